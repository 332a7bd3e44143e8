"""Expands xacro files as data: expressions are evaluated here, on numbers, texts and lists, never by Python.

xacro evaluates `${...}` with Python's `eval`, and what it excludes is easily reached all the same. So this module runs
its own copy of the module `xacro` with another evaluation; in any version of xacro, a remaining `eval` fails.
"""

from __future__ import annotations

import ast
import math
import operator
import os
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from importlib.util import module_from_spec
from io import StringIO
from itertools import count, pairwise
from pathlib import Path
from typing import Any, Final, NoReturn
from xml.dom import expatbuilder, minidom
from xml.parsers.expat import ErrorString, ExpatError

import xacro

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import PLACE
from jauspy.modules.urdf_paths import PackagePaths
from jauspy.printable import printable
from jauspy.user_files import read_file

MAX_EXPRESSION: Final = 1000
"""Characters of an expression; bounds the depth of its syntax tree, too."""

MAX_VALUE_BITS: Final = 1024
"""Of an integer; floats have about as many."""

MAX_VALUE_LENGTH: Final = 100_000
"""Of a text, or of all that a list has at any depth; properties that double each other reach it soon."""

MAX_TOTAL: Final = 2_000_000
"""Of all values that a file uses, each time that it does; for robots of jauspy it is 4000."""

MAX_DIGITS: Final = 400
"""Of `round`, which otherwise calculates 10 to the power of any number."""

MAX_ELEMENTS: Final = 100_000
"""XML elements that macros make of a file; robots of jauspy have up to 700."""

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
    if not all(isinstance(each, int | float) for each in _sequence(values)):
        raise ExpressionError("sum is not evaluated for texts and lists")
    return sum(values)


def _sequence(value: Any) -> Any:
    if not isinstance(value, list | tuple | str):
        raise ExpressionError(f"{value!r} has no parts")
    return value


_TEXT_METHODS: Final[Mapping[str, Callable[..., Any]]] = {
    name: getattr(str, name) for name in ("endswith", "lower", "split", "startswith", "strip", "upper")
}
"""Methods of texts that are called by name; what they return is not longer than the text."""

_SWITCHES: Final = frozenset(("", "true", "false", "on", "off", "yes", "no"))

_MATH: Final = {
    name: value
    for name, value in vars(math).items()
    if not name.startswith("_") and name not in ("comb", "factorial", "perm", "prod")  # whose results take for ever
}
_BUILTIN: Final = {**{each.__name__: each for each in (bool, float, int, len, max, min, str)}, "round": _rounded}
_PYTHON: Final = {**_BUILTIN, **{each.__name__: each for each in (abs, all, any, sorted)}, "sum": _sum}


def expand(
    path: str,
    packages: PackagePaths | None = None,
    arguments: Mapping[str, str] | None = None,
    *,
    with_places: bool = False,
) -> str:
    """The URDF that a xacro file describes, or a URDF as it is. Raises `ConfigError` in one line.

    `packages` finds the directories of `$(find ...)`; `arguments` are those of `$(arg ...)`. `with_places` gives each
    element the attribute `PLACE`.
    """
    if Path(path).is_dir():
        raise ConfigError(f"urdf: {path}: is a directory; name the URDF or xacro file in it")
    if not Path(path).is_file():
        raise ConfigError(f"urdf: {path}: there is no such file")
    try:
        module = _copy_of_xacro(Path(path), packages or PackagePaths())
        if with_places:
            module.parse = partial(_parse, module.parse)
        return str(module.process_file(path, mappings=dict(arguments or {})).toxml())
    except Exception as error:  # xacro leaves it to Python to find some mistakes
        reason = printable(" ".join(str(error).split())) or type(error).__name__
        if isinstance(error, RecursionError):
            reason = "includes or macros contain themselves"
        place = _failed_at(error)
        raise ConfigError(f"urdf: {path}: xacro cannot expand it: {place}{reason}") from error


def _failed_at(error: Exception) -> str:
    """The place of the element that xacro was expanding, as `arm.xacro:12: `; empty if there is none."""
    place, trace = "", error.__traceback__
    while trace is not None:
        for variable in ("node", "elt"):  # xacro's names of it
            element = trace.tb_frame.f_locals.get(variable)
            if isinstance(element, minidom.Element):
                place = element.getUserData(PLACE) or place
        trace = trace.tb_next
    return place and f"{place}: "


def _copy_of_xacro(path: Path, packages: PackagePaths) -> Any:
    """The module for one file, with evaluation as described here. What others import as `xacro` stays as it is."""
    spec = xacro.__spec__
    assert spec.loader is not None
    module: Any = module_from_spec(spec)
    spec.loader.exec_module(module)
    symbols = {**_MATH, **_BUILTIN}
    named = {"math": _MATH, "python": _PYTHON, "xacro": {"load_yaml": module.load_yaml}}
    for name, values in named.items():
        symbols[name] = module.NameSpace()
        symbols[name].update(values)
    evaluator = Evaluator(filter(callable, (*symbols.values(), *_PYTHON.values(), module.load_yaml)))
    module.eval = module.exec = _refuse
    module.open = _open
    module.safe_eval = lambda text, names, _=None: evaluator.evaluate(text, names)
    module.eval_extension = partial(_extension, module.eval_extension, lambda name: packages.package(name, path))
    module.handle_macro_call = _counted(module.handle_macro_call)
    module._global_symbols = symbols  # noqa: SLF001 - xacro offers no other way
    return module


def _refuse(*_: object) -> NoReturn:
    raise ExpressionError("this version of xacro evaluates in a way that is not known to be safe")


