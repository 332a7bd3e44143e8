"""What the generator writes: the model with Python names decided and structurally equal composites shared.

An owner is a class at module level: a message, or a composite of a declared type set. Composites and enumerations
inside an owner become its nested classes, flat, with names that are unique in it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from jauspy.codec.items_numbers import Intervals
from jauspy.codec.scaling import Scaling
from jauspy.schema.model import Count, Message


@dataclass(frozen=True, slots=True)
class EnumPlan:
    """An `IntEnum`."""

    name: str
    path: str
    members: tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class Allowed:
    """A value set: the enumeration and the intervals beside it; both empty when everything is allowed."""

    enum: EnumPlan | None = None
    intervals: Intervals = ()

    @property
    def anything(self) -> bool:
        """True when there is nothing to check."""
        return not self.enum and not self.intervals


@dataclass(frozen=True, slots=True)
class NumberPlan:
    """An integer or float; a real when `scaling` is set."""

    code: str
    units: str
    scaling: Scaling | None = None
    allowed: Allowed = Allowed()


@dataclass(frozen=True, slots=True)
class TextPlan:
    """A string of fixed length, or counted."""

    length: int = 0
    count: Count | None = None


@dataclass(frozen=True, slots=True)
class BlobPlan:
    """Counted bytes, perhaps a message."""

    count: Count
    is_message: bool
    format: str


@dataclass(frozen=True, slots=True)
class ObjectPlan:
    """An instance of a class of the plan."""

    cls: ClassPlan


@dataclass(frozen=True, slots=True)
class RepeatPlan:
    """A counted list."""

    count: Count
    item: ItemPlan


@dataclass(frozen=True, slots=True)
class UnionPlan:
    """A tag and one of several classes."""

    code: str
    arms: tuple[ClassPlan, ...]
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class GridPlan:
    """An array."""

    item: ItemPlan
    sizes: tuple[int, ...]


ItemPlan: TypeAlias = NumberPlan | TextPlan | BlobPlan | ObjectPlan | RepeatPlan | UnionPlan | GridPlan


@dataclass(frozen=True, slots=True)
class SlotPlan:
    """An attribute."""

    name: str
    jaus: str
    item: ItemPlan
    optional: bool = False
    doc: str = ""


@dataclass(frozen=True, slots=True)
class BitPlan:
    """A sub-field of a bit field."""

    name: str
    shift: int
    mask: int
    allowed: Allowed
    doc: str = ""


@dataclass(eq=False, slots=True)
class ClassPlan:
    """A class to write. Which of the last fields count depends on `kind`.

    `called` says that its `_read` and `_write` are used; what is of one form only is read and written in place.
    `answer` is the report on a query. `same_as` is a message of another module that has the same body. `loops` are
    those that its code has one inside the other where it is read and written in place.
    """

    kind: Literal["message", "composite", "bits", "choice", "format"]
    name: str
    path: str
    doc: str = ""
    slots: tuple[SlotPlan, ...] = ()
    presence: str | None = None
    code: str = "B"
    bits: tuple[BitPlan, ...] = ()
    choices: tuple[tuple[int, NumberPlan], ...] = ()
    allowed: Allowed = Allowed()
    count: Count | None = None
    message_formats: tuple[int, ...] = ()
    nested: list[EnumPlan | ClassPlan] = field(default_factory=list)
    message: Message | None = None
    is_query: bool = False
    answer: ClassPlan | None = None
    aliases: dict[str, str] = field(default_factory=dict)
    called: bool = False
    same_as: str | None = None
    loops: int = 0


@dataclass(eq=False, slots=True)
class ModulePlan:
    """A Python module: its dotted name below `jauspy.messages`, and its classes."""

    name: str
    doc: str
    service: str = ""
    version: str = ""
    classes: list[ClassPlan] = field(default_factory=list)
