"""Expands xacro files as data: expressions are evaluated here, on numbers, texts and lists, never by Python.

xacro evaluates `${...}` with Python's `eval`, and what it excludes is easily reached all the same. So this module runs
its own copy of the module `xacro` with another evaluation; in any version of xacro, a remaining `eval` fails.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from fnmatch import fnmatchcase
from functools import partial
from importlib.util import module_from_spec
from io import StringIO
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
from jauspy.robot.missing_parts import SCHEME, MissingParts
from jauspy.robot.urdf_paths import MissingFile, PackagePaths
from jauspy.robot.xacro_expressions import (
    BUILTIN,
    BYTES,
    FILES,
    MATH,
    PYTHON,
    STEPS,
    YAML_BYTES,
    Costs,
    Evaluator,
    ExpressionError,
)
from jauspy.user_files import read_file

MAX_DEPTH: Final = 32
"""Files that include each other."""

MAX_REASON: Final = 500
"""Characters of an error."""

_SWITCHES: Final = frozenset(("", "true", "false", "on", "off", "yes", "no"))

_LOG: Final = get_logger("jauspy.xacro")


def expand(
    path: str,
    packages: PackagePaths | None = None,
    arguments: Mapping[str, str] | None = None,
    *,
    with_places: bool = False,
    missing: MissingParts | None = None,
) -> str:
    """The URDF that a xacro file describes, or a URDF as it is. Raises `ConfigError` in one line.

    `packages` finds the directories of `$(find ...)`; `arguments` are those of `$(arg ...)`. `with_places` gives each
    element the attribute `PLACE`. `missing` collects includes whose files are missing, which are left out with the
    calls of macros that are unknown then; without it they are errors.
    """
    if Path(path).is_dir():
        raise ConfigError(f"urdf: {path}: is a directory; name the URDF or xacro file in it")
    if not Path(path).is_file():
        raise ConfigError(f"urdf: {path}: there is no such file")
    try:
        module = _copy_of_xacro(Path(path), packages or PackagePaths(), missing, with_places=with_places)
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


def _copy_of_xacro(
    path: Path, packages: PackagePaths, missing: MissingParts | None = None, *, with_places: bool = False
) -> Any:
    """The module for one file, with evaluation as described here. What others import as `xacro` stays as it is."""
    spec = xacro.__spec__
    assert spec.loader is not None
    module: Any = module_from_spec(spec)
    spec.loader.exec_module(module)
    symbols = {**MATH, **BUILTIN}
    named = {"math": MATH, "python": PYTHON, "xacro": {"load_yaml": module.load_yaml}}
    for name, values in named.items():
        symbols[name] = module.NameSpace()
        symbols[name].update(values)
    costs = Costs()
    evaluator = Evaluator(filter(callable, (*symbols.values(), *PYTHON.values(), module.load_yaml)), costs)
    read = partial(_read, path, packages, costs)
    module.eval = module.exec = _refuse
    module.open = partial(_open_yaml, read, costs, missing)
    module.parse = partial(_parse, module, read, lambda name: _CountedElements(name, costs, with_places=with_places))
    module.glob = SimpleNamespace(glob=partial(_matching, path, packages, costs))
    module.safe_eval = lambda text, names, _=None: evaluator.evaluate(text, names)
    module.eval_text = partial(_text, module.eval_text, costs)
    search = partial(packages.package, near=path)
    extension = partial(_extension, module.eval_extension, partial(missing.find, search=search) if missing else search)
    if missing is not None:
        _Tolerant(module, missing, partial(_exists, path, packages, costs))
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


def _parameter(parse: Callable[[str], object], costs: Costs, text: str) -> object:
    """A macro's first parameter, and the others as text."""
    costs.add(STEPS, 100 * len(text))
    return parse(text)


def _text(evaluate: Callable[..., object], costs: Costs, text: str, symbols: object) -> object:
    """The value of a text with expressions; xacro copies the remaining text for each of its parts."""
    costs.add(STEPS, len(text) * (1 + text.count("$")))
    return evaluate(text, symbols)


