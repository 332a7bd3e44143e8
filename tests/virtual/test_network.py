"""The virtual network: as bad as it is told to be, and no worse."""

from __future__ import annotations

import asyncio
import time

import pytest

from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.messages.core import ConfirmControl, QueryHeartbeatPulse, ReportHeartbeatPulse, RequestControl
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import pack, unpack
from jauspy.services.core import AccessControl, Liveness
from jauspy.testing import LocalNode, VirtualClock, VirtualNetwork, until
from jauspy.virtual.clock import START_TIME

PULSE = QueryHeartbeatPulse()


async def arrivals(network: VirtualNetwork, number: int) -> list[tuple[float, int]]:
    """Send numbered packets, 1 ms apart; when each arrived, in the order of arrival."""
    here, there = network.transport("1.1.1"), network.transport("2.1.1")
    found: list[tuple[float, int]] = []
    there.received = lambda data: found.extend((network.clock.elapsed, each.sequence) for each in unpack(data))
    await here.open()
    await there.open()
    for index in range(number):
        here.send(pack(Packet(here.id, there.id, PULSE.encode(), index)))
        await asyncio.sleep(0.001)
    await asyncio.sleep(60)
    return found


async def test_a_good_network_delivers_all_in_order():
    async with VirtualNetwork() as network:
        assert [index for _, index in await arrivals(network, 50)] == list(range(50))
        assert len(network.sent(QueryHeartbeatPulse, "1.1.1")) == 50


@pytest.mark.parametrize("seed", [1, 2])
async def test_loss_is_repeatable(seed):
    found = []
    for _ in range(2):
        async with VirtualNetwork(loss=0.3, seed=seed) as network:
            found.append([index for _, index in await arrivals(network, 200)])
    assert found[0] == found[1]
    assert 100 < len(found[0]) < 180


async def test_duplicates_and_delay():
    async with VirtualNetwork(duplication=1.0, delay=0.5) as network:
        found = await arrivals(network, 10)
    assert [index for _, index in found] == [index for index in range(10) for _ in range(2)]
    assert found[0][0] == pytest.approx(0.5, abs=1e-6)


async def test_reordering_lets_later_datagrams_overtake():
    async with VirtualNetwork(reordering=0.2) as network:
        order = [index for _, index in await arrivals(network, 100)]
    assert order != sorted(order)
    assert sorted(order) == list(range(100))


async def test_jitter():
    async with VirtualNetwork(jitter=0.1) as network:
        found = await arrivals(network, 100)
    late = [at - index * 0.001 for at, index in found]
    assert 0.0 <= min(late) < 0.02
    assert 0.08 < max(late) < 0.101


async def test_disconnect_and_lose_drop_packets():
    async with VirtualNetwork() as network, network.component("101.1.1", [Liveness()]), network.ocu() as ocu:
        network.disconnect("101.1.1")
        with pytest.raises(ResponseTimeout):
            await ocu.query("101.1.1", PULSE)
        network.reconnect("101.1.1")
        await ocu.query("101.1.1", PULSE)

        network.lose(ReportHeartbeatPulse, times=2, after=1)
        before = len(network.sent(QueryHeartbeatPulse))
        for _ in range(3):
            await ocu.query("101.1.1", PULSE)
        assert len(network.sent(QueryHeartbeatPulse)) == before + 5


async def test_components_use_virtual_time():
    started = time.monotonic()
    async with (
        VirtualNetwork() as network,
        network.component("101.1.1", [AccessControl(timeout=200), Liveness()]) as robot,
        network.ocu() as ocu,
    ):
        await ocu.query("101.1.1", RequestControl(authority_code=200), expects=ConfirmControl)
        assert robot.host.controller == ocu.id
        await asyncio.sleep(199)
        assert robot.host.controller == ocu.id
        await until(lambda: robot.host.controller is None, within=2)
    assert time.monotonic() - started < 60


async def test_event_loop_is_restored():
    loop = asyncio.get_running_loop()
    with VirtualClock() as clock:
        with pytest.raises(ConfigError, match="uses a virtual clock already"), VirtualClock():
            pass
        await asyncio.sleep(1000)
        assert clock.elapsed == pytest.approx(1000)
        assert (clock.utc_now().hour, clock.utc_now().minute) == (0, 16)
    assert abs(loop.time() - time.monotonic()) < 60
    await asyncio.sleep(0.001)


async def test_timers_keep_their_time_when_the_clock_is_changed():
    loop, fired = asyncio.get_running_loop(), []
    loop.call_later(30, lambda: fired.append(loop.time() - START_TIME))
    with VirtualClock():
        await asyncio.sleep(29)
        assert not fired
        await asyncio.sleep(2)
        assert fired == [pytest.approx(30, abs=0.01)]
        left = loop.call_later(3600, fired.clear)
    assert left.when() - loop.time() == pytest.approx(3600, abs=1)
    left.cancel()


async def test_threads_can_still_wake_the_loop():
    with VirtualClock():
        assert await asyncio.to_thread(lambda: 7) == 7


async def test_until_error_names_the_condition():
    with VirtualClock(), pytest.raises(AssertionError, match=r"waited 5 s in vain for the condition at .*test_network"):
        await until(lambda: False, within=5)


async def test_local_node_can_be_restarted():
    with LocalNode() as node:
        async with node.component("101.1.1", [Liveness()]), node.ocu() as ocu:
            await ocu.query("101.1.1", PULSE)
            assert [str(each) for each in node.components] == ["42.1.1", "101.1.1"]
            port = node.port
            node.stop()
            assert node.components == ()
            with pytest.raises(ResponseTimeout):
                await ocu.query("101.1.1", PULSE, timeout=0.02, retries=0)
            node.start()
            await ocu.query("101.1.1", PULSE, timeout=0.5, retries=40)
            assert node.port == port
    assert not node.root.exists()
