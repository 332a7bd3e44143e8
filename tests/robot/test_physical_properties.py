"""Masses, shapes and mount sites that the CM-MAS reports, compared with the model of the simulation."""

from __future__ import annotations

import math
from datetime import UTC, datetime

import numpy as np
import pytest

from jauspy.backends import find
from jauspy.geometry.poses import Transform, jaus_frame
from jauspy.geometry.rigid_parts import RigidParts
from jauspy.geometry.urdf import parse_urdf
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.exp import QueryMassProperties, QueryMountSite, QueryShape
from jauspy.messages.iop import QueryElectricalProperties, QueryPhysicalProperties
from jauspy.robot import robot_files
from jauspy.robot.hosts import host_of
from jauspy.services.iop.physical_properties import ComponentPhysicalProperties, PhysicalSpecification

CLIENT = JausID(42, 1, 1)
CONFIG = robot_files.load("inc1")
MODEL = robot_files.robot_model(CONFIG)
MASTER = next(module for module in CONFIG.modules if module.type == "CM-MAS")


class Reporting:
    """The CM-MAS of an inc1 on a backend."""

    def __init__(self, backend: str) -> None:
        self.robot = find(backend).open(MODEL, "empty")
        self.host = host_of(
            CONFIG, MASTER, MODEL, self.robot, {}, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0
        )

    def ask(self, query):
        self.host.receive(query.encode(), CLIENT, 0.0)
        (output,) = self.host.poll_output(0.0)
        return registry.decode(output.payload)


@pytest.fixture
def reporting():
    tested = Reporting("kinematic")
    yield tested
    tested.robot.close()


def tensor_of(record) -> np.ndarray:
    rows = [[getattr(record, f"moment_of_inertial_tensor_{''.join(sorted(a + b))}") for b in "xyz"] for a in "xyz"]
    return np.array(rows)


def test_masses_and_inertia_are_those_of_the_simulation():
    mujoco = pytest.importorskip("mujoco", reason="mujoco is of the extra `sim`")
    tested = Reporting("sim")
    try:
        model, data = tested.robot.model, tested.robot.data
        base = model.body("inc1/base_link").id
        report = tested.ask(QueryMassProperties())
        records = [entry.mass_properties_record for entry in report.mass_property_list]
        masses = np.array([record.mass for record in records])
        centres = np.array([[getattr(record, f"center_of_mass_{axis}") for axis in "xyz"] for record in records])
        assert masses.sum() == pytest.approx(model.body_subtreemass[base], abs=1e-3)
        rotation = data.xmat[base].reshape(3, 3)
        centre = rotation.T @ (data.subtree_com[base] - data.xpos[base]) * [1.0, -1.0, -1.0]
        assert masses @ centres / masses.sum() == pytest.approx(centre, abs=1e-4)
        total = sum(
            (
                tensor_of(record) + record.mass * (np.dot(r, r) * np.eye(3) - np.outer(r, r))
                for record, r in zip(records, centres - centre, strict=True)
            ),
            np.zeros((3, 3)),
        )
        expected = np.zeros((3, 3))
        for body in range(model.nbody):
            if model.body_rootid[body] == model.body_rootid[base]:
                turn = data.ximat[body].reshape(3, 3)
                r = data.xipos[body] - data.subtree_com[base]
                expected += turn @ np.diag(model.body_inertia[body]) @ turn.T
                expected += model.body_mass[body] * (np.dot(r, r) * np.eye(3) - np.outer(r, r))
        mirror = np.diag([1.0, -1.0, -1.0])
        assert total == pytest.approx(mirror @ rotation.T @ expected @ rotation @ mirror, rel=1e-3, abs=1e-3)
        assert mujoco.__version__
    finally:
        tested.robot.close()


