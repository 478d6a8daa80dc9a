"""A cam by its motion in the editor: handles of the timing diagram, laws, live checks, the file with its comments."""

import json
import threading

import numpy as np
import pytest

from cadgen.design.load import complete_of, packaged_designs
from cadgen.errors import DesignError
from cadgen.progress import silent
from cadgen.viewer.editor.compute import compute
from cadgen.viewer.editor.guard import Address
from cadgen.viewer.editor.job import AnswerState, Job, JobStage
from cadgen.viewer.editor.server import Service, application, bound_socket
from cadgen.viewer.editor.session import Session
from cadgen.viewer.editor.text_changes import read_changes
from cadgen.viewer.editor.timing import timing_of
from tests.docs.blocks import DOCS
from tests.viewer.editor.conftest import Here
from tests.viewer.page.chromium import ARGUMENTS, READY, chromium_path, serious_faults

TEXT = """\
# A feeder.   Its comments stay.
name = "feeder"

[motion]
turns = "clockwise"   # as seen
speed_rpm = 100
segments = [
    { rise_mm = 8.0, in_deg = 80.0, law = "cycloidal" },  # out
    { dwell_deg = 40.0 },
    { rise_mm = 4.0, in_deg = 60.0, law = "modified_sine" },
    { to_mm = 0.0, in_deg = 120.0, law = "polynomial_3_4_5" },
    { dwell_deg = 60.0 },  # the rest
]

[follower]
kind = "roller"
radius_mm = 9.0

[cam]
base_circle_radius_mm = 40.0
thickness_mm = 8.0

[dynamics]
mass_kg = 0.5
spring_rate_N_per_mm = 5.0
preload_N = 40.0
"""
MOVED = [name for name, file in packaged_designs().items() if "[motion]" in file.read_text(encoding="utf-8")]


@pytest.fixture
def file(tmp_path):
    place = tmp_path / "feeder.toml"
    place.write_text(TEXT, encoding="utf-8")
    return place


@pytest.fixture
def session(file):
    return Session(file)


def answer(session, stage):
    result = compute(Job(session.revision, stage, session.now.text, str(session._file)), silent)
    return result.state, json.loads(result.body)


def moved(segment, angle=0.0, height=0.0):
    """Changes of the page for a handle that is moved."""
    changes = {each.key: each.value + each.sign * angle for each in segment.along} if angle else {}
    return changes | ({each.key: each.value + each.sign * height for each in segment.up} if height else {})


def test_each_handle_moves_its_end_and_nothing_behind_the_next_segment(session):
    """However a handle is moved, the motion fills the turn and closes, and all other ends stay where they were."""
    before = timing_of(session.now.design).segments
    assert [(each.start, each.stop, each.after) for each in before] == [
        (0.0, 80.0, 8.0),
        (80.0, 120.0, 8.0),
        (120.0, 180.0, 12.0),
        (180.0, 300.0, 0.0),
        (300.0, 360.0, 0.0),
    ]
    assert [bool(each.up) for each in before] == [True, True, True, False, False]
    for number, segment in enumerate(before[:-1]):
        height = 1.5 if segment.up else 0.0
        session.change(moved(segment, -7.5, height))
        after = timing_of(session.now.design).segments
        assert after[number].stop == segment.stop - 7.5
        assert [each.stop for k, each in enumerate(after) if k != number] == [
            each.stop for k, each in enumerate(before) if k != number
        ]
        level = {0, 1} if number in (0, 1) else {number}
        for k, each in enumerate(after):
            assert each.after == pytest.approx(before[k].after + (height if k in level else 0.0))
        session.undo()
    assert session.now.text == TEXT


@pytest.mark.parametrize("name", MOVED)
def test_packaged_cams_have_their_controls_and_handles(name):
    session = Session(name)
    state = session.state()
    controls = [control for group in state["groups"] for control in group["controls"]]
    assert {"cam.base_circle_radius_mm", "cam.thickness_mm", "motion.speed_rpm"} <= {each["key"] for each in controls}
    for control in controls:
        assert control["low"] <= control["value"] <= control["high"], control
        assert "rod" not in control["label"][0]
    assert (state["points"], state["kinds"]) == ([], [])
    segments = timing_of(session.now.design).segments
    assert bool(segments) == (name != "eccentric")
    for segment in segments[:-1]:
        session.change(moved(segment, 0.25, 0.01 if segment.up else 0.0))
        session.undo()


