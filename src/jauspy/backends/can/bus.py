"""Buses of python-can, named as in `socketcan:can0`, and the wire in this process that replaces one (`virtual:`)."""

from __future__ import annotations

import errno
import inspect
import ipaddress
import logging
import os
import socket
import sys
import threading
import time
from collections import Counter, deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any, Final, cast

import can
import canopen
from can.interfaces import BACKENDS

from jauspy.errors import ConfigError
from jauspy.logs import get_logger

_LOG: Final = get_logger("jauspy.can")

VIRTUAL: Final = "virtual"
"""Simulated drives in this process."""

ECHOING: Final = frozenset({"udp_multicast"})
"""Interfaces that echo sent frames."""

IP_MULTICAST_ALL: Final = 49
"""Option of Linux: receive the groups that any program has joined (linux/in.h). Python does not name it."""

IPV6_MULTICAST_ALL: Final = 29
"""The same for IPv6 (linux/in6.h)."""

OPEN: Final = frozenset({"udp_multicast"})
"""Interfaces on which each program of the network may send, and also frames that say that the bus has failed."""


def split(bus: str) -> tuple[str, str, dict[str, Any]]:
    """Interface, channel and options of `udp_multicast:239.0.0.1,port=43200`; raises `ConfigError`."""
    interface, colon, rest = bus.partition(":")
    channel, *pairs = rest.split(",")
    options: dict[str, Any] = {}
    for pair in pairs:
        key, equals, value = pair.partition("=")
        if not equals or not key.isidentifier():
            raise ConfigError(f"can.bus = {bus!r}: write options as KEY=VALUE, as in ,port=43200")
        options[key] = int(value) if value.isdigit() else value
    if not colon or not channel or interface not in (VIRTUAL, *can.VALID_INTERFACES):
        raise ConfigError(
            f"can.bus = {bus!r}: write INTERFACE:CHANNEL, as in socketcan:can0, udp_multicast:239.0.0.1, "
            f"slcan:/dev/ttyACM0 or virtual:motors; interfaces are: {', '.join(sorted(can.VALID_INTERFACES))}"
        )
    return interface, channel, options


NO_BIT_RATE: Final = frozenset({"udp_multicast", "socketcan", "socketcand"})
"""Interfaces whose bit rate is set elsewhere, as by `ip link`."""

HINTS: Final = {
    errno.EAFNOSUPPORT: "this kernel has no CAN: load its modules can, can_raw and that of the adapter",
    errno.ENODEV: "there is no such interface: plug the adapter in; `ip link show type can` lists them",
    errno.ENETDOWN: "it is down: `ip link set can0 up type can bitrate 1000000`",
    errno.ENOENT: "there is no such device: plug the adapter in, and look for its name in /dev",
    errno.EACCES: "your user may not use it: `sudo usermod -aG dialout $USER`, and log in again",
    errno.EPERM: "your user may not use it",
}
"""Advice for errors of the kernel."""

SO_RCVBUFFORCE: Final = 33
"""Socket option of Linux that the module socket lacks; for root."""

RECEIVE_BUFFER: Final = 2**22
"""Size of the kernel's receive buffer: frames of half a second, for a program that is blocked."""


def open_bus(bus: str, bit_rate: int) -> can.BusABC:
    """Open a bus of python-can. Raises `ConfigError` with the error of the kernel or the package, and what to do."""
    interface, channel, options = split(bus)
    with _quiet():
        try:
            _check_options(bus, interface, options)
            if interface not in NO_BIT_RATE:
                options.setdefault("bitrate", bit_rate)
            opened = can.Bus(channel, interface=interface, **options)
        except ConfigError:
            raise
        except Exception as error:  # noqa: BLE001 - drivers raise what they like, as NameError without their library
            why = describe(error, interface)
        else:
            _enlarge_buffer(opened)
            if interface in OPEN:
                _leave_other_groups(opened)
                _warn_if_reachable(bus, channel)
            return opened
    raise ConfigError(f"can.bus = {bus!r}: cannot be opened: {why}")


def _leave_other_groups(bus: can.BusABC) -> None:
    """Receive this bus's group only: Linux passes on those of all programs, and robots would move others' drives."""
    if sys.platform != "linux":
        return
    with socket.socket(fileno=os.dup(bus.fileno())) as copy:
        if copy.family == socket.AF_INET6:
            copy.setsockopt(socket.IPPROTO_IPV6, IPV6_MULTICAST_ALL, 0)
        else:
            copy.setsockopt(socket.IPPROTO_IP, IP_MULTICAST_ALL, 0)


