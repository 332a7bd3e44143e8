"""Contact shadows and track marks: where they are, and that physics does not have them."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import DrawnModel, build
from jauspy_sim.models.decals import BODY_SHADE, MARK, MARK_LENGTH, MARKS, SHADOW, add_decals, footprint, opacities
from jauspy_sim.models.whips import Whips
from jauspy_sim.rendering.cameras import state_size
from jauspy_sim.rendering.decals import Decals
from jauspy_sim.rendering.gl import HIDDEN, Culling
from jauspy_sim.robot import SimulatedRobot

INC1 = replace(robot_model(load("inc1")), lidars=())
FOOTPRINT = footprint(INC1)


class Seen:
    """inc1 on a ramp of 20 degrees that begins at x = 3, or before it, as a camera draws it."""

    def __init__(self) -> None:
        spec = mujoco.MjSpec()
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1))
        self.slope = math.radians(20.0)
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=(2.0, 1.0, 0.05),
            pos=(3.0 + 2.0 * math.cos(self.slope), 0.0, 2.0 * math.sin(self.slope) - 0.05),
            quat=(math.cos(self.slope / 2.0), 0.0, -math.sin(self.slope / 2.0), 0.0),
        )
        robot = spec.worldbody.add_body(name="base")
        robot.add_freejoint()
        robot.add_geom(size=(0.1, 0.0, 0.0), group=1)
        add_decals(spec, INC1)
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        assert FOOTPRINT is not None
        self.decals = Decals(self.model, self.model.body("base").id, FOOTPRINT)

    def place(self, x: float, y: float = 0.0, z: float = 0.0, yaw: float = 0.0, pitch: float = 0.0) -> None:
        self.data.qpos[:3] = x, y, z
        turn, nod = np.zeros(4), np.zeros(4)
        mujoco.mju_axisAngle2Quat(turn, np.array([0.0, 0.0, 1.0]), yaw)
        mujoco.mju_axisAngle2Quat(nod, np.array([0.0, 1.0, 0.0]), pitch)
        mujoco.mju_mulQuat(self.data.qpos[3:7], turn, nod)
        mujoco.mj_kinematics(self.model, self.data)
        self.decals.place(self.data)

    @property
    def opacity(self) -> float:
        """That of the shadow, as a fraction of the greatest."""
        first, found = self.model.geom(f"{SHADOW} 0").id, np.array(opacities())
        shown = self.model.geom_rgba[first : first + len(found), 3] / found
        assert np.ptp(shown) < 1e-6
        return float(shown[0])

    def corners(self, geom: int) -> np.ndarray:
        """The points of a shape's mesh in the world."""
        mesh = int(self.model.geom_dataid[geom])
        first, count = int(self.model.mesh_vertadr[mesh]), int(self.model.mesh_vertnum[mesh])
        points = self.model.mesh_vert[first : first + count]
        return points @ self.data.geom_xmat[geom].reshape(3, 3).T + self.data.geom_xpos[geom]

    def marks(self) -> list[int]:
        shown = [self.model.geom(f"{MARK} {number}").id for number in range(4 * MARKS)]
        return [geom for geom in shown if self.model.geom_rgba[geom, 3] > 0.0]


def test_the_shadow_lies_below_the_robot_on_level_ground() -> None:
    seen = Seen()
    seen.place(0.5, -0.3, yaw=math.pi / 2.0)
    assert seen.opacity == pytest.approx(1.0, rel=0.01)
    points = seen.corners(seen.model.geom(f"{SHADOW} 0").id)
    assert points[:, 2].min() > 0.004, "above paint on the ground"
    assert points[:, 2].max() < 0.012
    assert FOOTPRINT is not None
    back, front, right, left = FOOTPRINT.body
    assert points[:, 1].min() == pytest.approx(-0.3 + back - BODY_SHADE.outer, abs=0.01)
    assert points[:, 1].max() == pytest.approx(-0.3 + front + BODY_SHADE.outer, abs=0.01)
    assert (points[:, 0].min(), points[:, 0].max()) == pytest.approx(
        (0.5 - left - BODY_SHADE.outer, 0.5 - right + BODY_SHADE.outer), abs=0.01
    )


def test_the_shadow_darkens_inward_without_steps_that_show() -> None:
    body, feet = opacities()[: BODY_SHADE.rings], opacities()[BODY_SHADE.rings :]
    for shade in (body, feet):
        steps = np.diff([0.0, *shade])
        assert (steps > 0.0).all()
        assert steps.max() < 0.17


def test_the_rings_of_the_shadow_do_not_overlap() -> None:
    """Else they would be darker than their opacities."""
    seen = Seen()
    seen.place(0.0)
    rings = [seen.corners(seen.model.geom(f"{SHADOW} {ring}").id) for ring in range(BODY_SHADE.rings)]
    for outer, inner in itertools.pairwise(rings):
        half = len(outer) // 2
        assert np.sort(outer[half:], axis=0) == pytest.approx(np.sort(inner[: len(outer) - half], axis=0), abs=1e-5)


