"""Exit status of `jauspy fuzz target`."""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from jauspy.cli import fuzz_target
from jauspy.cli.main import app
from jauspy.fuzz.target.campaign import TargetResult


@pytest.mark.parametrize(("states", "status"), [(set(), 2), ({"Receiving.Ready"}, 0)])
def test_a_target_that_reached_no_state_is_no_success(monkeypatch, tmp_path, states, status):
    result = TargetResult("101.1.103", 20, states, {"Receiving.Ready.Controlled"}, cases=10)
    monkeypatch.setattr(fuzz_target, "run", lambda plan, show: result)
    outcome = CliRunner().invoke(app, ["fuzz", "target", "127.0.0.1:4999", "-o", str(tmp_path)])
    assert outcome.exit_code == status
    assert "Receiving.Ready.Controlled" in outcome.stderr
    assert ("nothing was tested" in outcome.stderr) == (status == 2)
