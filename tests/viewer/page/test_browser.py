"""The page in a browser: Chromium of the system, software drawing. Skipped with a sentence where there is none."""

import pytest

from cadgen.viewer.page.html import html_of
from cadgen.viewer.page.report import page_of
from tests.viewer.page.chromium import ARGUMENTS, READY, serious_faults


@pytest.fixture(scope="module")
def browser(chromium):
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        yield started
        started.close()


@pytest.fixture(scope="module")
def address(html, tmp_path_factory):
    file = tmp_path_factory.mktemp("page") / "page.html"
    file.write_text(html, encoding="utf-8")
    return file.as_uri()


@pytest.fixture(scope="module")
def opened(browser, address):
    """The page, ready, with everything that it said and asked for; to start it takes longer than most of the tests."""
    context = browser.new_context(viewport={"width": 1280, "height": 720}, locale="en-GB")
    page = context.new_page()
    page.said = []
    page.on("console", lambda message: page.said.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: page.said.append(str(error)))
    page.on("request", lambda request: page.said.append(request.url) if request.url != address else None)
    page.goto(address)
    page.wait_for_selector(READY, state="attached")
    yield page
    context.close()


@pytest.fixture
def shown(opened):
    """The page at the start of the run, with play; no test may make it say or ask for anything."""
    opened.set_checked("#with-play", True)
    slide(opened, 0.0)
    opened.evaluate("() => document.activeElement.blur()")
    yield opened
    assert opened.said == []


def slide(page, degrees):
    page.evaluate(
        "d => { const s = document.getElementById('angle'); s.value = d; s.dispatchEvent(new Event('input')); }",
        degrees,
    )


@pytest.mark.slow
def test_it_comes_up_without_an_error_or_a_request(shown):
    assert shown.locator("canvas").count() >= 5  # the scene and four charts
    assert shown.locator("html").get_attribute("data-without") is None


@pytest.mark.slow
def test_the_slider_moves_cam_car_and_read_outs(shown):
    def state():
        return shown.evaluate(
            "() => [document.getElementById('disc-layer').style.transform,"
            " document.getElementById('car').style.transform,"
            " document.getElementById('now').textContent, document.getElementById('angle-now').value]"
        )

    before = state()
    slide(shown, 128.0)
    after = state()
    assert all(old != new for old, new in zip(before, after, strict=True))
    assert after[3] == "128.0°"
    shown.uncheck("#with-play")
    free = state()
    assert free[1] != after[1]
    # Without play the cam stands where the motor does.
    assert free[0] == "rotate(128deg)"


@pytest.mark.slow
def test_it_plays_and_stops_by_the_space_bar(shown):
    shown.keyboard.press("Space")
    shown.wait_for_selector("#go[aria-pressed=true]")
    shown.wait_for_timeout(400)
    shown.keyboard.press("Space")
    shown.wait_for_selector("#go[aria-pressed=false]")
    assert float(shown.input_value("#angle")) > 0


@pytest.mark.slow
def test_the_live_region_speaks_once_the_slider_rests(shown):
    slide(shown, 90.0)
    shown.locator("#live", has_text="cam angle 90.0°, lift ").wait_for(state="attached")


@pytest.mark.slow
def test_chinese_and_back(shown):
    english = shown.inner_text("main")
    shown.click("#language")
    assert shown.locator("html").get_attribute("lang") == "zh-CN"
    assert "检查项" in shown.inner_text("#checks")
    assert "升程" in shown.inner_text("#chart-lift")
    shown.click("#language")
    assert shown.inner_text("main") == english


@pytest.mark.slow
@pytest.mark.long
def test_a_distance_is_measured_between_two_points(shown):
    shown.get_by_role("button", name="Measure").click()
    box = shown.locator("#scene canvas").bounding_box()
    shown.get_by_role("button", name="Right").click()
    hits = 0
    for share in (0.35, 0.45, 0.55, 0.65):
        shown.mouse.click(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"])
        hits = shown.inner_text(".measured")
        if "mm" in hits:
            break
    assert "mm (ahead" in hits


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    ("scheme", "width", "locale"),
    [("light", 1280, "en-GB"), ("dark", 390, "en-GB"), ("dark", 1280, "zh-CN"), ("light", 390, "zh-CN")],
)
def test_axe_finds_nothing_serious(browser, address, scheme, width, locale):
    context = browser.new_context(viewport={"width": width, "height": 800}, color_scheme=scheme, locale=locale)
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector(READY, state="attached")
    serious = serious_faults(page)
    context.close()
    assert not serious, serious