def test_bodies_stand_where_the_urdf_has_them(reporting):
    parts = RigidParts(MODEL.description).at()
    report = reporting.ask(QueryPhysicalProperties())
    bodies = [body for part in parts for body in part.bodies]
    without = sum(not part.bodies for part in parts)
    assert len(report.element_list) == len(bodies) + without
    masses = [element.mass_record.mass for element in report.element_list]
    assert sum(mass for mass in masses if mass) == pytest.approx(sum(part.mass for part in parts), abs=1e-3)
    chassis = report.element_list[0]
    box = next(body for body in parts[0].bodies)
    shape = chassis.shape_variant
    assert [shape.length_x, shape.length_y, shape.length_z] == pytest.approx(box.shape.size, abs=1e-3)
    matrix = chassis.shape_transformation_record
    x, y, z = box.pose.position
    assert [matrix.m14, matrix.m24, matrix.m34] == pytest.approx([x, -y, -z], abs=1e-3)
    assert [matrix.m41, matrix.m42, matrix.m43, matrix.m44] == pytest.approx([0, 0, 0, 1], abs=1e-4)


def test_aeodrs_has_cylinders_along_y(reporting):
    parts = RigidParts(MODEL.description).at()
    round_bodies = [body for part in parts for body in part.bodies if body.shape.is_round]
    assert round_bodies
    cylinders = [entry for entry in reporting.ask(QueryShape()).shape_list if hasattr(entry.shape_variant, "radius")]
    for body, entry in zip(round_bodies, cylinders, strict=True):
        turn = entry.shape_orientation_record
        rotation = rotation_from_quaternion(
            turn.d_component_of_unit_quaternion_q,
            turn.a_component_of_unit_quaternion_q,
            turn.b_component_of_unit_quaternion_q,
            turn.c_component_of_unit_quaternion_q,
        )
        along = np.array(Transform(rotation).rotate((0.0, 1.0, 0.0)))
        axis = np.array(jaus_frame(body.pose).rotate((0.0, 0.0, 1.0)))
        assert abs(along @ axis) == pytest.approx(1.0, abs=1e-4)


def test_mount_sites_of_modules(reporting):
    sites = reporting.ask(QueryMountSite(node_id=0)).mount_site_properties_list
    assert [site.mount_site_rec.attachment_id for site in sites] == [103, 104, 105, 108, 106, 107]
    arm = sites[1]
    place = arm.location_record
    assert [place.offset_x, place.offset_y, place.offset_z] == pytest.approx([0.12, 0.0, -0.2], abs=1e-6)
    assert type(arm.coordinate_frame_variant).__name__ == "ModuleFrameVariant"
    camera = sites[4]
    assert camera.coordinate_frame_variant.link_index == 4
    for site in sites:
        turn = site.orientation_record
        parts = [getattr(turn, f"{part}_component_of_unit_quaternion_q") for part in "dabc"]
        assert math.hypot(*parts) == pytest.approx(1.0, abs=1e-6)
    assert len(reporting.ask(QueryMountSite(node_id=1)).mount_site_properties_list) == len(sites)
    assert reporting.ask(QueryMountSite(node_id=7)).mount_site_properties_list == []


def test_electrical_properties_are_left_out(reporting):
    report = reporting.ask(QueryElectricalProperties())
    assert report.nominal_voltage is None
    assert report.current_amperage is None


def test_a_robot_of_extreme_size_is_reported_within_the_ranges():
    links = "".join(
        f'<link name="l{n}"><inertial><mass value="1e9"/><inertia ixx="1e30" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
        '</inertial><collision><geometry><box size="1e6 1 1"/></geometry></collision></link>'
        for n in range(300)
    )
    joints = "".join(
        f'<joint name="j{n}" type="continuous"><parent link="l{n}"/><child link="l{n + 1}"/><origin xyz="1e4 0 0"/>'
        '<axis xyz="0 0 1"/></joint>'
        for n in range(299)
    )
    parts = RigidParts(parse_urdf(f'<robot name="huge">{links}{joints}</robot>')).at()
    specification = PhysicalSpecification(lambda: parts).send_report_physical_properties()
    assert len(specification.element_list) == 255
    specification.encode()
    component = ComponentPhysicalProperties(lambda: parts)
    assert len(component.send_report_mass_properties().mass_property_list) == 255
    component.send_report_mass_properties().encode()
    component.send_report_shape().encode()
