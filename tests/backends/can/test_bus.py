"""Buses of python-can: names, options, what is told when one cannot be opened, and what cannot be read."""

from __future__ import annotations

import errno
import os
import queue
import socket
import sys
import threading
from collections.abc import Callable, Iterator

import can
import pytest

pytest.importorskip("canopen", reason="canopen is not installed")

from jauspy.backends.can import bus as bus_module
from jauspy.backends.can.bus import Receiver, open_bus, reachable_at, split
from jauspy.errors import ConfigError


@pytest.mark.parametrize(
    ("bus", "said"),
    [
        ("can0", "write INTERFACE:CHANNEL, as in socketcan:can0"),
        ("morse:key", "interfaces are: .*socketcan"),
        ("socketcan:can0,fast", "write options as KEY=VALUE"),
    ],
)
def test_names_of_buses(bus: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        split(bus)


def test_options_of_a_bus() -> None:
    assert split("udp_multicast:239.0.0.1,port=43200") == ("udp_multicast", "239.0.0.1", {"port": 43200})


@pytest.mark.parametrize(
    ("bus", "said"),
    [
        ("udp_multicast:239.0.0.1,prot=43200", "udp_multicast has no option 'prot'; it has: .*, port, "),
        ("slcan:/dev/no_such_adapter", r"No such file or directory.*\(there is no such device: plug the adapter in"),
        ("kvaser:0", "cannot be opened: .*; install what python-can needs for kvaser: its driver or package"),
        ("udp_multicast:10.0.0.1", "could not create or configure socket: Invalid argument"),
    ],
)
def test_a_bus_that_cannot_be_opened(bus: str, said: str, caplog: pytest.LogCaptureFixture) -> None:
    with pytest.raises(ConfigError, match=said) as caught:
        open_bus(bus, 1_000_000)
    assert "\n" not in str(caught.value)
    assert not caplog.records


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (errno.EAFNOSUPPORT, "this kernel has no CAN: load its modules can, can_raw"),
        (errno.ENODEV, "there is no such interface: plug the adapter in; `ip link show type can` lists them"),
        (errno.EACCES, "your user may not use it: `sudo usermod -aG dialout"),
    ],
)
def test_errors_of_the_kernel_say_what_to_do(number: int, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_arguments: object, **_options: object) -> None:
        raise OSError(number, "refused")

    monkeypatch.setattr(can, "Bus", refused)
    with pytest.raises(ConfigError, match=f"'socketcan:can0': cannot be opened: .*{said}"):
        open_bus("socketcan:can0", 1_000_000)


class ScriptedBus:
    """Gives frames and errors to a receiver."""

    def __init__(self, *script: can.Message | Exception) -> None:
        self._script = queue.SimpleQueue[can.Message | Exception]()
        for each in script:
            self._script.put(each)
        self.state = can.BusState.ACTIVE

    def recv(self, timeout: float) -> can.Message | None:
        try:
            each = self._script.get(timeout=timeout)
        except queue.Empty:
            return None
        if isinstance(each, Exception):
            raise each
        return each


FRAME = can.Message(arbitration_id=0x181, data=b"1234", is_extended_id=False)


def received(*script: can.Message | Exception) -> tuple[Receiver, list[str]]:
    """What a receiver did with it, and the failures that it told."""
    failures: list[str] = []
    frames = threading.Event()
    receive: Callable[[can.Message], None] = lambda _message: frames.set()  # noqa: E731 - typed
    receiver = Receiver(ScriptedBus(*script, FRAME), receive, failures.append)  # type: ignore[arg-type] - no more is used
    assert frames.wait(10.0)
    receiver.close()
    return receiver, failures


def error_frame(identifier: int, data: bytes = bytes(8)) -> can.Message:
    return can.Message(arbitration_id=identifier, data=data, is_error_frame=True, is_extended_id=False)


def test_an_error_frame_of_the_kernel_tells_bus_off() -> None:
    receiver, failures = received(error_frame(0x40))
    assert failures == ["bus-off"]
    assert receiver.counters["error_frames"] == 1


