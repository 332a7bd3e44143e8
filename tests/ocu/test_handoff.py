"""Two operators: one asks the other for control of a component, who grants or refuses it."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.errors import ConfigError, ControlRejected, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryControl
from jauspy.messages.iop import (
    ConfirmHandoffRequest,
    ConfirmReleaseControl,
    RequestHandoff,
    RequestReleaseControl,
)
from jauspy.services.core import AccessControl, Liveness
from jauspy.services.iop import EnhancedAccessControl
from jauspy.services.iop.handoff import Decision

ME = JausID(101, 1, 1)


def made(virtual_network):
    services = [Liveness(), AccessControl(timeout=3), EnhancedAccessControl(handoff_timeout=5)]
    return virtual_network.component(ME, services)


async def handed_over(virtual_network, decision):
    """What the first client is asked, and who is in control afterwards."""
    asked = []

    def decide(where, request):
        asked.append((where, str(request.client), request.explanation))
        return decision

    first = virtual_network.ocu("42.1.1", decide_handoff=decide)
    second = virtual_network.ocu("43.1.1")
    async with made(virtual_network), first, second:
        async with first.service(ME, "EnhancedAccessControl").control():
            try:
                await second.request_handoff(ME, "I see the door", within=20)
            finally:
                report = await second.query(ME, QueryControl())
        return asked, report.subsystem_id


async def test_granted_handoff(virtual_network):
    asked, subsystem = await handed_over(virtual_network, Decision.GRANTED)
    assert asked == [(ME, "43.1.1", "I see the door")]
    assert subsystem == 43


async def test_denied_handoff(virtual_network):
    with pytest.raises(ControlRejected, match=r"101\.1\.1 did not hand control over: the client in control refused"):
        await handed_over(virtual_network, Decision.DENIED)


async def test_handoff_that_nobody_decides_on_times_out(virtual_network):
    with pytest.raises(ControlRejected, match="the client in control did not answer in time"):
        await handed_over(virtual_network, None)


async def test_component_without_the_service_is_named(virtual_network):
    async with (
        virtual_network.component(ME, [Liveness()]),
        virtual_network.ocu("43.1.1") as second,
    ):
        with pytest.raises(ResponseTimeout, match="check that it offers EnhancedAccessControl"):
            await second.request_handoff(ME, "", within=2)


@pytest.mark.parametrize("kind", [RequestHandoff, RequestReleaseControl, ConfirmReleaseControl, ConfirmHandoffRequest])
@pytest.mark.parametrize("after", [0, 1])
async def test_message_that_is_lost_is_sent_again(virtual_network, kind, after):
    virtual_network.lose(kind, 1, after=after)
    asked, subsystem = await handed_over(virtual_network, Decision.GRANTED)
    assert len(asked) == 1
    assert subsystem == 43


async def test_handoff_that_is_not_decided_in_time_is_told(virtual_network):
    first = virtual_network.ocu("42.1.1", decide_handoff=lambda where, request: Decision.WAIT)
    second = virtual_network.ocu("43.1.1")
    async with made(virtual_network), first, second, first.service(ME, "EnhancedAccessControl").control():
        with pytest.raises(ResponseTimeout, match=r"nothing is decided on the handoff of 101\.1\.1 within 8 s"):
            await second.request_handoff(ME, "", within=8)


async def test_client_that_has_lost_control_asks_for_it(virtual_network):
    """Also inside the block with which it took control, where its commands are refused."""
    first = virtual_network.ocu("42.1.1")
    second = virtual_network.ocu("43.1.1", decide_handoff=lambda where, request: Decision.GRANTED)
    async with (
        made(virtual_network),
        first,
        second,
        first.service(ME, "EnhancedAccessControl").control() as control,
        second.service(ME, "EnhancedAccessControl").control(authority=200),
    ):
        await asyncio.wait_for(control.until_lost(), 5)
        await first.request_handoff(ME, "I am not done", within=8)
        assert (await first.query(ME, QueryControl())).subsystem_id == 42


async def test_explanation_has_the_characters_that_can_be_sent(virtual_network):
    asked = []
    first = virtual_network.ocu("42.1.1", decide_handoff=lambda *shown: asked.append(shown[1].explanation))
    second = virtual_network.ocu("43.1.1")
    async with made(virtual_network), first, second, first.service(ME, "EnhancedAccessControl").control():
        with pytest.raises(ControlRejected):
            await second.request_handoff(ME, "la porte du c\u0153ur co\u00fbte 5 \u20ac", within=8)
    assert asked == ["la porte du c?ur co\u00fbte 5 ?"]


@pytest.mark.parametrize(("explanation", "authority"), [("x" * 256, 100), ("", 256), ("", -1)])
async def test_impossible_requests_are_named(virtual_network, explanation, authority):
    async with virtual_network.ocu("43.1.1") as second:
        with pytest.raises(ConfigError, match="an explanation of up to 255 characters"):
            await second.request_handoff(ME, explanation, authority=authority)
