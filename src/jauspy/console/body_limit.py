"""ASGI middleware that bounds the bodies of requests, whatever the page of the browser permits."""

from __future__ import annotations

import asyncio
from typing import Any, Final

from starlette.datastructures import Headers
from starlette.responses import PlainTextResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from jauspy.console.trajectory import MAX_FILE

MAX_BODY: Final = MAX_FILE + (64 << 10)
"""Bytes: the largest file that the page takes, and the form around it."""
BODY_TIME: Final = 30.0
"""Seconds in which a body arrives."""
_CLOSE: Final = {"connection": "close"}  # the rest of the body is not read
_TOO_LARGE: Final = f"a request to the console has at most {MAX_BODY >> 10} kB; send a smaller file"
_TOO_SLOW: Final = f"the request did not arrive within {BODY_TIME:.0f} s; send it again"


class BodyLimit:
    """Passes requests with bodies of up to `MAX_BODY` bytes to `app`; answers others with 413, slow ones with 408."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection, as ASGI defines."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        announced = Headers(scope=scope).get("content-length", "0")
        if not announced.isdecimal() or int(announced) > MAX_BODY:
            await PlainTextResponse(_TOO_LARGE, 413, _CLOSE)(scope, receive, send)
            return
        request = _Request(scope, receive, send)
        try:
            await self._app(scope, request.receive, request.send)
        except Exception:
            if not request.is_refused:  # else the application was told that the browser has left
                raise


class _Request:
    """One request, whose body is counted while the application reads it."""

    def __init__(self, scope: Scope, receive: Receive, send: Send) -> None:
        self.is_refused = False
        self._scope, self._receive, self._send = scope, receive, send
        self._size = 0
        self._deadline = asyncio.get_running_loop().time() + BODY_TIME
        self._is_whole = self._is_answered = False

    async def receive(self) -> Message:
        """The next part of the body; the end of the connection if it is too long or too slow."""
        if self._is_whole or self._is_answered:  # what follows is the end of the connection
            return await self._receive()
        try:
            async with asyncio.timeout_at(self._deadline):
                message = await self._receive()
        except TimeoutError:
            return await self._refuse(PlainTextResponse(_TOO_SLOW, 408, _CLOSE))
        self._size += len(message.get("body", b""))
        self._is_whole = not message.get("more_body", False)
        if self._size > MAX_BODY:
            return await self._refuse(PlainTextResponse(_TOO_LARGE, 413, _CLOSE))
        return message

    async def send(self, message: Any) -> None:
        """Send a part of the answer, unless the request was refused."""
        if not self.is_refused:
            self._is_answered = True
            await self._send(message)

    async def _refuse(self, response: Response) -> Message:
        await response(self._scope, self._receive, self._send)
        self.is_refused = self._is_whole = True
        return {"type": "http.disconnect"}
