"""Expands xacro files as data: expressions are evaluated here, on numbers, texts and lists, never by Python.

xacro evaluates `${...}` with Python's `eval`, and what it excludes is easily reached all the same. So this module runs
its own copy of the module `xacro` with another evaluation; in any version of xacro, a remaining `eval` fails.
"""

from __future__ import annotations

import ast
import math
import operator
import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from fnmatch import fnmatchcase
from functools import partial
from importlib.util import module_from_spec
from io import StringIO
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Final, NoReturn
from xml.dom import expatbuilder, minidom
from xml.parsers.expat import ErrorString, ExpatError

import xacro

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import PLACE
from jauspy.logs import get_logger
from jauspy.printable import printable
from jauspy.robot.urdf_paths import PackagePaths
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

MAX_DEPTH: Final = 32
"""Files that include each other."""

MAX_REASON: Final = 500
"""Characters of an error."""

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
"""Of what one file takes with all that it includes. Robots of jauspy: 6 files, 29 kB, 10,000 parts."""

_LOG: Final = get_logger("jauspy.xacro")

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
        module = _copy_of_xacro(Path(path), packages or PackagePaths(), with_places=with_places)
        return str(module.process_file(path, mappings=dict(arguments or {})).toxml())
    except Exception as error:  # xacro leaves it to Python to find some mistakes
        reason = printable(" ".join(str(error).split()))[:MAX_REASON] or type(error).__name__
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


class _Costs:
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


def _copy_of_xacro(path: Path, packages: PackagePaths, *, with_places: bool = False) -> Any:
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
    costs = _Costs()
    evaluator = Evaluator(filter(callable, (*symbols.values(), *_PYTHON.values(), module.load_yaml)), costs)
    read = partial(_read, path, packages, costs)
    module.eval = module.exec = _refuse
    module.open = partial(_open_yaml, read, costs)
    module.parse = partial(_parse, module, read, lambda name: _CountedElements(name, costs, with_places=with_places))
    module.glob = SimpleNamespace(glob=partial(_matching, path, packages, costs))
    module.safe_eval = lambda text, names, _=None: evaluator.evaluate(text, names)
    module.eval_text = partial(_text, module.eval_text, costs)
    extension = partial(_extension, module.eval_extension, lambda name: packages.package(name, path))
    module.eval_extension = lambda text: evaluator.bounded(extension(text))
    for name in ("replace_node", "remove_previous_comments"):
        setattr(module, name, partial(_among_siblings, getattr(module, name), costs))
    module.re_macro_arg = _PARAMETER
    module.parse_macro_arg = partial(_parameter, module.parse_macro_arg, costs)
    module.message = module.warning = module.error = _log
    module.print_location = _refrain
    module._global_symbols = symbols  # noqa: SLF001 - xacro offers no other way
    return module


_PARAMETER: Final = re.compile(
    r"""^\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?(\$\{[^}]*\}|\$\([^)]*\)|(?:'[^']*'|"[^"]*"|[^\s'"])+|)(?:\s+|$)(.*)"""
)
"""xacro's pattern of a macro's parameter, without its alternatives that take exponential time."""


def _parameter(parse: Callable[[str], object], costs: _Costs, text: str) -> object:
    """A macro's first parameter, and the others as text."""
    costs.add(STEPS, 100 * len(text))
    return parse(text)


def _text(evaluate: Callable[..., object], costs: _Costs, text: str, symbols: object) -> object:
    """The value of a text with expressions; xacro copies the remaining text for each of its parts."""
    costs.add(STEPS, len(text) * (1 + text.count("$")))
    return evaluate(text, symbols)


def _among_siblings(change: Callable[..., None], costs: _Costs, node: minidom.Element, **how: Any) -> None:
    """Replace an element, or remove comments; each is searched among its siblings."""
    by = how.get("by")
    inserted = [element for element in (by if isinstance(by, list) else [by]) if element is not None]
    times = 1 + sum(len(element.childNodes) for element in inserted)
    costs.add(STEPS, times * len(node.parentNode.childNodes) if node.parentNode else 1)
    change(node, **how)


def _log(text: object, *more: object, **_: object) -> None:
    _LOG.warning("%s", printable(" ".join(map(str, (text, *more))))[:200])


def _refrain() -> None:
    """In place of what prints the place of each warning."""


def _read(top: Path, packages: PackagePaths, costs: _Costs, path: Path) -> bytes:
    """The content of the file itself, or of one that it names."""
    costs.add(FILES)
    if path != top and not packages.permitted(path, top).exists():
        raise FileNotFoundError(f"{path}: there is no such file")
    data = read_file(path)
    costs.add(BYTES, len(data))
    return data


