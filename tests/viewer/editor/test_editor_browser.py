"""The editor in a browser: points are dragged, the cam follows, and the file is saved. Skipped without a Chromium."""

import threading

import pytest

from tests.viewer.editor.conftest import TEXT
from tests.viewer.page.chromium import ARGUMENTS, READY, chromium_path, serious_faults

CURRENT = "html[data-whole]:not([data-stale])"


@pytest.fixture
def served(service, address):
    """The small design on a port of its own, computed in this process."""
    uvicorn = pytest.importorskip("uvicorn")
    from cadgen.viewer.editor.guard import Address
    from cadgen.viewer.editor.server import application, bound_socket

    listening = bound_socket(0)
    own = Address(listening.getsockname()[1], address.token)
    server = uvicorn.Server(uvicorn.Config(application(service, own), log_level="critical", lifespan="off"))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
    thread.start()
    yield own.url
    server.should_exit = True
    thread.join()


@pytest.fixture
def shown(served):
    path = chromium_path()
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=ARGUMENTS)
        page = browser.new_page(viewport={"width": 1280, "height": 720}, locale="en-GB")
        page.set_default_timeout(120_000)
        page.said = []
        page.on("console", lambda message: page.said.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: page.said.append(str(error)))
        page.goto(served)
        page.wait_for_selector(READY, state="attached")
        page.wait_for_selector(CURRENT, state="attached")
        yield page
        browser.close()


def current(page, session):
    """Wait until the page shows the design as it is now."""
    page.wait_for_selector(f'{CURRENT}[data-whole="{session.revision}"]', state="attached")


def dragged(page, key, right, down):
    """Drag a point by so many pixels."""
    box = page.locator(f'.handle[data-key="{key}"]').bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + right / 2, y + down / 2)
    page.mouse.move(x + right, y + down)
    page.mouse.up()


