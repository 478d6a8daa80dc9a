"""Formulas of a follower that is wrong in one member: named by a check, or refused; and no alarm where all are right.

The follower is a roller whose slide leans from the ray by 20 degrees, so what a slide on the ray inherits is wrong.
That the package's kinds raise no alarm, every test that finds a cam ready shows, too.
"""

import re
from dataclasses import dataclass, replace
from math import radians
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.cam.checks import check_cam
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.groove import pressed_outwards
from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.formulas import FORMULAS
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits
from cadgen.cam.round_follower import RoundFollower
from cadgen.errors import DesignError
from cadgen.laws.segments import MotionSpan, SegmentMotion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM, RAD, TAN
from cadgen.messages import CHINESE, translate
from cadgen.parts.blank import Blank
from tests.cam.test_kinds import FOLLOWERS

LEAN = np.exp(1j * radians(20))
LIMITS = CheckLimits(
    pressure_angle=PRESSURE_ANGLE_LIMITS["norton_oscillating"],
    lost_lift=1e-3,
    min_convex_radius=0.5,
    cutter_radius=2.0,
    wall=2.0,
)


@dataclass(frozen=True, kw_only=True)
class Leaning(RoundFollower):
    base: float = 42.0
    radius: float = 8.0

    @property
    def base_radius(self):
        return self.base + self.radius

    @property
    def reach(self):
        return self.radius + 20.0

    def centre(self, q, q1, q2):
        return self.base_radius + q * LEAN, q1 * LEAN, q2 * LEAN

    def least(self, x, y):
        p = (x + 1j * y - self.base_radius) * LEAN.conjugate()
        half = np.sqrt(np.maximum(self.radius**2 - p.imag**2, 0.0))
        return (np.where(abs(p.imag) < self.radius, p.real + half, -np.inf),)

    def most(self, x, y, off):
        p = (x + 1j * y - self.base_radius) * LEAN.conjugate()
        aside = np.maximum(abs(p.imag) - off, 0.0)
        half = np.sqrt(np.maximum(self.radius**2 - aside**2, 0.0))
        return (np.where(aside < self.radius, p.real + off + half, -np.inf),)

    def pressed(self, q, normal):
        return np.angle(LEAN) - normal

    def standing(self, distance):
        s = np.sqrt(distance**2 - (self.base_radius * LEAN.imag) ** 2) - self.base_radius * LEAN.real
        return s, np.angle(self.base_radius + s * LEAN)

    def point(self):
        return replace(self, base=self.base_radius, radius=0.0)


def motion(unit=MM, high=12.0):
    """Rise, dwell, return and dwell, of laws without a jump of the acceleration."""
    at = radians(1) if unit == RAD else 1.0
    rows = ((100, high, "cycloidal"), (40, high, None), (130, 0.0, "polynomial_3_4_5"), (90, 0.0, None))
    spans, begin, before = [], 0.0, 0.0
    for width, end, law in rows:
        span = (radians(begin), radians(begin + width), before * at, end * at, law and law_of(law))
        spans.append(MotionSpan(*span))
        begin, before = begin + width, end
    return SegmentMotion.of(spans, unit)


def failing(follower, moved=None):
    """Checks of formulas on the follower's own cam."""
    moved = motion(follower.unit) if moved is None else moved
    profile = actual_profile(moved, follower)
    made = check_cam(moved, follower, profile.curve, profile.trims, Blank(bore_diameter=8.0), LIMITS)
    return [check for check in made if check.code in FORMULAS]


def broken(**members):
    return dataclass(frozen=True, kw_only=True)(type("Broken", (Leaning,), members))()


@pytest.mark.parametrize("name", ["knife ahead", "flat tilted back", "swinging flat with", "leaning"])
def test_no_alarm_where_all_are_right(name):
    follower = FOLLOWERS.get(name, Leaning())
    assert failing(follower) == []


@pytest.mark.parametrize("name", ["roller behind", "swinging roller with"])
def test_no_alarm_on_an_outer_flank(name):
    moved = motion(FOLLOWERS[name].unit)
    opposite = replace(moved, q=type(moved.q)(-moved.q.c, moved.q.x, extrapolate="periodic"))
    assert failing(pressed_outwards(FOLLOWERS[name]), opposite) == []


def test_no_alarm_where_the_roller_is_undercut():
    assert failing(replace(FOLLOWERS["roller in line"], base=14.0, radius=12.0)) == []


