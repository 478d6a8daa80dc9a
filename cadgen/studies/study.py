"""A study as its file gives it: base design, what varies, what is aimed at, what must hold."""

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from json import dumps
from math import isfinite
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, Strict, field_validator, model_validator

from cadgen.car.against_play.profile_kinds import codes as profile_codes
from cadgen.car.planner import RESERVE, SEEDS, WITHIN_MM
from cadgen.check import CheckCode
from cadgen.design.section import HERE, DesignSection, OneOf, listed
from cadgen.errors import DesignError, brief
from cadgen.messages import Message
from cadgen.studies import sampling, study_figures
from cadgen.studies.sampling import REPLAN, ROUNDING, Variation
from cadgen.studies.study_figures import StudyFigure

MOST_DESIGNS = 1_000_000
_MOST_VALUES = 1000  # of a key, each of which is tried in the base design before anything is computed
ALL = "all"
Codes = Annotated[tuple[str, ...], Strict(False)]
ANY = "any"
FigureCode = Annotated[str, OneOf(study_figures.codes, study_figures.has)]


def at_place(error: ValueError, name: str) -> Message:
    """Sentence of an error whose key was not known where it was raised.

    Args:
        error: error whose message may have `HERE` in the place of the key.
        name: name of the key.
    """
    said = Message(*error.args)
    known = said.arguments.get("here") != HERE
    return said if known else Message(said.template, **{**said.arguments, "here": name})


def plan_kinds() -> tuple[str, ...]:
    """Codes of the plans by which designs are chosen."""
    return (*sampling.codes(), sampling.SEARCH)


class PlanKeys(DesignSection):
    """How designs are chosen."""

    kind: Annotated[str, OneOf(plan_kinds)] = Field(description="full_factorial, latin_hypercube, sobol or nsga2")
    designs: int | None = Field(default=None, ge=1, le=MOST_DESIGNS, description="their number; not for a factorial")
    population: int = Field(default=40, ge=4, le=10_000, description="designs of each generation of nsga2")

    @model_validator(mode="after")
    def _counted(self) -> "PlanKeys":
        factorial = self.kind == sampling.FACTORIAL
        if factorial and self.designs is not None:
            raise ValueError(
                Message("plan.designs is given, but a full factorial has as many as its values make: remove it")
            )
        if not factorial and self.designs is None:
            raise ValueError(
                Message("plan.designs is missing: say how many designs {kind} is to choose", kind=self.kind)
            )
        if self.kind == sampling.SEARCH and (self.designs or 0) < self.population:
            raise ValueError(
                Message(
                    "plan.designs is {designs}, fewer than the {population} of one generation: raise it, or lower "
                    "plan.population",
                    designs=self.designs,
                    population=self.population,
                )
            )
        return self