def test_the_shadow_lies_on_a_ramp() -> None:
    seen = Seen()
    along = 1.5
    seen.place(3.0 + along * math.cos(seen.slope), z=along * math.sin(seen.slope), pitch=-seen.slope)
    assert seen.opacity > 0.8
    up = seen.data.geom_xmat[seen.model.geom(f"{SHADOW} 0").id].reshape(3, 3)
    normals = [-math.sin(seen.slope), 0.0, math.cos(seen.slope)]
    points = seen.corners(seen.model.geom(f"{SHADOW} 0").id)
    heights = (points - [3.0, 0.0, 0.0]) @ normals
    assert 0.0 < heights.min() < heights.max() < 0.09
    assert np.linalg.det(up) == pytest.approx(1.0)


@pytest.mark.parametrize(
    "pose",
    [
        pytest.param({"x": 0.0, "z": 0.5}, id="in the air"),
        pytest.param({"x": 0.0, "z": 0.3, "pitch": -1.3}, id="reared up"),
        pytest.param({"x": 0.0, "z": 0.3, "pitch": math.pi}, id="on its back"),
    ],
)
def test_there_is_no_shadow_without_contact(pose: dict[str, float]) -> None:
    seen = Seen()
    seen.place(**pose)
    assert seen.opacity == 0.0
    assert seen.marks() == []


def test_decals_are_hidden_where_mujoco_draws_shadows() -> None:
    """Its light of the sun does not reach the ground below what is transparent."""
    seen = Seen()
    culling, shown = Culling(seen.model), seen.model.geom_group.copy()
    culling.hide_decals()
    hidden = [seen.model.geom(int(geom)).name for geom in np.flatnonzero(seen.model.geom_group == HIDDEN)]
    assert len(hidden) == len(opacities()) + 4 * MARKS
    assert all(name.startswith((SHADOW, MARK)) for name in hidden)
    culling.show_all()
    assert (seen.model.geom_group == shown).all()


def test_tracks_leave_marks_where_they_have_been() -> None:
    seen = Seen()
    for step in range(21):
        seen.place(-2.0 + 0.05 * step)
    marks = seen.marks()
    assert len(marks) == 2 * int(1.0 / MARK_LENGTH), "of the rear ends only"
    places = np.array([0.5 * (seen.corners(geom).min(axis=0) + seen.corners(geom).max(axis=0)) for geom in marks])
    assert set(np.round(places[:, 1], 2)) == {-0.23, 0.23}
    assert places[:, 0].min() == pytest.approx(-2.0 - 0.35 + MARK_LENGTH / 2.0, abs=0.01), (
        "where the belt leaves the ground"
    )
    assert places[:, 2].max() < 0.012
    straight = max(seen.model.geom_rgba[geom, 3] for geom in marks)
    for step in range(40):
        seen.place(-1.0, yaw=0.05 * step)
    assert max(seen.model.geom_rgba[geom, 3] for geom in seen.marks()) > 1.5 * straight, "sliding sideways leaves more"


def test_marks_are_bounded_and_a_pause_of_the_camera_leaves_a_gap() -> None:
    seen = Seen()
    for step in range(400):
        seen.place(0.04 * (step % 50), 0.02 * step)
    assert len(seen.marks()) <= 4 * MARKS
    seen = Seen()
    seen.place(-3.0)
    seen.place(2.0)
    assert seen.marks() == []


@pytest.mark.parametrize("name", ["inc1", "rover", "cell"])
def test_physics_has_none_of_it(name: str) -> None:
    """What cameras draw has the same state as physics, whose model is as it was."""
    robot = robot_model(load(name))
    physics = build(robot, "empty", drawn=False)
    names = [physics.geom(number).name for number in range(physics.ngeom)]
    assert not [each for each in names if each.startswith((SHADOW, MARK))]
    assert not physics.nuser_geom or not (physics.geom_user[:, 0] < 0.0).any()
    drawn = DrawnModel(robot, "empty").build()
    shown = [drawn.geom(number).name for number in range(drawn.ngeom)]
    assert (f"{SHADOW} 0" in shown) == (robot.tracks is not None or robot.wheels is not None)
    assert (f"{MARK} 0" in shown) == (robot.tracks is not None)
    assert state_size(drawn) == state_size(physics)


@pytest.mark.slow
def test_pictures_do_not_change_the_trajectory_by_a_bit() -> None:
    """Of two robots with the same commands, one is drawn with all decorations each tenth of a second."""
    ends = []
    for is_drawn in (False, True):
        robot = SimulatedRobot.open(replace(INC1, cameras=()), "empty")
        model = DrawnModel(INC1, "empty").build() if is_drawn else None
        if model is not None:
            assert FOOTPRINT is not None
            data, whips = mujoco.MjData(model), Whips(model)
            decals = Decals(model, model.body("inc1/base_link").id, FOOTPRINT)
        robot.drive.set_effort(0.5, 0.2)
        for _ in range(20):
            robot.advance(0.1)
            if model is not None:
                data.qpos[:], data.userdata[:] = robot.data.qpos, robot.data.userdata
                mujoco.mj_kinematics(model, data)
                whips.place(data, robot.time)
                decals.place(data)
        if model is not None:
            shown = model.geom_rgba[[model.geom(f"{MARK} {number}").id for number in range(4 * MARKS)], 3]
            assert (shown > 0.0).sum() > 4, "it was drawn"
        ends.append((robot.data.qpos.tobytes(), robot.data.qvel.tobytes()))
        robot.close()
    assert ends[0] == ends[1]
