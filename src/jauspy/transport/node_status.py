"""Reads the status of the node manager of a local root, and finds in it where components are."""

from __future__ import annotations

import asyncio
import json
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.protocol.addressing import UNKNOWN_LOCATION, Location
from jauspy.transport import multicast

SOCKET_NAME: Final = "JuniorRTE.status"
"""Name of the status socket, in the directory of the node manager's own one."""
MIRROR_NAME: Final = "JuniorRTE.mirror"
"""Name of the socket with the copy of the routed packets."""
READ_TIMEOUT: Final = 2.0
"""Seconds for one reader."""
SHORT_READ_TIMEOUT: Final = 0.25
"""Seconds between two parts of a status that is only a hint."""
READ_INTERVAL: Final = 0.5
"""Seconds between two reads for one component, so that many requests do not keep the node manager busy."""
MAX_STATUS: Final = 8 << 20
"""Bytes."""
MAX_LEFT_OUT: Final = 32
"""Messages of a link whose numbers are told."""
MAX_LOOKUPS: Final = 64
"""Concurrent lookups; the location of further components is unknown."""


async def read(root: Path) -> dict[str, Any]:
    """The status of the node manager of a local root; raises `TransportError` if it does not answer."""
    path = root / SOCKET_NAME
    try:
        async with asyncio.timeout(READ_TIMEOUT):
            reader, writer = await asyncio.open_unix_connection(path)
            try:
                text = bytearray()
                while len(text) <= MAX_STATUS and (part := await reader.read(1 << 16)):
                    text += part
            finally:
                writer.transport.abort()  # nothing was written
        status = _parsed(text)
    except (OSError, TimeoutError, TypeError, ValueError) as error:
        raise TransportError(
            f"no node manager serves its status at {path}: {getattr(error, 'strerror', None) or 'no answer'}; "
            "is it running, with `status` on, and is this its --local-root?"
        ) from None
    return status


def read_at_once(root: Path) -> dict[str, Any]:
    """Same as `read`, without an event loop; empty if there is no status soon."""
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as sock:
            sock.settimeout(SHORT_READ_TIMEOUT)
            sock.connect(str(root / SOCKET_NAME))
            text = bytearray()
            while len(text) <= MAX_STATUS and (part := sock.recv(1 << 16)):
                text += part
            return _parsed(text)
    except (OSError, TypeError, ValueError):
        return {}


def _decoded(text: bytes | bytearray) -> Any:
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None


def _parsed(text: bytes | bytearray) -> dict[str, Any]:
    """The parsed status.

    Raises `TypeError` or `ValueError` for other content, which any program that may write to the root can serve.
    """
    if len(text) > MAX_STATUS:
        raise ValueError(f"longer than {MAX_STATUS} bytes")
    status = _decoded(text)
    if not isinstance(status, dict):
        raise TypeError("not an object")
    for name, keys in (("components", ("id",)), ("peers", ("id", "address", "heard"))):
        rows = status.get(name, [])
        if not isinstance(rows, list) or not all(isinstance(row, dict) and row.keys() >= {*keys} for row in rows):
            raise ValueError(f"{name} is not a list of objects with {', '.join(keys)}")
    return status


class Locator:
    """Looks up where components are: what the node manager has learned, and all addresses of this machine.

    Requests that arrive during a read share the next one.
    """

    def __init__(self, root: Path) -> None:
        self._root = root
        self._requests: list[tuple[JausID, Callable[[Location], None], bool]] = []
        self._task: asyncio.Task[None] | None = None

    def locate(self, id: JausID, found: Callable[[Location], None], *, is_here: bool = False) -> None:
        """Call `found` with the location, in a later turn of the event loop unless there are too many requests.

        `is_here`: the component is known to be on this machine, regardless of the status.
        """
        if len(self._requests) >= MAX_LOOKUPS:
            found(this_machine() if is_here else UNKNOWN_LOCATION)
            return
        self._requests.append((id, found, is_here))
        if self._task is None:
            self._task = asyncio.get_running_loop().create_task(self._answer(), name="locate")

    def close(self) -> None:
        """Stop; pending requests are not answered."""
        self._requests.clear()
        if self._task is not None:
            self._task.cancel()
            self._task = None

    async def _answer(self) -> None:
        while self._requests:
            requests, self._requests = self._requests, []
            try:
                status = await read(self._root)
            except TransportError:  # a node manager of others, or none
                status = {}
            local = this_machine()._replace(ports=_ports(status.get("networks", ())))
            components = {str(component["id"]): component for component in status.get("components", ())}
            peers = {str(peer["id"]): peer for peer in status.get("peers", ())}
            queues = _send_queues(status.get("networks", ()))
            left_out = _left_out(status.get("left_out", ()))
            for id, found, is_here in requests:
                if is_here or str(id) in components:
                    found(local._replace(waiting=_number(components.get(str(id), {}).get("waiting_bytes"))))
                    continue
                peer = peers.get(str(id))
                location = _location(None if peer is None else str(peer["address"]), local)
                if peer is not None:
                    waiting = queues.get(str(peer.get("network")))
                    location = location._replace(sent=_number(peer.get("sent_bytes")), waiting=waiting)
                    location = location._replace(left_out=tuple(left_out.get(str(peer.get("link")), {}).items()))
                found(location)
            await asyncio.sleep(READ_INTERVAL)
        self._task = None


def _number(value: object) -> int | None:
    """A count of a status; None for anything else."""
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None


def _send_queues(networks: object) -> dict[str, int]:
    """Bytes that wait to be sent, by network."""
    rows = networks if isinstance(networks, list) else []
    found = {str(row.get("name")): _number(row.get("send_queue")) for row in rows if isinstance(row, dict)}
    return {name: size for name, size in found.items() if size is not None}


def _left_out(rows: object) -> dict[str, dict[str, int]]:
    """Numbers of messages that were left out, by link and message; of a link the first `MAX_LEFT_OUT`."""
    found: dict[str, dict[str, int]] = {}
    for row in rows if isinstance(rows, list) else []:
        if isinstance(row, dict) and (count := _number(row.get("count"))) is not None:
            of_link = found.setdefault(str(row.get("link")), {})
            message = str(row.get("message"))
            if message in of_link or len(of_link) < MAX_LEFT_OUT:
                of_link[message] = of_link.get(message, 0) + count
    return found


def this_machine() -> Location:
    """The location of this process, with all addresses of its machine."""
    return Location(is_here=True, hosts=multicast.own_addresses())


def host_of(address: str) -> str:
    """The host of an address in a status, as in `192.168.1.20:3794` and `[fe80::1]:3794`."""
    return address.rpartition(":")[0].strip("[]")


def _location(address: str | None, local: Location) -> Location:
    if address is None:
        return Location(ports=local.ports)
    host, ports = host_of(address), local.ports | _ports([{"address": address}])
    return local._replace(ports=ports) if local.has(host) else Location(hosts=frozenset({host}), ports=ports)


def _ports(rows: object) -> frozenset[int]:
    """The ports of the addresses in a part of a status."""
    listed = rows if isinstance(rows, list) else []
    parts = (str(entry.get("address")).rpartition(":") for entry in listed if isinstance(entry, dict))
    return frozenset(int(port) for host, _, port in parts if host and port.isdecimal() and len(port) < 6)
