"""docs/iop.md says what the definitions have and what inc1 offers; lint finds what the page says, and no more."""

from __future__ import annotations

from collections import Counter

import pytest
from tools.iop_tables import page
from tools.iop_tables.jsidl import SCHEMAS

from jauspy.schema.lint import lint

KNOWN = {
    ("MilitaryIlluminationService.xml", "duplicate-message"): 1,
    ("CBRNSensor.xml", "duplicate-message"): 1,
    ("CBRNSensor.xml", "conflicting-message"): 1,
    ("CBRNSensor.xml", "presence-vector"): 1,
    ("Communicator.xml", "scale-type"): 3,
    ("MeasurementSensor.xml", "conflicting-message"): 1,
    ("MeasurementSensorClient.xml", "conflicting-message"): 1,
}
"""Mistakes of the reference and of other public definitions, which stay."""


@pytest.mark.slow
def test_page_has_all_services_and_what_inc1_offers():
    assert len(page.services()) == 56
    assert page.PAGE.read_text("utf-8") == page.text(), "write it by: python -m tools.iop_tables page"


def test_what_is_told_of_inc1_is_of_services_of_the_profile():
    assert set(page.INC1) <= {service.id.rpartition(":")[2] for service in page.services()}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["PlatformState", "EnhancedAccessControl", "UnsolicitedHeartbeat", "PlatformMode"])
def test_services_of_the_platform_are_offered_by_the_master(name):
    assert page.offered()[f"urn:jaus:jss:iop:{name}"] == ["CM-MAS"]


@pytest.mark.slow
def test_lint_finds_nothing_but_the_mistakes_of_the_reference():
    paths = [path for name in ("iop", "exp") for path in sorted((SCHEMAS / name).rglob("*.xml"))]
    found = Counter((finding.file.rpartition("/")[2], finding.code) for finding in lint(paths))
    assert found == KNOWN
