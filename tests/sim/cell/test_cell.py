"""The simulated factory cell as a whole."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

import mujoco
from tests.helpers.cells import ARM, build_arm, build_car, cell_model, open_cell, put_on, small_cell, weightless

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.arm import ModularArm
from jauspy.platform.modular.cell import Car, Conveyor, PartSensor
from jauspy.platform.modular.parts import PartSensorSetup
from jauspy_sim.cell.assembly import build_cell
from jauspy_sim.cell.start import wait_attached

FIVE_DEGREES = math.radians(5.0)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_parts_rest_in_their_bins(seed: int) -> None:
    """With errors of 10 mm and 5 degrees: they have slid to the lower edge, and nothing moves or overlaps."""
    cell = open_cell(pose_error=(0.01, FIVE_DEGREES), seed=seed)
    before = cell.truth.poses()
    cell.advance(0.5)
    for part in cell.setup.parts:
        now, was = cell.truth.pose(part.name), before[part.name]
        assert math.dist((now.x, now.y, now.z), (was.x, was.y, was.z)) < 1e-3, part.name
        there = part.pose
        assert math.dist((now.x, now.y, now.z), (there.x, there.y, there.z)) < 0.03, part.name
    assert cell.truth.penetration() < 1e-3
    at_edge = {each.first for each in cell.truth.contacts()} | {each.second for each in cell.truth.contacts()}
    assert {"bin_1", "bin_2", "bin_3", "bin_4", "bin_5"} <= at_edge or cell.data.ncon < 20  # sleeping parts have none


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_scattered_parts_come_to_rest_in_their_bins(seed: int) -> None:
    cell = open_cell(scatter=True, seed=seed)
    before = cell.truth.poses()
    cell.advance(0.2)
    for part in cell.setup.parts:
        for bin in cell.setup.bins:
            frame = Transform.from_pose(bin.pose).inverse()
            planned = frame @ Transform.from_pose(part.pose)
            if all(abs(value) < limit for value, limit in zip(planned.position, (0.26, 0.19, 0.3), strict=True)):
                found = frame @ Transform.from_pose(cell.truth.pose(part.name))
                middle = (found @ cell.setup.types[part.type].grasp).position
                assert abs(middle[0]) < bin.length / 2.0
                assert abs(middle[1]) < bin.width / 2.0
                assert cell.truth.pose(part.name).z == pytest.approx(before[part.name].z, abs=1e-4)


@pytest.mark.slow
def test_scattered_parts_are_turned_by_the_seed() -> None:
    first, same, other = (open_cell(scatter=True, seed=seed).truth.pose("servo_1") for seed in (1, 1, 2))
    assert first == same
    assert abs(first.roll - other.roll) > 0.05  # its x axis is along the normal of the floor


@pytest.mark.slow
def test_scattered_parts_lie_on_other_sides_if_they_are_turned_over() -> None:
    cell = open_cell(scatter=True, turned_over=1.0)
    upward = []
    for part in cell.setup.parts:
        if (kind := cell.setup.types[part.type]).further_grasps:
            frame = cell.truth.frame(part.name)
            up = [-(frame @ grasp).rotation[2][2] for grasp in kind.grasps]
            assert max(up) > 0.85  # the floors of the bins are 20 degrees off
            upward.append(up.index(max(up)))
    assert len(upward) > 15
    assert set(upward) == {1, 2, 3}


@pytest.mark.slow
def test_errors_of_the_start_differ_by_seed() -> None:
    one, other = (open_cell(pose_error=(0.01, FIVE_DEGREES), seed=seed) for seed in (1, 2))
    assert one.truth.pose("tube_1") != other.truth.pose("tube_1")


def run(seed: int) -> bytes:
    """A second in which both arms, the conveyor and the sensor do something; the state at its end."""
    cell = open_cell(pose_error=(0.01, FIVE_DEGREES), seed=seed)
    build_arm(cell, ARM[:3])
    cell.groups["ur10"].command([Target(ControlMode.POSITION, 0.5), *[None] * 5])
    arm, conveyor, sensor = ModularArm.of(cell), Conveyor.of(cell), PartSensor.of(cell)
    assert arm is not None
    assert conveyor is not None
    assert sensor is not None
    conveyor.set_speed(0.2)
    arm.move([0.4, 0.3], 0.8)
    for _ in range(10):
        cell.advance(0.1)
    return bytes(cell.data.qpos.tobytes()) + repr(sensor.state()).encode()


@pytest.mark.slow
def test_same_seed_same_bits() -> None:
    assert run(3) == run(3)


@pytest.mark.slow
def test_steps_may_be_divided_at_will() -> None:
    one, other = open_cell(), open_cell()
    for cell in (one, other):
        cell.groups["ur10"].command([Target(ControlMode.POSITION, 0.5), *[None] * 5])
    one.advance(0.3)
    for _ in range(100):
        other.advance(0.003)
    assert one.data.qpos.tobytes() == other.data.qpos.tobytes()


@pytest.mark.slow
def test_the_conveyor_carries_a_box_at_its_speed() -> None:
    cell = small_cell(["platform_1", "box_1"], conveyor=open_cell().setup.conveyor)
    conveyor = Conveyor.of(cell)
    assert conveyor is not None
    conveyor.set_speed(0.2)
    cell.advance(1.0)
    (_, speed, _), _ = (tuple(cell.data.qvel[cell.model.joint("box_1").dofadr[0] :][:3]), None)
    assert speed == pytest.approx(0.2, abs=0.001)
    assert conveyor.state().speed == pytest.approx(0.2, abs=0.001)
    assert conveyor.state().position == pytest.approx(0.18, abs=0.01)  # 1 m/s^2 at the start
    conveyor.set_speed(math.nan)
    conveyor.set_speed(9.0)
    cell.advance(1.0)
    assert conveyor.state().speed == pytest.approx(0.5, abs=0.002)
    conveyor.set_speed(0.0)
    cell.advance(1.0)
    assert conveyor.state().speed == pytest.approx(0.0, abs=1e-4)


@pytest.mark.slow
def test_the_sensor_has_noise_and_a_rate() -> None:
    cell = small_cell(["platform_1", "box_1"], sensor=PartSensorSetup(5.0, 0.001, 0.01, 4))
    sensor = PartSensor.of(cell)
    assert sensor is not None
    seen = []
    for _ in range(100):
        cell.advance(0.2)
        seen.append(sensor.state())
    times = [each.time for each in seen]
    assert times == pytest.approx([0.2 * (number + 1) for number in range(100)], abs=0.003)
    true = cell.truth.pose("box_1").x
    errors = [observation.parts[0].pose.x - true for observation in seen]
    assert [part.name for part in seen[0].parts] == ["box_1"]
    spread = math.sqrt(sum(error**2 for error in errors) / len(errors))
    assert spread == pytest.approx(0.001, rel=0.3)


@pytest.mark.slow
def test_the_robot_holds_still_with_a_load() -> None:
    """Its controllers bear what the gripper holds."""
    cell = small_cell(["platform_1", "car"])
    down = Transform.from_pose(Pose(roll=math.pi))
    before = cell.groups["ur10"].state().positions
    put_on(cell, "gripper", "car", down @ Transform(position=(0.0, 0.0, -0.09)))
    weight, body = 3.5 * 9.81, cell.model.body("car").id
    cell.data.xfrc_applied[body][2] = weight  # it is carried until the vacuum is there
    wait_attached(cell, "gripper", "car")
    cell.data.xfrc_applied[body][2] = 0.0
    cell.advance(1.5)
    assert cell.groups["ur10"].state().positions == pytest.approx(before, abs=1e-3)
    assert cell.connectors["gripper"].state().force == pytest.approx(3.5 * 9.81, rel=0.03)


@pytest.mark.slow
def test_the_assembled_arm_moves_as_its_model_says() -> None:
    cell = small_cell([*ARM, "platform_1"])
    build_arm(cell)
    arm = ModularArm.of(cell)
    assert arm is not None
    goal = (0.3, 0.6, 0.8, 0.6, 0.5)
    arm.move(goal, 2.0)
    cell.advance(3.5)
    state = arm.state()
    assert state.joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")
    assert state.positions == pytest.approx(goal, abs=0.005)
    tip, told = cell.truth.connector("servo_5/output").position, state.tip_pose
    assert math.dist(tip, (told.x, told.y, told.z)) < 0.003
    assert not any(each.state().broken_off for each in cell.connectors.values())


@pytest.mark.slow
def test_the_car_drives_once_it_has_wheels() -> None:
    names = ["car", *(f"servo_{number}" for number in range(6, 10)), *(f"wheel_{number}" for number in range(1, 5))]
    cell = small_cell(["platform_1", *names], car="car", arm="")
    car = Car.of(cell)
    assert car is not None
    cell.advance(0.5)
    car.set_effort(1.0, 0.0)
    assert not car.state().assembled
    joint = cell.model.joint("car")
    cell.data.qpos[joint.qposadr[0] : joint.qposadr[0] + 7] = (-2.0, 0.0, 0.03, 1.0, 0.0, 0.0, 0.0)
    with weightless(cell):
        build_car(cell)
    assert car.state().assembled
    assert {cell.servos[f"servo_{number}"].state().claimed_by for number in range(6, 10)} == {"car"}
    cell.advance(0.5)
    start = car.pose()
    assert start.z == pytest.approx(0.02, abs=0.003)
    car.set_effort(0.5, 0.0)
    cell.advance(1.0)
    assert car.pose().x > start.x + 0.1
    assert abs(car.pose().y - start.y) < 0.02
    assert car.twist().vx > 0.2
    car.set_effort(0.0, 0.6)
    cell.advance(1.0)
    assert car.twist().wz > 0.1
    car.set_effort(math.nan, 0.0)
    cell.advance(0.3)
    assert abs(car.twist().vx) < 0.01
    assert abs(car.twist().wz) < 0.02
    cell.connectors["servo_6/output"].set(False)
    cell.advance(0.01)
    assert not car.state().assembled
    assert {cell.servos[f"servo_{number}"].state().claimed_by for number in range(6, 10)} == {""}


def test_a_window_needs_a_display(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    cell = small_cell(["platform_1"])
    with pytest.raises(ConfigError, match="no display"):
        cell.view()
    cell.close()
    cell.close()


@pytest.mark.slow
def test_what_is_seen_neither_collides_nor_weighs() -> None:
    cell = build_cell(cell_model(), "cell")
    model, drawn = cell.model, cell.drawn
    seen = [geom for geom in range(drawn.ngeom) if drawn.geom_dataid[geom] >= 0]
    assert len(seen) > 100
    assert not any(drawn.geom_contype[geom] or drawn.geom_conaffinity[geom] for geom in seen)
    assert drawn.body("tube_1").mass == pytest.approx(0.27)
    assert not model.nmesh
    at_rest = open_cell().data.qpos
    accelerations = []
    for each in (model, drawn):
        data = mujoco.MjData(each)
        data.qpos[:] = at_rest
        mujoco.mj_forward(each, data)
        assert data.ncon > 50
        accelerations.append(data.qacc)
    assert accelerations[0] == pytest.approx(accelerations[1], abs=1e-6)


def test_inertia_of_the_model_is_that_of_the_solids() -> None:
    cell = small_cell(["platform_1", "box_1"])
    body = cell.model.body("box_1")
    x, y, z = 0.16, 0.12, 0.1
    expected = [0.3 * (b * b + c * c) / 12.0 for b, c in ((y, z), (x, z), (x, y))]
    assert sorted(body.inertia.tolist()) == pytest.approx(sorted(expected))
    assert body.ipos.tolist() == pytest.approx([0.0, 0.0, 0.05])
