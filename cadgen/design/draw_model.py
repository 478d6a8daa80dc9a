"""From a design to what can be set on its car, and the ranges that a draw of spacings needs."""

from math import degrees, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import rolling_step
from cadgen.cam.follower import Contact, EdgeFollower
from cadgen.car.course.layout import Draw
from cadgen.car.draws.setting_ranges import SettingRange, SettingRanges, Wheels
from cadgen.car.draws.target import Complex, Steering, Target
from cadgen.car.path.wheel_track import Track
from cadgen.car.running.drive import wheel_radius
from cadgen.curves.closed import ClosedCurve
from cadgen.design import cam_model, gear_model
from cadgen.design.course import spacings_of
from cadgen.design.schema import Design
from cadgen.design.settings import SettingsSection
from cadgen.deviations.deviation import BASE_RADIUS, INNER_FACE, START_HEADING, START_X, START_Y
from cadgen.errors import DesignError
from cadgen.messages import Message

# Share of steering or travel that may be missing at the end of a range; with more no turn comes out right.
_MOST_OFF = 0.1
_OUTLINE_STEP = 0.03  # mm; the run then ends within 0.01 mm of where finer steps take it
_ZERO = np.zeros(1)


def settings(design: Design) -> SettingsSection:
    """The section of what can be set on the car.

    Raises:
        DesignError: the design does not say it.
    """
    if design.settings is None:
        raise DesignError(
            "settings is missing, which says what can be set on the car when a spacing is drawn: add [settings] with "
            "disc_from_mm and disc_to_mm for the disc on its shaft, wheel_from_mm and wheel_to_mm or wheel_radii_mm "
            "for the drive wheel, and start_within_mm for the start"
        )
    return design.settings


def draw(design: Design) -> Draw:
    """The spacings of the course.

    Raises:
        DesignError: the course has one spacing alone.
    """
    spacings = spacings_of(design.course)
    if spacings is None:
        raise DesignError(
            "course.spacing is missing, so there is one course and nothing to set for: add [course.spacing] with "
            "from_mm and to_mm"
        )
    return spacings


def setting_ranges(design: Design, track: Track, start: tuple[float, float, float]) -> SettingRanges:
    """Quantities that can be set, at a start of the scaled path.

    Args:
        design: loaded design.
        track: track of the drive wheel as stated.
        start: x and y of the planned point there, mm, and heading, rad.

    Raises:
        DesignError: no ratio is known.
    """
    given = settings(design)
    x, y, heading = start
    return SettingRanges(
        disc=SettingRange(*given.range_of(INNER_FACE)),
        head=SettingRange(*given.range_of(BASE_RADIUS)),
        wheels=wheels(design, track),
        x=SettingRange(*given.range_of(START_X), x),
        y=SettingRange(*given.range_of(START_Y), y),
        heading=SettingRange(*given.range_of(START_HEADING), heading),
    )


_NO_TRAIN = Message(
    "train is missing, and without its ratio the radius of the drive wheel is not known, which is set for each "
    "spacing: add [train]"
)


def wheels(design: Design, track: Track) -> Wheels:
    """Drive wheels and ratios that can be had; those of the design where [settings] names none.

    Raises:
        DesignError: no ratio is known, so no radius is.
    """
    given = settings(design)
    if design.train is None:
        raise DesignError(_NO_TRAIN)
    ratio = float(gear_model.train(design).ratio)
    ratios = given.ratios or (ratio,)
    if given.wheel_from_mm is not None and given.wheel_to_mm is not None:
        return Wheels((given.wheel_from_mm, given.wheel_to_mm), ratios, made=True, step=given.wheel_step_mm)
    return Wheels(given.wheel_radii_mm or (wheel_radius(track.turn, ratio),), ratios)


def refuse_range(design: Design, spacings: Draw, track: Track | None, rod: EdgeFollower) -> None:
    """Refuse settings with which the disc meets the fork or leaves the rod, or that cannot reach the spacings.

    Args:
        design: loaded design.
        spacings: what is drawn.
        track: track of the drive wheel as stated; None before one is planned, when the wheels are not judged yet.
        rod: rod as designed.

    Raises:
        DesignError: the key, what is wrong, and what to change.
    """
    given = settings(design)
    _refuse_ends(given, rod)
    low, high = (end / spacings.stated for end in (spacings.spacings[0], spacings.spacings[-1]))
    middle = (rod.inner + rod.outer) / 2
    for factor, key, disc in ((low, "from", given.disc_from_mm), (high, "to", given.disc_to_mm)):
        spacing, wanted = factor * spacings.stated, middle * (factor - 1)
        if (wanted - disc) * (factor - 1) > _MOST_OFF * (middle + wanted) * abs(factor - 1):
            raise DesignError(
                "settings.disc_{key}_mm is {disc:g}, but with posts {spacing:g} mm apart the disc must be "
                "moved by {wanted:.2f} mm on its shaft to steer by {percent:.0f} %: set "
                "settings.disc_{key}_mm to {wanted:.1f}, or bring course.spacing.{key}_mm nearer to "
                "{stated:g}",
                key=key,
                disc=disc,
                spacing=spacing,
                wanted=wanted,
                percent=100 / factor,
                stated=spacings.stated,
            )
    if track is None:
        if design.train is None:
            raise DesignError(_NO_TRAIN)
        return
    for factor, key, wheel in zip((low, high), ("from", "to"), wheels(design, track).travels, strict=True):
        spacing = factor * spacings.stated
        short = (factor * track.turn - wheel) * (factor - 1)
        if short > _MOST_OFF * factor * track.turn * abs(factor - 1):
            ratios = given.ratios or (float(gear_model.train(design).ratio),)
            radius = factor * track.turn / (TURN * (min(ratios) if factor < 1 else max(ratios)))
            raise DesignError(
                "settings has no drive wheel for posts {spacing:g} mm apart, where the car must go "
                "{travel:.0f} mm in a turn of the cam: set settings.wheel_{key}_mm to {radius:.1f}, or put "
                "such a wheel into settings.wheel_radii_mm",
                spacing=spacing,
                travel=factor * track.turn,
                key=key,
                radius=radius,
            )


