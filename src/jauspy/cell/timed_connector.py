"""A motion of the modular arm during which a connector is set, as in a throw."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from contextlib import suppress

from jauspy.cell.client import CellClient
from jauspy.errors import JausError


async def begin_motion(
    cell: CellClient, vector: Sequence[float], duration: float, connector: str, after: float, *, enabled: bool
) -> None:
    """Begin a motion of the modular arm, and set a connector so many seconds after its start.

    Both commands leave together, and the robot counts the seconds: a client that sent the second one in time would be
    late by what its machine and the network take, and box and tip move by 3 mm in each millisecond of a throw. If one
    of them fails, the connector stays as it is.
    """
    commands = cell.command_arm(vector, duration), cell.enable(connector, enabled, after=after)
    for failure in await asyncio.gather(*commands, return_exceptions=True):
        if isinstance(failure, BaseException):
            with suppress(JausError):
                await cell.enable(connector, not enabled)  # takes the place of what is to come
            raise failure
