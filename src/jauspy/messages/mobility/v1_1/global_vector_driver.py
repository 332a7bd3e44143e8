"""urn:jaus:jss:mobility:GlobalVectorDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_vector_driver as mobility_v1_0_global_vector_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalVectorDriver", "1.1")

@jd.derived(_SERVICE)
class SetGlobalVector(mobility_v1_0_global_vector_driver.SetGlobalVector): ...


@jd.message(_SERVICE, 0x04A7, presence="B", command=True)
class SetGlobalVectorExt(jd.Message):
    """SetGlobalVectorExt (0x04A7): Sets heading, attitude and one of several kinds of speed on the globe.

    speed: Wanted speed, and its kind
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is true north
    course: -3.14159265359..3.14159265359 radian, optional. Wanted direction of travel, in radians; 0 is true north
    """
    Speed = mobility_v1_0_types.Speed
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    speed: mobility_v1_0_types.Speed = jd.field("Speed", lambda: mobility_v1_0_types.Speed.layout())
    z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportGlobalVector(mobility_v1_0_global_vector_driver.ReportGlobalVector): ...

@jd.derived(_SERVICE)
class QueryGlobalVector(mobility_v1_0_global_vector_driver.QueryGlobalVector):
    REPORT = ReportGlobalVector


@jd.message(_SERVICE, 0x44A7, presence="B")
class ReportGlobalVectorExt(jd.Message):
    """ReportGlobalVectorExt (0x44A7): Tells the commanded vector on the globe, with the kind of speed.

    speed: Wanted speed, and its kind
    z_position: optional. Vertical position and its datum
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Wanted direction, in radians; 0 is true north
    course: -3.14159265359..3.14159265359 radian, optional. Wanted direction of travel, in radians; 0 is true north
    """
    Speed = mobility_v1_0_types.Speed
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    speed: mobility_v1_0_types.Speed = jd.field("Speed", lambda: mobility_v1_0_types.Speed.layout())
    z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24A7, query=True)
class QueryGlobalVectorExt(jd.Message):
    """QueryGlobalVectorExt (0x24A7): Asks for the commanded vector on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalVectorExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0x1F)
