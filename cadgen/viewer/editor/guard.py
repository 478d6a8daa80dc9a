"""Refusal of every request that does not come from the page itself.

The server is on this machine's own address alone, but every page in the browser can reach that. So the address has a
random token; `Host` must be the server's own, for a foreign name may be made to point here (DNS rebinding); a request
from another page has that page's `Origin`, and is refused; and a body has a limit.
"""

import secrets
from dataclasses import dataclass

from starlette import types
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from cadgen.messages import Message
from cadgen.viewer.editor.job import in_both
from cadgen.viewer.page.html import policy

MOST_BYTES = 100_000  # of a request's body: a hundred changes are some 10 000
_ANOTHER_PAGE = Message("the request comes from another page: use the page that cadgen edit has opened")

_HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": f"{policy(edited=True)}; frame-ancestors 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


@dataclass(frozen=True)
class Address:
    """Where the page is served.

    Attributes:
        port: port on this machine's own address.
        token: random text without which nothing is answered.
    """

    port: int
    token: str

    @classmethod
    def on(cls, port: int) -> "Address":
        """Address on a port, with a token of its own."""
        return cls(port, secrets.token_urlsafe(24))

    @property
    def host(self) -> str:
        """Host and port."""
        return f"127.0.0.1:{self.port}"

    @property
    def url(self) -> str:
        """Address for the browser."""
        return f"http://{self.host}/{self.token}/"


def refused(status: int, sentence: str) -> Response:
    """Answer that refuses a request in a sentence."""
    return JSONResponse(in_both(sentence), status)


async def _read(receive: Receive) -> bytes | None:
    """The body of a request; None if it is longer than allowed, whatever its header says."""
    body = b""
    while True:
        message = await receive()
        body += bytes(message.get("body", b""))
        if len(body) > MOST_BYTES:
            return None
        if message["type"] != "http.request" or not message.get("more_body", False):
            return body


class Guard:
    """The server behind its guard: only requests from the page get through, and every answer has its headers."""

    def __init__(self, inside: ASGIApp, address: Address) -> None:
        self._inside, self._address = inside, address

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, as ASGI has it."""
        if scope["type"] == "lifespan":
            await self._inside(scope, receive, send)
            return
        if scope["type"] != "http":
            return

        async def headed(message: types.Message) -> None:
            if message["type"] == "http.response.start":
                own = [(key.lower().encode(), value.encode()) for key, value in _HEADERS.items()]
                message["headers"] = [*message.get("headers", []), *own]
            await send(message)

        request = Request(scope)
        answer: ASGIApp | None = self._refusal(request)
        if answer is None:
            body = await _read(receive)
            if body is not None:
                pending = [{"type": "http.request", "body": body, "more_body": False}]

                async def replayed() -> types.Message:
                    """The body that was read already, and then what comes after it."""
                    return pending.pop() if pending else await receive()

                behind_token = request.url.path[len(self._address.token) + 1 :]
                await self._inside({**scope, "path": behind_token}, replayed, headed)
                return
            answer = _too_long()
        await answer(scope, receive, headed)

    def _refusal(self, request: Request) -> Response | None:
        """Answer to a request that does not come from the page; None for one that does."""
        host, own = self._address.host, f"http://{self._address.host}"
        if request.headers.getlist("host") != [host]:
            return refused(
                400,
                Message(
                    "this server is asked as {host} alone: open the address that cadgen edit has printed", host=host
                ),
            )
        token = request.url.path.split("/")[1] if "/" in request.url.path else ""
        if not secrets.compare_digest(token.encode(), self._address.token.encode()):
            return refused(
                403, Message("the address lacks its token: open the whole address that cadgen edit has printed")
            )
        origin, reading = request.headers.get("origin"), request.method in ("GET", "HEAD")
        if origin != own and not (reading and origin is None):
            return refused(403, _ANOTHER_PAGE)
        if request.headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
            return refused(403, _ANOTHER_PAGE)
        length = request.headers.get("content-length", "0")
        if not length.isdecimal() or len(length) > 12 or int(length) > MOST_BYTES:
            return _too_long()
        if not reading and request.headers.get("content-type", "").partition(";")[0] != "application/json":
            return refused(415, Message("the body must be JSON, with the content type application/json"))
        return None


def _too_long() -> Response:
    text = Message("the request is longer than {most} bytes: make fewer changes at once", most=MOST_BYTES)
    return refused(413, text)
