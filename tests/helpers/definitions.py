"""A definition that uses all of JSIDL, with any text in it, and what generated Python source may consist of."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Final
from xml.sax.saxutils import escape

import jauspy
from jauspy.cli.new.component import TO_DO
from jauspy.codec.registry import Registry
from jauspy.errors import JausError

_TEMPLATE: Final = Path(__file__).with_name("everything.jsidl").read_text()
_HOLE: Final = re.compile(r"\[(\w+)\]")

HOLES: Final = sorted(set(_HOLE.findall(_TEMPLATE)))
"""Where a definition may have any text: names of several kinds, units, descriptions, guards, the URN."""


def definition(**texts: str) -> str:
    """The definition, with a text appended to each thing of a kind, as in `definition(doc='"')`."""
    assert texts.keys() <= set(HOLES)
    spaces = {each: f"&#{ord(each)};" for each in "\t\n\r\x85\u2028"}  # as they are, a parser makes blanks of them
    return _HOLE.sub(lambda hole: escape(texts.get(hole[1], ""), {'"': "&quot;", **spaces}), _TEMPLATE)


_EXAMPLE: Final = """
from typing import TYPE_CHECKING
if TYPE_CHECKING:
    from acme import A as A
x = f(*e, {1, 2}, [1], {1: 2}, k=lambda c: c.a)
class B:
    y: list[int] | None = -1
    x = ()
    "text"
"""
_DECLARATIONS: Final = frozenset({type(node).__name__ for node in ast.walk(ast.parse(_EXAMPLE))})
_CALLED: Final = re.compile(r"jd(\.[A-Za-z_]+)+|[^()[\]]+\.layout|frozenset|lazy|entries|Registry|IntEnum")
_IMPORTED: Final = ("__future__", "enum", "typing", "jauspy.codec", "jauspy.codec.registry", "jauspy.messages")


def assert_declares_only(source: str, package: str) -> None:
    """Message classes are made of declarations: nothing is called but what declares them, nothing is formatted."""
    tree = ast.parse(source)
    assert {type(node).__name__ for node in ast.walk(tree)} <= _DECLARATIONS
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            assert node.module in _IMPORTED or node.module.startswith(f"{package}.") or node.module == package
        if isinstance(node, ast.Call):
            assert _CALLED.fullmatch(ast.unparse(node.func)), ast.unparse(node)
        if isinstance(node, ast.Attribute | ast.Name):
            name = node.attr if isinstance(node, ast.Attribute) else node.id
            assert not name.startswith("__") or name in ("__name__", "__all__", "__getattr__", "__dir__")


_METHODS: Final = _DECLARATIONS | {"FunctionDef", "Return", "Import"}


def assert_is_stub(source: str, package: str = "it") -> None:
    """Services are classes with methods that do nothing but be counted; only services are made.

    `package` is that of the component.
    """
    tree = ast.parse(source)
    counts = set()
    assert {type(node).__name__ for node in ast.walk(tree)} <= _METHODS
    classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            known = ("__future__", "jauspy", f"{package}.messages")
            assert node.module in known if isinstance(node, ast.ImportFrom) else node.names[0].name in known
        if isinstance(node, ast.FunctionDef):
            assert all(isinstance(each, ast.Expr | ast.Return) for each in node.body)
            counts.add(f"self.host.count('{TO_DO}', '{node.name}')")
        if isinstance(node, ast.Call):
            assert ast.unparse(node.func) in classes or ast.unparse(node) in counts, ast.unparse(node)


def assert_loads_only(source: str) -> None:
    """A module loads files below its folder, and looks up messages by texts."""
    tree = ast.parse(source)
    _, path, package, here, load, *messages = tree.body
    assert [ast.unparse(node) for node in (path, package, here)] == [
        "from pathlib import Path",
        "import jauspy",
        "_HERE = Path(__file__).parent",
    ]
    assert isinstance(load, ast.Assign)
    assert isinstance(load.value, ast.Call)
    assert ast.unparse(load.value.func) == "jauspy.load"
    for argument in load.value.args:
        assert isinstance(argument, ast.BinOp)
        assert isinstance(argument.right, ast.Constant)
    for node in messages:
        assert isinstance(node, ast.Assign)
        assert isinstance(node.value, ast.Call)
        assert ast.unparse(node.value.func) == "registry.by_name"
        given = [*node.value.args, *(keyword.value for keyword in node.value.keywords)]
        assert all(isinstance(argument, ast.Constant) for argument in given)


def assert_types_only(source: str) -> None:
    """A stub declares classes, fields, constants and `by_name`; nothing is called but `jd.record`."""
    tree = ast.parse(source)
    assert {type(node).__name__ for node in ast.walk(tree)} <= _DECLARATIONS | {"FunctionDef", "Import"}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            assert node.module in ("enum", "jauspy.codec")
        if isinstance(node, ast.Import):
            assert [alias.name for alias in node.names] == ["typing"]
        if isinstance(node, ast.Call):
            assert ast.unparse(node) in ("jd.record()", "jd.record(kw_only=True)")
        if isinstance(node, ast.FunctionDef):
            assert (node.name, ast.unparse(node.body)) == ("by_name", "...")


def loaded(file: Path) -> Registry | None:
    """What the file defines; None if it is refused, in one line."""
    registry, problem = None, ""
    try:
        registry = jauspy.load(file)
    except JausError as error:
        problem = str(error)
    assert problem.isprintable()
    return registry
