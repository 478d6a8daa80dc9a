"""The server behind its guard: the page alone gets through, and every refusal is one sentence."""

import asyncio
import random
import re
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from cadgen.api.design import Design
from cadgen.viewer.editor import guard
from cadgen.viewer.editor.guard import Address
from cadgen.viewer.editor.job import Result
from cadgen.viewer.editor.server import Service, application
from cadgen.viewer.page.html import policy
from tests.viewer.editor.conftest import TEXT, Here

JSON = {"content-type": "application/json"}


def sentence(response):
    answer = response.json()
    assert list(answer) == ["error", "zh"]
    assert re.search(r"[\u4e00-\u9fff]", answer["zh"])
    assert "\n" not in answer["error"]
    return answer["error"]


def test_the_page_and_its_headers(client):
    response = client.get("")
    assert response.status_code == 200
    headers = response.headers
    assert headers["content-security-policy"] == f"{policy(edited=True)}; frame-ancestors 'none'"
    assert "connect-src 'self'" in headers["content-security-policy"]
    assert "unsafe" not in headers["content-security-policy"]
    assert (headers["cache-control"], headers["referrer-policy"]) == ("no-store", "no-referrer")
    assert headers["x-content-type-options"] == "nosniff"
    # The report asks nobody.
    assert "connect-src" not in policy()


def test_each_address_has_a_token_of_its_own():
    tokens = {Address.on(1).token for _ in range(50)}
    assert len(tokens) == 50
    assert min(map(len, tokens)) >= 32


@pytest.mark.parametrize(
    "path", ["/", "/state", "/wrong/state", "/abc-tokenx/state", "//abc-token/state", "/%00/state"]
)
def test_without_the_token_nothing_is_answered(client, path):
    response = client.get(f"http://127.0.0.1:8123{path}")
    assert response.status_code == 403
    assert "token" in sentence(response)
    assert "small" not in response.text


@pytest.mark.parametrize("host", ["evil.example:8123", "localhost:8123", "127.0.0.1", "127.0.0.1:8124", ""])
def test_another_host_is_refused(client, host):
    response = client.get("state", headers={"host": host})
    assert response.status_code == 400
    assert "asked as 127.0.0.1:8123" in sentence(response)


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:9999", "https://127.0.0.1:8123"])
def test_another_origin_is_refused(client, origin):
    for response in (
        client.get("state", headers={"origin": origin}),
        client.post("change", json={"changes": {"car.wheelbase_mm": 1.0}}, headers={"origin": origin}),
    ):
        assert response.status_code == 403
        assert "another page" in sentence(response)
    assert client.get("state", headers={"sec-fetch-site": "cross-site"}).status_code == 403


def test_a_change_without_an_origin_or_as_a_form_is_refused(client, session):
    del client.headers["origin"]
    assert client.post("undo", json={}).status_code == 403
    assert client.get("state").status_code == 200
    client.headers["origin"] = "http://127.0.0.1:8123"
    assert client.post("undo", content="{}", headers={"content-type": "text/plain"}).status_code == 415
    assert session.now.text == TEXT


def test_a_body_that_is_too_long_is_refused_whatever_its_header_says(client, session):
    long = b'{"changes": {"' + b"x" * guard.MOST_BYTES + b'": 1}}'
    assert client.post("change", content=long, headers=JSON).status_code == 413

    def pieces():
        yield from (long[i : i + 1000] for i in range(0, len(long), 1000))

    response = client.post("change", content=pieces(), headers=JSON)
    assert response.status_code == 413
    assert "longer than" in sentence(response)
    assert client.post("change", content=b"{}", headers={**JSON, "content-length": "-5"}).status_code == 413
    assert session.now.text == TEXT


