"""Filters of messages by their addresses, headers and decoded fields: `src == 42.* and msg == SetWrenchEffort`."""

from __future__ import annotations

import fnmatch
import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass
from difflib import get_close_matches
from enum import Enum
from functools import cache, lru_cache
from importlib import import_module
from typing import Any, Final, TypeAlias

from lark import Lark, Token, Transformer, UnexpectedInput, UnexpectedToken, v_args
from lark.exceptions import VisitError

from jauspy.capture.dissect import Part
from jauspy.codec.field_paths import leaves, path_pattern, without_numbers
from jauspy.codec.message import Message, Struct
from jauspy.codec.registry import Registry
from jauspy.codec.rounding import rounded
from jauspy.errors import ConfigError
from jauspy.printable import printable

Predicate: TypeAlias = Callable[[Part], bool]
Value: TypeAlias = float | str

MAX_LENGTH: Final = 2000
"""Characters of a filter."""
MAX_DEPTH: Final = 50
"""Pairs of parentheses and `not` around a comparison."""

GRAMMAR: Final = r"""
?start: or_test
?or_test: and_test (_OR and_test)*
?and_test: not_test (_AND not_test)*
?not_test: _NOT not_test -> negation
    | "(" or_test ")"
    | NAME COMPARISON value -> comparison
    | NAME _IN "(" value ("," value)* ")" -> member
    | NAME -> present
?value: NUMBER | STRING | WORD | NAME
_OR.3: /or\b/i | "||"
_AND.3: /and\b/i | "&&"
_NOT.3: /not\b/i | "!"
_IN.3: /in\b/i
COMPARISON: "==" | "!=" | "<=" | ">=" | "<" | ">" | "contains"
STRING: /"[^"]*"/ | /'[^']*'/
NUMBER.2: /[-+]?(0x[0-9a-f]+|[0-9a-f]+h|(\d+\.?\d*|\.\d+)(e[-+]?\d+)?)(?![\w.*:?])/i
NAME.1: /[a-z_]\w*(\[\d+\])*(\.[a-z_]\w*(\[\d+\])*)*(?![\w*:?.\[])/i
WORD: /[\w*?:][\w.*?:\-]*/
%ignore /\s+/
"""

HEADER: Final[dict[str, tuple[str, Callable[[Part], Value | None]]]] = {
    "src": ("id of the sender", lambda part: str(part.packet.source)),
    "dst": ("id of the receiver, or of many", lambda part: str(part.packet.destination)),
    "msg": ("name of the message", lambda part: None if part.content.message is None else part.content.message.NAME),
    "code": ("id of the message, as 0x4402 or 4402h", lambda part: part.content.code),
    "service": (
        "URN of the service, or its last part",
        lambda part: None if part.content.message is None else part.content.message.SERVICE,
    ),
    "version": (
        "version of the service",
        lambda part: None if part.content.message is None else part.content.message.VERSION,
    ),
    "seq": ("sequence number", lambda part: part.packet.sequence),
    "size": ("bytes of the message", lambda part: len(part.content.payload)),
    "priority": ("LOW, STANDARD, HIGH or SAFETY_CRITICAL", lambda part: part.packet.priority.name),
    "broadcast": ("NONE, LOCAL or GLOBAL", lambda part: part.packet.broadcast.name),
    "ack": ("acknowledgement: NONE, REQUESTED or ACK", lambda part: part.packet.ack.name),
    "data_flag": ("SINGLE, or the place of a fragment", lambda part: part.packet.data_flag.name),
    "deviation": ("deviations from the definition", lambda part: "; ".join(part.content.deviations) or None),
    "problem": ("why it could not be decoded", lambda part: part.content.problem or None),
}
"""What a filter can compare besides the fields of messages: a description, and its value; None if there is none."""

ORDERS: Final[dict[str, Callable[[float, float], bool]]] = {
    "<": lambda value, limit: value < limit,
    "<=": lambda value, limit: value <= limit,
    ">": lambda value, limit: value > limit,
    ">=": lambda value, limit: value >= limit,
}
_NAMES_OF_IDS: Final = ("src", "dst")


