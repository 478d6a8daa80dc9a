"""Spur gears of the studies' own: tolerances, plays, teeth in mesh, and every train within limits.

Nothing of cadgen is used: tolerances come from the printed tables of ISO 286 and the formulas of ISO 1328, plays and
return errors from eq. 1-13 and 25 as the paper has them, roots from rolling a rack's rounded corner, contact ratios
from these. Lengths in mm, plays and thicknesses in µm.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from itertools import pairwise, product
from math import acos, atan, atan2, ceil, cos, degrees, floor, hypot, pi, prod, radians, sin, sqrt, tan

from scipy.optimize import brentq

# ---------------------------------------------------------------- tolerances, µm

SIZES = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250)
IT = {  # printed, ISO 286-1
    7: (10, 12, 15, 18, 21, 25, 30, 35, 40, 46),
    8: (14, 18, 22, 27, 33, 39, 46, 54, 63, 72),
    9: (25, 30, 36, 43, 52, 62, 74, 87, 100, 115),
    10: (40, 48, 58, 70, 84, 100, 120, 140, 160, 185),
}
F_A_GRADE = {5: 7, 6: 7, 7: 8, 8: 8, 9: 9}
B_R = {5: (8, 1.0), 6: (8, 1.26), 7: (9, 1.0), 8: (9, 1.26), 9: (10, 1.0)}


def it(size: float, grade: int) -> float:
    return IT[grade][next(k for k, upper in enumerate(SIZES) if size <= upper * (1 + 1e-12))]


def step(value: float, *limits: float) -> float:
    """Geometric mean of the step (lower, upper] that holds the value."""
    upper = next(k for k, limit in enumerate(limits) if value <= limit * (1 + 1e-12))
    upper = max(upper, 1)
    return sqrt(limits[upper - 1] * limits[upper])


def graded(value: float, grade: int, finest: float) -> float:
    value *= sqrt(2) ** (grade - 5)
    unit = 1.0 if value > 10 else 0.5 if value >= 5 else finest
    return unit * floor(value / unit + 0.5)


@dataclass(frozen=True)
class Wheel:
    """One gear as it is specified; `aim` is what it is cut to, µm or a place in the zone."""

    z: int
    m: float
    b: float
    grade: int
    aim: str | float

    def tolerances(self) -> tuple[float, float, float, float, float]:
        d1 = step(self.z * self.m, 5, 20, 50, 125, 280, 560)
        m1, m2 = step(self.m, 0.5, 2, 3.5, 6), step(self.m, 0.2, 0.5, 0.8, 1, 1.5, 2.5, 4)
        width, q = step(self.b, 4, 10, 20, 40, 80), self.grade
        f_pt = graded(0.3 * (m1 + 0.4 * sqrt(d1)) + 4, q, 0.1)
        f_beta = graded(0.1 * sqrt(d1) + 0.63 * sqrt(width) + 4.2, q, 0.1)
        f_r = graded(0.24 * m1 + sqrt(d1) + 5.6, q, 0.5)
        composite = graded(3.2 * m2 + 1.01 * sqrt(d1) + 6.4, q, 0.5)
        it_grade, factor = B_R[q]
        return f_pt, f_beta, f_r, it(self.z * self.m, it_grade) * factor, composite


ALPHA = radians(20)
INV = tan(ALPHA) - ALPHA


@dataclass(frozen=True)
class Pair:
    """One unshifted stage with all that the equations say of it; µm but for sizes in mm."""

    driver: Wheel
    driven: Wheel
    span: float
    a: float = field(init=False)
    zones: tuple[tuple[float, float], ...] = field(init=False)
    least: float = field(init=False)
    greatest: float = field(init=False)
    closest: float = field(init=False)

    def __post_init__(self) -> None:
        one, two = self.driver, self.driven
        a = one.m * (one.z + two.z) / 2
        f_a = it(a, F_A_GRADE[one.grade]) / 2
        t1, t2 = one.tolerances(), two.tolerances()
        f_sb = min(0.5 * self.span / one.b * t1[1], 0.5 * self.span / two.b * t2[1])
        squares = (2 * f_sb * sin(ALPHA)) ** 2 + (f_sb * cos(ALPHA)) ** 2
        squares += t1[0] ** 2 + t2[0] ** 2 + (t1[1] ** 2 + t2[1] ** 2) * cos(ALPHA) ** 2
        required = 2 / 3 * (60 + 0.5 * a + 30 * one.m)
        upper = -(f_a * tan(ALPHA) + (required + sqrt(squares)) / (2 * cos(ALPHA)))
        zones = []
        for wheel, t in ((one, t1), (two, t2)):
            width = 2 * tan(ALPHA) * hypot(t[2], t[3])
            middle = {"least": upper, "middle": upper - width / 2, "greatest": upper - width}.get(wheel.aim, wheel.aim)
            zones.append((middle + width / 2, middle - width / 2))
        axes, composite = 2 * f_a * tan(ALPHA), 2 * (t1[4] + t2[4]) * tan(ALPHA)
        put = object.__setattr__
        put(self, "a", a)
        put(self, "zones", tuple(zones))
        put(self, "least", -zones[0][0] - zones[1][0] - axes)
        put(self, "greatest", -zones[0][1] - zones[1][1] + axes + composite)
        # At the closest axes and the thickest teeth, by the exact involutes.
        near = acos(cos(ALPHA) * a / (a - f_a * 1e-3))
        opened = one.m * (one.z + two.z) * (tan(near) - near - INV)
        put(self, "closest", opened * 1e3 - zones[0][0] - zones[1][0])

    @property
    def ratio(self) -> Fraction:
        return Fraction(self.driven.z, self.driver.z)

    @property
    def shifts(self) -> tuple[float, float]:
        return tuple((high + low) / 2e3 / (2 * self.driver.m * tan(ALPHA)) for high, low in self.zones)

    @property
    def forms(self) -> list[tuple[int, float]]:
        return list(zip((self.driver.z, self.driven.z), self.shifts, strict=True))

    @property
    def contact(self) -> float:
        return contact(*self.forms)

    @property
    def undercut(self) -> float:
        return max(missing(*form) for form in self.forms)

    @property
    def root_gap(self) -> float:
        return 0.25 - max(self.shifts)

    def root(self, which: int) -> float:
        z, shift = self.forms[which]
        return self.driver.m * (z - 2 * (1.25 - shift))


def errors(pairs: tuple[Pair, ...]) -> tuple[float, float]:
    """Least and greatest return error at the output in degrees, eq. 13 and 25."""
    least = greatest = 0.0
    for pair in pairs:
        radius = pair.driven.m * pair.driven.z / 2 * 1e3
        least = least / float(pair.ratio) + pair.least / radius
        greatest = greatest / float(pair.ratio) + pair.greatest / radius
    return degrees(least), degrees(greatest)


# ---------------------------------------------------------------- teeth, in modules: rack with h_f 1.25, rho 0.38

RHO = 0.38
CENTRE_DEPTH = 1.25 - RHO  # of the corner's centre under the rack's reference line
CENTRE_SIDE = pi / 4 - CENTRE_DEPTH * tan(ALPHA) - RHO / cos(ALPHA)  # from the middle of the rack's tooth


def missing(z: int, shift: float) -> float:
    """Profile shift that is missing to be free of undercut: the corner's straight end lies under the line of action."""
    depth = CENTRE_DEPTH + RHO * sin(ALPHA) - shift
    return max(depth - z / 2 * sin(ALPHA) ** 2, 0.0)


