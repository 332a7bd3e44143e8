"""Localisation by simulated sensors: errors that grow as they are reported, and that come from a seed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import pytest
from tests.helpers.robot import described

from jauspy.backends.kinematic import KinematicRobot
from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.localization import RTK, GnssSetup, ImuSetup, Localization, LocalizationSetup, PoseEstimate
from jauspy.platform.localizer import AttitudeFilter, Localizer
from jauspy.platform.motion_sensors import Encoders, GnssReceiver, InertialSensor, generator

_, INC1 = described("inc1")
CHASSIS = replace(INC1, lidars=(), cameras=(), force_torque=(), groups={})
SENSORS = LocalizationSetup(source="sensors", gnss=GnssSetup())
STEP = 0.02
LEGS = ((0.5, 0.0), (0.4, 0.2), (0.0, 0.4), (0.4, -0.2))
"""Efforts, for five seconds each."""


def drive(
    setup: LocalizationSetup, seconds: float, watch: Callable[[KinematicRobot], None] | None = None
) -> KinematicRobot:
    robot = KinematicRobot(replace(CHASSIS, localization=setup))
    for step in range(round(seconds / STEP)):
        robot.drive.set_effort(*LEGS[int(step * STEP / 5.0) % len(LEGS)])
        robot.advance(STEP)
        if watch is not None:
            watch(robot)
    return robot


def located(robot: KinematicRobot) -> Localization:
    found = Localization.of(robot)
    assert found is not None
    return found


def off(true: Pose, estimate: PoseEstimate) -> tuple[float, float]:
    """Metres, and radians of the yaw."""
    pose = estimate.pose
    return math.dist((true.x, true.y), (pose.x, pose.y)), abs(math.remainder(true.yaw - pose.yaw, math.tau))


@pytest.mark.slow
@pytest.mark.parametrize("gnss", [SENSORS.gnss, RTK], ids=["standalone", "rtk"])
def test_errors_are_as_large_as_they_are_reported(gnss: GnssSetup) -> None:
    ratios: dict[str, list[float]] = {"local": [], "globe": [], "yaw": []}
    for seed in range(10):
        robot = drive(replace(SENSORS, seed=seed, gnss=gnss), 15.0)
        true, state = robot.drive.pose(), located(robot).state()
        ratios["local"].append(off(true, state.local)[0] / state.local.horizontal_rms)
        ratios["globe"].append(off(true, state.globe)[0] / state.globe.horizontal_rms)
        ratios["yaw"].append(off(true, state.local)[1] / state.local.attitude_rms)
    for name, found in ratios.items():
        mean_square = sum(ratio**2 for ratio in found) / len(found)
        assert 0.2 < mean_square < 2.0, f"{name}: {found}"


def test_shocks_and_their_rebound_do_not_tilt_the_attitude() -> None:
    """Tracks that slip against a kerb: each hard, short shock backward is followed by a soft, long one forward."""
    attitude = AttitudeFilter((0.0, 0.0, GRAVITY), 0.0)
    for step in range(500):  # ten seconds at 50 Hz; the mean of -6 and four times 1.5 m/s^2 is zero
        attitude.turn((0.0, 0.0, 0.0), (-6.0 if step % 5 == 0 else 1.5, 0.0, GRAVITY), 0.02)
    roll, pitch, _ = attitude.angles()
    assert abs(pitch) < 0.005
    assert roll == 0.0


@pytest.mark.slow
def test_standalone_receiver_is_off_by_a_metre_and_rtk_by_a_centimetre() -> None:
    far = [off(*pair(drive(replace(SENSORS, seed=seed), 2.0)))[0] for seed in range(8)]
    near = [off(*pair(drive(replace(SENSORS, seed=seed, gnss=RTK), 2.0)))[0] for seed in range(8)]
    assert 0.5 < math.sqrt(sum(each**2 for each in far) / 8) < 3.0
    assert max(near) < 0.05


def pair(robot: KinematicRobot) -> tuple[Pose, PoseEstimate]:
    return robot.drive.pose(), located(robot).state().globe


def test_local_pose_never_jumps_and_the_global_one_does() -> None:
    jumps: dict[str, float] = {"local": 0.0, "globe": 0.0}
    last: dict[str, Pose] = {}

    def watch(robot: KinematicRobot) -> None:
        state = located(robot).state()
        for name, estimate in (("local", state.local), ("globe", state.globe)):
            here, before = estimate.pose, last.get(name)
            if before is not None:
                jumps[name] = max(jumps[name], math.dist((here.x, here.y), (before.x, before.y)))
            last[name] = here

    drive(SENSORS, 20.0, watch)
    assert jumps["local"] < 1.6 * STEP * 1.05, "never faster than the robot"
    assert jumps["globe"] > jumps["local"]


def test_the_same_seed_gives_the_same_errors_and_the_same_motion() -> None:
    first, again, other = (drive(replace(SENSORS, seed=seed), 5.0) for seed in (3, 3, 4))
    assert located(first).state() == located(again).state()
    assert located(first).state().local != located(other).state().local
    assert first.drive.pose() == other.drive.pose() == drive(LocalizationSetup(), 5.0).drive.pose()


def test_without_sensors_there_is_no_localisation() -> None:
    for setup in (LocalizationSetup(), LocalizationSetup(source="exact")):
        assert Localization.of(KinematicRobot(replace(CHASSIS, localization=setup))) is None


class Driven:
    """A chassis that the test moves, whose tracks turn as the test says."""

    def __init__(self) -> None:
        self.true = Pose()
        self.velocity = Twist()
        self.tracks = (0.0, 0.0, 0.0)

    def pose(self) -> Pose:
        return self.true

    def twist(self) -> Twist:
        return self.velocity

    def odometry(self) -> tuple[float, float, float]:
        return self.tracks


def run(localizer: Localizer, since: float, seconds: float) -> float:
    steps = round(seconds / STEP)
    for step in range(1, steps + 1):
        localizer.step(since + step * STEP)
    return since + steps * STEP


def test_slip_is_unknown_to_the_local_pose_and_known_to_gnss() -> None:
    chassis = Driven()
    localizer = Localizer(replace(SENSORS, gnss=RTK), chassis)
    now = run(localizer, 0.0, 1.0)
    chassis.true = Pose(y=0.5)  # it slides sideways down a bank
    run(localizer, now, 5.0)
    state = localizer.state()
    assert abs(state.local.pose.y) < 0.01
    assert state.globe.pose.y == pytest.approx(0.5, abs=0.1)
    chassis.tracks = (1.0, 0.0, 0.0)  # the tracks spin on ice
    run(localizer, now + 5.0, 2.0)
    assert localizer.state().local.pose.x == pytest.approx(2.0, abs=0.1)
    assert localizer.state().twist.vx == pytest.approx(1.0, abs=0.05)


def test_at_rest_the_heading_stays_and_the_bias_is_measured() -> None:
    localizer = Localizer(replace(SENSORS, seed=5), Driven())
    run(localizer, 0.0, 2.0)
    before = localizer.state()
    run(localizer, 2.0, 60.0)
    after = localizer.state()
    assert math.dist((before.local.pose.x, before.local.pose.y), (after.local.pose.x, after.local.pose.y)) == 0.0
    assert abs(after.local.pose.yaw - before.local.pose.yaw) < math.radians(0.01)
    assert after.rate_rms <= before.rate_rms


def test_without_an_imu_the_heading_is_by_odometry() -> None:
    chassis = Driven()
    localizer = Localizer(replace(SENSORS, imu=None), chassis)
    chassis.tracks = (0.0, 0.0, 0.5)
    run(localizer, 0.0, 2.0)
    state = localizer.state()
    assert state.local.pose.yaw == pytest.approx(1.0, abs=0.05)
    assert state.local.attitude_rms > 0.1, "tracks skid when they turn"


def test_errors_are_counted_from_a_declared_pose() -> None:
    robot = drive(SENSORS, 30.0)
    localization = located(robot)
    assert localization.state().local.horizontal_rms > 0.05
    localization.declare(0.1 * math.sqrt(3.0), 0.02)
    robot.advance(STEP)
    local = localization.state().local
    assert local.position_rms == pytest.approx(0.1 * math.sqrt(3.0), rel=0.05)
    localization.declare(None, 0.0)
    robot.advance(STEP)
    assert localization.state().local.position_rms == pytest.approx(0.1 * math.sqrt(3.0), rel=0.05)


def test_encoders_count_whole_counts_and_lose_none() -> None:
    encoders = Encoders(
        replace(SENSORS.odometry, scale_error=0.0, noise=0.0, resolution=0.01), generator(1, "encoders")
    )
    ways = []
    for _ in range(1000):
        encoders.count((0.1, 0.0, 0.0), 0.02)
        ways.append(encoders.read().forward)
    assert {round(way, 9) for way in ways} == {0.0, 0.01}
    assert sum(ways) == pytest.approx(2.0, abs=0.01)


def test_imu_has_the_noise_density_of_its_data_sheet() -> None:
    setup = replace(ImuSetup(), gyro_bias=0.0, gyro_bias_walk=0.0, acceleration_bias=0.0)
    imu = InertialSensor(setup, generator(2, "imu"), Pose(), Twist())
    samples = [imu.measure(Pose(), Twist(), STEP) for _ in range(3000)]
    for measured, expected in ((rates, setup.gyro_noise) for rates in zip(*(gyro for gyro, _ in samples), strict=True)):
        deviation = math.sqrt(sum(each**2 for each in measured) / len(measured))
        assert deviation * math.sqrt(STEP) == pytest.approx(expected, rel=0.06)


def test_imu_measures_gravity_and_centripetal_acceleration() -> None:
    quiet = ImuSetup(50.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    imu = InertialSensor(quiet, generator(3, "imu"), Pose(), Twist(vx=1.0, wz=0.5))
    rates, force = imu.measure(Pose(yaw=0.5 * STEP), Twist(vx=1.0, wz=0.5), STEP)
    assert rates == pytest.approx((0.0, 0.0, 0.5), abs=1e-6)
    assert force == pytest.approx((0.0, 0.5, 9.81), abs=0.01)


def test_most_of_the_error_of_a_fix_stays_for_minutes() -> None:
    receiver = GnssReceiver(GnssSetup(), generator(4, "gnss"))
    fixes = [receiver.fix(Pose(), second * 1.0) for second in range(4000)]
    x = [fix[0] for fix in fixes]

    def correlation(lag: int) -> float:
        return sum(a * b for a, b in zip(x, x[lag:], strict=False)) / (len(x) - lag)

    assert math.sqrt(correlation(0)) == pytest.approx(math.hypot(0.3, 1.2), rel=0.35)
    assert correlation(10) / correlation(0) > 0.7
    assert abs(correlation(1000)) / correlation(0) < 0.5
