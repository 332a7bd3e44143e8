"""urn:jaus:jss:iop:LeaderManagement 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:LeaderManagement", "1.1")


@jd.message(_SERVICE, 0xFFD4)
class ReportFollowers(jd.Message):
    """ReportFollowers (0xFFD4): Tells who is registered as a follower.

    follower_list: 0..255 items. Registered followers
    """

    @jd.bit_field("I")
    class Follower_ID(jd.Struct):
        """Address of the follower's component.

        component_id: bits 0..7. Component ID.
        node_id: bits 8..15. Node ID.
        subsystem_id: bits 16..31. Subsystem ID.
        """
        component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((0, 255),)))
        node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((0, 255),)))
        subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((0, 65535),)))

    @jd.record()
    class FollowerRec(jd.Struct):
        """follower_id: Address of the follower's component"""
        follower_id: ReportFollowers.Follower_ID = jd.field("Follower_ID", lambda: ReportFollowers.Follower_ID.layout())

    follower_list: list[ReportFollowers.FollowerRec] = jd.field("FollowerList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportFollowers.FollowerRec.layout()))


@jd.message(_SERVICE, 0xFFD3, query=True)
class QueryFollowers(jd.Message):
    """QueryFollowers (0xFFD3): Asks who is registered as a follower."""
    REPORT = ReportFollowers


@jd.message(_SERVICE, 0xFFD2, query=True)
class RegisterFollower(jd.Message):
    """RegisterFollower (0xFFD2): Registers the sender as a follower or ends its registration; needed only to influence the speed.

    request_type: RequestType. Start or end of the registration
    """

    class RequestType(IntEnum):
        CONNECT = 0
        DISCONNECT = 1

    request_type: RegisterFollower.RequestType | int = jd.field("RequestType", lambda: jd.Number("B", jd.Values(RegisterFollower.RequestType)))


@jd.message(_SERVICE, 0xFFD1, query=True)
class RequestSpeedOverride(jd.Message):
    """RequestSpeedOverride (0xFFD1): A follower asks the leader to change its speed.

    override_type: Relative or absolute wish
    """

    @jd.record()
    class PercentRec(jd.Struct):
        """speed_override_percent: 0..100. Wanted share of the leader's original speed, in percent"""
        speed_override_percent: float = jd.field("SpeedOverridePercent", jd.real("B", 0.0, 100.0))

    @jd.record()
    class AbsoluteRec(jd.Struct):
        """speed_override_absolute: 0..327.67 meter per second. Wanted speed"""
        speed_override_absolute: float = jd.field("SpeedOverrideAbsolute", jd.real("H", 0.0, 327.67, "meter per second"))

    override_type: RequestSpeedOverride.PercentRec | RequestSpeedOverride.AbsoluteRec = jd.field("OverrideType", lambda: jd.Union.of("B", percent_rec=RequestSpeedOverride.PercentRec, absolute_rec=RequestSpeedOverride.AbsoluteRec))


@jd.message(_SERVICE, 0xFFD5)
class RegisterFollowerResponse(jd.Message):
    """RegisterFollowerResponse (0xFFD5): Answers a registration; also sent unasked when a follower fails to renew it.

    result: Result. State of the registration
    timeout: in second. Time within which the follower has to register anew
    """

    class Result(IntEnum):
        CONNECTED = 0
        DISCONNECTED = 1

    result: RegisterFollowerResponse.Result | int = jd.field("Result", lambda: jd.Number("B", jd.Values(RegisterFollowerResponse.Result)))
    timeout: int = jd.field("Timeout", jd.Number("B", jd.ANY, "second"))