class Vary(DesignSection):
    """Key that varies: by values, or from a least to a most."""

    key: str = Field(min_length=1, description="key of the design, or replan.within_mm, replan.reserve or replan.seeds")
    values: Annotated[tuple[Any, ...], Strict(False)] | None = Field(default=None, description="values to choose from")
    least: float | None = Field(default=None, description="least value")
    most: float | None = Field(default=None, description="greatest value")
    step: float | None = Field(default=None, gt=0, description="between values of a range")
    along: dict[str, tuple[Any, ...]] = Field(
        default={}, description="keys that change together with this one, each with a list as long as values"
    )

    @field_validator("along", mode="before")
    @classmethod
    def _lists(cls, along: Any) -> Any:
        if isinstance(along, dict) and all(isinstance(values, list) for values in along.values()):
            return {key: tuple(values) for key, values in along.items()}
        raise ValueError(Message("{here} must have a list for each key", here=HERE))

    @model_validator(mode="after")
    def _values_or_range(self) -> "Vary":
        ranged = self.least is not None and self.most is not None
        if (self.values is not None) == ranged or (self.least is None) != (self.most is None):
            raise ValueError(
                Message("{key} must vary either by values or from least to most: give one of the two", key=self.key)
            )
        if self.values is not None and not self.values:
            raise ValueError(Message("{key} has no values to choose from: add some", key=self.key))
        _refuse_values(self.key, self.values or ())
        for place, value in enumerate(self.values or ()):
            if value in self.values[:place]:  # type: ignore[index]
                raise ValueError(
                    Message("{key} has the value {value} twice: remove one", key=self.key, value=brief(repr(value), 60))
                )
        for key, values in self.along.items():
            _refuse_values(key, values)
            if len(values) != len(self.values or ()):
                raise ValueError(
                    Message(
                        "{key} changes along with {other} and has {values} values, but {other} has {count}: give it as "
                        "many, in the same order",
                        key=key,
                        other=self.key,
                        values=len(values),
                        count=len(self.values or ()),
                    )
                )
        if self.values is not None and self.step is not None:
            raise ValueError(Message("{key} has values and a step, which is for a range: remove one", key=self.key))
        if ranged and not (self.least or 0.0) < (self.most or 0.0):
            raise ValueError(
                Message(
                    "the range of {key} from {least:g} to {most:g} is empty: least must be below most",
                    key=self.key,
                    least=self.least,
                    most=self.most,
                )
            )
        if ranged and self.step is not None:
            self._refuse_step((self.most or 0.0) - (self.least or 0.0), self.step)
        return self

    def _refuse_step(self, width: float, step: float) -> None:
        if step > width * (1 + ROUNDING):
            raise ValueError(
                Message("the step of {key} is {step:g}, more than its range is wide: lower it", key=self.key, step=step)
            )
        if width / step > MOST_DESIGNS:
            raise ValueError(
                Message(
                    "the step of {key} is {step:g}, which makes more than {most} values: raise it",
                    key=self.key,
                    step=step,
                    most=MOST_DESIGNS,
                )
            )


def _refuse_values(key: str, values: tuple[Any, ...]) -> None:
    """Refuse more values than can be tried, and those that no key of a design has."""
    if len(values) > _MOST_VALUES:
        raise ValueError(
            Message(
                "{key} has {values} values; it can have at most {most}: give a range instead",
                key=key,
                values=len(values),
                most=_MOST_VALUES,
            )
        )
    for value in values:
        if not _is_plain(value):
            raise ValueError(
                Message(
                    "{key} has the value {value}; it must be a finite number, a text, true or false, or a list of "
                    "these",
                    key=key,
                    value=brief(repr(value), 60),
                )
            )


def _is_plain(value: object) -> bool:
    if isinstance(value, list):
        return all(map(_is_plain, value))
    return isinstance(value, bool | int | str) or (isinstance(value, float) and isfinite(value))


class LimitKeys(DesignSection):
    """A limit on a figure; one on a cheap figure screens."""

    figure: FigureCode = Field(description="code of a figure")
    least: float | None = Field(default=None, description="least that it may be")
    most: float | None = Field(default=None, description="most that it may be")

    @model_validator(mode="after")
    def _limits_something(self) -> "LimitKeys":
        if self.least is None and self.most is None:
            raise ValueError(Message("the limit on {figure} has neither least nor most: give one", figure=self.figure))
        if self.least is not None and self.most is not None and self.least > self.most:
            raise ValueError(
                Message(
                    "the limit on {figure} from {least:g} to {most:g} is empty: exchange them",
                    figure=self.figure,
                    least=self.least,
                    most=self.most,
                )
            )
        return self

    def excess(self, value: float) -> float:
        """How far a value is beyond the limit, as a share of it; 0 within it.

        Args:
            value: value of the figure, a number in its own unit.
        """
        over = 0.0 if self.most is None else (value - self.most) / max(abs(self.most), 1e-9)
        under = 0.0 if self.least is None else (self.least - value) / max(abs(self.least), 1e-9)
        return max(over, under, 0.0)


