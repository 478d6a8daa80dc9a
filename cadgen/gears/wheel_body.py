"""A wheel's body from its teeth and its blank: bore, keyway, hub, web, lightening holes, and the walls they leave."""

from __future__ import annotations

from dataclasses import replace
from math import asin, ceil, degrees, floor, hypot, inf, isfinite, pi, sin, tan

from cadgen.errors import DesignError
from cadgen.gears.stage import Wheel, holes_of, is_bar, is_ring, rim_diameter
from cadgen.gears.tooth import MOST_TEETH_MORE, GearForm
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body, RadialHole, Slab
from cadgen.parts.face import Face
from cadgen.parts.features import DFlat, Flats, Hub, Keyway
from cadgen.parts.loop import Loop, circle, loop_of

# Least wall elsewhere in mm: thinner ones bend under the cutter.
LEAST_WALL = 0.4
STEPS = 10  # in a mm, of diameters that follow from others: a shop's drills and gauges have no finer ones


def gear_body(form: Wheel, blank: Blank | None = None) -> Body:
    """The body of one gear between the heights 0 and `form.width`, its hub above.

    Without `blank` it is a plain disc. Raises `DesignError` for a tooth that cannot be cut and for
    features that cut into each other, into the teeth, or leave too thin a wall.
    """
    blank = blank or Blank()
    teeth = form.outline.from_below(form.width)
    if is_ring(form) or is_bar(form):
        return _plain_body(form, blank, teeth)
    pins = _pin_holes(blank, form)
    holes = _checked_features(blank, form) + pins
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


def _pin_holes(blank: Blank, form: Wheel) -> tuple[Loop, ...]:
    """Holes of a carrier for the pins of its planets; none of another wheel."""
    holes = holes_of(form)
    for feature, name, key in (
        (blank.web, Message("a web"), "web"),
        (blank.lightening, Message("lightening holes"), "lightening"),
    ):
        if feature and holes:
            raise DesignError(
                "{gear} has {feature}, and its plate holds the pins of the planets; remove {key}",
                gear=str(form),
                feature=name,
                key=key,
            )
    return holes


def _plain_body(form: Wheel, blank: Blank, teeth: Loop) -> Body:
    """The body of a ring, a plain rim, or of a rack: no shaft can pass through them."""
    for name, key in (
        (Message("a bore"), "bore_diameter_mm" if blank.bore_diameter else ""),
        (Message("a hub"), "hub" if blank.hub else ""),
        (Message("a keyway"), "keyway" if blank.key else ""),
        (Message("a web"), "web" if blank.web else ""),
        (Message("lightening holes"), "lightening" if blank.lightening else ""),
    ):
        if key and is_bar(form):
            raise DesignError(
                "{gear} has {feature}, and a rack is a plain bar; remove {key}", gear=str(form), feature=name, key=key
            )
        if key:
            raise DesignError(
                "{gear} has {feature}, and a ring is a plain rim; remove {key}", gear=str(form), feature=name, key=key
            )
    if is_bar(form):
        return Body((Slab(0.0, form.width, (teeth,)),))
    return Body((Slab(0.0, form.width, (circle(rim_diameter(form)), teeth)),))


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
    if not least <= most:
        room = floor((blank.bore_diameter - (least - most)) * STEPS) / STEPS
        fitting = room > 0 and _least_hub(replace(blank, bore_diameter=room)) <= most
        raise DesignError(
            "{gear} has no room for a collar between {least:.4g} mm over its bore and {most:.4g} mm under its root;"
            " {cure}",
            gear=str(smaller),
            least=least,
            most=most,
            cure=Message("give bore_diameter_mm = {bore:g}", bore=room) if fitting else Message("give a smaller bore"),
        )
    room = smaller.root_diameter - 2 * max(LEAST_WALL, clearance)
    return replace(blank, hub=Hub(diameter=max(floor(room * STEPS) / STEPS, least), length=length))


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
        if not upper.tip_diameter <= seat - 2 * LEAST_WALL:
            raise DesignError(
                "{upper} does not fit on the {seat:.4g} mm that {lower} offers it; put a collar (a hub with a length)"
                " between them, with length_mm = 1",
                upper=str(upper),
                seat=seat,
                lower=str(lower),
            )
    top = body.slabs[-1].end
    teeth = upper.outline.from_below(upper.width).rotated(turn)
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


