"""urn:jaus:jss:iop:PhysicalSpecificationService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:PhysicalSpecificationService", "1.1")


@jd.message(_SERVICE, 0xD733, presence="B")
class ReportElectricalProperties(jd.Message):
    """ReportElectricalProperties (0xD733): Tells the node's voltage and current data.

    nominal_voltage: 0..600 volt, optional. Supply voltage that the node is made for
    current_voltage: 0..600 volt, optional. Supply voltage at this moment
    nominal_amperage: 0..10 ampere, optional. Mean current taken
    maximum_amperage: 0..10 ampere, optional. Highest current that can occur
    current_amperage: 0..10 ampere, optional. Current taken at this moment
    """
    nominal_voltage: float | None = jd.field("NominalVoltage", jd.real("H", 0.0, 600.0, "volt"), default=None)
    current_voltage: float | None = jd.field("CurrentVoltage", jd.real("H", 0.0, 600.0, "volt"), default=None)
    nominal_amperage: float | None = jd.field("NominalAmperage", jd.real("H", 0.0, 10.0, "ampere"), default=None)
    maximum_amperage: float | None = jd.field("MaximumAmperage", jd.real("H", 0.0, 10.0, "ampere"), default=None)
    current_amperage: float | None = jd.field("CurrentAmperage", jd.real("H", 0.0, 10.0, "ampere"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xD731, query=True)
class QueryElectricalProperties(jd.Message):
    """QueryElectricalProperties (0xD731): Asks for the node's voltage and current data."""
    REPORT = ReportElectricalProperties


