"""Results of swings and of ISO 9283 as figures, sentences, pages and pictures."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the extra 'cell-measurements' is not installed")

from jauspy import plots
from jauspy.cell import report
from jauspy.cell.calibration import Parameters
from jauspy.cell.iso9283.bench import Plan
from jauspy.cell.iso9283.characteristics import Accuracy, Arrival, Drift, DriftPoint, PathAccuracy
from jauspy.cell.iso9283.page import write_report
from jauspy.cell.iso9283.results import Report, Run
from jauspy.cell.measurements import Measured
from jauspy.cell.report import Plot, Promise, Section, Table, page, plot_trials
from jauspy.cell.swing import AT_REST, Swing, SwingComparison
from jauspy.cell.trials import summarised
from jauspy.errors import ConfigError
from jauspy.platform.modular.arm import ArmController
from jauspy.plots import figure


def run(name: str, *accuracies: float) -> Run:
    poses = tuple(Accuracy(ap, ap / 10.0, (2.0 * ap, ap, 0.0), (ap / 5.0, 0.0, 0.0)) for ap in accuracies)
    return Run(name, poses, deviations=(np.zeros((2, 3)), np.ones((2, 3))))


def measured(calibrated: float) -> Report:
    nothing = Parameters(np.zeros(5), np.zeros((8, 6)), np.zeros(8))
    arms = run("modular arm", 0.02, 0.04), run("modular arm, reported", 0.004, 0.003)
    return Report((run("UR10", 0.0001, 0.0003),), *arms, (run("modular arm, calibrated", calibrated, 0.0001),), nothing)


class TestIso9283:
    def test_the_worst_pose_counts_for_each_figure(self) -> None:
        poses = (
            Accuracy(0.1, 0.001, (0.2, 0.0, 0.0), (0.003, 0.0, 0.0)),
            Accuracy(0.05, 0.002, (0.1, 0.0, 0.3), (0.004, 0.0, 0.0)),
        )
        worst = Run("UR10", poses).worst
        assert worst == Accuracy(0.1, 0.002, (0.2, 0.0, 0.3), (0.004, 0.0, 0.0))
        assert (worst.angle_accuracy, worst.angle_repeatability) == (0.3, 0.004)

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


EVIL = "<script>alert(1)</script>"


class TestReportOfIso9283:
    @pytest.fixture(autouse=True)
    def _matplotlib(self) -> None:
        pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")

    def whole(self) -> Report:
        worst = Accuracy(0.0015, 0.0002, (0.001, 0.002, 0.003), (0.004, 0.005, 0.006))
        path = PathAccuracy(worst, np.full((46, 3), 0.0005), 0.912, 10)
        plain = measured(0.002)
        loaded = replace(plain.ur10[0], name=EVIL, load=10.0, path=path)
        points = (DriftPoint(0.0, Accuracy(0.001, 0.0001)), DriftPoint(600.0, Accuracy(0.0012, 0.0001)))
        return replace(plain, ur10=(plain.ur10[0], loaded), drifts=((EVIL, Drift(points)),))

    @pytest.mark.slow
    def test_it_has_the_tables_of_the_standard(self, tmp_path: Path) -> None:
        page = write_report(self.whole(), Plan(), 0, tmp_path).read_text()
        assert '<th scope="col" class="number">AT, mm</th>' in page
        row = "1.500 0.057 0.115 0.172 0.200 0.229 0.286 0.344 0.912"
        assert "".join(f'<td class="number">{cell}</td>' for cell in row.split()) in page, "the path"
        assert "drift of P1 in 10 minutes" in page
        assert "dAP 0.200 mm" in page
        assert "no thermal model" in page
        assert page.count("<caption>") > 8
        assert page.count('<img class="plot"') == 3

    @pytest.mark.slow
    def test_names_are_text(self, tmp_path: Path) -> None:
        path = write_report(self.whole(), Plan(), 0, tmp_path, tmp_path / "report.html")
        assert path == tmp_path / "report.html"
        page = path.read_text()
        assert "<script" not in page
        assert "&lt;script&gt;" in page
        assert "script-src" not in page, "nothing may run"
        assert "default-src &#x27;none&#x27;" in page

    def test_figures_of_paths_and_drift_are_in_the_results(self) -> None:
        found = self.whole().measured(0)
        assert found.values[f"at {EVIL} with 10 kg"] == 0.0015
        assert found.values[f"rt angle {EVIL} with 10 kg"] == 0.006
        assert found.values[f"path speed {EVIL} with 10 kg"] == 0.912
        assert found.values[f"dap {EVIL}"] == pytest.approx(0.0002)
        assert found.values[f"drift time {EVIL}"] == 600.0
        assert [row["path"] for row in found.rows if "path" in row] == ["P2 to P4"]


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
        assert text.index("not kept") < text.index('class="yes"')

    def test_everything_from_outside_is_text(self) -> None:
        evil = "<script>alert(1)</script>"
        sections = [Section(evil, evil, [Table(evil, [(evil, evil), (evil, evil)], evil)])]
        text = page(evil, evil, [Promise(evil, evil, evil, kept=True)], sections)
        assert "<script" not in text
        assert text.count("&lt;script&gt;") == 16

    def test_numbers_are_aligned(self) -> None:
        rows = [("a", "b", "c", "d"), ("1.5", "-2", "1.5 m", "on"), ("2", "-", "3 %", "off")]
        text = page("t", "l", [], [Section("s", tables=[Table("t", rows)])])
        assert '<td class="number">-2</td><td class="number">1.5 m</td><td>on</td>' in text

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
        text = page("t", "l", [], [Section("s", plots=[Plot(tmp_path / "no.svg", "none")], film=tmp_path / "no.mp4")])
        assert "<img" not in text
        assert "<video controls" not in text

    def test_pictures_have_their_type(self, tmp_path: Path) -> None:
        plot = tmp_path / "plot.png"
        plot.write_bytes(b"PNG")
        text = page("t", "l", [], [Section("s", plots=[Plot(plot, "A <b> plot")])])
        assert '<img class="plot" alt="A &lt;b&gt; plot" src="data:image/png;base64,' in text


class TestPlots:
    @pytest.fixture(autouse=True)
    def _matplotlib(self) -> None:
        pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")

    @pytest.mark.slow
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

    monkeypatch.setattr(plots, "import_module", missing)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[plot\]'"), figure(tmp_path / "plot.svg"):
        pass