def _matching(top: Path, packages: PackagePaths, costs: _Costs, pattern: str) -> list[str]:
    """The paths that match a pattern with `*`, `?` and `[...]`, in directories whose files may be read."""
    first, *names = Path(pattern).parts
    found = [Path(first)]
    for name in names:
        if not re.search(r"[*?[]", name):
            found = [folder / name for folder in found if (folder / name).exists()]
            continue
        matching = []
        for folder in filter(Path.is_dir, found):
            for entry in packages.permitted(folder, top).iterdir():
                costs.add(STEPS, 10_000)
                if fnmatchcase(entry.name, name) and not entry.name.startswith("."):
                    matching.append(entry)
        found = matching
    return sorted(map(str, found))


def _refuse(*_: object) -> NoReturn:
    raise ExpressionError("this version of xacro evaluates in a way that is not known to be safe")


def _open_yaml(read: Callable[[Path], bytes], costs: _Costs, path: str) -> StringIO:
    """A file that is read as YAML."""
    data = read(Path(path))
    costs.add(YAML_BYTES, len(data))
    return StringIO(data.decode())


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


def _parse(
    module: Any,
    read: Callable[[Path], bytes],
    builder: Callable[[str], expatbuilder.ExpatBuilderNS],
    *given: str | None,
) -> minidom.Document:
    """As xacro's `parse`: the document of a file, whose elements have their places."""
    text, filename = given
    if text is not None or filename is None:
        _refuse()
    if len(module.filestack) > MAX_DEPTH:
        raise RecursionError
    path = Path(filename)
    try:
        document: minidom.Document = builder(path.name).parseString(read(path))
    except FileNotFoundError as error:
        module.filestack.pop()
        raise module.XacroException(exc=error) from error  # xacro goes on if the file is optional
    except ExpatError as error:
        raise ExpressionError(f"{printable(filename)}:{error.lineno}: not XML: {ErrorString(error.code)}") from error
    return document


class _Copies:
    """Gives the copies of elements that macros make the place of the element, and counts them."""

    def __init__(self, costs: _Costs) -> None:
        self._costs = costs

    def handle(self, operation: int, key: str, data: Any, src: minidom.Node, dst: minidom.Node) -> None:
        """Called by xml.dom for a copy, `dst`."""
        del operation
        assert isinstance(src, minidom.Element)
        texts = (child.data for child in src.childNodes if not isinstance(child, minidom.Element))
        self._costs.add_element((text for pair in src.attributes.items() for text in pair), texts)
        dst.setUserData(key, data, self)


class _CountedElements(expatbuilder.ExpatBuilderNS):
    """Makes documents whose elements are counted, and have `PLACE` as user data.

    With places, elements that are not xacro's also have it as attribute.
    """

    def __init__(self, name: str, costs: _Costs, *, with_places: bool) -> None:
        super().__init__()
        self._name = name.replace("$", "")
        self._costs = costs
        self._copies = _Copies(costs)
        self._with_places = with_places

    def start_element_handler(self, name: str, attributes: Any) -> None:
        """Called by the parser at each start of an element."""
        self._costs.add_element(attributes)
        super().start_element_handler(name, attributes)
        element: Any = self.curNode
        place = f"{self._name}:{self.getParser().CurrentLineNumber}"
        element.setUserData(PLACE, place, self._copies)
        if self._with_places and ":" not in element.tagName:
            element.setAttribute(PLACE, place)

    def character_data_handler_cdata(self, data: str) -> None:
        """Called by the parser for a part of a text."""
        self._costs.add_element((), (data,))
        super().character_data_handler_cdata(data)

    def comment_handler(self, data: str) -> None:
        """Called by the parser for a comment."""
        self._costs.add_element((), (data,))
        super().comment_handler(data)

    def pi_handler(self, target: str, data: str) -> None:
        """Called by the parser for a processing instruction."""
        self._costs.add_element((), (target, data))
        super().pi_handler(target, data)

    def start_doctype_decl_handler(self, *_: object) -> None:
        """Called by the parser for a document type, which may define entities."""
        raise ExpressionError("it has a <!DOCTYPE ...>, which is not read")


class Evaluator:
    """Evaluates expressions in Python's syntax: numbers, texts, lists, operators, calls of `functions`."""

    def __init__(self, functions: Iterable[Callable[..., Any]], costs: _Costs) -> None:
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
                at = value(key)
                return self.bounded(_item(found, at) if isinstance(found, dict) else _sequence(found)[at])
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
                values = [value(each) for each in (left, *others)]
                return all(_OPERATORS[type(op)](*pair) for op, pair in zip(ops, pairwise(values), strict=True))
            case ast.IfExp(test=test, body=body, orelse=other):
                return value(body if value(test) else other)
            case ast.Call(func=ast.Attribute(value=holder, attr=name), args=arguments, keywords=[]) if (
                name in _TEXT_METHODS and isinstance(text := value(holder), str)
            ):
                return self.bounded(_TEXT_METHODS[name](text, *map(value, arguments)))
            case ast.Call(func=function, args=arguments, keywords=[]):
                called = value(function)
                if any(called is each for each in self._functions):
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
