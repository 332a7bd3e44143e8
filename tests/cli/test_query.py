"""`jauspy query` of a component that does not offer what it is asked for."""

from __future__ import annotations

import pytest

from jauspy.cli.query import _ask
from jauspy.errors import ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryHeartbeatPulse
from jauspy.messages.manipulator import QueryJointPositions
from jauspy.services.core import Liveness


async def test_a_query_that_is_not_offered_says_so(virtual_network):
    async with virtual_network.component("7.1.1", [Liveness()]):
        with pytest.raises(ResponseTimeout, match=r"7\.1\.1 does not offer QueryJointPositions of manipulator:"):
            await _ask(virtual_network.ocu(), JausID(7, 1, 1), QueryJointPositions())
    with pytest.raises(ResponseTimeout, match=r"QueryHeartbeatPulse .* times in .* and no answer came"):
        await _ask(virtual_network.ocu(), JausID(7, 1, 1), QueryHeartbeatPulse())
