"""A generated package is tested against the definitions that it was made from; ids and versions of others are found."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.fuzz.conftest import Decode
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.messages.core import RegisterServices

TABLE = "_table.py"
MODULE = "example/v1_0/battery.py"


@pytest.fixture
def fuzz(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., tuple[int, str]]:
    """Fuzzes a fresh package in which one text of one file was replaced by another one."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)

    def call(*arguments: str, status: int = 0) -> str:
        result = CliRunner().invoke(app, arguments)
        assert result.exit_code == status, result.output
        return result.stdout

    def run(file: str = TABLE, old: str = "", new: str = "", *, status: int = 1) -> str:
        name = f"acme_{len(list(tmp_path.iterdir()))}"
        call("new", "definition", "urn:example:Battery", "charge:percent", "-o", f"{name}.xml")
        call("schema", "generate", f"{name}.xml", "-o", name)
        path = tmp_path / name / file
        assert old in path.read_text()
        path.write_text(path.read_text().replace(old, new))
        out = call(*("fuzz", "codec", "--schemas", f"{name}.xml", "--package", name, "--cases", "60"), status=status)
        for each in list(sys.modules):
            if each.split(".")[0] == name:
                del sys.modules[each]
        return out

    return run


def test_fresh_package_has_no_findings(fuzz):
    assert "60 cases from" in fuzz(status=0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "old", "new", "sentence"),
    [
        (TABLE, "0xD002", "0xD003", "the package has the id D003h, the definition D002h"),
        (MODULE, "0xD002", "0xD003", "its class has the id D003h, the package's table D002h"),
        (MODULE, '"1.0"', '"1.1"', "its class has the version 1.1, the package's table 1.0"),
        (TABLE, '"urn:example:Battery", "1.0",', '"urn:example:Battery", "2.0",', "there is no message"),
        (TABLE, '(0xD001, "QueryBattery", "', '(0xD001, "QueryBattery", "f', "generated from other fields"),
    ],
)
def test_packages_with_other_ids_versions_or_fields_are_found(fuzz, file, old, new, sentence):
    status = 2 if "no message" in sentence else 1
    out = fuzz(file, old, new, status=status)
    assert status == 2 or sentence in out


def test_decoder_that_takes_other_ids_is_found(plant, hunt):
    def generous(right: Decode, data: bytes) -> object:
        return right(RegisterServices.CODE.to_bytes(2, "little") + data[2:], None)

    plant(generous)
    assert "foreign RegisterServices 1.1 decode" in {finding.cause for finding in hunt(40)}
