"""Constant expressions of JSIDL limits and sizes, as in `-10 * basicConsts.PI`."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable

Number = int | float
Lookup = Callable[[str], Number]
"""The value of a (dotted) constant name; raises `ExpressionError` when there is none."""

MAX_LENGTH = 200
"""Characters of an expression; bounds the depth of its syntax tree."""

_BINARY: dict[type[ast.operator], Callable[[Number, Number], Number]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


class ExpressionError(ValueError):
    """Why a text is not a constant expression."""


def evaluate(text: str, lookup: Lookup) -> Number:
    """The value of numbers and constant names joined by + - * / and parentheses; an int stays an int."""
    plain = _literal(text)
    if plain is not None:
        return plain
    if len(text) > MAX_LENGTH:
        raise ExpressionError(f"expression longer than {MAX_LENGTH} characters")
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise ExpressionError(f"expected a number or a constant expression, got {text!r}") from error
    try:
        result = _value(tree.body, lookup)
    except (ZeroDivisionError, OverflowError) as error:
        raise ExpressionError(f"{text!r}: {error}") from error
    if not math.isfinite(result):
        raise ExpressionError(f"{text!r} is not finite")
    return result


def _literal(text: str) -> Number | None:
    """Most limits are plain numbers."""
    try:
        return int(text)
    except ValueError:
        pass
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def _value(node: ast.expr, lookup: Lookup) -> Number:
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return number
        case ast.UnaryOp(op=ast.USub()):
            return -_value(node.operand, lookup)
        case ast.UnaryOp(op=ast.UAdd()):
            return _value(node.operand, lookup)
        case ast.BinOp() if type(node.op) in _BINARY:
            return _BINARY[type(node.op)](_value(node.left, lookup), _value(node.right, lookup))
        case ast.Name() | ast.Attribute():
            return lookup(ast.unparse(node))
    raise ExpressionError(f"expected numbers, constants, + - * / and parentheses, got {ast.unparse(node)!r}")
