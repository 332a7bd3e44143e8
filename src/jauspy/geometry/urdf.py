"""Links and joints of a robot, and the parser of URDF (after xacro). Frames as in REP-103; SI units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Final, TypeAlias

from lxml import etree

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose

ORIGIN: Final = Pose()
"""The identity."""


class JointKind(Enum):
    """The types of joints that are supported; the values are URDF's names."""

    REVOLUTE = "revolute"
    CONTINUOUS = "continuous"
    PRISMATIC = "prismatic"
    FIXED = "fixed"


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of a robot. Limits: radians or metres; rad/s or m/s; newton metres or newtons.

    A continuous joint turns without end: its limits are infinite, and its position counts full turns.
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    origin: Pose = ORIGIN
    """Where the joint's frame is in the parent link's, at position zero."""
    axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
    """Of unit length, in the joint's frame."""
    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0
    damping: float = 0.0
    """Viscous friction: effort per velocity."""
    friction: float = 0.0
    """Coulomb friction: effort."""
    mimics: str | None = None
    """The joint whose position this one follows: `multiplier` times it, plus `offset`."""
    multiplier: float = 1.0
    offset: float = 0.0

    @property
    def turns(self) -> bool:
        """True for a revolute or continuous joint, whose positions are angles."""
        return self.kind in (JointKind.REVOLUTE, JointKind.CONTINUOUS)

    @property
    def is_independent(self) -> bool:
        """True for a joint that moves, and that does not mimic another one."""
        return self.kind is not JointKind.FIXED and self.mimics is None

    def position(self, positions: Mapping[str, float]) -> float:
        """Its position where the independent joints have `positions`, by name; those without one are at zero."""
        if self.mimics is None:
            return positions.get(self.name, 0.0)
        return self.multiplier * positions.get(self.mimics, 0.0) + self.offset


@dataclass(frozen=True, slots=True)
class RobotDescription:
    """A robot's tree of links and joints, as its URDF gives it."""

    name: str
    urdf: str
    joints: Mapping[str, Joint]
    friction: Mapping[str, float] = field(default_factory=dict)
    """Coefficients of friction by link, where given."""

    def joint(self, name: str) -> Joint:
        """The joint of that name. Raises `ConfigError`, which lists the joints that move, for an unknown one."""
        if name not in self.joints:
            moving = [joint.name for joint in self.joints.values() if joint.kind is not JointKind.FIXED]
            raise ConfigError(f"{self.name} has no joint {name!r}; those that move are: {', '.join(moving)}")
        return self.joints[name]

    def links(self) -> set[str]:
        """The names of all links."""
        return {link for joint in self.joints.values() for link in (joint.parent, joint.child)}

    def root(self) -> str:
        """The root link."""
        (root,) = self.links() - {joint.child for joint in self.joints.values()}
        return root

    def chain(self, base: str, tip: str) -> tuple[Joint, ...]:
        """The joints from one link to another, base to tip. Raises `ConfigError` if the tip is not below the base."""
        above = {joint.child: joint for joint in self.joints.values()}
        found: list[Joint] = []
        link = tip
        while link != base:
            if link not in above:
                raise ConfigError(f"{self.name}: no joints lead from link {base!r} to link {tip!r}")
            found.append(above[link])
            link = above[link].parent
        return tuple(reversed(found))


Element: TypeAlias = etree._Element  # noqa: SLF001 - lxml gives its element no public name

KINDS = {kind.value: kind for kind in JointKind}


def parse_urdf(text: str) -> RobotDescription:
    """The robot that a URDF describes. Raises `ConfigError`, which names the joint."""
    try:
        root = etree.fromstring(text.encode(), etree.XMLParser(resolve_entities=False, no_network=True))
    except etree.XMLSyntaxError as error:
        raise ConfigError(f"the URDF is not XML: {error}") from error
    if root.tag != "robot":
        raise ConfigError(f"the URDF begins with <{root.tag}>, not with <robot>")
    joints = _resolve_mimics([_joint(element) for element in root.findall("joint")])
    description = RobotDescription(
        root.get("name", "robot"), text, {joint.name: joint for joint in joints}, _friction(root)
    )
    _check(description, [str(link.get("name")) for link in root.findall("link")], joints)
    return description


def _check(description: RobotDescription, links: list[str], joints: list[Joint]) -> None:
    if len(description.joints) != len(joints):
        raise ConfigError(f"the URDF of {description.name} gives a joint's name twice")
    known = set(links)
    for joint in joints:
        for link in (joint.parent, joint.child):
            if link not in known:
                raise ConfigError(f"joint {joint.name!r} names the link {link!r}, which the URDF does not have")
    roots = known - {joint.child for joint in joints}
    if len(roots) != 1:
        raise ConfigError(f"the URDF of {description.name} must have one root link; it has: {', '.join(sorted(roots))}")


def _joint(element: Element) -> Joint:
    name = str(element.get("name"))
    kind = KINDS.get(str(element.get("type")))
    if kind is None:
        raise ConfigError(f"joint {name!r} is {element.get('type')!r}; jauspy knows: {', '.join(KINDS)}")
    limit, dynamics, mimic = element.find("limit"), element.find("dynamics"), element.find("mimic")
    if kind in (JointKind.REVOLUTE, JointKind.PRISMATIC) and limit is None:
        raise ConfigError(f"joint {name!r} has no <limit>; it needs lower, upper, effort and velocity")
    endless = kind is JointKind.CONTINUOUS
    return Joint(
        name,
        kind,
        _link(element, "parent", name),
        _link(element, "child", name),
        _origin(element, name),
        _axis(element, name),
        lower=-math.inf if endless else _number(limit, "lower", name),
        upper=math.inf if endless else _number(limit, "upper", name),
        effort=_number(limit, "effort", name),
        velocity=_number(limit, "velocity", name),
        damping=_number(dynamics, "damping", name),
        friction=_number(dynamics, "friction", name),
        mimics=None if mimic is None else mimic.get("joint", ""),
        multiplier=_number(mimic, "multiplier", name, 1.0),
        offset=_number(mimic, "offset", name),
    )