def test_a_change_is_written_where_it_stands_and_comments_stay(session, file):
    session.change({"motion.segments.1.law": "modified_trapezoid"})
    session.change({"motion.segments.1.in_deg": 85.5, "motion.segments.2.dwell_deg": 34.5}, "drag")
    session.change({"motion.segments.1.in_deg": 90.5, "motion.segments.2.dwell_deg": 29.5}, "drag")
    assert session.state()["undo"] == 2
    session.save()
    wanted = TEXT.replace('in_deg = 80.0, law = "cycloidal"', 'in_deg = 90.5, law = "modified_trapezoid"')
    assert file.read_text(encoding="utf-8") == wanted.replace("dwell_deg = 40.0", "dwell_deg = 29.5")


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"motion.segments.1.law": "constant_velocity"}, "the velocity jumps at 0 degrees"),
        ({"motion.segments.1.in_deg": 70.0}, "take 350 degrees; they must take 360"),
        ({"motion.segments.1.law": "sine"}, 'motion.segments.1.law is "sine"; it must be'),
        ({"motion.turns": "counterclockwise"}, "motion.turns cannot be changed here"),
    ],
)
def test_a_change_that_cannot_be_is_refused_and_nothing_changes(session, changes, words):
    with pytest.raises(DesignError, match=words):
        session.change(changes)
    assert session.now.text == TEXT
    assert session.revision == 1


@pytest.mark.parametrize("value", ['x"y', "x\ny", "", "X", "a" * 65, ["a", "b"], None, True])
def test_words_of_a_request_need_no_marks(value):
    with pytest.raises(DesignError, match="must be a number, a pair"):
        read_changes({"motion.segments.1.law": value})
    assert read_changes({"motion.segments.1.law": "polynomial_3_4_5"}) == {"motion.segments.1.law": "polynomial_3_4_5"}


def angles(session):
    return [each.in_deg or each.dwell_deg for each in session.now.design.motion.segments]


def heights(session):
    return [round(each.after, 9) for each in timing_of(session.now.design).segments]


@pytest.mark.parametrize("place", range(2, 7))
def test_a_dwell_is_put_in_and_taken_out_again(session, place):
    before = session.now.text
    height = heights(session)[place - 2]
    session.insert(f"motion.segments.{place}", (10.0, height))
    assert sum(angles(session)) == pytest.approx(360.0)
    assert session.now.design.motion.segments[place - 1].dwell_deg == 10.0
    assert "# Its comments stay" not in before or "# out" in session.now.text
    session.remove(f"motion.segments.{place}")
    assert session.now.design == complete_of(before, session._file)
    session.undo()
    session.undo()
    assert session.now.text == before


def test_a_rise_is_put_in_and_later_heights_stay(session):
    session.insert("motion.segments.3", (15.0, 9.5))  # out of the dwell at 8 mm
    (_, dwell, new, third, *_) = session.now.design.motion.segments
    assert (dwell.dwell_deg, new.to_mm, new.in_deg, new.law) == (25.0, 9.5, 15.0, "polynomial_3_4_5")
    assert third.rise_mm == pytest.approx(2.5)  # to 12 mm as before
    assert heights(session) == [8.0, 8.0, 9.5, 12.0, 0.0, 0.0]
    assert all(words in session.now.text for words in ("# out", "# the rest", "# as seen"))
    session.remove("motion.segments.3")
    assert heights(session) == [8.0, 8.0, 12.0, 0.0, 0.0]
    assert angles(session) == [80.0, 40.0, 60.0, 120.0, 60.0]


@pytest.mark.parametrize(
    ("place", "left"),
    [(1, [8.0, 12.0, 0.0, 0.0]), (2, [8.0, 12.0, 0.0, 0.0]), (3, [8.0, 8.0, 0.0, 0.0]), (5, [8.0, 8.0, 12.0, 0.0])],
)
def test_a_segment_that_is_taken_out_leaves_a_motion_that_closes(session, place, left):
    if place == 1:  # its rise goes into the next one
        left = [0.0, 12.0, 0.0, 0.0]
    session.remove(f"motion.segments.{place}")
    assert sum(angles(session)) == pytest.approx(360.0)
    assert heights(session) == left


