"""Masses, shapes and places for modules of a robot, by its description (IOP v3 and AEODRS).

All values are in the frame of the root link with JAUS's axes (x forward, y right, z down), of the present posture.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform, jaus_frame
from jauspy.geometry.rigid_parts import Body, RigidPart
from jauspy.geometry.vectors import Quaternion, X, product, quaternion, rotation_about
from jauspy.messages.exp import (
    QueryMountSite,
    ReportMassProperties,
    ReportMountSite,
    ReportShape,
)
from jauspy.messages.iop import ReportElectricalProperties, ReportPhysicalProperties
from jauspy.services.service import Service

MAX_ENTRIES: Final = 255
"""Elements of a list."""
MAX_SIZE: Final = 10.0
"""Metres; the greatest length of a body in the messages."""
MAX_OFFSET: Final = 30.0
"""Metres; the greatest offset of ReportPhysicalProperties."""
MAX_INERTIA: Final = 1e38
"""kg m^2; a float of four bytes."""
MAX_MASS: Final = 10_000.0
"""Kilograms."""
_ALONG_Y: Final = Transform(rotation_about(X, math.pi / 2.0))
"""The frame of a cylinder along y, as AEODRS has them, in that of the same one along z."""


class PhysicalSpecification(Service, urn="urn:jaus:jss:iop:PhysicalSpecificationService"):
    """Reports the parts that `parts` returns, each mass with the first body of its part.

    The standard does not say in which frame centres of mass and inertia are. Their range is that of the bodies'
    offsets, so they are in the vehicle's frame, too.
    """

    def __init__(self, parts: Callable[[], Sequence[RigidPart]]) -> None:
        self._parts = parts

    def send_report_physical_properties(self) -> ReportPhysicalProperties:
        """The bodies. A part without one is a sphere without size at its centre of mass."""
        found = []
        for part in self._parts():
            mass = ReportPhysicalProperties.MassRecord(**_mass(part, MAX_OFFSET))
            if not part.bodies:
                sphere = ReportPhysicalProperties.PhysicalSpecificationSphereRecord(radius=0.0)
                found.append(_element(Transform(position=part.centre), sphere, mass))
            for body in part.bodies:
                found.append(_element(body.pose, _iop_shape(body), mass))
                mass = ReportPhysicalProperties.MassRecord()
        return ReportPhysicalProperties(found[:MAX_ENTRIES])

    def send_report_electrical_properties(self) -> ReportElectricalProperties:
        """Nothing: a description has no voltages and currents."""
        return ReportElectricalProperties()


class ComponentPhysicalProperties(Service, urn="urn:jaus:jss:exp:aeodrs:ComponentPhysicalProperties"):
    """Reports the parts that `parts` returns, in the frame of the module."""

    def __init__(self, parts: Callable[[], Sequence[RigidPart]]) -> None:
        self._parts = parts

    def send_report_mass_properties(self) -> ReportMassProperties:
        """The parts that have a mass."""
        entries = [
            ReportMassProperties.MassPropertySeq(
                _module_frame(ReportMassProperties),
                ReportMassProperties.MassPropertiesRecord(**_mass(part, 500.0)),
            )
            for part in self._parts()
            if part.mass > 0.0
        ]
        return ReportMassProperties(entries[:MAX_ENTRIES])

    def send_report_shape(self) -> ReportShape:
        """The bodies of all parts."""
        return ReportShape([_shape(body) for part in self._parts() for body in part.bodies][:MAX_ENTRIES])


@dataclass(frozen=True, slots=True)
class MountSite:
    """The place of a module."""

    node: int
    component: int
    """Number of the module, which is reported as its attachment: modules may share a node."""
    frame: Transform
    """JAUS's axes of the module, in those of the chassis, or in the frame of a manipulator's link."""
    link: int | None = None
    """Number of the manipulator's link that carries it; None if it is on the chassis."""


