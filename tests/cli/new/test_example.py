"""`jauspy new example`."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app

EXAMPLES = Path(__file__).parents[3] / "examples"


def new_example(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["new", "example", *arguments])
    return result.exit_code, result.output + str(result.exception or "")


@pytest.mark.slow
def test_every_file_is_listed_in_the_readme_and_can_be_written(tmp_path: Path) -> None:
    status, listed = new_example()
    assert status == 0
    names = [line.split()[0] for line in listed.splitlines()]
    assert all(len(line.split()) > 3 for line in listed.splitlines())
    for name in names:
        assert new_example(name, "-o", str(tmp_path))[0] == 0
    written = {path.name for path in tmp_path.iterdir()}
    assert written == {path.name for path in EXAMPLES.iterdir() if path.is_file()} - {"README.md"}
    assert all(f"[{name}]" in (EXAMPLES / "README.md").read_text() for name in written - {"winch.xml"})
    assert (tmp_path / "verbs.py").read_text() == (EXAMPLES / "verbs.py").read_text()


@pytest.mark.parametrize("name", ["own_service", "own_service.py"])
def test_files_that_an_example_needs_are_written_too(tmp_path: Path, name: str) -> None:
    assert new_example(name, "-o", str(tmp_path))[0] == 0
    assert {path.name for path in tmp_path.iterdir()} == {"own_service.py", "winch.xml"}


def test_one_sentence_for_a_wrong_name_and_for_a_file_that_exists(tmp_path: Path) -> None:
    assert "there is no example '../../etc/passwd'; there are: backend" in new_example("../../etc/passwd")[1]
    (tmp_path / "verbs.py").write_text("mine")
    assert "verbs.py exists" in new_example("verbs", "-o", str(tmp_path))[1]
    assert (tmp_path / "verbs.py").read_text() == "mine"
