"""WebSockets of browsers at the console's application, in memory, each with the session of a user."""

from __future__ import annotations

import asyncio
from types import TracebackType
from typing import Any, Self

from jauspy.console.users import Session, User, current


class BrowserSocket:
    """A socket that is open in its context; `said` has the texts and bytes that were received, `code` why it closed."""

    def __init__(self, app: Any, path: str, user: User) -> None:
        self.said: list[Any] = []
        self.code: int | None = None
        self.error: BaseException | None = None
        self._app, self._user = app, user
        self._scope = {
            "type": "websocket",
            "path": path,
            "raw_path": path.encode(),
            "query_string": b"",
            "headers": [],
            "scheme": "ws",
            "root_path": "",
            "subprotocols": [],
            "client": ("127.0.0.1", 1),
            "server": ("127.0.0.1", 80),
        }
        self._inbox: asyncio.Queue[dict[str, Any]] = asyncio.Queue()

    async def __aenter__(self) -> Self:
        self._inbox.put_nowait({"type": "websocket.connect"})
        self._task = asyncio.create_task(self._serve())
        await self.settled()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._inbox.put_nowait({"type": "websocket.disconnect", "code": 1001})
        async with asyncio.timeout(10.0):
            await self._task
        if self.error is not None and error is None:
            raise self.error

    def send(self, data: str | bytes) -> None:
        """Send a message of the browser."""
        self._inbox.put_nowait({"type": "websocket.receive", "text" if isinstance(data, str) else "bytes": data})

    async def settled(self) -> None:
        """Return when everything that was sent has been read, or the socket is closed."""
        async with asyncio.timeout(10.0):
            while not self._inbox.empty() and not self._task.done():
                await asyncio.sleep(0.0)
        for _ in range(3):
            await asyncio.sleep(0.0)

    async def _serve(self) -> None:
        current.set(Session(self._user, "127.0.0.1"))
        try:
            await self._app(self._scope, self._inbox.get, self._send)
        except BaseException as error:  # noqa: BLE001 - raised at the end of the context
            self.error = error

    async def _send(self, message: dict[str, Any]) -> None:
        if message["type"] == "websocket.send":
            self.said.append(message.get("text") or message.get("bytes"))
        elif message["type"] == "websocket.close":
            self.code = message["code"]
