"""Worlds as a TOML list of objects on a ground: a plane, or a height map from an image."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Final, Literal, Self, TypeAlias

import mujoco
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from jauspy.config_errors import explain, line_prefix
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.user_files import confined, own_folder, read_file, read_toml
from jauspy_sim.models.groups import COLLISION
from jauspy_sim.models.mesh_files import read_heights
from jauspy_sim.models.shapes import RGBA, Look, MeshSource, ShapeBuilder, Solid
from jauspy_sim.worlds.lighting import HORIZON, ZENITH, add_floor, add_sky, add_sun

MAX_HEIGHTS: Final = 513
"""Rows and columns of a height map; larger ones are made smaller."""

Number: TypeAlias = Annotated[float, Field(ge=-10_000.0, le=10_000.0, allow_inf_nan=False)]
Length: TypeAlias = Annotated[float, Field(gt=0.0, le=10_000.0, allow_inf_nan=False)]
Fraction: TypeAlias = Annotated[float, Field(ge=0.0, le=1.0)]
Colour: TypeAlias = Annotated[tuple[Fraction, ...], Field(min_length=3, max_length=4)]
"""Red, green, blue, and alpha if it is not 1."""


def _check_pose(numbers: tuple[float, ...]) -> tuple[float, ...]:
    if len(numbers) not in (3, 6):
        raise ValueError("write x, y, z in metres, or these and roll, pitch, yaw in degrees")
    return numbers


PoseNumbers: TypeAlias = Annotated[tuple[Number, ...], AfterValidator(_check_pose)]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class GroundConfig(_Table):
    """The ground: a plane, or a height map in whose middle robots start."""

    height_map: str | None = None
    """An image: black is low, white is `height` above it."""
    size: tuple[Length, Length] = (50.0, 50.0)
    """Metres along x and y; a plane is endless, and this is its visible part."""
    height: Length = 1.0
    """Metres from black to white."""
    colour: Colour | None = None
    texture: str | None = None
    texture_size: Length = 2.0
    """Metres after which the texture repeats."""
    friction: Annotated[float, Field(ge=0.0, le=5.0)] = 1.0


class SunConfig(_Table):
    """The sun, in degrees: above the horizon, and from x towards y."""

    elevation: Annotated[float, Field(ge=1.0, le=90.0)] = 60.0
    azimuth: Annotated[float, Field(ge=-360.0, le=360.0)] = 30.0
    brightness: Fraction = 0.7
    shadows: bool = True


class SkyConfig(_Table):
    """The colours of the sky."""

    zenith: Annotated[tuple[Fraction, ...], Field(min_length=3, max_length=3)] = ZENITH
    horizon: Annotated[tuple[Fraction, ...], Field(min_length=3, max_length=3)] = HORIZON


class ObjectConfig(_Table):
    """An object: a primitive or a mesh, fixed or free."""

    name: Annotated[str, Field(min_length=1, max_length=64)]
    shape: Literal["box", "sphere", "cylinder", "capsule", "ellipsoid", "mesh"]
    pose: PoseNumbers = (0.0, 0.0, 0.0)
    """The pose of its middle, or of the origin of a mesh: metres, and fixed-axis roll, pitch, yaw in degrees."""
    size: Annotated[tuple[Length, ...], Field(max_length=3)] = ()
    """Metres of a box along x, y, z; of an ellipsoid, its three axes."""
    radius: Length | None = None
    length: Length | None = None
    """Length of a cylinder along z; of a capsule, without its ends."""
    file: str | None = None
    """File of a mesh."""
    scale: Length | tuple[Length, Length, Length] = 1.0
    mass: Annotated[float, Field(gt=0.0, le=1e6)] | None = None
    """Kilograms; an object without a mass does not move."""
    friction: Annotated[float, Field(ge=0.0, le=5.0)] = 1.0
    colour: Colour | None = None
    texture: str | None = None

    @model_validator(mode="after")
    def _check_shape(self) -> Self:
        needs = {
            "box": ("size",),
            "ellipsoid": ("size",),
            "sphere": ("radius",),
            "cylinder": ("radius", "length"),
            "capsule": ("radius", "length"),
            "mesh": ("file",),
        }[self.shape]
        for key in ("size", "radius", "length", "file"):
            given = getattr(self, key) not in (None, ())
            if given != (key in needs):
                raise ValueError(f"{key}: a {self.shape} {'needs' if key in needs else 'has no'} {key}")
        if "size" in needs and len(self.size) != 3:
            raise ValueError("size: write three lengths, along x, y and z")
        return self


class WorldConfig(_Table):
    """The file."""

    ground: GroundConfig = GroundConfig()
    sun: SunConfig = SunConfig()
    sky: SkyConfig = SkyConfig()
    objects: Annotated[tuple[ObjectConfig, ...], Field(max_length=5000)] = ()

    @model_validator(mode="after")
    def _check_names(self) -> Self:
        names = [item.name for item in self.objects]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"objects: {', '.join(twice)} is there twice; give each its own name")
        return self


def objects_world(path: Path) -> mujoco.MjSpec:
    """The world of a TOML file. Raises `ConfigError` with file and key."""
    try:
        config = WorldConfig.model_validate(read_toml(path))
    except ValidationError as error:
        text = read_file(path).decode()
        problems = "; ".join(
            line_prefix(text, problem["loc"]) + explain(problem, WorldConfig)
            for problem in error.errors(include_url=False)
        )
        raise ConfigError(f"{path}: {problems}") from error
    return _Builder(path, config).build()


class _Builder:
    def __init__(self, path: Path, config: WorldConfig) -> None:
        self._path, self._config = path, config
        self._spec = mujoco.MjSpec()
        self._spec.compiler.degree = False
        self._seen = ShapeBuilder(self._spec, visual=0, collision=0)
        self._hidden = ShapeBuilder(self._spec, visual=0, collision=COLLISION, prefix="hidden/")

    def build(self) -> mujoco.MjSpec:
        sky, sun = self._config.sky, self._config.sun
        add_sky(self._spec, _three(sky.zenith), _three(sky.horizon))
        add_sun(self._spec, sun.elevation, sun.azimuth, sun.brightness, shadows=sun.shadows)
        self._at("ground", self._add_ground)
        for number, item in enumerate(self._config.objects):
            self._at(f"objects[{number}]", lambda item=item: self._add(item))  # type: ignore[misc]
        return self._spec

    def _at(self, key: str, add: Callable[[], None]) -> None:
        try:
            add()
        except ConfigError as error:
            raise ConfigError(f"{self._path}: {key}: {error}") from error

    def _add_ground(self) -> None:
        ground = self._config.ground
        repeat = (1.0 / ground.texture_size,) * 2
        look = Look(_rgba(ground.colour), self._file(ground.texture), repeat)
        plain = ground.colour is None and ground.texture is None
        if ground.height_map is None:
            if plain:
                geom = add_floor(self._spec)
            else:
                geom = self._spec.worldbody.add_geom(
                    name="floor",
                    type=mujoco.mjtGeom.mjGEOM_PLANE,
                    size=(0.0, 0.0, 0.1),
                    material=self._seen.material(look),
                )
            geom.friction = (ground.friction, *geom.friction[1:])
            return
        heights = read_heights(self._named(ground.height_map), MAX_HEIGHTS)
        rows, columns = heights.shape
        middle = float(heights[(rows - 1) // 2 : rows // 2 + 1, (columns - 1) // 2 : columns // 2 + 1].mean())
        pose = Transform(position=(0.0, 0.0, -ground.height * middle))
        size = (*ground.size, ground.height)
        if plain:
            look = Look((0.45, 0.42, 0.36, 1.0))
        geom = self._seen.height_field(self._spec.worldbody, heights, size, pose, look)
        geom.friction = (ground.friction, *geom.friction[1:])

    def _add(self, item: ObjectConfig) -> None:
        frame = _transform(item.pose)
        body = self._spec.worldbody.add_body(name=item.name, pos=frame.position, quat=quaternion(frame.rotation))
        look = Look(_rgba(item.colour), self._file(item.texture))
        solid = Solid(item.friction, mass=item.mass or 0.0)
        if item.mass is not None:
            body.add_freejoint()
        if item.shape == "mesh":
            scale = (item.scale,) * 3 if isinstance(item.scale, float) else item.scale
            source = MeshSource(self._named(item.file or ""), scale)
            self._hidden.draw_mesh(body, source, Transform(), look)
            if item.mass is None:
                self._hidden.collide_surface(body, source, Transform(), solid)
            else:
                self._hidden.collide_mesh(body, source, Transform(), solid)
            return
        kinds = mujoco.mjtGeom
        radius, half = item.radius or 0.0, (item.length or 0.0) / 2.0
        kind, size = {
            "box": (kinds.mjGEOM_BOX, [length / 2.0 for length in item.size]),
            "ellipsoid": (kinds.mjGEOM_ELLIPSOID, [length / 2.0 for length in item.size]),
            "sphere": (kinds.mjGEOM_SPHERE, [radius]),
            "cylinder": (kinds.mjGEOM_CYLINDER, [radius, half]),
            "capsule": (kinds.mjGEOM_CAPSULE, [radius, half]),
        }[item.shape]
        geom = self._seen.collide(body, kind, size, Transform(), solid)
        self._seen.paint(geom, look)

    def _file(self, name: str | None) -> Path | None:
        return None if name is None else self._named(name)

    def _named(self, name: str) -> Path:
        return confined(self._path.parent / name, (own_folder(self._path),))


def _three(numbers: tuple[float, ...]) -> tuple[float, float, float]:
    red, green, blue = numbers
    return red, green, blue


def _rgba(colour: tuple[float, ...] | None) -> RGBA | None:
    if colour is None:
        return None
    red, green, blue, alpha = (*colour, 1.0)[:4]
    return red, green, blue, alpha


def _transform(numbers: tuple[float, ...]) -> Transform:
    x, y, z, *angles = (*numbers, 0.0, 0.0, 0.0)[:6]
    return Transform.from_pose(Pose(x, y, z, *map(math.radians, angles)))
