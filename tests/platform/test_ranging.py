"""When a lidar scans, and what of that it can see."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import pytest

from jauspy.platform.ranging import LidarSetup, Scanner

SETUP = LidarSetup("lidar", "lidar_link", rays=8, rate=10.0, range=(0.5, 4.0))


def distances(angles: Sequence[float]) -> list[float]:
    """A metre more with every ray to the left: 0.25, 1.25 ..."""
    return [0.25 + round((angle + math.pi) / (math.tau / 8)) for angle in angles]


def test_rays_go_all_around_and_ahead() -> None:
    angles = SETUP.angles()
    assert (len(angles), angles[0], angles[4]) == (8, -math.pi, 0.0)
    assert angles[6] == pytest.approx(math.pi / 2)


def test_distances_out_of_range_are_infinite() -> None:
    scanner = Scanner(SETUP, distances)
    scanner.step(0.0)
    assert scanner.scan is not None
    assert scanner.scan.ranges == (-math.inf, 1.25, 2.25, 3.25, *[math.inf] * 4)
    assert (scanner.scan.frame, scanner.scan.time) == ("lidar_link", 0.0)


def test_scan_rate_is_independent_of_the_steps() -> None:
    scanner, times = Scanner(SETUP), []
    for step in range(500):
        scanner.step(step * 0.002)
        assert scanner.scan is not None
        assert scanner.age == pytest.approx(step * 0.002 - scanner.scan.time)
        times.append(scanner.scan.time)
    assert sorted(set(times)) == pytest.approx([n / 10 for n in range(10)])


def test_missed_scans_are_skipped() -> None:
    calls = []
    scanner = Scanner(SETUP, lambda angles: calls.append(1) or distances(angles))
    for now in (0.0, 5.0, 5.002, 5.004):
        scanner.step(now)
    assert len(calls) == 2


def test_settings_take_effect_with_the_next_step() -> None:
    scanner = Scanner(SETUP, distances)
    scanner.step(0.0)
    scanner.configure(replace(scanner.settings, start=-math.pi / 4, stop=math.pi / 2, max_range=6.0, min_range=0.1))
    scanner.step(0.01)
    assert scanner.scan is not None
    assert scanner.scan.angles == pytest.approx([-math.pi / 4, 0.0, math.pi / 4, math.pi / 2])
    assert scanner.scan.ranges == (3.25, math.inf, math.inf, math.inf)
    assert (scanner.settings.max_range, scanner.settings.min_range) == (4.0, 0.5)


def test_rate_can_only_be_reduced() -> None:
    scanner = Scanner(SETUP)
    scanner.configure(replace(scanner.settings, rate=2.0))
    seen = set()
    for step in range(100):
        scanner.step(step * 0.01)
        assert scanner.scan is not None
        seen.add(scanner.scan.time)
    assert len(seen) == 2
    scanner.configure(replace(scanner.settings, rate=50.0))
    assert scanner.settings.rate == 10.0


def test_an_inactive_lidar_has_no_scan() -> None:
    scanner = Scanner(SETUP, distances)
    scanner.step(0.0)
    scanner.configure(replace(scanner.settings, active=False))
    scanner.step(1.0)
    assert scanner.scan is None
    assert scanner.age == 0.0
    scanner.configure(replace(scanner.settings, active=True))
    scanner.step(1.01)
    assert scanner.scan is not None