def corner(z: int, shift: float, turned: float) -> tuple[float, float]:
    """Radius and angle, from the middle of the space, of the root point made when the gear has `turned` (rad)."""
    radius = z / 2
    # The rack's corner centre, seen from the pitch point as the gear has turned and the rack moved by r · turned.
    x, y = CENTRE_SIDE + radius * turned, -(CENTRE_DEPTH - shift)
    reach = hypot(x, y)
    x, y = x + RHO * x / reach, y + RHO * y / reach  # the contact lies on the normal through the pitch point
    return hypot(x, radius + y), atan2(x, radius + y) - turned


@cache
def start_of_involute(z: int, shift: float) -> float:
    """Length along the line of action, from its touching the base circle, at which the flank begins."""
    tangent = z / 2 * sin(ALPHA) - (CENTRE_DEPTH + RHO * sin(ALPHA) - shift) / sin(ALPHA)
    if missing(z, shift) == 0:
        return tangent
    base = z / 2 * cos(ALPHA)
    # Half the space at the base circle; out from there it widens by the involute.
    space = (pi / 2 - 2 * shift * tan(ALPHA)) / z - INV

    def beyond(turned: float) -> float:
        radius, angle = corner(z, shift, turned)
        roll = sqrt(max((radius / base) ** 2 - 1, 0.0))
        return angle - (space + roll - atan(roll))

    def above(turned: float) -> float:
        return corner(z, shift, turned)[0] - base

    # The corner runs from the space's bottom to its own tangent end, where the line of action meets its centre.
    depth = CENTRE_DEPTH - shift
    last = (depth / tan(ALPHA) - CENTRE_SIDE) / (z / 2)
    first = -CENTRE_SIDE / (z / 2)
    out = brentq(above, first, last, xtol=1e-15)
    meet = brentq(beyond, out, last, xtol=1e-15)
    return sqrt(corner(z, shift, meet)[0] ** 2 - base**2)