def _warn_if_reachable(bus: str, group: str) -> None:
    if address := reachable_at(group):
        _LOG.warning(
            "%s has no authentication and is reachable at %s: each machine of that network can move the drives; use it "
            "for simulated drives only, or route the group to the loopback interface (docs/hardware.md)",
            bus,
            address,
        )


def reachable_at(group: str) -> str:
    """The address of this machine at which a multicast group is joined; empty for one of the loopback interface."""
    try:
        family, _, _, _, where = socket.getaddrinfo(group, 9, type=socket.SOCK_DGRAM)[0]
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            probe.connect(where)  # sends nothing
            address = str(probe.getsockname()[0])
        return "" if ipaddress.ip_address(address.partition("%")[0]).is_loopback else address
    except (OSError, ValueError) as error:
        return f"an unknown address ({error})"


def hint(error: BaseException) -> str:
    """Advice for an error of the kernel; empty if none is known."""
    numbers = (getattr(cause, key, None) for cause in (error, error.__cause__) for key in ("errno", "error_code"))
    return next((HINTS[number] for number in numbers if number in HINTS), "")


def describe(error: BaseException, interface: str = "") -> str:
    """The text of a bus error, with what to do if that is known."""
    cause = error.__cause__
    text = f"{error}" or type(error).__name__
    if isinstance(error, NameError) or (interface and f"can.interfaces.{interface}" in text):
        return f"{text}; install what python-can needs for {interface}: its driver or package"
    if isinstance(cause, OSError) and f"{cause.strerror}" not in text:
        text = f"{text}: {cause.strerror}"
    return f"{text} ({what})" if (what := hint(error)) else text


@contextmanager
def _quiet() -> Iterator[None]:
    """Suppress python-can's log about a bus that cannot be opened; the exception contains the reason."""
    logger = logging.getLogger("can")
    level = logger.level
    logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        logger.setLevel(level)


def _check_options(bus: str, interface: str, options: dict[str, Any]) -> None:
    """Refuse options that the interface does not have: python-can ignores them."""
    if not options:
        return
    module, name = BACKENDS[interface]
    known: set[str] = set()
    for base in getattr(import_module(module), name).__mro__:
        known |= set(inspect.signature(base.__init__).parameters)
    known -= {"self", "args", "kwargs", "channel"}
    if unknown := [key for key in options if key not in known]:
        raise ConfigError(
            f"can.bus = {bus!r}: {interface} has no option {unknown[0]!r}; it has: {', '.join(sorted(known))}"
        )


def _enlarge_buffer(bus: can.BusABC) -> None:
    """Enlarge the kernel's receive buffer, for interfaces with a socket."""
    try:
        with socket.socket(fileno=os.dup(bus.fileno())) as copy:
            try:
                copy.setsockopt(socket.SOL_SOCKET, SO_RCVBUFFORCE, RECEIVE_BUFFER)
            except PermissionError:
                copy.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
    except (OSError, NotImplementedError) as error:
        _LOG.debug("the receive buffer of the bus stays as it is: %s", error)


BUS_OFF: Final = 0x40
CONTROLLER: Final = 0x04
NO_ACKNOWLEDGEMENT: Final = 0x20
"""Classes of error frames in their identifier (linux/can/error.h)."""

PASSIVE: Final = 0x30
"""Bits of the second byte of class `CONTROLLER`: the controller is error passive."""


def error_frame_text(message: can.Message) -> str:
    """A text for an error frame of socketcan: `bus-off`, or another error."""
    if message.arbitration_id & BUS_OFF:
        return "bus-off"
    if message.arbitration_id & NO_ACKNOWLEDGEMENT:
        return "nobody acknowledges frames"
    if message.arbitration_id & CONTROLLER and len(message.data) > 1 and message.data[1] & PASSIVE:
        return "the controller is error passive: many frames are damaged"
    return "frames are damaged"


MAX_ERRORS: Final = 5
"""Errors in a row after which a receiver waits before it tries again."""


