"""`jauspy schema lint`: check definitions for mistakes that break other tools."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Final

import typer
from lxml.etree import _Element as Element
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.console import print_table
from jauspy.cli.options import Json
from jauspy.codec.build import build
from jauspy.codec.names import attribute, constant, snake
from jauspy.errors import SchemaError
from jauspy.schema import builtin_paths
from jauspy.schema.document import location
from jauspy.schema.lint import RULES, UNREADABLE, LintContext, LintFinding, LintRule, Problem, lint as run
from jauspy.schema.lint.fields import unbounded_list
from jauspy.schema.lint.messages import problem_of
from jauspy.schema.loader import find_files, load_own

_CONTAINERS: Final = ("record", "sequence", "variant", "bit_field")
_NO_MEMBERS: Final = frozenset(("presence_vector", "vtag_field"))


def colliding_names(context: LintContext) -> Iterator[Problem]:
    """JAUS names that become the same Python name."""
    for element, _ in context.elements(*_CONTAINERS):
        members = (part for part in element if part.tag not in _NO_MEMBERS)
        yield from _collisions(members, "name", attribute, f"in '{element.get('name')}'")
    for element, _ in context.elements("value_set"):
        holder = next(
            (ancestor.get("name") for ancestor in (element, *element.iterancestors()) if ancestor.get("name")), ""
        )
        yield from _collisions(element.iterchildren("value_enum"), "enum_const", constant, f"in '{holder}'")
    for service in context.services():
        seen: dict[str, Element] = {}
        messages = (seen.setdefault(part.get("name", ""), part) for part in context.messages(service))
        yield from _collisions(messages, "name", snake, f"in service '{service.get('name')}'")


def _collisions(elements: Iterable[Element], key: str, made: Callable[[str], str], where: str) -> Iterator[Problem]:
    seen: dict[str, str] = {}
    for element in elements:
        name = element.get(key, "")
        first = seen.setdefault(made(name), name)
        if first != name:
            reason = f"'{name}' and '{first}' {where} are both {made(name)} in Python"
            yield location(element), f"{reason}; one gets a number, rename it"


def without_code(context: LintContext) -> Iterator[Problem]:
    """Definitions that load, but for which no code can be generated; another rule finds lists without bounds."""
    if any(unbounded_list(context)):
        return
    try:
        schema = load_own(context.paths)
    except SchemaError:
        return  # other rules report it
    try:
        build(schema, "checked")
    except SchemaError as error:
        yield problem_of(error)


PYTHON_RULES: Final = (
    LintRule("python-name", "warning", "names that collide in Python", colliding_names),
    LintRule("no-code", "error", "what no message class can be made of", without_code),
)


_STYLES: Final = {"error": "bold red", "warning": "yellow", "hint": "dim"}


def lint(
    *,
    files: Annotated[
        list[str] | None,
        typer.Argument(metavar="[FILE]...", help="Files, folders or patterns. Default: the built-in definitions."),
    ] = None,
    ignore: Annotated[
        list[str] | None,
        typer.Option("--ignore", metavar="CODE", help="Ignore a rule, such as missing-count; may be repeated."),
    ] = None,
    list_rules: Annotated[bool, typer.Option("--rules", help="List the rules and exit.")] = False,
    as_json: Json = False,
) -> None:
    """Check definitions for mistakes that break other tools, as FILE:LINE: severity: code: sentence.

    All mistakes in all files are reported in one run, also in files that cannot be loaded. Files may refer to built-in
    types and services.

    The exit status is 0 without findings or with hints only, 1 with warnings or errors, 2 if a file cannot be read.

    Examples:
      jauspy schema lint vendor/
      jauspy schema lint 'vendor/**/*.xml' --ignore no-description
      jauspy schema lint vendor/ --json | jq -r 'select(.severity == "error") | .message'
    """
    rules = _rules(ignore or [])
    if list_rules:
        _print_rules(rules)
        return
    findings = run(_paths(files or []), rules)
    for finding in findings:
        if as_json:
            console.print_json(asdict(finding))
        else:
            _print(finding)
    if not as_json:
        _print_summary(findings)
    if any(finding.code == UNREADABLE for finding in findings):
        raise typer.Exit(2)
    if any(finding.severity != "hint" for finding in findings):
        raise typer.Exit(1)


def _paths(files: list[str]) -> list[Path]:
    """The files to check."""
    return find_files(files) if files else builtin_paths()


def _rules(ignored: list[str]) -> Sequence[LintRule]:

    rules = (*RULES, *PYTHON_RULES)
    codes = [rule.code for rule in rules]
    for code in ignored:
        if code not in codes:
            close = get_close_matches(code, codes, 1)
            hint = f"did you mean {close[0]}?" if close else "--rules lists them"
            raise typer.BadParameter(f"there is no rule {code!r}; {hint}", param_hint="--ignore")
    return [rule for rule in rules if rule.code not in ignored]


def _print_rules(rules: Sequence[LintRule]) -> None:

    print_table(("code", "severity", "what it finds"), [(rule.code, rule.severity, rule.summary) for rule in rules])


def _print(finding: LintFinding) -> None:

    line = Text.assemble(
        f"{finding.file}:{finding.line}: ",
        (finding.severity, _STYLES[finding.severity]),
        ": ",
        (finding.code, "cyan"),
        f": {finding.message}",
    )
    console.stdout().print(line)


def _print_summary(findings: list[LintFinding]) -> None:

    counts = Counter(finding.severity for finding in findings)
    parts = [f"{number} {severity}{'s' if number > 1 else ''}" for severity, number in sorted(counts.items())]
    console.note(", ".join(parts) or "nothing found")
