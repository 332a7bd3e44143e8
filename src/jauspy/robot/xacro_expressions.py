"""Evaluates expressions of xacro files as data: numbers, texts and lists, within bounds; never by Python's `eval`."""

from __future__ import annotations

import ast
import math
import operator
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from itertools import pairwise
from typing import Any, Final

MAX_EXPRESSION: Final = 1000
"""Characters of an expression; bounds the depth of its syntax tree, too."""

MAX_VALUE_BITS: Final = 1024
"""Most bits of an integer; floats have about as many."""

MAX_VALUE_LENGTH: Final = 100_000
"""Most characters of a text, or of a list at any depth; properties that double each other reach it soon."""

MAX_TOTAL: Final = 2_000_000
"""Most characters of all values that a file uses, each time that it does; robots of jauspy use 4000."""

MAX_DIGITS: Final = 400
"""Most digits of `round`, which otherwise calculates 10 to the power of any number."""

FILES: Final = "files, each time that they are read"
BYTES: Final = "bytes in all files"
YAML_BYTES: Final = "bytes of YAML"
PARTS: Final = "elements, attributes and texts, with those that macros make"
CHARACTERS: Final = "characters in elements, with those that macros make"
EXPRESSIONS: Final = "characters of expressions"
STEPS: Final = "steps"
LIMITS: Final[Mapping[str, int]] = {
    FILES: 1000,
    BYTES: 16 << 20,
    YAML_BYTES: 512 << 10,  # of which a second reads 100 kB
    PARTS: 200_000,
    CHARACTERS: 16 << 20,
    EXPRESSIONS: 1_000_000,
    STEPS: 500_000_000,
}
"""Bounds of what one file takes with all that it includes. Robots of jauspy: 6 files, 29 kB, 10,000 parts."""

_OPERATORS: Final[Mapping[type[ast.AST], Callable[..., Any]]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda one, other: one in other,
    ast.NotIn: lambda one, other: one not in other,
}


class ExpressionError(Exception):
    """Why an expression is not evaluated."""


def _rounded(value: float, digits: int | None = None) -> float:
    if digits is not None and abs(digits) > MAX_DIGITS:
        raise ExpressionError(f"round is not evaluated for more than {MAX_DIGITS} digits")
    return round(value, digits)


def _sum(values: Any) -> Any:
    """The sum of numbers only; Python's `sum` also joins lists, which takes quadratic time."""
    if not all(isinstance(entry, int | float) for entry in _sequence(values)):
        raise ExpressionError("sum is not evaluated for texts and lists")
    return sum(values)


def _sequence(value: Any) -> Any:
    if not isinstance(value, list | tuple | str):
        raise ExpressionError(f"{value!r} has no parts")
    return value


def _replaced(text: str, old: str, new: str, count: int = -1) -> str:
    found = text.count(old)
    _check_length(len(text) + (found if count < 0 else min(found, count)) * (len(new) - len(old)))
    return text.replace(old, new, count)


def _joined(text: str, parts: Any) -> str:
    if not all(isinstance(part, str) for part in _sequence(parts)):
        raise ExpressionError("join is evaluated for texts only")
    _check_length(sum(map(len, parts)) + len(text) * len(parts))
    return text.join(parts)


def _padding(name: str) -> Callable[..., str]:
    """The method of that name, which makes a text as long as its argument says."""
    method: Callable[..., str] = getattr(str, name)

    def pad(text: str, width: int, *fill: str) -> str:
        _check_length(width)
        return method(text, width, *fill)

    return pad


def _check_length(length: int) -> None:
    if length > MAX_VALUE_LENGTH:
        raise ExpressionError(f"a value is longer than {MAX_VALUE_LENGTH}")


_SHORT: Final = (
    *("capitalize", "casefold", "lower", "swapcase", "title", "upper"),
    *("lstrip", "removeprefix", "removesuffix", "rstrip", "strip"),
    *("partition", "rpartition", "rsplit", "split", "splitlines"),
    *("count", "endswith", "find", "index", "rfind", "rindex", "startswith"),
    *("isalnum", "isalpha", "isascii", "isdecimal", "isdigit", "isidentifier", "islower", "isnumeric", "isspace"),
    *("istitle", "isupper"),
)
_TEXT_METHODS: Final[Mapping[str, Callable[..., Any]]] = {
    **{name: getattr(str, name) for name in _SHORT},
    **{name: _padding(name) for name in ("center", "ljust", "rjust", "zfill")},
    "replace": _replaced,
    "join": _joined,
}
"""Methods of texts, called by name. They depend on their arguments only, and their results are bounded: `_SHORT` return
little more than the text, of the others the length is checked first. `format` and `format_map` reach attributes."""

MATH: Final = {
    name: value
    for name, value in vars(math).items()
    if not name.startswith("_") and name not in ("comb", "factorial", "perm", "prod")  # whose results take for ever
}
BUILTIN: Final = {
    **{function.__name__: function for function in (bool, float, int, len, max, min, str)},
    "round": _rounded,
}
PYTHON: Final = {**BUILTIN, **{function.__name__: function for function in (abs, all, any, sorted)}, "sum": _sum}


class Costs:
    """Counts what a file takes while it is expanded, so that no file takes all memory, or for ever."""

    def __init__(self) -> None:
        self._spent: Counter[str] = Counter()

    def add(self, what: str, amount: int = 1) -> None:
        """Count it; raises `ExpressionError` beyond the limit."""
        self._spent[what] += amount
        if self._spent[what] > LIMITS[what]:
            raise ExpressionError(f"it has more than {LIMITS[what]} {what}")

    def add_element(self, attributes: Iterable[str], texts: Iterable[str] = ()) -> None:
        """Count an element with the names and values of its attributes, and its texts and comments."""
        lengths = [*map(len, attributes), *map(len, texts)]
        self.add(PARTS, 1 + len(lengths))
        self.add(CHARACTERS, sum(lengths))


