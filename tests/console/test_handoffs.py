"""Handoff between pages of the console and other clients, on the virtual network."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import NamedTuple

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")

from jauspy.console.handoffs import MAX_SHOWN, Handoffs
from jauspy.console.users import LOCAL
from jauspy.errors import ControlRejected
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.services.iop.handoff import Decision, HandoffRequest
from jauspy.testing import VirtualNetwork, until

MASTER = JausID(101, 1, 110)
MINE, OTHERS = "my page", "another page"


class Scene(NamedTuple):
    handoffs: Handoffs
    other: OCU
    events: list[str]


@asynccontextmanager
async def scene(network: VirtualNetwork) -> AsyncIterator[Scene]:
    """A robot, the console's side, and another client."""
    async with network.robot(), network.ocu("42.1.1") as ocu, network.ocu("43.1.1") as other:
        robots, events = {101: await ocu.robot(101)}, list[str]()
        handoffs = Handoffs(ocu, lambda: robots, events.append, lambda _: None)
        try:
            yield Scene(handoffs, other, events)
        finally:
            await handoffs.close()


@pytest.mark.slow
@pytest.mark.parametrize("grants", [True, False])
async def test_the_page_that_holds_it_decides(virtual_network: VirtualNetwork, grants: bool) -> None:
    async with scene(virtual_network) as found:
        handoffs = found.handoffs
        assert await handoffs.take(MINE, LOCAL, MASTER, 127) == ""
        asks = asyncio.create_task(found.other.request_handoff(MASTER, "I see the door"))
        await until(lambda: bool(handoffs.requests(MASTER)), within=5)
        (request,) = handoffs.requests(MASTER)
        assert (str(request.client), request.explanation) == ("43.1.1", "I see the door")
        handoffs.answer(OTHERS, MASTER, request.id, grant=True)
        await asyncio.sleep(1.0)
        assert not asks.done(), "only the page that holds it decides"
        assert handoffs.requests(MASTER) == [request]
        handoffs.answer(MINE, MASTER, request.id, grant=grants)
        if grants:
            await asks
            await until(lambda: handoffs.held(MASTER) is None, within=5)
        else:
            with pytest.raises(ControlRejected, match="refused"):
                await asks
            assert handoffs.held(MASTER) is not None
        assert any("I see the door" in event for event in found.events)


@pytest.mark.slow
async def test_a_page_asks_and_holds_what_it_gets_until_it_ends(virtual_network: VirtualNetwork) -> None:
    async with scene(virtual_network) as found:
        handoffs, robot = found.handoffs, await found.other.robot(101)
        found.other.decide_handoffs(lambda _, __: Decision.GRANTED)
        async with robot.component(MASTER).service("EnhancedAccessControl").control():
            assert "43.1.1" in await handoffs.take(MINE, LOCAL, MASTER, 127)
            assert await handoffs.ask(MINE, LOCAL, MASTER, 127, "the stairs") == ""
            assert handoffs.held(MASTER) is not None
            assert "in another browser" in await handoffs.take(OTHERS, LOCAL, MASTER, 127)
        await handoffs.forget(MINE)
        assert handoffs.held(MASTER) is None
        assert await handoffs.take(OTHERS, LOCAL, MASTER, 127) == ""


async def test_requests_are_bounded_and_end(monkeypatch: pytest.MonkeyPatch) -> None:
    handoffs = Handoffs(OCU("42.1.1"), dict, lambda _: None, lambda _: None)
    for id in range(200):
        handoffs._on_request(MASTER, HandoffRequest(id, JausID(43, 1, 1), 1, "x"))
    assert len(handoffs.requests(MASTER)) == MAX_SHOWN
    monkeypatch.setattr("jauspy.console.handoffs.REQUEST_TIME", -1.0)
    assert handoffs.requests(MASTER) == []