def _refuse_ends(given: SettingsSection, rod: EdgeFollower) -> None:
    inner, outer = rod.inner + given.disc_from_mm, rod.outer + given.disc_to_mm
    if inner <= rod.radius:
        raise DesignError(
            "settings.disc_from_mm is {disc_from_mm:g}, which takes the disc to {inner:g} mm from the "
            "fork axis, less than the rod's radius: raise it to {radius:.1f} or more",
            disc_from_mm=given.disc_from_mm,
            inner=inner,
            radius=rod.radius - rod.inner + 1,
        )
    if outer >= rod.length:
        raise DesignError(
            "settings.disc_to_mm is {disc_to_mm:g}, which takes the disc's outer face to {outer:g} mm "
            "from the fork axis, past the end of the rod: lower it, or raise follower.length_mm, which "
            "is {length:g}",
            disc_to_mm=given.disc_to_mm,
            outer=outer,
            length=rod.length,
        )
    if rod.base_radius + given.head_from_mm <= rod.radius:
        raise DesignError(
            "settings.head_from_mm is {head_from_mm:g}, which leaves {base_radius:g} mm of base radius, "
            "less than the rod's radius: raise it",
            head_from_mm=given.head_from_mm,
            base_radius=rod.base_radius + given.head_from_mm,
        )


def start_of(spacings: Draw, track: Track, factor: float) -> tuple[float, float, float]:
    """Start of the scaled path: x and y of the planned point, mm, and heading, rad, between minus and plus pi.

    Args:
        spacings: spacings of the course.
        track: track as it is planned.
        factor: ratio of the spacing to the stated one.
    """
    x, y = track.planned(0.0).tolist()
    heading = radians((degrees(float(track.heading(_ZERO)[0])) + 180) % 360 - 180)
    return (*spacings.point((x, y), factor), heading)


def places(design: Design, track: Track, spacings: Draw, motor: Array, spacing: float) -> Complex:
    """Planned point of the scaled path at motor positions.

    Args:
        design: loaded design.
        track: track of the drive wheel as stated.
        spacings: what is drawn.
        motor: motor positions, shape (n,), rad; on a closed path those of later turns are as on the first.
        spacing: spacing drawn, mm.

    Returns:
        Places x + iy, shape (n,), mm.
    """
    if design.as_built is None:
        arc = motor / TURN * track.turn
        arc = np.mod(arc, track.length) if track.closed else arc
    else:
        arc = np.interp(motor, cam_model.cam_angle(design, track, track.arc), track.arc)
    planned = track.planned(arc)
    x, y = spacings.point((planned[:, 0], planned[:, 1]), spacing / spacings.stated)
    return np.asarray(x + 1j * y)


def target(
    design: Design, track: Track, spacings: Draw, spacing: float, nodes: Array, motor: Array, steering: Steering
) -> Target:
    """The path of a spacing with the car that is to drive it.

    Args:
        design: loaded design.
        track: track of the drive wheel as stated.
        spacings: what is drawn.
        spacing: spacing drawn, mm.
        nodes: cam angles between which the car is driven, shape (n + 1,), rad.
        motor: motor positions at which it is held against the path, shape (m,), rad.
        steering: steering that the disc gives.
    """
    return Target(
        nodes=nodes,
        motor=motor,
        places=places(design, track, spacings, motor, spacing),
        heading=start_of(spacings, track, spacing / spacings.stated)[2],
        offset=design.path.offset_mm,
        car=cam_model.car(design),
        steering=steering,
        rim=cam_model.travel(design, track) / track.turn,
    )


def contact(design: Design, cut: ClosedCurve, rod: EdgeFollower, cam_angle: Array) -> Contact:
    """Roll a rod on a disc of a design that is cut to a curve; arguments and errors as of `AsBuilt.roll_new`.

    Args:
        design: loaded design.
        cut: curve that is cut, mm.
        rod: rod.
        cam_angle: cam angles, rad, shape (n,).
    """
    step = rolling_step(cut, rod, _OUTLINE_STEP)
    return cam_model.as_built(design).roll_new(cut, rod, cam_angle, step)