def _rim_diameter(blank: Blank, form: Wheel) -> float:
    """Inner diameter of the rim, mm, where the recess of the web begins or the teeth need no more.

    A recess has a size in whole tenths, with the rim no thinner than asked for, if the holes have room beside it.
    """
    if not blank.web:
        return form.root_diameter - 2 * form.least_rim
    exact = form.root_diameter - 2 * blank.web.rim_thickness
    even = floor(exact * STEPS) / STEPS
    smallest = blank.lightening.hole_diameter if blank.lightening else 0.0
    return even if _holes_circle(blank, even)[1] >= smallest else exact


def _holes_circle(blank: Blank, rim: float) -> tuple[float, float]:
    """Diameter of the circle of holes, mm, and of the largest holes that have their walls there, negative for none.

    Midway between hub and rim it has a size in whole tenths, if the holes have room on it.

    Args:
        blank: blank of the gear.
        rim: diameter at which the rim ends inwards, mm.
    """
    low, holes = _inner_diameter(blank), blank.lightening
    middle = (low + rim) / 2
    ring = holes.circle_diameter if holes else None
    even = round(middle * STEPS) / STEPS
    for diameter in (even, middle) if ring is None else (ring,):
        largest = (rim - low) / 2 - abs(diameter - middle) - 2 * LEAST_WALL
        if not holes:
            break
        between = diameter * sin(pi / holes.count) if holes.count > 1 else inf
        if largest >= holes.hole_diameter and between >= holes.hole_diameter + 2 * LEAST_WALL:
            break
    return diameter, largest


def _inner_diameter(blank: Blank) -> float:
    """Least inner diameter of a recess in the web, mm: outside it hub, bore and keyway leave room."""
    return max(blank.hub.diameter if blank.hub else 0.0, _reach(blank))


def _reach(blank: Blank) -> float:
    """Diameter of the circle that holds bore and keyway, or the corners of its flats."""
    radius = blank.shaft_diameter / 2
    if isinstance(blank.key, Keyway):
        radius = hypot(radius + blank.key.depth, blank.key.width / 2)
    return 2 * radius


def _least_hub(blank: Blank) -> float:
    """Diameter of the thinnest hub over bore and keyway."""
    return _reach(blank) + 2 * LEAST_WALL


def _check_kinds(blank: Blank, form: Wheel) -> None:
    """Refuse features for a disc alone; keyway, flat and set screw stand at the angle 0, under a tooth."""
    if blank.edge_break != 0:
        raise DesignError("{gear} has broken edges; give the teeth a tip chamfer instead", gear=str(form))
    if blank.hub and blank.hub.side != Face.OUTER:
        raise DesignError("{gear} has its hub on the inner face; give the outer one", gear=str(form))
    if blank.mark is not None:
        raise DesignError("{gear} has a mark; leave it out, for its hub shows which face is up", gear=str(form))
    screw = blank.hub.set_screw if blank.hub else None
    key = Message("keyway") if isinstance(blank.key, Keyway) else Message("flat")
    for name, feature in ((key, blank.key), (Message("set screw"), screw)):
        if feature and feature.angle != 0:
            raise DesignError(
                "{gear} has its {feature} at {angle:g}°; give 0, which is under a tooth",
                gear=str(form),
                feature=name,
                angle=degrees(feature.angle),
            )