def _within(value: object) -> float | str:
    """A distance, or any."""
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if value == ANY or (number and 0 <= float(value) <= WITHIN_MM[1]):  # type: ignore[arg-type]
        return ANY if value == ANY else float(value)  # type: ignore[arg-type]
    raise ValueError(
        Message(
            '{here} is {value!r:.60}; it must be 0 to {most:g} (mm), or "{any}"',
            here=HERE,
            value=value,
            most=WITHIN_MM[1],
            any=ANY,
        )
    )


def _reserve(value: object) -> object:
    least, most = RESERVE
    if isinstance(value, bool) or not isinstance(value, int | float) or not least <= value <= most:
        raise ValueError(
            Message(
                "{here} is {value}; it must be {least:g} to {most:g}",
                here=HERE,
                value=brief(repr(value), 60),
                least=least,
                most=most,
            )
        )
    return value


def _seeds(value: object) -> object:
    least, most = SEEDS
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number or not least <= value <= most or value != round(value):  # type: ignore[call-overload,operator]
        raise ValueError(
            Message(
                "{here} is {value}; it must be a whole number from {least} to {most}",
                here=HERE,
                value=brief(repr(value), 60),
                least=least,
                most=most,
            )
        )
    return value


# What of [replan] may vary, and what its values must be.
_REPLANNED = {"within_mm": _within, "reserve": _reserve, "seeds": _seeds}
Within = Annotated[Any, BeforeValidator(_within)]


class ReplanKeys(DesignSection):
    """Plan the path of the designs, as `cadgen plan --from` does; each distinct path once."""

    within_mm: Within = Field(
        default=25.0,
        description='how far from the base\'s path, 0 to 1000, where 0 keeps that; or "any" path on the course',
    )
    reserve: float = Field(
        default=0.0,
        ge=RESERVE[0],
        le=RESERVE[1],
        description="room for the scatter of the cars, as of cadgen plan --reserve",
    )
    seeds: int = Field(default=1, ge=SEEDS[0], le=SEEDS[1], description="searches for each path")
    planned_for: Codes = Field(
        default=(), description="varied keys for whose value a path is planned, besides replan, path and course"
    )


class EachKeys(DesignSection):
    """Limits of the computation of one design."""

    seconds: float = Field(default=600.0, gt=0, le=1e6, description="time that one design may take")
    memory_mb: float | None = Field(default=None, ge=50, le=1e7, description="memory that a process may take more")


