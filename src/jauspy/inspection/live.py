"""The traffic that a node manager of this machine routes now, from the socket of its mirror."""

from __future__ import annotations

import io
import socket
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.errors import ConfigError, TransportError
from jauspy.transport.node_status import MIRROR_NAME


class LiveCapture(CaptureReader):
    """A capture of what a node manager routes, datagram by datagram, while its iteration waits for them.

    It ends with the node manager, or `seconds` after it was opened. `lost` counts the packets that this reader was too
    slow for.

    Raises:
        TransportError: no node manager mirrors there, or this user may not read it.
    """

    def __init__(self, root: Path, seconds: float | None = None) -> None:
        path = root / MIRROR_NAME
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            sock.connect(str(path))
        except OSError as error:
            sock.close()
            raise TransportError(
                f"no node manager shows its traffic at {path}: {error.strerror}; is it running, with `mirror_socket` "
                "on, and is this its --local-root?"
            ) from None
        self._raw = _UntilDeadline(sock, seconds)
        self._stream = io.BufferedReader(self._raw)
        super().__init__(self._stream, name=str(path), port=None)

    def __iter__(self) -> Iterator[Datagram]:
        try:
            yield from super().__iter__()
        except ConfigError:
            if not self._raw.ended:  # the end may be in the middle of a block
                raise

    def stop(self) -> None:
        """End the iteration, which may wait in another thread."""
        self._raw.stop()

    def close(self) -> None:
        """Stop."""
        self._stream.close()


class _UntilDeadline(io.RawIOBase):
    """A socket's bytes, which end at a deadline or with the connection."""

    def __init__(self, sock: socket.socket, seconds: float | None) -> None:
        self._socket = sock
        self._end = None if seconds is None else time.monotonic() + seconds
        self.ended = False

    def readable(self) -> bool:
        """True."""
        return True

    def readinto(self, buffer: Any) -> int:
        """Wait for bytes; 0 at the end."""
        if self._end is not None:
            self._socket.settimeout(max(1e-6, self._end - time.monotonic()))
        try:
            count = self._socket.recv_into(buffer)
        except TimeoutError:
            count = 0
        self.ended = not count
        return count

    def stop(self) -> None:
        """End the wait for bytes."""
        with suppress(OSError):  # ended already
            self._socket.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
        super().close()
