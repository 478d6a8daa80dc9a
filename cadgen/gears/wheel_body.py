"""A wheel's body from its teeth and its blank: bore, keyway, hub, web, lightening holes, and the walls they leave."""

from __future__ import annotations

from dataclasses import replace
from math import asin, degrees, floor, hypot, isfinite, pi

from cadgen.errors import DesignError
from cadgen.gears.stage import Wheel
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body, RadialHole, Slab
from cadgen.parts.face import Face
from cadgen.parts.features import DFlat, Hub, Keyway
from cadgen.parts.loop import Loop, circle, loop_of

# Least wall elsewhere in mm: thinner ones bend under the cutter.
LEAST_WALL = 0.4


def gear_body(form: Wheel, blank: Blank | None = None) -> Body:
    """The body of one gear between the heights 0 and `form.width`, its hub above.

    Without `blank` it is a plain disc. Raises `DesignError` for a tooth that cannot be cut and for
    features that cut into each other, into the teeth, or leave too thin a wall.
    """
    blank = blank or Blank()
    teeth = form.outline
    holes = _checked_features(blank, form)
    bore = _bore(blank)
    hub = (circle(blank.hub.diameter),) if blank.hub else ()
    width = form.width
    slabs = [Slab(0.0, width, (teeth, *bore), holes)]
    if blank.web:
        low, high = (width - blank.web.thickness) / 2, (width + blank.web.thickness) / 2
        recessed = (teeth, circle(_rim_diameter(blank, form)), *hub, *bore)
        disc = Slab(low, high, (teeth, *bore), holes)
        slabs = [Slab(0.0, low, recessed), disc, Slab(high, width, recessed)]
    if not (blank.hub and blank.hub.length):
        return Body(tuple(slabs))
    slabs.append(Slab(width, width + blank.hub.length, (*hub, *bore)))
    screw = blank.hub.set_screw
    if screw is None:
        return Body(tuple(slabs))
    return Body(tuple(slabs), RadialHole(screw.diameter, width + screw.height, reach=blank.hub.diameter))


def _checked_features(blank: Blank, form: Wheel) -> tuple[Loop, ...]:
    """The lightening holes of a gear, after the checks of all its features."""
    _check_kinds(blank, form)
    _check_bore(blank, form)
    _check_hub(blank, form)
    _check_web(blank, form)
    return _lightening_holes(blank, form)


def with_collar(blank: Blank, lower: Wheel, upper: Wheel, length: float, clearance: float = 0.0) -> Blank:
    """The blank of two gears on one shaft with a collar of `length` (mm) between them, if it has no hub of its own.

    The collar stays under the roots of both gears by `clearance` (mm), to a tenth of a millimetre, so that the gears in
    mesh with them pass it. It is no thinner than bore and keyway need. Raises `DesignError` where there is no room.

    Args:
        blank: blank of the part.
        lower: gear at the bottom.
        upper: gear on top.
        length: length of the collar, mm.
        clearance: distance of the collar from the roots, mm.
    """
    if blank.hub:
        return blank
    smaller = min(lower, upper, key=lambda form: form.root_diameter)
    least, most = _least_hub(blank), smaller.root_diameter - 2 * LEAST_WALL
    _require(
        least <= most,
        f"{smaller} has no room for a collar between {least:.4g} mm over its bore and {most:.4g} mm under its root;"
        " give a smaller bore",
    )
    room = smaller.root_diameter - 2 * max(LEAST_WALL, clearance)
    return replace(blank, hub=Hub(diameter=max(floor(room * 10) / 10, least), length=length))


def cluster_body(lower: Wheel, upper: Wheel, blank: Blank | None = None, turn: float = 0.0) -> Body:
    """Two gears on one shaft as one body: `lower` made from `blank`, its hub as a collar, and `upper` on top.

    `turn` (rad) turns `upper` against `lower`. Raises `DesignError` as `gear_body` does, and where `upper`
    does not fit on the face or the collar it stands on.

    Args:
        lower: gear at the bottom.
        upper: gear on top.
        blank: blank of the part; None for gears without features.
        turn: angle of the upper gear against the lower one, rad.
    """
    blank = blank or Blank()
    body = gear_body(lower, blank)
    _check_upper(blank, upper)
    if not (blank.hub and blank.hub.length):
        seat = blank.hub.diameter if blank.hub else lower.root_diameter
        _require(
            upper.tip_diameter <= seat - 2 * LEAST_WALL,
            f"{upper} does not fit on the {seat:.4g} mm that {lower} offers it;"
            " put a collar (a hub with a length) between them",
        )
    top = body.slabs[-1].end
    teeth = upper.outline.rotated(turn)
    return Body((*body.slabs, Slab(top, top + upper.width, (teeth, *_bore(blank)))), body.radial_hole)


