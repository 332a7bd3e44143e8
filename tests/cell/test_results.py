"""Results of swings and of ISO 9283 as figures, sentences, pages and pictures."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the extra 'cell-measurements' is not installed")

from jauspy.cell import report
from jauspy.cell.calibration import Parameters
from jauspy.cell.iso9283 import Accuracy, Arrival, Report, Run
from jauspy.cell.measurements import Measured
from jauspy.cell.report import Promise, Section, figure, page, plot_trials
from jauspy.cell.swing import AT_REST, Swing, SwingComparison
from jauspy.cell.trials import summarised
from jauspy.errors import ConfigError
from jauspy.platform.modular.arm import ArmController


def run(name: str, *accuracies: float) -> Run:
    return Run(name, tuple(Accuracy(each, each / 10.0, 2.0 * each, each / 5.0) for each in accuracies))


def measured(calibrated: float) -> Report:
    nothing = Parameters(np.zeros(5), np.zeros((8, 6)), np.zeros(8))
    arms = run("modular arm", 0.02, 0.04), run("modular arm, reported", 0.004, 0.003)
    return Report((run("UR10", 0.0001, 0.0003),), *arms, (run("modular arm, calibrated", calibrated, 0.0001),), nothing)


class TestIso9283:
    def test_the_worst_pose_counts_for_each_figure(self) -> None:
        poses = (Accuracy(0.1, 0.001, 0.2, 0.003), Accuracy(0.05, 0.002, 0.1, 0.004))
        assert Run("UR10", poses).worst == Accuracy(0.1, 0.002, 0.2, 0.004)

    def test_a_calibration_that_improves_five_times_succeeds(self) -> None:
        found = measured(0.002).measured(3)
        assert found.success
        assert found.failure == ""
        assert found.values["improvement"] == pytest.approx(20.0)
        assert found.values["improvement on reports"] == pytest.approx(2.0)
        assert found.values["ap UR10"] == 0.0003
        assert found.values["rp angle modular arm"] == pytest.approx(0.008)

    def test_one_that_improves_less_says_how_much(self) -> None:
        found = measured(0.01).measured(3)
        assert not found.success
        assert found.failure == "calibration improves accuracy 4.0 times; at least 5 are wanted"

    def test_each_pose_has_a_row(self) -> None:
        rows = measured(0.002).measured(3).rows
        assert [row["pose"] for row in rows] == ["P1", "P2"] * 4
        assert {row["arm"] for row in rows} >= {"UR10", "modular arm, calibrated"}

    def test_speeds_have_figures_of_their_own(self) -> None:
        report = measured(0.002)
        slow = Run("UR10", report.ur10[0].poses, 0.5, (Arrival(0.2, 0.001), Arrival(0.1, 0.002)), out_of_reach=0.3)
        found = Report((*report.ur10, slow), report.assembled, report.reported, report.calibrated, report.parameters)
        values = found.measured(3).values
        assert values["stabilisation UR10, at 50% of its speed"] == 0.2
        assert values["overshoot of UR10, at 50% of its speed"] == 0.002
        assert values["attitude out of reach UR10, at 50% of its speed"] == 0.3
        assert "attitude out of reach UR10" not in values


def swing(controller: ArmController, speeds: np.ndarray) -> Swing:
    times = 0.01 * np.arange(len(speeds))
    return Swing(controller, times, np.stack([0.6 * speeds, 0.0 * speeds, 0.8 * speeds], axis=1), end=0.3, payload=0.3)


class TestSwing:
    def test_the_speed_is_the_magnitude_about_all_axes(self) -> None:
        assert swing(ArmController.PID, np.array([1.0, 0.5])).speeds == pytest.approx([1.0, 0.5])

    def test_an_arm_at_rest_from_the_start_settles_at_once(self) -> None:
        found = swing(ArmController.PID, np.zeros(100))
        assert (found.settled, found.settled_after_end, found.overshoot) == (0.0, 0.0, 0.0)
        assert found.came_to_rest

    def test_what_moves_once_more_has_not_settled_before(self) -> None:
        speeds = np.zeros(100)
        speeds[[3, 60]] = 2.0 * AT_REST
        assert swing(ArmController.PID, speeds).settled == pytest.approx(0.61)

    def test_a_swing_without_any_overshoot_to_compare_with_fails_with_a_sentence(self) -> None:
        moving = np.where(np.arange(100) < 40, 1.0, 0.0)
        found = SwingComparison(swing(ArmController.PID, np.zeros(100)), swing(ArmController.MODEL, moving)).measured(1)
        assert not found.success
        assert found.values["overshoot_ratio"] == math.inf
        assert found.failure == "at rest 0.0 times sooner, overshoot inf of that of PID"

    def test_two_without_overshoot_do_not_differ(self) -> None:
        still = np.zeros(100)
        assert SwingComparison(swing(ArmController.PID, still), swing(ArmController.MODEL, still)).overshoot == 1.0


class TestPage:
    def test_a_promise_that_is_not_kept_says_so(self) -> None:
        text = page("t", "l", [Promise("a", "1", "2", kept=False), Promise("b", "1", "1", kept=True)], [])
        assert text.count('class="no">not kept') == 1
        assert text.count('class="yes">kept') == 1
        assert text.index("not kept") < text.index('"yes"')

    def test_everything_from_outside_is_text(self) -> None:
        evil = "<script>alert(1)</script>"
        sections = [Section(evil, evil, [(evil,), (evil,)])]
        text = page(evil, evil, [Promise(evil, evil, evil, kept=True)], sections)
        assert "<script" not in text
        assert text.count("&lt;script&gt;") == 10

    def test_numbers_are_aligned(self) -> None:
        text = page("t", "l", [], [Section("s", table=[("a", "b", "c"), ("1.5", "-2", "1.5 m")])])
        assert '<td class="number">1.5</td><td class="number">-2</td><td>1.5 m</td>' in text

    def test_a_film_is_inside_and_one_that_is_too_large_is_named(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        film = tmp_path / "a&b.mp4"
        film.write_bytes(b"moov")
        assert "data:video/mp4;base64,bW9vdg==" in page("t", "l", [], [Section("s", film=film)])
        monkeypatch.setattr(report, "MAX_FILM", 3)
        text = page("t", "l", [], [Section("s", film=film)])
        assert "<video controls" not in text
        assert "<p>Film: a&amp;b.mp4</p>" in text

    def test_files_that_are_not_there_are_left_out(self, tmp_path: Path) -> None:
        text = page("t", "l", [], [Section("s", plots=[tmp_path / "no.svg"], film=tmp_path / "no.mp4")])
        assert "<img" not in text
        assert "<video controls" not in text

    def test_pictures_have_their_type(self, tmp_path: Path) -> None:
        plot = tmp_path / "plot.png"
        plot.write_bytes(b"PNG")
        assert '<img alt="plot" src="data:image/png;base64,' in page("t", "l", [], [Section("s", plots=[plot])])


class TestPlots:
    @pytest.fixture(autouse=True)
    def _matplotlib(self) -> None:
        pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")

    @pytest.mark.parametrize("rows", [[], [{"error": 0.001}, {"error": 0.002}, {"other": 1.0}]])
    def test_trials_are_drawn_with_and_without_errors_of_parts(
        self, tmp_path: Path, rows: list[dict[str, float]]
    ) -> None:
        results = [Measured(1, "lift", success=True, duration=8.0, rows=rows), Measured(2, "lift", failure="no box")]
        path = tmp_path / "new" / "trials.svg"
        plot_trials(results, summarised(results), path)
        assert "<svg" in path.read_text()

    def test_a_figure_that_fails_leaves_no_file_and_no_open_figure(self, tmp_path: Path) -> None:
        pyplot = pytest.importorskip("matplotlib.pyplot")
        before = pyplot.get_fignums()
        with pytest.raises(ValueError, match="on purpose"), figure(tmp_path / "plot.svg"):
            raise ValueError("on purpose")
        assert pyplot.get_fignums() == before
        assert not (tmp_path / "plot.svg").exists()


def test_without_matplotlib_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> object:
        raise ImportError(name)

    monkeypatch.setattr(report, "import_module", missing)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[plot\]'"), figure(tmp_path / "plot.svg"):
        pass
