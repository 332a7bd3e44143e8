"""Stability of a robot against tipping over: the margin of tipping from masses, joints, slope and payload.

The margin is the angle by which gravity would have to turn about an edge of the support polygon until its line through
the centre of mass meets that edge: the force-angle measure of Papadopoulos and Rey (ICRA 1996) for a robot at rest. It
is negative for a robot that tips over. Frames as in REP-103; see docs/adr/0186-batteries-health-and-stability.md.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Final, NamedTuple

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import CollisionBox, collision_boxes, inertials
from jauspy.geometry.vectors import GRAVITY, Vector, add, cross, difference, dot, scaled
from jauspy.platform.contract import RobotParts
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import joint_positions
from jauspy.platform.localization import Localization
from jauspy.platform.stability_setup import StabilitySetup

FLAT: Final = 0.005
"""Metres above the ground up to which points of tracks or wheels carry the robot, too: soil and rubber give way."""
MIN_PAYLOAD: Final = 0.3
"""Kilograms below which a force at the gripper counts as an error of its sensor."""
WEIGHING_TIME: Final = 0.3
"""Seconds over which the weight is averaged (first-order): a load that swings is not heavier."""
MAX_PAYLOAD: Final = 200.0
"""Kilograms; a gripper that holds on to the ground measures more."""
STAIRS: Final = math.radians(15.0)
"""Pitch above which a robot may stand on the edges of stairs; ramps are mostly flatter."""
PREDICTION: Final = 0.3
"""Seconds that joints are predicted to move on when their command ends: reaction and braking."""

AS_MEASURED: Final[Mapping[str, float]] = {}
"""Velocities of no joints."""

EDGES: Final = ("rear", "right", "front", "left")
"""Edges of the support polygon, over which the robot tips backward, to the right, forward, to the left."""
PITCH_EDGES: Final = frozenset({"rear", "front"})


class Margin(NamedTuple):
    """The margin of tipping over one edge."""

    angle: float
    """Radians."""
    edge: str
    """One of `EDGES`."""


class Payload(NamedTuple):
    """The load of the gripper: kilograms, and the position in the frame of the root link."""

    mass: float
    position: Vector


NO_PAYLOAD: Final = Payload(0.0, (0.0, 0.0, 0.0))


class StabilityModel:
    """The masses of a robot, and the shapes on which it stands."""

    def __init__(self, robot: RobotModel) -> None:
        self._tree = FrameTree(robot.description)
        urdf = robot.description.urdf
        self._bodies = [
            (body.link, body.mass, (body.origin.x, body.origin.y, body.origin.z)) for body in inertials(urdf)
        ]
        carriers = set(_carriers(robot))
        self._shapes = [shape for shape in collision_boxes(urdf) if shape.link in carriers]

    @property
    def can_tip(self) -> bool:
        """True if the robot stands on tracks or wheels whose shapes are known."""
        return bool(self._shapes)

    def frames(self, positions: Mapping[str, float]) -> dict[str, Transform]:
        """Frames of all links in the root link's, for positions of joints by name."""
        return self._tree.poses(positions)

    def mass_beyond(self, link: str) -> float:
        """Kilograms of a link and of all that it carries."""
        carried = {link}
        for joint in self._tree.joints:
            if joint.parent in carried:
                carried.add(joint.child)
        return sum(mass for name, mass, _ in self._bodies if name in carried)

    def centre(self, frames: Mapping[str, Transform], payload: Payload = NO_PAYLOAD) -> Vector:
        """Centre of mass in the root link's frame."""
        mass, moment = payload.mass, scaled(payload.position, payload.mass)
        for link, part, middle in self._bodies:
            mass += part
            moment = add(moment, scaled(frames[link].apply(middle), part))
        return scaled(moment, 1.0 / mass) if mass > 0.0 else moment

    def margins(
        self, frames: Mapping[str, Transform], down: Vector, payload: Payload = NO_PAYLOAD, overhang: float = 0.0
    ) -> list[Margin]:
        """The margins of all edges; `down`: the direction of gravity in the root link's frame.

        `overhang`: metres at the front and the rear that nothing carries.
        """
        centre = self.centre(frames, payload)
        corners = support_polygon([point for shape in self._shapes for point in _lowest(frames, shape)], centre)
        if overhang:
            corners = _shortened(corners, overhang)
        edges = zip(EDGES, corners, (*corners[1:], corners[0]), strict=True)
        return [Margin(tipping_angle(begin, end, centre, down), name) for name, begin, end in edges]


def _carriers(robot: RobotModel) -> Iterator[str]:
    """The links that touch the ground: belts and wheels."""
    if robot.tracks is not None:
        for name in robot.tracks.left + robot.tracks.right:
            yield robot.description.joint(name).child
    if robot.wheels is not None:
        for wheel in robot.wheels.wheels:
            yield wheel.joint.child


