"""urn:jaus:jss:iop:PlatformState 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import management as core_v1_0_management

_SERVICE = jd.Service("urn:jaus:jss:iop:PlatformState", "1.1")


@jd.message(_SERVICE, 0xFF25, command=True)
class SetPlatformState(jd.Message):
    """SetPlatformState (0xFF25): Sets the state of the platform.

    platform_state: PlatformState. The state
    """

    class PlatformState(IntEnum):
        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    platform_state: SetPlatformState.PlatformState | int = jd.field("PlatformState", lambda: jd.Number("B", jd.Values(SetPlatformState.PlatformState)))


@jd.message(_SERVICE, 0xFF28)
class ReportPlatformState(jd.Message):
    """ReportPlatformState (0xFF28): Tells the state of the platform.

    platform_state: PlatformState. The state
    """

    class PlatformState(IntEnum):
        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    platform_state: ReportPlatformState.PlatformState | int = jd.field("PlatformState", lambda: jd.Number("B", jd.Values(ReportPlatformState.PlatformState)))


@jd.message(_SERVICE, 0xFF26, query=True)
class QueryPlatformState(jd.Message):
    """QueryPlatformState (0xFF26): Asks for the state of the platform."""
    REPORT = ReportPlatformState

@jd.derived(_SERVICE)
class SetEmergency(core_v1_0_management.SetEmergency): ...

@jd.derived(_SERVICE)
class ClearEmergency(core_v1_0_management.ClearEmergency): ...


@jd.message(_SERVICE, 0xFF27)
class ConfirmPlatformStateRequest(jd.Message):
    """ConfirmPlatformStateRequest (0xFF27): Tells whether the state of the platform is changing.

    platform_state: PlatformState. The state that was asked for
    response_code: ResponseCode. Whether the state is changing
    """

    class PlatformState(IntEnum):
        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    class ResponseCode(IntEnum):
        TRANSITIONING = 0
        INVALID_STATE = 1

    platform_state: ConfirmPlatformStateRequest.PlatformState | int = jd.field("PlatformState", lambda: jd.Number("B", jd.Values(ConfirmPlatformStateRequest.PlatformState)))
    response_code: ConfirmPlatformStateRequest.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(ConfirmPlatformStateRequest.ResponseCode)))
