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
from jauspy.geometry.vectors import Rotation

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
    """The joint's frame in the parent link's, at position zero."""
    axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
    """Unit vector of the axis, in the joint's frame."""
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
    place: str = field(default="", compare=False)
    """Location of its limits, as `arm.urdf:12`; empty for a joint that is not from a file."""

    @property
    def turns(self) -> bool:
        """True for a revolute or continuous joint, whose positions are angles."""
        return self.kind in (JointKind.REVOLUTE, JointKind.CONTINUOUS)

    @property
    def is_independent(self) -> bool:
        """True for a joint that moves, and that does not mimic another one."""
        return self.kind is not JointKind.FIXED and self.mimics is None

    def position(self, positions: Mapping[str, float]) -> float:
        """Position of the joint where independent joints have `positions`, by name; joints without one are at zero."""
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
    only_link: str = ""
    """The link of a robot without joints."""

    def joint(self, name: str) -> Joint:
        """The joint of that name. Raises `ConfigError`, which lists the joints that move, for an unknown one."""
        if name not in self.joints:
            moving = [joint.name for joint in self.joints.values() if joint.kind is not JointKind.FIXED]
            raise ConfigError(f"{self.name} has no joint {name!r}; those that move are: {', '.join(moving)}")
        return self.joints[name]

    def links(self) -> set[str]:
        """The names of all links."""
        found = {link for joint in self.joints.values() for link in (joint.parent, joint.child)}
        return found or {self.only_link}

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

UNGUIDED: Final = ("floating", "planar")
"""Types of joints without a motor; they are taken as fixed."""

PLACE: Final = "jauspy.place"
"""Attribute with the file and line of an element, where the text of a URDF is not that of a file."""

MAX_ELEMENTS: Final = 200_000
"""XML elements of a URDF."""


def place(element: Element) -> str:
    """Location of an element, as `arm.urdf:12`, or `line 12` if the file is not known."""
    return element.get(PLACE) or f"line {element.sourceline}"


def numbers(element: Element, key: str, count: int, default: str | None = None) -> tuple[float, ...]:
    """The finite numbers of an attribute; `default` is the text of one that is missing. Raises `ConfigError`."""
    text = element.get(key, default)
    if text is None:
        raise ConfigError(f"{place(element)}: <{element.tag}> has no {key}")
    try:
        values = tuple(float(part) for part in text.split())
    except ValueError:
        values = ()
    if len(values) != count or not all(map(math.isfinite, values)):
        raise ConfigError(
            f"{place(element)}: <{element.tag} {key}={text!r}>: {text!r} is not {count} finite "
            f"number{'s' if count > 1 else ''}"
        )
    return values


def origin(element: Element) -> Pose:
    """The pose in `<origin>` of a joint, a shape or an inertia. Raises `ConfigError`."""
    found = element.find("origin")
    if found is None:
        return ORIGIN
    xyz, rpy = (numbers(found, key, 3, "0 0 0") for key in ("xyz", "rpy"))
    return Pose(*xyz, *rpy)


def parse_urdf(text: str) -> RobotDescription:
    """The robot that a URDF describes. Raises `ConfigError`, which names the line, and the joint or link."""
    root = parse_tree(text)
    elements = root.findall("joint")
    joints = _resolve_mimics([_joint(element) for element in elements], list(map(place, elements)))
    links = [str(link.get("name")) for link in root.findall("link")]
    description = RobotDescription(
        root.get("name", "robot"),
        text,
        {joint.name: joint for joint in joints},
        _friction(root),
        links[0] if len(links) == 1 else "",
    )
    _check(description, root, links)
    return description


def parse_tree(text: str) -> Element:
    """The element `<robot>` of a URDF. Raises `ConfigError`, which names the line."""
    try:
        root = etree.fromstring(text.encode(), etree.XMLParser(resolve_entities=False, no_network=True))
    except etree.XMLSyntaxError as error:
        raise ConfigError(f"line {error.lineno}: the URDF is not XML: {error.msg}") from error
    if root.tag != "robot":
        raise ConfigError(f"{place(root)}: the URDF begins with <{root.tag}>, not with <robot>")
    if sum(1 for _ in root.iter()) > MAX_ELEMENTS:
        raise ConfigError(f"the URDF has more than {MAX_ELEMENTS} elements")
    return root


