"""Write src/jauspy/sync/facade.py: the classes of src/jauspy/ocu/ with the same methods, without `await`."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final, TypeAlias

ROOT: Final = Path(__file__).resolve().parents[1]
SOURCE: Final = ROOT / "src" / "jauspy" / "ocu"
TARGET: Final = ROOT / "src" / "jauspy" / "sync" / "facade.py"
WIDTH: Final = 120

CLASSES: Final = {
    "Subscription": "subscription",
    "Control": "control",
    "Elements": "lists",
    "CommandStream": "commands",
    "ServiceClient": "service",
    "Arm": "arm",
    "Gripper": "gripper",
    "Camera": "camera",
    "ModularArm": "cell",
    "Connector": "cell",
    "ServoModule": "cell",
    "Conveyor": "cell",
    "PartStation": "cell",
    "Lidar": "lidar",
    "Guards": "guards",
    "Planner": "planner",
    "CommsLost": "comms_lost",
    "Microphone": "sound",
    "Announcer": "sound",
    "RobotControl": "robot",
    "ComponentClient": "robot",
    "Robot": "robot",
    "OCU": "client",
}
"""The classes, and their modules; those that others return come first."""
BASES: Final = {
    "Subscription": "Facade[{name}[R]], Generic[R]",
    "Elements": "Facade[{name}], MutableSequence[Element]",
    "OCU": "OpensPortal",
}
OF_EXTRAS: Final = {"jauspy.audio.coding", "jauspy.video.frames"}
"""Modules that need packages of an extra; imported for type checkers only."""
SKIPPED: Final = {
    "OCU": {"open", "close", "watch_program", "trace", "__aenter__", "__aexit__"},
    "Control": {"on_sent", "on_ready"},
}
"""What `sync/portal.py` has, and what is the OCU's own business."""
SPECIAL: Final = {"__aenter__": "__enter__", "__aexit__": "__exit__", "__aiter__": "__iter__"}
KEPT: Final = {"__len__", "__getitem__"}
ALIASES: Final = {"Elements": {"replace": "__setitem__", "delete": "__delitem__"}}
"""What Python's own syntax calls these methods."""
WORDS: Final = (
    ("the program's event loop turns", "the program calls the OCU at least once a second"),
    ("the event loop of the program turns", "the program calls the OCU at least once a second"),
    ("When the loop stood still for a second", "When it does not"),
    ("an `async", "a `async"),
    ("async with", "with"),
    ("async for", "for"),
    ("await ", ""),
    ("jauspy.OCU(", "jauspy.sync.OCU("),
)

Function: TypeAlias = ast.FunctionDef | ast.AsyncFunctionDef


class Names:
    """Where the names of a module come from, and which of them the facade needs."""

    def __init__(self) -> None:
        self.imports: dict[str, tuple[str, str]] = {}

    def need(self, tree: ast.AST, module: str, origins: dict[str, tuple[str, str]]) -> None:
        """Import what this expression mentions, from where its module has it."""
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.isidentifier():
                raise SystemExit(f"{module}: a quoted annotation {node.value!r} is not understood")
            known = isinstance(node, ast.Name) and node.id in origins and node.id not in CLASSES
            if isinstance(node, ast.Name) and known and not node.id.startswith("Async"):
                self.imports.setdefault(node.id, origins[node.id])

    def lines(self) -> Iterator[str]:
        """The import statements."""
        by_module: dict[str, set[str]] = {}
        for module, name in self.imports.values():
            by_module.setdefault(module, set()).add(name)
        for module in sorted(by_module.keys() - OF_EXTRAS):
            yield f"from {module} import {', '.join(sorted(by_module[module]))}"
        for module in sorted(by_module.keys() & OF_EXTRAS):
            yield f"if TYPE_CHECKING:\n    from {module} import {', '.join(sorted(by_module[module]))}"