@cache
def contact(one: tuple[int, float], two: tuple[int, float]) -> float:
    line = (one[0] + two[0]) / 2 * sin(ALPHA)
    tips = [sqrt((z / 2 + 1) ** 2 - (z / 2 * cos(ALPHA)) ** 2) for z, _ in (one, two)]
    begin = max(line - tips[1], start_of_involute(*one))
    end = min(tips[0], line - start_of_involute(*two))
    return max(end - begin, 0.0) / (pi * cos(ALPHA))


# ---------------------------------------------------------------- trains


def given_pairs(keys: dict) -> tuple[Pair, ...]:
    aim = keys.get("E_sn_um", keys.get("thinning", "middle"))
    return tuple(
        Pair(
            *(
                Wheel(stage[role]["teeth"], stage[role]["module_mm"], stage[role]["width_mm"], keys["grade"], aim)
                for role in ("driver", "driven")
            ),
            keys["bearing_span_mm"],
        )
        for stage in keys["stages"]
    )


CLEARANCE = 0.3
COLLAR = 1.0


def in_mesh(pair: Pair) -> list[str]:
    """The checks of a stage that it must fail, by name."""
    wrong = []
    if pair.closest <= 0:
        wrong.append("teeth jam")
    if pair.contact < 1.1:
        wrong.append("contact ratio")
    if pair.root_gap < 0.12:
        wrong.append("root clearance")
    return wrong


def fits(pairs: tuple[Pair, ...], keys: dict) -> bool:
    """Whether bores, collars, shafts and bearings have room; nothing turns in a search but its neighbours' bodies."""
    bore = keys.get("drive", {}).get("bore_diameter_mm", 0.0)
    for place, pair in enumerate(pairs):
        for which, wheel in enumerate((pair.driver, pair.driven)):
            root, tip = pair.root(which), wheel.m * (wheel.z + 2)
            alone = (place == 0 and which == 0) or (place == len(pairs) - 1 and which == 1)
            if bore > root - (tip - root) / 2 or (not alone and bore + 1.6 > root):
                return False
        if bore and bore + CLEARANCE > pair.a:
            return False
    for one, two in pairwise(pairs):
        if bore and one.driven.m * (one.driven.z + 2) / 2 + bore / 2 + CLEARANCE > two.a + 1e-9:
            return False
        if bore and two.driver.m * (two.driver.z + 2) / 2 + bore / 2 + CLEARANCE > one.a + 1e-9:
            return False
    return sum(pair.driver.b for pair in pairs) + COLLAR * (len(pairs) - 1) <= keys["bearing_span_mm"] + 1e-9