def _check(description: RobotDescription, root: Element, links: list[str]) -> None:
    named: dict[tuple[str, str | None], Element] = {}
    for element in root.iterchildren("joint", "link"):
        key = (str(element.tag), element.get("name"))
        if key in named:
            raise ConfigError(
                f"{place(element)}: the URDF of {description.name} gives a {element.tag}'s name twice: {key[1]!r}, "
                f"first at {place(named[key])}"
            )
        named[key] = element
    known, parents = set(links), dict[str, str]()
    for joint in description.joints.values():
        where = place(named["joint", joint.name])
        for link in (joint.parent, joint.child):
            if link not in known:
                raise ConfigError(
                    f"{where}: joint {joint.name!r} names the link {link!r}, which the URDF does not have"
                )
        if joint.child in parents:
            raise ConfigError(
                f"{where}: joints {parents[joint.child]!r} and {joint.name!r} both have the child {joint.child!r}; "
                "a URDF is a tree"
            )
        parents[joint.child] = joint.name
    roots = known - set(parents)
    if len(roots) != 1:
        raise ConfigError(
            f"the URDF of {description.name} must have one root link; it has: {', '.join(sorted(roots)) or 'none'}"
        )
    (only,) = roots
    if len(_reached(description, only)) != len(known):
        raise ConfigError(f"the joints of the URDF of {description.name} form a loop; a URDF is a tree")


def _reached(description: RobotDescription, root: str) -> set[str]:
    below: dict[str, list[str]] = {}
    for joint in description.joints.values():
        below.setdefault(joint.parent, []).append(joint.child)
    found, pending = {root}, [root]
    while pending:
        more = below.get(pending.pop(), [])
        found.update(more)
        pending += more
    return found


def _joint(element: Element) -> Joint:
    name, type_ = str(element.get("name")), str(element.get("type"))
    kind = JointKind.FIXED if type_ in UNGUIDED else KINDS.get(type_)
    if kind is None:
        raise ConfigError(f"{place(element)}: joint {name!r} is {type_!r}; jauspy supports: {', '.join(KINDS)}")
    limit, dynamics, mimic = element.find("limit"), element.find("dynamics"), element.find("mimic")
    if kind in (JointKind.REVOLUTE, JointKind.PRISMATIC) and limit is None:
        raise ConfigError(
            f"{place(element)}: joint {name!r} has no <limit>; it needs lower, upper, effort and velocity"
        )
    endless = kind is JointKind.CONTINUOUS
    joint = Joint(
        name,
        kind=kind,
        parent=_link(element, "parent", name),
        child=_link(element, "child", name),
        origin=origin(element),
        axis=_axis(element, name),
        lower=-math.inf if endless else _number(limit, "lower"),
        upper=math.inf if endless else _number(limit, "upper"),
        effort=_number(limit, "effort"),
        velocity=_number(limit, "velocity"),
        damping=_number(dynamics, "damping"),
        friction=_number(dynamics, "friction"),
        mimics=None if mimic is None or kind is JointKind.FIXED else mimic.get("joint", ""),
        multiplier=_number(mimic, "multiplier", 1.0),
        offset=_number(mimic, "offset"),
        place=place(element if limit is None else limit),
    )
    for key, value in (("effort", joint.effort), ("velocity", joint.velocity)):
        if value < 0.0 and limit is not None:
            raise ConfigError(f'{place(limit)}: joint {name!r}: <limit {key}="{value:g}">: is negative')
    for key, value in (("damping", joint.damping), ("friction", joint.friction)):
        if value < 0.0 and dynamics is not None:
            raise ConfigError(f'{place(dynamics)}: joint {name!r}: <dynamics {key}="{value:g}">: is negative')
    if joint.lower > joint.upper and limit is not None:
        raise ConfigError(
            f"{place(limit)}: joint {name!r}: <limit>: lower {joint.lower:g} is above upper {joint.upper:g}"
        )
    return joint


def _resolve_mimics(joints: list[Joint], places: list[str]) -> list[Joint]:
    """The joints, of which those that mimic name an independent joint: a chain of them is shortened."""
    known = {joint.name: joint for joint in joints}
    return [_resolved(joint, known, where) for joint, where in zip(joints, places, strict=True)]


def _resolved(joint: Joint, known: Mapping[str, Joint], where: str) -> Joint:
    for _ in known:
        if joint.mimics is None:
            return joint
        followed = known.get(joint.mimics)
        if followed is None or followed.kind is JointKind.FIXED:
            raise ConfigError(f"{where}: joint {joint.name!r} mimics {joint.mimics!r}, which is not a moving joint")
        if followed.mimics is None:
            return joint
        joint = replace(
            joint,
            mimics=followed.mimics,
            multiplier=joint.multiplier * followed.multiplier,
            offset=joint.multiplier * followed.offset + joint.offset,
        )
    raise ConfigError(f"{where}: joint {joint.name!r} mimics itself")


