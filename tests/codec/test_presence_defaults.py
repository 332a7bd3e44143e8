"""Queries ask for every field of their report unless they are told otherwise."""

from __future__ import annotations

import pytest
from tests.helpers.sampling import sampled

from jauspy.codec.layout import Composite
from jauspy.errors import EncodeError
from jauspy.messages import registry
from jauspy.messages.manipulator import QueryManipulatorSpecifications
from jauspy.messages.mobility import QueryGlobalPose, QueryLocalPose, QueryVelocityState

EVERY = [
    each
    for entry in registry.entries
    for each in [registry.by_name(entry.name, service=entry.service, version=entry.version)]
    if each.IS_QUERY and getattr(each, "REPORT", None) is not None
]


def test_query_without_arguments_asks_for_all_fields():
    assert QueryLocalPose() == QueryLocalPose(0x1FF)
    assert QueryLocalPose().encode().hex() == "0324ff01"
    assert QueryGlobalPose().presence_vector == 0x1FF
    assert QueryVelocityState().presence_vector == 0x1FF
    assert QueryManipulatorSpecifications().presence_vector == 0b11
    assert QueryLocalPose(0x43).presence_vector == 0x43


@pytest.mark.parametrize("query", sampled(EVERY, 60), ids=lambda query: f"{query.NAME}-{query.VERSION}")
def test_default_covers_the_optional_fields_of_the_report(query):
    layout, report = query.layout(), query.REPORT.layout()
    if not isinstance(layout, Composite) or [slot.name for slot in layout.slots] != ["presence_vector"]:
        return
    optional = sum(slot.optional for slot in report.slots)
    if optional:
        assert query().presence_vector == (1 << optional) - 1
        assert query.decode(query().encode()) == query()
    else:
        with pytest.raises((TypeError, EncodeError)):
            query()
