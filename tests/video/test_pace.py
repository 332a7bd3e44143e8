"""When a camera counts as too slow for its quality."""

from __future__ import annotations

import pytest

pytest.importorskip("cv2", reason="the extra 'video' is not installed")

from jauspy.video.camera_worker import PACE_WINDOW, Pace


def windows(pace, count, skipped, start=0.0, rate=15.0):
    """What the pace says at each picture of that many windows, in which each picture leaves out as many."""
    period = (1 + skipped) / rate
    return [pace.is_too_slow(start + number * period, skipped) for number in range(round(count * PACE_WINDOW / period))]


def test_a_camera_that_keeps_its_rate_is_quick_enough():
    assert not any(windows(Pace(), 4, skipped=0))


def test_one_that_leaves_out_each_second_picture_is_too_slow_after_each_window():
    assert sum(windows(Pace(), 4.5, skipped=1)) == 4


def test_pictures_left_out_before_the_first_one_and_in_a_pause_do_not_count():
    pace = Pace()
    assert not pace.is_too_slow(0.0, 100)
    assert not any(windows(pace, 3, skipped=0))
    assert not pace.is_too_slow(1000.0, 500)
    assert not any(windows(pace, 3, skipped=0, start=1000.1))
