"""urn:jaus:jss:mobility:PrimitiveDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetWrenchEffort(rt.Message):
    """SetWrenchEffort (0x0405): Sets propulsive and resistive efforts.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """

    CODE: ClassVar[int] = 0x0405
    NAME: ClassVar[str] = "SetWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    propulsive_linear_effort_x: float | None = None
    propulsive_linear_effort_y: float | None = None
    propulsive_linear_effort_z: float | None = None
    propulsive_rotational_effort_x: float | None = None
    propulsive_rotational_effort_y: float | None = None
    propulsive_rotational_effort_z: float | None = None
    resistive_linear_effort_x: float | None = None
    resistive_linear_effort_y: float | None = None
    resistive_linear_effort_z: float | None = None
    resistive_rotational_effort_x: float | None = None
    resistive_rotational_effort_y: float | None = None
    resistive_rotational_effort_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("propulsive_linear_effort_x", "PropulsiveLinearEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_y", "PropulsiveLinearEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_z", "PropulsiveLinearEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_x", "PropulsiveRotationalEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_y", "PropulsiveRotationalEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_z", "PropulsiveRotationalEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_x", "ResistiveLinearEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_y", "ResistiveLinearEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_z", "ResistiveLinearEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_x", "ResistiveRotationalEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_y", "ResistiveRotationalEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_z", "ResistiveRotationalEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
            ),
            "H",
        )


@dataclass(slots=True, repr=False)
class QueryWrenchEffort(rt.Message):
    """QueryWrenchEffort (0x2405): Asks for the efforts in use.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2405
    NAME: ClassVar[str] = "QueryWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("presence_vector", "PresenceVector", rt.Number("H")),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportWrenchEffort(rt.Message):
    """ReportWrenchEffort (0x4405): Tells the efforts in use.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """

    CODE: ClassVar[int] = 0x4405
    NAME: ClassVar[str] = "ReportWrenchEffort"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    propulsive_linear_effort_x: float | None = None
    propulsive_linear_effort_y: float | None = None
    propulsive_linear_effort_z: float | None = None
    propulsive_rotational_effort_x: float | None = None
    propulsive_rotational_effort_y: float | None = None
    propulsive_rotational_effort_z: float | None = None
    resistive_linear_effort_x: float | None = None
    resistive_linear_effort_y: float | None = None
    resistive_linear_effort_z: float | None = None
    resistive_rotational_effort_x: float | None = None
    resistive_rotational_effort_y: float | None = None
    resistive_rotational_effort_z: float | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("propulsive_linear_effort_x", "PropulsiveLinearEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_y", "PropulsiveLinearEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_linear_effort_z", "PropulsiveLinearEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_x", "PropulsiveRotationalEffortX", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_y", "PropulsiveRotationalEffortY", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("propulsive_rotational_effort_z", "PropulsiveRotationalEffortZ", rt.Real("H", rt.Scaling(-100.0, 100.0, 65535), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_x", "ResistiveLinearEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_y", "ResistiveLinearEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_linear_effort_z", "ResistiveLinearEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_x", "ResistiveRotationalEffortX", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_y", "ResistiveRotationalEffortY", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
                rt.Slot("resistive_rotational_effort_z", "ResistiveRotationalEffortZ", rt.Real("B", rt.Scaling(0.0, 100.0, 255), "percent"), optional=True),
            ),
            "H",
        )
