"""Server of the page, its state and its results over HTTP, from its first line to Ctrl-C.

| request                         | answer                                                              |
|---------------------------------|---------------------------------------------------------------------|
| `GET /`                         | the page, empty                                                     |
| `GET /state`                    | revision, numbers, points, what can be undone                       |
| `GET /news`                     | revision, file, and whether another program has changed it          |
| `POST /change`                  | `{"changes": {key: number or [x, y]}, "gesture": text}` -> state    |
| `POST /insert`                  | `{"key": key, "at": [x, y]}` -> state                               |
| `POST /remove`                  | `{"key": key}` -> state                                             |
| `POST /exchange`                | `{"key": key}` of a gate or segment, with the next one -> state     |
| `POST /undo`, `POST /redo`      | state                                                               |
| `POST /save`                    | `{}` or `{"name": text}` -> state                                   |
| `GET /result?stage=&revision=`  | HTML and data of `preview` or `whole`; 409 once a newer one is there |
| ... `&patience=`                | 202 if it is not there after so many seconds: ask again             |

Every refusal is `{"error": sentence, "zh": sentence}`, in English and in Chinese: 4xx.
"""

import asyncio
import json
import signal
import socket
import sys
import webbrowser
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from threading import Condition, Thread, current_thread, main_thread
from typing import Any, NamedTuple

import uvicorn
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp

from cadgen.errors import CadgenError, DesignError, FileError
from cadgen.messages import Message
from cadgen.registry import fault_sentence
from cadgen.viewer.editor.guard import Address, Guard, refused
from cadgen.viewer.editor.job import AnswerState, Job, JobStage, Result
from cadgen.viewer.editor.session import Session
from cadgen.viewer.editor.text_changes import read_changes, read_point
from cadgen.viewer.editor.worker import Worker
from cadgen.viewer.page.html import shell

_STATUS = {AnswerState.DONE: 200, AnswerState.REFUSED: 422, AnswerState.SUPERSEDED: 409, AnswerState.FAULT: 503}
_PATIENCE_S = 2  # for answers that are under way at the end
_NEWER = Message("a newer version of the design is there: ask for that one")
_MOST_LETTERS = 100  # of the name of a gesture
_MOST_PATIENCE_S = 60  # of a page that waits for a result


class Asked(NamedTuple):
    """Values that the body of a request may have, unchecked; None where it has none."""

    changes: object
    gesture: object
    key: object
    at: object
    name: object


