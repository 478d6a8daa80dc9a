"""Materials and fits of a gear train, for drawings and masses of its parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from cadgen.design.train import GearBlankSection, PlateSection, SpurStage, TrainSection
from cadgen.gears.fits import runs
from cadgen.gears.planetary_kind import PlanetaryKeys
from cadgen.messages import Message
from cadgen.output.drawing.shaft_fit import ShaftFit


@dataclass(frozen=True, slots=True)
class ShaftMaking:
    """Material and fits of the part on a shaft, for its drawing.

    Attributes:
        place: place of the shaft in the train, a key of the design.
        word: word for it.
        material: material of the part; None where the design does not say.
        fit: fits and joint of its bore.
        bored: whether it has a bore, and thus a fit to be stated.
        screwed: whether a set screw holds it, and thus a thread is to be stated.
    """

    place: str
    word: str
    material: str | None
    fit: ShaftFit
    bored: bool
    screwed: bool


@dataclass(frozen=True, slots=True)
class PinMaking:
    """Fits of the pins of a planetary stage.

    Attributes:
        planets: fit of the planets on their pins; None where the design does not say.
        carrier: fit of the pins in the carrier; None where the design does not say.
        diameter: diameter of the pins, mm.
    """

    planets: str | None
    carrier: str | None
    diameter: float

    @property
    def loose(self) -> bool:
        """Whether they may slide out, since they run in the carrier and in the planets."""
        fits = (self.planets, self.carrier)
        return all(fit is not None and runs(fit, self.diameter) for fit in fits)


@dataclass(frozen=True, slots=True)
class TrainMaking:
    """Materials and fits of a train for its drawings.

    Attributes:
        drive: part on the drive's shaft.
        intermediate: part on each shaft between.
        own: parts on shafts between that have features of their own, by the number of the shaft.
        output: part on the camshaft.
        beside: parts beside the shafts, as planets are.
        pins: fits of the pins of planets, by the number of their stage; of stages with pins alone.
        plate: material of the plates; None where the design does not say.
        holes: fit of their holes; None where the design does not say.
        plate_thickness: thickness of the plates, mm; None where the design does not say.
        bearing_bores: bores for bearings, mm, one for all shafts or one each; None for holes as large as the shafts.
    """

    drive: ShaftMaking
    intermediate: ShaftMaking
    own: Mapping[int, ShaftMaking]
    output: ShaftMaking
    beside: ShaftMaking
    pins: Mapping[int, PinMaking]
    plate: str | None
    holes: str | None
    plate_thickness: float | None
    bearing_bores: tuple[float, ...] | None

    @classmethod
    def of(cls, keys: TrainSection) -> TrainMaking:
        """Making by the keys of a train."""

        def shaft(place: str, given: GearBlankSection, word: str = "") -> ShaftMaking:
            fit = ShaftFit.of(given, given.bore_fit, given.hub.set_screw_thread if given.hub else None)
            material = given.material or keys.material
            screwed = bool(given.hub and given.hub.set_screw_mm)
            bored = given.bore_diameter_mm > 0
            return ShaftMaking(place, word or Message(place), material, fit, bored=bored, screwed=screwed)

        plate = keys.plate or PlateSection()
        return cls(
            shaft("drive", keys.drive),
            shaft("intermediate", keys.intermediate),
            {
                each.shaft: shaft(f"shafts.{place}", each, Message("shaft {number}", number=each.shaft))
                for place, each in enumerate(keys.shafts or (), 1)
            },
            shaft("output", keys.output),
            shaft("beside", GearBlankSection()),
            {
                number: PinMaking(stage.keys.planet.bore_fit, stage.keys.pin_fit, size)
                for number, stage in enumerate(keys.stages, 1)
                if not isinstance(stage, SpurStage)
                and isinstance(stage.keys, PlanetaryKeys)
                and (size := stage.keys.planet.bore_diameter_mm)
            },
            plate.material,
            plate.hole_fit,
            plate.thickness_mm,
            plate.bearing_bores_mm,
        )

    def shaft(self, number: int, shafts: int) -> ShaftMaking:
        """Making of the part on a shaft.

        Args:
            number: number of the shaft, from 1 at the drive; of a part beside the shafts, a greater one.
            shafts: how many there are.
        """
        if number > shafts:
            return self.beside
        if number in (1, shafts):
            return self.drive if number == 1 else self.output
        return self.own.get(number, self.intermediate)

    def open_keys(self, shafts: int) -> dict[str, str]:
        """Facts that the sheets leave open, each with its key.

        Args:
            shafts: how many shafts there are.
        """
        each = [self.shaft(number, shafts) for number in range(1, shafts + 1)]
        keys: dict[str, str] = {}
        if not all(part.material for part in each):
            keys[Message("material of the gears")] = "train.material"
        for part in each:
            if part.bored and not part.fit.bore:
                keys[Message("fit of the bore, {place}", place=part.word)] = f"train.{part.place}.bore_fit"
            if part.screwed and not part.fit.thread:
                name = Message("thread of the set screw, {place}", place=part.word)
                keys[name] = f"train.{part.place}.hub.set_screw_thread"
        for number, pins in self.pins.items():
            if not pins.planets:
                name = Message("fit of the planets on their pins, stage {number}", number=number)
                keys[name] = f"train.stages.{number}.planet.bore_fit"
            if not pins.carrier:
                name = Message("fit of the pins in the carrier, stage {number}", number=number)
                keys[name] = f"train.stages.{number}.pin_fit"
        if not self.plate:
            keys[Message("material of the plates")] = "train.plate.material"
        if not self.holes:
            keys[Message("fit of the plates' holes")] = "train.plate.hole_fit"
        return keys
