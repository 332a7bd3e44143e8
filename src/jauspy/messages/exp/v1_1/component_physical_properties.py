"""urn:jaus:jss:exp:aeodrs:ComponentPhysicalProperties 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:ComponentPhysicalProperties", "1.1")


@jd.message(_SERVICE, 0xFC40)
class ReportMassProperties(jd.Message):
    """ReportMassProperties (0xFC40): Gives the mass of each rigid part; jointed components such as arms have several parts.

    mass_property_list: 0..255 items. One entry for each part
    """
    AttachmentFrameRecord = exp_v1_0_types.AttachmentFrameRecord

    @jd.record()
    class Empty0(jd.Struct):
        """Empty0."""

    @jd.record()
    class ModuleFrameVariant(jd.Struct):
        """Frame of the module itself.

        module_frame_variant: Frame of the module itself
        """
        module_frame_variant: ReportMassProperties.Empty0 = jd.field("ModuleFrameVariant", lambda: jd.Union.of("B", empty0=ReportMassProperties.Empty0))

    @jd.record()
    class LinkFrameRecord(jd.Struct):
        """link_index: Which manipulator link carries the frame"""
        link_index: int = jd.field("LinkIndex", jd.Number("B"))

    @jd.record()
    class StabilizerFrameRecord(jd.Struct):
        """stabilizer_id: Number of the stabilizer"""
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))

    @jd.record("H")
    class MassPropertiesRecord(jd.Struct):
        """mass: 0..10000 kilogram. Mass of the part; 0 counts as not valid
        center_of_mass_x: -500..500 meter, optional. X coordinate of the center of mass
        center_of_mass_y: -500..500 meter, optional. Y coordinate of the center of mass
        center_of_mass_z: -500..500 meter, optional. Z coordinate of the center of mass
        moment_of_inertial_tensor_xx: optional. Element XX of the inertia tensor about the center of mass, in kg m^2
        moment_of_inertial_tensor_xy: optional. Element XY of the inertia tensor about the center of mass, in kg m^2
        moment_of_inertial_tensor_xz: optional. Element XZ of the inertia tensor about the center of mass, in kg m^2
        moment_of_inertial_tensor_yy: optional. Element YY of the inertia tensor about the center of mass, in kg m^2
        moment_of_inertial_tensor_yz: optional. Element YZ of the inertia tensor about the center of mass, in kg m^2
        moment_of_inertial_tensor_zz: optional. Element ZZ of the inertia tensor about the center of mass, in kg m^2
        """
        mass: float = jd.field("Mass", jd.real("I", 0.0, 10000.0, "kilogram"))
        center_of_mass_x: float | None = jd.field("CenterOfMassX", jd.real("I", -500.0, 500.0, "meter"), default=None)
        center_of_mass_y: float | None = jd.field("CenterOfMassY", jd.real("I", -500.0, 500.0, "meter"), default=None)
        center_of_mass_z: float | None = jd.field("CenterOfMassZ", jd.real("I", -500.0, 500.0, "meter"), default=None)
        moment_of_inertial_tensor_xx: float | None = jd.field("MomentOfInertialTensorXX", jd.Number("f"), default=None)
        moment_of_inertial_tensor_xy: float | None = jd.field("MomentOfInertialTensorXY", jd.Number("f"), default=None)
        moment_of_inertial_tensor_xz: float | None = jd.field("MomentOfInertialTensorXZ", jd.Number("f"), default=None)
        moment_of_inertial_tensor_yy: float | None = jd.field("MomentOfInertialTensorYY", jd.Number("f"), default=None)
        moment_of_inertial_tensor_yz: float | None = jd.field("MomentOfInertialTensorYZ", jd.Number("f"), default=None)
        moment_of_inertial_tensor_zz: float | None = jd.field("MomentOfInertialTensorZZ", jd.Number("f"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class MassPropertySeq(jd.Struct):
        """coordinate_frame_var: Frame in which the entry is given"""
        coordinate_frame_var: ReportMassProperties.ModuleFrameVariant | ReportMassProperties.LinkFrameRecord | ReportMassProperties.StabilizerFrameRecord | exp_v1_0_types.AttachmentFrameRecord = jd.field("CoordinateFrameVar", lambda: jd.Union.of("B", module_frame_variant=ReportMassProperties.ModuleFrameVariant, link_frame_record=ReportMassProperties.LinkFrameRecord, stabilizer_frame_record=ReportMassProperties.StabilizerFrameRecord, attachment_frame_record=exp_v1_0_types.AttachmentFrameRecord))
        mass_properties_record: ReportMassProperties.MassPropertiesRecord = jd.field("MassPropertiesRecord", lambda: ReportMassProperties.MassPropertiesRecord.layout())

    mass_property_list: list[ReportMassProperties.MassPropertySeq] = jd.field("MassPropertyList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMassProperties.MassPropertySeq.layout()))


@jd.message(_SERVICE, 0xEC40, query=True)
class QueryMassProperties(jd.Message):
    """QueryMassProperties (0xEC40): Asks for mass and center of mass."""
    REPORT = ReportMassProperties


@jd.message(_SERVICE, 0xFC42)
class ReportShape(jd.Message):
    """ReportShape (0xFC42): Gives simple bodies that together enclose the component.

    shape_list: 0..65535 items. One entry for each body
    """
    AttachmentFrameRecord = exp_v1_0_types.AttachmentFrameRecord

    @jd.record()
    class Empty0(jd.Struct):
        """Empty0."""

    @jd.record()
    class ModuleFrameVariant(jd.Struct):
        """Frame of the module itself.

        module_frame_variant: Frame of the module itself
        """
        module_frame_variant: ReportShape.Empty0 = jd.field("ModuleFrameVariant", lambda: jd.Union.of("B", empty0=ReportShape.Empty0))

    @jd.record()
    class LinkFrameRecord(jd.Struct):
        """link_index: Which manipulator link carries the frame"""
        link_index: int = jd.field("LinkIndex", jd.Number("B"))

    @jd.record()
    class StabilizerFrameRecord(jd.Struct):
        """stabilizer_id: Number of the stabilizer"""
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))

    @jd.record()
    class ShapeLocationRecord(jd.Struct):
        """offset_x: -500..500 meter. X coordinate of the middle of the shape
        offset_y: -500..500 meter. Y coordinate of the middle of the shape
        offset_z: -500..500 meter. Z coordinate of the middle of the shape
        """
        offset_x: float = jd.field("OffsetX", jd.real("I", -500.0, 500.0, "meter"))
        offset_y: float = jd.field("OffsetY", jd.real("I", -500.0, 500.0, "meter"))
        offset_z: float = jd.field("OffsetZ", jd.real("I", -500.0, 500.0, "meter"))

    @jd.record()
    class ShapeOrientationRecord(jd.Struct):
        """d_component_of_unit_quaternion_q: -1..1. Scalar part of the rotation
        a_component_of_unit_quaternion_q: -1..1. First vector part of the rotation
        b_component_of_unit_quaternion_q: -1..1. Second vector part of the rotation
        c_component_of_unit_quaternion_q: -1..1. Third vector part of the rotation
        """
        d_component_of_unit_quaternion_q: float = jd.field("DComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
        a_component_of_unit_quaternion_q: float = jd.field("AComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
        b_component_of_unit_quaternion_q: float = jd.field("BComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))
        c_component_of_unit_quaternion_q: float = jd.field("CComponentOfUnitQuaternionQ", jd.real("I", -1.0, 1.0))

    @jd.record()
    class BoxRecord(jd.Struct):
        """length_x: 0..10 meter. Size along X
        length_y: 0..10 meter. Size along Y
        length_z: 0..10 meter. Size along Z
        """
        length_x: float = jd.field("LengthX", jd.real("I", 0.0, 10.0, "meter"))
        length_y: float = jd.field("LengthY", jd.real("I", 0.0, 10.0, "meter"))
        length_z: float = jd.field("LengthZ", jd.real("I", 0.0, 10.0, "meter"))

    @jd.record()
    class CylinderRecord(jd.Struct):
        """radius: 0..5 meter. Radius of the cylinder
        length: 0..10 meter. Size along the cylinder's axis, which is Y before rotation
        """
        radius: float = jd.field("Radius", jd.real("I", 0.0, 5.0, "meter"))
        length: float = jd.field("Length", jd.real("I", 0.0, 10.0, "meter"))

    @jd.record()
    class SphereRecord(jd.Struct):
        """radius: 0..5 meter. Radius of the sphere"""
        radius: float = jd.field("Radius", jd.real("I", 0.0, 5.0, "meter"))

    @jd.record()
    class ShapeSeq(jd.Struct):
        """coordinate_frame_variant: Frame in which the entry is given
        shape_variant: Kind and size of the body
        """
        coordinate_frame_variant: ReportShape.ModuleFrameVariant | ReportShape.LinkFrameRecord | ReportShape.StabilizerFrameRecord | exp_v1_0_types.AttachmentFrameRecord = jd.field("CoordinateFrameVariant", lambda: jd.Union.of("B", module_frame_variant=ReportShape.ModuleFrameVariant, link_frame_record=ReportShape.LinkFrameRecord, stabilizer_frame_record=ReportShape.StabilizerFrameRecord, attachment_frame_record=exp_v1_0_types.AttachmentFrameRecord))
        shape_location_record: ReportShape.ShapeLocationRecord = jd.field("ShapeLocationRecord", lambda: ReportShape.ShapeLocationRecord.layout())
        shape_orientation_record: ReportShape.ShapeOrientationRecord = jd.field("ShapeOrientationRecord", lambda: ReportShape.ShapeOrientationRecord.layout())
        shape_variant: ReportShape.BoxRecord | ReportShape.CylinderRecord | ReportShape.SphereRecord = jd.field("ShapeVariant", lambda: jd.Union.of("B", box_record=ReportShape.BoxRecord, cylinder_record=ReportShape.CylinderRecord, sphere_record=ReportShape.SphereRecord))

    shape_list: list[ReportShape.ShapeSeq] = jd.field("ShapeList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportShape.ShapeSeq.layout()))


@jd.message(_SERVICE, 0xEC42, query=True)
class QueryShape(jd.Message):
    """QueryShape (0xEC42): Asks for the shapes that enclose the component."""
    REPORT = ReportShape
