"""urn:jaus:jss:iop:ManipulatorEndEffectorForceTorqueSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:ManipulatorEndEffectorForceTorqueSensor", "1.1")


@jd.message(_SERVICE, 0xD999, presence="B")
class ReportManipulatorEndEffectorForceTorque(jd.Message):
    """ReportManipulatorEndEffectorForceTorque (0xD999): Forces and torques acting at the end effector.

    force_x: -100000..100000 newton, optional. Force along x of the end effector frame
    force_y: -100000..100000 newton, optional. Force along y of the end effector frame
    force_z: -100000..100000 newton, optional. Force along z of the end effector frame
    torque_x: -1000000..1000000 newton meter, optional. Torque about x of the end effector frame
    torque_y: -1000000..1000000 newton meter, optional. Torque about y of the end effector frame
    torque_z: -1000000..1000000 newton meter, optional. Torque about z of the end effector frame
    """
    force_x: float | None = jd.field("ForceX", jd.real("I", -100000.0, 100000.0, "newton"), default=None)
    force_y: float | None = jd.field("ForceY", jd.real("I", -100000.0, 100000.0, "newton"), default=None)
    force_z: float | None = jd.field("ForceZ", jd.real("I", -100000.0, 100000.0, "newton"), default=None)
    torque_x: float | None = jd.field("TorqueX", jd.real("I", -1000000.0, 1000000.0, "newton meter"), default=None)
    torque_y: float | None = jd.field("TorqueY", jd.real("I", -1000000.0, 1000000.0, "newton meter"), default=None)
    torque_z: float | None = jd.field("TorqueZ", jd.real("I", -1000000.0, 1000000.0, "newton meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xD998, query=True)
class QueryManipulatorEndEffectorForceTorque(jd.Message):
    """QueryManipulatorEndEffectorForceTorque (0xD998): Asks for the forces and torques.

    presence_vector: Which fields of the report are wanted; 255 stands for all of them
    """
    REPORT = ReportManipulatorEndEffectorForceTorque
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x3F)
