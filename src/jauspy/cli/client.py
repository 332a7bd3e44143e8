"""The JAUS id of a verb's client, its OCU, and the id of the component that it addresses."""

from __future__ import annotations

import errno
import socket
import zlib
from pathlib import Path
from typing import Final

from jauspy.cli.options import DEFAULT_ROOT
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.peers import find_kind
from jauspy.ocu import OCU
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.sources import MOVE_TIMEOUT
from jauspy.transport import local as local_socket, node_status

SUBSYSTEM: Final = 42
NODE: Final = 1
ATTEMPTS: Final = 6
"""A query is sent this many times within `--timeout`, because packets may be lost."""
FIRST_COMPONENT, LAST_COMPONENT = 2, 254  # 42.1.1 is left to programs, such as the one in README


def destination(text: str) -> JausID:
    """The id of a component, or of several with wildcards; raises `ConfigError` if a part is 0."""
    id = JausID.parse(text)
    if 0 in (id.subsystem, id.node, id.component):
        raise ConfigError(
            f"{id} is not the id of a component: no part may be 0; 65535, 255 and 255 are wildcards; `jauspy ls` lists "
            "the components on the network"
        )
    return id


def own_id(given: str | None, connect: str | None) -> str:
    """The client's id: the given one, else the first from 42.1.2 that no process uses, here or elsewhere.

    Successive verbs get the same id, because an emergency can only be cleared by the id that set it.
    """
    if given is not None:
        return given
    root = local_root(connect) or DEFAULT_ROOT
    elsewhere = ids_elsewhere(connect)
    ids = [JausID(SUBSYSTEM, NODE, component) for component in range(FIRST_COMPONENT, LAST_COMPONENT + 1)]
    free = (id for id in ids if str(id) not in elsewhere and not local_socket.is_alive(root / str(int(id))))
    return str(next((id for id in free if _claim(id, connect)), ids[0]))


def ids_elsewhere(connect: str | None) -> set[str]:
    """Ids that another host uses, so that the node manager does not assign them on this machine."""
    root = local_root(connect)
    if root is None:
        return set()
    this_machine = node_status.this_machine()
    return {
        str(peer["id"])
        for peer in node_status.read_at_once(root).get("peers", ())
        if peer["heard"] is not None
        and peer["heard"] < MOVE_TIMEOUT
        and not this_machine.has(node_status.host_of(str(peer["address"])))
    }


def local_root(connect: str | None) -> Path | None:
    """The directory of the local sockets that `connect` means, None for other connections."""
    if connect is None:
        return DEFAULT_ROOT
    return Path(connect.removeprefix("local:")) if connect.startswith("local:") else None


def make_ocu(
    given: str | None,
    connect: str | None,
    timeout: float,
    registry: Registry | None = None,
    *,
    operator: Path | None = None,
    peer: str | None = None,
) -> OCU:
    """An OCU with the id of `own_id` that waits `timeout` seconds for an answer; `peer` names the kind to oblige."""
    limit = None if peer is None else find_kind(peer).max_message
    delivery = None if limit is None else Delivery(max_message=limit)
    id = own_id(given, connect)
    return OCU(
        id,
        connect,
        timeout=timeout / ATTEMPTS,
        retries=ATTEMPTS - 1,
        registry=registry,
        operator=operator,
        delivery=delivery,
    )


def _claim(id: JausID, connect: str | None) -> bool:
    """Reserve the id until this process ends; false if another verb has reserved it.

    Two UDP clients with the same id would receive each other's answers.
    """
    where = zlib.crc32((connect or "").encode())
    claim = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    try:
        claim.bind(f"\0jauspy.{where:x}.{id}")  # an abstract socket (Linux); elsewhere nothing is reserved
    except OSError as error:
        claim.close()
        return error.errno != errno.EADDRINUSE
    _claims.append(claim)
    return True


_claims: Final[list[socket.socket]] = []
