"""Every profile by its code. A new one is a file in this folder and a line below, or is registered from outside."""

import re

from cadgen.car.optimize.profiles.actual import ACTUAL
from cadgen.car.optimize.profiles.compensated import COMPENSATED
from cadgen.car.optimize.profiles.optimized import OPTIMIZED
from cadgen.car.optimize.profiles.profile import Profile
from cadgen.car.optimize.profiles.published import PUBLISHED
from cadgen.car.optimize.profiles.smoothed import SMOOTHED
from cadgen.car.optimize.profiles.smoothed_compensated import SMOOTHED_COMPENSATED
from cadgen.car.optimize.profiles.theoretical import THEORETICAL
from cadgen.errors import DesignError

_CODE = re.compile(r"[a-z0-9]+([+_-][a-z0-9]+)*")  # it stands in the names of files
_PROFILES: dict[str, Profile] = {}


def register(profile: Profile) -> None:
    """Add a profile to the table, under its code.

    Raises:
        DesignError: the code is taken, or cannot stand in the name of a file.
    """
    if profile.code in _PROFILES:
        raise DesignError(f'there is a profile "{profile.code}" already: choose another code')
    if not _CODE.fullmatch(profile.code):
        raise DesignError(
            f'"{profile.code}" cannot be the code of a profile: take small letters, digits and single +, - or _ between'
        )
    _PROFILES[profile.code] = profile


for _profile in (
    ACTUAL,
    OPTIMIZED,
    COMPENSATED,
    SMOOTHED,
    SMOOTHED_COMPENSATED,
    THEORETICAL,
    PUBLISHED,
):
    register(_profile)


def codes(*, for_play: bool = False) -> tuple[str, ...]:
    """Codes of all profiles, or only of those that act against play."""
    return tuple(profile.code for profile in _PROFILES.values() if profile.for_play or not for_play)


def compared() -> tuple[Profile, ...]:
    """Profiles that the best is chosen of: the actual profile, then all that are cut for play."""
    return (ACTUAL, *(profile for profile in _PROFILES.values() if profile.for_play and not profile.best_of))


def profile_of(code: str) -> Profile:
    """The profile with a code.

    Raises:
        DesignError: no profile has the code.
    """
    if not isinstance(code, str) or code not in _PROFILES:
        raise DesignError(f'there is no profile "{code}": choose one of {", ".join(_PROFILES)}')
    return _PROFILES[code]


def meanings() -> str:
    """Every profile and its meaning, in one line."""
    return "; ".join(f"{profile.code}: {profile.meaning}" for profile in _PROFILES.values())