def test_segments_change_places_with_their_comments(session):
    session.exchange("motion.segments.1")
    assert angles(session) == [40.0, 80.0, 60.0, 120.0, 60.0]
    assert heights(session) == [0.0, 8.0, 12.0, 0.0, 0.0]
    (line,) = [line for line in session.now.text.splitlines() if "# out" in line]
    assert "rise_mm = 8.0" in line


@pytest.mark.parametrize("key", ["motion.segments.9", "motion.segments.0", "motion.points.1", "course.gates.1"])
def test_what_is_no_segment_is_refused(session, key):
    before = session.now.text
    for act in (lambda: session.remove(key), lambda: session.exchange(key), lambda: session.insert(key, (5.0, 1.0))):
        with pytest.raises(DesignError, match="is no segment of the motion"):
            act()
    with pytest.raises(DesignError):
        session.insert("motion.segments.2", (80.0, 8.0))  # nothing is left of the one before
    assert session.now.text == before


def test_tables_of_segments_are_changed_as_well(tmp_path):
    """Segments under headings of their own."""
    rows = TEXT[TEXT.index("segments = [") : TEXT.index("]\n\n[follower]") + 2]
    tables = """
[[motion.segments]]  # out
rise_mm = 8.0
in_deg = 80.0
law = "cycloidal"

[[motion.segments]]
to_mm = 0.0
in_deg = 280.0
law = "cycloidal"
"""
    file = tmp_path / "tables.toml"
    file.write_text(TEXT.replace(rows, "").replace("[follower]", tables + "\n[follower]", 1), encoding="utf-8")
    session = Session(file)
    session.insert("motion.segments.2", (20.0, 8.0))
    session.exchange("motion.segments.2")
    assert angles(session) == [60.0, 280.0, 20.0]
    session.remove("motion.segments.3")
    assert (angles(session), heights(session)) == ([60.0, 300.0], [8.0, 0.0])


def test_preview_and_whole_have_model_curves_and_checks(session):
    state, first = answer(session, JobStage.PREVIEW)
    assert state == AnswerState.DONE
    assert set(first["pieces"]) == {"cam-box", "cam-legend", "charts", "course-box", "legend"}
    state, whole = answer(session, JobStage.WHOLE)
    assert state == AnswerState.DONE
    assert "pressure angle, rise" in whole["pieces"]["tables"]
    session.change({"dynamics.preload_N": 1.0, "motion.speed_rpm": 900.0})
    _, weak = answer(session, JobStage.WHOLE)
    assert "the follower leaves the disc from" in weak["pieces"]["top"]
    assert weak["document"]["passed"] is False
    assert [each["code"] for each in whole["document"]["charts"]][:6] == [
        "lift",
        "velocity",
        "acceleration",
        "jerk",
        "force",
        "torque",
    ]


def test_a_motion_by_a_table_is_edited_beside_its_table(tmp_path):
    (tmp_path / "lobe.csv").write_text((DOCS / "tutorial/lobe.csv").read_text(encoding="utf-8"), encoding="utf-8")
    start, stop = TEXT.index("segments = ["), TEXT.index("\n]\n") + 3
    text = TEXT[:start] + 'table = "lobe.csv"\nsmooth = true\n' + TEXT[stop:]
    (tmp_path / "lobe.toml").write_text(text, encoding="utf-8")
    session = Session(tmp_path / "lobe.toml")
    session.change({"cam.base_circle_radius_mm": 44.0})
    assert timing_of(session.now.design).segments == ()
    state, whole = answer(session, JobStage.WHOLE)
    assert state == AnswerState.DONE
    assert whole["document"]["passed"]
    assert "rows" not in session.now.text


