"""The actual profile: the exact envelope of a follower over all planes that carry it.

A follower gives its envelope between the kinks of the lift in closed form (`Follower.piece`). At a kink of the lift
that is hollow, its own section joins two of these pieces; at one that is convex the two cross and the part beyond the
crossing is lost. The disc that the follower nowhere cuts is the smallest of all branches at each polar angle
(`cadgen.cam.lower_hull`). Where the envelopes of two planes coincide, as those of the leaning rod do where beta is zero
over a stretch, neither is left for the other by rounding alone.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Branch, Follower, Swept, Trim, TrimKind
from cadgen.cam.lower_hull import SAME, LowestRun, Radii, Reach, lowest_branches
from cadgen.curves.closed import ByAngle, ClosedCurve, polar_angle
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion

_SAMPLES = 3600  # of a turn: folds and crossings closer together than 0.1 degree count as one
# A cusp between two samples is narrowed down to rounding: 16^13 steps of a sample.
_CUSP_ZOOM = 16
_CUSP_ZOOMS = 13
_NEWTON_STEPS = 20
_ZOOM, _ZOOMS = 33, 4  # polar angles at a time, and rounds: from 0.1 degree to 2e-9 rad
_CONVERGED = 1e-13  # rad; Newton's method has doubled its digits past rounding
_JOINT = 1e-9  # rad; two branches that end and begin within this meet, they do not cross
# Folds of all envelopes; their parts are joined in some 6 s of processor time for each profile that is made.
_MOST_FOLDS = 1000
_NO_TRIM = 1e-6  # rad; its square times the lift's curvature is 1e-10 mm: no lift that is lost within it would show


@dataclass(frozen=True)
class ActualProfile:
    """The trimmed envelope and the places where it was trimmed."""

    curve: ClosedCurve
    trims: tuple[Trim, ...]


def actual_profile(motion: Motion, follower: Follower) -> ActualProfile:
    """Return the largest disc that the follower nowhere cuts, in any plane that carries it.

    Args:
        motion: motion wanted.
        follower: follower of any kind.

    Raises:
        DesignError: the follower is too large for the cam's smallest radius, so that no disc remains, or a flank
            overhangs.
    """
    follower.refuse(motion)
    side = -1.0 if follower.encloses else 1.0  # of a disc outside of the follower the farthest branch is left
    branches = _branches(motion, follower)
    starts = np.array([_angle(b, b.start) for b in branches])
    # Polar angles that the branches run through, up to a whole turn, which an end less start would not show.
    angles = [np.unwrap(polar_angle(b.jet(np.linspace(b.start, b.stop, 65)).point)) for b in branches]
    spans = np.array([each[-1] - each[0] for each in angles])
    by_angle = [ByAngle(b) for b in branches]

    # Cells between all places where a branch begins or ends, and an even grid; each has one lowest branch.
    uniform = np.linspace(0.0, TURN, _SAMPLES, endpoint=False)
    edges = np.sort(np.concatenate([starts % TURN, (starts + spans) % TURN, uniform]))
    # Rounding may put one place at 0 and again just below a turn, so the last cell is measured round the end.
    edges = edges[np.diff(np.concatenate([edges, [edges[0] + TURN]])) > _JOINT]
    cells = edges + np.diff(np.concatenate([edges, [edges[0] + TURN]])) / 2
    reaches = []
    for number, branch in enumerate(branches):
        covered = np.flatnonzero((cells - starts[number]) % TURN <= spans[number])
        t = by_angle[number].parameters(cells[covered]) if covered.size else np.empty(0)
        radius = side * np.linalg.norm(branch.jet(t).point, axis=1) if covered.size else t
        reaches.append(Reach.of(covered, radius))
    radii = Radii(reaches, len(cells))
    runs = lowest_branches(radii, _continuations(branches, starts, spans))
    if len(runs) == 1:
        return ActualProfile(ClosedCurve(branches[runs[0].branch].smooth_parts()), ())
    begins: list[float] = []
    stops: list[float] = []
    trims = []
    while len(begins) < len(runs):
        left, run = runs[len(begins) - 1], runs[len(begins)]
        before, after, near = branches[left.branch], branches[run.branch], edges[run.cell]
        ends = np.array([_angle(before, before.stop), _angle(after, after.start)])
        gaps = (ends - near + np.pi) % TURN - np.pi
        if np.abs(gaps).max() < 2 * _JOINT:
            leave, enter = before.stop, after.start
        else:
            low = cells[run.cell - 1] if np.isfinite(radii.at(run.branch, run.cell - 1)) else near
            high = cells[run.cell] if np.isfinite(radii.at(left.branch, run.cell)) else near
            # The last cell comes before the first one.
            bracket = near - (near - low) % TURN, near + (high - near) % TURN
            both = by_angle[left.branch], by_angle[run.branch]
            leave, enter = _crossing(before, after, both, bracket, near, side)
            apart = [b.jet(np.array([t])).point[0] for b, t in ((before, leave), (after, enter))]
            if np.abs(apart[0] - apart[1]).max() >= 2 * SAME:
                # They do not meet: the next branch of the face before may be the lowest for less than a cell.
                face = [number for number, branch in enumerate(branches) if branch.face == before.face]
                between = face[(face.index(left.branch) + 1) % len(face)]
                if between == run.branch or len(runs) > len(branches):
                    raise _overhang(motion, follower, after, enter)
                runs.insert(len(begins), LowestRun(run.cell, between))
                continue
            if (trim := _trim(motion, before, after, leave, enter)) is not None:
                trims.append(trim)
        begins.append(enter)
        stops.append(leave)
    pieces = list[Branch]()
    for run, enter, stop in zip(runs, begins, stops[1:] + stops[:1], strict=True):
        branch = branches[run.branch]
        if stop <= enter and branch.stop - branch.start > TURN - _JOINT:
            stop += TURN  # without kinks one branch covers the whole turn, and a piece of it may run through its end
        if stop > enter:
            pieces += replace(branch, start=enter, stop=stop).smooth_parts()
    return ActualProfile(ClosedCurve(tuple(pieces)), tuple(trims))


def _continuations(branches: list[Branch], starts: Array, spans: Array) -> dict[int, int]:
    """For each branch the one of the same face that begins where it ends."""
    ends = (starts + spans) % TURN
    order = np.argsort(starts % TURN)
    # Turned on by whole turns, so that those about an end lie together on either side of the seam.
    places = ((starts % TURN)[order] + TURN * np.arange(-1, 2)[:, None]).ravel()
    numbers = np.tile(order, 3)
    following = {}
    first = np.searchsorted(places, ends - 2 * _JOINT, side="left").tolist()
    last = np.searchsorted(places, ends + 2 * _JOINT, side="right").tolist()
    for number, (a, b) in enumerate(zip(first, last, strict=True)):
        after = [int(index) for index in numbers[a:b] if branches[index].face == branches[number].face]
        if after:
            following[number] = max(after)
    return following


def _branches(motion: Motion, follower: Follower) -> list[Branch]:
    """Every part of all envelopes that runs forward, and the follower's section at every hollow kink."""
    joints = np.unique(np.concatenate([[0.0], motion.kinks, [TURN]]))
    branches, folds = list[Branch](), 0
    for face in follower.planes:
        spans = [follower.piece(motion, face, float(a), float(b)) for a, b in pairwise(joints)]
        for number, span in enumerate(spans):
            branches.extend(parts := _forward_parts(span))
            folds += max(len(parts) - 1, 0)
            section = follower.section(span, spans[(number + 1) % len(spans)])
            if section is not None:
                branches.append(section)
    if folds > _MOST_FOLDS:
        raise DesignError(
            "the {motion} ripples so closely that the {follower}'s contact turns back at {folds} "
            "places, {most} at most are followed: {fewer}",
            motion=motion.noun,
            follower=follower.noun,
            folds=folds,
            most=_MOST_FOLDS,
            fewer=motion.fewer(-(-folds // _MOST_FOLDS)),
        )
    return branches


def _forward_parts(span: Swept) -> list[Swept]:
    """Cut a span at its cusps and folds and keep what runs forward."""
    count = max(9, int(_SAMPLES * (span.stop - span.start) / TURN))
    # Between two nodes of the lift it may turn back, too, however close they are.
    nodes = span.motion.q.x
    nodes = nodes[(nodes > span.start) & (nodes < span.stop)]
    theta = np.union1d(np.linspace(span.start, span.stop, count), np.append(nodes, (nodes[1:] + nodes[:-1]) / 2))
    forward = span.advance(theta) > 0
    if forward.all():
        return [span]
    flips = np.flatnonzero(forward[1:] != forward[:-1])
    low, high = theta[flips], theta[flips + 1]
    column = np.arange(len(flips))
    for _ in range(_CUSP_ZOOMS):
        steps = low + (high - low) * np.linspace(0.0, 1.0, _CUSP_ZOOM + 1)[:, None]
        turned = ((span.advance(steps.ravel()) > 0).reshape(steps.shape) != forward[flips])[1:-1]
        first = np.where(turned.any(axis=0), np.argmax(turned, axis=0) + 1, _CUSP_ZOOM)
        low, high = steps[first - 1, column], steps[first, column]
    edges = np.concatenate([[span.start], (low + high) / 2, [span.stop]])
    keep = np.concatenate([forward[flips], forward[-1:]])
    return [replace(span, start=float(a), stop=float(b)) for a, b, k in zip(edges, edges[1:], keep, strict=False) if k]


def _crossing(
    before: Branch,
    after: Branch,
    by_angle: tuple[ByAngle, ByAngle],
    bracket: tuple[float, float],
    near: float,
    side: float,
) -> tuple[float, float]:
    """Parameters at which two branches meet between two polar angles, by Newton's method.

    Where that fails because they are nearly parallel, by `_closest`.
    """
    t = np.array([one.parameters(np.array([near]))[0] for one in by_angle])
    for _ in range(_NEWTON_STEPS):
        a, b = before.jet(t[:1]), after.jet(t[1:])
        system = np.stack([a.velocity[0], -b.velocity[0]], axis=1)
        if np.linalg.det(system) == 0:
            break
        step = np.linalg.solve(system, (a.point - b.point)[0])
        t = np.clip(t - step, [before.start, after.start], [before.stop, after.stop])
        if np.abs(step).max() < _CONVERGED:
            break
    points = np.concatenate([before.jet(t[:1]).point, after.jet(t[1:]).point])
    off = (polar_angle(points) - bracket[0] + np.pi) % TURN - np.pi
    inside = np.all((off > -_JOINT) & (off < bracket[1] - bracket[0] + _JOINT))
    if inside and np.abs(points[0] - points[1]).max() < SAME:
        return float(t[0]), float(t[1])
    return _closest(before, after, by_angle, bracket, side)


def _closest(
    before: Branch, after: Branch, by_angle: tuple[ByAngle, ByAngle], bracket: tuple[float, float], side: float
) -> tuple[float, float]:
    """Parameters at the one polar angle in a bracket where the radii of two branches cross, or else agree best."""
    low, high = bracket
    for _ in range(_ZOOMS):
        angles = np.linspace(low, high, _ZOOM)
        t = [one.parameters(angles) for one in by_angle]
        r = [np.linalg.norm(b.jet(at).point, axis=1) for b, at in zip((before, after), t, strict=True)]
        off = side * (r[0] - r[1])
        if not off[0] < 0 < off[-1]:
            best = int(np.argmin(np.abs(off)))
            break
        best = int(np.argmax(off > 0))
        low, high = angles[best - 1], angles[best]
    return float(t[0][best]), float(t[1][best])


def _overhang(motion: Motion, follower: Follower, after: Branch, enter: float) -> DesignError:
    """Branches that do not meet leave a wall along the ray between them, which no follower can climb."""
    theta = after.cam_angle(enter) % TURN
    return DesignError(
        "the cam's flank at cam angle {angle:.1f} degrees would be steeper than radial, with a "
        "pressure angle beyond 90 degrees, so the {follower} cannot follow it: {softer} or raise "
        "{base_key}",
        angle=np.degrees(theta),
        follower=follower.noun,
        softer=motion.softer(theta),
        base_key=follower.base_key,
    )


def _trim(motion: Motion, before: Branch, after: Branch, leave: float, enter: float) -> Trim | None:
    """The trim at a crossing; None where nothing is lost because the branches coincide."""
    angles = [before.cam_angle(leave), after.cam_angle(enter)]
    width = (angles[1] - angles[0] + np.pi) % TURN - np.pi
    if width < _NO_TRIM:
        return None
    point = before.jet(np.array([leave])).point[0]
    kind = TrimKind.LOCAL
    if before.face != after.face:
        kind = TrimKind.FACE_CHANGE
    elif isinstance(before, Swept):
        lost = angles[0] + np.linspace(0, 1, 201) * ((angles[1] - angles[0]) % TURN)
        kinked = np.any((motion.kinks - angles[0]) % TURN <= (angles[1] - angles[0]) % TURN)
        whole = replace(before, start=float(lost[0]), stop=float(lost[-1]))
        # On the outer flank of a groove a swallowtail is convex, and is known by its turning back.
        back = bool((whole.advance(lost) < 0).any())
        if not kinked and not back and whole.jet(lost).curvature.min() > 0:
            kind = TrimKind.GLOBAL
    return Trim(point, angles[0] % TURN, angles[1] % TURN, kind)


def _angle(branch: Branch, t: float) -> float:
    return float(polar_angle(branch.jet(np.array([t])).point)[0])
