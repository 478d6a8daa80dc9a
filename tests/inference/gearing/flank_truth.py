"""Flanks of a made gear, point by point in the plane, without the package.

Each flank is an involute of its own base circle about its own centre. Where a line of action meets it is found on the
curve itself, from the axis about which the gear is measured. Seen on the measured face teeth are counted clockwise,
which is mirrored here, so that the count goes counter-clockwise and right flanks look along it.
"""

import numpy as np
from scipy.optimize import brentq


def involute_point(base, start, roll, side):
    """Point of an involute that begins at the angle `start` on its base circle and leans back from `side`."""
    at = start - side * roll
    return base * np.exp(1j * at) * (1 + side * 1j * roll)


def flank_start(teeth, module, pressure, tooth, side, extra=0.0):
    """Angle at which the flank of a tooth leaves the base circle, for teeth of nominal thickness plus an angle."""
    half = np.pi / (2 * teeth) + np.tan(pressure) - pressure
    return 2 * np.pi * tooth / teeth + side * half + extra


def at_reference(teeth, module, pressure, tooth, side, centre=0j, extra=0.0, base=None):
    """Angle from the axis at which a flank crosses the reference circle."""
    radius = teeth * module / 2
    own = base or radius * np.cos(pressure)
    start = flank_start(teeth, module, pressure, tooth, side, extra)

    def off(roll):
        return abs(centre + involute_point(own, start, roll, side)) - radius

    roll = brentq(off, 0.05, 1.2)
    return np.angle(centre + involute_point(own, start, roll, side))


def index_um(teeth, module, pressure, centre, table):
    """Index deviation of right and left flanks along the count, um."""
    found = {}
    for side in (1, -1):
        arcs = []
        for tooth in range(teeth):
            extra = table * np.sin(2 * np.pi * tooth / teeth + 0.7)
            angle = at_reference(teeth, module, pressure, tooth, side, centre, extra)
            nominal = at_reference(teeth, module, pressure, tooth, side)
            arcs.append(1e3 * teeth * module / 2 * np.angle(np.exp(1j * (angle - nominal))))
        found[side] = np.array(arcs) - np.mean(arcs)
    return found


def run_out_um(teeth, module, pressure, centre, table):
    """Greatest less least distance from the axis to a ball that lies in each space in turn, um."""
    base = teeth * module / 2 * np.cos(pressure)
    # In a space as wide as the teeth are thick, a ball of this size touches at the reference circle.
    ball = brentq(
        lambda size: (
            np.sqrt(base**2 + (base * np.tan(pressure) + size) ** 2)
            - base / np.cos(_unrolled(ball_involute(teeth, pressure, size / base)))
        ),
        base * (np.pi / (2 * teeth) - np.tan(pressure) + pressure) + 1e-3 * module,
        2 * module,
    )
    away = []
    for tooth in range(teeth):
        extras = [table * np.sin(2 * np.pi * k / teeth + 0.7) for k in (tooth, tooth + 1)]
        right = flank_start(teeth, module, pressure, tooth, 1, extras[0]) + ball / base
        left = flank_start(teeth, module, pressure, tooth + 1, -1, extras[1]) - ball / base
        at = base / np.cos(_unrolled((right - left) / 2))
        away.append(abs(centre + at * np.exp(1j * (right + left) / 2)))
    return 1e3 * np.ptp(away)


def ball_involute(teeth, pressure, share):
    """Involute function at the middle of a ball that lies in a space; share is its radius in base radii."""
    return np.tan(pressure) - pressure - np.pi / (2 * teeth) + share


def _unrolled(involute):
    return brentq(lambda angle: np.tan(angle) - angle - involute, 1e-4, 1.4)


def profile_um(teeth, module, pressure, cut_at, hob=0.0, phase=0.5):
    """Rolls in mm, and deviation along the base tangent of a flank that a tool has cut, um.

    The tool has another pressure angle and is off its own axis by `hob`, in mm, as a hob of one start that turns once
    while the gear turns by a tooth. The flank is the envelope of the tool's straight edges, by its support function.
    """
    base = teeth * module / 2 * np.cos(pressure)
    other = teeth * module / 2 * np.cos(cut_at)
    rolls = np.linspace(0.3, 0.75, 121) * base * np.tan(pressure) * 2
    start = flank_start(teeth, module, pressure, 0, 1)
    cut = flank_start(teeth, module, cut_at, 0, 1)

    # A straight edge leaves what none of its places cuts: on each base tangent, the least of where they cross it.
    places = np.linspace(rolls[0] / base - 0.06, rolls[-1] / base + 0.06, 20_001)
    normal = 1j * np.exp(1j * (cut - places))
    support = other * places + hob * np.sin(cut_at) * np.sin(teeth * places + phase)
    deviations = []
    for roll in rolls / base:
        foot, along = base * np.exp(1j * (start - roll)), 1j * np.exp(1j * (start - roll))
        crossed = (support - (foot * normal.conj()).real) / (along * normal.conj()).real
        deviations.append(1e3 * (crossed.min() - roll * base))
    return rolls, np.array(deviations)