def _check_bore(blank: Blank, form: Wheel) -> None:
    """The keyway must fit the bore, and both must leave a rim under the root."""
    key, bore = blank.key, blank.bore_diameter
    if not (isfinite(bore) and bore >= 0):
        raise DesignError(
            "{gear} has a bore of {bore:g} mm; give more than 0, or 0 for none", gear=str(form), bore=bore
        )
    if key and not bore:
        raise DesignError(
            "{gear} has flats or a keyway and no bore; give bore_diameter_mm, such as 5, or leave them out",
            gear=str(form),
        )
    if isinstance(key, Keyway):
        for name, length in ((Message("keyway width"), key.width), (Message("keyway depth"), key.depth)):
            if not (isfinite(length) and length > 0):
                raise DesignError(
                    "{gear} has a {size} of {length:g} mm; give more than 0, or leave it out",
                    gear=str(form),
                    size=name,
                    length=length,
                )
        if not key.width < bore:
            raise DesignError(
                "{gear} has a keyway of {width:g} mm width in a bore of {bore:g} mm; give a narrower one, such as "
                "{usual:g}",
                gear=str(form),
                width=key.width,
                bore=bore,
                usual=round(bore / 3, 2),
            )
    if isinstance(key, DFlat) and not 0 < key.depth < bore / 2:
        raise DesignError(
            "{gear} has a flat at {across:g} mm across a bore of {bore:g} mm; give an across_mm of more than {half:g} "
            "and less than {bore:g}, such as {usual:g}",
            gear=str(form),
            across=bore - key.depth,
            bore=bore,
            half=bore / 2,
            usual=round(0.9 * bore, 2),
        )
    largest = form.root_diameter - 2 * form.least_rim
    if bore and not _reach(blank) <= largest + 1e-9:  # without a bore nothing is taken from a solid gear
        if largest <= 0:
            raise DesignError(
                "{gear} is too small for a bore: its root of {root:.4g} mm leaves none within a rim of {rim:.4g} mm; "
                "leave the bore out{teeth}",
                gear=str(form),
                root=form.root_diameter,
                rim=form.least_rim,
                teeth=_enough_teeth(form, _reach(blank)),
            )
        raise DesignError(
            "{gear} has a {feature} that reaches to {reach:.4g} mm diameter under its root of {root:.4g} mm; keep it"
            " within {largest:g} mm",
            gear=str(form),
            feature=Message("keyway") if isinstance(key, Keyway) and bore <= largest else Message("bore"),
            reach=_reach(blank),
            root=form.root_diameter,
            largest=floor((largest + 1e-9) * 100) / 100,
        )


def _enough_teeth(form: Wheel, reach: float) -> str:
    """Number of teeth that leave room for a bore, in words; empty where no number does.

    Args:
        form: gear without room for it.
        reach: diameter that the bore reaches to, mm.
    """
    if not isinstance(form, GearForm):
        return ""
    for teeth in range(form.teeth + 1, form.teeth + MOST_TEETH_MORE):
        more = replace(form, teeth=teeth)
        if more.root_diameter - 2 * more.least_rim >= reach:
            return Message(", or give {teeth} teeth", teeth=teeth)
    return ""


def _check_upper(blank: Blank, upper: Wheel) -> None:
    """The upper of two gears needs a rim over the bore, and its teeth clear of the collar."""
    _check_bore(blank, upper)
    if blank.hub and blank.hub.length and not blank.hub.diameter < upper.root_diameter:
        raise DesignError(
            "the collar of {collar:g} mm stands in the teeth of {gear}; give a hub diameter under {root:.4g} mm",
            collar=blank.hub.diameter,
            gear=str(upper),
            root=upper.root_diameter,
        )


