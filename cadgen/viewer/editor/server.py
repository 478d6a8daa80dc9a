"""The page, its state and its results over HTTP: what the page's second script asks for.

| request                         | answer                                                              |
|---------------------------------|---------------------------------------------------------------------|
| `GET /`                         | the page, empty                                                     |
| `GET /state`                    | revision, numbers, points, what can be undone                       |
| `POST /change`                  | `{"changes": {key: number or [x, y]}, "gesture": text}` -> state    |
| `POST /insert`                  | `{"key": key, "at": [x, y]}` -> state                               |
| `POST /remove`                  | `{"key": key}` -> state                                             |
| `POST /exchange`                | `{"key": key}` of a gate, with the next one -> state                |
| `POST /undo`, `POST /redo`      | state                                                               |
| `POST /save`                    | `{}` or `{"name": text}` -> state                                   |
| `GET /result?stage=&revision=`  | HTML and data of `preview` or `whole`; 409 once a newer one is there |

Every refusal is `{"error": sentence}`: 4xx, with the sentences of the command line.
"""

import json
from collections.abc import Callable
from threading import Condition
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp

from cadgen.errors import CadgenError, DesignError
from cadgen.viewer.editor.guard import Address, Guard, refused
from cadgen.viewer.editor.job import Job, Result, Stage, State, fault_sentence
from cadgen.viewer.editor.session import Session
from cadgen.viewer.editor.text import read_changes, read_point
from cadgen.viewer.editor.worker import Worker
from cadgen.viewer.page.html import shell

_STATUS = {State.DONE: 200, State.REFUSED: 422, State.SUPERSEDED: 409, State.FAULT: 503}
_NEWER = "a newer version of the design is there: ask for that one"


class Service:
    """A session, and the two processes that compute its versions: the preview does not wait for the whole."""

    def __init__(self, session: Session, workers: dict[Stage, Worker] | None = None) -> None:
        self.session = session
        self.workers: dict[Stage, Worker] = workers or {stage: Worker() for stage in Stage}
        self._known: dict[Stage, tuple[int, Result]] = {}
        self._computing: set[Stage] = set()
        self._turns: dict[Stage, Condition] = {stage: Condition() for stage in self.workers}

    def start(self) -> None:
        """Begin the processes before the page asks."""
        for worker in self.workers.values():
            worker.start()
        self.session.state()  # the schema's keys are put together meanwhile, which takes a moment the first time

    def close(self) -> None:
        """End the processes."""
        for worker in self.workers.values():
            worker.close()

    def act(self, action: Callable[[], object]) -> dict[str, Any]:
        """Do something with the session and return its new state; older versions are no longer computed.

        Raises:
            CadgenError: of the action.
        """
        action()
        for worker in self.workers.values():
            worker.supersede(self.session.revision)
        for turn in self._turns.values():
            with turn:
                turn.notify_all()
        return self.session.state()

    def result(self, stage: Stage, revision: int) -> Result:
        """Result of a version; computed once, however many pages ask.

        A request that waits for its turn is answered as soon as its version is superseded: a browser has six
        connections to a server, and those that wait would keep the next change from being sent.
        """
        turn = self._turns[stage]
        with turn:
            turn.wait_for(lambda: stage not in self._computing or self.session.revision != revision)
            known = self._known.get(stage)
            if known is not None and known[0] == revision:
                return known[1]
            now, text, file = self.session.job()
            if now != revision:
                return Result(State.SUPERSEDED)
            self._computing.add(stage)
        result = Result(State.SUPERSEDED)
        try:
            self.workers[stage].supersede(revision)
            result = self.workers[stage].run(Job(revision, stage, text, file))
        finally:
            with turn:
                self._computing.discard(stage)
                if result.state in (State.DONE, State.REFUSED):
                    self._known[stage] = (revision, result)
                turn.notify_all()
        return result


def application(service: Service, address: Address) -> ASGIApp:
    """The server as an ASGI application."""

    async def page(request: Request) -> Response:
        return HTMLResponse(shell(service.session.name, {}, edited=True))

    async def state(request: Request) -> Response:
        return JSONResponse(service.session.state())

    async def result(request: Request) -> Response:
        stage, revision = request.query_params.get("stage"), request.query_params.get("revision", "")
        if stage not in service.workers or not revision.isdecimal() or len(revision) > 12:
            return refused(400, "stage must be preview or whole, and revision a whole number")
        found = await run_in_threadpool(service.result, Stage(stage), int(revision))
        if found.state == State.SUPERSEDED:
            return refused(409, _NEWER)
        return Response(found.body, _STATUS[found.state], media_type="application/json")

    def action(act: Callable[[dict[str, Any]], object]) -> Callable[[Request], Any]:
        async def answer(request: Request) -> Response:
            try:
                body = json.loads(await request.body() or b"{}")
            except (ValueError, RecursionError):
                return refused(400, "the body is not JSON")
            if not isinstance(body, dict):
                return refused(400, "the body must be a JSON object")
            try:
                return JSONResponse(await run_in_threadpool(service.act, lambda: act(body)))
            except DesignError as error:
                return refused(422, str(error))
            except CadgenError as error:
                return refused(409, str(error))

        return answer

    session = service.session
    routes = [
        Route("/", page),
        Route("/state", state),
        Route("/result", result),
        Route("/change", action(lambda body: _change(session, body)), methods=["POST"]),
        Route(
            "/insert",
            action(lambda body: session.insert(_text(body, "key"), read_point(body.get("at")))),
            methods=["POST"],
        ),
        Route("/remove", action(lambda body: session.remove(_text(body, "key"))), methods=["POST"]),
        Route("/exchange", action(lambda body: session.exchange(_text(body, "key"))), methods=["POST"]),
        Route("/undo", action(lambda body: session.undo()), methods=["POST"]),
        Route("/redo", action(lambda body: session.redo()), methods=["POST"]),
        Route(
            "/save",
            action(lambda body: session.save(_text(body, "name") if body.get("name") is not None else None)),
            methods=["POST"],
        ),
    ]

    async def not_there(request: Request, error: Exception) -> Response:
        return refused(404, "there is no such page: open the address that cadgen edit has printed")

    async def not_so(request: Request, error: Exception) -> Response:
        return refused(405, "this address is asked in another way")

    async def failed(request: Request, error: Exception) -> Response:
        return refused(500, fault_sentence(error))

    handlers: dict[Any, Any] = {404: not_there, 405: not_so, Exception: failed}
    return Guard(Starlette(routes=routes, exception_handlers=handlers), address)


def _change(session: Session, body: dict[str, Any]) -> None:
    gesture = body.get("gesture")
    if gesture is not None and not (isinstance(gesture, str) and len(gesture) <= 100):
        raise DesignError("gesture must be a text of at most 100 letters")
    session.change(read_changes(body.get("changes")), gesture)


def _text(body: dict[str, Any], name: str) -> str:
    value = body.get(name)
    if not isinstance(value, str):
        raise DesignError(f"the {name} must be a text")
    return value
