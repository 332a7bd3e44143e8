"""Messages in a capture whose id means several things, or nothing."""

from __future__ import annotations

from jauspy.capture.dissect import read_message
from jauspy.messages import registry


def test_ambiguous_id_is_not_decoded() -> None:
    content = read_message(bytes.fromhex("2af900"), registry)
    assert content.message is None
    assert content.problem == (
        "message F92Ah is CBRNScanWindowConfigurationCommand of iop:CBRNSensor 1.1 or "
        "QueryMeasurement of iop:MeasurementSensor 1.1; specify the service"
    )


def test_an_unknown_id() -> None:
    assert read_message(bytes.fromhex("eeee00"), registry).problem == "unknown message EEEEh"
