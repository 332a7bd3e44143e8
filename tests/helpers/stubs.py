"""Stubs compared with the classes that they are for: names, order, types and defaults of fields, reports, by_name."""

from __future__ import annotations

import ast
from dataclasses import MISSING, fields
from enum import IntEnum
from pathlib import Path
from typing import Any

from jauspy.codec import declare
from jauspy.codec.message import Message, Struct
from jauspy.codec.registry import Registry
from jauspy.codec.stubs import Stubs


def assert_agree(stubs: Stubs, folder: Path) -> dict[str, Any]:
    """Run the module as if it were in a folder, and compare it with its stub; returns its names."""
    found: dict[str, Any] = {"__file__": str(folder / "messages.py")}
    exec(compile(stubs.module, "messages.py", "exec"), found)
    _Comparison(ast.parse(stubs.stub), found).run(stubs)
    return found


class _Comparison:
    """A stub, and the names of its module."""

    def __init__(self, tree: ast.Module, found: dict[str, Any]) -> None:
        self.found = found
        self.declared = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        self.aliases = _assigned(tree)
        self.names = {**found, "jd": declare}

    def run(self, stubs: Stubs) -> None:
        own = [(self.found[name], self.declared[name]) for name in stubs.names.values()]
        for cls, stub in own:
            self._name_types(cls, stub)
        for cls, stub in own:
            self._compare(cls, stub)
        self._compare_by_name()

    def _name_types(self, cls: type[Struct], stub: ast.ClassDef) -> None:
        """Find the classes of type sets, which have names in the stub only."""
        for name, other in _assigned(stub).items():
            if name != "REPORT" and other not in self.names:
                self.names[other] = getattr(cls, name)
                self._name_types(self.names[other], self.declared[other])
                self._compare(self.names[other], self.declared[other])

    def _compare(self, cls: type[Struct], stub: ast.ClassDef) -> None:
        doc, assigned = ast.get_docstring(stub, clean=False), _assigned(stub)
        assert doc is None or doc.split() == (cls.__doc__ or "").split()
        if "REPORT" in cls.__dict__:
            report = assigned.pop("REPORT")
            assert cls.__dict__["REPORT"] is self.found[self.aliases.get(report, report)]
        base = ast.unparse(stub.bases[0])
        if base not in ("jd.Message", "jd.Struct"):
            assert cls.__mro__[1] is self.found[base]
            return
        assert issubclass(cls, Message) == (base == "jd.Message")
        nested = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
        for name, other in assigned.items():
            assert getattr(cls, name) is self.names[other]
        parts = {name for name, part in cls.__dict__.items() if isinstance(part, type) and name != "REPORT"}
        assert parts == {*nested, *assigned}
        for name, node in nested.items():
            part = getattr(cls, name)
            if issubclass(part, IntEnum):
                assert {key: int(value) for key, value in _assigned(node).items()} == {each.name: each for each in part}
            else:
                self._compare(part, node)
        self._compare_fields(cls, stub)

    def _compare_fields(self, cls: type[Struct], stub: ast.ClassDef) -> None:
        found: Any = fields(cls)  # type: ignore[arg-type]  # message classes are dataclasses
        listed = [node for node in stub.body if isinstance(node, ast.AnnAssign)]
        assert [ast.unparse(node.target) for node in listed] == [one.name for one in found]
        for node, one in zip(listed, found, strict=True):
            default = MISSING if node.value is None else ast.literal_eval(node.value)
            assert default is one.default or default == one.default
            kind = eval(ast.unparse(node.annotation), self.names)
            assert kind == one.type
        assert ("kw_only=True" in ast.unparse(stub.decorator_list[0])) == any(one.kw_only for one in found)

    def _compare_by_name(self) -> None:
        registry: Registry = self.found["registry"]
        (loader,) = (node for node in self.declared.values() if ast.unparse(node.bases[0]) == "jr.Registry")
        for method in loader.body[:-1]:
            assert isinstance(method, ast.FunctionDef)
            literal, result = method.args.args[1].annotation, method.returns
            assert isinstance(literal, ast.Subscript)
            assert isinstance(result, ast.Subscript)
            assert registry.by_name(ast.literal_eval(literal.slice)) is self.found[ast.unparse(result.slice)]


def _assigned(node: ast.Module | ast.ClassDef) -> dict[str, str]:
    """Names without annotation, and what they stand for."""
    return {ast.unparse(each.targets[0]): ast.unparse(each.value) for each in node.body if isinstance(each, ast.Assign)}
