"""Version 1.0 of services beside 1.1 and 2.0, for clients that look for version 1.0 only (ADR 118).

A message that both versions have is the same on the wire, so a component that answers the inputs of the older version
lists it too. Left out are the services whose messages differ: LocalVectorDriver, RangeSensor and AnalogVideo.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cache
from typing import Final

from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.loader import load_needed

CORE: Final = "urn:jaus:jss:core:"
MOBILITY: Final = "urn:jaus:jss:mobility:"
MANIPULATOR: Final = "urn:jaus:jss:manipulator:"
SENSING: Final = "urn:jaus:jss:environmentSensing:"
VERSION: Final = "1.0"

OLDER: Final[tuple[str, ...]] = (
    *(f"{CORE}{name}" for name in ("Transport", "Events", "AccessControl", "Management")),
    *(f"{CORE}{name}" for name in ("Discovery", "Time", "Liveness", "Liveliness")),
    *(f"{MOBILITY}{name}" for name in ("PrimitiveDriver", "VelocityStateSensor", "VelocityStateDriver")),
    *(f"{MOBILITY}{name}" for name in ("AccelerationStateSensor", "LocalPoseSensor", "GlobalPoseSensor")),
    *(f"{MOBILITY}{name}" for name in ("LocalWaypointDriver", "GlobalWaypointDriver", "GlobalVectorDriver")),
    *(f"{MOBILITY}{name}" for name in ("ListManager", "LocalWaypointListDriver", "GlobalWaypointListDriver")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("JointPositionSensor", "JointVelocitySensor")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("JointForceTorqueSensor", "ActuatorForceTorqueDriver")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("JointPositionDriver", "JointVelocitiesDriver")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("EndEffectorPoseSensor", "EndEffectorVelocityStateSensor")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("EndEffectorPoseDriver", "EndEffectorVelocityStateDriver")),
    *(f"{MANIPULATOR}Manipulator{name}" for name in ("JointPositionsListDriver", "EndEffectorPoseListDriver")),
    *(f"{MANIPULATOR}{name}" for name in ("ListManager", "PrimitiveManipulator", "PrimitiveEndEffector")),
    *(f"{MANIPULATOR}{name}" for name in ("PrimitivePanTilt", "PanTiltJointPositionSensor")),
    *(f"{MANIPULATOR}{name}" for name in ("PanTiltJointVelocitySensor", "PanTiltJointPositionDriver")),
    f"{MANIPULATOR}PanTiltJointVelocitiesDriver",
    *(f"{SENSING}{name}" for name in ("VisualSensor", "DigitalVideo", "StillImage")),
)
"""The services of which version 1.0 can be listed."""


RENAMED: Final = {
    f"{CORE}Liveliness": (f"{CORE}Liveness",),
    f"{MOBILITY}ListManager": (f"{MOBILITY}LocalWaypointListDriver", f"{MOBILITY}GlobalWaypointListDriver"),
    f"{MANIPULATOR}ListManager": (f"{MANIPULATOR}ManipulatorListDriver",),
    f"{MANIPULATOR}ManipulatorJointVelocitiesDriver": (f"{MANIPULATOR}ManipulatorJointVelocityDriver",),
    f"{MANIPULATOR}ManipulatorJointPositionsListDriver": (f"{MANIPULATOR}ManipulatorJointPositionListDriver",),
    f"{MANIPULATOR}PanTiltJointVelocitiesDriver": (f"{MANIPULATOR}PanTiltJointVelocityDriver",),
}
"""Those that have another name now: one of these services does the same."""


def answered(services: Collection[str], inputs: Collection[int]) -> Iterator[str]:
    """The services whose version 1.0 is answered by a component with these services and inputs, which are message ids.

    A service is left out when the component lacks one of its inputs, or of those that it inherits.
    """
    for urn, codes in _inputs().items():
        if not set(RENAMED.get(urn, (urn,))).isdisjoint(services) and codes.issubset(inputs):
            yield urn


@cache
def _inputs() -> dict[str, frozenset[int]]:
    """The message ids that version 1.0 of each service takes, with those that it inherits."""
    schema = load_needed(frozenset((urn, VERSION) for urn in OLDER))
    parent_of = parents_among(schema.services)
    lines = {urn: lineage(schema.service(urn, VERSION), parent_of) for urn in OLDER}
    return {urn: frozenset(message.code for each in line for message in each.inputs) for urn, line in lines.items()}