@pytest.mark.slow
@pytest.mark.long
def test_a_waypoint_is_dragged_and_the_cam_follows(shown, session, file):
    from playwright.sync_api import expect

    disc, key = "document.querySelector('#cam-box .disc').getAttribute('d')", "path.waypoints_mm.3"
    before, camera = shown.evaluate(disc), shown.locator("#scene canvas").count()
    dragged(shown, key, 6, -4)
    shown.wait_for_selector(f'{CURRENT}:not([data-whole="1"])', state="attached")
    current(shown, session)
    assert shown.evaluate(disc) != before
    assert shown.locator("#scene canvas").count() == camera == 1
    x, y = session.now.design.path.keys.waypoints_mm[2]
    assert x > 2600.0
    assert y > 1200.0
    assert [float(field.input_value()) for field in shown.locator("#point-bar input").all()] == [x, y]
    assert shown.title().startswith("• small")

    # A turn that cannot be driven: the sentence stands below the course, and the last good cam stays.
    good = shown.evaluate(disc)
    shown.locator("#point-bar input").first.fill("1510")
    shown.locator("#point-bar input").last.fill("210")
    with shown.expect_response(lambda answer: "[1510,210]" in (answer.request.post_data or "")):
        shown.keyboard.press("Tab")
    shown.wait_for_selector("html[data-state=fault]", state="attached")
    assert shown.locator("#course-figure .fault").inner_text()
    assert shown.evaluate(disc) == good
    while session.state()["undo"] > 1:
        steps = session.state()["undo"]
        with shown.expect_response("**/undo"):
            shown.locator("#undo").click()
        assert session.state()["undo"] == steps - 1
    current(shown, session)
    assert not shown.locator("#course-figure .fault").inner_text()

    # A point is added by a double click halfway, is the chosen one, and is removed by its key.
    first, second = (shown.locator(f'.handle[data-key="path.waypoints_mm.{n}"]').bounding_box() for n in (4, 5))
    with shown.expect_response("**/insert"):
        shown.mouse.dblclick(
            (first["x"] + second["x"] + first["width"]) / 2, (first["y"] + second["y"] + first["height"]) / 2
        )
    shown.wait_for_selector('.handle.chosen[data-key="path.waypoints_mm.5"]')
    points = session.now.design.path.keys.waypoints_mm
    assert len(points) == 6
    assert points[4] == pytest.approx((4750.0, 1250.0), abs=10)
    shown.locator('.handle[data-key="path.waypoints_mm.5"]').focus()
    with shown.expect_response("**/remove"):
        shown.keyboard.press("Delete")
    shown.wait_for_selector('.handle.chosen[data-key="path.waypoints_mm.5"]:focus')
    assert len(session.now.design.path.keys.waypoints_mm) == 5
    current(shown, session)

    # Posts and gates come and go: by button, double click and keys; the order of gates changes.
    def pressed(name, request):
        with shown.expect_response(f"**/{request}"):
            shown.get_by_role("button", name=name, exact=True).click()
        current(shown, session)  # the answer is there before the page has taken it

    steps = session.state()["undo"]
    shown.get_by_role("button", name="Gates", exact=True).click()
    for _ in range(2):
        pressed("Add a gate", "insert")
    first, second = (gate.at_mm for gate in session.now.design.course.gates)
    shown.wait_for_selector('.handle.chosen[data-key="course.gates.2.at_mm"]:focus')
    pressed("Earlier in the order of the gates", "exchange")
    assert [gate.at_mm for gate in session.now.design.course.gates] == [second, first]
    shown.wait_for_selector('.handle.chosen[data-key="course.gates.1.at_mm"][data-number="1"]')
    shown.get_by_role("button", name="Posts, walls, zones, field", exact=True).click()
    pressed("Add a wall", "insert")
    shown.wait_for_selector('.handle.chosen[data-key="course.walls.1.line_mm.1"]:focus')
    # A wall of two points goes as a whole; a post that is added before the answer comes is the chosen one after both.
    box, held = shown.locator("#handles").bounding_box(), []
    shown.route("**/remove", lambda request: held.append(request))
    with shown.expect_request("**/remove"):
        shown.keyboard.press("Delete")
    shown.mouse.dblclick(box["x"] + box["width"] / 4, box["y"] + box["height"] / 4)
    with shown.expect_response("**/insert"):
        held[0].continue_()
    shown.unroute("**/remove")
    shown.wait_for_selector('.handle.chosen[data-key="course.posts.2.at_mm"]:focus')
    assert not session.now.design.course.walls
    assert session.now.design.course.posts[1].radius_mm == 20.0
    current(shown, session)
    assert serious_faults(shown, "header", "#edit", "#course-figure") == []
    shown.set_viewport_size({"width": 360, "height": 740})
    shown.emulate_media(color_scheme="dark")
    assert serious_faults(shown, "header", "#edit", "#course-figure") == []
    assert shown.evaluate("() => document.documentElement.scrollWidth") <= 360
    shown.set_viewport_size({"width": 1280, "height": 720})
    shown.emulate_media(color_scheme="light")
    while session.state()["undo"] > steps:
        with shown.expect_response("**/undo"):
            shown.locator("#undo").click()
    assert session.now.design.course.gates == session.now.design.course.walls == ()
    current(shown, session)

    # What is typed is saved, although the field has not been left, and Ctrl+Z takes it back.
    wheelbase = shown.locator("#control-car-wheelbase_mm")
    wheelbase.fill("168")
    with shown.expect_response("**/save"):
        wheelbase.press("Control+s")
    assert "wheelbase_mm = 168   # L" in file.read_text()
    with shown.expect_response("**/undo"):
        wheelbase.press("Control+z")
    assert session.now.design.car.wheelbase_mm == 167.0
    expect(wheelbase).to_have_value("167")

    # A number that the schema refuses is refused at its field.
    number = shown.locator("#control-cam-thickness_mm")
    number.fill("60")
    number.press("Enter")
    refused = shown.locator('.control[data-key="cam.thickness_mm"] .fault')
    refused.wait_for(state="visible")
    assert "faces" in refused.inner_text()
    assert session.now.design.cam.thickness_mm == 3

    # The sentence stays, whatever was being computed meanwhile, until a change is taken.
    held = []
    shown.route("**/result?stage=whole*", lambda request: held.append(request))
    wheelbase.fill("169")
    with shown.expect_request("**/result?stage=whole*"):  # it follows the preview, and has to be under way
        wheelbase.press("Enter")
    number.fill("61")
    number.press("Enter")
    refused.wait_for(state="visible")
    assert held
    for request in held:
        request.continue_()
    shown.unroute("**/result?stage=whole*")
    current(shown, session)
    assert "faces" in refused.inner_text()
    with shown.expect_response("**/change"):
        number.fill("3.5")
        number.press("Enter")
    refused.wait_for(state="hidden")
    for value in (169.0, 167.0):
        with shown.expect_response("**/undo"):
            shown.locator("#undo").click()
        assert session.now.design.car.wheelbase_mm == value
    current(shown, session)

    shown.keyboard.press("Control+s")
    shown.wait_for_selector("#save:not(.due)")
    assert shown.title().startswith("small")
    assert file.read_text() == TEXT.replace("[2600.0, 1200.0]", f"[{x!r}, {y!r}]")
    # Refusals and superseded results are statuses, which the browser reports; nothing else is.
    assert all("422" in text or "409" in text for text in shown.said), shown.said


