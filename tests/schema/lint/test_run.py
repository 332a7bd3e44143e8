"""The linter as a whole: it goes on where the loader stops. That it finds what the loader refuses: test_errors.py."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.schema import builtin_paths
from jauspy.schema.lint import REFUSED, RULES, UNREADABLE, lint

PECULIAR = {
    ("CBRNSensor.xml", "conflicting-message"),
    ("MeasurementSensor.xml", "conflicting-message"),
    ("MeasurementSensorClient.xml", "conflicting-message"),
    ("CBRNSensor.xml", "presence-vector"),
    ("CBRNSensor.xml", "duplicate-message"),
    ("DigitalControl.xml", "uncontrolled-command"),
    ("Drawing.xml", "tag-limits"),
    ("types.xml", "tag-limits"),
    ("MissionSpooler.xml", "output-trigger"),
    ("MilitaryIlluminationService.xml", "duplicate-message"),
    ("Communicator.xml", "scale-type"),
}
"""What is wrong in the published definitions themselves: it is on the wire, so it stays."""


@pytest.mark.slow
def test_built_in_definitions_have_published_mistakes_only():
    found = [finding for finding in lint(builtin_paths()) if (Path(finding.file).name, finding.code) not in PECULIAR]
    assert [str(finding) for finding in found] == []


def test_lint_codes_are_unique():
    codes = [rule.code for rule in (*RULES, REFUSED)]
    assert len(set(codes)) == len(codes)
    assert all(code.replace("-", "").isalpha() and code.islower() for code in codes)


def test_mistakes_of_many_files_are_sorted(jsidl):
    field = '<fixed_field name="N" field_type="byte" field_units="one" optional="true"/>'
    for name in ("B", "A"):
        jsidl.service(name=name, urn=f"urn:test:{name}", body=f'<record name="R">\n{field}\n{field}</record>')
    found = [finding for finding in lint(jsidl.paths) if finding.severity == "error"]
    assert [(finding.file, finding.code) for finding in found if finding.code == "presence-vector"] == [
        (str(path), "presence-vector") for path in sorted(jsidl.paths) for _ in range(2)
    ]
    assert found == sorted(found)
    assert str(found[0]).startswith(f"{jsidl.paths[1]}:")
    assert ": error: " in str(found[0])


def test_an_unreadable_file_does_not_hide_the_others(jsidl):
    broken = jsidl.file("broken.xml", "<service_def>\n<oops")
    jsidl.service(body='<list name="L"><count_field field_type_unsigned="unsigned byte"/><record name="R"/></list>')
    codes = {(finding.file, finding.code) for finding in lint(jsidl.paths)}
    assert (str(broken), UNREADABLE) in codes
    assert (str(jsidl.paths[1]), "missing-count") in codes


def test_mistake_inside_a_malformed_part_is_found(jsidl):
    jsidl.service(
        body='<record name="R" colour="red"><bit_field name="B" field_type_unsigned="unsigned byte">'
        '<sub_field name="S"><bit_range from_index="1" to_index="9"/></sub_field></bit_field></record>'
    )
    assert {finding.code for finding in lint(jsidl.paths) if finding.severity == "error"} == {"grammar", "bit-range"}


def test_unreadable_types_and_references_to_them_are_reported(jsidl):
    """A file that breaks the grammar is checked as far as it goes, whatever is missing."""
    jsidl.service(
        types='<declared_type_set_ref name="x"/>\n<record name="R"><value_set/></record>\n<record><oops/></record>',
        body='<declared_record name="Use" declared_type_ref="R"/>',
        messages=None,
    )
    behavior = '<state_machine name="M"><state name="A"><transition name="T"/></state></state_machine>'
    jsidl.service(name="B", urn="urn:test:B", events=f"<protocol_behavior>{behavior}</protocol_behavior>")
    jsidl.file("nameless.xml", '<declared_type_set xmlns="urn:jaus:jsidl:1.1" name="t"/>')
    errors = {finding.code for finding in lint(jsidl.paths) if finding.severity == "error"}
    assert errors == {"grammar"}
