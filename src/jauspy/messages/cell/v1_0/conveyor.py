"""urn:jauspy:cell:Conveyor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:Conveyor", "1.0")


@jd.message(_SERVICE, 0xDA63, command=True)
class SetConveyorSpeed(jd.Message):
    """SetConveyorSpeed (0xDA63): Runs the belt at a speed until the next one.

    speed: in meter per second. Speed in metres per second, limited to the largest one; negative is backward
    """
    speed: float = jd.field("Speed", jd.Number("f", jd.ANY, "meter per second"))


@jd.message(_SERVICE, 0xFA65, presence="B")
class ReportConveyorState(jd.Message):
    """ReportConveyorState (0xFA65): Tells the motion of the belt.

    commanded_speed: in meter per second, optional. Speed that was set, in metres per second
    speed: in meter per second, optional. Present speed, in metres per second
    position: in meter, optional. How far the belt has travelled, in metres
    max_speed: in meter per second, optional. Largest speed, in metres per second
    """
    commanded_speed: float | None = jd.field("CommandedSpeed", jd.Number("f", jd.ANY, "meter per second"), default=None)
    speed: float | None = jd.field("Speed", jd.Number("f", jd.ANY, "meter per second"), default=None)
    position: float | None = jd.field("Position", jd.Number("d", jd.ANY, "meter"), default=None)
    max_speed: float | None = jd.field("MaxSpeed", jd.Number("f", jd.ANY, "meter per second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xEA65, query=True)
class QueryConveyorState(jd.Message):
    """QueryConveyorState (0xEA65): Asks for the motion of the belt.

    presence_vector: Which fields the report is to have, by bit
    """
    REPORT = ReportConveyorState
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0xF)
