"""The server from its first line to Ctrl-C."""

import signal
import socket
import sys
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Thread, current_thread, main_thread

import uvicorn

from cadgen.errors import FileError
from cadgen.viewer.editor.guard import Address
from cadgen.viewer.editor.server import Service, application
from cadgen.viewer.editor.session import Session

_PATIENCE_S = 2  # for answers that are under way at the end


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
        _Server(config, ready, service.close).run(sockets=[listening])
    finally:
        service.close()
        listening.close()


class _Server(uvicorn.Server):
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
        raise FileError(f"port {port} cannot be used ({reason}): choose another one, or leave --port out") from None
    return listening
