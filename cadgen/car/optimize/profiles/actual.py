"""The actual profile: the exact envelope of the rod."""

from cadgen.car.optimize.profiles.profile import Profile

ACTUAL = Profile(code="actual", meaning="the exact envelope of the rod")
