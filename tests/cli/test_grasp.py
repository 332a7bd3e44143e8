"""`jauspy grasp`: what is refused before a robot is looked for."""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

pytest.importorskip("ompl", reason="OMPL is not installed")
pytest.importorskip("coal", reason="coal is not installed")

from jauspy.cli.main import app


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["101.1.104"], "name what is to be grasped: a known thing, a colour, or a place"),
        (["101.1.104", "--object", "spoon"], "'spoon' is no known thing; there are: can, box, bottle, cup, bar, ball"),
        (["101.1.104", "--colour", "beige"], "'beige' is no known colour; there are: red, orange"),
        (["101.1.104", "--at", "1,2"], "--at: '1,2': write x,y,z in metres, as in 0.8,0.1,0.3"),
        (["101.1.104", "--object", "can", "--place", "1,nan,0"], "--place: '1,nan,0': write x,y,z in metres"),
        (["101.1.0", "--object", "can"], "101.1.0"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_sentence(arguments: list[str], message: str) -> None:
    result = CliRunner().invoke(app, ["grasp", *arguments])
    assert result.exit_code != 0
    assert message in " ".join(result.stderr.replace("│", " ").split())
