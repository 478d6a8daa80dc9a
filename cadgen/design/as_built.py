"""The section of the car as it was built: the effects that measured data were traced to, and what becomes of each."""

import re
from types import ModuleType
from typing import TYPE_CHECKING, Annotated

from pydantic import Field, Strict, field_validator, model_validator

from cadgen.car.against_play.profile_kinds import ACTUAL, codes
from cadgen.design.section import WORD, DesignSection, OneOf, listed
from cadgen.deviations.deviation import Place
from cadgen.errors import DesignError
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.deviations.effect import Effect as Known
    from cadgen.inference.measurement.record import Kind as KindOfData


def _kinds() -> ModuleType:
    # Only here: the kinds need numpy, and most designs have no effects.
    from cadgen.inference.measurement import kinds

    return kinds


Kind = Annotated[str, OneOf(lambda: _kinds().codes(), lambda code: _kinds().has(code))]

_ROUNDING = 1e-9  # of a parameter's range, by which a written value may pass its bound


class SourceSection(DesignSection):
    """A file of measured data. One table [[as_built.sources]] for each."""

    file: str = Field(description="its name, without the folder")
    kind: Kind = Field(description="kind of the measured data")
    sha256: str = Field(description="of the file, 64 hexadecimal digits")
    verdict: str = Field(default="", description="class of the verdict on it")

    @field_validator("sha256")
    @classmethod
    def _is_a_hash(cls, sha256: str) -> str:
        if not re.fullmatch("[0-9a-f]{64}", sha256):
            raise ValueError(
                Message(
                    'as_built.sources.sha256 is "{sha256}"; it must be 64 hexadecimal digits in small letters, '
                    "as sha256sum prints them",
                    sha256=sha256[:80],
                )
            )
        return sha256


class EffectValue(DesignSection):
    """A number of an effect."""

    name: str = Field(description="of the number, with its unit at the end")
    value: float = Field(ge=-1e6, le=1e6, description="value in that unit")
    sigma: float | None = Field(default=None, ge=0, le=1e6, description="its standard deviation")


class EffectSection(DesignSection):
    """An effect that data were traced to, one table for each; those on the disc act in turn."""

    effect: str = Field(description="its name in the catalogue of that kind of data, as in [effects.md](effects.md)")
    kind: Kind = Field(description="of the data that it was found in")
    place: Annotated[Place, WORD] = Field(
        description="`car`: it stays with the car, and a cam is made for it; `process`: every disc made this way has "
        "it, and a cam is cut so that the finished disc is right; `part`: the disc that was measured has it, and a "
        "new one does not; `noted`: it is only recorded"
    )
    values: Annotated[tuple[EffectValue, ...], Strict(False)] = Field(
        min_length=1, description="as inline tables with name, value and, if known, sigma"
    )

    @property
    def numbers(self) -> dict[str, float]:
        """Values by their names, in the units of these."""
        return {value.name: value.value for value in self.values}

    @property
    def kind_of_data(self) -> "KindOfData":
        """The kind as an object."""
        from cadgen.inference.measurement.kinds import kind_of

        return kind_of(self.kind)

    def known(self) -> "Known":
        """The effect of the catalogue.

        Raises:
            DesignError: no effect has that name.
        """
        return self.kind_of_data.named(self.effect, self.numbers)

    @model_validator(mode="after")
    def _is_in_the_catalogue(self) -> "EffectSection":
        try:
            known = self.known()
        except DesignError as error:
            raise ValueError(Message("as_built.effects: {error}", error=error.message)) from None
        where = Message("as_built.effects, {effect} of kind {kind}:", effect=self.effect, kind=self.kind)
        places = dict.fromkeys((*known.places, Place.NOTED))
        if self.place not in places:
            raise ValueError(
                Message(
                    '{where} place is "{place}"; it must be {listed}',
                    where=where,
                    place=self.place,
                    listed=listed(list(places), "or"),
                )
            )
        if self.place != Place.NOTED:
            self._has_its_numbers(known, where)
        return self

    def _has_its_numbers(self, known: "Known", where: str) -> None:
        wanted = [p.name for p in known.parameters] + [name for name, _ in known.indices]
        if sorted(value.name for value in self.values) != sorted(wanted):
            have = listed([value.name for value in self.values], "and")
            raise ValueError(
                Message(
                    "{where} values has {have}; it must have {listed}, once each",
                    where=where,
                    have=have,
                    listed=listed(wanted, "and"),
                )
            )
        for p in known.parameters:
            value, slack = self.numbers[p.name], _ROUNDING * (p.upper - p.lower)
            if not p.lower - slack <= value <= p.upper + slack:
                raise ValueError(
                    Message(
                        "{where} {name} is {value:g}; what can be lies between {lower:g} and {upper:g}: measure "
                        "again, or correct the value",
                        where=where,
                        name=p.name,
                        value=value,
                        lower=p.lower,
                        upper=p.upper,
                    )
                )
        for name, _ in known.indices:
            if not (self.numbers[name] >= 1 and self.numbers[name] == int(self.numbers[name])):
                raise ValueError(
                    Message(
                        "{where} {name} is {numbers:g}; it must be a whole number from 1",
                        where=where,
                        name=name,
                        numbers=self.numbers[name],
                    )
                )