def fits(form: Wheel, blank: Blank, *, upper: bool | None = None) -> bool:
    """Whether a gear, as cut, has room for this blank: alone, or as the `upper` or lower of two on a shaft.

    Its teeth are not looked at.
    """
    if upper is not None and blank.hub is None:
        if form.root_diameter - 2 * LEAST_WALL < _least_hub(blank):
            return False
        # The collar that two gears get by default; for this one alone the web and the holes have most room.
        blank = replace(blank, hub=Hub(diameter=_least_hub(blank), length=1.0))
    try:
        if upper:
            _check_upper(blank, form)
        else:
            _checked_features(blank, form)
    except DesignError:
        return False
    return True


def _require(holds: bool, message: str) -> None:
    if not holds:
        raise DesignError(message)


def _require_positive(form: Wheel, **lengths: float) -> None:
    for name, value in lengths.items():
        _require(
            isfinite(value) and value > 0,
            f"{form} has a {name.replace('_', ' ')} of {value:g} mm; give more than 0, or leave it out",
        )


def _rim_diameter(blank: Blank, form: Wheel) -> float:
    """Where the rim ends inwards: at the web's recess if there is one, else as deep as the teeth need it."""
    return form.root_diameter - 2 * (blank.web.rim_thickness if blank.web else form.least_rim)


def _reach(blank: Blank) -> float:
    """Diameter of the circle that holds bore and keyway."""
    radius = blank.bore_diameter / 2
    if isinstance(blank.key, Keyway):
        radius = hypot(radius + blank.key.depth, blank.key.width / 2)
    return 2 * radius


def _least_hub(blank: Blank) -> float:
    """Diameter of the thinnest hub over bore and keyway."""
    return _reach(blank) + 2 * LEAST_WALL


def _check_kinds(blank: Blank, form: Wheel) -> None:
    """Refuse features for a disc alone; keyway and set screw stand at the angle 0, under a tooth."""
    _require(not isinstance(blank.key, DFlat), f"{form} has a D-flat in its bore; give a keyway, or none")
    _require(blank.edge_break == 0, f"{form} has broken edges; give the teeth a tip chamfer instead")
    _require(not blank.hub or blank.hub.side == Face.OUTER, f"{form} has its hub on the inner face; give the outer one")
    _require(blank.mark is None, f"{form} has a mark; leave it out, for its hub shows which face is up")
    screw = blank.hub.set_screw if blank.hub else None
    for name, feature in (("keyway", blank.key), ("set screw", screw)):
        angle = feature.angle if feature else 0.0
        _require(angle == 0, f"{form} has its {name} at {degrees(angle):g}°; give 0, which is under a tooth")


def _check_bore(blank: Blank, form: Wheel) -> None:
    """The keyway must fit the bore, and both must leave a rim under the root."""
    key, bore = blank.key, blank.bore_diameter
    _require(isfinite(bore) and bore >= 0, f"{form} has a bore of {bore:g} mm; give more than 0, or 0 for none")
    if isinstance(key, Keyway):
        _require_positive(form, keyway_width=key.width, keyway_depth=key.depth)
        _require(
            key.width < bore,
            f"{form} has a keyway of {key.width:g} mm width in a bore of {bore:g} mm; give a narrower one",
        )
    largest = form.root_diameter - 2 * form.least_rim
    _require(
        _reach(blank) <= largest,
        f"{form} has a {'keyway' if key and bore <= largest else 'bore'} that reaches to"
        f" {_reach(blank):.4g} mm diameter under its root of {form.root_diameter:.4g} mm;"
        f" keep it within {largest:.4g} mm",
    )


def _check_upper(blank: Blank, upper: Wheel) -> None:
    """The upper of two gears needs a rim over the bore, and its teeth clear of the collar."""
    _check_bore(blank, upper)
    if blank.hub and blank.hub.length:
        _require(
            blank.hub.diameter < upper.root_diameter,
            f"the collar of {blank.hub.diameter:g} mm stands in the teeth of {upper};"
            f" give a hub diameter under {upper.root_diameter:.4g} mm",
        )