class MountSiteProperties(Service, urn="urn:jaus:jss:exp:aeodrs:MountSiteProperties"):
    """Reports the places of modules."""

    def __init__(self, sites: Sequence[MountSite]) -> None:
        self._sites = tuple(sites)

    def send_report_mount_site(self, query: QueryMountSite) -> ReportMountSite:
        """Those of one node, or of all (0)."""
        wanted = [site for site in self._sites if query.node_id in (0, site.node)]
        return ReportMountSite([_mount_site(site) for site in wanted[:MAX_ENTRIES]])


def _mount_site(site: MountSite) -> ReportMountSite.MountSitePropertySeq:
    x, y, z = site.frame.position
    d, a, b, c = _quaternion(site.frame)
    return ReportMountSite.MountSitePropertySeq(
        ReportMountSite.MountSiteRec(site.node, site.component),
        _module_frame(ReportMountSite) if site.link is None else ReportMountSite.LinkFrameRecord(site.link),
        ReportMountSite.LocationRecord(x, y, z),
        ReportMountSite.OrientationRecord(d, a, b, c),
    )


def _module_frame(report: Any) -> Any:
    """The frame of the module, in the form that each of the reports has of it."""
    return report.ModuleFrameVariant(report.Empty0())


def _mass(part: RigidPart, reach: float) -> dict[str, Any]:
    """The fields of a mass record; `reach` (metres) is the greatest coordinate that the message has."""
    centre = JAUS_FROM_REP_103.apply(part.centre)
    turn = JAUS_FROM_REP_103.rotation
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = product(product(turn, part.tensor), turn)
    return {
        "mass": min(part.mass, MAX_MASS),
        **{f"center_of_mass_{axis}": _within(value, reach) for axis, value in zip("xyz", centre, strict=True)},
        **{
            f"moment_of_inertial_tensor_{axes}": _within(value, MAX_INERTIA)
            for axes, value in (("xx", xx), ("xy", xy), ("xz", xz), ("yy", yy), ("yz", yz), ("zz", zz))
        },
    }


def _element(pose: Transform, shape: Any, mass: ReportPhysicalProperties.MassRecord) -> Any:
    frame = jaus_frame(pose)
    rows = [(*row, shift) for row, shift in zip(frame.rotation, frame.position, strict=True)]
    values = {
        f"m{row}{column}": _within(value, MAX_OFFSET if column == 4 else 1.0)
        for row, line in enumerate((*rows, (0.0, 0.0, 0.0, 1.0)), 1)
        for column, value in enumerate(line, 1)
    }
    return ReportPhysicalProperties.ElementSeq(
        ReportPhysicalProperties.ShapeTransformationRecord(**values), shape, mass
    )


def _iop_shape(body: Body) -> Any:
    x, y, z = (min(size, MAX_SIZE) for size in body.shape.size)
    if body.shape.is_sphere:
        return ReportPhysicalProperties.PhysicalSpecificationSphereRecord(x / 2.0)
    if body.shape.is_round:
        return ReportPhysicalProperties.PhysicaSpecificationCylinderRecord(x / 2.0, z)
    return ReportPhysicalProperties.PhysicalSpecificationBoxRecord(x, y, z)


def _shape(body: Body) -> ReportShape.ShapeSeq:
    x, y, z = (min(size, MAX_SIZE) for size in body.shape.size)
    pose = jaus_frame(body.pose)
    if body.shape.is_sphere:
        shape: Any = ReportShape.SphereRecord(x / 2.0)
    elif body.shape.is_round:
        shape, pose = ReportShape.CylinderRecord(x / 2.0, z), pose @ _ALONG_Y
    else:
        shape = ReportShape.BoxRecord(x, y, z)
    return ReportShape.ShapeSeq(
        _module_frame(ReportShape),
        ReportShape.ShapeLocationRecord(*(_within(value, 500.0) for value in pose.position)),
        ReportShape.ShapeOrientationRecord(*_quaternion(pose)),
        shape,
    )


def _quaternion(frame: Transform) -> Quaternion:
    d, a, b, c = (_within(part, 1.0) for part in quaternion(frame.rotation))
    return d, a, b, c


def _within(value: float, limit: float) -> float:
    return max(-limit, min(limit, value))