class OutlookSection(DesignSection):
    """Expected run of the car on the new cam, from all measurements; written by `cadgen calibrate`."""

    old_mm: float = Field(ge=0, le=1e7, description="median distance from the planned end of the run, on the old cam")
    new_mm: float = Field(ge=0, le=1e7, description="the same on a new cam made for `effects`")
    least_mm: float = Field(ge=0, le=1e7, description="the new one is nearer with a chance of 5 %")
    most_mm: float = Field(ge=0, le=1e7, description="the new one is farther off with a chance of 5 %")
    chance_worse: float = Field(ge=0, le=1, description="that the new one is farther off than the old one")
    explained: bool | None = Field(
        default=None, description="whether the effects explain the measured track; left out if none was measured"
    )
    places: Annotated[tuple[Annotated[Place, WORD], ...], Strict(False)] = Field(
        default=(),
        description="of the `effects`, in their order, with which it is so expected; left out, those they have",
    )


class EarlierCam(DesignSection):
    """Cam with which the car was measured before. One table [[as_built.earlier]] for each, the first cam first."""

    profile: Annotated[str, OneOf(codes)] = Field(description="of the cam that was on the car then")
    cut_for: Annotated[tuple[EffectSection, ...], Strict(False)] = Field(
        default=(), description="effects that it was made for; none for the first cam of a car"
    )


class AsBuiltSection(DesignSection):
    """The car as it was built and measured: written by `cadgen calibrate`, taken into account by every command."""

    profile: Annotated[str, OneOf(codes)] = Field(
        default=ACTUAL.code,
        description="of the cam that was on the car when it was measured, made from this design with `cut_for` in the "
        "place of `effects`",
    )
    other_cam: Annotated[str, OneOf(codes)] | None = Field(
        default=None,
        description="profile of another cam that may have been on the car, by what was measured; no cam is cut without "
        "`--force` then",
    )
    other_cam_earlier: bool | None = Field(
        default=None, description="whether `other_cam` is one that the car had before, as in `earlier`"
    )
    outlook: OutlookSection | None = Field(default=None, description="with the places that `cadgen calibrate` gave")
    outlook_agreed: OutlookSection | None = Field(
        default=None, description="with every effect that a cam can take out once you agree, by `car` as its place"
    )
    sources: Annotated[tuple[SourceSection, ...], Strict(False)] = ()
    effects: Annotated[tuple[EffectSection, ...], Strict(False)] = ()
    cut_for: Annotated[tuple[EffectSection, ...], Strict(False)] = Field(
        default=(), description="effects that the measured cam was made for already; none for the first cam of a car"
    )
    earlier: Annotated[tuple[EarlierCam, ...], Strict(False)] | None = Field(
        default=None,
        description="cams with which the car was measured before; left out where it was measured with the first alone",
    )

    @property
    def expected(self) -> OutlookSection | None:
        """The outlook with the places that the effects have; None if none was reckoned with them."""
        places = tuple(effect.place for effect in self.effects)
        known = filter(None, (self.outlook, self.outlook_agreed))
        return next((outlook for outlook in known if outlook.places in ((), places)), None)

    @property
    def cams(self) -> tuple[EarlierCam, ...]:
        """Cams with which the car was measured, the first one first."""
        return (*(self.earlier or ()), EarlierCam(profile=self.profile, cut_for=self.cut_for))

    @model_validator(mode="after")
    def _each_thing_is_set_once(self) -> "AsBuiltSection":
        earlier = [("earlier.cut_for", cam.cut_for) for cam in self.earlier or ()]
        for name, effects in (("effects", self.effects), ("cut_for", self.cut_for), *earlier):
            seen: dict[tuple[str, str], EffectSection] = {}
            for effect in effects:
                # Gears on several shafts run out, each by itself.
                own = effect.effect if effect.place == Place.CAR and effect.known().indices else ""
                for value in effect.values if effect.place == Place.CAR else ():
                    if (value.name, own) in seen:
                        before = seen[value.name, own]
                        raise ValueError(
                            Message(
                                "as_built.{name} has {name2} of the car twice, from {effect} of kind {kind} and from "
                                '{effect2} of kind {kind2}: set place = "noted" in one of them',
                                name=name,
                                name2=value.name,
                                effect=before.effect,
                                kind=before.kind,
                                effect2=effect.effect,
                                kind2=effect.kind,
                            )
                        )
                    seen[value.name, own] = effect
        return self