class Service:
    """A session, and the two processes that compute its versions: the preview does not wait for the whole."""

    def __init__(self, session: Session, workers: dict[JobStage, Worker] | None = None) -> None:
        self.session = session
        self.workers: dict[JobStage, Worker] = workers or {stage: Worker() for stage in JobStage}
        self._known: dict[JobStage, tuple[int, Result]] = {}
        self._computing: set[JobStage] = set()
        self._turns: dict[JobStage, Condition] = {stage: Condition() for stage in self.workers}

    def start(self) -> None:
        """Begin the processes before the page asks."""
        for worker in self.workers.values():
            worker.start()
        self.session.state()  # the schema's keys are put together meanwhile, which takes a moment the first time

    def close(self) -> None:
        """End the processes."""
        for worker in self.workers.values():
            worker.close()

    def act(self, action: Callable[[], object]) -> object:
        """Do something with the session and return its new state, JSON; older versions are no longer computed.

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

    def result(self, stage: JobStage, revision: int) -> Result:
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
                return Result(AnswerState.SUPERSEDED)
            self._computing.add(stage)
        result = Result(AnswerState.SUPERSEDED)
        try:
            self.workers[stage].supersede(revision)
            result = self.workers[stage].run(Job(revision, stage, text, file))
        finally:
            with turn:
                self._computing.discard(stage)
                if result.state in (AnswerState.DONE, AnswerState.REFUSED):
                    self._known[stage] = (revision, result)
                turn.notify_all()
        return result


def application(service: Service, address: Address) -> ASGIApp:
    """The server as an ASGI application."""

    async def page(request: Request) -> Response:
        car = service.session.now.car
        return HTMLResponse(shell(service.session.name, {}, edited=True, car=car))

    async def state(request: Request) -> Response:
        return JSONResponse(service.session.state())

    async def news(request: Request) -> Response:
        return JSONResponse((await run_in_threadpool(service.session.news)).json())

    # Results have threads of their own, and all who wait for one version share one: however many wait, a change has a
    # thread at once. Of each stage one thread computes, and one waits for its turn with the newest version.
    threads = {stage: ThreadPoolExecutor(2, f"result-{stage}") for stage in JobStage}
    awaited: dict[tuple[JobStage, int], asyncio.Future[Result]] = {}

    async def result(request: Request) -> Response:
        query = request.query_params
        stage, revision, patience = query.get("stage"), query.get("revision", ""), query.get("patience", "")
        if stage not in service.workers or not revision.isdecimal() or len(revision) > 12:
            return refused(400, Message("stage must be preview or whole, and revision a whole number"))
        if patience and not (patience.isdecimal() and len(patience) < 4 and int(patience) <= _MOST_PATIENCE_S):
            return refused(400, Message("patience must be a whole number of at most {most} s", most=_MOST_PATIENCE_S))
        wanted = JobStage(stage), int(revision)
        if wanted not in awaited:
            loop = asyncio.get_running_loop()
            awaited[wanted] = loop.run_in_executor(threads[wanted[0]], service.result, *wanted)
            awaited[wanted].add_done_callback(lambda _: awaited.pop(wanted))
        done, _ = await asyncio.wait([awaited[wanted]], timeout=int(patience) if patience else None)
        if not done:
            return JSONResponse({}, 202)
        found = done.pop().result()
        if found.state == AnswerState.SUPERSEDED:
            return refused(409, _NEWER)
        return Response(found.body, _STATUS[found.state], media_type="application/json")

    def action(act: Callable[[Asked], object]) -> Callable[[Request], Any]:
        async def answer(request: Request) -> Response:
            try:
                content = json.loads(await request.body() or b"{}")
            except (ValueError, RecursionError):
                return refused(400, Message("the body is not JSON"))
            if not isinstance(content, dict):
                return refused(400, Message("the body must be a JSON object"))
            body = Asked(**{name: content.get(name) for name in Asked._fields})
            try:
                return JSONResponse(await run_in_threadpool(service.act, lambda: act(body)))
            except DesignError as error:
                return refused(422, error.message)
            except CadgenError as error:
                return refused(409, error.message)

        return answer

    session = service.session

    def change(body: Asked) -> None:
        gesture = body.gesture
        if gesture is not None and not (isinstance(gesture, str) and len(gesture) <= _MOST_LETTERS):
            raise DesignError("gesture must be a text of at most {most} letters", most=_MOST_LETTERS)
        session.change(read_changes(body.changes), gesture)

    actions: dict[str, Callable[[Asked], object]] = {
        "change": change,
        "insert": lambda body: session.insert(_text("key", body.key), read_point(body.at)),
        "remove": lambda body: session.remove(_text("key", body.key)),
        "exchange": lambda body: session.exchange(_text("key", body.key)),
        "undo": lambda body: session.undo(),
        "redo": lambda body: session.redo(),
        "save": lambda body: session.save(None if body.name is None else _text("name", body.name)),
    }
    routes = [Route("/", page), Route("/state", state), Route("/news", news), Route("/result", result)]
    routes += [Route(f"/{name}", action(act), methods=["POST"]) for name, act in actions.items()]

    async def not_there(request: Request, error: Exception) -> Response:
        return refused(404, Message("there is no such page: open the address that cadgen edit has printed"))

    async def not_so(request: Request, error: Exception) -> Response:
        return refused(405, Message("this address is asked in another way"))

    async def failed(request: Request, error: Exception) -> Response:
        return refused(500, fault_sentence(error))

    handlers: dict[Any, Any] = {404: not_there, 405: not_so, Exception: failed}
    return Guard(Starlette(routes=routes, exception_handlers=handlers), address)


def _text(name: str, value: object) -> str:
    if not isinstance(value, str):
        raise DesignError("the {name} must be a text", name=name)
    return value


def serve(session: Session, port: int, show: Callable[[str], object], *, browser: bool) -> None:
    """Serve a session on this machine's own address until the process is interrupted.

    Args:
        session: design that is edited.
        port: port; 0 for any that is free.
        show: function that is called once with the address, when it can be opened.
        browser: whether to open the address in the user's browser.

    Raises:
        FileError: the port is taken.
    """
    listening = bound_socket(port)
    address = Address.on(listening.getsockname()[1])
    service = Service(session)

    def ready() -> None:
        show(address.url)
        if browser:
            Thread(target=webbrowser.open, args=(address.url,), daemon=True).start()  # some wait for their browser

    config = uvicorn.Config(
        application(service, address),
        log_level="critical",
        access_log=False,
        server_header=False,
        date_header=False,
        lifespan="off",
        ws="none",
        timeout_graceful_shutdown=_PATIENCE_S,
    )
    try:
        service.start()
        _InterruptibleServer(config, ready, service.close).run(sockets=[listening])
    finally:
        service.close()
        listening.close()


class _InterruptibleServer(uvicorn.Server):
    """A server that says when it is ready, and that Ctrl-C ends as it is meant to."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None], ending: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready, self._ending = ready, ending

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to listen."""
        await super().startup(sockets)
        self._ready()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """End what is being computed, and with it the requests that wait for it."""
        self._ending()
        await super().shutdown(sockets)

    @contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Take the signals that end a process for the end of the editing, which is no failure."""
        if current_thread() is not main_thread():  # signals come to that one alone
            yield
            return
        names = [name for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name)]
        before = {getattr(signal, name): signal.getsignal(getattr(signal, name)) for name in names}
        for number in before:
            if before[number] is not signal.SIG_IGN:
                signal.signal(number, self.handle_exit)
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)


def bound_socket(port: int) -> socket.socket:
    """A socket on a port of this machine's own address.

    Raises:
        FileError: the port is taken, or may not be used.
    """
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        if sys.platform == "win32":
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind(("127.0.0.1", port))
    except OSError as error:
        listening.close()
        reason = error.strerror or error
        raise FileError(
            "port {port} cannot be used ({reason}): choose another one, or leave --port out", port=port, reason=reason
        ) from None
    return listening