def _check_web(blank: Blank, form: Wheel) -> None:
    """A web needs a hub to stand on, a width to be thinner than and a rim that carries the teeth."""
    if not blank.web:
        return
    if blank.hub is None:
        raise DesignError(
            "{gear} has a web but no hub; give the hub's diameter, {least:.4g} mm or more",
            gear=str(form),
            least=ceil(_least_hub(blank) * STEPS) / STEPS,
        )
    web, thickest = blank.web, form.width - 2 * LEAST_WALL
    if not LEAST_WALL <= web.thickness <= thickest:
        raise DesignError(
            "{gear} has a web of {web:g} mm in a width of {width:g} mm; {cure}",
            gear=str(form),
            web=web.thickness,
            width=form.width,
            cure=_range(LEAST_WALL, thickest, Message("leave the web out, or give a greater width")),
        )
    least = form.least_rim
    most = (form.root_diameter - blank.hub.diameter) / 2 - LEAST_WALL
    narrowest, widest = _reach(blank) + 2 * LEAST_WALL, form.root_diameter - 2 * (least + LEAST_WALL)
    if not least <= web.rim_thickness <= most:
        smaller = Message(
            "leave the web out, or give a hub of {narrowest:.4g} to {widest:.4g} mm",
            narrowest=narrowest,
            widest=widest,
        )
        raise DesignError(
            "{gear} has a rim of {rim:g} mm between its root of {root:.4g} mm and its hub of {hub:g} mm diameter;"
            " {cure}",
            gear=str(form),
            rim=web.rim_thickness,
            root=form.root_diameter,
            hub=blank.hub.diameter,
            cure=_range(least, most, smaller if narrowest <= widest else Message("leave the web out")),
        )


def _range(low: float, high: float, otherwise: Message) -> Message:
    """Cure of a length: the range in which it may lie, mm, or another one where there is none."""
    return Message("give {low:.4g} to {high:.4g} mm", low=low, high=high) if low <= high else otherwise


def _check_hub(blank: Blank, form: Wheel) -> None:
    """The hub must hold the bore and the set screw, and stay inside the root."""
    if not blank.hub:
        return
    hub = blank.hub
    if not (isfinite(hub.length) and (hub.length > 0 or (hub.length == 0 and blank.web is not None))):
        raise DesignError(
            "{gear} has a hub of {length:g} mm length; give more than 0, or 0 and a web",
            gear=str(form),
            length=hub.length,
        )
    least, largest = _least_hub(blank), form.root_diameter - 2 * LEAST_WALL
    if not least <= hub.diameter <= largest:
        raise DesignError(
            "{gear} has a hub of {hub:g} mm between its bore and its teeth; {cure}",
            gear=str(form),
            hub=hub.diameter,
            cure=_range(least, largest, Message("leave the hub out, or give a smaller bore")),
        )
    if screw := hub.set_screw:
        room = 2 * min(screw.height, hub.length - screw.height)
        key, across = blank.key, blank.bore_diameter
        if isinstance(key, Flats):  # the hole opens on the flat alone
            across *= tan(pi / key.count)
        widest = max(min(room, across) - 2 * LEAST_WALL, 0.0)
        if not 0 < screw.diameter <= widest:
            raise DesignError(
                "{gear} has a set screw of {screw:g} mm in a hub of {length:g} mm length with a bore of {bore:g} mm;"
                " give at most {widest:.4g} mm",
                gear=str(form),
                screw=screw.diameter,
                length=hub.length,
                bore=blank.bore_diameter,
                widest=widest,
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
    low, high, ring = _inner_diameter(blank), _rim_diameter(blank, form), blank.lightening.circle_diameter
    on, largest = _holes_circle(blank, high)
    if not (count >= 1 and LEAST_WALL <= diameter <= largest):
        raise DesignError(
            "{gear} has {count} lightening holes of {diameter:g} mm between {low:.4g} and {high:.4g} mm diameter;"
            " {cure}",
            gear=str(form),
            count=count,
            diameter=diameter,
            low=low,
            high=high,
            cure=_range(LEAST_WALL, largest, Message("leave them out")),
        )
    most = pi / asin(min((diameter + 2 * LEAST_WALL) / on, 1.0))
    if not count <= max(most, 1.0):
        raise DesignError(
            "{gear} has {count} lightening holes of {diameter:g} mm on a circle of {circle:.4g} mm diameter; give at"
            " most {most}, or smaller ones",
            gear=str(form),
            count=count,
            diameter=diameter,
            circle=on,
            most=max(int(most), 1),
        )
    centers = blank.lightening.centers() if ring else blank.lightening.centers_off_keyway(on)
    return tuple(circle(diameter, complex(x, y)) for x, y in centers)