def _resolve_mimics(joints: list[Joint]) -> list[Joint]:
    """The joints, of which those that mimic name an independent joint: a chain of them is shortened."""
    known = {joint.name: joint for joint in joints}
    return [_resolved(joint, known) for joint in joints]


def _resolved(joint: Joint, known: Mapping[str, Joint]) -> Joint:
    for _ in known:
        if joint.mimics is None:
            return joint
        followed = known.get(joint.mimics)
        if followed is None or followed.kind is JointKind.FIXED:
            raise ConfigError(f"joint {joint.name!r} mimics {joint.mimics!r}, which is not a joint that moves")
        if followed.mimics is None:
            return joint
        joint = replace(
            joint,
            mimics=followed.mimics,
            multiplier=joint.multiplier * followed.multiplier,
            offset=joint.multiplier * followed.offset + joint.offset,
        )
    raise ConfigError(f"joint {joint.name!r} mimics itself")


def _link(element: Element, tag: str, joint: str) -> str:
    found = element.find(tag)
    if found is None or not found.get("link"):
        raise ConfigError(f"joint {joint!r} has no <{tag} link=...>")
    return str(found.get("link"))


def _number(element: Element | None, key: str, where: str, default: float = 0.0) -> float:
    text = None if element is None else element.get(key)
    return default if text is None else _numbers(text, 1, where)[0]


def _numbers(text: str, count: int, where: str) -> tuple[float, ...]:
    try:
        values = tuple(float(part) for part in text.split())
    except ValueError:
        values = ()
    if len(values) != count or not all(map(math.isfinite, values)):
        raise ConfigError(f"{where!r}: {text!r} is not {count} finite number{'s' if count > 1 else ''}")
    return values


def _origin(element: Element, joint: str) -> Pose:
    origin = element.find("origin")
    if origin is None:
        return ORIGIN
    xyz, rpy = (_numbers(origin.get(key, "0 0 0"), 3, joint) for key in ("xyz", "rpy"))
    return Pose(*xyz, *rpy)


def _axis(element: Element, joint: str) -> tuple[float, float, float]:
    axis = element.find("axis")
    x, y, z = _numbers("1 0 0" if axis is None else axis.get("xyz", ""), 3, joint)
    length = math.hypot(x, y, z)
    if not length:
        raise ConfigError(f"joint {joint!r}: the axis has no direction")
    return x / length, y / length, z / length


def _friction(root: Element) -> dict[str, float]:
    """Coefficients of friction, from Gazebo's extension of URDF: `<gazebo reference="LINK"><mu1>`."""
    found = ((gazebo.get("reference"), gazebo.find("mu1")) for gazebo in root.findall("gazebo"))
    return {link: _numbers(mu.text or "", 1, link)[0] for link, mu in found if link and mu is not None}


@dataclass(frozen=True, slots=True)
class Inertial:
    """The mass of a link, kg, and the pose of its centre of mass in the link's frame."""

    link: str
    mass: float
    origin: Pose


@dataclass(frozen=True, slots=True)
class CollisionBox:
    """The bounding box, in metres, of a link's box, cylinder or sphere, and its pose in the link's frame."""

    link: str
    size: tuple[float, float, float]
    origin: Pose
    is_round: bool = False
    """True for a cylinder or sphere, whose diameter is the first size."""


def inertials(text: str) -> list[Inertial]:
    """The masses in a URDF that `parse_urdf` accepts. Raises `ConfigError`, which names the link, if malformed."""
    found = []
    for link in etree.fromstring(text.encode()).findall("link"):
        name, inertial = str(link.get("name")), link.find("inertial")
        if inertial is not None:
            mass = inertial.find("mass")
            found.append(Inertial(name, 0.0 if mass is None else _number(mass, "value", name), _origin(inertial, name)))
    return found


def collision_boxes(text: str) -> list[CollisionBox]:
    """The collision shapes in a URDF that `parse_urdf` accepts, without meshes."""
    links = etree.fromstring(text.encode()).findall("link")
    pairs = [(str(link.get("name")), collision) for link in links for collision in link.findall("collision")]
    sizes = [
        (name, _size(shape.find("geometry"), name), _origin(shape, name), _is_round(shape)) for name, shape in pairs
    ]
    return [CollisionBox(name, size, origin, is_round) for name, size, origin, is_round in sizes if size is not None]


def _is_round(shape: Element) -> bool:
    return shape.find("geometry/cylinder") is not None or shape.find("geometry/sphere") is not None


def _size(geometry: Element | None, link: str) -> tuple[float, float, float] | None:
    kind = None if geometry is None or not len(geometry) else geometry[0]
    match None if kind is None else kind.tag:
        case "box":
            x, y, z = _numbers("" if kind is None else kind.get("size", ""), 3, link)
            return x, y, z
        case "cylinder":
            across = 2.0 * _number(kind, "radius", link)
            return across, across, _number(kind, "length", link)
        case "sphere":
            across = 2.0 * _number(kind, "radius", link)
            return across, across, across
    return None
