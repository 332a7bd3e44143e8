"""Sharing efforts between two tracks."""

import math

import pytest

from jauspy.platform.chassis import clamp, mix


@pytest.mark.parametrize(
    ("efforts", "tracks"),
    [
        ((0.4, 0.0), (0.4, 0.4)),
        ((0.0, 0.3), (-0.3, 0.3)),
        ((0.5, 0.2), (0.3, 0.7)),
        ((1.0, 1.0), (0.0, 1.0)),
        ((-1.0, 0.5), (-1.0, -1 / 3)),
        ((5.0, 0.0), (1.0, 1.0)),
    ],
)
def test_efforts_are_mixed_for_both_tracks(efforts: tuple[float, float], tracks: tuple[float, float]) -> None:
    assert mix(*efforts) == pytest.approx(tracks)


def test_clamp_treats_nan_as_zero() -> None:
    assert clamp(math.nan) == 0.0
    assert clamp(-math.inf) == -1.0