def test_the_angle_of_a_line_that_leans_is_not_that_of_the_ray():
    (check,) = failing(broken(pressed=RoundFollower.pressed))
    assert check.code == "pressure-angle-formula"
    assert not check.passed
    one, other = map(float, re.search(r"([-.\d]+)° by the formula, ([-.\d]+)° by outline", check.place).groups())
    assert abs(one - other) == pytest.approx(20.0, abs=1e-3)
    # By the textbook: the centre's path against the line of the slide.
    theta = radians(float(re.search(r"cam angle ([.\d]+)", check.place)[1]))
    q, slope = motion().q(theta), motion().q(theta, nu=1)
    path = slope * LEAN + 1j * (Leaning().base_radius + q * LEAN)
    assert abs(other) == pytest.approx(abs(np.degrees(np.angle(LEAN * 1j / path))), abs=0.02)
    assert "correct pressed or pressure_angle of the follower (Broken)" in check.advice
    assert all(re.search("[一-鿿]", translate(text, CHINESE)) for text in (check.name, check.place, check.advice))


WRONG = {
    "pressed changes its sign": (
        "pressure-angle-formula",
        {"pressed": lambda self, q, normal: abs(normal) - np.angle(LEAN)},
    ),
    "ahead": ("contact-formula", {"ahead": lambda self, *of: Leaning.ahead(self, *of) + 0.1}),
    "most": ("bound-formula", {"most": lambda self, x, y, off: self.least(x, y)}),
    "standing left out": ("standing-formula", {"standing": RoundFollower.standing}),
    "distance": ("standing-formula", {"distance": lambda self, q, face: self.base_radius + q}),
    "push": ("push-formula", {"push": lambda self, *of: 1.01 * Leaning.push(self, *of)}),
    "profile_radius": ("radius-formula", {"profile_radius": lambda self, *of: Leaning.profile_radius(self, *of) + 2.0}),
    "normal": ("normal-formula", {"normal": lambda self, *of: Leaning.normal(self, *of).conj()}),
    "second derivative of centre": (
        "curvature-formula",
        {"centre": lambda self, q, q1, q2: Leaning.centre(self, q, q1, 1.2 * q2)},
    ),
    "lift": ("lift-formula", {"lift": lambda self, q: 0.1 * q, "of_lift": lambda self, s: (10 * s, 0 * s, s + np.inf)}),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_member_that_is_wrong_is_named(name):
    code, members = WRONG[name]
    found = failing(broken(**members))
    assert code in [check.code for check in found]
    assert not any(check.passed for check in found)


@pytest.mark.parametrize("member", ["checks", "pitch_curve"])
def test_a_member_that_returns_nothing_is_named(member):
    follower = broken(**{member: lambda self, of: None})
    with pytest.raises(DesignError, match=rf"{member} of the \w+ \(Broken\) returns None"):
        follower.refuse(motion()) if member == "pitch_curve" else failing(follower)


LACKING = {
    "its follower lacks least": (type("Lacking", (Leaning,), {"least": None}), {}),
    "the motion of its follower is in mm, and that of the kind in tan": (Leaning, {"unit": TAN}),
    "lift with of_lift gives something else": (type("Other", (Leaning,), {"lift": lambda self, q: 2 * q}), {}),
    "least fails (ZeroDivisionError": (type("Failing", (Leaning,), {"least": lambda self, x, y: 1 / 0}), {}),
    "most gives something else": (type("One", (Leaning,), {"most": lambda self, x, y, off: x}), {}),
    "its build gives object": (object, {}),
    "its build fails": (lambda: Leaning(arm=3), {}),
}


def without(member):
    """The class as it is abstract still, for one member is not there."""
    given = {name: each for name, each in vars(Leaning).items() if name not in (member, "__dict__", "__weakref__")}
    return type("Lacking", (RoundFollower,), given)


@pytest.mark.parametrize("words", LACKING)
def test_what_lacks_a_member_is_refused_with_its_name(words):
    build, of_kind = LACKING[words]
    build = without("least") if "lacks" in words else build
    kind = FollowerKind(code="own", meaning="", keys=object, build=lambda keys, seat: build(), **of_kind)
    with pytest.raises(DesignError, match=re.escape(words)) as refused:
        kind.follower(None, SimpleNamespace())
    assert '"own"' in str(refused.value)
    assert str(refused.value).count(": ") < 4