@pytest.mark.parametrize(
    ("path", "body", "status"),
    [
        ("change", b"{", 400),
        ("change", b"[]", 400),
        ("change", b"[" * 50_000, 400),
        ("change", b"\xff\xfe", 400),
        ("change", b"{}", 422),
        ("change", b'{"changes": {}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": "170"}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": true}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": NaN}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": 1e999}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": 99999999999999999999}}', 422),
        ("change", b'{"changes": {"path.waypoints_mm.2": [1, 2, 3]}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm=1\\nname": 170}}', 422),
        ("change", b'{"changes": {"car.wheelbase_mm": 170}, "gesture": 5}', 422),
        ("insert", b"{}", 422),
        ("insert", b'{"key": "path.waypoints_mm.2", "at": [1, 2, 3]}', 422),
        ("insert", b'{"key": "path.waypoints_mm.2", "at": [NaN, 2]}', 422),
        ("insert", b'{"key": "path.waypoints_mm.99", "at": [1, 2]}', 422),
        ("remove", b'{"key": 5}', 422),
        ("remove", b'{"key": "course.posts.2"}', 422),
        ("insert", b'{"key": "course.gates.2", "at": [1, 2]}', 422),
        ("exchange", b'{"key": "course.posts.1"}', 422),
        ("exchange", b'{"key": 1}', 422),
        ("save", b'{"name": 5}', 422),
        ("save", b'{"name": "../x"}', 422),
        ("state", b"{}", 405),
        ("nothing", b"{}", 404),
        ("../state", b"{}", 403),
    ],
)
def test_requests_that_cannot_be_are_refused_in_a_sentence(client, session, path, body, status):
    response = client.post(path, content=body, headers=JSON)
    assert response.status_code == status, response.text
    assert sentence(response)
    assert session.now.text == TEXT


@pytest.mark.parametrize("query", ["", "stage=all&revision=1", "stage=preview&revision=-1", "stage=preview&revision=x"])
def test_a_result_is_asked_for_by_stage_and_revision(client, query):
    assert client.get(f"result?{query}").status_code == 400


def test_an_old_revision_is_superseded(client):
    client.post("change", json={"changes": {"car.wheelbase_mm": 170.0}})
    assert client.get("result?stage=preview&revision=1").status_code == 409


def test_a_point_is_added_and_removed(client, session):
    state = client.post("insert", json={"key": "path.waypoints_mm.2", "at": [700.0, 20.0]}).json()
    points = {point["key"]: point for point in state["points"]}
    assert (points["path.waypoints_mm.2"]["x"], points["path.waypoints_mm.2"]["listed"]) == (700.0, "path.waypoints_mm")
    assert points["course.posts.1.at_mm"]["listed"] == ""
    assert len(client.post("remove", json={"key": "path.waypoints_mm.2"}).json()["points"]) == len(points) - 1
    assert session.now.text == TEXT


def test_a_request_that_waits_is_answered_when_it_is_superseded(session):
    """One computation does not end; the requests for it and after it do, so that the page can go on asking."""
    begun, end = threading.Event(), threading.Event()

    class Endless(Here):
        def run(self, job):
            begun.set()
            end.wait(60)
            return Result("superseded")

    service = Service(session, {"preview": Here(), "whole": Endless()})
    with ThreadPoolExecutor(3) as pool:
        first = pool.submit(service.result, "whole", 1)
        begun.wait(60)
        waits = pool.submit(service.result, "whole", 1)
        service.act(lambda: session.change({"car.wheelbase_mm": 170.0}))
        assert waits.result(60).state == "superseded"
        assert not first.done()
        end.set()
        assert first.result(60).state == "superseded"


class Held(Here):
    """A worker whose first job does not end until it is told to; the others are answered at once."""

    def __init__(self):
        self.begun, self.end, self.jobs = threading.Event(), threading.Event(), []

    def run(self, job):
        self.jobs.append(job.revision)
        if len(self.jobs) == 1:
            self.begun.set()
            self.end.wait(300)
            return Result("superseded")
        return Result("done", b'{"revision": %d}' % job.revision)


WAITING = 120


