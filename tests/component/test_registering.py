"""A component on the list of another one's Discovery, for clients that ask only there."""

from __future__ import annotations

import asyncio
from contextlib import AbstractAsyncContextManager

import pytest

import jauspy
from jauspy.errors import ConfigError
from jauspy.messages.core import (
    QueryConfiguration,
    QueryIdentification,
    RegisterServices,
    ReportConfiguration,
    ReportIdentification,
)
from jauspy.services.core import Discovery, Liveness
from jauspy.services.core.discovery import REGISTRATION_INTERVAL
from jauspy.testing import VirtualNetwork

MASTER, PUMP, ELSEWHERE = "101.1.1", "101.1.7", "101.1.8"


def master(network: VirtualNetwork) -> AbstractAsyncContextManager[jauspy.Component]:
    return network.component(MASTER, [Liveness()])


def pump(network: VirtualNetwork, id: str = PUMP) -> AbstractAsyncContextManager[jauspy.Component]:
    return network.component(id, [Liveness(), Discovery(register_with=MASTER)])


async def listed(ocu: jauspy.OCU) -> list[int]:
    """The components that the master knows of."""
    report = await ocu.query(MASTER, QueryConfiguration(query_type=3), expects=ReportConfiguration)
    return [each.component_id for node in report.node_list for each in node.component_list]


async def test_component_is_listed_while_it_runs(virtual_network, ocu):
    async with master(virtual_network):
        async with pump(virtual_network):
            await asyncio.sleep(2 * REGISTRATION_INTERVAL)
            assert await listed(ocu) == [1, 7]
            assert len(virtual_network.sent(RegisterServices)) == 3
        assert await listed(ocu) == [1]


async def test_component_registers_again_with_a_restarted_master(virtual_network, ocu):
    async with pump(virtual_network):
        await asyncio.sleep(1.0)
        async with master(virtual_network):
            assert await listed(ocu) == [1]
            await asyncio.sleep(REGISTRATION_INTERVAL)
            assert await listed(ocu) == [1, 7]


async def test_moved_component_is_listed_under_its_new_id(virtual_network, ocu):
    async with master(virtual_network), pump(virtual_network) as component:
        await asyncio.sleep(1.0)
        assert await listed(ocu) == [1, 7]
        component.move(ELSEWHERE)
        await asyncio.sleep(1.0)
        assert await listed(ocu) == [1, 8]


async def test_component_registers_when_it_is_assigned_an_id(virtual_network, ocu):
    async with master(virtual_network), pump(virtual_network, "0.0.7") as component:
        await asyncio.sleep(1.0)
        assert await listed(ocu) == [1]
        component.move(PUMP)
        await asyncio.sleep(1.0)
        assert await listed(ocu) == [1, 7]


async def test_move_to_another_subsystem_is_counted(virtual_network):
    async with pump(virtual_network, "0.0.7") as component:
        component.move("102.1.7")
        await asyncio.sleep(1.0)
        assert component.counters["host.not_registered"] == 1
        assert not virtual_network.sent(RegisterServices)


@pytest.mark.parametrize("id", ["102.1.7", MASTER])
def test_registration_with_itself_or_another_subsystem_is_rejected(id: str) -> None:
    with pytest.raises(ConfigError, match=r"cannot register with 101\.1\.1"):
        jauspy.Component(id, [Liveness(), Discovery(register_with=MASTER)])


async def test_given_name_is_kept(virtual_network, ocu):
    async with virtual_network.component(PUMP, [Discovery(register_with=MASTER)], name="pump"):
        report = await ocu.query(PUMP, QueryIdentification(query_type=4), expects=ReportIdentification)
        assert report.identification == "pump"


@pytest.mark.parametrize("id", ["101.0.1", "0.0.1", "101.1.255", "x"])
def test_invalid_register_with_is_rejected(id: str) -> None:
    with pytest.raises(ConfigError):
        Discovery(register_with=id)