@jd.message(_SERVICE, 0xD732)
class ReportPhysicalProperties(jd.Message):
    """ReportPhysicalProperties (0xD732): Tells the node's shape and mass data as a set of simple bodies.

    element_list: 0..255 items. One element a body
    """

    @jd.record()
    class ShapeTransformationRecord(jd.Struct):
        """m11: -1..1. Row 1, column 1 of the pose matrix
        m12: -1..1. Row 1, column 2 of the pose matrix
        m13: -1..1. Row 1, column 3 of the pose matrix
        m14: -30..30. Row 1, column 4 of the pose matrix: shift along axis 1
        m21: -1..1. Row 2, column 1 of the pose matrix
        m22: -1..1. Row 2, column 2 of the pose matrix
        m23: -1..1. Row 2, column 3 of the pose matrix
        m24: -30..30. Row 2, column 4 of the pose matrix: shift along axis 2
        m31: -1..1. Row 3, column 1 of the pose matrix
        m32: -1..1. Row 3, column 2 of the pose matrix
        m33: -1..1. Row 3, column 3 of the pose matrix
        m34: -30..30. Row 3, column 4 of the pose matrix: shift along axis 3
        m41: -1..1. Row 4, column 1 of the pose matrix
        m42: -1..1. Row 4, column 2 of the pose matrix
        m43: -1..1. Row 4, column 3 of the pose matrix
        m44: -1..1. Row 4, column 4 of the pose matrix
        """
        m11: float = jd.field("M11", jd.real("H", -1.0, 1.0))
        m12: float = jd.field("M12", jd.real("H", -1.0, 1.0))
        m13: float = jd.field("M13", jd.real("H", -1.0, 1.0))
        m14: float = jd.field("M14", jd.real("H", -30.0, 30.0))
        m21: float = jd.field("M21", jd.real("H", -1.0, 1.0))
        m22: float = jd.field("M22", jd.real("H", -1.0, 1.0))
        m23: float = jd.field("M23", jd.real("H", -1.0, 1.0))
        m24: float = jd.field("M24", jd.real("H", -30.0, 30.0))
        m31: float = jd.field("M31", jd.real("H", -1.0, 1.0))
        m32: float = jd.field("M32", jd.real("H", -1.0, 1.0))
        m33: float = jd.field("M33", jd.real("H", -1.0, 1.0))
        m34: float = jd.field("M34", jd.real("H", -30.0, 30.0))
        m41: float = jd.field("M41", jd.real("H", -1.0, 1.0))
        m42: float = jd.field("M42", jd.real("H", -1.0, 1.0))
        m43: float = jd.field("M43", jd.real("H", -1.0, 1.0))
        m44: float = jd.field("M44", jd.real("H", -1.0, 1.0))

    @jd.record()
    class PhysicalSpecificationBoxRecord(jd.Struct):
        """length_x: 0..10 meter. Size along the body's x axis
        length_y: 0..10 meter. Size along the body's y axis
        length_z: 0..10 meter. Size along the body's z axis
        """
        length_x: float = jd.field("LengthX", jd.real("H", 0.0, 10.0, "meter"))
        length_y: float = jd.field("LengthY", jd.real("H", 0.0, 10.0, "meter"))
        length_z: float = jd.field("LengthZ", jd.real("H", 0.0, 10.0, "meter"))

    @jd.record()
    class PhysicaSpecificationCylinderRecord(jd.Struct):
        """radius: 0..5 meter. Radius of the cylinder
        length: 0..10 meter. Length of the cylinder
        """
        radius: float = jd.field("Radius", jd.real("H", 0.0, 5.0, "meter"))
        length: float = jd.field("Length", jd.real("H", 0.0, 10.0, "meter"))

    @jd.record()
    class PhysicalSpecificationSphereRecord(jd.Struct):
        """radius: 0..5 meter. Radius of the sphere"""
        radius: float = jd.field("Radius", jd.real("H", 0.0, 5.0, "meter"))

    @jd.record("H")
    class MassRecord(jd.Struct):
        """mass: 0..10000 kilogram, optional. Mass of the body; 0 counts as unknown
        center_of_mass_x: -30..30 meter, optional. Centre of mass, x
        center_of_mass_y: -30..30 meter, optional. Centre of mass, y
        center_of_mass_z: -30..30 meter, optional. Centre of mass, z
        moment_of_inertial_tensor_xx: optional. XX component of the inertia about the centre of mass, in kilogram metre squared
        moment_of_inertial_tensor_xy: optional. XY component of the inertia about the centre of mass, in kilogram metre squared
        moment_of_inertial_tensor_xz: optional. XZ component of the inertia about the centre of mass, in kilogram metre squared
        moment_of_inertial_tensor_yy: optional. YY component of the inertia about the centre of mass, in kilogram metre squared
        moment_of_inertial_tensor_yz: optional. YZ component of the inertia about the centre of mass, in kilogram metre squared
        moment_of_inertial_tensor_zz: optional. ZZ component of the inertia about the centre of mass, in kilogram metre squared
        """
        mass: float | None = jd.field("Mass", jd.real("I", 0.0, 10000.0, "kilogram"), default=None)
        center_of_mass_x: float | None = jd.field("CenterOfMassX", jd.real("H", -30.0, 30.0, "meter"), default=None)
        center_of_mass_y: float | None = jd.field("CenterOfMassY", jd.real("H", -30.0, 30.0, "meter"), default=None)
        center_of_mass_z: float | None = jd.field("CenterOfMassZ", jd.real("H", -30.0, 30.0, "meter"), default=None)
        moment_of_inertial_tensor_xx: float | None = jd.field("MomentOfInertialTensorXX", jd.Number("f"), default=None)
        moment_of_inertial_tensor_xy: float | None = jd.field("MomentOfInertialTensorXY", jd.Number("f"), default=None)
        moment_of_inertial_tensor_xz: float | None = jd.field("MomentOfInertialTensorXZ", jd.Number("f"), default=None)
        moment_of_inertial_tensor_yy: float | None = jd.field("MomentOfInertialTensorYY", jd.Number("f"), default=None)
        moment_of_inertial_tensor_yz: float | None = jd.field("MomentOfInertialTensorYZ", jd.Number("f"), default=None)
        moment_of_inertial_tensor_zz: float | None = jd.field("MomentOfInertialTensorZZ", jd.Number("f"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class ElementSeq(jd.Struct):
        """shape_variant: Form of the body"""
        shape_transformation_record: ReportPhysicalProperties.ShapeTransformationRecord = jd.field("ShapeTransformationRecord", lambda: ReportPhysicalProperties.ShapeTransformationRecord.layout())
        shape_variant: ReportPhysicalProperties.PhysicalSpecificationBoxRecord | ReportPhysicalProperties.PhysicaSpecificationCylinderRecord | ReportPhysicalProperties.PhysicalSpecificationSphereRecord = jd.field("ShapeVariant", lambda: jd.Union.of("B", physical_specification_box_record=ReportPhysicalProperties.PhysicalSpecificationBoxRecord, physica_specification_cylinder_record=ReportPhysicalProperties.PhysicaSpecificationCylinderRecord, physical_specification_sphere_record=ReportPhysicalProperties.PhysicalSpecificationSphereRecord))
        mass_record: ReportPhysicalProperties.MassRecord = jd.field("MassRecord", lambda: ReportPhysicalProperties.MassRecord.layout())

    element_list: list[ReportPhysicalProperties.ElementSeq] = jd.field("ElementList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPhysicalProperties.ElementSeq.layout()))


@jd.message(_SERVICE, 0xD730, query=True)
class QueryPhysicalProperties(jd.Message):
    """QueryPhysicalProperties (0xD730): Asks for the node's shape and mass data."""
    REPORT = ReportPhysicalProperties