def _link(element: Element, tag: str, joint: str) -> str:
    found = element.find(tag)
    if found is None or not found.get("link"):
        raise ConfigError(f"{place(element)}: joint {joint!r} has no <{tag} link=...>")
    return str(found.get("link"))


def _number(element: Element | None, key: str, default: float = 0.0) -> float:
    return default if element is None or element.get(key) is None else numbers(element, key, 1)[0]


def _axis(element: Element, joint: str) -> tuple[float, float, float]:
    axis = element.find("axis")
    x, y, z = (1.0, 0.0, 0.0) if axis is None else numbers(axis, "xyz", 3)
    length = math.hypot(x, y, z)
    if not length and element.get("type") in (JointKind.FIXED.value, *UNGUIDED):
        return 1.0, 0.0, 0.0
    if not length:
        raise ConfigError(f"{place(element)}: joint {joint!r}: the axis has no direction")
    return x / length, y / length, z / length


def _friction(root: Element) -> dict[str, float]:
    """Coefficients of friction, from Gazebo's extension of URDF: `<gazebo reference="LINK"><mu1>`."""
    links = {link.get("name") for link in root.findall("link")}
    found = {}
    for gazebo in root.findall("gazebo"):
        link, mu = gazebo.get("reference"), gazebo.find("mu1")
        if link in links and mu is not None:
            try:
                found[str(link)] = float(mu.get("value") or mu.text or "")
            except ValueError:
                raise ConfigError(f"{place(mu)}: <mu1>{mu.text}</mu1> is not a number") from None
    return found


@dataclass(frozen=True, slots=True)
class Inertial:
    """The mass of a link, kg, and the pose of its centre of mass in the link's frame."""

    link: str
    mass: float
    origin: Pose
    tensor: Rotation = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    """Moments and products of inertia about the centre of mass, along the axes of `origin`, kg m^2."""


@dataclass(frozen=True, slots=True)
class CollisionBox:
    """The bounding box, in metres, of a link's box, cylinder or sphere, and its pose in the link's frame."""

    link: str
    size: tuple[float, float, float]
    origin: Pose
    is_round: bool = False
    """True for a cylinder or sphere, whose diameter is the first size."""
    is_sphere: bool = False


def inertials(text: str) -> list[Inertial]:
    """The masses in a URDF that `parse_urdf` accepts. Raises `ConfigError`, which names the link, if malformed."""
    found = []
    for link in parse_tree(text).findall("link"):
        name, inertial = str(link.get("name")), link.find("inertial")
        if inertial is not None:
            mass, inertia = inertial.find("mass"), inertial.find("inertia")
            xx, xy, xz, yy, yz, zz = (_number(inertia, f"i{key}") for key in ("xx", "xy", "xz", "yy", "yz", "zz"))
            tensor = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
            found.append(Inertial(name, _number(mass, "value"), origin(inertial), tensor))
    return found


def collision_boxes(text: str) -> list[CollisionBox]:
    """The collision shapes in a URDF that `parse_urdf` accepts, without meshes."""
    links = parse_tree(text).findall("link")
    pairs = [(str(link.get("name")), collision) for link in links for collision in link.findall("collision")]
    sizes = [(name, _size(shape.find("geometry")), shape) for name, shape in pairs]
    return [
        CollisionBox(name, size, origin(shape), _is_round(shape), shape.find("geometry/sphere") is not None)
        for name, size, shape in sizes
        if size is not None
    ]


def _is_round(shape: Element) -> bool:
    return shape.find("geometry/cylinder") is not None or shape.find("geometry/sphere") is not None


def _size(geometry: Element | None) -> tuple[float, float, float] | None:
    kind = None if geometry is None or not len(geometry) else geometry[0]
    if kind is None:
        return None
    match kind.tag:
        case "box":
            x, y, z = numbers(kind, "size", 3)
            return x, y, z
        case "cylinder":
            diameter = 2.0 * numbers(kind, "radius", 1)[0]
            return diameter, diameter, numbers(kind, "length", 1)[0]
        case "sphere":
            diameter = 2.0 * numbers(kind, "radius", 1)[0]
            return diameter, diameter, diameter
    return None
