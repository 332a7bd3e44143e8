"""Serial lines (JSerial): a link that reopens its device, and a component's transport. Needs the extra `serial`."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import jserial, judp
from jauspy.protocol.counters import Counters
from jauspy.transport.age import MAX_AGE, StallDetector
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.send_queue import QueueMemory, SendQueue

if TYPE_CHECKING:
    import serial

_LOG = get_logger(__name__)

READ_SIZE: Final = 4096
REOPEN_INTERVAL: Final = 1.0


@dataclass(frozen=True, slots=True)
class SerialLine:
    """Settings of a serial device with 8 data bits; `parity` is N, E or O, `stop_bits` 1 or 2."""

    device: str
    baud_rate: int = 19200
    parity: str = "N"
    stop_bits: int = 1
    hardware_flow_control: bool = False
    software_flow_control: bool = False


class SerialLink:
    """Sends datagrams, and calls `received(datagram)` for each received one.

    While the device is missing, datagrams are dropped, and opening is retried. After the event loop was blocked for
    more than `max_age` seconds, what the device has received is dropped.
    """

    def __init__(
        self,
        line: SerialLine,
        counters: Counters,
        received: Callable[[bytes], None],
        *,
        max_age: float = MAX_AGE,
        memory: QueueMemory | None = None,
    ) -> None:
        self.line = line
        self._counters = counters
        self._received = received
        self._loop = asyncio.get_running_loop()
        self._port: serial.Serial | None = None
        self._decoder = jserial.FrameDecoder()
        self._waiting = SendQueue(max_age=max_age, memory=memory)
        self._stall = StallDetector(max_age)
        self._rest = b""
        self._retry: asyncio.TimerHandle | None = None

    @property
    def connected(self) -> bool:
        """True while the device is open."""
        return self._port is not None

    @property
    def waiting(self) -> int:
        """The number of queued packets."""
        return len(self._waiting)

    def open(self) -> None:
        """Open the device; raises `TransportError`."""
        try:
            import serial  # noqa: PLC0415 - an extra
        except ImportError:
            raise TransportError("serial ports need pyserial; install it with: pip install 'jauspy[serial]'") from None
        line = self.line
        try:
            self._port = serial.Serial(
                line.device,
                line.baud_rate,
                parity=line.parity,
                stopbits=line.stop_bits,
                rtscts=line.hardware_flow_control,
                xonxoff=line.software_flow_control,
                timeout=0,
                exclusive=True,
            )
        except (serial.SerialException, ValueError, OSError) as error:
            raise TransportError(
                f"cannot open the serial port {line.device}: {error}; check its name, its users and your permissions"
            ) from error
        self._decoder = jserial.FrameDecoder()
        self._loop.add_reader(self._port.fileno(), self._read)

    def close(self) -> None:
        """Close the device; a second call does nothing."""
        if self._retry is not None:
            self._retry.cancel()
            self._retry = None
        self._stall.close()
        self._release()

    def send(self, datagram: bytes) -> bool:
        """Send a checked datagram of one packet as soon as the line has room; false when it was dropped."""
        if self._port is None:
            self._counters.drop("serial_closed", self.line.device)
            return False
        idle = not self._rest and not self._waiting
        for _ in self._waiting.push(datagram):
            self._counters.drop("queue_full", self.line.device)
        if idle:
            self._write()
        return True

    def _read(self) -> None:
        if self._port is None:
            return
        if self._stall.has_stalled:
            self._counters.drop("stale", self.line.device)
            self._port.reset_input_buffer()
            self._decoder = jserial.FrameDecoder()
        try:
            data = os.read(self._port.fileno(), READ_SIZE)
        except BlockingIOError:
            return
        except OSError as error:
            self._lost(error)
            return
        if not data:
            self._lost(OSError("the device has hung up"))
            return
        datagrams, errors = self._decoder.feed(data)
        for problem in errors:
            self._counters.drop(f"malformed.{problem.reason}", problem)
        for datagram in datagrams:
            self._received(datagram)

    def _write(self) -> None:
        """Write as much as the line has room for; the rest of a frame is written first next time."""
        for _ in range(self._waiting.drop_stale()):
            self._counters.drop("stale", self.line.device)
        while self._port is not None and (self._rest or self._waiting):
            if not self._rest:
                self._rest = jserial.frame(self._waiting.peek())
                self._waiting.pop()
            try:
                written = os.write(self._port.fileno(), self._rest)
            except BlockingIOError:
                written = 0
            except OSError as error:
                self._lost(error)
                return
            self._rest = self._rest[written:]
            if self._rest:
                self._loop.add_writer(self._port.fileno(), self._write)
                return
        if self._port is not None:
            self._loop.remove_writer(self._port.fileno())

    def _lost(self, error: OSError) -> None:
        self._counters["serial.lost"] += 1
        _LOG.warning("serial port %s: %s", self.line.device, error)
        self._release()
        self._retry = self._loop.call_later(REOPEN_INTERVAL, self._reopen)

    def _reopen(self) -> None:
        self._retry = None
        try:
            self.open()
        except TransportError:
            self._retry = self._loop.call_later(REOPEN_INTERVAL, self._reopen)
        else:
            self._counters["serial.reopened"] += 1

    def _release(self) -> None:
        port, self._port = self._port, None
        for _ in range(self._waiting.clear()):
            self._counters.drop("serial_closed", self.line.device)
        self._rest = b""
        if port is not None:
            self._loop.remove_reader(port.fileno())
            self._loop.remove_writer(port.fileno())
            port.close()


class SerialTransport:
    """A component's transport over one serial line to a node manager."""

    def __init__(self, id: JausID, line: SerialLine) -> None:
        self.id = id
        self.received: Receiver = ignore
        self.max_age = MAX_AGE
        self._line = line
        self._counters = Counters(_LOG)
        self._link: SerialLink | None = None

    @property
    def connected(self) -> bool:
        """True while the device is open; a serial line has no other state."""
        return self._link is not None and self._link.connected

    @property
    def waiting(self) -> int:
        """The number of queued packets."""
        return 0 if self._link is None else self._link.waiting

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""
        return self._counters

    async def open(self) -> None:
        """Open the device; raises `TransportError` when it cannot be used."""
        link = SerialLink(self._line, self._counters, self._take, max_age=self.max_age)
        link.open()
        self._link = link

    async def close(self) -> None:
        """Close the device."""
        link, self._link = self._link, None
        if link is not None:
            link.close()

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; the connection is kept."""
        on_leave()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send each packet in a frame of its own; counted when dropped."""
        if self._link is None:
            self._counters.drop("closed")
            return
        try:
            packets = [datagram[:1] + datagram[raw.start : raw.end] for raw in judp.headers(datagram)]
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        for packet in packets:
            self._counters["sent"] += self._link.send(packet)

    def _take(self, datagram: bytes) -> None:
        self._counters["received"] += 1
        self.received(datagram)