@pytest.mark.parametrize("patience", ["", "&patience=60"])
def test_many_waiting_results_delay_no_change(session, address, patience):
    """120 pages wait for a result that does not come; a change is answered all the same, and stale work is dropped."""
    httpx = pytest.importorskip("httpx")
    held = Held()
    service = Service(session, {"preview": Here(), "whole": held})
    own = f"http://{address.host}"

    async def run():
        async with httpx.AsyncClient(
            transport=httpx.ASGITransport(application(service, address)),
            base_url=f"{own}/{address.token}/",
            headers={"origin": own},
            timeout=None,
        ) as client:

            def results(revision):
                path = f"result?stage=whole&revision={revision}{patience}"
                return [asyncio.create_task(client.get(path)) for _ in range(WAITING)]

            first = results(1)
            await asyncio.to_thread(held.begun.wait, 300)
            begun = time.perf_counter()
            changed = [
                await client.post("change", json={"changes": {"car.wheelbase_mm": 170.0 + number}})
                for number in range(5)
            ]
            took = time.perf_counter() - begun
            print(f"{WAITING} waiting results: a change takes {1e3 * took / 5:.1f} ms")
            assert [answer.status_code for answer in changed] == [200] * 5
            assert not any(task.done() for task in first)  # the computation goes on
            # One version is computed once, however many wait; the versions between are never begun.
            last = [task for revision in range(2, 7) for task in results(revision)]
            await asyncio.sleep(0)
            held.end.set()
            codes = [(await task).status_code for task in (*first, *last)]
            assert codes == [409] * (5 * WAITING) + [200] * WAITING
            assert held.jobs == [1, 6]

    asyncio.run(asyncio.wait_for(run(), 120))


def test_a_result_that_is_not_there_in_time_is_asked_for_again(client, service, session):
    held = Held()
    service.workers["whole"] = held
    path = "result?stage=whole&revision={}&patience={}"
    with client:  # one loop for all requests, as a server has
        assert client.get(path.format(1, "x")).status_code == 400
        assert client.get(path.format(1, 61)).status_code == 400
        assert client.get(path.format(1, 0)).status_code == 202
        client.post("change", json={"changes": {"car.wheelbase_mm": 170.0}})
        assert client.get(path.format(2, 0)).status_code == 202
        held.end.set()
        answer = client.get(path.format(2, 60))
        assert (answer.status_code, answer.json()) == (200, {"revision": 2})


def test_what_is_new_is_told_to_every_page(client, session, file):
    assert client.get("news").json() == {
        "revision": 1,
        "file": "small.toml",
        "unsaved": False,
        "changed_outside": False,
    }
    client.post("change", json={"changes": {"car.wheelbase_mm": 170.0}})
    news = client.get("news").json()
    assert (news["revision"], news["unsaved"], news["changed_outside"]) == (2, True, False)
    file.write_text(TEXT.replace("# C", "# by another program"))
    assert client.get("news").json()["changed_outside"]
    client.post("save", json={"name": "mine.toml"})
    assert client.get("news").json() == {
        "revision": 3,
        "file": "mine.toml",
        "unsaved": False,
        "changed_outside": False,
    }
    (file.parent / "mine.toml").unlink()  # a file that was removed is written again
    assert not client.get("news").json()["changed_outside"]


def test_a_fault_is_a_sentence_too(service, address):
    testclient = pytest.importorskip("starlette.testclient")
    service.act = lambda _: {}["of its own"]
    own = f"http://{address.host}"
    client = testclient.TestClient(
        application(service, address), f"{own}/{address.token}/", raise_server_exceptions=False
    )
    response = client.post("undo", json={}, headers={"origin": own})
    assert response.status_code == 500
    assert "please report it" in sentence(response)
    assert response.headers["cache-control"] == "no-store"


def figures(html):
    """Value and limit of each check in the first table of checks."""
    rows = re.findall(r"<tr[^>]*>(.*?)</tr>", html.partition('id="table-cam-checks"')[2].partition("</table>")[0])
    return [[float(value) for value in re.findall(r'data-value="([^"]+)"', row)] for row in rows[1:]]


