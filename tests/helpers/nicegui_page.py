"""A page of the console without a browser: loads it, and speaks on the socket of NiceGUI."""

from __future__ import annotations

import asyncio
import json
import re
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self

from tests.helpers.console_visit import Visit
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

_CLIENT = re.compile(r"client_id[^0-9a-z]{1,20}([0-9a-f-]{36})")
_TOKEN = re.compile(r'data-token="([\w-]+)"')


@dataclass(frozen=True)
class Loaded:
    """The page as it was loaded."""

    text: str

    @property
    def client(self) -> str:
        """The id of NiceGUI's client."""
        found = _CLIENT.search(self.text)
        assert found, "the page has the id of its client"
        return found[1]

    @property
    def has_place(self) -> bool:
        """True for a page that starts its script with a token, false when too many pages are open."""
        return _TOKEN.search(self.text.replace("\\", "")) is not None


async def load(visit: Visit) -> Loaded:
    """Load the page, which opens no socket."""
    return Loaded(await asyncio.to_thread(visit.get))


class PageSocket:
    """The socket of a page, after its handshake; `is_closed` when the console has closed it."""

    def __init__(self, visit: Visit, client: str) -> None:
        query = f"EIO=4&transport=websocket&client_id={client}"
        self._address = f"{visit.sockets}/_nicegui_ws/socket.io/?{query}"
        self._visit = visit
        self._client = client
        self.is_closed = False

    async def __aenter__(self) -> Self:
        self._socket: ClientConnection = await connect(
            self._address, origin=self._visit.url, additional_headers=self._visit.headers, max_size=None
        )
        await self.raw("40")
        handshake = {"client_id": self._client, "tab_id": "tab", "document_id": "document", "next_message_id": 0}
        await self.raw(f"420{json.dumps(['handshake', handshake])}")
        self._reading = asyncio.create_task(self._read())
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._reading.cancel()
        await self._socket.close()

    async def raw(self, text: str | bytes) -> None:
        """Send a packet of Engine.IO."""
        try:
            await self._socket.send(text)
        except ConnectionClosed:
            self.is_closed = True

    async def emit(self, name: str, **content: Any) -> None:
        """Send an event of Socket.IO."""
        await self.raw(f"42{json.dumps([name, {'client_id': self._client, **content}])}")

    async def _read(self) -> None:
        try:
            async for text in self._socket:
                if text == "2":
                    await self.raw("3")
        except ConnectionClosed:
            pass
        self.is_closed = True