@pytest.mark.slow
@pytest.mark.long
def test_a_phone_needs_no_sideways_scrolling(browser, address):
    context = browser.new_context(viewport={"width": 390, "height": 844}, locale="en-GB")
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector(READY, state="attached")
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 390
    page.set_viewport_size({"width": 844, "height": 390})  # turned, and back again
    page.wait_for_function("() => document.querySelector('.plot canvas').clientWidth > 500")
    page.set_viewport_size({"width": 360, "height": 740})
    page.wait_for_function("() => document.querySelector('.plot canvas').clientWidth < 360")
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 360
    context.close()


@pytest.mark.slow
@pytest.mark.long
def test_it_prints_on_a4(shown, tmp_path):
    content = shown.pdf(format="A4", prefer_css_page_size=True)
    assert content.startswith(b"%PDF")
    assert 3 <= content.count(b"/Type /Page\n") + content.count(b"/Type /Page ") <= 12


@pytest.mark.slow
@pytest.mark.long
def test_without_webgl_a_sentence_and_the_rest(browser, address):
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.add_init_script(
        "HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext,"
        " { apply: (f, self, a) => (a[0].startsWith('webgl') ? null : Reflect.apply(f, self, a)) })"
    )
    page.goto(address)
    page.wait_for_selector(READY, state="attached")
    assert "no WebGL" in page.inner_text("#trouble")
    slide(page, 200.0)
    assert page.evaluate("() => document.getElementById('disc-layer').style.transform").startswith("rotate(")
    page.close()


@pytest.mark.slow
def test_without_scripts_the_tables_read(browser, address):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(address)
    assert "pressure angle, rise" in page.inner_text("#checks")
    assert page.locator("#disc-layer").is_visible()
    context.close()


