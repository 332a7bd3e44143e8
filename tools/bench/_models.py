"""Messages for the benchmark that are in no service set: a list of joint efforts, and two of MAVLink's as JSIDL."""

from __future__ import annotations

from jauspy.codec.build import load_schema
from jauspy.codec.registry import Registry
from jauspy.schema import model as m


def number(name: str, kind: m.Scalar, scale: m.Scale | None = None) -> m.FixedField:
    """A number that is always there."""
    return m.FixedField(name=name, type=kind, scale=scale)


def array(name: str, size: int) -> m.Array:
    """Floats."""
    return m.Array(name=name, element=number("Value", "f32"), dimensions=(m.Dimension("Index", size),))


def record(name: str, *fields: m.Field) -> m.Record:
    """A body."""
    return m.Record(name=name, fields=fields)


EFFORT = record("EffortRec", number("JointEffort", "u16", m.Scale(-100.0, 100.0)))
ATTITUDE = record(
    "AttitudeRec",
    number("TimeBootMs", "u32"),
    *(number(name, "f32") for name in ("Roll", "Pitch", "Yaw", "RollSpeed", "PitchSpeed", "YawSpeed")),
)
ODOMETRY = record(
    "OdometryRec",
    number("TimeUsec", "u64"),
    *(number(name, "f32") for name in ("X", "Y", "Z")),
    array("Q", 4),
    *(number(name, "f32") for name in ("Vx", "Vy", "Vz", "RollSpeed", "PitchSpeed", "YawSpeed")),
    array("PoseCovariance", 21),
    array("VelocityCovariance", 21),
    *(number(name, "u8") for name in ("FrameId", "ChildFrameId", "ResetCounter", "EstimatorType")),
    number("Quality", "i8"),
)


def message(name: str, code: int, body: m.Composite) -> m.MessageDefinition:
    """A report."""
    return m.MessageDefinition(name=name, code=code, is_command=False, body=body)


def registry() -> Registry:
    """The messages, generated as those of a user's own JSIDL are."""
    efforts = m.List(name="EffortList", count=m.Count("u8", 0, 255), element=EFFORT)
    messages = (
        message("SetEfforts", 0xD601, efforts),
        message("Attitude", 0xF00A, ATTITUDE),
        message("Odometry", 0xF00B, ODOMETRY),
    )
    service = m.ServiceDefinition(
        name="Bench", id="urn:jauspy:bench:Bench", version="1.0", jsidl="1.1", outputs=messages
    )
    return load_schema(m.Schema(services=(service,)))