@pytest.mark.long
@pytest.mark.slow
def test_ends_are_dragged_and_a_law_is_chosen_in_the_browser(session, file):
    """By pointer, keys, list and field; the cam follows, a refusal is said, and saving writes the file."""
    pytest.importorskip("uvicorn")
    import uvicorn

    path = chromium_path()
    from playwright.sync_api import expect, sync_playwright

    listening = bound_socket(0)
    own = Address(listening.getsockname()[1], "abc-token")
    service = Service(session, {stage: Here() for stage in JobStage})
    server = uvicorn.Server(uvicorn.Config(application(service, own), log_level="critical", lifespan="off"))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
    thread.start()
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=path, args=ARGUMENTS)
            page, said = browser.new_page(viewport={"width": 1280, "height": 900}, locale="en-GB"), []
            page.set_default_timeout(60_000)
            page.on("pageerror", lambda error: said.append(str(error)))
            page.goto(own.url)
            page.wait_for_selector(READY, state="attached")

            def current():
                page.wait_for_selector(f'html[data-whole="{session.revision}"]:not([data-stale])', state="attached")

            current()
            assert page.locator(".handle.timing").count() == 4
            assert page.locator("#course-figure").count() == 0
            disc = page.locator("#cam-box .disc").get_attribute("d")
            box = page.locator('.handle[data-number="1"]').bounding_box()
            plot = page.locator("#timing-plot").bounding_box()
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.mouse.move(x, y)
            page.mouse.down()
            page.mouse.move(x + plot["width"] / 72, y - 2)
            page.mouse.move(x + plot["width"] / 36, y - 20)  # 10 degrees
            page.mouse.up()
            expect(page.locator('[data-width="1"]')).to_have_value("90")
            current()
            (first, second, third, *_) = session.now.design.motion.segments
            assert (first.in_deg, second.dwell_deg) == (90.0, 30.0)
            assert first.rise_mm > 8.0
            assert first.rise_mm + third.rise_mm == pytest.approx(12.0)
            assert page.locator("#cam-box .disc").get_attribute("d") != disc

            page.locator('.handle[data-number="3"]').focus()
            page.keyboard.press("ArrowRight")
            page.keyboard.press("ArrowRight")
            page.keyboard.press("Shift+ArrowDown")
            expect(page.locator('[data-width="3"]')).to_have_value("62")
            page.wait_for_function("() => document.documentElement.dataset.state === 'whole'")
            assert timing_of(session.now.design).segments[2].after == pytest.approx(11.9)

            page.select_option('[data-law="1"]', "constant_velocity")
            expect(page.locator("#timing-figure .fault")).to_contain_text("the velocity jumps at 0 degrees")
            expect(page.locator('[data-law="1"]')).to_have_value("cycloidal")
            page.select_option('[data-law="1"]', "modified_sine")
            expect(page.locator("#timing-figure .fault")).to_be_empty()
            page.locator('[data-width="5"]').fill("50")
            page.keyboard.press("Tab")
            expect(page.locator('[data-width="4"]')).to_have_value("128")
            current()
            # The curve ends where the file says.
            shown = page.evaluate("() => document.querySelector('#timing-plot .lift').getAttribute('points')")
            curve = np.array([[float(value) for value in pair.split(",")] for pair in shown.split()])
            assert curve[-1, 0] == 360.0
            page.locator('[data-dwell="2"]').click()
            expect(page.locator("#timing-rows .row")).to_have_count(6)
            assert session.now.design.motion.segments[2].dwell_deg == pytest.approx(15.0, abs=0.1)
            page.locator('[data-remove="3"]').click()
            expect(page.locator("#timing-rows .row")).to_have_count(5)
            page.locator('[data-later="4"]').click()
            expect(page.locator('[data-law="4"]')).to_have_count(0)
            page.locator('[data-later="4"]').click()
            expect(page.locator('[data-law="4"]')).to_have_count(1)
            assert page.locator('[data-rise="5"]').is_disabled()
            current()
            assert serious_faults(page, "#timing-figure") == []
            page.keyboard.press("Control+s")
            page.wait_for_selector("#save[disabled]", state="attached")
            written = file.read_text(encoding="utf-8")
            assert written == session.now.text
            assert all(comment in written for comment in ("# A feeder.   Its", "# as seen", "# out", "# the rest"))
            assert complete_of(written, file).motion.segments[4].dwell_deg == 50.0
            page.set_viewport_size({"width": 390, "height": 844})
            assert page.evaluate("() => document.documentElement.scrollWidth") <= 390
            assert said == []
            browser.close()
    finally:
        server.should_exit = True
        thread.join()
