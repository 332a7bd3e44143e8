"""A robot that follows another one, and the convoy that it is part of (IOP v3)."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID, component_id
from jauspy.messages.iop import (
    QueryFollowerConfiguration,
    ReportFollowerConfiguration,
    SetFollowerConfiguration,
    SetFollowerState,
    UpdateConvoyDetails,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import check_ready
from jauspy.ocu.service import ServiceClient

DRIVER: Final = "iop:LeaderFollowerDriver"
CONVOY: Final = "iop:Convoy"
START_TIME: Final = 1.0
"""Seconds after START within which a robot that cannot follow has ended it: the leader's pose takes a moment."""
POLL_PERIOD: Final = 0.1
"""Seconds between two queries for the state."""


@dataclass(frozen=True, slots=True)
class Following:
    """The state of a follower, in metres and seconds; the offset is positive to the left."""

    is_following: bool
    leader: JausID | None
    gap: float | None
    lag: float | None
    max_gap: float | None
    offset: float | None


Offering = Callable[..., ServiceClient | None]
"""The client of the first of these services that the robot offers."""


class Follower:
    """The client of a robot's LeaderFollowerDriver; `offering` finds its services."""

    def __init__(self, connection: Connection, offering: Offering) -> None:
        self._connection = connection
        self._offering = offering

    async def follow(
        self,
        leader: int | str | JausID,
        *,
        gap: float,
        lag: float,
        max_gap: float,
        offset: float,
        may_slow: bool,
        may_stop: bool,
    ) -> None:
        """See `Robot.follow`."""
        for value, use in ((gap, "gap"), (lag, "lag"), (max_gap, "max_gap"), (offset, "offset")):
            check_number(value, use)
            if not math.isfinite(value):
                raise ConfigError(f"{use}={value:g}: give a number of metres or seconds")
        if min(gap, lag) < 0.0 or max_gap <= gap:
            raise ConfigError(f"gap={gap:g} and lag={lag:g} must not be negative, and max_gap={max_gap:g} above gap")
        driver = self._driver()
        ahead = _leader_id(leader, driver.id)
        if ahead.subsystem == driver.id.subsystem:
            raise ConfigError(f"leader={leader}: a robot cannot follow itself")
        await check_ready(self._connection, driver.id)
        await self._connection.send_checked(
            driver.id,
            SetFollowerConfiguration(
                leader_id=SetFollowerConfiguration.Leader_ID(ahead.component, ahead.node, ahead.subsystem),
                error_behavior=SetFollowerConfiguration.ErrorBehavior(
                    stop_leader=int(may_stop), allow_leader_override=int(may_slow)
                ),
                lag_time=lag,
                minimum_follow_distance=gap,
                maximum_follow_distance=max_gap,
                lateral_offset=-offset,
            ),
            ack=True,
        )
        await self._connection.send_checked(driver.id, SetFollowerState(SetFollowerState.State.START), ack=True)
        clock = asyncio.get_running_loop().time
        end = clock() + START_TIME
        while clock() < end:
            if not (await self.state()).is_following:
                raise RequestError(
                    f"{driver.id} does not follow {ahead}: the leader is not there, more than {max_gap:g} m away, or "
                    "the robot was stopped; the log of the robot has the reason"
                )
            await asyncio.sleep(POLL_PERIOD)

    async def stop(self) -> None:
        """See `Robot.stop_following`."""
        driver = self._driver()
        await self._connection.send_checked(driver.id, SetFollowerState(SetFollowerState.State.STOP), ack=True)

    async def state(self) -> Following:
        """See `Robot.following`."""
        report = await self._driver().query(QueryFollowerConfiguration(), expects=ReportFollowerConfiguration)
        settings, state = report.follower_configuration_rec, report.follower_state_rec.state
        ahead = settings.leader_id
        return Following(
            is_following=state == ReportFollowerConfiguration.State.START,
            leader=None if ahead is None else JausID(ahead.subsystem_id, ahead.node_id, ahead.component_id),
            gap=settings.minimum_follow_distance,
            lag=settings.lag_time,
            max_gap=settings.maximum_follower_distance,
            offset=None if settings.lateral_offset is None else -settings.lateral_offset,
        )

    async def set_convoy(self, subsystem: int, followers: tuple[int, ...]) -> None:
        """See `Robot.set_convoy`."""
        service = self._offering(CONVOY)
        if service is None:
            raise ConfigError(f"this robot keeps no convoy: it does not offer {CONVOY}")
        column = (subsystem, *followers)
        for number in column:
            check_number(number, "a follower", whole=True)
            if not 1 <= number <= 65534:
                raise ConfigError(f"a follower is {number}; it must be the number of a subsystem, 1..65534")
        if len(set(column)) < len(column):
            raise ConfigError(f"a convoy of {', '.join(map(str, column))}: each robot drives in it once")
        orders = [
            UpdateConvoyDetails.ConvoyOrderRec(ahead, behind) for ahead, behind in zip(column, followers, strict=False)
        ]
        record = UpdateConvoyDetails.ConvoyRecord(1, subsystem)
        convoys = [UpdateConvoyDetails.ConvoySeq(record, orders)] if followers else []
        await self._connection.send_checked(service.id, UpdateConvoyDetails(convoys), ack=True)

    def _driver(self) -> ServiceClient:
        driver = self._offering(DRIVER)
        if driver is None:
            raise ConfigError(f"this robot follows no other: it does not offer {DRIVER}")
        return driver


def _leader_id(leader: int | str | JausID, own: JausID) -> JausID:
    """The component that reports the leader's pose: of a subsystem, the one with the numbers of the own driver."""
    if isinstance(leader, int):
        check_number(leader, "leader", whole=True)
    found = component_id(replace(own, subsystem=leader) if isinstance(leader, int) else leader)
    if not (found.subsystem and found.node):
        raise ConfigError(f"leader={leader}: {found} is not the id of a component, as in 101.1.102")
    return found
