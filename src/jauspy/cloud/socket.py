"""Publishing and subscribing to clouds: PUB and SUB sockets of nanomsg, by `pynng`."""

from __future__ import annotations

import importlib
import secrets
import time
from collections import Counter
from types import ModuleType, TracebackType
from typing import Any, Final, Self

from jauspy.cloud.message import Cloud, decode
from jauspy.errors import ConfigError, DecodeError, TransportError

SEND_QUEUE_SIZE: Final = 8
"""Messages queued for a slow subscriber; further ones are lost, which shows as gaps in the numbers."""
MAX_MESSAGE_SIZE: Final = 32_000_000
"""Bytes of a message that a subscriber accepts; a million coloured points are 24 MB."""


def _pynng() -> ModuleType:
    try:
        return importlib.import_module("pynng")
    except ImportError as error:
        raise ConfigError("point clouds need pynng: pip install 'jauspy[cloud]'") from error


class _Socket:
    _socket: Any

    def close(self) -> None:
        """Close the socket; without effect when closed."""
        self._socket.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


class CloudPublisher(_Socket):
    """Listens at an address such as `tcp://127.0.0.1:5565` or `ipc:///tmp/cloud` for any number of subscribers.

    Raises `ConfigError` without pynng, `TransportError` when it cannot listen there.
    """

    def __init__(self, address: str) -> None:
        nng = _pynng()
        self._socket = nng.Pub0(send_buffer_size=SEND_QUEUE_SIZE)
        try:
            self._socket.listen(address)
        except nng.NNGException as error:
            self._socket.close()
            raise TransportError(f"{address}: cannot publish there: {error}") from error
        self._stream = secrets.randbits(32)
        self._number = 0

    def publish(self, points: bytes, frame: str, at: float, values: int = 3) -> None:
        """Send to all subscribers without waiting; `points` and `values` as in `Cloud`, `at` is its time."""
        self._socket.send(Cloud(points, frame, at, values, self._stream, self._number).encode())
        self._number += 1


class CloudSubscriber(_Socket):
    """Receives the clouds published at an address; reconnects when the publisher was away."""

    def __init__(self, address: str) -> None:
        nng = _pynng()
        self._timeout = nng.Timeout
        self._socket = nng.Sub0(topics=b"", recv_buffer_size=SEND_QUEUE_SIZE, recv_max_size=MAX_MESSAGE_SIZE)
        try:
            self._socket.dial(address, block=False)
        except nng.NNGException as error:
            self._socket.close()
            raise ConfigError(f"{address}: no address to subscribe to, as in tcp://127.0.0.1:5565: {error}") from error
        self._last: Cloud | None = None
        self.counters: Counter[str] = Counter()
        """Clouds `received`; those `lost` by their numbers; `malformed` messages; `restarts` of the publisher."""

    def receive(self, timeout: float) -> Cloud | None:
        """The next cloud; None after `timeout` seconds. Malformed messages are counted and skipped."""
        until = time.monotonic() + timeout
        while True:
            self._socket.recv_timeout = max(1, round((until - time.monotonic()) * 1000.0))
            try:
                cloud = decode(self._socket.recv())
            except self._timeout:
                return None
            except (DecodeError, RuntimeError):  # pynng raises RuntimeError for an empty message
                self.counters["malformed"] += 1
                if time.monotonic() >= until:
                    return None
            else:
                self._count(cloud)
                return cloud

    def _count(self, cloud: Cloud) -> None:
        last, self._last = self._last, cloud
        self.counters["received"] += 1
        if last is not None and last.stream != cloud.stream:
            self.counters["restarts"] += 1
        elif last is not None:
            self.counters["lost"] += max(0, cloud.number - last.number - 1)