class Receiver:
    """A thread that passes each frame of a bus to `receive`.

    Unreadable frames are counted and logged, and never end the thread. `failed` is called with `bus-off`, unless error
    frames can be forged.
    """

    def __init__(
        self,
        bus: can.BusABC,
        receive: Callable[[can.Message], None],
        failed: Callable[[str], None],
        *,
        errors_forgeable: bool = False,
    ) -> None:
        self._errors_forgeable = errors_forgeable
        self.counters: Counter[str] = Counter(frames=0, unreadable=0, error_frames=0)
        self._bus = bus
        self._receive = receive
        self._failed = failed
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="CAN receiver", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        errors = 0
        while not self._closing.is_set():
            try:
                message = self._bus.recv(0.1)
                if message is not None:
                    self._pass_on(message)
                errors = 0
            except Exception as error:  # noqa: BLE001 - drivers raise what they like, also of foreign datagrams
                self.counters["unreadable"] += 1
                errors += 1
                _LOG.warning("a frame of the CAN bus cannot be read: %s", describe(error))
                if errors > MAX_ERRORS:  # the adapter is gone, which sending says, or a flood
                    time.sleep(0.001)

    def _pass_on(self, message: can.Message) -> None:
        self.counters["frames"] += 1
        if message.is_error_frame:
            self.counters["error_frames"] += 1
            if self._errors_forgeable:
                return
            text = error_frame_text(message)
            if text == "bus-off" or self._bus.state is can.BusState.ERROR:
                self._failed("bus-off")
            else:
                _LOG.warning("an error of the CAN bus: %s", text)
        else:
            self._receive(message)

    def close(self) -> None:
        """End the thread; the bus stays open."""
        self._closing.set()
        self._thread.join()


class PeriodicTask:
    """The result of `Port.send_periodic`, as python-can returns it."""

    def __init__(self, port: Port, message: can.Message, period: float, start: float) -> None:
        self.message = message
        self.period = period
        self.due = start
        self._port = port

    def stop(self) -> None:
        """End it."""
        self._port.periodic.discard(self)

    def modify_data(self, message: can.Message) -> None:
        """Change the bytes to send."""
        self.message = message


class Port:
    """A bus as `canopen.Network` uses it, whose periodic messages are sent by `step`, without a thread."""

    def network(self) -> canopen.Network:
        """The network on it. canopen expects a bus of python-can, but uses only the methods that a port has."""
        return canopen.Network(cast("can.BusABC", self))

    channel_info = "port"

    def __init__(self, send: Callable[[can.Message], None]) -> None:
        self._send = send
        self._now = 0.0
        self.periodic: set[PeriodicTask] = set()

    def send(self, message: can.Message, timeout: float | None = None) -> None:  # noqa: ARG002 - never blocks
        """Send a frame."""
        self._send(message)

    def send_periodic(self, message: can.Message, period: float) -> PeriodicTask:
        """Send a frame each `period` seconds, from the next `step` on."""
        task = PeriodicTask(self, message, period, self._now)
        self.periodic.add(task)
        return task

    def step(self, now: float) -> None:
        """Send what is due."""
        self._now = now
        for task in sorted(self.periodic, key=lambda task: task.message.arbitration_id):
            if now >= task.due:
                task.due = max(task.due + task.period, now)
                self._send(task.message)

    def shutdown(self) -> None:
        """End periodic messages."""
        self.periodic.clear()


class VirtualBus:
    """A CAN bus in one process, with two ends: the robot and the simulated drives.

    When `send` returns, the other end has received the frame.

    Frames that are sent meanwhile wait for their turn, as on a bus. `loses` may drop frames, for tests.
    """

    def __init__(self) -> None:
        self.near = Port(lambda message: self._transmit(message, near=True))
        self.far = Port(lambda message: self._transmit(message, near=False))
        self.near_receives: Callable[[can.Message], None] = lambda _message: None
        self.far_receives: Callable[[can.Message], None] = lambda _message: None
        self.loses: Callable[[can.Message], bool] = lambda _message: False
        self.watch: Callable[[can.Message, bool], None] | None = None
        self._waiting: deque[tuple[can.Message, bool]] = deque()
        self._busy = False

    def _transmit(self, message: can.Message, *, near: bool) -> None:
        self._waiting.append((message, near))
        if self._busy:
            return
        self._busy = True
        try:
            while self._waiting:
                each, from_near = self._waiting.popleft()
                if self.watch is not None:
                    self.watch(each, from_near)
                if not self.loses(each):
                    (self.far_receives if from_near else self.near_receives)(each)
        finally:
            self._busy = False
