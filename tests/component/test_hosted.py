from __future__ import annotations

import asyncio
import logging
import time
from datetime import UTC, datetime

import pytest

from jauspy.codec.message import Message
from jauspy.component.component import (
    MAX_PACKETS_PER_TURN,
    MAX_TRANSPORT_BACKLOG,
    MAX_WAITING_PER_TURN,
    Component,
    ComponentOptions,
    loop_time,
)
from jauspy.errors import ConfigError, EncodeError, ProtocolError, ResponseTimeout, TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.messages.core import (
    CreateEvent,
    Event,
    QueryControl,
    QueryHeartbeatPulse,
    RegisterServices,
    RejectControl,
    ReportHeartbeatPulse,
    ReportTimeout,
    RequestControl,
    ServiceRec,
)
from jauspy.protocol.delivery import FRAGMENTS_PER_BURST, Delivery
from jauspy.protocol.header import Ack, DataFlag, Packet
from jauspy.protocol.judp import pack, unpack
from jauspy.services.core import AccessControl, Events, Liveness
from jauspy.services.host import Host
from jauspy.testing import until
from jauspy.transport import LoopbackHub, LoopbackTransport

ME, PEER = JausID(1, 1, 1), JausID(2, 1, 1)


def component(hub: LoopbackHub, id: JausID = ME, *, intercept=None, **options) -> Component:
    host = Host(id, [Liveness(), AccessControl(timeout=1)], utc_now=lambda: datetime.now(UTC), now=loop_time())
    return Component.of_host(host, LoopbackTransport(id, hub), intercept=intercept, options=ComponentOptions(**options))


class Peer:
    def __init__(self, hub: LoopbackHub) -> None:
        self.transport = LoopbackTransport(PEER, hub)
        self.transport.received = self._take
        self.packets: asyncio.Queue[Packet] = asyncio.Queue()

    def _take(self, datagram: bytes) -> None:
        for packet in unpack(datagram):
            self.packets.put_nowait(packet)

    def send(self, message: Message | bytes, ack: Ack = Ack.NONE) -> None:
        payload = message if isinstance(message, bytes) else message.encode()
        self.transport.send(pack(Packet(PEER, ME, payload, 7, ack=ack)))

    async def next(self) -> Packet:
        async with asyncio.timeout(20):
            return await self.packets.get()

    async def __aenter__(self) -> Peer:
        await self.transport.open()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.transport.close()


async def test_a_query_is_answered():
    hub = LoopbackHub()
    async with component(hub) as me, Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse())
        answer = await peer.next()
        assert (answer.source, answer.payload) == (ME, ReportHeartbeatPulse().encode())
        assert me.counters["host.received"] == 1
        assert me.counters["endpoint.sent"] == 1
        assert me.counters["transport.sent"] == 1


async def test_deferred_answer_is_sent_when_available():
    class Slow(Liveness):
        later = None

        def report_heartbeat_pulse(self):
            self.later = self.host.defer(ReportTimeout)
            return self.later

    slow, hub = Slow(), LoopbackHub()
    host = Host(ME, [slow], utc_now=lambda: datetime.now(UTC), now=time.monotonic())
    async with Component.of_host(host, LoopbackTransport(ME, hub)), Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse(), ack=Ack.REQUIRED)
        acknowledged = await peer.next()
        assert acknowledged.ack is Ack.ACK
        assert peer.packets.empty()
        slow.later.set_result(ReportHeartbeatPulse())
        answer = await peer.next()
    assert answer.payload == ReportHeartbeatPulse().encode()
    slow.later.set_result(ReportHeartbeatPulse())


async def test_acknowledgement_callbacks_are_called_and_bounded(virtual_network):
    hub, reported = LoopbackHub(), []
    async with component(hub, clock=loop_time) as me, Peer(hub) as peer:
        me.host.receive(RequestControl(1).encode(), PEER, loop_time())
        for _ in range(100):
            me.host.send(PEER, ReportHeartbeatPulse(), on_acknowledged=reported.append)
        me.wake()
        assert reported == []
        sent = [await peer.next() for _ in range(101)][1:]
        assert [each.ack for each in sent] == [Ack.REQUIRED] * 64 + [Ack.NONE] * 36
        peer.transport.send(pack(Packet(PEER, ME, b"", sent[0].sequence, ack=Ack.ACK)))
        await until(lambda: reported == [True])
        await until(lambda: len(reported) == 64)
        assert reported == [True] + [False] * 63
        assert me.host.controller == PEER, "who does not acknowledge may be there all the same"