def _lowest(frames: Mapping[str, Transform], shape: CollisionBox) -> Iterator[Vector]:
    """Points of a shape that may touch the ground, in the root link's frame."""
    frame = frames[shape.link] @ Transform.from_pose(shape.origin)
    x, y, z = (size / 2.0 for size in shape.size)
    if shape.is_round:  # about its z axis
        for side in (-z, z):
            px, py, pz = frame.apply((0.0, 0.0, side))
            yield px, py, pz - x
        return
    for signs in itertools.product((-1.0, 1.0), repeat=3):
        yield frame.apply((signs[0] * x, signs[1] * y, signs[2] * z))


def support_polygon(points: Sequence[Vector], centre: Vector) -> tuple[Vector, Vector, Vector, Vector]:
    """Corners of the area on which a robot stands: rear left, rear right, front right, front left.

    `points` may touch the ground; those carry the robot between which its centre of mass is, seen from the side.
    """
    rear, front = _resting_points(sorted((x, z) for x, _, z in points), centre[0])
    slope = (front[1] - rear[1]) / (front[0] - rear[0]) if front[0] > rear[0] else 0.0
    carrying = [(x, y) for x, y, z in points if z - (rear[1] + slope * (x - rear[0])) <= FLAT]
    back, ahead = min(x for x, _ in carrying), max(x for x, _ in carrying)
    right, left = min(y for _, y in carrying), max(y for _, y in carrying)
    low, high = (rear[1] + slope * (x - rear[0]) for x in (back, ahead))
    return (back, left, low), (back, right, low), (ahead, right, high), (ahead, left, high)


def _shortened(
    corners: tuple[Vector, Vector, Vector, Vector], overhang: float
) -> tuple[Vector, Vector, Vector, Vector]:
    """The support polygon without this length at each end, but for a tenth of it in the middle."""
    back, ahead = corners[0][0], corners[2][0]
    share = min(0.45, overhang / (ahead - back)) if ahead > back else 0.0
    rear_left, rear_right, front_right, front_left = corners
    return (
        add(rear_left, scaled(difference(front_left, rear_left), share)),
        add(rear_right, scaled(difference(front_right, rear_right), share)),
        add(front_right, scaled(difference(rear_right, front_right), share)),
        add(front_left, scaled(difference(rear_left, front_left), share)),
    )


def _resting_points(profile: Sequence[tuple[float, float]], middle: float) -> tuple[tuple[float, float], ...]:
    """The two points of the lower convex hull of a profile (x, z; sorted) between which x = `middle` lies."""
    hull: list[tuple[float, float]] = []
    for point in profile:
        while len(hull) > 1 and _turn(hull[-2], hull[-1], point) <= 0.0:
            hull.pop()
        if not hull or point[0] > hull[-1][0]:  # of points one above the other the lowest counts
            hull.append(point)
    for first, second in itertools.pairwise(hull):
        if middle <= second[0]:
            return first, second
    return hull[-2:][0], hull[-1]


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def tipping_angle(begin: Vector, end: Vector, centre: Vector, down: Vector) -> float:
    """Angle of tipping over an edge, which is on the right of the robot seen from `begin` to `end`.

    Positive while the line of gravity through the centre of mass passes inside; radians.
    """
    axis = difference(end, begin)
    length = math.sqrt(dot(axis, axis))
    if length == 0.0:
        return -math.pi
    axis = scaled(axis, 1.0 / length)
    to_edge = _across(difference(end, centre), axis)
    gravity = _across(down, axis)
    return math.atan2(dot(cross(to_edge, gravity), axis), dot(to_edge, gravity))


def _across(vector: Vector, axis: Vector) -> Vector:
    """The part of a vector at right angles to a unit vector."""
    return difference(vector, scaled(axis, dot(vector, axis)))


def gravity_direction(pose: Pose) -> Vector:
    """Unit vector downwards in the frame of a body with this attitude."""
    sine = math.sin(pose.pitch)
    cosine = math.cos(pose.pitch)
    return sine, -math.sin(pose.roll) * cosine, -math.cos(pose.roll) * cosine


