"""Parts of a frame among the parts of its car."""

from collections import Counter
from collections.abc import Iterator

import numpy as np

from cadgen.arrays import Array
from cadgen.car.assembly.car_parts import Block, CarPart, GroupKind, MovingGroup, Supply, turned_round
from cadgen.car.assembly.carried import Carried
from cadgen.car.assembly.frame.bought_parts import Bought, BoughtKind
from cadgen.car.assembly.panels import BASE_COLOUR, PLATE_COLOUR, Panel, PartPlace
from cadgen.car.running.friction import DiscMaterial, named_material
from cadgen.design import gear_model
from cadgen.design.frame import FrameSection
from cadgen.design.train import PlateSection
from cadgen.jobs.cam.cam_plan import DENSITY
from cadgen.jobs.car_frame import CarFrame
from cadgen.messages import Message, joined

_STANDS = MovingGroup(GroupKind.FRAME)
_STEEL = DENSITY[DiscMaterial.STEEL] * 1e-3  # g/mm³
_HOLLOW = 0.6  # of a bearing's ring: the room between its rings is empty
_PULLEY, _KNOTS = 10.0, 200.0  # g of a small pulley in its bracket; mm of string for two knots and the pulley
_BELT = 10.0  # g of a small belt with its pulleys, or of two gears
_DARK, _BRASS = (0.22, 0.24, 0.27), (0.78, 0.65, 0.30)


def frame_parts(frame: CarFrame) -> tuple[CarPart, ...]:
    """Sheets, block and bought parts of a frame; screws and nuts are listed and not drawn.

    Args:
        frame: frame of the car.
    """
    return (*_made(frame), *_bought(frame))


def _made(frame: CarFrame) -> Iterator[CarPart]:
    plates = gear_model.train_keys(frame.design).plate or PlateSection()
    others, usual = material_of(frame), DiscMaterial.ALUMINIUM
    printed = frame.frame.printed
    if printed is not None:
        usual = DiscMaterial.PLA
        name, density, assumed = known_material(others, usual)
        yield CarPart(
            code="printed-frame",
            title=Message("frame in one piece"),
            shape=printed.shape,
            places=(_matrix(printed.place),),
            group=_STANDS,
            material=name,
            density=density,
            assumed=assumed,
            colour=BASE_COLOUR,
            standard=f"{frame.stem}_printed",
            how=Message("printed on the lower face of its base"),
        )
    for panel in frame.frame.sheets:
        stated = plates.material if panel in frame.frame.plates else others
        colour = BASE_COLOUR if panel.code in ("base", "platform") else PLATE_COLOUR
        yield _sheet(panel, known_material(stated, usual), colour, f"{frame.stem}_{panel.code}")
    if frame.frame.carried is not None:
        yield from _drive(frame.frame.carried)
    block = frame.frame.block
    name, density, assumed = known_material(others, usual)
    yield CarPart(
        code="fork-block",
        title=Message("block of the fork"),
        shape=block.shape,
        places=(_matrix(block.place),),
        group=_STANDS,
        material=name,
        density=density,
        assumed=assumed,
        colour=PLATE_COLOUR,
        standard=f"{frame.stem}_block",
    )


def _drive(carried: Carried) -> Iterator[CarPart]:
    """Weight before its fall with pulley and string, or motor."""
    body = carried.body
    size = f"{body.along:g} x {body.across:g} x {body.tall:g}"
    yield CarPart(
        code="drop-weight" if body.fall else "motor",
        title=body.title,
        shape=carried.shape,
        places=(_matrix(carried.place),),
        group=_STANDS,
        material=Message("steel") if body.fall else "",
        density=0.0,
        mass=1000 * body.mass,
        colour=_DARK,
        supply=Supply.BOUGHT,
        standard=f"{body.along:g} x {body.tall:g}, {body.mass:g} kg" if body.fall else f"{size}, {body.mass:g} kg",
        how=Message(
            "between its tubes; its string leads through the top plate, over a pulley of {size:.1f} mm, down behind "
            "the rear axle, is wound by {turns:.1f} turns of the wheels backwards on {what}, and is knotted behind the "
            "hole in it",
            size=carried.pulley,
            turns=body.turns,
            what=Message("the drum") if body.drum else Message("the axle"),
        )
        if body.fall
        else Message("screwed to the base from below; its shaft drives the rear axle"),
    )
    long = f"{body.string:g} mm x {carried.tubes + body.fall + _KNOTS:.0f} mm"
    bought = [
        (
            "pulley",
            Message("pulley of the string, in its bracket"),
            f"Ø{carried.pulley:.1f}",
            _PULLEY,
            Message("on the top plate"),
        ),
        ("string", Message("string"), long, 0.5, Message("from the weight over the pulley to the rear axle")),
    ]
    if not body.fall:
        bought = [
            (
                "motor-drive",
                Message("belt or gears between motor and rear axle"),
                Message("by the motor"),
                _BELT,
                Message("from the motor's shaft to the rear axle"),
            )
        ]
    for code, title, standard, mass, how in bought:
        yield CarPart(
            code=code,
            title=title,
            shape=None,
            places=(),
            group=_STANDS,
            material="",
            density=0.0,
            mass=mass,
            supply=Supply.BOUGHT,
            standard=standard,
            further=1,
            how=how,
        )