async def test_requested_ack_is_sent():
    hub = LoopbackHub()
    async with component(hub), Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse(), Ack.REQUIRED)
        packets = [await peer.next(), await peer.next()]
        assert {(each.ack, each.sequence) for each in packets} >= {(Ack.ACK, 7)}


async def test_timers_of_services_run(virtual_network):
    hub = LoopbackHub()
    async with component(hub) as me, Peer(hub) as peer:
        peer.send(RequestControl(authority_code=100))
        await peer.next()
        assert me.host.controller == PEER
        rejected = await peer.next()  # after the timeout of a second
        assert rejected.payload[:2] == b"\x10\x00"
        assert me.host.controller is None


async def test_timers_run_on_after_one_that_panicked(virtual_network):
    class PanicError(BaseException):
        """As of extensions in Rust: not an `Exception`."""

    def panic() -> None:
        raise PanicError

    loop, reported, called = asyncio.get_running_loop(), [], []
    handler = loop.get_exception_handler()
    loop.set_exception_handler(lambda _, context: reported.append(type(context["exception"])))
    async with component(LoopbackHub()) as me:
        me.host.set_timer("panic", loop_time() + 0.1, panic)
        me.host.set_timer("other", loop_time() + 0.2, lambda: called.append(loop_time()))
        me.wake()
        await asyncio.sleep(1.0)
    loop.set_exception_handler(handler)
    assert reported == [PanicError]
    assert len(called) == 1


async def test_garbage_is_counted_and_valid_traffic_continues():
    hub = LoopbackHub()
    async with component(hub) as me, Peer(hub) as peer:
        for garbage in (b"", b"\x02", b"\xff" * 65507, pack(Packet(PEER, ME, b"\x0d\x00"))[:-3]):
            me._transport.received(garbage)
        peer.send(b"\x0d")
        peer.send(b"\x0d\x00\x01\x02\x03")
        peer.send(QueryHeartbeatPulse())
        await peer.next()
        assert me.counters["host.malformed_RequestControl"] == 1
        assert me.counters["host.too_short"] == 1
        assert sum(value for name, value in me.counters.items() if name.startswith("endpoint.dropped.")) >= 3


async def test_exception_does_not_reach_the_event_loop(caplog):
    hub = LoopbackHub()

    def buggy(packet: Packet) -> bool:
        raise RuntimeError("a bug")

    async with component(hub, intercept=buggy) as me, Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse())
        async with asyncio.timeout(20):
            while not me.counters.get("component.internal_error"):
                await asyncio.sleep(0)
    assert "a bug" in caplog.text


async def test_intercepted_packet_does_not_reach_the_services():
    hub = LoopbackHub()
    seen = []

    def mine(packet: Packet) -> bool:
        seen.append(packet.source)
        return packet.payload == ReportTimeout(timeout=3).encode()

    async with component(hub, intercept=mine) as me, Peer(hub) as peer:
        peer.send(ReportTimeout(timeout=3))
        peer.send(QueryHeartbeatPulse())
        await peer.next()
        assert seen == [PEER, PEER]
        assert "host.unknown_message" not in me.counters


async def test_component_can_be_opened_and_closed_repeatedly():
    hub = LoopbackHub()
    me = component(hub)
    for _ in range(2):
        await me.open()
        await me.open()
        assert me.is_open
        await me.close()
        await me.close()
        assert not me.is_open
    async with Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse())
        await asyncio.sleep(0.01)
        assert peer.packets.empty()


async def test_failed_open_of_a_transport_is_an_error_and_cleans_up():
    hub = LoopbackHub()
    async with component(hub):
        second = component(hub)
        with pytest.raises(TransportError, match="another component"):
            await second.open()
        assert not second.is_open