def origins(tree: ast.Module, module: str) -> dict[str, tuple[str, str]]:
    """Every name at the top of a module: from which module it is imported, or this one."""
    found: dict[str, tuple[str, str]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and node.module != "__future__":
            found |= {each.asname or each.name: (node.module, each.name) for each in node.names}
    for node in tree.body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            found[node.name] = (module, node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found[node.target.id] = (module, node.target.id)
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found[node.targets[0].id] = (module, node.targets[0].id)
    return found


def translated(text: str) -> str:
    """A docstring without the words of asynchronous code."""
    for old, new in WORDS:
        text = text.replace(old, new)
    return text


def docstring(node: Function | ast.ClassDef, indent: str) -> Iterator[str]:
    """Its lines, as they stand in the source."""
    text = ast.get_docstring(node, clean=True)
    if text:
        lines = translated(text).split("\n")
        quoted = [f'"""{lines[0]}', *lines[1:]]
        quoted[-1] += '"""' if len(lines) == 1 else ""
        yield from (f"{indent}{line}".rstrip() for line in quoted)
        if len(lines) > 1:
            yield f'{indent}"""'


def returned(annotation: ast.expr | None) -> str:
    """The annotation of what is returned, for a caller that does not await."""
    text = ast.unparse(annotation) if annotation else "None"
    if text.startswith("AsyncGenerator["):
        return text.replace("AsyncGenerator[", "Generator[").removesuffix("]") + ", None]"
    return text.replace("AsyncIterator[", "Iterator[")


def wrapped(call: str, annotation: ast.expr | None, *, is_async: bool) -> str:
    """The expression that makes of an asynchronous call what the facade returns."""
    text = ast.unparse(annotation) if annotation else "None"
    if text.startswith("AsyncGenerator["):
        return f"self._portal.iterate({call})"
    if is_async:
        call = f"self._portal.run({call})"
    if text.split("[")[0] in CLASSES:
        return f"{text.split('[')[0]}(self._portal, {call})"
    if text.startswith("tuple[") and text[6:].split(",")[0] in CLASSES:
        return f"tuple({text[6:].split(',')[0]}(self._portal, each) for each in {call})"
    return call


def parameters(arguments: ast.arguments) -> list[str]:
    """Each with its annotation and default, as in the source."""
    positional = [*arguments.posonlyargs, *arguments.args]
    missing = len(positional) - len(arguments.defaults)
    found = [
        _parameter(each, None if index < missing else arguments.defaults[index - missing])
        for index, each in enumerate(positional)
    ]
    if arguments.vararg:
        found.append(f"*{_parameter(arguments.vararg, None)}")
    elif arguments.kwonlyargs:
        found.append("*")
    found += [_parameter(*pair) for pair in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)]
    if arguments.kwarg:
        found.append(f"**{_parameter(arguments.kwarg, None)}")
    return found


def _parameter(argument: ast.arg, default: ast.expr | None) -> str:
    text = argument.arg + (f": {ast.unparse(argument.annotation)}" if argument.annotation else "")
    if default is None:
        return text
    return f"{text}{' = ' if argument.annotation else '='}{ast.unparse(default)}"


def passed(arguments: ast.arguments) -> str:
    """The arguments of a call that hands all of them on."""
    found = [each.arg for each in [*arguments.posonlyargs, *arguments.args][1:]]
    found += [f"*{arguments.vararg.arg}"] if arguments.vararg else []
    found += [f"{each.arg}={each.arg}" for each in arguments.kwonlyargs]
    found += [f"**{arguments.kwarg.arg}"] if arguments.kwarg else []
    return ", ".join(found)


def head(name: str, arguments: ast.arguments, result: str) -> Iterator[str]:
    """The `def` line, broken when it is long."""
    given = parameters(arguments)
    line = f"    def {name}({', '.join(given)}) -> {result}:"
    if len(line) <= WIDTH:
        yield line
        return
    yield f"    def {name}("
    yield from (f"        {each}," for each in given)
    yield f"    ) -> {result}:"


class ClassWriter:
    """One class of the facade."""

    def __init__(self, node: ast.ClassDef, module: str, origins: dict[str, tuple[str, str]], names: Names) -> None:
        self.node, self.module, self.origins, self.names = node, module, origins, names

    def lines(self) -> Iterator[str]:
        """The whole class."""
        name, original = self.node.name, f"_{self.node.name}"
        base = BASES.get(name, "Facade[{name}]").format(name=original)
        yield f"class {name}({base}):"
        yield from docstring(self.node, "    ")
        for member in self.node.body:
            if isinstance(member, ast.FunctionDef | ast.AsyncFunctionDef):
                yield from self._member(member)

    def _member(self, node: Function) -> Iterator[str]:
        if node.name in SKIPPED.get(self.node.name, ()):
            return
        if node.name == "__init__":
            yield from self._constructor(node)
            yield from self._attributes(node)
        elif not node.name.startswith("_") or node.name in SPECIAL or node.name in KEPT:
            self._need(node)
            yield from self._method(node)

    def _method(self, node: Function) -> Iterator[str]:
        is_property = any(ast.unparse(each) == "property" for each in node.decorator_list)
        yield ""
        yield from (f"    @{ast.unparse(each)}" for each in node.decorator_list)
        if any(ast.unparse(each) == "overload" for each in node.decorator_list):
            *start, last = head(node.name, node.args, returned(node.returns))
            yield from start
            yield f"{last} ..."
            return
        yield from head(SPECIAL.get(node.name, node.name), node.args, returned(node.returns))
        yield from docstring(node, "        ")
        yield f"        {self._body(node, is_property=is_property)}"
        alias = ALIASES.get(self.node.name, {}).get(node.name)
        if alias:
            yield f"\n    {alias} = {node.name}"

    def _body(self, node: Function, *, is_property: bool) -> str:
        if node.name == "__aiter__":
            return "return self._portal.iterate(self._async)"
        if node.name == "__aexit__":
            return f"self._portal.leave(self._async.__aexit__({passed(node.args)}))"
        call = f"self._async.{node.name}" + ("" if is_property else f"({passed(node.args)})")
        is_async = isinstance(node, ast.AsyncFunctionDef)
        if node.name == "__aenter__":
            return f"self._portal.run({call})\n        return self"
        expression = wrapped(call, node.returns, is_async=is_async)
        return expression if returned(node.returns) == "None" else f"return {expression}"

    def _constructor(self, node: Function) -> Iterator[str]:
        """Only the OCU is made by its user; the others come from it."""
        if self.node.name != "OCU":
            return
        self._need(node)
        yield ""
        yield from head("__init__", node.args, "None")
        yield f"        super().__init__(Portal(), _OCU({passed(node.args)}))"

    def _attributes(self, node: Function) -> Iterator[str]:
        """Public attributes become properties, of the type they are given in `__init__`."""
        types = {each.arg: each.annotation for each in [*node.args.args, *node.args.kwonlyargs]}
        for index, statement in enumerate(node.body):
            target, annotation = _attribute(statement, types)
            if target is None or target.startswith("_"):
                continue
            if annotation is None:
                raise SystemExit(f"{self.module}: {self.node.name}.{target} needs an annotation")
            self.names.need(annotation, self.module, self.origins)
            yield "\n    @property"
            yield f"    def {target}(self) -> {ast.unparse(annotation)}:"
            following = node.body[index + 1] if index + 1 < len(node.body) else None
            match following:
                case ast.Expr(value=ast.Constant(value=str(text))):
                    yield f'        """{translated(text)}"""'
            yield f"        return self._async.{target}"

    def _need(self, node: Function) -> None:
        given = node.args
        starred = [each for each in (given.vararg, given.kwarg) if each is not None]
        for each in [*given.posonlyargs, *given.args, *given.kwonlyargs, *starred]:
            if each.annotation:
                self.names.need(each.annotation, self.module, self.origins)
        defaults = [each for each in [*given.defaults, *given.kw_defaults] if not isinstance(each, ast.Constant)]
        for expression in [*defaults, node.returns, *node.decorator_list]:
            if expression:
                self.names.need(expression, self.module, self.origins)


def _attribute(statement: ast.stmt, types: dict[str, ast.expr | None]) -> tuple[str | None, ast.expr | None]:
    """The attribute of `self` that a statement sets, and its type."""
    target: ast.expr | None = None
    if isinstance(statement, ast.AnnAssign):
        target = statement.target
    elif isinstance(statement, ast.Assign):
        target = statement.targets[0]
    if not isinstance(target, ast.Attribute):
        return None, None
    if isinstance(statement, ast.AnnAssign):
        return target.attr, statement.annotation
    assert isinstance(statement, ast.Assign)
    value = statement.value
    if isinstance(value, ast.Name):
        return target.attr, types.get(value.id)
    if isinstance(value, ast.Constant) and value.value is not None:
        return target.attr, ast.Name(type(value.value).__name__)
    return target.attr, None


def generated() -> str:
    """The text of the facade."""
    names, classes, originals = Names(), [], []
    names.imports |= {
        "Generic": ("typing", "Generic"),
        "TYPE_CHECKING": ("typing", "TYPE_CHECKING"),
        "MutableSequence": ("collections.abc", "MutableSequence"),
        "Generator": ("collections.abc", "Generator"),
        "Iterator": ("collections.abc", "Iterator"),
        "Portal": ("jauspy.sync.portal", "Portal"),
        "Facade": ("jauspy.sync.portal", "Facade"),
        "OpensPortal": ("jauspy.sync.portal", "OpensPortal"),
    }
    for name, file in CLASSES.items():
        module = f"jauspy.ocu.{file}"
        tree = ast.parse((SOURCE / f"{file}.py").read_text())
        node = next(each for each in tree.body if isinstance(each, ast.ClassDef) and each.name == name)
        classes.append("\n".join(ClassWriter(node, module, origins(tree, module), names).lines()))
        originals.append(f"from {module} import {name} as _{name}")
    return "\n".join(
        [
            '"""`jauspy.ocu` without `await`. Generated by tools/generate_sync.py; do not edit."""',
            "",
            "from __future__ import annotations",
            "",
            *names.lines(),
            *sorted(originals),
            "",
            "",
            "\n\n\n".join(classes),
            "",
        ]
    )


if __name__ == "__main__":
    TARGET.write_text(generated())
    print(f"wrote {TARGET.relative_to(ROOT)}", file=sys.stderr)
