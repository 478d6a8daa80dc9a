"""A car put together: its parts, their masses against the CAD kernel's, and the designs of which none can be made."""

from math import pi

import numpy as np
import pytest

from cadgen.car.assembly.car_parts import BodyShape
from cadgen.check import CheckCode
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.geometry.meshes.car_meshes import shape_mesh
from cadgen.jobs.assembly_checks import assembly_verdict, verdict_on_car
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_assembly import CarAssembly, put_together
from cadgen.jobs.car_frame import frame_in
from cadgen.jobs.car_gaps import part_gaps
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.verdict import PartVerdict, Reservation


def car_of(*overrides: str) -> CarAssembly:
    design = load_design("workshop_car", overrides)
    return put_together(plan_cam(design, "actual"), plan_gears(design))


@pytest.fixture(scope="module")
def car() -> CarAssembly:
    return car_of()


def test_every_part_has_a_code_a_colour_and_a_mass(car: CarAssembly) -> None:
    assert len({part.code for part in car.parts}) == len(car.parts)
    assert len({part.colour for part in car.parts}) == len(car.parts)
    assert all(part.code.isascii() and part.quantity > 0 for part in car.parts)
    assert [part.code for part in car.parts if part.each <= 0] == ["drive"]  # it is not known
    assert car.balance().volume == pytest.approx(sum(part.each * part.quantity for part in car.parts))


def test_check_and_assembly_say_the_same_of_the_whole_car(car: CarAssembly) -> None:
    """`check` lays the train out and measures no teeth, `assembly` plans all of it: one figure, one verdict."""
    own = assembly_verdict(car).checks
    assert [check.code for check in own] == [CheckCode.TIPPING_SPEED, CheckCode.ENERGY_LEFT]
    assert set(own) <= set(car.cam.verdict.checks)
    assert car.cam.passed


def test_a_car_too_heavy_for_its_drive_is_not_ready() -> None:
    heavy = ["frame.material=steel", "mechanics.speed_m_per_s=4", "mechanics.drive_energy_J=3.9"]
    cam = plan_cam(load_design("workshop_car", heavy), "actual", judged=False)
    assert {check.code for check in verdict_on_car(cam).failed} == {CheckCode.TIPPING_SPEED, CheckCode.ENERGY_LEFT}


def test_what_is_left_must_carry_a_motor_or_weight_that_is_not_counted(car: CarAssembly) -> None:
    """Put in as [drive], or stated as a mass, it leaves nothing open; a mass of nothing known is said to be none."""
    few = "mechanics.drive_energy_J=4.1"

    def judged(*changes: str) -> PartVerdict:
        return verdict_on_car(plan_cam(load_design("workshop_car", changes), "actual", judged=False))

    def held(*changes: str) -> dict[str, Reservation]:
        return {each.code: each for each in judged(*changes).reservations}

    assert not held()
    missing = held(few)["drive-not-counted"]
    more = float(missing.text.rpartition(" carries ")[2].split()[0])
    assert not held(few, "mechanics.car_mass_kg=1.3")
    assert set(held("layout=", "frame=")) == {"energy-not-judged"}
    mass = car.balance().volume * 1e-3 + more
    for off, passes in ((-0.002, True), (0.002, False)):
        checks = judged(few, f"mechanics.car_mass_kg={mass + off}").checks
        (check,) = (each for each in checks if each.code == CheckCode.ENERGY_LEFT)
        assert check.passed is passes


def test_parts_that_cannot_be_put_together_are_a_reservation() -> None:
    """Without [frame], whose check would say it, the reservation is all that is known of a fork without room."""
    low = ["frame=", "layout.camshaft_height_mm=36"]
    cam = plan_cam(load_design("workshop_car", low), "actual", judged=False)
    held = {each.code: each for each in verdict_on_car(cam).reservations}
    assert "layout.camshaft_height_mm" in held["car-not-put-together"].cure


def test_gaps_under_the_pointer_know_the_sheets_of_the_frame(car: CarAssembly) -> None:
    """Gaps to the frame's sheets, against sizes of the layout and the frame's own check."""
    found, made = part_gaps(car), frame_in(car.layout)
    nearest = {code: {each.other: each.size for each in gaps} for code, gaps in found.items()}
    site, top = car.layout.site, made.frame.top
    # The bracket stands two clearances beside the idle wheel, and the rod lies over the platform on its spacers.
    assert nearest["idle-wheel"]["bracket-idle"] == pytest.approx(2 * site.clearance)
    assert nearest["rod"]["platform"] == pytest.approx(top - made.frame.spacer - 6.0 - site.rod_radius)
    sheets = {panel.code.replace("_", "-") for panel in made.frame.panels}
    least = min(size for code in sheets for size in nearest[code].values())
    assert least == pytest.approx(made.gaps[0].size)
    assert "shaft-2" not in nearest["plate-near"]


def test_volumes_are_those_of_the_cad_kernel(car: CarAssembly) -> None:
    from cadgen.geometry.solids.car_solids import car_solids
    from cadgen.geometry.solids.kernel import volume

    for code, part in car_solids(car.parts, "").items():
        # 7e-4 for the rod's socket in the spindle, which is taken as a cylinder between axis and outside.
        assert car.part(code).content.volume == pytest.approx(
            volume(part.solid), rel=1e-3 if "spindle" in code else 3e-5
        )


def test_meshes_have_the_volumes_of_their_parts(car: CarAssembly) -> None:
    for part in car.parts:
        if part.shape is not None and "gear" not in part.code:
            solid = shape_mesh(part.shape, 0.002).solid()
            assert solid.volume() == pytest.approx(part.content.volume, rel=2e-3), part.code


def test_wheels_stand_on_the_floor_and_the_rod_points_to_the_disc(car: CarAssembly) -> None:
    height = car.layout.arrangement.height if car.layout.arrangement else 0.0
    for code, slab in (("drive-wheel", 0), ("front-wheel", 1)):
        (place,), shape = car.part(code).placed(), car.part(code).shape
        assert isinstance(shape, BodyShape)
        radius = shape.body.slabs[slab].rings[0].radii[1]
        assert place[1, 3] + radius == pytest.approx(height)
    angle = 1.9
    fork = car.fork_angle(angle)
    (rod,) = car.part("rod").placed(angle, fork)
    beta = np.arctan(car.use.steering.q(np.array([angle])))[0]
    assert rod[:, 2] == pytest.approx([np.sin(beta), 0.0, np.cos(beta)], abs=1e-6)


def test_the_drive_turns_by_the_ratio_against_the_cam(car: CarAssembly) -> None:
    assert car.part("drive-wheel").group.rate == pytest.approx(45.0)
    assert car.part("cam-disc").group.rate == pytest.approx(-1.0)
    travel = 2 * pi * car.layout.site.wheel_radius * 45.0
    assert travel == pytest.approx(car.use.travel)


def test_a_design_without_a_layout_is_refused_with_its_cure() -> None:
    with pytest.raises(DesignError, match=r"add a section \[layout\]"):
        car_of("layout=")
