"""The optimized profile: the best against play of all that are compared."""

from cadgen.car.optimize.profiles.profile import Profile

OPTIMIZED = Profile(
    code="optimized",
    meaning="the best against the gears' play, of actual and all that are cut for it",
    for_play=True,
    best_of=True,
)
