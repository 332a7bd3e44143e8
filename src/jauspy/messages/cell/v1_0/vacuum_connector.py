"""urn:jauspy:cell:VacuumConnector 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:VacuumConnector", "1.0")


@jd.message(_SERVICE, 0xDA62, command=True)
class SetConnector(jd.Message):
    """SetConnector (0xDA62): Enables a connector, or lets air in.

    connector: 1..255. Number of the connector of the part, from 1
    enabled: Enabled. Whether the pump runs
    """

    class Enabled(IntEnum):
        DISABLED = 0
        ENABLED = 1

    connector: int = jd.field("Connector", jd.Number("B", jd.Values(None, ((1, 255),))))
    enabled: SetConnector.Enabled | int = jd.field("Enabled", lambda: jd.Number("B", jd.Values(SetConnector.Enabled)))


@jd.message(_SERVICE, 0xDA6A, command=True)
class ScheduleConnector(jd.Message):
    """ScheduleConnector (0xDA6A): Enables a connector, or lets air in, after a time. The next command for the connector takes its place, and leaving Ready cancels it.

    connector: 1..255. Number of the connector of the part, from 1
    enabled: Enabled. Whether the pump runs
    delay: in second. Seconds by the clock of the robot, 0 to 60
    """

    class Enabled(IntEnum):
        DISABLED = 0
        ENABLED = 1

    connector: int = jd.field("Connector", jd.Number("B", jd.Values(None, ((1, 255),))))
    enabled: ScheduleConnector.Enabled | int = jd.field("Enabled", lambda: jd.Number("B", jd.Values(ScheduleConnector.Enabled)))
    delay: float = jd.field("Delay", jd.Number("d", jd.ANY, "second"))


@jd.message(_SERVICE, 0xFA63, presence="I")
class ReportConnectorState(jd.Message):
    """ReportConnectorState (0xFA63): Tells the state of a connector.

    connector: 1..255. Number of the connector of the part, from 1
    enabled: Enabled, optional. Whether the pump runs
    attached_to: up to 255 characters, optional. Name of the part that it holds; empty without one
    offset_x: in meter, optional. X of the frame of the attached part in the frame of the connector, in metres
    offset_y: in meter, optional. Y of the frame of the attached part in the frame of the connector, in metres
    offset_z: in meter, optional. Z of the frame of the attached part in the frame of the connector, in metres
    offset_roll: in radian, optional. Roll of that frame, about fixed axes, in radians
    offset_pitch: in radian, optional. Pitch of that frame, about fixed axes, in radians
    offset_yaw: in radian, optional. Yaw of that frame, about fixed axes, in radians
    force: in newton, optional. Magnitude of the force that it holds, in newtons
    moment: in newton meter, optional. Magnitude of the moment that it holds, in newton metres
    broken_off: optional. How often an overload has released what was attached
    error: Error, optional. Why the last attachment ended or did not come about
    error_text: up to 255 characters, optional. The same in words; empty after a success
    load_mass: in kilogram, optional. Mass of all that hangs on the gripper, as the robot's motors tell while it moves
    load_mass_deviation: in kilogram, optional. Standard deviation of that mass; absent while the mass is not known
    utilisation: optional. Fraction of the strength of the connection that the load uses; above 1 it breaks off
    vacuum: in pascal, optional. Pressure below that of the surroundings, in pascals
    latched: Latched, optional. Whether the attached part is locked mechanically
    """

    class Enabled(IntEnum):
        DISABLED = 0
        ENABLED = 1

    class Error(IntEnum):
        NO_ERROR = 0
        NO_CONTACT = 1
        TOO_FAR = 2
        NOT_ALIGNED = 3
        ATTACHMENT_FAILED = 4
        OVERLOADED = 5
        NO_POWER = 6
        OTHER_ERROR = 7

    class Latched(IntEnum):
        NOT_LATCHED = 0
        LATCHED = 1

    connector: int = jd.field("Connector", jd.Number("B", jd.Values(None, ((1, 255),))))
    enabled: ReportConnectorState.Enabled | int | None = jd.field("Enabled", lambda: jd.Number("B", jd.Values(ReportConnectorState.Enabled)), default=None)
    attached_to: str | None = jd.field("AttachedTo", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    offset_x: float | None = jd.field("OffsetX", jd.Number("f", jd.ANY, "meter"), default=None)
    offset_y: float | None = jd.field("OffsetY", jd.Number("f", jd.ANY, "meter"), default=None)
    offset_z: float | None = jd.field("OffsetZ", jd.Number("f", jd.ANY, "meter"), default=None)
    offset_roll: float | None = jd.field("OffsetRoll", jd.Number("f", jd.ANY, "radian"), default=None)
    offset_pitch: float | None = jd.field("OffsetPitch", jd.Number("f", jd.ANY, "radian"), default=None)
    offset_yaw: float | None = jd.field("OffsetYaw", jd.Number("f", jd.ANY, "radian"), default=None)
    force: float | None = jd.field("Force", jd.Number("f", jd.ANY, "newton"), default=None)
    moment: float | None = jd.field("Moment", jd.Number("f", jd.ANY, "newton meter"), default=None)
    broken_off: int | None = jd.field("BrokenOff", jd.Number("H"), default=None)
    error: ReportConnectorState.Error | int | None = jd.field("Error", lambda: jd.Number("B", jd.Values(ReportConnectorState.Error)), default=None)
    error_text: str | None = jd.field("ErrorText", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    load_mass: float | None = jd.field("LoadMass", jd.Number("f", jd.ANY, "kilogram"), default=None)
    load_mass_deviation: float | None = jd.field("LoadMassDeviation", jd.Number("f", jd.ANY, "kilogram"), default=None)
    utilisation: float | None = jd.field("Utilisation", jd.Number("f"), default=None)
    vacuum: float | None = jd.field("Vacuum", jd.Number("f", jd.ANY, "pascal"), default=None)
    latched: ReportConnectorState.Latched | int | None = jd.field("Latched", lambda: jd.Number("B", jd.Values(ReportConnectorState.Latched)), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xEA63, query=True)
class QueryConnectorState(jd.Message):
    """QueryConnectorState (0xEA63): Asks for the state of a connector.

    presence_vector: Which fields the report is to have, by bit
    connector: 1..255. Number of the connector of the part, from 1
    """
    REPORT = ReportConnectorState
    presence_vector: int = jd.field("PresenceVector", jd.Number("I"))
    connector: int = jd.field("Connector", jd.Number("B", jd.Values(None, ((1, 255),))))


@jd.message(_SERVICE, 0xFA64)
class ReportConnectorSpecification(jd.Message):
    """ReportConnectorSpecification (0xFA64): Tells the connectors of the part and their limits.

    connector_list: 0..255 items. The connectors, by number from 1
    """

    @jd.record()
    class ConnectorLimitsRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        type: up to 255 characters. Type of the part
        max_distance: in meter. Largest distance of the plates at which it attaches, in metres
        max_angle: in radian. Largest angle between the plates at which it attaches, in radians
        max_force: in newton. Largest force that it holds, in newtons
        max_moment: in newton meter. Largest moment that it holds, in newton metres
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        type: str = jd.field("Type", jd.Text(count=jd.Count("B", 0, 255)))
        max_distance: float = jd.field("MaxDistance", jd.Number("f", jd.ANY, "meter"))
        max_angle: float = jd.field("MaxAngle", jd.Number("f", jd.ANY, "radian"))
        max_force: float = jd.field("MaxForce", jd.Number("f", jd.ANY, "newton"))
        max_moment: float = jd.field("MaxMoment", jd.Number("f", jd.ANY, "newton meter"))

    @jd.record()
    class ConnectorNameRec(jd.Struct):
        """connector_name: up to 255 characters. Name of the connector"""
        connector_name: str = jd.field("ConnectorName", jd.Text(count=jd.Count("B", 0, 255)))

    connector_limits_rec: ReportConnectorSpecification.ConnectorLimitsRec = jd.field("ConnectorLimitsRec", lambda: ReportConnectorSpecification.ConnectorLimitsRec.layout())
    connector_list: list[ReportConnectorSpecification.ConnectorNameRec] = jd.field("ConnectorList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportConnectorSpecification.ConnectorNameRec.layout()))


@jd.message(_SERVICE, 0xEA64, query=True)
class QueryConnectorSpecification(jd.Message):
    """QueryConnectorSpecification (0xEA64): Asks for the connectors of the part and their limits."""
    REPORT = ReportConnectorSpecification