@pytest.mark.slow
@pytest.mark.long
def test_the_page_of_a_motion_moves(browser, feeder, tmp_path):
    """Disc and follower by the slider and by the button, in the picture and in 3D; with curves, and without scripts."""
    file = tmp_path / "page.html"
    file.write_text(html_of(page_of(feeder())), encoding="utf-8")
    context = browser.new_context(viewport={"width": 1280, "height": 800}, locale="en-GB")
    page, said = context.new_page(), []
    page.on("console", lambda message: said.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(file.as_uri())
    page.wait_for_selector(READY, state="attached")
    slide(page, 105.0)  # on the upper dwell
    assert page.evaluate("() => document.getElementById('disc-layer').style.transform") == "rotate(105deg)"
    moved = page.locator("#follower-section").get_attribute("transform")
    assert moved.startswith("translate(14 0) rotate(0 ")
    assert page.inner_text("#now .lift b") == "14.000 mm"
    assert page.locator("#now > span").count() == 2  # lift and pressure angle: there is no car
    assert page.locator(".plot canvas").count() == 6
    assert page.locator("#scene canvas").count() == 1
    page.click("#go")
    page.wait_for_function("() => Number(document.getElementById('angle').value) > 106")
    page.click("#go")
    page.set_viewport_size({"width": 390, "height": 844})
    page.wait_for_function("() => document.querySelector('.plot canvas').clientWidth < 390")
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 390
    assert serious_faults(page) == []
    assert said == []
    context.close()

    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(file.as_uri())
    assert page.locator("#follower-section").is_visible()
    assert page.locator(".still").first.is_visible()
    assert page.locator(".still text").count() >= 3 * 7
    context.close()


@pytest.mark.slow
def test_a_design_that_fails_says_so_first(browser, failing, tmp_path):
    file = tmp_path / "page.html"
    file.write_text(failing[1], encoding="utf-8")
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.goto(file.as_uri())
    page.wait_for_selector(READY, state="attached")
    assert page.locator("#failures").bounding_box()["y"] < 200
    page.close()


FRAME = "() => document.querySelector('#course-view svg').getAttribute('viewBox').split(' ').map(Number)"
# Middle of a drawing on the screen, and the place on the floor that is drawn there, y upwards.
PLACE = """([x, y, id]) => {
  if (id) {
    const r = document.getElementById(id).getBoundingClientRect();
    [x, y] = [r.x + r.width / 2, r.y + r.height / 2];
  }
  const stage = document.getElementById('course-view').getBoundingClientRect();
  const box = document.querySelector('#course-view svg').getAttribute('viewBox');
  const [left, top, width, height] = box.split(' ').map(Number);
  return [left + (x - stage.x) / stage.width * width, -top - (y - stage.y) / stage.height * height];
}"""


@pytest.mark.slow
@pytest.mark.long
def test_the_course_is_brought_nearer_moved_and_shown_as_a_whole(shown):
    slide(shown, 100.0)
    shown.locator("#course-box").scroll_into_view_if_needed()
    whole, box = shown.evaluate(FRAME), shown.locator("#course-box").bounding_box()
    x, y = round(box["x"] + 0.6 * box["width"]), round(box["y"] + 0.5 * box["height"])  # of an event they are whole
    under, car = shown.evaluate(PLACE, [x, y, ""]), shown.evaluate(PLACE, [0, 0, "car"])
    half_a_pixel = whole[2] / shown.locator("#course-view").bounding_box()["width"] / 2
    shown.mouse.move(x, y)
    shown.mouse.wheel(0, -600)
    shown.wait_for_function("w => document.querySelector('#course-box.zoomed') !== null", arg=0)
    near = shown.evaluate(FRAME)
    assert near[2] < 0.7 * whole[2]
    # What was under the pointer is there still, and the car stands where it stood on the floor.
    assert shown.evaluate(PLACE, [x, y, ""]) == pytest.approx(under, abs=1.0)
    assert shown.evaluate(PLACE, [0, 0, "car"]) == pytest.approx(car, abs=half_a_pixel)
    assert near[2] / near[3] == pytest.approx(box["width"] / box["height"], rel=0.02)  # it fills its box

    # The ground goes with the pointer.
    shown.mouse.down()
    shown.mouse.move(x - 20, y + 15)
    shown.mouse.move(x - 40, y + 30)
    shown.mouse.up()
    assert shown.evaluate(PLACE, [x - 40, y + 30, ""]) == pytest.approx(under, abs=3.0)
    assert shown.evaluate(PLACE, [0, 0, "car"]) == pytest.approx(car, abs=half_a_pixel)

    # Keys: nearer, to the right, all; buttons; and never beyond the course.
    shown.locator("#course-box").focus()
    now = shown.evaluate(FRAME)
    shown.keyboard.press("+")
    closer = shown.evaluate(FRAME)
    assert closer[2] == pytest.approx(now[2] / 1.4, rel=1e-6)
    shown.keyboard.press("ArrowRight")
    assert shown.evaluate(FRAME)[0] > closer[0]
    for _ in range(80):
        shown.keyboard.press("ArrowRight")
        shown.keyboard.press("ArrowDown")
    last = shown.evaluate(FRAME)
    assert last[0] + last[2] == pytest.approx(whole[0] + whole[2])
    assert last[1] + last[3] == pytest.approx(whole[1] + whole[3])
    shown.keyboard.press("0")
    assert shown.evaluate(FRAME) == whole
    for _ in range(20):
        shown.click("#map-nearer")
    assert shown.evaluate(FRAME)[2] > whole[2] / 100  # as near as it comes
    shown.click("#map-farther")
    shown.click("#map-fit")
    assert shown.evaluate(FRAME) == whole

    # All of it is shown: the wheel turns the page.
    shown.evaluate("() => scrollTo(0, 0)")
    box = shown.locator("#course-box").bounding_box()
    shown.mouse.move(box["x"] + 50, box["y"] + 50)
    shown.mouse.wheel(0, 200)
    shown.wait_for_function("() => scrollY > 0")
    assert shown.evaluate(FRAME) == whole
    shown.evaluate("() => scrollTo(0, 0)")


@pytest.mark.slow
@pytest.mark.long
def test_two_fingers_bring_the_course_nearer_and_one_moves_it(browser, address):
    context = browser.new_context(viewport={"width": 390, "height": 844}, locale="en-GB", has_touch=True)
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector(READY, state="attached")
    page.locator("#course-box").scroll_into_view_if_needed()
    box, whole = page.locator("#course-box").bounding_box(), page.evaluate(FRAME)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    touch = page.context.new_cdp_session(page)

    def fingers(kind, *places):
        points = [{"x": a, "y": b, "id": number} for number, (a, b) in enumerate(places)]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    under = page.evaluate(PLACE, [x, y, ""])
    fingers("touchStart", (x - 20, y), (x + 20, y))
    for apart in (30, 45, 60):
        fingers("touchMove", (x - apart, y), (x + apart, y))
    fingers("touchEnd")
    near = page.evaluate(FRAME)
    assert near[2] < 0.6 * whole[2]
    assert page.evaluate(PLACE, [x, y, ""]) == pytest.approx(under, abs=0.02 * whole[2])
    scrolled = page.evaluate("() => scrollY")
    under = page.evaluate(PLACE, [x, y, ""])
    fingers("touchStart", (x, y))
    for way in (10, 20, 30):
        fingers("touchMove", (x - way, y - way))
    fingers("touchEnd")
    assert page.evaluate(PLACE, [x - 30, y - 30, ""]) == pytest.approx(under, abs=0.02 * whole[2])
    assert page.evaluate("() => scrollY") == scrolled  # the map is moved, and not the page
    assert page.evaluate("() => [visualViewport.scale, document.documentElement.scrollWidth]") == [1, 390]
    context.close()