@pytest.mark.slow
def test_numbers_of_the_page_are_those_of_check(client, file):
    client.post("change", json={"changes": {"path.waypoints_mm.3": [2620.0, 1190.0]}})
    revision = client.get("state").json()["revision"]
    result = client.get(f"result?stage=whole&revision={revision}").json()
    assert (result["stage"], result["revision"]) == ("whole", revision)
    client.post("save", json={})
    cam = Design.load(file).cam()
    checks = sorted(cam.computed.figures, key=lambda check: check.passed)
    known = [[c.value, *([c.limit] if abs(c.limit) < float("inf") else [])] for c in checks]
    assert figures(result["pieces"]["tables"]) == known
    assert ("see what fails" in result["pieces"]["verdict"]) == (not cam.passed)


@pytest.mark.slow
def test_a_design_that_cannot_be_driven_is_told_and_its_floor_is_shown(client):
    client.post("change", json={"changes": {"path.waypoints_mm.3": [1510.0, 210.0]}})
    response = client.get("result?stage=preview&revision=2")
    assert response.status_code == 422
    answer = response.json()
    assert answer["error"]
    assert 'class="post"' in answer["floor"]
    client.post("undo", json={})
    answer = client.get("result?stage=preview&revision=3").json()
    assert sorted(answer["pieces"]) == ["cam-box", "cam-legend", "charts", "course-box", "legend"]
    assert answer["document"]["format"] == "cadgen-report"


@pytest.mark.slow
@pytest.mark.long
def test_two_hundred_random_actions_without_a_fault(client, service, session, file, monkeypatch):
    """Sensible and foolish numbers, undo, redo, save, results; each answer has its state, and the text always loads."""
    rng = random.Random(14)
    seen = set()
    for number in range(200):
        state = client.get("state").json()
        controls = [control for group in state["groups"] for control in group["controls"]]
        control, point = rng.choice(controls), rng.choice(state["points"])
        kinds = ["slide", "drag", "drag", "far", "insert", "remove", "undo", "redo", "save", "name", "result"]
        kind = rng.choice([*kinds, "add", "add", "take", "exchange"])
        if kind == "slide":
            value = rng.uniform(control["low"], control["high"])
            value = round(value) if control["whole"] else value
            response = client.post("change", json={"changes": {control["key"]: value}, "gesture": f"g{number // 3}"})
        elif kind == "drag":
            at = [point["x"] + rng.gauss(0, 30), point["y"] + rng.gauss(0, 30)]
            response = client.post("change", json={"changes": {point["key"]: at}, "gesture": f"g{number // 3}"})
        elif kind == "far":
            foolish = rng.choice([0, -1, 1e-12, 1e6, -1e6, 1e14, 0.1])
            key, value = rng.choice([(control["key"], foolish), (point["key"], [foolish, foolish])])
            response = client.post("change", json={"changes": {key: value}})
        elif kind in ("insert", "remove"):
            response = client.post(kind, json={"key": point["key"], "at": [point["x"] + 50.0, point["y"]]})
        elif kind in ("add", "take", "exchange"):
            item = rng.choice(state["kinds"])
            key = item["key"] if item["alone"] else f"{item['key']}.{rng.randint(0, item['count'] + 2)}"
            if kind == "exchange":
                key = f"course.gates.{rng.randint(0, 3)}"
            body = {"key": key, "at": [rng.uniform(0, 6000), rng.uniform(-500, 2500)]}
            response = client.post({"add": "insert", "take": "remove"}.get(kind, kind), json=body)
        elif kind == "result":
            if number % 4:  # they take long
                continue
            stage = rng.choice(["preview", "whole"])
            response = client.get(f"result?stage={stage}&revision={state['revision']}")
        else:
            body = {"name": rng.choice(["small", "one", "../x", ""])} if kind == "name" else {}
            response = client.post("save" if kind == "name" else kind, json=body)
        seen.add((kind, response.status_code))
        assert response.status_code in (200, 409, 422), (kind, response.text)
        if response.status_code == 422:
            assert response.json()["error"]
    assert {status for _, status in seen} == {200, 409, 422}
    assert seen >= {(kind, status) for kind in ("add", "take", "exchange") for status in (200, 422)}
    Design.from_toml(session.now.text)
    assert "# A small car.   Its comments are to stay." in session.now.text
    assert {entry.suffix for entry in file.parent.iterdir()} == {".toml"}
