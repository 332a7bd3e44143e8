from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.cli.schema.lint import PYTHON_RULES
from jauspy.errors import SchemaError
from jauspy.schema import load_files
from jauspy.schema.lint import RULES, lint

HEADER = (
    '<header name="H"><record name="R" optional="false"><fixed_field name="MessageID" '
    'field_type="unsigned short integer" field_units="one" optional="false"/></record></header>'
)
HERE = "<!-- here -->"


class Jsidl:
    """Writes JSIDL files, loads them, and knows in which line of them an error was planted."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.paths: list[Path] = []

    def file(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        self.paths.append(path)
        return path

    def service(
        self, *, body="", messages=None, outputs="", types="", consts="", references="", events="", behavior="",
        name="Test", urn="urn:test:Test", version="1.0", namespace="urn:jaus:jsidl:1.1",
    ) -> Path:  # fmt: skip
        if messages is None:
            messages = self.message(body)
        return self.file(
            f"{name}-{version}.xml",
            f"""<service_def xmlns="{namespace}" name="{name}" id="{urn}" version="{version}">
<description>d</description>
<assumptions>a</assumptions>
{references}
{consts}
<declared_type_set name="types">
{types}
</declared_type_set>
<message_set>
<input_set>
{messages}
</input_set>
<output_set>
{outputs}
</output_set>
</message_set>
<internal_events_set>
{events}
</internal_events_set>
<protocol_behavior is_stateless="false">
{behavior}
</protocol_behavior>
</service_def>
""",
        )

    def message(self, body: str, *, name="Msg", code="1234") -> str:
        return (
            f'<message_def name="{name}" message_id="{code}" is_command="true">\n'
            f"<description>d</description>\n{HEADER}\n"
            f'<body name="Body">\n{body}\n</body>\n<footer name="F"/>\n</message_def>'
        )

    def load(self):
        return load_files(self.paths)

    def body(self, body: str, **parts):
        """The body of the only message of a service."""
        self.service(body=body, **parts)
        return self.load().services[0].inputs[0].body

    def field(self, field: str, **parts):
        """The only field of a record that is the only body."""
        pv = '<presence_vector field_type_unsigned="unsigned byte"/>'
        return self.body(f'<record name="Rec" optional="false">{pv}\n{field}\n</record>', **parts).fields[0]

    def error(self) -> SchemaError:
        """The error of loading; it must name the line marked `here` (when one is). The linter has to find it, too."""
        with pytest.raises(SchemaError) as caught:
            self.load()
        errors = {(finding.file, finding.line) for finding in lint(self.paths) if finding.severity == "error"}
        at_the_root = caught.value.line == 1  # the linter says it of the element
        assert (caught.value.file, caught.value.line or 0) in errors or (at_the_root and errors)
        if self.marked():
            assert self.marked() == [(caught.value.file, caught.value.line)]
        return caught.value

    def marked(self) -> list[tuple[str, int]]:
        """The lines marked `here`."""
        return [
            (str(path), number)
            for path in self.paths
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
            if HERE in line
        ]

    def lint(self, code: str) -> list[str]:
        """What the linter finds under this code, at the lines marked `here` and nowhere else."""
        found = [finding for finding in lint(self.paths, (*RULES, *PYTHON_RULES)) if finding.code == code]
        assert sorted({(finding.file, finding.line) for finding in found}) == sorted(self.marked())
        return [finding.message for finding in found]


@pytest.fixture
def jsidl(tmp_path: Path) -> Jsidl:
    return Jsidl(tmp_path)
