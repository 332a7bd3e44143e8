"""What `jauspy up` says once the robot is there."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

from jauspy.cli.up import _tell
from jauspy.modules.robots import load


@pytest.mark.parametrize(("services", "drives"), [(None, True), (("Discovery", "LocalPoseSensor"), False)])
def test_says_how_to_drive_only_what_can_be_driven(capsys, services, drives) -> None:
    config = load("inc1")
    module = config.modules[0].model_copy(update={"services": services})
    config = config.model_copy(update={"modules": (module,)})
    runner = SimpleNamespace(config=config, components=[SimpleNamespace(id=config.id_of(module))])
    _tell(runner, "running", Path("/tmp/elsewhere"))
    text = capsys.readouterr().out
    assert ("drive it:  jauspy send 101.1.102 SetWrenchEffort" in text) == drives
    assert "ask it:    jauspy query 101.1.102 QueryStatus --connect local:/tmp/elsewhere" in text