@pytest.mark.parametrize(
    ("frame", "said"),
    [
        (error_frame(0x20), "nobody acknowledges frames"),
        (error_frame(0x04, b"\0\x20\0\0\0\0\0\0"), "error passive"),
        (error_frame(0x08), "frames are damaged"),
    ],
)
def test_other_error_frames_are_logged(frame: can.Message, said: str, caplog: pytest.LogCaptureFixture) -> None:
    _, failures = received(frame)
    assert not failures
    assert said in caplog.text


def test_what_cannot_be_read_is_counted_and_ends_nothing() -> None:
    receiver, failures = received(*[can.CanOperationError("could not unpack received message")] * 8)
    assert receiver.counters["unreadable"] == 8
    assert receiver.counters["frames"] == 1
    assert not failures


@pytest.fixture
def multicast_bus() -> Iterator[tuple[can.BusABC, int]]:
    """A bus, and its UDP port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        port = probe.getsockname()[1]
    try:
        bus = open_bus(f"udp_multicast:239.0.0.98,port={port}", 1_000_000)
    except ConfigError:
        pytest.skip("this machine has no route for multicast")
    yield bus, port
    bus.shutdown()


def test_a_foreign_datagram_on_a_multicast_bus_ends_nothing(multicast_bus: tuple[can.BusABC, int]) -> None:
    bus, port = multicast_bus
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        try:
            other.sendto(b"not a frame", ("239.0.0.98", port))
        except OSError:
            pytest.skip("this machine has no route for multicast")
    frames = threading.Event()
    receiver = Receiver(bus, lambda _message: frames.set(), lambda _why: None)
    bus.send(FRAME)
    arrived = frames.wait(10.0)
    receiver.close()
    assert arrived
    assert receiver.counters["unreadable"] == 1


@pytest.mark.skipif(sys.platform != "linux", reason="an option of Linux")
def test_frames_of_another_group_are_not_received(multicast_bus: tuple[can.BusABC, int]) -> None:
    bus, port = multicast_bus
    foreign = can.Message(arbitration_id=0x80, is_extended_id=False)
    with open_bus(f"udp_multicast:239.0.0.97,port={port}", 1_000_000) as other:
        other.send(foreign)
        assert other.recv(5.0) is not None  # its own echo: the frame has been sent
    bus.send(can.Message(arbitration_id=0x181, is_extended_id=False))
    first = bus.recv(5.0)
    assert first is not None
    assert first.arbitration_id == 0x181


def test_the_kernel_keeps_more_frames_than_by_default(multicast_bus: tuple[can.BusABC, int]) -> None:
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as plain,
        socket.socket(fileno=os.dup(multicast_bus[0].fileno())) as copy,
    ):
        sizes = [each.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) for each in (plain, copy)]
    assert sizes[0] < sizes[1]


def test_a_bus_that_other_machines_reach_is_named_at_the_start(
    multicast_bus: tuple[can.BusABC, int], monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    name = f"udp_multicast:239.0.0.98,port={multicast_bus[1]}"
    for address, said in (("192.0.2.7", 1), ("", 0)):
        caplog.clear()
        monkeypatch.setattr(bus_module, "reachable_at", lambda _group, found=address: found)
        open_bus(name, 1_000_000).shutdown()
        lines = [record.getMessage() for record in caplog.records]
        assert sum("has no authentication and is reachable at 192.0.2.7" in line for line in lines) == said
        assert len(lines) == said


def test_loopback_is_not_reachable() -> None:
    assert reachable_at("127.0.0.1") == ""
    assert reachable_at("no group").startswith("an unknown address")


def test_forged_error_frames_are_no_bus_off() -> None:
    """On a bus of datagrams, where each program may send them."""
    failures: list[str] = []
    frames = threading.Event()
    bus = ScriptedBus(*[error_frame(0x40)] * 5, FRAME)
    receiver = Receiver(bus, lambda _message: frames.set(), failures.append, errors_forgeable=True)  # type: ignore[arg-type]
    assert frames.wait(10.0)
    receiver.close()
    assert not failures
    assert receiver.counters["error_frames"] == 5
