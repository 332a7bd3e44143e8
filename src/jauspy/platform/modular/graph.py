"""The graph of attached modules: derives the chain of an arm from the states of connectors.

A part is one rigid body, a servo module two: its housing and its output link. An attachment joins the body that has the
connector to the (first) body of the part that it holds, whichever of the two carries the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.parts import CellSetup, PartKind, PartType


class Attachment(NamedTuple):
    """A connector that holds a part."""

    connector: str
    """Name of the connector, as in `servo_1/output`."""
    part: str
    offset: Transform
    """Frame of the part in the frame of the connector."""


class Body(NamedTuple):
    """A rigid body: a part, or the output link of a servo module."""

    part: str
    output: bool = False


@dataclass(frozen=True, slots=True)
class Link:
    """A body of an arm, and how it is mounted on the one before it.

    `pose` is its frame in the frame of `parent`, at position zero if `joint` is not empty. The joint's axis is given in
    the frame at `joint_pose` in the parent's frame; the body's frame is `body_pose` in the frame that turns.
    """

    body: Body
    parent: Body
    joint: str = ""
    """Name of the servo module whose joint is between them; empty if they are joined rigidly."""
    joint_pose: Transform = IDENTITY
    reversed: bool = False
    """True if the output link carries the housing: the joint then turns the body by minus its position."""
    body_pose: Transform = IDENTITY


@dataclass(frozen=True, slots=True, kw_only=True)
class ArmChain:
    """An arm: all bodies that a base carries through one connection, parents before children."""

    base: str = ""
    """The connection to the base: `platform_1/top`, or `servo_5/output` if the arm holds on to the base by itself."""
    ground: str = ""
    """The base."""
    mount: Transform = IDENTITY
    """Frame of the first body in the frame of the base."""
    root: Body | None = None
    """The first body."""
    links: tuple[Link, ...] = ()
    """All other bodies."""
    joints: tuple[str, ...] = ()
    """Servo modules between base and tip, from base to tip."""
    side_joints: tuple[str, ...] = ()
    """Servo modules of branches: the arm does not move them."""
    parts: tuple[str, ...] = ()
    """Parts between base and tip, from base to tip."""
    tip: str = ""
    """Connector at the end; empty if the end is an input flange (the arm is reversed) or has no connector."""
    tip_body: Body | None = None
    tip_pose: Transform = IDENTITY
    """Frame of the tip's connector in the frame of `tip_body`; the identity for an input flange."""
    loads: tuple[str, ...] = ()
    """Boxes that connectors of the arm hold."""
    load_at_tip: str = ""
    """The box that the tip holds."""
    held_by: tuple[str, ...] = ()
    """Further connections to bases or to the gripper: while there are any, the arm is a closed loop."""


def attachments(connectors: Iterable[tuple[str, ConnectorState]]) -> tuple[Attachment, ...]:
    """The attachments, by the states of connectors."""
    return tuple(Attachment(name, state.attached_to, state.offset) for name, state in connectors if state.attached_to)


@dataclass(frozen=True, slots=True)
class _Edge:
    """One way along an attachment or a joint."""

    start: Body
    end: Body
    pose: Transform
    """Frame of the end in the frame of the start, at position zero."""
    name: str
    """The connector, or the servo module."""
    is_joint: bool


@dataclass(slots=True)
class _Graph:
    """Bodies and the ways between them; connections of the gripper and of bases are kept apart."""

    edges: dict[Body, list[_Edge]] = field(default_factory=dict)
    roots: list[tuple[str, _Edge]] = field(default_factory=list)
    """Edges from a base into a part, with the base's name."""
    grips: dict[str, list[str]] = field(default_factory=dict)
    """Parts that a connector outside of all parts holds, as the gripper does."""


def find_chain(
    cell: CellSetup, attached: Iterable[Attachment], previous: str = "", other: str = "", *, keeps: bool = False
) -> ArmChain:
    """The arm: the longest chain of servo modules from a base. Without one, an empty chain.

    `previous` is the connection that carried the arm before; of chains with as many joints, the one on it is taken, and
    with `keeps` it is taken as long as it has joints. `other` is the connection that carries another arm, whose parts
    are left out. Parts with wheels are not an arm. Of arms of the same length, the base that `cell` lists first has it.
    """
    types = {part.name: cell.types[part.type] for part in cell.parts}
    graph = _graph(types, attached)
    found: dict[frozenset[Body], list[tuple[str, _Edge]]] = {}
    for root in graph.roots:
        found.setdefault(frozenset(_component(graph, root[1].end)), []).append(root)
    best = ArmChain()
    for bodies, roots in found.items():
        parts = {body.part for body in bodies}
        if any(types[part].kind is PartKind.WHEEL for part in parts):
            continue
        if any(root[1].name == other for root in roots):
            continue
        kept = [root for root in roots if root[1].name == previous]
        direct = [root for root in roots if root[1].name.startswith(f"{root[0]}/")]
        ground, edge = (kept or direct or roots)[0]
        grips = [name for name, held in graph.grips.items() if parts.intersection(held)]
        held_by = (*(root[1].name for root in roots if root[1] is not edge), *grips)
        chain = _chain(graph, types, ground, edge, held_by)
        if keeps and kept and chain.joints:
            return chain
        as_long = bool(kept) and len(chain.joints) == len(best.joints)
        if len(chain.joints) > len(best.joints) or not best.base or as_long:
            best = chain
    return best


