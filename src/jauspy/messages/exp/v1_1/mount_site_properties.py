"""urn:jaus:jss:exp:aeodrs:MountSiteProperties 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:MountSiteProperties", "1.1")


@jd.message(_SERVICE, 0xF701)
class ReportMountSite(jd.Message):
    """ReportMountSite (0xF701): Gives position and orientation of the sites asked for.

    mount_site_properties_list: 0..255 items. One entry for each site
    """
    AttachmentFrameRecord = exp_v1_0_types.AttachmentFrameRecord

    @jd.record("B")
    class MountSiteRec(jd.Struct):
        """child_node_id: Node of the module that fits on this site
        attachment_id: optional. Attachment point of the child module; numbered by that module
        """
        child_node_id: int = jd.field("ChildNodeID", jd.Number("B"))
        attachment_id: int | None = jd.field("AttachmentID", jd.Number("B"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class Empty0(jd.Struct):
        """Empty0."""

    @jd.record()
    class ModuleFrameVariant(jd.Struct):
        """Frame of the module itself.

        module_frame_variant: Frame of the module itself
        """
        module_frame_variant: ReportMountSite.Empty0 = jd.field("ModuleFrameVariant", lambda: jd.Union.of("B", empty0=ReportMountSite.Empty0))

    @jd.record()
    class LinkFrameRecord(jd.Struct):
        """link_index: Which manipulator link carries the frame"""
        link_index: int = jd.field("LinkIndex", jd.Number("B"))

    @jd.record()
    class StabilizerFrameRecord(jd.Struct):
        """stabilizer_id: Number of the stabilizer"""
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))

    @jd.record()
    class LocationRecord(jd.Struct):
        """offset_x: -500..500 meter. X coordinate of the site (middle of its bolt pattern)
        offset_y: -500..500 meter. Y coordinate of the site
        offset_z: -500..500 meter. Z coordinate of the site
        """
        offset_x: float = jd.field("OffsetX", jd.real("I", -500.0, 500.0, "meter"))
        offset_y: float = jd.field("OffsetY", jd.real("I", -500.0, 500.0, "meter"))
        offset_z: float = jd.field("OffsetZ", jd.real("I", -500.0, 500.0, "meter"))

    @jd.record()
    class OrientationRecord(jd.Struct):
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
    class MountSitePropertySeq(jd.Struct):
        """coordinate_frame_variant: Frame in which the entry is given"""
        mount_site_rec: ReportMountSite.MountSiteRec = jd.field("MountSiteRec", lambda: ReportMountSite.MountSiteRec.layout())
        coordinate_frame_variant: ReportMountSite.ModuleFrameVariant | ReportMountSite.LinkFrameRecord | ReportMountSite.StabilizerFrameRecord | exp_v1_0_types.AttachmentFrameRecord = jd.field("CoordinateFrameVariant", lambda: jd.Union.of("B", module_frame_variant=ReportMountSite.ModuleFrameVariant, link_frame_record=ReportMountSite.LinkFrameRecord, stabilizer_frame_record=ReportMountSite.StabilizerFrameRecord, attachment_frame_record=exp_v1_0_types.AttachmentFrameRecord))
        location_record: ReportMountSite.LocationRecord = jd.field("LocationRecord", lambda: ReportMountSite.LocationRecord.layout())
        orientation_record: ReportMountSite.OrientationRecord = jd.field("OrientationRecord", lambda: ReportMountSite.OrientationRecord.layout())

    mount_site_properties_list: list[ReportMountSite.MountSitePropertySeq] = jd.field("MountSitePropertiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMountSite.MountSitePropertySeq.layout()))


@jd.message(_SERVICE, 0xE701, query=True)
class QueryMountSite(jd.Message):
    """QueryMountSite (0xE701): Asks for the place of one module or of all.

    node_id: Node of the module asked about; 0 asks for every registered site
    """
    REPORT = ReportMountSite
    node_id: int = jd.field("NodeID", jd.Number("B"))