class Filter:
    """A predicate over the parts of dissected datagrams, made from text.

    A comparison is true if any value of its name fits; `!=` is true if there is a value and none fits. Fields are found
    at any depth, by their names or the last parts of their paths (`time_stamp.hour`, `node_list[0].node_rec.node_id`);
    a list without a number stands for all its elements. Text is compared without regard to case, with `*` and `?` as
    wildcards; numbers are in SI units and radians, rounded as `decode` prints them.

    Raises:
        ConfigError: the text is no filter, or names something that no message has; it points at the character.
    """

    def __init__(self, text: str, registry: Registry) -> None:
        self.text = text
        if not text.strip():
            raise ConfigError("the filter is empty; an example: src == 42.* and msg == SetWrenchEffort")
        if len(text) > MAX_LENGTH:
            raise ConfigError(f"the filter has {len(text)} characters, {MAX_LENGTH} is the limit")
        if text.count("(") + len(re.findall(r"\bnot\b|!(?!=)", text)) > MAX_DEPTH:
            raise ConfigError(f"the filter has more than {MAX_DEPTH} parentheses and negations")
        try:
            tree = _PARSER.parse(text)
            self._predicate: Predicate = _Compiler(registry).transform(tree)
        except UnexpectedInput as error:
            raise _wrong(text, _position(error, text), _expectation(error, text)) from None
        except VisitError as error:
            if isinstance(found := error.orig_exc, _UnknownName):
                raise _wrong(text, found.position, str(found)) from None
            raise

    def __call__(self, part: Part) -> bool:
        """True if the message fits."""
        return self._predicate(part)


class _UnknownName(Exception):
    """A name of the filter that nothing has, or a value that a name cannot have."""

    def __init__(self, position: int, problem: str) -> None:
        super().__init__(problem)
        self.position = position


@v_args(inline=True)
class _Compiler(Transformer[Token, Predicate]):
    """Makes the predicate of a parsed filter, from its leaves on."""

    def __init__(self, registry: Registry) -> None:
        super().__init__()
        self._registry = registry

    def or_test(self, *parts: Predicate) -> Predicate:
        """True if any is."""
        return lambda part: any(test(part) for test in parts)

    def and_test(self, *parts: Predicate) -> Predicate:
        """True if all are."""
        return lambda part: all(test(part) for test in parts)

    def negation(self, test: Predicate) -> Predicate:
        """True if the other is not."""
        return lambda part: not test(part)

    def present(self, name: Token) -> Predicate:
        """True if there is a value that is not zero, false or empty."""
        values = self._values(name)
        return lambda part: any(bool(value) for value in values(part))

    def member(self, name: Token, *wanted: Token) -> Predicate:
        """True if a value is one of several."""
        tests = [self.comparison(name, Token("COMPARISON", "=="), token) for token in wanted]
        return lambda part: any(test(part) for test in tests)

    def comparison(self, name: Token, operator: Token, wanted: Token) -> Predicate:
        """True if a value fits."""
        values = self._values(name)
        value = _value(wanted)
        if (order := ORDERS.get(operator)) is not None:
            if not isinstance(value, float):
                raise _UnknownName(wanted.start_pos or 0, f"{operator} needs a number")
            limit = value
            return lambda part: any(order(number, limit) for number in map(_number, values(part)) if number is not None)
        if operator == "contains":
            text = str(wanted.value).strip("\"'").casefold()
            return lambda part: any(text in _text(value).casefold() for value in values(part))
        self._check(name, wanted)
        fits = _equality(name, wanted, value)
        if operator == "==":
            return lambda part: any(fits(value) for value in values(part))
        return lambda part: bool(found := list(values(part))) and not any(fits(value) for value in found)

    def _values(self, name: Token) -> Callable[[Part], Iterator[object]]:
        """The function that finds the values of a name in a part."""
        known = HEADER.get(name.lower())
        if known is not None:
            read = known[1]
            return lambda part: (value for value in (read(part),) if value is not None)
        path = name.lower()
        last = without_numbers(path.rpartition(".")[2])
        if not any(last == field for field in _field_names(self._registry)):
            raise _UnknownName(name.start_pos or 0, self._unknown(last))
        return lambda part: printed_values(part.content.message, path)

    def _unknown(self, name: str) -> str:
        close = get_close_matches(name, [*HEADER, *_field_names(self._registry)], 1)
        hint = f"; did you mean {close[0]!r}?" if close else f"; besides fields there are {', '.join(HEADER)}"
        return f"no message has a field {printable(name)!r}{hint}"

    def _check(self, name: Token, wanted: Token) -> None:
        """Reject names of messages that do not exist."""
        if name.lower() != "msg":
            return
        names = {entry.name.casefold(): entry.name for entry in self._registry.entries}
        pattern = str(wanted.value).strip("\"'").casefold()
        if not fnmatch.filter(names, pattern):
            close = get_close_matches(pattern, names, 1)
            hint = f"; did you mean {names[close[0]]}?" if close else ""
            raise _UnknownName(wanted.start_pos or 0, f"there is no message {printable(pattern)!r}{hint}")


_PARSER: Final = Lark(GRAMMAR, parser="lalr", lexer="contextual", propagate_positions=True)


