"""Dependencies and checks of the code: each package has a row in docs/dependencies.md, each exclusion a reason."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from tools.audit_packages import report

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
COLUMNS = 9


def name_of(requirement: str) -> str:
    return re.split(r"[\[<>=!;~ ]", requirement, maxsplit=1)[0].lower()


def wanted() -> dict[str, set[str]]:
    """The extras of each package that pyproject.toml names."""
    found: dict[str, set[str]] = {name_of(each): {"(always)"} for each in PROJECT["project"]["dependencies"]}
    for extra, requirements in PROJECT["project"]["optional-dependencies"].items():
        for each in requirements:
            if name_of(each) != "jauspy":
                found.setdefault(name_of(each), set()).add(extra)
    return found


def rows(heading: str) -> dict[str, list[str]]:
    text = (ROOT / "docs/dependencies.md").read_text().partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    lines = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("| ")]
    return {cells[0].strip().lower(): [cell.strip() for cell in cells] for cells in lines[1:]}


def test_each_dependency_has_a_row_with_its_extras() -> None:
    table = rows("Direct")
    assert {name: set(cells[1].split(", ")) for name, cells in table.items()} == wanted()


def test_rows_are_complete() -> None:
    for heading, columns in (("Direct", COLUMNS), ("Indirect", COLUMNS - 1)):
        for name, cells in rows(heading).items():
            assert len(cells) == columns, name
            assert all(cells), name


def test_what_is_indirect_is_not_direct() -> None:
    assert not set(rows("Indirect")) & set(wanted())


def test_each_exclusion_of_bandit_has_a_reason() -> None:
    section = (ROOT / "pyproject.toml").read_text().partition("[tool.bandit]\n")[2].partition("\n[")[0]
    left_out = [line for line in section.splitlines() if line.startswith('  "')]
    assert len(left_out) == len(PROJECT["tool"]["bandit"]["skips"]) + len(PROJECT["tool"]["bandit"]["exclude_dirs"])
    assert all(re.search(r'", +# \w.{15,}', line) for line in left_out)


def test_each_exception_in_the_code_names_its_check() -> None:
    for folder in ("src", "tools"):
        for file in (ROOT / folder).rglob("*.py"):
            for line in file.read_text().splitlines():
                if "# nosec" in line:
                    assert re.search(r"# nosec B\d{3}( # |$)", line), f"{file}: {line}"


def test_the_checks_run_them() -> None:
    makefile = (ROOT / "Makefile").read_text()
    assert re.search(r"^check:.* security\b", makefile, re.MULTILINE)
    assert "make audit ||" in (ROOT / ".ci/run").read_text()


PACKAGE = {"name": "a", "version": "1", "vulns": []}
SKIPPED = {"name": "b", "skip_reason": "not found"}


def test_an_audit_that_checks_nothing_says_so() -> None:
    lines, status = report([SKIPPED, SKIPPED])
    assert status == 0
    assert lines == ["audit: nothing was checked, because the list of vulnerabilities cannot be reached"]


def test_an_audit_names_vulnerabilities_and_what_it_left_out() -> None:
    lines, status = report([PACKAGE | {"vulns": [{"id": "PYSEC-1", "fix_versions": ["2"]}]}, SKIPPED])
    assert status == 1
    assert lines == ["a 1: PYSEC-1, fixed in 2", "audit: packages: 1, vulnerabilities: 1", "audit: not checked: b"]
    assert report([PACKAGE]) == (["audit: packages: 1, vulnerabilities: 0"], 0)
