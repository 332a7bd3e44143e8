"""Communicator: delays and losses that the network has are those that it reports, to a bounded number of clients."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime

import pytest

from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import RequestControl, Resume
from jauspy.messages.iop import (
    QueryCommunicatorCapability,
    QueryCommunicatorConfiguration,
    QueryCommunicatorHealth,
    ReportCommunicatorHealth,
    SetCommunicatorConfiguration,
    SetCommunicatorConfigurationResponse,
)
from jauspy.protocol.addressing import Location
from jauspy.services.core import with_core_services
from jauspy.services.host import Host
from jauspy.services.iop import Communicator, HealthReporter
from jauspy.services.iop.communicator import ASKED_TIMEOUT, MAX_CLIENTS
from jauspy.virtual.network import VirtualNetwork

ME = "101.1.110"
CLIENT = JausID(42, 1, 1)
ALL = 0xFFFF
Rate, Count = ReportCommunicatorHealth.PacketErrorRateRec, ReportCommunicatorHealth.PacketErrorCountRec


async def measured(network: VirtualNetwork, seconds: float = 20.0):
    """What a client is told that asks each second."""
    async with network.component(ME, [Communicator()]), network.ocu("42.1.1", timeout=2.0, retries=5) as ocu:
        first = await ocu.query(ME, QueryCommunicatorHealth(ALL))
        assert first.error_variant == Count(0)
        assert first.report_communicator_health_rec.latency is None
        for _ in range(int(seconds)):
            await asyncio.sleep(1.0)
            report = await ocu.query(ME, QueryCommunicatorHealth(ALL))
        return report


@pytest.mark.parametrize("delay", [0.0, 0.02, 0.045])
async def test_latency_is_that_of_the_network(delay):
    async with VirtualNetwork(delay=delay) as network:
        report = await measured(network)
        assert report.report_communicator_health_rec.latency == pytest.approx(delay, abs=0.002)
        assert report.report_communicator_health_rec.bit_results == 0
        assert report.error_variant == Rate(pytest.approx(0.0))


async def test_loss_is_that_of_round_trips():
    async with VirtualNetwork(loss=0.1, seed=3) as network:
        report = await measured(network, 30.0)
        assert report.error_variant.packet_error_rate == pytest.approx(19.0, abs=12.0)


async def test_a_client_that_went_away_is_reported_failed_and_forgotten():
    async with VirtualNetwork() as network, network.component(ME, [Communicator()]) as component:
        service = component.host.service(Communicator)
        async with network.ocu("42.1.1") as ocu:
            await ocu.query(ME, QueryCommunicatorHealth(ALL))
            await asyncio.sleep(2.0)
            network.disconnect("42.1.1")
            await asyncio.sleep(4.0)
            network.reconnect("42.1.1")
            report = await ocu.query(ME, QueryCommunicatorHealth(ALL))
            assert report.report_communicator_health_rec.bit_results == 1
            await asyncio.sleep(ASKED_TIMEOUT + 2.0)
            assert service._links == {}


class Asked:
    """A component without a network."""

    def __init__(self) -> None:
        services = with_core_services([Communicator()], "")
        self.host = Host(JausID.parse(ME), services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0)

    def ask(self, query, client: JausID = CLIENT) -> list:
        self.host.receive(query.encode(), client, 0.0)
        return [registry.decode(output.payload) for output in self.host.poll_output(0.0)]


def test_a_flood_of_invented_clients_is_bounded_and_the_operator_is_served():
    asked = Asked()
    for number in range(1, 200):
        asked.ask(QueryCommunicatorHealth(ALL), JausID(1000 + number, 1, 1))
    service = asked.host.service(Communicator)
    assert len(service._links) == MAX_CLIENTS
    assert asked.host.counters["too_many_links"] == 199 - MAX_CLIENTS
    operator = JausID(42, 1, 1)
    asked.ask(RequestControl(200), operator)
    asked.ask(QueryCommunicatorHealth(ALL), operator)
    assert operator in service._links
    assert len(service._links) == MAX_CLIENTS


def test_settings_are_none_and_changes_are_refused():
    asked = Asked()
    asked.ask(RequestControl(200))
    asked.ask(Resume())
    change = SetCommunicatorConfiguration
    (answer,) = asked.ask(change(change.SetCommunicatorConfigurationRec(channel=3), change.NoChangeRec(0)))
    assert isinstance(answer, SetCommunicatorConfigurationResponse)
    assert answer.result.other_failure == 1
    (capability,) = asked.ask(QueryCommunicatorCapability())
    assert capability.frequency_band_list == []
    (configuration,) = asked.ask(QueryCommunicatorConfiguration(ALL))
    assert configuration.report_communicator_configuration_rec.channel is None


def load(asked: Asked, seconds: float, sent: int | None, waiting: int | None) -> None:
    """Let time pass, in which the node manager has sent so many bytes in all."""
    asked.host.locate = lambda _, found: found(Location(hosts=frozenset({"192.0.2.7"}), sent=sent, waiting=waiting))
    asked.host.handle_timeout(seconds)


def test_the_rate_is_what_the_node_manager_has_sent_in_ten_seconds():
    asked = Asked()
    asked.host.locate = lambda _, found: found(Location(sent=1000, waiting=0))
    asked.ask(QueryCommunicatorHealth(ALL))
    link = asked.host.service(Communicator)._links[CLIENT]
    assert link.rate is None, "one look tells no rate"
    load(asked, 2.0, 251_000, 0)
    assert link.rate == pytest.approx(1.0)  # 250 kB in 2 s, in Mbit/s
    load(asked, 4.0, 251_000, 0)
    assert link.rate == pytest.approx(0.5)
    load(asked, 6.0, 10, 0)
    assert link.rate is None, "the node manager was restarted"


def test_queues_are_in_the_health_of_the_robot_and_long_ones_are_a_warning():
    services = with_core_services([Communicator(), HealthReporter([])], "")
    asked = Asked()
    asked.host = Host(JausID.parse(ME), services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0)
    asked.host.locate = lambda _, found: found(Location(waiting=10))
    asked.ask(QueryCommunicatorHealth(ALL))
    reporter = asked.host.service(HealthReporter)
    load(asked, 2.0, None, 200_000)
    asked.host.handle_timeout(3.5)
    (entry,) = reporter.entries
    assert (entry.severity.name, entry.text) == ("WARN", "195 kB wait to be sent to 42.1.1")
    load(asked, 4.0, None, 0)
    asked.host.handle_timeout(5.5)
    assert [entry.severity.name for entry in reporter.entries] == ["NONE"]


def test_what_limits_of_the_link_left_out_in_ten_seconds_is_in_the_health_of_the_robot():
    services = with_core_services([Communicator(), HealthReporter([])], "")
    asked = Asked()
    asked.host = Host(JausID.parse(ME), services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0)

    def look(seconds: float, **left_out: int) -> None:
        asked.host.locate = lambda _, found: found(Location(left_out=tuple(left_out.items())))
        asked.host.handle_timeout(seconds)

    asked.host.locate = lambda _, found: found(Location(left_out=(("ReportStatus 4002h", 7),)))
    asked.ask(QueryCommunicatorHealth(ALL))
    look(2.0, **{"ReportStatus 4002h": 7, "ReportLocalPose 4403h": 5})
    look(4.0, **{"ReportStatus 4002h": 9, "ReportLocalPose 4403h": 20})
    asked.host.handle_timeout(5.5)
    texts = [entry.text for entry in asked.host.service(HealthReporter).entries]
    assert "the link to 42.1.1 leaves out 20 ReportLocalPose 4403h, 2 ReportStatus 4002h in 10 s" in texts
    look(6.0)  # the node manager was restarted
    asked.host.handle_timeout(7.5)
    assert not any("leaves out" in entry.text for entry in asked.host.service(HealthReporter).entries)
