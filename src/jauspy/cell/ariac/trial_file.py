"""Files of trials: orders, changes of orders, and challenges. Keys have the names of ARIAC's, where it has them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Final, Self

from annotated_types import Interval, MaxLen, MinLen
from pydantic import BaseModel, ConfigDict, ValidationError, model_validator

from jauspy.config_errors import explain, line_prefix
from jauspy.errors import ConfigError
from jauspy.platform.modular.parts import CellSetup, PartKind
from jauspy.platform.tables import Identifier, Name, Table, check_unique
from jauspy.user_files import parse_toml, read_file

MAX_SIZE: Final = 100_000
"""Bytes of a file."""
MAX_ENTRIES: Final = 20
"""Orders, changes, and challenges of each kind."""
MAX_TIME: Final = 3600.0
MAX_PROBLEMS: Final = 5
"""Mistakes of a file that an error names."""
TRAYS: Final = (1, 2)
QUADRANTS: Final = (1, 2, 3, 4)
SHIPPED: Final = files("jauspy.cell.ariac") / "trials"

Tray = Annotated[int, Interval(ge=1, le=2)]
Seconds = Annotated[float, Interval(ge=0.0, le=MAX_TIME)]


@dataclass(frozen=True, slots=True)
class Product(Table):
    """A part that an order wants in a quadrant of its tray."""

    type: Identifier
    quadrant: Annotated[int, Interval(ge=1, le=4)]


@dataclass(frozen=True, slots=True)
class PartPlaced(Table):
    """The moment when a part of a type lies on a tray."""

    type: Identifier
    tray: Tray


@dataclass(frozen=True, slots=True)
class Condition(Table):
    """When something happens: one of a time, a part that is placed, and an order that is submitted."""

    time_condition: Seconds | None = None
    """Seconds from the start of the trial."""
    part_place_condition: PartPlaced | None = None
    submission_condition: Identifier | None = None
    """The id of an order."""

    def __post_init__(self) -> None:
        given = (self.time_condition, self.part_place_condition, self.submission_condition)
        if sum(value is not None for value in given) != 1:
            raise ValueError(
                "time_condition: give one of time_condition, part_place_condition and submission_condition"
            )


AT_ONCE: Final = Condition(time_condition=0.0)


@dataclass(frozen=True, slots=True)
class Order(Table):
    """An order: products for a tray."""

    id: Identifier
    tray: Tray
    products: Annotated[tuple[Product, ...], MinLen(1), MaxLen(4)]
    announcement: Condition = AT_ONCE
    priority: bool = False
    """True for an order that is to be submitted before all others that are not."""

    def __post_init__(self) -> None:
        check_unique("products", tuple(f"quadrant {product.quadrant}" for product in self.products))


@dataclass(frozen=True, slots=True)
class OrderChange(Table):
    """Other products for an order that may be worked on."""

    order: Identifier
    when: Condition
    products: Annotated[tuple[Product, ...], MinLen(1), MaxLen(4)]

    def __post_init__(self) -> None:
        check_unique("products", tuple(f"quadrant {product.quadrant}" for product in self.products))


@dataclass(frozen=True, slots=True)
class DroppedPart(Table):
    """The gripper vents `delay` seconds after it has picked a part of a type for the nth time."""

    type: Identifier
    drop_after: Annotated[int, Interval(ge=0, le=100)] = 0
    """Number of picks of this type before that."""
    delay: Annotated[float, Interval(ge=0.1, le=60.0)] = 1.0


@dataclass(frozen=True, slots=True)
class SensorBlackout(Table):
    """The part sensor observes nothing for a while."""

    when: Condition
    duration: Annotated[float, Interval(gt=0.0, le=MAX_TIME)]


@dataclass(frozen=True, slots=True)
class BeltSpeed(Table):
    """A speed of the belt, in m/s, from a moment on."""

    when: Condition
    speed: Annotated[float, Interval(ge=0.0, le=0.2)]


class Trial(BaseModel):
    """A trial; `load` reads one."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: Name
    time_limit: Annotated[float, Interval(gt=0.0, le=MAX_TIME)] = 300.0
    """Seconds after which nothing counts any more."""
    attainable_points: Annotated[int, Interval(ge=0, le=1000)] | None = None
    """Points that can be had, in a trial whose parts do not suffice for all."""
    orders: Annotated[tuple[Order, ...], MinLen(1), MaxLen(MAX_ENTRIES)]
    changes: Annotated[tuple[OrderChange, ...], MaxLen(MAX_ENTRIES)] = ()
    flipped_parts: Annotated[tuple[Identifier, ...], MaxLen(MAX_ENTRIES)] = ()
    """Parts that lie upside down in their bins."""
    faulty_parts: Annotated[tuple[Identifier, ...], MaxLen(MAX_ENTRIES)] = ()
    """Servo modules whose gear has seized."""
    missing_parts: Annotated[tuple[Identifier, ...], MaxLen(MAX_ENTRIES)] = ()
    """Parts that are not there."""
    dropped_parts: Annotated[tuple[DroppedPart, ...], MaxLen(MAX_ENTRIES)] = ()
    sensor_blackouts: Annotated[tuple[SensorBlackout, ...], MaxLen(MAX_ENTRIES)] = ()
    belt_speeds: Annotated[tuple[BeltSpeed, ...], MaxLen(MAX_ENTRIES)] = ()
    """Speeds of the belt that brings the boxes; without any, they lie still in reach."""

    @model_validator(mode="after")
    def _check(self) -> Self:
        ids = tuple(order.id for order in self.orders)
        check_unique("orders", ids)
        for key, condition in self.conditions():
            named = condition.submission_condition
            if named is not None and named not in ids:
                raise ValueError(f"{key}: there is no order {named!r}; there are: {', '.join(ids)}")
        for number, change in enumerate(self.changes):
            if change.order not in ids:
                raise ValueError(f"changes[{number}].order: no order {change.order!r}; there are: {', '.join(ids)}")
        if not any(order.announcement.time_condition is not None for order in self.orders):
            raise ValueError("orders: one needs an announcement at a time, or the trial never begins")
        return self

    def conditions(self) -> Iterable[tuple[str, Condition]]:
        """All conditions, each with its key."""
        yield from ((f"orders[{n}].announcement", order.announcement) for n, order in enumerate(self.orders))
        for name in ("changes", "sensor_blackouts", "belt_speeds"):
            yield from ((f"{name}[{n}].when", entry.when) for n, entry in enumerate(getattr(self, name)))

    @property
    def challenges(self) -> tuple[str, ...]:
        """Names of the challenges that the trial has."""
        found = {
            "priority order": any(order.priority for order in self.orders),
            "order change": self.changes,
            "flipped parts": self.flipped_parts,
            "faulty parts": self.faulty_parts,
            "insufficient parts": self.missing_parts,
            "dropped parts": self.dropped_parts,
            "sensor blackout": self.sensor_blackouts,
            "moving belt": self.belt_speeds,
        }
        return tuple(name for name, there in found.items() if there)