def _value(token: Token) -> Value:
    text = str(token.value)
    if token.type == "STRING":
        return text[1:-1]
    if token.type != "NUMBER":
        return text
    try:
        if text.lower().endswith("h"):
            return float(int(text[:-1], 16))
        return float(int(text, 16)) if "0x" in text.lower() else float(text)
    except OverflowError:
        raise _UnknownName(token.start_pos or 0, "the number is too large") from None


def _equality(name: Token, token: Token, wanted: Value) -> Callable[[object], bool]:
    if name.lower() in _NAMES_OF_IDS:
        return _id_pattern(token)
    if isinstance(wanted, float) and token.type == "NUMBER":
        exact, raw = wanted, str(token.value)
        return lambda value: _number(value) == exact or (isinstance(value, str) and value == raw)
    pattern = re.compile(fnmatch.translate(str(wanted).casefold()))
    is_service = name.lower() == "service"

    def fits(value: object) -> bool:
        text = _text(value).casefold()
        return bool(pattern.match(text)) or (is_service and bool(pattern.match(text.rpartition(":")[2])))

    return fits


def _id_pattern(token: Token) -> Callable[[object], bool]:
    """A pattern of ids: parts that are missing, and `*`, stand for any number."""
    parts = str(token.value).strip("\"'").split(".")
    if len(parts) > 3 or not all(part == "*" or (part.isascii() and part.isdigit()) for part in parts):
        raise _UnknownName(token.start_pos or 0, f"{printable(str(token.value))!r} is no id, as 42.1.1, 42.* or 42")
    wanted = [None if part == "*" else str(int(part)) for part in parts]

    def fits(value: object) -> bool:
        return all(part in (None, number) for part, number in zip(wanted, str(value).split("."), strict=False))

    return fits


def printed_values(message: Message | None, path: str) -> Iterator[object]:
    """The values of a field, which is found by the last names of its path, as they are printed."""
    if message is not None and next(_find(message, path), None) is not None:  # rounding takes longer than a search
        yield from _find(rounded(message), path)


def _find(message: Message, end: str) -> Iterator[object]:
    """The values in a message whose paths end with a path."""
    fits, last = _pattern(end).search, without_numbers(end.rpartition(".")[2])  # a search for text is ten times quicker
    return (value for path, value in leaves(message) if last in path and fits(path))


_pattern: Final = lru_cache(maxsize=64)(path_pattern)


def _number(value: object) -> float | None:
    if isinstance(value, Enum):
        value = value.value
    return float(value) if isinstance(value, int | float) else None


def _text(value: object) -> str:
    if isinstance(value, Enum):
        return value.name
    return value.hex() if isinstance(value, bytes) else str(value)


def _field_names(registry: Registry) -> Iterator[str]:
    """The names of all fields, module by module; first those of modules that are imported already."""
    modules = dict.fromkeys(entry.module for entry in registry.entries)
    for module in sorted(modules, key=lambda name: name not in sys.modules):
        yield from _fields_of_module(module)


@cache
def _fields_of_module(module: str) -> frozenset[str]:
    names: set[str] = set()
    waiting: list[Any] = list(vars(import_module(module)).values())
    while waiting:
        kind = waiting.pop()
        if isinstance(kind, type) and is_dataclass(kind) and issubclass(kind, Struct):
            names.update(field.name for field in fields(kind))
            waiting += vars(kind).values()
    return frozenset(names)


def _wrong(text: str, position: int, problem: str) -> ConfigError:
    """The filter with a mark below the character at which it is wrong."""
    start = max(0, position - 60)
    shown = printable(text[start : start + 120])
    mark = " " * len(printable(text[start:position])) + "^"
    return ConfigError(f"the filter is wrong at character {position + 1}: {problem}\n  {shown}\n  {mark}")


def _position(error: UnexpectedInput, text: str) -> int:
    position: int | None = error.pos_in_stream
    at_end = isinstance(error, UnexpectedToken) and error.token.type == "$END"
    return len(text.rstrip()) if position is None or at_end else position


def _expectation(error: UnexpectedInput, text: str) -> str:
    """What could stand where the parser stopped."""
    expected = getattr(error, "expected", None) or getattr(error, "allowed", None) or set()
    what = [words for token, words in _WORDS.items() if token in expected]
    if _position(error, text) >= len(text.rstrip()):
        return f"it ends where {' or '.join(what) or 'more'} is expected"
    return f"{' or '.join(what) or 'nothing more'} is expected here"


_WORDS: Final = {
    "COMPARISON": "a comparison (==, !=, <, <=, >, >=, contains, in)",
    "NUMBER": "a value",
    "NAME": "a name",
    "_OR": "and, or",
    "RPAR": "a closing parenthesis",
}
"""Tokens of the grammar as error texts call them."""
