"""Whom a verb talks to, and as whom."""

from __future__ import annotations

import errno
import socket
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Final

from jauspy.cli.options import DEFAULT_ROOT

if TYPE_CHECKING:
    from jauspy.codec.registry import Registry
    from jauspy.ids import JausID
    from jauspy.ocu import OCU

SUBSYSTEM: Final = 42
NODE: Final = 1
ATTEMPTS: Final = 6
"""Questions that share the time a verb waits for answers, for packets get lost."""
_FIRST, _LAST = 2, 254  # 42.1.1 is left to programs, as the one in README


def destination(text: str) -> JausID:
    """The id of a component, or of several with wildcards; `ConfigError` for what can be nobody's."""
    from jauspy.errors import ConfigError
    from jauspy.ids import JausID

    id = JausID.parse(text)
    if 0 in (id.subsystem, id.node, id.component):
        raise ConfigError(
            f"{id} is nobody's id: no part may be 0; 65535, 255 and 255 stand for all; `jauspy ls` shows who is there"
        )
    return id


def own_id(given: str | None, connect: str | None) -> str:
    """The id to speak as: the given one, else the first that nothing else on this machine uses now.

    The first and not any: an emergency can only be cleared by the id that set it.
    """
    from jauspy.ids import JausID
    from jauspy.transport import local as local_socket

    if given is not None:
        return given
    root = Path(connect.removeprefix("local:")) if connect and connect.startswith("local:") else DEFAULT_ROOT
    ids = [JausID(SUBSYSTEM, NODE, component) for component in range(_FIRST, _LAST + 1)]
    return str(
        next((id for id in ids if not local_socket.is_alive(root / str(int(id))) and _claim(id, connect)), ids[0])
    )


def client(given: str | None, connect: str | None, timeout: float, registry: Registry | None = None) -> OCU:
    """An OCU that waits so many seconds for an answer, with the id of `own_id`."""
    from jauspy.ocu import OCU

    id = own_id(given, connect)
    return OCU(id, connect, timeout=timeout / ATTEMPTS, retries=ATTEMPTS - 1, registry=registry)


def _claim(id: JausID, connect: str | None) -> bool:
    """Take the id for this process; false when another verb has it. It is free again when the process ends.

    Over UDP nothing else tells: two clients with one id would get each other's answers.
    """
    where = zlib.crc32((connect or "").encode())
    claim = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    try:
        claim.bind(f"\0jauspy.{where:x}.{id}")  # a name without a file, as Linux has them; elsewhere nothing is claimed
    except OSError as error:
        claim.close()
        return error.errno != errno.EADDRINUSE
    _claims.append(claim)
    return True


_claims: Final[list[socket.socket]] = []