class Evaluator:
    """Evaluates expressions in Python's syntax: numbers, texts, lists, operators, calls of `functions`."""

    def __init__(self, functions: Iterable[Callable[..., Any]], costs: Costs) -> None:
        self._functions = tuple(functions)
        self._costs = costs
        self._total = 0

    def evaluate(self, text: str, names: Mapping[str, Any]) -> Any:
        """The value of an expression; raises `ExpressionError`, or what the operators and functions raise."""
        if len(text) > MAX_EXPRESSION:
            raise ExpressionError(f"expression longer than {MAX_EXPRESSION} characters")
        self._costs.add(EXPRESSIONS, len(text))
        try:
            tree = ast.parse(text.strip(), mode="eval")
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            raise ExpressionError(f"{text!r} is not an expression") from error
        return self._value(tree.body, names)

    def _value(self, node: ast.expr | None, names: Mapping[str, Any]) -> Any:
        value = partial(self._value, names=names)
        match node:
            case None:
                return None
            case ast.Constant(value=bool() | int() | float() | str() | None as constant):
                return self.bounded(constant)
            case ast.Name(id=name):
                return self.bounded(_item(names, name))
            case ast.Attribute(value=holder, attr=name):
                return self.bounded(_item(value(holder), name))
            case ast.Subscript(value=holder, slice=ast.Slice(lower, upper, step)):
                return _sequence(value(holder))[value(lower) : value(upper) : value(step)]
            case ast.Subscript(value=holder, slice=key):
                found = value(holder)
                index = value(key)
                return self.bounded(_item(found, index) if isinstance(found, dict) else _sequence(found)[index])
            case ast.List(elts=parts) | ast.Tuple(elts=parts):
                return self.bounded([value(part) for part in parts])
            case ast.Dict(keys=keys, values=parts) if None not in keys:
                return self.bounded({value(key): value(part) for key, part in zip(keys, parts, strict=True)})
            case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
                return _OPERATORS[type(op)](value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                return self.bounded(_calculated(type(op), value(left), value(right)))
            case ast.BoolOp(op=op, values=parts):
                return self._either(parts, names, until=isinstance(op, ast.Or))
            case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in _OPERATORS for op in ops):
                values = [value(operand) for operand in (left, *others)]
                return all(_OPERATORS[type(op)](*pair) for op, pair in zip(ops, pairwise(values), strict=True))
            case ast.IfExp(test=test, body=body, orelse=other):
                return value(body if value(test) else other)
            case ast.Call(func=ast.Attribute(value=holder, attr=name), args=arguments, keywords=[]) if (
                name in _TEXT_METHODS and isinstance(text := value(holder), str)
            ):
                return self.bounded(_TEXT_METHODS[name](text, *map(value, arguments)))
            case ast.Call(func=function, args=arguments, keywords=[]):
                called = value(function)
                if any(called is function for function in self._functions):
                    return self.bounded(called(*map(value, arguments)))
        raise ExpressionError(
            f"{ast.unparse(node)!r} is not evaluated: only numbers, texts, lists, and functions of math"
        )

    def bounded(self, value: Any) -> Any:
        """The value. Lists share their parts, so that a few lines make one of 2 to the power of its depth."""
        if isinstance(value, int) and value.bit_length() > MAX_VALUE_BITS:
            raise ExpressionError(f"a number has more than {MAX_VALUE_BITS} bits")
        size, parts = 1, [value]
        while parts:
            part = parts.pop()
            if isinstance(part, str | list | tuple | dict):
                size += len(part)
            if size > MAX_VALUE_LENGTH:
                raise ExpressionError(f"a value is longer than {MAX_VALUE_LENGTH}")
            if isinstance(part, list | tuple):
                parts += part
            elif isinstance(part, dict):
                parts += part.values()
        self._total += size
        if self._total > MAX_TOTAL:
            raise ExpressionError(f"the values of all expressions are longer than {MAX_TOTAL}")
        return value

    def _either(self, parts: Iterable[ast.expr], names: Mapping[str, Any], *, until: bool) -> Any:
        """`a or b`, until one is true, or `a and b`, until one is false; the last one otherwise."""
        found = None
        for part in parts:
            found = self._value(part, names)
            if bool(found) is until:
                break
        return found


def _item(holder: Any, name: Any) -> Any:
    """A name of a scope, or a key of a dictionary; nothing has attributes."""
    if not isinstance(holder, dict):
        raise ExpressionError(f".{name} is not evaluated: values have no attributes and methods here")
    try:
        return holder[name]
    except (KeyError, AttributeError):  # xacro's dictionaries raise both
        raise ExpressionError(f"{name!r} is not defined") from None


def _calculated(op: type[ast.operator], left: Any, right: Any) -> Any:
    """An operation whose result is not too large; this is checked before it takes time."""
    if op is ast.Mod and not isinstance(left, int | float):
        raise ExpressionError("% is not evaluated for texts")
    if op is ast.Mult and not (isinstance(left, int | float) and isinstance(right, int | float)):
        raise ExpressionError("* is not evaluated for texts and lists")
    if (
        op is ast.Pow
        and isinstance(left, int)
        and isinstance(right, int)
        and left.bit_length() * right > 2 * MAX_VALUE_BITS
    ):
        raise ExpressionError(f"a number has more than {MAX_VALUE_BITS} bits")
    return _OPERATORS[op](left, right)
