"""Scores of kits, confidence of trials, and the page of results."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.campaigns import wilson
from jauspy.cell.kitting import MAX_ANGLE, MAX_DISTANCE, drawn_order, score
from jauspy.cell.measurements import Measured, figure_text
from jauspy.cell.report import Plot, Promise, Section, Table, page
from jauspy.cell.trials import summarised

GOOD = (0.001, 0.01)


def test_a_whole_kit_has_three_points_a_product() -> None:
    assert score(dict.fromkeys(range(4), GOOD), 4) == 12


def test_a_product_out_of_its_pose_has_one_point_and_no_bonus() -> None:
    assert score({0: GOOD, 1: (MAX_DISTANCE + 0.001, 0.0)}, 2) == 3
    assert score({0: GOOD, 1: (0.0, MAX_ANGLE + 0.01)}, 2) == 3


def test_missing_products_and_other_things_cost_the_bonus() -> None:
    assert score({0: GOOD}, 2) == 2
    assert score({0: GOOD, 1: GOOD}, 2, extra=1) == 4
    assert score({}, 2) == 0


def test_orders_are_drawn_with_a_seed() -> None:
    assert drawn_order(3) == drawn_order(3)
    assert drawn_order(3) != drawn_order(4)
    assert [each.type for each in drawn_order(3)].count("box") == 2


def test_the_interval_of_a_rate() -> None:
    assert wilson(95, 100) == pytest.approx((0.888, 0.978), abs=1e-3)
    assert wilson(0, 0) == (0.0, 1.0)
    low, high = wilson(20, 20)
    assert 0.8 < low < high == 1.0


def test_a_summary_names_the_failures() -> None:
    good = Measured(1, "lift", success=True, duration=10.0, cpu=5.0)
    results = [good, Measured(0, "lift", failure="no box", cpu=1.0)]
    found = summarised(results)
    assert (found.successes, found.runs, found.rate) == (1, 2, 0.5)
    assert found.failures == ((0, "no box"),)
    assert found.duration == 10.0


def test_what_differs_from_run_to_run_is_not_compared() -> None:
    assert Measured(1, "lift", cpu=1.0).comparable() == Measured(1, "lift", cpu=2.0).comparable()


def test_the_page_has_everything_inside_and_is_escaped(tmp_path: Path) -> None:
    plot = tmp_path / "plot.svg"
    plot.write_text("<svg/>")
    sections = [Section("one", "text", [Table("t", [("a",), ("1",)])], [Plot(plot, "one")])]
    text = page("cell", "lead", [Promise("<b>", "95 %", "96 %", kept=True)], sections)
    assert "http://" not in text
    assert "https://" not in text
    assert "<b>" not in text
    assert "&lt;b&gt;" in text
    assert "data:image/svg+xml;base64," in text
    assert 'class="yes">kept' in text


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("clearance", 0.0104, "10.4 mm"),
        ("driven", 2.63, "2.63 m"),
        ("largest_tilt", 0.01, "0.573 degrees"),
        ("ap angle UR10", 0.01, "0.573 degrees"),
        ("ap UR10", 0.0001, "0.1 mm"),
        ("settled_pid", 2.87, "2.87 s"),
        ("settled_sooner", 7.36, "7.36"),
        ("overshoot_model", 0.15, "0.15 rad/s"),
        ("retries", 2.0, "2"),
    ],
)
def test_figures_have_units(name: str, value: float, text: str) -> None:
    assert figure_text(name, value) == text