class StudyFile(DesignSection):
    """Content of a study's file."""

    name: str = Field(default="", pattern=r"^([A-Za-z0-9][\w.-]{0,80})?$", description="in the names of the results")
    base: str = Field(default="carbon_free_car", min_length=1, description="a packaged design, or a TOML file")
    overrides: Codes = Field(default=(), alias="set", description="changes of the base, as of --set")
    profile: Annotated[str, OneOf(profile_codes)] | None = Field(default=None, description="profile of the cam")
    seed: int = Field(default=1, ge=0, le=2**63 - 1, description="seed of plan and cars")
    cars: int = Field(default=1000, ge=1, le=1_000_000, description="random cars for passed_percent")
    objectives: Annotated[tuple[FigureCode, ...], Strict(False)] = Field(min_length=1, description="figures aimed at")
    record: Annotated[tuple[FigureCode, ...], Strict(False)] = Field(default=(), description="further figures")
    checks: Codes = Field(default=(ALL,), description='codes of the checks that must pass, ["all"], or [] for none')
    best: int = Field(default=5, ge=0, le=1000, description="designs of the front that are written")
    plan: PlanKeys
    vary: Annotated[tuple[Vary, ...], Strict(False)] = Field(min_length=1, description="what varies")
    limits: Annotated[tuple[LimitKeys, ...], Strict(False)] = Field(default=(), description="limits on figures")
    replan: ReplanKeys | None = None
    each: EachKeys = EachKeys()

    @model_validator(mode="after")
    def _names_what_is_there(self) -> "StudyFile":
        keys = [key for each in self.vary for key in (each.key, *each.along)]
        for key in keys:
            if keys.count(key) > 1:
                raise ValueError(Message("{key} varies twice: put all its values into one [[vary]]", key=key))
            if key.startswith(REPLAN) and self.replan is None:
                raise ValueError(Message("{key} varies, but no path is planned: add [replan]", key=key))
            if key.startswith(REPLAN) and key.removeprefix(REPLAN) not in _REPLANNED:
                raise ValueError(
                    Message(
                        "{key} cannot vary: of [replan] only {keys} do",
                        key=key,
                        keys=listed(tuple(_REPLANNED), "and"),
                    )
                )
        for each in self.vary:
            judge = _REPLANNED.get(each.key.removeprefix(REPLAN)) if each.key.startswith(REPLAN) else None
            for value in each.values or (each.least, each.most):
                try:
                    if judge is not None:
                        judge(value)
                except ValueError as error:
                    raise ValueError(at_place(error, each.key)) from None
        for key in self.replan.planned_for if self.replan else ():
            if key not in keys:
                raise ValueError(Message("replan.planned_for names {key}, which does not vary: remove it", key=key))
        for name in ("objectives", "record"):
            figures = getattr(self, name)
            if len(set(figures)) < len(figures):
                raise ValueError(Message("{name} names a figure twice: remove one", name=name))
        known = {code.value for code in CheckCode}
        for code in self.checks:
            if code not in known and code != ALL:
                raise ValueError(
                    Message(
                        'checks names "{code}", which is no check: see the codes of cadgen check --json', code=code[:80]
                    )
                )
        return self


@dataclass(frozen=True)
class Study:
    """A study that has been read and checked.

    Attributes:
        file: content of its file.
        name: its name.
        text: text of the base design.
        source: name of the base design's file.
        variations: what varies.
    """

    file: StudyFile
    name: str
    text: str
    source: str
    variations: tuple[Variation, ...]

    @cached_property
    def figures(self) -> tuple[StudyFigure, ...]:
        """Objectives, then the other figures that are recorded or limited, each once."""
        named = (*self.file.objectives, *self.file.record, *(limit.figure for limit in self.file.limits))
        return tuple(study_figures.kind_of(code) for code in dict.fromkeys(named))

    @property
    def objectives(self) -> tuple[StudyFigure, ...]:
        """Figures that are aimed at."""
        return self.figures[: len(self.file.objectives)]

    @property
    def keys(self) -> tuple[str, ...]:
        """Keys that vary."""
        return tuple(each.key for each in self.variations)

    @cached_property
    def count(self) -> int:
        """Number of designs.

        Raises:
            DesignError: there are too many.
        """
        if self.searches:
            return self.generations * self.file.plan.population
        count = sampling.count(self.file.plan.kind, self.variations, self.file.plan.designs)
        if count > MOST_DESIGNS:
            many = str(count) if count < 10**15 else Message("more than 10^15")
            raise DesignError(
                "the plan has {many} designs; it can have at most {most}: use larger steps",
                many=many,
                most=MOST_DESIGNS,
            )
        return count

    @property
    def searches(self) -> bool:
        """Whether later designs depend on the results of earlier ones."""
        return self.file.plan.kind == sampling.SEARCH

    @property
    def generations(self) -> int:
        """Whole generations of a search, rounded up."""
        return -(-(self.file.plan.designs or 0) // self.file.plan.population)

    @cached_property
    def fingerprint(self) -> str:
        """SHA-256 of everything that the rows depend on, but the version of the program."""
        content = {"study": self.file.model_dump(mode="json", exclude={"best"}), "name": self.name, "base": self.text}
        return sha256(dumps(content, sort_keys=True).encode()).hexdigest()