def _check_web(blank: Blank, form: Wheel) -> None:
    """A web needs a hub to stand on, a width to be thinner than and a rim that carries the teeth."""
    if not blank.web:
        return
    if blank.hub is None:
        raise DesignError(f"{form} has a web but no hub; give the hub's diameter")
    web, thickest = blank.web, form.width - 2 * LEAST_WALL
    _require(
        LEAST_WALL <= web.thickness <= thickest,
        f"{form} has a web of {web.thickness:g} mm in a width of {form.width:g} mm; "
        + _range(LEAST_WALL, thickest, "leave the web out, or give a greater width"),
    )
    least = form.least_rim
    most = (form.root_diameter - blank.hub.diameter) / 2 - LEAST_WALL
    narrowest, widest = _reach(blank) + 2 * LEAST_WALL, form.root_diameter - 2 * (least + LEAST_WALL)
    smaller = f", or give a hub of {narrowest:.4g} to {widest:.4g} mm" if narrowest <= widest else ""
    _require(
        least <= web.rim_thickness <= most,
        f"{form} has a rim of {web.rim_thickness:g} mm between its root of {form.root_diameter:.4g} mm and its hub of"
        f" {blank.hub.diameter:g} mm diameter; " + _range(least, most, "leave the web out" + smaller),
    )


def _range(low: float, high: float, otherwise: str) -> str:
    return f"give {low:.4g} to {high:.4g} mm" if low <= high else otherwise


def _check_hub(blank: Blank, form: Wheel) -> None:
    """The hub must hold the bore and the set screw, and stay inside the root."""
    if not blank.hub:
        return
    hub = blank.hub
    _require(
        isfinite(hub.length) and (hub.length > 0 or (hub.length == 0 and blank.web is not None)),
        f"{form} has a hub of {hub.length:g} mm length; give more than 0, or 0 and a web",
    )
    least = _least_hub(blank)
    largest = form.root_diameter - 2 * LEAST_WALL
    _require(
        least <= hub.diameter <= largest,
        f"{form} has a hub of {hub.diameter:g} mm between its bore and its teeth; "
        + _range(least, largest, "leave the hub out, or give a smaller bore"),
    )
    if screw := hub.set_screw:
        room = 2 * min(screw.height, hub.length - screw.height)
        widest = max(min(room, blank.bore_diameter) - 2 * LEAST_WALL, 0.0)
        _require(
            0 < screw.diameter <= widest,
            f"{form} has a set screw of {screw.diameter:g} mm in a hub of {hub.length:g} mm length with a"
            f" bore of {blank.bore_diameter:g} mm; give at most {widest:.4g} mm",
        )


def _bore(blank: Blank) -> tuple[Loop, ...]:
    """The loop of the bore, if there is one."""
    if not blank.bore_diameter:
        return ()
    return (loop_of(blank.bore()) if blank.key else circle(blank.bore_diameter),)


def _lightening_holes(blank: Blank, form: Wheel) -> tuple[Loop, ...]:
    if not blank.lightening:
        return ()
    count, diameter = blank.lightening.count, blank.lightening.hole_diameter
    low, high = max(blank.hub.diameter if blank.hub else 0.0, _reach(blank)), _rim_diameter(blank, form)
    middle, ring = (low + high) / 2, blank.lightening.circle_diameter
    pitch_radius = (middle if ring is None else ring) / 2
    largest = (high - low) / 2 - abs(2 * pitch_radius - middle) - 2 * LEAST_WALL
    _require(
        count >= 1 and LEAST_WALL <= diameter <= largest,
        f"{form} has {count} lightening holes of {diameter:g} mm between {low:.4g} and {high:.4g} mm diameter; "
        + _range(LEAST_WALL, largest, "leave them out"),
    )
    most = pi / asin(min((diameter + 2 * LEAST_WALL) / (2 * pitch_radius), 1.0))
    _require(
        count <= max(most, 1.0),
        f"{form} has {count} lightening holes of {diameter:g} mm on a circle of {2 * pitch_radius:.4g} mm diameter;"
        f" give at most {max(int(most), 1)}, or smaller ones",
    )
    centers = blank.lightening.centers() if ring else blank.lightening.centers_off_keyway(2 * pitch_radius)
    return tuple(circle(diameter, complex(x, y)) for x, y in centers)