@pytest.mark.slow
@pytest.mark.long
def test_a_second_tab_says_when_its_numbers_are_old(shown, session, file):
    """It follows the first one, keeps what is typed in it, and says what another program has done to the file."""
    from playwright.sync_api import expect

    second = shown.context.browser.new_page(viewport={"width": 1280, "height": 720}, locale="en-GB")
    second.set_default_timeout(120_000)
    second.goto(shown.url)
    second.wait_for_selector(READY, state="attached")
    current(second, session)
    number = second.locator("#control-cam-thickness_mm")
    number.fill("4")  # not sent yet
    held = []
    second.route("**/result?*", lambda request: held.append(request))
    shown.locator("#control-car-wheelbase_mm").fill("171")
    with shown.expect_response("**/change"):
        shown.keyboard.press("Enter")
    second.wait_for_selector("html[data-state=elsewhere][data-stale]", state="attached")
    assert second.inner_text("#status").startswith("changed in another tab: these numbers are old")
    expect(second.locator("#control-car-wheelbase_mm")).to_have_value("171")
    expect(number).to_have_value("4")
    for request in held:
        request.continue_()
    second.unroute("**/result?*")
    current(second, session)
    assert second.locator("html").get_attribute("data-state") == "whole"
    # Saved in the one, saved in the other.
    second.wait_for_selector("#save.due")
    shown.keyboard.press("Control+s")
    second.wait_for_selector("#save:not(.due)")
    assert not second.inner_text("#changed-outside")
    file.write_text(TEXT.replace("# C", "# by another program"))
    for page in (shown, second):
        page.wait_for_selector("#changed-outside:not(:empty)")
        assert page.inner_text("#changed-outside").startswith("small.toml was changed by another program")
    second.click("#language")
    assert "small.toml" in second.inner_text("#changed-outside")
    assert "其他程序" in second.inner_text("#changed-outside")
    second.close()


@pytest.mark.slow
@pytest.mark.long
def test_it_is_saved_under_a_name_with_its_ending(shown, session, file):
    shown.click("#save-as")
    shown.fill("#save-name", "mine.toml")
    assert shown.inner_text("#naming .hint").endswith("/mine.toml")
    shown.keyboard.press("Enter")
    shown.wait_for_selector("#naming:not([open])", state="attached")
    assert shown.inner_text("h1 span") == "mine"
    assert {entry.name for entry in file.parent.iterdir()} == {"small.toml", "mine.toml"}


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("size", [(1280, 720), (820, 1000), (390, 844)])
def test_failures_leave_the_course_under_the_pointer(shown, session, size):
    """They come and go, from a page elsewhere, while a point is held; nothing moves but the point."""
    places = (
        "() => ['course-box', 'course-view', 'edit'].map((id) => document.getElementById(id).getBoundingClientRect())"
    )
    shown.set_viewport_size({"width": size[0], "height": size[1]})
    key = "path.waypoints_mm.3"
    box = shown.locator(f'.handle[data-key="{key}"]').bounding_box()
    x, y = round(box["x"] + box["width"] / 2), round(box["y"] + box["height"] / 2)
    shown.mouse.move(x, y)
    shown.mouse.down()
    with shown.expect_response("**/change"):
        shown.mouse.move(x + 4, y - 2)
    before, seen = shown.evaluate(places), set()
    for limit, there in ((100.0, 1), (1.0, 0), (100.0, 1)):
        session.change({"checks.min_convex_radius_mm": limit})
        current(shown, session)
        assert shown.locator("#failures").count() == there
        assert shown.evaluate(places) == before
        seen.add(shown.evaluate("([x, y]) => document.elementFromPoint(x, y).dataset.key", [x + 4, y - 2]))
    assert seen == {key}
    shown.mouse.up()
    assert shown.locator("#failures").is_visible()
    assert shown.evaluate(places)[0] == before[0]


@pytest.mark.slow
@pytest.mark.long
def test_points_are_dragged_on_a_course_that_is_brought_nearer(shown, session):
    """The point goes with the pointer, the part of the course that is shown stays, and a point beyond it comes in."""
    frame = "() => document.querySelector('#course-view svg').getAttribute('viewBox').split(' ').map(Number)"
    whole = shown.evaluate(frame)
    box = shown.locator('.handle[data-key="path.waypoints_mm.3"]').bounding_box()
    x, y = round(box["x"] + box["width"] / 2), round(box["y"] + box["height"] / 2)
    shown.mouse.move(x, y)
    shown.mouse.wheel(0, -600)
    shown.wait_for_selector("#course-box.zoomed")
    near, stage = shown.evaluate(frame), shown.locator("#course-view").bounding_box()
    scale = near[2] / stage["width"]  # mm by px
    assert near[2] < 0.5 * whole[2]
    dragged(shown, "path.waypoints_mm.3", 8, -6)
    shown.wait_for_selector(f'{CURRENT}:not([data-whole="1"])', state="attached")
    current(shown, session)
    point = session.now.design.path.keys.waypoints_mm[2]
    assert point == pytest.approx((2600.0 + 8 * scale, 1200.0 + 6 * scale), abs=2 * scale)
    assert shown.evaluate(frame) == pytest.approx(near, abs=1e-6)
    far = shown.locator('.handle[data-key="path.waypoints_mm.5"]')
    far.focus()
    place, view = far.bounding_box(), shown.locator("#course-box").bounding_box()
    assert view["x"] <= place["x"] + place["width"] / 2 <= view["x"] + view["width"]
    assert view["y"] <= place["y"] + place["height"] / 2 <= view["y"] + view["height"]
    shown.keyboard.press("0")
    assert shown.evaluate(frame)[2] > near[2]
    assert all("409" in text for text in shown.said), shown.said
