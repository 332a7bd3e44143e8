"""Source of enumerations and dataclasses."""

from __future__ import annotations

from jauspy.codec.generator_decode import decode_method
from jauspy.codec.generator_encode import encode_method
from jauspy.codec.generator_fixed import Constants
from jauspy.codec.generator_layout import layout_method
from jauspy.codec.generator_text import annotation, describe, docstring, indent, needs_keywords, quote
from jauspy.codec.plan import ClassPlan, EnumPlan, ModulePlan, SlotPlan
from jauspy.codec.undefined import undefined_bits, undefined_presence


def class_lines(plan: ClassPlan, module: ModulePlan, constants: Constants) -> list[str]:
    """A class with its nested ones, from the decorator on."""
    if plan.same_as:
        lines = [f"class {plan.name}({plan.same_as}):", *indent(docstring(_summary(plan)))]
        return [*lines, "", *indent(["__slots__ = ()", *_place(module), *_report(plan)])]
    base = "rt.Message" if plan.kind == "message" else "rt.Struct"
    keywords = ", kw_only=True" if needs_keywords(plan) else ""
    lines = [f"@dataclass(slots=True, repr=False{keywords})", f"class {plan.name}({base}):"]
    blocks = [docstring(_summary(plan), _details(plan))]
    if plan.kind == "message":
        blocks.append(_constants(plan, module))
    blocks.append([f"{name} = {path}" for name, path in plan.aliases.items()])
    blocks += [_enum(n) if isinstance(n, EnumPlan) else class_lines(n, module, constants) for n in plan.nested]
    blocks.append(_attributes(plan))
    blocks += [layout_method(plan), decode_method(plan, constants), encode_method(plan, constants)]
    for number, block in enumerate(block for block in blocks if block):
        lines += indent([*([""] if number else []), *block])
    return lines


def _summary(plan: ClassPlan) -> str:
    if plan.message is None:
        return plan.doc or f"{plan.name}."
    title = f"{plan.message.name} (0x{plan.message.code:04X})"
    return f"{title}: {plan.doc}" if plan.doc else f"{title}."


def _constants(plan: ClassPlan, module: ModulePlan) -> list[str]:
    assert plan.message is not None
    return [
        f"CODE = 0x{plan.message.code:04X}",
        f"NAME = {quote(plan.message.name)}",
        *_place(module),
        f"IS_COMMAND = {plan.message.is_command}",
        f"IS_QUERY = {plan.is_query}",
        *_report(plan),
    ]


def _report(plan: ClassPlan) -> list[str]:
    return [f"REPORT: ClassVar[type[{plan.answer.name}]]"] if plan.answer else []


def _place(module: ModulePlan) -> list[str]:
    return [f"SERVICE = {quote(module.service)}", f"VERSION = {quote(module.version)}"]


def _enum(plan: EnumPlan) -> list[str]:
    members = [f"{name} = {value}" for name, value in plan.members]
    return [f"class {plan.name}(IntEnum):", *indent(docstring(f"Values of {plan.name}.")), "", *indent(members)]


def _attributes(plan: ClassPlan) -> list[str]:
    match plan.kind:
        case "bits":
            lines = [
                f"{bit.name}: {f'{bit.allowed.enum.path} | int' if bit.allowed.enum else 'int'}" for bit in plan.bits
            ]
            return [*lines, *(["reserved_bits: int = 0"] if undefined_bits(plan) else [])]
        case "choice":
            kinds = sorted({annotation(number) for _, number in plan.choices}, reverse=True)
            choice = f"{plan.allowed.enum.path} | int" if plan.allowed.enum else "int"
            return [f"choice: {choice}", f"value: {' | '.join(kinds)}"]
        case "format":
            choice = f"{plan.allowed.enum.path} | int" if plan.allowed.enum else "int"
            return [f"format: {choice}", f"data: {'rt.Message | bytes' if plan.message_formats else 'bytes'}"]
        case _:
            lines = [_attribute(slot) for slot in plan.slots]
            return [*lines, *(["reserved_presence: int = 0"] if undefined_presence(plan) else [])]


def _attribute(slot: SlotPlan) -> str:
    kind = annotation(slot.item)
    return f"{slot.name}: {kind} | None = None" if slot.optional else f"{slot.name}: {kind}"


def _details(plan: ClassPlan) -> list[str]:
    match plan.kind:
        case "bits":
            rows = [_bit_text(bit.name, bit.shift, bit.mask, bit.doc) for bit in plan.bits]
        case "choice":
            rows = [f"{index}: {number.units}, {describe(number)}".rstrip(", ") for index, number in plan.choices]
        case "format":
            rows = []
        case _:
            rows = [_slot_text(slot) for slot in plan.slots]
    return [row for row in rows if row]


def _bit_text(name: str, shift: int, mask: int, doc: str) -> str:
    last = shift + mask.bit_length() - 1
    where = f"bit {shift}" if last == shift else f"bits {shift}..{last}"
    return f"{name}: {where}{'. ' + doc if doc else ''}"


def _slot_text(slot: SlotPlan) -> str:
    facts = ", ".join(part for part in (describe(slot.item), "optional" if slot.optional else "") if part)
    text = ". ".join(part.rstrip(".") for part in (facts, slot.doc) if part)
    return f"{slot.name}: {text}" if text else ""