def _sheet(panel: Panel, material: tuple[str, float, bool], colour: tuple[float, float, float], files: str) -> CarPart:
    name, density, assumed = material
    return CarPart(
        code=panel.code.replace("_", "-"),
        title=Message(panel.name),
        shape=panel.shape,
        places=(_matrix(panel.place),),
        group=_STANDS,
        material=name,
        density=density,
        assumed=assumed,
        colour=colour,
        standard=files,
    )


def _bought(frame: CarFrame) -> Iterator[CarPart]:
    kinds: dict[str, list[Bought]] = {}
    for part in frame.frame.bought:
        kinds.setdefault(part.code, []).append(part)
    for code, parts in kinds.items():
        first, number = parts[0], len(parts)
        drawn = first.kind not in (BoughtKind.SCREW, BoughtKind.NUT)
        material = DiscMaterial.ALUMINIUM if first.kind == BoughtKind.TUBE else DiscMaterial.STEEL
        shape = None
        if drawn:
            shape = Block(tuple(turned_round((low, high, outer, bore) for outer, bore, low, high in first.rounds)))
        own = f"{first.kind}-{first.code}".lower().replace(" ", "-")
        if first.kind == BoughtKind.BEARING:  # as the car calls those in its plates
            outside, bore, _, _ = first.rounds[0]
            own = f"bearing-{bore:g}-{outside:g}"
        elif first.kind == BoughtKind.MICROMETER:
            own = "micrometer-head"
        volume = sum(np.pi / 4 * (outer**2 - bore**2) * (high - low) for outer, bore, low, high in first.rounds)
        yield CarPart(
            code=own.replace(".", "p"),
            title=Message("ball bearing") if first.kind == BoughtKind.BEARING else Message(first.name),
            shape=shape,
            places=tuple(_along(each) for each in parts) if drawn else (),
            group=_STANDS,
            material=Message(str(material)),
            density=DENSITY[material] * 1e-3 * (_HOLLOW if first.kind == BoughtKind.BEARING else 1.0),
            assumed=False,
            colour=_DARK if first.kind == BoughtKind.BEARING else _BRASS,
            supply=Supply.BOUGHT,
            standard=code,
            mass=None if drawn else _STEEL * volume,
            further=0 if drawn else number,
            how=_where(parts),
        )


def _where(parts: list[Bought]) -> str:
    """Where like parts belong, with how many of them where they belong to several places."""
    count = Counter(part.where for part in parts if part.where)
    if len(count) <= 1:
        return next(iter(count), "")
    return joined(Message("{count} {where}", count=number, where=where) for where, number in count.items())


def material_of(frame: CarFrame) -> str | None:
    """Material of base, platform, block and brackets as a design states it; a printed frame has none from its plates.

    Args:
        frame: frame of the car.
    """
    keys = frame.design.frame or FrameSection()
    plates = gear_model.train_keys(frame.design).plate or PlateSection()
    return keys.material or (None if keys.printed else plates.material)


def known_material(stated: str | None, usual: DiscMaterial) -> tuple[str, float, bool]:
    """Material in words, its density, g/mm³, and whether either is assumed.

    Args:
        stated: material as a design states it; None where it does not.
        usual: material that is taken where nothing is known.
    """
    known = named_material(stated)
    return Message(stated or str(usual)), DENSITY[known or usual] * 1e-3, known is None


def _matrix(place: PartPlace) -> Array:
    return np.column_stack([place.turn, place.shift])


def _along(part: Bought) -> Array:
    """Place whose z axis is that of a bought part."""
    way = np.asarray(part.way)
    beside = np.array([0.0, 0.0, 1.0] if abs(way[0]) > 0.5 else [1.0, 0.0, 0.0])
    return np.column_stack([beside, np.cross(way, beside), way, np.asarray(part.start)])
