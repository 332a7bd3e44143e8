"""urn:jaus:jss:mobility:LocalVectorDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalVectorDriver", "1.0")


@jd.message(_SERVICE, 0x0408, presence="B", command=True)
class SetLocalVector(jd.Message):
    """SetLocalVector (0x0408): Sets heading, speed and attitude in the local frame.

    speed: 0..327.67 meter per second, optional. Wanted speed, in metres per second
    z: -10000..35000 meter, optional. Wanted position along Z of the local frame, in metres
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is along X
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    """
    speed: float | None = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"), default=None)
    z: float | None = jd.field("Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4408, presence="B")
class ReportLocalVector(jd.Message):
    """ReportLocalVector (0x4408): Tells the commanded heading, speed and attitude in the local frame.

    speed: 0..327.67 meter per second, optional. Wanted speed, in metres per second
    z: -10000..35000 meter, optional. Wanted position along Z of the local frame, in metres
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is along X
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    """
    speed: float | None = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"), default=None)
    z: float | None = jd.field("Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2408, query=True)
class QueryLocalVector(jd.Message):
    """QueryLocalVector (0x2408): Asks for the commanded heading, speed and attitude in the local frame.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalVector
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x1F)