def names() -> list[str]:
    """The trials that come with jauspy, in the order in which they are run."""
    return sorted(file.name.removesuffix(".toml") for file in SHIPPED.iterdir() if file.name.endswith(".toml"))


def shipped(name: str) -> Path:
    """The file of a trial that comes with jauspy. Raises `ConfigError` with their names."""
    if name not in names():
        raise ConfigError(f"there is no trial {name!r}; there are: {', '.join(names())}; or give a file")
    return Path(str(SHIPPED / f"{name}.toml"))


def load(name_or_path: str) -> Trial:
    """A trial by its name or from a TOML file. Raises `ConfigError` with file, line and key of a mistake."""
    path = Path(name_or_path)
    if not (path.suffix or "/" in name_or_path):
        path = shipped(name_or_path)
    text = read_file(path, MAX_SIZE).decode("utf-8", "replace")
    data = parse_toml(text.encode(), str(path))
    try:
        return Trial.model_validate(data)
    except ValidationError as error:
        problems = "; ".join(
            f"{line_prefix(text, problem['loc'])}{explain(problem, Trial)}"
            for problem in error.errors(include_url=False)[:MAX_PROBLEMS]
        )
        raise ConfigError(f"{path}: is not a trial: {problems}") from error


def check(trial: Trial, cell: CellSetup) -> None:
    """Raise `ConfigError` with the key of a part or type that the cell does not have, or that cannot fail so."""
    wanted = [(f"orders[{n}].products", order.products) for n, order in enumerate(trial.orders)]
    wanted += [(f"changes[{n}].products", change.products) for n, change in enumerate(trial.changes)]
    for key, products in wanted:
        for number, product in enumerate(products):
            _check_type(f"{key}[{number}].type", product.type, cell)
    for number, dropped in enumerate(trial.dropped_parts):
        _check_type(f"dropped_parts[{number}].type", dropped.type, cell)
    for key, condition in trial.conditions():
        if condition.part_place_condition is not None:
            _check_type(f"{key}.part_place_condition.type", condition.part_place_condition.type, cell)
    fit = {
        "missing_parts": [part.name for part in cell.parts if not part.fixed],
        "flipped_parts": [part.name for part in cell.parts if cell.types[part.type].further_grasps],
        "faulty_parts": [part.name for part in cell.parts if cell.types[part.type].kind is PartKind.SERVO],
    }
    for key, permitted in fit.items():
        parts: Sequence[str] = getattr(trial, key)
        for number, part in enumerate(parts):
            if part not in permitted:
                raise ConfigError(f"{key}[{number}] = {part!r}: not such a part; there are: {', '.join(permitted)}")
    if trial.belt_speeds and cell.conveyor is None:
        raise ConfigError("belt_speeds: the cell has no conveyor")


def _check_type(key: str, type: str, cell: CellSetup) -> None:
    known = sorted({part.type for part in cell.parts if cell.types[part.type].kind is not PartKind.BASE})
    if type not in known:
        raise ConfigError(f"{key} = {type!r}: no part has this type; there are: {', '.join(known)}")