async def test_run_serves_until_closed_or_cancelled():
    hub = LoopbackHub()
    me = component(hub)
    async with Peer(hub) as peer:
        running = asyncio.create_task(me.run())
        await asyncio.sleep(0)
        peer.send(QueryHeartbeatPulse())
        await peer.next()
        await me.close()
        await running

        running = asyncio.create_task(me.run())
        await asyncio.sleep(0)
        running.cancel()
        with pytest.raises(asyncio.CancelledError):
            await running
    assert not me.is_open


async def test_outage_of_the_transport_is_survived():
    hub = LoopbackHub()
    async with component(hub) as me, Peer(hub) as peer:
        await me._transport.close()
        me.send(PEER, ReportHeartbeatPulse())
        await me._transport.open()
        peer.send(QueryHeartbeatPulse())
        await peer.next()
        assert me.counters["transport.dropped.closed"] == 1


async def test_sequence_numbers_start_at_random_and_continue():
    hub = LoopbackHub()
    async with Peer(hub) as peer:
        async with component(hub, first_sequence=0xFFFF) as me:
            for _ in range(2):
                me.send(PEER, ReportHeartbeatPulse())
            assert [(await peer.next()).sequence for _ in range(2)] == [0xFFFF, 0]
        starts = set()
        for _ in range(4):
            async with component(hub) as me:
                me.send(PEER, ReportHeartbeatPulse())
                starts.add((await peer.next()).sequence)
        assert len(starts) > 1


async def test_send_raises_encode_error():
    async with component(LoopbackHub()) as me:
        with pytest.raises(EncodeError):
            me.send(PEER, RequestControl(authority_code=300))


async def test_wake_sends_messages_queued_from_outside():
    hub = LoopbackHub()
    async with component(hub) as me, Peer(hub) as peer:
        me.host.send(PEER, ReportHeartbeatPulse())
        me.wake()
        assert (await peer.next()).payload == ReportHeartbeatPulse().encode()


async def test_deliver_returns_after_the_ack():
    hub = LoopbackHub()
    async with component(hub) as me, component(hub, PEER):
        await me.deliver(PEER, ReportHeartbeatPulse())
        assert me.counters["endpoint.delivered"] == 1


async def test_unacknowledged_message_is_resent_and_then_an_error():
    hub = LoopbackHub()
    async with component(hub, delivery=Delivery(ack_timeout=0.01)) as me, Peer(hub) as peer:
        with pytest.raises(ResponseTimeout, match=r"2\.1\.1 did not acknowledge ReportHeartbeatPulse"):
            await me.deliver(PEER, ReportHeartbeatPulse())
        tries = [await peer.next() for _ in range(4)]
        assert tries == [tries[0]] * 4
        assert peer.packets.empty()


async def test_events_of_an_unreachable_client_end():
    hub = LoopbackHub()
    async with component(hub, delivery=Delivery(ack_timeout=0.01)) as me, Peer(hub) as peer:
        peer.send(CreateEvent(1, 1, 0.0, QueryHeartbeatPulse()))
        while (await peer.next()).payload[:2] != Event.CODE.to_bytes(2, "little"):
            pass
        assert len(me.host.service(Events).subscriptions) == 1
        with pytest.raises(ResponseTimeout):
            await me.deliver(PEER, ReportHeartbeatPulse())
        assert len(me.host.service(Events).subscriptions) == 0


async def test_close_ends_all_waits():
    me = component(LoopbackHub())
    with pytest.raises(ConfigError, match="not open"):
        await me.deliver(PEER, ReportHeartbeatPulse())
    await me.open()
    waiting = asyncio.create_task(me.deliver(PEER, ReportHeartbeatPulse()))
    await asyncio.sleep(0)
    with pytest.raises(ProtocolError, match="which is not acknowledged"):
        await me.deliver(EVERYONE, ReportHeartbeatPulse())
    await me.close()
    with pytest.raises(TransportError, match="was closed"):
        await waiting


