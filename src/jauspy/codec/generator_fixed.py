"""What straight-line code knows about items of fixed size: their `struct` codes, and the module constants they need."""

from __future__ import annotations

import math

from jauspy.codec.generator_layout import scaling
from jauspy.codec.generator_text import quote, tuple_of
from jauspy.codec.plan import Allowed, ClassPlan, EnumPlan, ItemPlan, NumberPlan, ObjectPlan, SlotPlan, TextPlan
from jauspy.codec.scaling import Scaling
from jauspy.codec.wire import FLOATS, SIZES, compact, limits


class Constants:
    """The constants of one module, by name, in the order of their first use."""

    def __init__(self) -> None:
        self._sources: dict[str, str] = {}
        self._names: dict[str, str] = {}
        self._types: dict[str, str] = {}

    def lines(self) -> list[str]:
        """The assignments; they stand after all classes."""
        return [f"{name}{self._types.get(name, '')} = {source}" for name, source in self._sources.items()]

    def _add(self, name: str, source: str, kind: str = "") -> str:
        if source not in self._names:
            while name in self._sources:
                name += "_"
            self._names[source] = name
            self._sources[name] = source
            if kind:
                self._types[name] = f": {kind}"
        return self._names[source]

    def packer(self, codes: str) -> str:
        """A `struct.Struct`."""
        short = compact(codes)
        return self._add(f"_S_{short}", f"rt.Packer({quote('<' + short)})")

    def members(self, enum: EnumPlan) -> str:
        """A map of values to members."""
        return self._add(f"_E_{'_'.join(enum.path.split('.')[-2:])}", f"rt.members({enum.path})")

    def arms(self, paths: list[str]) -> str:
        """The classes of a variant in the order of their tags."""
        kinds = " | ".join(f"type[{path}]" for path in dict.fromkeys(paths))
        return self._add(f"_U_{len(self._sources)}", tuple_of(paths), f"tuple[{kinds}, ...]")

    def tags(self, paths: list[str]) -> str:
        """The inverse of `arms`."""
        rows = ", ".join(f"{path}: {tag}" for tag, path in enumerate(paths))
        return self._add(f"_T_{len(self._sources)}", f"{{{rows}}}", "dict[type[rt.Struct], int]")

    def scaling(self, scale: Scaling) -> str:
        """A scale range."""
        return self._add(f"_R_{len(self._sources)}", scaling(scale))

    def masks(self, path: str, head: str, codes: list[tuple[int, str]]) -> str:
        """The packers of a run of optional fields."""
        rows = tuple_of(f"({bit}, {quote(code)})" for bit, code in codes)
        return self._add(f"_M_{'_'.join(path.split('.')[-2:])}", f"rt.Masks({quote(head)}, {rows})")


def fixed_codes(item: ItemPlan) -> list[str] | None:
    """The `struct` codes of an item of fixed size, `None` for others."""
    match item:
        case NumberPlan():
            return [item.code]
        case TextPlan(count=None):
            return [f"{item.length}s"] if item.length else None
        case ObjectPlan():
            return class_codes(item.cls)
        case _:
            return None


def class_codes(plan: ClassPlan) -> list[str] | None:
    """The same for a class."""
    if plan.kind == "bits":
        return [plan.code]
    if plan.kind not in ("composite", "message") or plan.presence:
        return None
    codes: list[str] = []
    for slot in plan.slots:
        found = fixed_codes(slot.item)
        if found is None:
            return None
        codes += found
    return codes


def code_size(code: str) -> int:
    """Bytes of one code."""
    return int(code[:-1]) if code[0].isdigit() else SIZES[code]


def size_of(codes: list[str]) -> int:
    """Bytes of several."""
    return sum(map(code_size, codes))


def covers(allowed: Allowed, low: float, high: float) -> bool:
    """True when every value from `low` to `high` is allowed."""
    if allowed.anything:
        return True
    named = [(value, value) for _, value in allowed.enum.members] if allowed.enum else []
    reached = low - 1
    for start, end in sorted([*named, *allowed.intervals]):
        if start > reached + 1:
            return False
        reached = max(reached, end)
    return reached >= high


def outside(allowed: Allowed, name: str, constants: Constants, low: float = -math.inf, high: float = math.inf) -> str:
    """A condition that is true when `name`, known to be within `low`..`high`, is not allowed."""
    parts = [f"{name} not in {constants.members(allowed.enum)}"] if allowed.enum else []
    for start, end in allowed.intervals:
        if start <= low or end >= high:
            parts.append(f"{name} > {end!r}" if start <= low else f"{name} < {start!r}")
        else:
            parts.append(f"not {start!r} <= {name} <= {end!r}")
    return " and ".join(parts)


def free(number: NumberPlan) -> bool:
    """True when any raw value may stand there."""
    if number.code in FLOATS:
        return False
    if number.scaling:
        return number.code.isupper()
    return covers(number.allowed, *limits(number.code))


def runs(slots: tuple[SlotPlan, ...]) -> list[list[SlotPlan]]:
    """Neighbours of fixed size together, each other slot alone; optional composites stay alone, too."""
    made: list[list[SlotPlan]] = []
    fixed_before = False
    for slot in slots:
        codes = fixed_codes(slot.item)
        fixed = codes is not None and (not slot.optional or len(codes) == 1)
        if fixed and fixed_before:
            made[-1].append(slot)
        else:
            made.append([slot])
        fixed_before = fixed
    return made


def is_fixed_run(run: list[SlotPlan]) -> bool:
    """True for the fixed runs of `runs`."""
    codes = fixed_codes(run[0].item)
    return codes is not None and (not run[0].optional or len(codes) == 1)


def bits_by_name(plan: ClassPlan) -> dict[str, int]:
    """The presence bit of each optional slot; 0 when the vector has none left for it."""
    highest = limits(plan.presence)[1] if plan.presence else 0
    optional = [slot.name for slot in plan.slots if slot.optional]
    return {name: 1 << number if 1 << number <= highest else 0 for number, name in enumerate(optional)}
