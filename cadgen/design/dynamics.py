"""The section [dynamics]: mass, spring, load, damping and guide of a follower that is moved by [motion]."""

from __future__ import annotations

from math import inf, radians
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Le
from pydantic import Field, Strict

from cadgen.cam.followers.closure import Closure
from cadgen.cam.followers.kind import FollowerKind
from cadgen.car.running.friction import DiscMaterial
from cadgen.design.lift_rows import MOST_ROWS
from cadgen.design.section import DesignSection
from cadgen.errors import DesignError
from cadgen.laws.unit import MM
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.cam.follower import Follower
    from cadgen.cam.forces import Dynamics

# Modulus of elasticity, MPa, and Poisson's ratio: tables of makers and handbooks; plastics scatter by a third.
STEEL = (206_000.0, 0.30)
_ELASTIC: dict[DiscMaterial, tuple[float, float]] = {
    DiscMaterial.STEEL: STEEL,
    DiscMaterial.ALUMINIUM: (70_000.0, 0.33),
    DiscMaterial.BRASS: (100_000.0, 0.35),
    DiscMaterial.ACRYLIC: (3_200.0, 0.37),
    DiscMaterial.PLA: (3_500.0, 0.36),
    DiscMaterial.POM: (2_800.0, 0.35),
}
# Keys of a slide, and those in their place of a follower on an arm.
_SLIDE_AND_ARM = (
    ("mass_kg", "inertia_kgmm2"),
    ("spring_rate_N_per_mm", "spring_rate_Nmm_per_rad"),
    ("preload_N", "preload_Nmm"),
    ("load_N", "load_Nmm"),
    ("damping_N_s_per_m", "damping_Nmm_s_per_rad"),
)
_OF_A_SLIDE = ("guide_friction", "guide_length_mm", "overhang_mm")
_OF_AN_ARM = ("arm_mass_kg", "arm_centre_mm")

Force = Annotated[float, Ge(-1e7), Le(1e7)]
LoadRow = Annotated[tuple[Force, Force], Strict(False)]


