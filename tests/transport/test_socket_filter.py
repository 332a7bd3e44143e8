"""The kernel's filter of a local socket drops exactly the broadcasts that it is to drop."""

import socket
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from hypothesis import given, settings, strategies as st

from jauspy.component import Component
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportHeartbeatPulse
from jauspy.ocu import OCU
from jauspy.protocol import header
from jauspy.protocol.header import Broadcast
from jauspy.services.core import Liveness
from jauspy.testing import LocalNode
from jauspy.transport.socket_filter import MAX_CODES, set_filter

PULSE = ReportHeartbeatPulse.CODE
CODES = {PULSE, 0x4002}


@contextmanager
def filtered(codes: set[int]) -> Iterator[tuple[socket.socket, socket.socket]]:
    sender, receiver = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
    with sender, receiver:
        receiver.setblocking(False)
        set_filter(receiver, codes)
        yield sender, receiver


def passes(pair: tuple[socket.socket, socket.socket], datagram: bytes) -> bool:
    sender, receiver = pair
    assert sender.send(datagram) == len(datagram)
    try:
        assert receiver.recv(1 << 16) == datagram
    except BlockingIOError:
        return False
    return True


def datagram(payload: bytes, control: int, *, version: int = 2, flags: int = 0) -> bytes:
    packed = bytearray(header.pack_alone(0x650101, 0xFFFFFFFF, control, payload, 7))
    packed[0], packed[1] = version, flags
    return bytes(packed)


@pytest.fixture(scope="module")
def pair() -> Iterator[tuple[socket.socket, socket.socket]]:
    with filtered(CODES) as made:
        if passes(made, datagram(PULSE.to_bytes(2, "little"), 0x08)):
            pytest.skip("this system has no filters of sockets")
        yield made


near = st.builds(
    datagram,
    st.builds(
        lambda code, rest: code.to_bytes(2, "little") + rest,
        st.sampled_from([*CODES, 0x4202 ^ 0x0100, 0x0242, 0x2202]),
        st.binary(max_size=300),
    ),
    st.integers(0, 255) | st.sampled_from([0x04, 0x08, 0x0C, 0x0A]),
    version=st.sampled_from([2, 2, 2, 1]),
    flags=st.sampled_from([0, 0, 0, 1, 0x40, 0x80]),
)


@settings(max_examples=500)
@given(near | st.builds(lambda one, other: one + other, near, near | st.binary(max_size=40)) | st.binary(max_size=60))
def test_what_is_dropped_is_what_the_header_says(pair: tuple[socket.socket, socket.socket], sent: bytes) -> None:
    assert passes(pair, sent) == (header.broadcast_code(sent) not in CODES)


def test_every_truncated_heartbeat_passes(pair: tuple[socket.socket, socket.socket]) -> None:
    pulse = datagram(PULSE.to_bytes(2, "little"), 0x08)
    assert [length for length in range(1, len(pulse) + 1) if not passes(pair, pulse[:length])] == [len(pulse)]


def test_a_filter_is_replaced_and_removed(pair: tuple[socket.socket, socket.socket]) -> None:
    pulse = datagram(PULSE.to_bytes(2, "little"), 0x08)
    with filtered({PULSE}) as other:
        assert not passes(other, pulse)
        set_filter(other[1], {0x4002})
        assert passes(other, pulse)
        set_filter(other[1], set(range(0x4202, 0x4202 + MAX_CODES)))
        assert not passes(other, pulse)
        assert not passes(other, datagram((0x4202 + MAX_CODES - 1).to_bytes(2, "little"), 0x08))
        set_filter(other[1], ())
        set_filter(other[1], ())
        assert passes(other, pulse)
        with pytest.raises(ValueError, match="65 message ids; a filter has up to 64"):
            set_filter(other[1], set(range(MAX_CODES + 1)))


@pytest.mark.usefixtures("pair")
async def test_heartbeats_of_others_wake_no_component_that_does_not_take_them() -> None:
    with LocalNode() as node:
        first, second = (Component(f"101.1.{number}", [Liveness()], connect=node.local) for number in (121, 122))
        async with first, second, OCU("42.1.1", node.local) as ocu:
            taken: list[JausID] = []
            await heartbeats(second, first, ocu)
            assert first.counters["host.unknown_message"] == 1, "that which was not broadcast"
            first.host.expect(ReportHeartbeatPulse, lambda _, source: taken.append(source))
            await heartbeats(second, first, ocu)
            assert taken == [second.id] * 2
            second.move("101.1.123")
            await heartbeats(first, second, ocu)
            assert second.counters["host.unknown_message"] == 1, "the filter moves with the id"


async def heartbeats(sender: Component, receiver: Component, ocu: OCU) -> None:
    """A broadcast heartbeat, and one that is not, both handled before this returns."""
    sender.send(JausID(0xFFFF, 0xFF, 0xFF), ReportHeartbeatPulse(), broadcast=Broadcast.GLOBAL)
    sender.send(receiver.id, ReportHeartbeatPulse())
    await ocu.query(sender.id, QueryStatus())
    await ocu.query(receiver.id, QueryStatus())