def _open(path: str) -> StringIO:
    """A file that is included, or is read as YAML: not a device or a pipe, which may never end."""
    return StringIO(read_file(Path(path)).decode())


def _extension(resolve: Callable[[str], object], package: Callable[[str], Path], text: str) -> object:
    """`$(arg NAME)`, `$(find PACKAGE)` and others, which evaluate nothing."""
    words = text.removeprefix("$(").removesuffix(")").split()
    if words[:1] == ["eval"]:
        raise ExpressionError(f"{text}: write ${{...}}")
    if words[:1] == ["find"] and len(words) == 2:
        return str(package(words[1]))
    if words[:1] in (["env"], ["optenv"]) and len(words) > 1:
        _check_variable(words[1])
    return resolve(text)


def _check_variable(name: str) -> None:
    """Refuse an environment variable that may be a secret: a robot reports what its file contains to its clients."""
    value = os.environ.get(name, "")
    if value.lower() in _SWITCHES:
        return
    try:
        float(value)
    except ValueError:
        raise ExpressionError(
            f"the value of the environment variable {name} is not read, because it is neither a number nor one of "
            "true, false, on, off, yes and no: write it into the file"
        ) from None


def _parse(parse: Callable[..., Any], text: Any, filename: str | None = None) -> Any:
    """As xacro's `parse`: the document of a file, whose elements have their places."""
    if text is not None or filename is None:
        return parse(text, filename)
    builder = _PlacedElements(Path(filename).name)
    try:
        return builder.parseString(read_file(Path(filename)))
    except ExpatError as error:
        raise ExpressionError(f"{printable(filename)}:{error.lineno}: not XML: {ErrorString(error.code)}") from error


class _CopiesPlace:
    """Gives the copies of elements that macros make the place of the element."""

    def handle(self, operation: int, key: str, data: Any, src: minidom.Node, dst: minidom.Node) -> None:
        """Called by xml.dom for a copy, `dst`."""
        del operation, src
        dst.setUserData(key, data, self)


class _PlacedElements(expatbuilder.ExpatBuilderNS):
    """Makes documents whose elements have `PLACE` as user data, and those that are not xacro's also as attribute."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self._name = name.replace("$", "")

    def start_element_handler(self, name: str, attributes: Any) -> None:
        """Called by the parser at each start of an element."""
        super().start_element_handler(name, attributes)
        element: Any = self.curNode
        place = f"{self._name}:{self.getParser().CurrentLineNumber}"
        element.setUserData(PLACE, place, _CopiesPlace())
        if ":" not in element.tagName:
            element.setAttribute(PLACE, place)


def _counted(handle_macro_call: Callable[..., object]) -> Callable[..., object]:
    """The function that xacro calls for every element, which counts them."""
    elements = count(1)

    def handle(*arguments: object) -> object:
        if next(elements) > MAX_ELEMENTS:
            raise ExpressionError(f"macros make more than {MAX_ELEMENTS} elements of it")
        return handle_macro_call(*arguments)

    return handle


class Evaluator:
    """Evaluates expressions in Python's syntax: numbers, texts, lists, operators, calls of `functions`."""

    def __init__(self, functions: Iterable[Callable[..., Any]]) -> None:
        self._functions = tuple(functions)
        self._total = 0

    def evaluate(self, text: str, names: Mapping[str, Any]) -> Any:
        """The value of an expression; raises `ExpressionError`, or what the operators and functions raise."""
        if len(text) > MAX_EXPRESSION:
            raise ExpressionError(f"expression longer than {MAX_EXPRESSION} characters")
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
                return self._bounded(constant)
            case ast.Name(id=name):
                return self._bounded(_item(names, name))
            case ast.Attribute(value=holder, attr=name):
                return self._bounded(_item(value(holder), name))
            case ast.Subscript(value=holder, slice=ast.Slice(lower, upper, step)):
                return _sequence(value(holder))[value(lower) : value(upper) : value(step)]
            case ast.Subscript(value=holder, slice=key):
                found = value(holder)
                at = value(key)
                return self._bounded(_item(found, at) if isinstance(found, dict) else _sequence(found)[at])
            case ast.List(elts=parts) | ast.Tuple(elts=parts):
                return self._bounded([value(part) for part in parts])
            case ast.Dict(keys=keys, values=parts) if None not in keys:
                return self._bounded({value(key): value(part) for key, part in zip(keys, parts, strict=True)})
            case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
                return _OPERATORS[type(op)](value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                return self._bounded(_calculated(type(op), value(left), value(right)))
            case ast.BoolOp(op=op, values=parts):
                return self._either(parts, names, until=isinstance(op, ast.Or))
            case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in _OPERATORS for op in ops):
                values = [value(each) for each in (left, *others)]
                return all(_OPERATORS[type(op)](*pair) for op, pair in zip(ops, pairwise(values), strict=True))
            case ast.IfExp(test=test, body=body, orelse=other):
                return value(body if value(test) else other)
            case ast.Call(func=ast.Attribute(value=holder, attr=name), args=arguments, keywords=[]) if (
                name in _TEXT_METHODS and isinstance(text := value(holder), str)
            ):
                return self._bounded(_TEXT_METHODS[name](text, *map(value, arguments)))
            case ast.Call(func=function, args=arguments, keywords=[]):
                called = value(function)
                if any(called is each for each in self._functions):
                    return self._bounded(called(*map(value, arguments)))
        raise ExpressionError(
            f"{ast.unparse(node)!r} is not evaluated: only numbers, texts, lists, and functions of math"
        )

    def _bounded(self, value: Any) -> Any:
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