class DynamicsSection(DesignSection):
    """Mass, spring and load of a follower that is moved by [motion], for forces, torque and lift-off."""

    mass_kg: float | None = Field(default=None, ge=0, le=10_000, description="of all that moves along with the slide")
    inertia_kgmm2: float | None = Field(
        default=None, ge=0, le=1e9, description="of a swinging follower, moment of inertia about the pivot"
    )
    spring_rate_N_per_mm: float | None = Field(default=None, ge=0, le=1e5, description="of the spring that closes it")
    spring_rate_Nmm_per_rad: float | None = Field(default=None, ge=0, le=1e9, description="of a swinging follower")
    preload_N: float | None = Field(
        default=None, ge=-1e7, le=1e7, description="force of the spring at lift 0, onto the disc"
    )
    preload_Nmm: float | None = Field(
        default=None, ge=-1e7, le=1e7, description="of a swinging follower, its moment at swing 0"
    )
    load_N: float | None = Field(
        default=None, ge=-1e7, le=1e7, description="load against the motion, the same at every angle"
    )
    load_Nmm: float | None = Field(default=None, ge=-1e7, le=1e7, description="of a swinging follower")
    load: str | None = Field(
        default=None,
        min_length=1,
        max_length=1000,
        description="CSV of two columns, cam angle in degrees and load in N (N·mm of a swinging follower), by its path "
        "from the folder of the design file",
    )
    load_rows: Annotated[tuple[LoadRow, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=2,
        max_length=MOST_ROWS,
        description="rows of the load, [cam angle, load], instead of a file; what is read from a file is kept here",
    )
    damping_N_s_per_m: float | None = Field(default=None, ge=0, le=1e6, description="damping of the slide")
    damping_Nmm_s_per_rad: float | None = Field(default=None, ge=0, le=1e9, description="of a swinging follower")
    gravity_deg: float | None = Field(
        default=None,
        ge=-180,
        le=180,
        description="angle from the follower's motion outwards to its weight: 180 where the weight presses it on the "
        "disc; of a swinging follower at swing 0, in the sense in which it lifts; left out, no weight",
    )
    arm_mass_kg: float | None = Field(
        default=None, gt=0, le=10_000, description="of a swinging follower, for its weight; with gravity_deg"
    )
    arm_centre_mm: float | None = Field(
        default=None,
        gt=0,
        le=10_000,
        description="of a swinging follower, distance of its centre of mass from the pivot, on the line of the arm",
    )
    guide_friction: float | None = Field(
        default=None, ge=0, le=1.5, description="sliding friction in the slide's guide"
    )
    guide_length_mm: float | None = Field(default=None, gt=0, le=10_000, description="length of that guide")
    overhang_mm: float | None = Field(default=None, ge=0, le=10_000, description="end of the guide to the contact")
    contact_width_mm: float | None = Field(
        default=None, gt=0, le=1000, description="length of the line of contact; left out, the disc's thickness"
    )
    disc_modulus_MPa: float | None = Field(
        default=None, gt=0, le=1e6, description="modulus of elasticity; left out, by blank.material, or of steel"
    )
    disc_poisson_ratio: float | None = Field(default=None, ge=0, lt=0.5, description="left out, by blank.material")
    follower_modulus_MPa: float | None = Field(default=None, gt=0, le=1e6, description="left out, 206000, of steel")
    follower_poisson_ratio: float | None = Field(default=None, ge=0, lt=0.5, description="left out, 0.3, of steel")

    def refuse(self, kind: FollowerKind, keys: object, thickness: float) -> None:
        """Refuse keys that do not suit the follower or the disc, or each other.

        Args:
            kind: kind of the follower.
            keys: keys of the follower.
            thickness: thickness of the disc, mm.

        Raises:
            DesignError: it is so.
        """
        slides = kind.unit == MM
        springs = [key for pair in (_SLIDE_AND_ARM[1], _SLIDE_AND_ARM[2]) for key in pair if getattr(self, key)]
        if springs and closed_by_form(keys):
            raise DesignError(
                "dynamics.{key} is of a spring, and the follower is held by its closure: remove it (on the command "
                "line with --set dynamics.{key}=)",
                key=springs[0],
            )
        for slide, arm in _SLIDE_AND_ARM:
            wrong, right = (arm, slide) if slides else (slide, arm)
            if getattr(self, wrong) is not None:
                raise DesignError(
                    'dynamics.{wrong} is not of a follower of kind "{code}", which {moves}: give {right} instead',
                    wrong=wrong,
                    right=right,
                    code=kind.code,
                    moves=Message("slides") if slides else Message("swings"),
                )
        given = [key for key in _OF_A_SLIDE if getattr(self, key) is not None]
        if given and not slides:
            raise DesignError(
                'dynamics.{key} is of a slide, and a follower of kind "{code}" swings: remove it (on the command line '
                "with --set dynamics.{key}=)",
                key=given[0],
                code=kind.code,
            )
        given = [key for key in _OF_AN_ARM if getattr(self, key) is not None]
        if given and slides:
            raise DesignError(
                'dynamics.{key} is of an arm, and a follower of kind "{code}" slides: remove it (on the command line '
                "with --set dynamics.{key}=)",
                key=given[0],
                code=kind.code,
            )
        missing = [key for key in ("gravity_deg", *_OF_AN_ARM) if getattr(self, key) is None]
        if not slides and 0 < len(missing) <= len(_OF_AN_ARM):
            raise DesignError(
                "the weight of an arm needs dynamics.gravity_deg, arm_mass_kg and arm_centre_mm together, and "
                "{missing} is missing: add it, or remove the others",
                missing=joined((f"dynamics.{key}" for key in missing), Message(" and ")),
            )
        if (self.guide_friction is None) != (self.guide_length_mm is None):
            raise DesignError(
                "dynamics needs guide_friction and guide_length_mm together, and has only {given}: add the other, or "
                "remove it",
                given="guide_length_mm" if self.guide_friction is None else "guide_friction",
            )
        if self.load_rows is None and self.load is not None:
            raise DesignError(
                "dynamics.load names a file whose rows were not read: load the design from its file",
            )
        if self.load_rows is not None:
            self._refuse_load(self.load_rows, "load_N" if slides else "load_Nmm")
        longest = getattr(keys, "depth_mm", None) or thickness
        if self.contact_width_mm is not None and self.contact_width_mm > longest:
            raise DesignError(
                "dynamics.contact_width_mm is {width:g}; no line of contact is longer than the disc is thick, or its "
                "groove deep: set it to {longest:g} or less",
                width=self.contact_width_mm,
                longest=longest,
            )

    def _refuse_load(self, rows: tuple[tuple[float, float], ...], constant: str) -> None:
        if getattr(self, constant) is not None:
            raise DesignError(
                "dynamics has {constant} and a load by angle, two for one value: remove {constant} (on the command "
                "line "
                "with --set dynamics.{constant}=)",
                constant=constant,
            )
        for number in range(1, len(rows)):
            if rows[number][0] <= rows[number - 1][0]:
                raise DesignError(
                    "row {number} of the load is at {angle:g} degrees, after one at {before:g}, but angles must grow: "
                    "sort the rows by their angles, and keep one of each",
                    number=number + 1,
                    angle=rows[number][0],
                    before=rows[number - 1][0],
                )
        if rows[-1][0] - rows[0][0] > 360 * (1 + 1e-9):
            raise DesignError(
                "the rows of the load reach over {reach:g} degrees; they must reach over 360 at most: remove those "
                "beyond it",
                reach=rows[-1][0] - rows[0][0],
            )


def most_of(key: str) -> float:
    """Greatest value that a key of [dynamics] may have, in its unit; infinite if it has no bound.

    Args:
        key: name of the key.
    """
    return next((bound.le for bound in DynamicsSection.model_fields[key].metadata if hasattr(bound, "le")), inf)


def closed_by_form(keys: object) -> bool:
    """Whether a groove or a second disc holds a follower on its cam, and no spring.

    Args:
        keys: keys of the follower.
    """
    return getattr(keys, "closure", None) not in (None, Closure.SPRING)


def dynamics_of(
    section: DynamicsSection,
    kind: FollowerKind,
    followers: tuple[Follower, Follower],
    material: DiscMaterial | None,
    width: float,
) -> Dynamics:
    """Mass, spring, damping and load of a design's follower, in N, mm, s.

    Args:
        section: section [dynamics].
        kind: kind of the follower.
        followers: follower, whose radius presses on the disc, and the one on the other flank or on the second disc.
        material: material of the disc; None where the design does not say.
        width: greatest length of the line of contact, mm.
    """
    import numpy as np

    from cadgen.cam.forces import GRAVITY, Dynamics, Guide, Line, Load, joint_modulus

    slides = kind.unit == MM
    inertia, rate, preload, constant, damping = (
        getattr(section, slide if slides else arm) or 0.0 for slide, arm in _SLIDE_AND_ARM
    )
    load: float | Load = constant
    if section.load_rows is not None:
        angle, value = np.array(section.load_rows, dtype=float).T
        load = Load(cam_angle=np.radians(angle), value=value)
    guide = None
    if section.guide_friction and section.guide_length_mm is not None:
        guide = Guide(
            friction=section.guide_friction, length=section.guide_length_mm, overhang=section.overhang_mm or 0.0
        )
    usual, ratio = STEEL if material is None else _ELASTIC[material]
    disc = section.disc_modulus_MPa or usual, _given(section.disc_poisson_ratio, ratio)
    other = section.follower_modulus_MPa or STEEL[0], _given(section.follower_poisson_ratio, STEEL[1])
    radius, other_radius = (follower.radius for follower in followers)
    line = None
    if radius:
        modulus = joint_modulus(disc, other)
        width = section.contact_width_mm or width
        line = Line(width=width, modulus=modulus, radius=radius, other_radius=other_radius)
    weight = 0.0
    if section.gravity_deg is not None:
        weight = GRAVITY * (inertia if slides else (section.arm_mass_kg or 0.0) * (section.arm_centre_mm or 0.0))
    return Dynamics(
        # kg to N s²/mm, kg mm² to N mm s², N s/m to N s/mm.
        inertia=inertia * 1e-3,
        rate=rate,
        preload=preload,
        damping=damping * (1e-3 if slides else 1.0),
        load=load,
        weight=weight,
        downhill=radians(180.0 if section.gravity_deg is None else section.gravity_deg),
        swings=not slides,
        guide=guide,
        line=line,
    )


def _given(value: float | None, otherwise: float) -> float:
    return otherwise if value is None else value
