"""What is missing, late or double by the sequence numbers of an event."""

from __future__ import annotations

import pytest

from jauspy.ocu.subscription import MAX_DELAY, SequenceTracker


def reported(*numbers: int, rate: float = 10.0) -> list[int | None]:
    """What each of these numbers, one period apart, says of those before."""
    sequence, period = SequenceTracker(), 1.0 / rate
    return [sequence.missing(number & 0xFF, rate, index * period) for index, number in enumerate(numbers)]


@pytest.mark.parametrize(
    ("numbers", "missing"),
    [
        ((7, 8, 9), [0, 0, 0]),
        ((254, 255, 256, 257), [0, 0, 0, 0]),
        ((1, 2, 5, 6), [0, 0, 2, 0]),
        ((1, 3, 2, 4), [0, 1, None, 0]),
        ((1, 1, 2), [0, None, 0]),
        ((255, 256, 255, 257), [0, 0, None, 0]),
    ],
)
def test_gaps_are_counted_by_sequence_numbers(numbers, missing):
    assert reported(*numbers) == missing


@pytest.mark.parametrize("rate", [0.0, 0.1, 10.0, 100.0])
def test_no_report_counts_as_late_after_a_long_silence(rate):
    sequence = SequenceTracker()
    assert sequence.missing(0, rate, 0.0) == 0
    assert sequence.missing(201, rate, MAX_DELAY) == 200
    assert sequence.missing(202, rate, MAX_DELAY) == 0


def test_silence_limit_depends_on_the_rate():
    sequence = SequenceTracker()
    assert sequence.missing(0, 500.0, 0.0) == 0
    assert sequence.missing(151, 500.0, 0.25) is None
    assert sequence.missing(151, 500.0, 0.3) == 150