def _graph(types: Mapping[str, PartType], attached: Iterable[Attachment]) -> _Graph:
    graph = _Graph()
    for name, kind in types.items():
        if kind.servo is not None:
            _join(graph, Body(name), Body(name, output=True), kind.servo.joint, name, is_joint=True)
    for connector, part, offset in attached:
        owner, _, own_name = connector.partition("/")
        if part not in types:
            continue
        if owner not in types:
            graph.grips.setdefault(connector, []).append(part)
            continue
        kind = types[owner]
        frame = kind.connectors.get(own_name)
        if frame is None:
            continue
        carrier, held, pose = Body(owner, output=kind.servo is not None), Body(part), frame @ offset
        if kind.kind is PartKind.BASE and types[part].kind is PartKind.BASE:
            continue
        if kind.kind is PartKind.BASE:
            graph.roots.append((owner, _Edge(carrier, held, pose, connector, is_joint=False)))
        elif types[part].kind is PartKind.BASE:
            graph.roots.append((part, _Edge(held, carrier, pose.inverse(), connector, is_joint=False)))
        else:
            _join(graph, carrier, held, pose, connector, is_joint=False)
    order = {name: index for index, name in enumerate(types)}
    graph.roots.sort(key=lambda root: (order[root[0]], root[1].name))
    return graph


def _join(graph: _Graph, a: Body, b: Body, pose: Transform, name: str, *, is_joint: bool) -> None:
    graph.edges.setdefault(a, []).append(_Edge(a, b, pose, name, is_joint))
    graph.edges.setdefault(b, []).append(_Edge(b, a, pose.inverse(), name, is_joint))


def _component(graph: _Graph, start: Body) -> Iterator[Body]:
    seen, waiting = {start}, [start]
    while waiting:
        body = waiting.pop()
        yield body
        for edge in graph.edges.get(body, ()):
            if edge.end not in seen:
                seen.add(edge.end)
                waiting.append(edge.end)


def _chain(
    graph: _Graph, types: Mapping[str, PartType], ground: str, root: _Edge, held_by: tuple[str, ...]
) -> ArmChain:
    """Walk from the base outward, and take the way with the most servo modules, then the most parts, as the arm."""
    way: dict[Body, tuple[_Edge, ...]] = {root.end: ()}
    links: list[Link] = []
    loads: list[str] = []
    waiting = [root.end]
    while waiting:
        body = waiting.pop(0)
        for edge in sorted(graph.edges.get(body, ()), key=lambda edge: edge.name):
            if edge.end in way:
                continue
            way[edge.end] = (*way[body], edge)
            waiting.append(edge.end)
            links.append(_link(edge, types))
            if types[edge.end.part].kind is PartKind.BOX:
                loads.append(edge.end.part)

    def length(body: Body) -> tuple[int, int, bool]:
        edges = way[body]
        return sum(edge.is_joint for edge in edges), len(edges), _holds_on(body, types, held_by)

    tip_body = max((body for body in way if types[body.part].kind is not PartKind.BOX), key=length, default=root.end)
    path = way[tip_body]
    joints = tuple(edge.name for edge in path if edge.is_joint)
    bodies = (root.end, *(edge.end for edge in path))
    tip, tip_pose = _tip(graph, types, tip_body, held_by, root)
    at_tip = next((edge.end.part for edge in graph.edges.get(tip_body, ()) if tip and edge.name == tip), "")
    return ArmChain(
        base=root.name,
        ground=ground,
        mount=root.pose,
        root=root.end,
        links=tuple(links),
        joints=joints,
        side_joints=tuple(link.joint for link in links if link.joint and link.joint not in joints),
        parts=tuple(dict.fromkeys(body.part for body in bodies)),
        tip=tip,
        tip_body=tip_body,
        tip_pose=tip_pose,
        loads=tuple(loads),
        load_at_tip=at_tip if at_tip in loads else "",
        held_by=held_by,
    )


def _holds_on(body: Body, types: Mapping[str, PartType], held_by: tuple[str, ...]) -> bool:
    """True if a connector of this body holds on to another base."""
    names = types[body.part].connectors
    return any(f"{body.part}/{name}" in held_by for name in names) and _has_connectors(body, types)


def _has_connectors(body: Body, types: Mapping[str, PartType]) -> bool:
    """A servo module has its connectors on its output link, other parts have one body."""
    return body.output or types[body.part].servo is None


def _tip(
    graph: _Graph, types: Mapping[str, PartType], body: Body, held_by: tuple[str, ...], root: _Edge
) -> tuple[str, Transform]:
    """The connector at the end: that which holds a box or a base, else the first that carries nothing of the arm."""
    if not _has_connectors(body, types):
        return "", IDENTITY
    used = {edge.name for edge in graph.edges.get(body, ()) if types[edge.end.part].kind is not PartKind.BOX}
    names = {
        f"{body.part}/{name}": pose
        for name, pose in types[body.part].connectors.items()
        if f"{body.part}/{name}" not in used and f"{body.part}/{name}" != root.name
    }
    holding = {edge.name for edge in graph.edges.get(body, ())}.union(held_by)
    for name, pose in names.items():
        if name in holding:
            return name, pose
    return next(iter(names.items()), ("", IDENTITY))


def _link(edge: _Edge, types: Mapping[str, PartType]) -> Link:
    if not edge.is_joint:
        return Link(edge.end, edge.start, body_pose=edge.pose)
    servo = types[edge.name].servo
    assert servo is not None
    if edge.end.output:
        return Link(edge.end, edge.start, edge.name, joint_pose=servo.joint)
    return Link(edge.end, edge.start, edge.name, reversed=True, body_pose=servo.joint.inverse())
