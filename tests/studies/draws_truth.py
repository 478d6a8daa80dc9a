"""A car with other settings, by code of its own: the rod on points of the disc, the run by Runge and Kutta, the sweep.

Shares nothing with the program: the rod's ellipse is solved for its lean by Newton's method, the run has four stages on
the heading, and distances are those of points and sides by hand.
"""

import numpy as np

STEPS = 1800  # of a turn
_WINDOW = 0.9  # of the rod's radius, within which it touches


def steering(points, a, r, planes, turns):
    """tan(beta) of a rod of radius r on a disc's points (n, 2), at cam angles (m,), for a base radius and two planes.

    In the plane w the rod is an ellipse about a + w T with the half axes r sqrt(1 + T^2) along the ray and r across it.
    It rests on the point that asks for the greatest T.
    """
    polar = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    if polar[-1] < polar[0]:
        points, polar = points[::-1], polar[::-1]
    radius = np.hypot(*points.T)
    reach = np.arcsin(min(1.0, _WINDOW * r / radius.min()))
    turn = 2 * np.pi
    whole = np.concatenate([polar - turn, polar, polar + turn])
    size = np.tile(radius, 3)
    step = turn / len(points)
    half = int(np.ceil(reach / step * 1.3)) + 2
    at = np.searchsorted(whole, polar[0] + (turns - polar[0]) % turn)
    number = at[:, None] + np.arange(-half, half + 1)
    off = whole[number] - (polar[0] + (turns - polar[0]) % turn)[:, None]
    x, y = size[number] * np.cos(off), size[number] * np.sin(off)
    best = np.full(len(turns), -np.inf)
    for w in planes:
        h = np.sqrt(np.maximum(r**2 - y**2, 0.0))
        T = (x - a + h) / w
        for _ in range(6):
            root = np.sqrt(1 + T**2)
            T -= (a + w * T - h * root - x) / (w - h * T / root)
        T = np.where(np.abs(y) < _WINDOW * r, T, -np.inf)
        k = np.clip(T.argmax(axis=1), 1, T.shape[1] - 2)
        rows = np.arange(len(turns))
        before, here, after = T[rows, k - 1], T[rows, k], T[rows, k + 1]
        bend = before - 2 * here + after
        best = np.maximum(
            best, np.where(bend < 0, here - (after - before) ** 2 / (8 * np.minimum(bend, -1e-300)), here)
        )
    return best


def run(tangent, step, travel, start, car):
    """Drive wheel x + iy and heading at every other cam angle, by Runge and Kutta of the fourth order.

    Args:
        tangent: tan(beta) at cam angles `step` apart, an odd number of them.
        step: rad.
        travel: mm in a turn.
        start: drive wheel x + iy, heading.
        car: wheelbase and A1.
    """
    L, a1 = car
    rate = -tangent / (L + a1 * tangent) * travel / (2 * np.pi)
    h, ends, middles = 2 * step, rate[::2], rate[1::2]
    turned = np.concatenate([[0.0], np.cumsum(h / 6 * (ends[:-1] + 4 * middles + ends[1:]))])
    heading = start[1] + turned
    # The heading in the middle of a step, from the cubic through the rates at its ends and its middle.
    inner = heading[:-1] + h / 24 * (5 * ends[:-1] + 8 * middles - ends[1:])
    ahead = np.exp(1j * heading)
    going = travel / (2 * np.pi) * h / 6 * (ahead[:-1] + 4 * np.exp(1j * inner) + ahead[1:])
    return start[0] + np.concatenate([[0.0], np.cumsum(going)]), heading


def passed(track, ends):
    """Distance of a track's best crossing of a segment from the nearer of its ends; minus infinity if it has none."""
    a, b = ends
    seen = (track - a) / (b - a)
    cross = np.flatnonzero((seen.imag[:-1] <= 0) != (seen.imag[1:] <= 0))
    share = seen.imag[cross] / (seen.imag[cross] - seen.imag[cross + 1])
    along = seen.real[cross] + share * (seen.real[cross + 1] - seen.real[cross])
    return float(np.max(np.minimum(along, 1 - along) * abs(b - a), initial=-np.inf))


def gaps(wheel, heading, car, outline, posts, field):
    """Least distance of each post's middle, and of the field's edge, from a rectangle that is driven.

    Args:
        wheel: drive wheel x + iy.
        heading: rad.
        car: wheelbase and A1.
        outline: front, rear, left and right of the fork axis, mm.
        posts: middles x + iy.
        field: low and high corner, x + iy.
    """
    front, rear, left, right = outline
    fork = wheel + (car[0] - 1j * car[1]) * np.exp(1j * heading)
    least = []
    for post in posts:
        seen = (post - fork) * np.exp(-1j * heading)
        x = np.maximum(np.maximum(seen.real - front, rear - seen.real), 0)
        y = np.maximum(np.maximum(seen.imag - left, right - seen.imag), 0)
        least.append(np.hypot(x, y).min())
    corners = np.array([front + 1j * left, front + 1j * right, rear + 1j * right, rear + 1j * left])
    placed = fork[:, None] + corners * np.exp(1j * heading)[:, None]
    low, high = field
    edge = min(
        (placed.real - low.real).min(),
        (high.real - placed.real).min(),
        (placed.imag - low.imag).min(),
        (high.imag - placed.imag).min(),
    )
    return np.array(least), edge
