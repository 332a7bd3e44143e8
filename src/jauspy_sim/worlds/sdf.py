"""Worlds and models of SDFormat 1.4 to 1.11, the format of Gazebo.

Models become bodies: one body of a static model, else a tree of links that move by their joints. Plugins, sensors and
other unsupported elements are skipped, with one log line for each world.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Final

import mujoco
from lxml import etree

from jauspy.errors import ConfigError
from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.urdf import Element
from jauspy.geometry.vectors import Vector, quaternion
from jauspy.user_files import read_file
from jauspy_sim.models.groups import COLLISION
from jauspy_sim.models.shapes import ShapeBuilder, same_shape
from jauspy_sim.worlds.lighting import add_floor, add_sky, add_sun
from jauspy_sim.worlds.model_paths import ModelPaths, sdf_of_model
from jauspy_sim.worlds.sdf_links import LinkBuilder, Names, SdfLink, SkippedElements
from jauspy_sim.worlds.sdf_poses import MODEL, WORLD, Scope, floats, is_true, line_of, located, raw_pose, words

MAX_DEPTH: Final = 8
"""Nesting depth of models."""

MAX_ITEMS: Final = 20_000
"""Links of a world."""

HINGES: Final = ("revolute", "continuous")


def sdf_world(path: Path, paths: ModelPaths) -> mujoco.MjSpec:
    """The world of an SDF file; a model alone stands on an endless floor. Raises `ConfigError` with file and line."""
    return _Reader(path, paths).read()


@dataclass(slots=True)
class _Joint:
    name: str
    element: Element
    parent: str
    child: str
    pose: Transform
    """Pose in the frame of the outermost model."""
    axis: Vector


@dataclass(slots=True)
class _Model:
    """The links and joints of a model and of the models in it."""

    name: str
    links: dict[str, SdfLink] = field(default_factory=dict)
    joints: list[_Joint] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Place:
    """The context of a model: its file, its frame in the outermost model, the prefix of its names."""

    near: Path
    frame: Transform = IDENTITY
    prefix: str = ""
    depth: int = 0
    outer: frozenset[Path] = frozenset()
    """The files of the models around it."""


class _Reader:
    def __init__(self, path: Path, paths: ModelPaths) -> None:
        self._path, self._paths = path, paths
        self._spec = mujoco.MjSpec()
        self._spec.compiler.degree = False
        self._skipped, self._names = SkippedElements(path), Names()
        shapes = ShapeBuilder(self._spec, visual=0, collision=COLLISION)
        self._links = LinkBuilder(shapes, paths, self._skipped, self._names)
        self._items = 0

    def read(self) -> mujoco.MjSpec:
        root = _parse(self._path)
        world = root.find("world")
        add_sky(self._spec)
        if world is None:
            if root.find("model") is None:
                raise ConfigError(f"{self._path}: has neither a <world> nor a <model>")
            add_floor(self._spec)
            world = root
        gravity = world.find("gravity")
        if gravity is not None:
            self._spec.option.gravity = located(self._path, lambda: floats(gravity, 3))
        located(self._path, lambda: self._read_world(world))
        if not self._links.lights:
            add_sun(self._spec)
        self._skipped.tell()
        return self._spec

    def _read_world(self, world: Element) -> None:
        scope = Scope(WORLD)
        for element in world.iterchildren("model", "frame", "include"):
            pose, relative_to = raw_pose(element)
            relative_to = relative_to or element.get("attached_to", "")
            scope.add(str(element.get("name")), pose, relative_to, line_of(element))
        for element in world.iterchildren("*"):
            match element.tag:
                case "model":
                    pose, relative_to = raw_pose(element)
                    base = scope.pose(relative_to or WORLD, line_of(element))
                    self._add_model(element, self._path, base @ pose, str(element.get("name")))
                case "include":
                    self._include(element, scope)
                case "light":
                    pose, relative_to = raw_pose(element)
                    frame = scope.pose(relative_to or WORLD, line_of(element)) @ pose
                    self._links.add_light(element, self._spec.worldbody, frame)
                case "frame":
                    pass
                case _:
                    self._skipped.add(element, self._path)

    def _include(self, include: Element, scope: Scope) -> None:
        found = self._included(include, self._path)
        if found is None:
            return
        inner, near = found
        pose, relative_to = raw_pose(include if include.find("pose") is not None else inner)
        frame = scope.pose(relative_to or WORLD, line_of(include)) @ pose
        if inner.tag == "light":
            self._links.add_light(inner, self._spec.worldbody, frame)
            return
        name = " ".join(words(include.find("name"))) or str(inner.get("name"))
        self._add_model(inner, near, frame, name, fixed=is_true(include.find("static")))

    def _included(self, include: Element, near: Path) -> tuple[Element, Path] | None:
        """The model or light that an `<include>` names, and its file; None for one that would be downloaded."""
        uri = " ".join(words(include.find("uri")))
        if uri.startswith(("http://", "https://", "fuel://")):
            self._skipped.add(include, near, f"<include> of {uri}")
            return None
        try:
            path = sdf_of_model(self._paths.file(uri, near))
        except ConfigError as error:
            raise ConfigError(f"line {line_of(include)}: <include>: {error}") from error
        for unread in include.iterchildren("plugin"):
            self._skipped.add(unread, near)
        root = _parse(path)
        inner = next(root.iterchildren("model", "light", "actor"), None)
        if inner is None or inner.tag == "actor":
            self._skipped.add(include, near, f"<include> of {uri}, which has no model")
            return None
        return inner, path

    def _add_model(
        self, element: Element, near: Path, frame: Transform, name: str, *, fixed: bool | None = None
    ) -> None:
        model = _Model(self._names.unique(name))
        static = located(near, lambda: self._collect(element, _Place(near), model))
        placement = element.get("placement_frame")
        if placement in model.links:
            frame = frame @ model.links[placement].pose.inverse()
        if fixed or (static and fixed is None):
            body = self._spec.worldbody.add_body(name=model.name, pos=frame.position, quat=quaternion(frame.rotation))
            for link in model.links.values():
                self._links.add(link, body, link.pose, moves=False)
        else:
            self._add_tree(model, frame)

    def _collect(self, element: Element, place: _Place, model: _Model) -> bool:
        """Add the links and joints of a model, with poses in the outermost one; return whether a model is static."""
        near, frame, prefix = place.near, place.frame, place.prefix
        if place.depth > MAX_DEPTH:
            raise ConfigError(f"line {line_of(element)}: more than {MAX_DEPTH} models in each other")
        scope, static = Scope(), is_true(element.find("static")) is True
        nested: list[tuple[Element, Path, str]] = []
        for child in element.iterchildren("link", "frame", "joint", "model", "include"):
            name, inner, file = str(child.get("name")), child, near
            pose, relative_to = raw_pose(child)
            if child.tag == "include":
                found = self._included(child, near)
                if found is None:
                    continue
                inner, file = found
                if file == near or file in place.outer:
                    raise ConfigError(f"line {line_of(child)}: <include>: {file} includes itself")
                name = " ".join(words(child.find("name"))) or str(inner.get("name"))
                if child.find("pose") is None:
                    pose, relative_to = raw_pose(inner)
            if child.tag == "joint":
                relative_to = relative_to or " ".join(words(child.find("child")))
            if child.tag in ("model", "include"):
                nested.append((inner, file, name))
            scope.add(name, pose, relative_to or child.get("attached_to", ""), line_of(child))
        for inner, file, name in nested:
            before = set(model.links)
            inside = frame @ scope.pose(name, line_of(inner))
            deeper = _Place(file, inside, f"{prefix}{name}::", place.depth + 1, place.outer | {near})
            collect = partial(self._collect, inner, deeper, model)
            static = located(file, collect) or static
            for added in set(model.links) - before:
                pose = frame.inverse() @ model.links[added].pose
                scope.add(added.removeprefix(prefix), pose, MODEL, line_of(inner))
        for child in element.iterchildren("*"):
            line = line_of(child)
            match child.tag:
                case "link":
                    self._count(child)
                    name = f"{prefix}{child.get('name')}"
                    pose = frame @ scope.pose(str(child.get("name")), line)
                    model.links.setdefault(name, SdfLink(name, child, pose, near))
                case "joint":
                    self._collect_joint(child, scope, place, model)
                case "frame" | "model" | "include":
                    pass
                case _:
                    self._skipped.add(child, near)
        return static

    def _collect_joint(self, joint: Element, scope: Scope, place: _Place, model: _Model) -> None:
        frame, prefix = place.frame, place.prefix
        parent, child = (" ".join(words(joint.find(tag))) for tag in ("parent", "child"))
        pose = frame @ scope.pose(str(joint.get("name")), line_of(joint))
        xyz = joint.find("axis/xyz")
        axis = (0.0, 0.0, 1.0) if xyz is None else floats(xyz, 3)
        expressed_in = "" if xyz is None else xyz.get("expressed_in", "")
        if _version(joint) < 1.5 or is_true(joint.find("axis/use_parent_model_frame")):
            expressed_in = MODEL
        turn = frame @ scope.pose(expressed_in, line_of(joint)) if expressed_in else pose
        x, y, z = turn.rotate((axis[0], axis[1], axis[2]))
        name = f"{prefix}{joint.get('name')}"
        outer = WORLD if parent == WORLD else f"{prefix}{parent}"
        model.joints.append(
            _Joint(name, element=joint, parent=outer, child=f"{prefix}{child}", pose=pose, axis=(x, y, z))
        )

    def _add_tree(self, model: _Model, frame: Transform) -> None:
        """Add the links of a model that moves: those that no joint carries are free."""
        carried: dict[str, _Joint] = {}
        for joint in model.joints:
            for end in (joint.parent, joint.child):
                if end not in model.links and end != WORLD:
                    raise ConfigError(
                        f"{self._path}: line {line_of(joint.element)}: joint {joint.name!r} names the link {end!r}, "
                        f"which is not there"
                    )
            if joint.child in carried or joint.child == WORLD:
                self._skipped.add(joint.element, self._path, "<joint> that closes a loop")
            else:
                carried[joint.child] = joint
        below: dict[str, list[_Joint]] = {}
        for joint in carried.values():
            below.setdefault(joint.parent, []).append(joint)
        roots = [link for name, link in model.links.items() if name not in carried]
        if not roots and not below.get(WORLD):
            raise ConfigError(f"{self._path}: the joints of model {model.name!r} form a loop")
        for link in roots:
            body = self._body(self._spec.worldbody, f"{model.name}/{link.name}", frame @ link.pose)
            body.add_freejoint()
            self._add_branch(model, link, body, below)
        for joint in below.get(WORLD, []):
            link = model.links[joint.child]
            body = self._body(self._spec.worldbody, f"{model.name}/{link.name}", frame @ link.pose)
            self._add_joint(model, joint, link, body)
            self._add_branch(model, link, body, below, moves=_moves(joint))

    def _add_branch(
        self, model: _Model, link: SdfLink, body: mujoco.MjsBody, below: dict[str, list[_Joint]], *, moves: bool = True
    ) -> None:
        pending = [(link, body, moves)]
        while pending:
            link, body, moves = pending.pop()
            self._links.add(link, body, Transform(), moves=moves)
            for joint in below.get(link.name, []):
                child = model.links[joint.child]
                inner = self._body(body, f"{model.name}/{child.name}", link.pose.inverse() @ child.pose)
                self._add_joint(model, joint, child, inner)
                pending.append((child, inner, moves or _moves(joint)))

    def _add_joint(self, model: _Model, joint: _Joint, child: SdfLink, body: mujoco.MjsBody) -> None:
        kind = joint.element.get("type", "")
        if kind == "fixed":
            return
        if kind not in (*HINGES, "prismatic", "ball"):
            self._skipped.add(joint.element, self._path, f'<joint type="{kind}">, taken as fixed')
            return
        inward = child.pose.inverse()
        types = mujoco.mjtJoint
        added = body.add_joint(
            name=self._names.unique(f"{model.name}/{joint.name}"),
            pos=(inward @ joint.pose).position,
            axis=inward.rotate(joint.axis),
            type=types.mjJNT_BALL
            if kind == "ball"
            else types.mjJNT_SLIDE
            if kind == "prismatic"
            else types.mjJNT_HINGE,
        )
        if kind == "ball":
            return

        def number(path: str, default: float) -> float:
            element = joint.element.find(f"axis/{path}")
            return default if element is None else floats(element, 1)[0]

        lower, upper = number("limit/lower", -1e16), number("limit/upper", 1e16)
        if kind != "continuous" and -1e6 < lower < upper < 1e6:
            added.limited, added.range = mujoco.mjtLimited.mjLIMITED_TRUE, (lower, upper)
        damping = max(0.0, number("dynamics/damping", 0.0))
        added.damping = same_shape(added.damping, damping)
        added.frictionloss = max(0.0, number("dynamics/friction", 0.0))
        stiffness = max(0.0, number("dynamics/spring_stiffness", 0.0))
        if stiffness:
            added.stiffness = same_shape(added.stiffness, stiffness)
            added.springref = number("dynamics/spring_reference", 0.0)
        added.armature = 1e-4

    def _body(self, parent: mujoco.MjsBody, name: str, frame: Transform) -> mujoco.MjsBody:
        return parent.add_body(name=self._names.unique(name), pos=frame.position, quat=quaternion(frame.rotation))

    def _count(self, element: Element) -> None:
        self._items += 1
        if self._items > MAX_ITEMS:
            raise ConfigError(f"line {line_of(element)}: the world has more than {MAX_ITEMS} links")


def _parse(path: Path) -> Element:
    try:
        root = etree.fromstring(
            read_file(path), etree.XMLParser(resolve_entities=False, no_network=True, remove_comments=True)
        )
    except etree.XMLSyntaxError as error:
        raise ConfigError(f"{path}:{error.lineno}: is not XML: {error.msg}") from error
    if root.tag not in ("sdf", "gazebo"):
        raise ConfigError(f"{path}:{line_of(root)}: begins with <{root.tag}>, not with <sdf>")
    return root


def _version(element: Element) -> float:
    text = str(element.getroottree().getroot().get("version", "1.7"))
    major, _, minor = text.partition(".")
    return float(f"1.{minor.zfill(2)[:2]}") if major == "1" and minor.isdigit() and len(minor) > 1 else _number(text)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return 1.7


def _moves(joint: _Joint) -> bool:
    return joint.element.get("type") in (*HINGES, "prismatic", "ball")