async def test_large_messages_are_fragmented_and_reassembled():
    hub = LoopbackHub()
    seen: asyncio.Queue[Packet] = asyncio.Queue()

    def mine(packet: Packet) -> bool:
        seen.put_nowait(packet)
        return True

    async with component(hub, intercept=mine), component(hub, PEER) as other:
        for ack in (Ack.NONE, Ack.REQUIRED):
            ticket = other._endpoint.send(ME, b"\x01\x40" + bytes(400_000), now=time.monotonic(), ack=ack)
            other.wake()
            async with asyncio.timeout(20):
                packet = await seen.get()
            assert (len(packet.payload), packet.data_flag) == (400_002, DataFlag.SINGLE)
            assert (ticket is None) == (ack is Ack.NONE)


async def test_fragments_wait_while_the_transport_is_congested(virtual_network):
    class Line(LoopbackTransport):
        waiting = MAX_TRANSPORT_BACKLOG

    hub = LoopbackHub()
    line = Line(ME, hub)
    host = Host(ME, [Liveness()], utc_now=lambda: datetime.now(UTC), now=loop_time())
    async with Component.of_host(host, line) as me, component(hub, PEER) as other:
        me._endpoint.send(PEER, b"\x01\x40" + bytes(400_000), now=loop_time())
        me.wake()
        await asyncio.sleep(1.0)
        assert line.counters["sent"] == FRAGMENTS_PER_BURST
        line.waiting = 0
        await until(lambda: other.counters.get("endpoint.received") == 1)


def queries(number: int, start: int = 0) -> bytes:
    """One datagram with many packets."""
    packets = [pack(Packet(PEER, ME, QueryHeartbeatPulse().encode(), start + n)) for n in range(number)]
    return packets[0][:1] + b"".join(packet[1:] for packet in packets)


async def test_packets_above_the_limit_of_a_turn_are_handled_later():
    hub = LoopbackHub()
    many = 3 * MAX_PACKETS_PER_TURN + 1
    async with component(hub) as me:
        me._transport.received(queries(many))
        assert me.counters["host.received"] == MAX_WAITING_PER_TURN
        me._transport.received(queries(1, start=many))
        async with asyncio.timeout(20):
            while me.counters["host.received"] < many + 1:
                await asyncio.sleep(0)


async def test_pending_packets_are_dropped_on_close():
    hub = LoopbackHub()
    me = component(hub)
    await me.open()
    me._transport.received(queries(MAX_PACKETS_PER_TURN + 1, start=1000))
    await me.close()
    async with me, Peer(hub) as peer:
        peer.send(QueryHeartbeatPulse())
        await peer.next()
        await asyncio.sleep(0)
        assert me.counters["host.received"] == MAX_WAITING_PER_TURN + 1


async def test_exception_on_one_packet_does_not_affect_others_of_its_datagram():
    hub = LoopbackHub()

    def buggy(packet: Packet) -> bool:
        if packet.sequence == 1:
            raise RuntimeError("a bug")
        return False

    async with component(hub, intercept=buggy) as me:
        me._transport.received(queries(2, start=1))
        assert me.counters["component.internal_error"] == 1
        assert me.counters["host.received"] == 1


async def test_control_times_out_while_the_event_loop_hangs():
    hub, now = LoopbackHub(), [time.monotonic()]
    async with component(hub, clock=lambda: now[0]) as me, Peer(hub) as peer:
        peer.send(RequestControl(authority_code=100))
        await peer.next()
        now[0] += 60.0
        peer.send(QueryControl())
        assert (await peer.next()).payload == RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED).encode()
        assert me.host.controller is None


async def test_oversized_message_is_counted_and_logged_once(caplog):
    async with component(LoopbackHub()) as me:
        for _ in range(2):
            me.host.send(EVERYONE, RegisterServices([ServiceRec("x" * 255, 1, 0)] * 255))
            me.wake()
        assert me.counters["component.unsendable.oversize"] == 2
    (record,) = caplog.records
    assert record.levelno == logging.WARNING
    assert f"cannot send 0B00h to {EVERYONE}: oversize" in record.getMessage()
