"""Document types are refused, so no entity is ever expanded or fetched."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.errors import SchemaError
from jauspy.schema import load_files, loader

LAUGHS = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">\n' for i in range(1, 12))
SERVICE = (
    '<service_def xmlns="urn:jaus:jsidl:1.1" name="{0}" id="urn:x" version="1.0">'
    "<description>{0}</description></service_def>"
)

ATTACKS = {
    "billion laughs": f'<!DOCTYPE x [\n<!ENTITY l0 "ha">\n{LAUGHS}]>\n{SERVICE.format("&l11;")}',
    "external entity": f'<!DOCTYPE x [\n<!ENTITY e SYSTEM "file:///etc/passwd">]>\n{SERVICE.format("&e;")}',
    "external subset": f'<!DOCTYPE x SYSTEM "http://127.0.0.1:9/x.dtd">\n{SERVICE.format("x")}',
    "parameter entity": f'<!DOCTYPE x [<!ENTITY % p SYSTEM "http://127.0.0.1:9/p">%p;]>\n{SERVICE.format("x")}',
    "harmless": f"<!DOCTYPE x>\n{SERVICE.format('x')}",
}


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-16-be", "utf-32"])
@pytest.mark.parametrize("text", ATTACKS.values(), ids=ATTACKS.keys())
def test_document_type_is_refused(tmp_path: Path, text: str, encoding: str):
    path = tmp_path / "attack.xml"
    path.write_bytes(f'<?xml version="1.0" encoding="{encoding}"?>\n{text}'.encode(encoding))
    with pytest.raises(SchemaError, match="a document type declaration is not allowed") as caught:
        load_files([path])
    assert (caught.value.file, caught.value.line) == (str(path), 2)


def test_document_type_in_another_encoding_is_refused(tmp_path: Path):
    path = tmp_path / "attack.xml"
    path.write_bytes(
        f'<?xml version="1.0" encoding="IBM037"?>{SERVICE.format("x")}'.replace("?>", "?><!DOCTYPE x>").encode("cp037")
    )
    with pytest.raises(SchemaError):
        load_files([path])


def test_undefined_entity(tmp_path: Path):
    path = tmp_path / "entity.xml"
    path.write_text(SERVICE.format("&gone;"))
    with pytest.raises(SchemaError, match="Entity 'gone' not defined"):
        load_files([path])


def test_deep_nesting(tmp_path: Path):
    path = tmp_path / "deep.xml"
    path.write_text('<service_def xmlns="urn:jaus:jsidl:1.1">' + "<state>" * 100_000)
    with pytest.raises(SchemaError, match="not well-formed XML"):
        load_files([path])


def test_shipped_definitions_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    (tmp_path / "schemas").mkdir()
    monkeypatch.setattr(loader, "files", lambda package: tmp_path)
    with pytest.raises(SchemaError, match="reinstall jauspy"):
        loader.builtin_paths()
