"""The status of a running node manager: a Unix stream socket that says one JSON document to whoever connects."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from jauspy.errors import TransportError
from jauspy.node.state import NodeState
from jauspy.transport import local as local_socket

SOCKET_NAME: Final = "JuniorRTE.status"
"""Beside the node manager's own socket."""
PATIENCE: Final = 2.0
"""Seconds that a reader may take."""
MAX_READERS: Final = 8
RATE_INTERVAL: Final = 0.5
"""Seconds between the two looks that rates are made from."""


class StatusServer:
    """Read-only: nothing that a reader sends is looked at."""

    def __init__(self, path: Path, mode: int, group: str | None, state: Callable[[], NodeState]) -> None:
        self._path = path
        self._mode = mode
        self._group = group
        self._state = state
        self._started = asyncio.get_running_loop().time()
        self._readers = 0
        self._server: asyncio.Server | None = None

    async def __aenter__(self) -> None:
        try:
            self._path.unlink(missing_ok=True)
            self._server = await asyncio.start_unix_server(self._serve, self._path)
            self._path.chmod(self._mode)
        except OSError as error:
            told = f"cannot open the socket {self._path}: {error.strerror}"
            raise TransportError(f"{told}; {local_socket.OTHER_DIRECTORY}, or set `status` to false") from error
        local_socket.give_to_group(self._path, self._group)

    async def __aexit__(self, *error: object) -> None:
        if self._server is not None:
            self._server.close()
        self._path.unlink(missing_ok=True)

    async def _serve(self, _: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._readers += 1
        try:
            if self._readers <= MAX_READERS:
                writer.write(json.dumps(self._state().as_dict(self._started)).encode() + b"\n")
                async with asyncio.timeout(PATIENCE):
                    await writer.drain()
                    writer.close()
                    await writer.wait_closed()
        except (OSError, TimeoutError):
            writer.transport.abort()
        finally:
            self._readers -= 1
            writer.close()


async def read(root: Path) -> dict[str, Any]:
    """The status of the node manager at this local root; raises `TransportError` when there is none."""
    path = root / SOCKET_NAME
    try:
        async with asyncio.timeout(PATIENCE):
            reader, writer = await asyncio.open_unix_connection(path)
            text = await reader.read()
            writer.close()
    except (OSError, TimeoutError) as error:
        raise TransportError(
            f"no node manager tells its status at {path}: {getattr(error, 'strerror', None) or 'no answer'}; "
            "is it running, with `status` on, and is this its --local-root?"
        ) from None
    status: dict[str, Any] = json.loads(text)
    return status


def with_rates(before: dict[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """The later of two looks, with what was counted per second between them as `rates`."""
    seconds = max(after["uptime"] - before["uptime"], 1e-3)
    counted = after["counters"]
    rates = {name: round((count - before["counters"].get(name, 0)) / seconds, 1) for name, count in counted.items()}
    return after | {"rates": rates}