class StabilityMonitor:
    """The present stability of a robot, and the limits that follow; shared by the modules that move it."""

    def __init__(self, setup: StabilitySetup, model: RobotModel, robot: RobotParts) -> None:
        self.setup = setup
        self.pitchover = self.rollover = setup.on
        """True while motions are limited that could tip the robot over, forward or backward, and to a side."""
        self._model = StabilityModel(model)
        self._robot = robot
        self._localization = Localization.of(robot)
        measured = (sensor for sensor in model.force_torque if sensor.name in robot.force_torque)
        self._scale = next((sensor for sensor in measured if _carries(model, sensor.link)), None)
        self._weight = 0.0
        """Kilograms, averaged."""
        self._weighed_at: float | None = None
        self._beyond = self._model.mass_beyond(self._scale.link) if self._scale is not None else 0.0
        self._hand = _hand(model, self._scale.link if self._scale is not None else "")

    def payload(self) -> Payload:
        """The load of the gripper, by the sensor of force behind it; else that of the robot's file."""
        frames = self._model.frames(joint_positions(self._robot.groups.values()))
        return self._payload(frames, self._down())

    def margin(self, ahead: float = 0.0) -> Margin:
        """The least margin, with the joints `ahead` seconds in the future if they move on as they do."""
        return min(self._margins(ahead))

    def limiting(
        self, ahead: float = 0.0, velocities: Mapping[str, float] = AS_MEASURED, *, standing: bool = False
    ) -> Margin:
        """The least margin of the edges over which this robot is to be kept from tipping; pi if there is none.

        `ahead` seconds in the future joints have moved with these velocities, others with those that are measured.
        `standing`: of a robot that may stand on the edges of stairs, for as long as it does not drive.
        """
        margins = self._margins(ahead, velocities, standing=standing)
        kept = [margin for margin in margins if self._keeps(margin.edge)]
        return min(kept, default=Margin(math.pi, ""))

    @property
    def limits(self) -> bool:
        """True while motions are limited."""
        return self.pitchover or self.rollover

    def factor(self, margin: Margin) -> float:
        """Fraction of the speed with which the robot may move."""
        setup = self.setup
        share = (margin.angle - setup.stop) / (setup.slow - setup.stop)
        return min(1.0, max(setup.creep, share))

    @property
    def warning(self) -> str:
        """Why the operator should be careful, as a sentence; empty if there is no need."""
        margin = self.margin()
        return "" if margin.angle > self.setup.stop else self.text(margin)

    def text(self, margin: Margin) -> str:
        """A margin as a clause for people."""
        whither = {"rear": "backward", "front": "forward"}.get(margin.edge, f"to the {margin.edge}")
        carried = self.payload().mass
        load = f" with {carried:.0f} kg in the gripper" if carried >= 1.0 else ""
        return f"{math.degrees(margin.angle):.0f} degrees from tipping {whither}{load}"

    def _keeps(self, edge: str) -> bool:
        return self.pitchover if edge in PITCH_EDGES else self.rollover

    def _margins(
        self, ahead: float, velocities: Mapping[str, float] = AS_MEASURED, *, standing: bool = False
    ) -> list[Margin]:
        positions = joint_positions(self._robot.groups.values())
        down = self._down()
        frames = self._model.frames(positions)
        payload = self._payload(frames, down)
        if ahead:
            frames = self._model.frames(self._positions_after(positions, ahead, velocities))
            payload = Payload(payload.mass, frames[self._hand].position)
        on_stairs = standing and abs(down[0]) > math.sin(STAIRS)
        return self._model.margins(frames, down, payload, self.setup.overhang if on_stairs else 0.0)

    def _positions_after(
        self, positions: Mapping[str, float], ahead: float, velocities: Mapping[str, float]
    ) -> dict[str, float]:
        found = dict(positions)
        for group in self._robot.groups.values():
            for joint, velocity in zip(group.joints, group.state().velocities, strict=True):
                after = found[joint.name] + velocities.get(joint.name, velocity) * ahead
                found[joint.name] = min(max(after, joint.lower), joint.upper) if joint.lower < joint.upper else after
        return found

    def _down(self) -> Vector:
        pose = self._robot.drive.pose() if self._localization is None else self._localization.state().local.pose
        return gravity_direction(pose)

    def _payload(self, frames: Mapping[str, Transform], down: Vector) -> Payload:
        hand = frames[self._hand].position
        if self._scale is None:
            return Payload(self.setup.payload, hand)
        wrench = self._robot.force_torque[self._scale.name].wrench
        mass = dot(frames[self._scale.link].rotate(wrench.force), down) / GRAVITY - self._beyond
        before, self._weighed_at = self._weighed_at, wrench.time
        share = 1.0 if before is None else 1.0 - math.exp(-max(0.0, wrench.time - before) / WEIGHING_TIME)
        self._weight += share * (min(MAX_PAYLOAD, max(0.0, mass)) - self._weight)
        return Payload(self._weight if self._weight > MIN_PAYLOAD else 0.0, hand)


def _carries(model: RobotModel, link: str) -> bool:
    """True for a link that a group of joints moves: a sensor there weighs what a tool holds."""
    chain = model.description.chain(model.description.root(), link)
    moved = {name for group in model.groups.values() for name in group.joints}
    return any(joint.name in moved for joint in chain)


def _hand(model: RobotModel, sensor: str) -> str:
    """The link with which the robot holds things.

    The tip of a group beyond the sensor, or of the group with most joints; without such groups the sensor's link, or
    the root.
    """
    description, root = model.description, model.description.root()
    groups = sorted(model.groups.values(), key=lambda group: -len(group.joints))
    for group in groups:
        if not sensor or any(joint.child == sensor for joint in description.chain(root, group.tip)):
            return group.tip
    return sensor or root


def stability_of(model: RobotModel, robot: RobotParts) -> StabilityMonitor | None:
    """The monitor of a robot; None without the table `[stability]`, or for one that cannot tip over."""
    if model.stability is None or not StabilityModel(model).can_tip:
        return None
    return StabilityMonitor(model.stability, model, robot)
