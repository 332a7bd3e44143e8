"""No text of a robot, a file or a user is put into markup, properties or scripts: those are literals, or come from
`jauspy.console.markup`."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import jauspy.console

CONSOLE = Path(jauspy.console.__file__).parent
EXEMPT = "markup.py"
TAKING_KEYS = ("props", "style", "classes", "add_slot", "add_resource", "get_computed_prop", "teleport")
TAKING_MARKUP = ("html", "set_content", "add_head_html", "add_body_html", "markdown", "restructured_text", "mermaid")
TAKING_CODE = ("run_javascript", "run_method", "run_chart_method", "run_layer_method", "run_map_method")
TAKING_ADDRESSES = ("link", "image", "interactive_image", "icon", "avatar", "add_css", "add_scss", "add_sass")
LITERALS_ONLY = frozenset(TAKING_KEYS + TAKING_MARKUP + TAKING_CODE + TAKING_ADDRESSES)
"""Methods and functions of NiceGUI whose text becomes keys, markup, code or addresses."""
JS_SINKS = re.compile(
    r"\beval\(|\bnew Function\b|outerHTML|insertAdjacentHTML|document\.write|set(Timeout|Interval)\([\"'`]"
)
INNER_HTML = "element.innerHTML = `"
"""The instruments over the picture: an SVG of numbers that are written in the script."""


def problems(source: str) -> Iterator[str]:
    """The calls in a program that the rule forbids."""
    tree = ast.parse(source)
    constants = _constants(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr in ("_props", "_style", "_classes", "default_props"):
            yield f"{node.lineno}: {node.attr}"
        if isinstance(node, ast.Subscript | ast.Call) and _changes_props(node):
            yield f"{node.lineno}: props are set"
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        keywords = {each.arg: each.value for each in node.keywords}
        given = [*node.args, *keywords.values()] if name in LITERALS_ONLY else []
        if name == "element":  # the name of an HTML element or of a component
            given += node.args
        if name == "on":
            given += [value for key, value in keywords.items() if key == "js_handler"]
        if name in ("attributes", "style_number", "call", "page_files") and None in keywords:
            yield f"{node.lineno}: {name}(**…)"
        if name == "style_number":
            given += node.args[1:2]
        if name == "call":
            given += node.args[:1]
        for value in given:
            if not _is_literal(value, constants):
                yield f"{node.lineno}: {name}({ast.unparse(value)})"


def _constants(tree: ast.Module) -> set[str]:
    """The names to which the module assigns a literal, and nothing else anywhere."""
    names = [node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)]
    names += [node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)]
    given = [node for node in tree.body if isinstance(node, ast.AnnAssign) and isinstance(node.value, ast.Constant)]
    return {node.target.id for node in given if isinstance(node.target, ast.Name) and names.count(node.target.id) == 1}


def _is_literal(value: ast.expr, constants: set[str]) -> bool:
    """True for constants of the program, and for the choice between some."""
    if isinstance(value, ast.IfExp):
        return _is_literal(value.body, constants) and _is_literal(value.orelse, constants)
    if isinstance(value, ast.Name):
        return value.id in constants
    return isinstance(value, ast.Constant)


def _changes_props(node: ast.Subscript | ast.Call) -> bool:
    """True for `element.props[…] = …` and `element.props.update(…)`; reading them is fine."""
    if isinstance(node, ast.Subscript):
        return isinstance(node.ctx, ast.Store) and isinstance(node.value, ast.Attribute) and node.value.attr == "props"
    inner = node.func.value if isinstance(node.func, ast.Attribute) else None
    return isinstance(inner, ast.Attribute) and inner.attr == "props"


@pytest.mark.slow
def test_the_console_keeps_the_rule() -> None:
    found = {
        path.name: list(problems(path.read_text())) for path in sorted(CONSOLE.rglob("*.py")) if path.name != EXEMPT
    }
    assert len(found) > 30
    assert {name: each for name, each in found.items() if each} == {}


@pytest.mark.parametrize(
    "mutant",
    [
        "ui.label('x').props(f'aria-label=\"{name}\"')",
        "ui.label('x').props('aria-label=\"%s\"' % name)",
        "ui.label('x').props('aria-label=\"{}\"'.format(name))",
        "ui.label('x').props('aria-label=' + name)",
        "ui.label('x').props(name)",
        "ui.label('x').props(add=name)",
        "ui.label('x').props(remove=f'{name}')",
        "ui.label('x').props(*names)",
        "ui.label('x').props(**names)",
        "ui.label('x').props(' '.join(names))",
        "ui.label('x').props(literal if name else name)",
        "text = 'dense'\ntext = name\nui.label('x').props(text)",
        "def build(TEXT):\n    ui.label('x').props(TEXT)",
        "for text in names:\n    ui.html(text)",
        "ui.label('x').props[name] = 1",
        "ui.label('x').props.update({name: 1})",
        "ui.label('x')._props[name] = 1",
        "ui.label('x').style(f'--x: {name}')",
        "ui.label('x').classes(replace=f'chip {name}')",
        "ui.html(f'<b>{name}</b>', sanitize=False)",
        "html(name)",
        "ui.html('').set_content(name)",
        "ui.run_javascript(f'jauspy.go({name})')",
        "ui.context.client.run_javascript(name)",
        "ui.add_head_html(name)",
        "ui.add_body_html('<script>%s</script>' % name)",
        "ui.markdown(name)",
        "ui.table(rows=[]).add_slot('body', f'<td>{name}</td>')",
        "ui.button('x').on('click', js_handler=f'() => {name}')",
        "ui.element(name)",
        "ui.link('x', name)",
        "chart.run_chart_method(name)",
        "attributes(element, **{name: 1})",
        "style_number(element, name, 1)",
        "call(name, 1)",
        "call(f'jauspy.{name}')",
    ],
)
def test_a_mutant_is_caught(mutant: str) -> None:
    assert list(problems(mutant))


@pytest.mark.parametrize(
    "program",
    [
        "ui.label(name).props('dense').classes('a').tooltip(name)",
        "ui.html('<b>x</b>', sanitize=False)",
        "TEXT: Final = '<b>x</b>'\nui.html(TEXT, sanitize=False)",
        "ui.label('x').classes(add='chosen' if name else '', remove='' if name else 'chosen')",
        "attributes(element, aria_label=name, min=low)",
        "call('jauspy.world.setRoute', points)",
        "values['x'].get(name)",
    ],
)
def test_what_is_safe_is_allowed(program: str) -> None:
    assert list(problems(program)) == []


def test_the_scripts_of_the_page_make_no_markup_of_text() -> None:
    for path in sorted((CONSOLE / "static").glob("*.js")):
        lines = [each.split(" // ")[0] for each in path.read_text().splitlines() if not each.lstrip().startswith("//")]
        found = [each for each in lines if JS_SINKS.search(each) or ("innerHTML" in each and INNER_HTML not in each)]
        assert found == [], path.name


def test_no_markup_has_a_handler_in_an_attribute() -> None:
    for path in CONSOLE.rglob("*.py"):
        assert not re.search(r"<[a-z][^>]*\son\w+=", path.read_text()), path.name