def _among_siblings(change: Callable[..., None], costs: Costs, node: minidom.Element, **how: Any) -> None:
    """Replace an element, or remove comments; each is searched among its siblings."""
    separator = how.get("by")
    inserted = [
        element for element in (separator if isinstance(separator, list) else [separator]) if element is not None
    ]
    times = 1 + sum(len(element.childNodes) for element in inserted)
    costs.add(STEPS, times * len(node.parentNode.childNodes) if node.parentNode else 1)
    change(node, **how)


def _log(text: object, *more: object, **_: object) -> None:
    _LOG.warning("%s", printable(" ".join(map(str, (text, *more))))[:200])


def _refrain() -> None:
    """Print nothing, in place of the function that prints the place of each warning."""


def _read(top: Path, packages: PackagePaths, costs: Costs, path: Path) -> bytes:
    """The content of the file itself, or of one that it names."""
    costs.add(FILES)
    if path != top and not packages.permitted(path, top).exists():
        raise FileNotFoundError(f"{path}: there is no such file")
    data = read_file(path)
    costs.add(BYTES, len(data))
    return data


def _matching(top: Path, packages: PackagePaths, costs: Costs, pattern: str) -> list[str]:
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


def _open_yaml(read: Callable[[Path], bytes], costs: Costs, missing: MissingParts | None, path: str) -> StringIO:
    """A file that is read as YAML; raises `MissingFile` if its package is missing."""
    if missing is not None and (error := missing.package_error(path[max(0, path.find(SCHEME)) :])) is not None:
        raise error
    data = read(Path(path))
    costs.add(YAML_BYTES, len(data))
    return StringIO(data.decode())


def _exists(top: Path, packages: PackagePaths, costs: Costs, path: Path) -> bool:
    """True if a file that may be named exists; raises `ConfigError` for others."""
    costs.add(STEPS, 10_000)
    return path == top or packages.permitted(path, top).exists()


class _Tolerant:
    """How xacro includes files and calls macros, but that it leaves out what is missing, and notes it."""

    def __init__(self, module: Any, missing: MissingParts, exists: Callable[[Path], bool]) -> None:
        self._module = module
        self._process, self._call = module.process_include, module.handle_macro_call
        self._missing = missing
        self._exists = exists
        module.process_include, module.handle_macro_call = self.include, self.call

    def include(self, elt: minidom.Element, macros: object, symbols: object, func: object) -> None:
        """Process an `<xacro:include>`, or leave it out if its file or package is missing."""
        module = self._module
        name = str(module.eval_text(elt.getAttribute("filename"), symbols))
        path = Path(module.abs_filename_spec(name))
        error = self._missing.package_error(name)
        optional = module.get_boolean_value(elt.getAttribute("optional") or "false", None)
        if error is None and not optional and not re.search(r"[*?[]", name) and not self._exists(path):
            error = MissingFile(f"{path}: there is no such file")
        if error is None:
            self._process(elt, macros, symbols, func)
            return
        self._missing.add_include(name, elt.getUserData(PLACE) or "", str(error))
        self._remove(elt)

    def call(self, node: minidom.Element, macros: object, symbols: object) -> bool:
        """Expand the call of a macro, or leave it out if the macro is unknown because includes are missing."""
        name = node.tagName.removeprefix("xacro:")
        if self._missing.lacks_includes and name not in (node.tagName, "call"):
            try:
                self._module.resolve_macro(name, macros, symbols)
            except KeyError:
                self._missing.leave_out("macros", f"{name} ({node.getUserData(PLACE)})")
                self._remove(node)
                return True
        return bool(self._call(node, macros, symbols))

    def _remove(self, element: minidom.Element) -> None:
        self._module.remove_previous_comments(element)
        self._module.replace_node(element, by=None)


def _extension(resolve: Callable[[str], object], package: Callable[[str], object], text: str) -> object:
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
    """Parse a file as xacro's `parse` does, with the places of its elements."""
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

    def __init__(self, costs: Costs) -> None:
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

    def __init__(self, name: str, costs: Costs, *, with_places: bool) -> None:
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