def candidates(keys: dict) -> tuple[list[Pair], Fraction]:
    """Every pair within the limits but those of the teeth in mesh, and the ratio that is wanted."""
    given, limits = given_pairs(keys), keys["search"]
    ratios = [float(pair.ratio) for pair in given]
    low = limits.get("stage_ratio_min", min(1.0, *ratios))
    high = limits.get("stage_ratio_max", max(10.0, *ratios))
    aim = keys.get("E_sn_um", keys.get("thinning", "middle"))
    found = []
    for m, b in product(limits["modules_mm"], limits["widths_mm"]):
        for z1, z2 in product(range(limits["teeth_min"], limits["teeth_max"] + 1), repeat=2):
            a = m * (z1 + z2) / 2
            if (
                low * z1 * (1 - 1e-12) <= z2 <= high * z1 * (1 + 1e-12)
                and a <= limits["centre_distance_max_mm"] + 1e-9
                and m * min(z1, z2) >= 5 * (1 - 1e-12)
            ):
                found.append(Pair(*(Wheel(z, m, b, keys["grade"], aim) for z in (z1, z2)), keys["bearing_span_mm"]))
    return found, prod((pair.ratio for pair in given), start=Fraction(1))


def best_train(keys: dict) -> tuple[float, float] | None:
    """Greatest return errors of the best train within the limits of the search, and of the best that can be made."""
    given, limits = given_pairs(keys), keys["search"]
    contact_min = limits.get("contact_ratio_min", max(1.1, min(1.2, floor(min(p.contact for p in given) * 100) / 100)))
    undercut_max = limits.get("undercut_max", max(0.5, ceil(max(p.undercut for p in given) * 100) / 100))

    @cache
    def allowed(pair: Pair) -> bool:
        return (
            pair.closest > 0 and pair.root_gap >= 0.12 and pair.undercut <= undercut_max and pair.contact >= contact_min
        )

    pairs, ratio = candidates(keys)
    by_ratio: dict[Fraction, list[Pair]] = {}
    for pair in pairs:
        by_ratio.setdefault(pair.ratio, []).append(pair)
    chains = []

    def extend(chain: tuple[Pair, ...], left: Fraction, missing_stages: int) -> None:
        if missing_stages == 1:
            chains.extend((errors((*chain, pair))[1], (*chain, pair)) for pair in by_ratio.get(left, ()))
            return
        for pair in pairs:
            extend((*chain, pair), left / pair.ratio, missing_stages - 1)

    extend((), ratio, len(given))
    chains.sort(key=lambda entry: entry[0])
    within = (entry for entry in chains if all(map(allowed, entry[1])))
    first = next(within, None)
    if first is None:
        return None
    made = first if fits(first[1], keys) else next((entry for entry in within if fits(entry[1], keys)), None)
    return first[0], made[0] if made else -1.0


def height_of(pairs: tuple[Pair, ...]) -> float:
    """Height of the stack of a train as given, whose gears need not be as wide as those in mesh with them."""
    low, high, plane = 0.0, 0.0, pairs[0].driven.b / 2
    for place, pair in enumerate(pairs):
        for wheel in (pair.driver, pair.driven):
            low, high = min(low, plane - wheel.b / 2), max(high, plane + wheel.b / 2)
        if place + 1 < len(pairs):
            after = pairs[place + 1]
            out = max((pair.driver.b - pair.driven.b) / 2, 0) + max((after.driven.b - after.driver.b) / 2, 0)
            plane += pair.driven.b / 2 + COLLAR + out + after.driver.b / 2
    return high - low


def fits_as_given(pairs: tuple[Pair, ...], keys: dict) -> bool:
    return height_of(pairs) <= keys["bearing_span_mm"] + 1e-9 and fits(pairs, {**keys, "bearing_span_mm": 1e9})
