"""A file author sends a robot whose xacro has Python in it: no expression of it runs, wherever and however written."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.errors import ConfigError
from jauspy.robot import robot_files, xacro_files

run = CliRunner()

TOUCH: Final = "system('touch written')"
OBJECTS: Final = "().__class__.__base__.__subclasses__()"
EXPRESSIONS: Final = {
    "a lambda hides names": f"(lambda f: f.__globals__['os'].{TOUCH})(xacro.load_yaml)",
    "so does a list": f"[f.__globals__['os'].{TOUCH} for f in [xacro.load_yaml]]",
    "classes": f"(lambda: [c for c in {OBJECTS} if c.__name__ == 'BuiltinImporter'][0].load_module('os').{TOUCH})()",
    "frames": f"[f.f_back.f_back.f_globals['os'].{TOUCH} for f in [(lambda: (g for g in [1]))().gi_frame]]",
    "variables of a module": f"[python.vars(o)['os'].{TOUCH} for o in [python.type(math)]]",
    "a function's own function": f"(lambda: xacro.warning.__closure__[0].cell_contents.__globals__['os'].{TOUCH})()",
    "a format": "'{0.__globals__[os].environ}'.format(xacro.load_yaml)",
    "an assignment": f"(o := xacro.load_yaml) and (lambda: o.__globals__['os'].{TOUCH})()",
    "imports": f"__import__('os').{TOUCH}",
    "an f-string": "f'" + f'<(lambda f: f.__globals__["os"].{TOUCH.replace(chr(39), chr(34))})(xacro.load_yaml)>\'',
}
RUN: Final = EXPRESSIONS["a lambda hides names"]
PLACES: Final = {
    "an attribute": f'<link name="${{{RUN}}}"/>',
    "a text": f"<link>${{{RUN}}}</link>",
    "a property": f'<xacro:property name="p" value="${{{RUN}}}"/><link name="${{p}}"/>',
    "a condition": f'<xacro:if value="${{{RUN}}}"/>',
    "a parameter": f'<xacro:macro name="m" params="a:=${{{RUN}}}"><link name="${{a}}"/></xacro:macro><xacro:m/>',
    "an element": f'<xacro:element xacro:name="${{{RUN}}}"/>',
    "a comment": f"<!-- xacro:eval-comments:on --><!-- ${{{RUN}}} -->",
    "a call": f'<xacro:call macro="${{{RUN}}}"/>',
    "an evaluation": f"<link name=\"$(eval '{{0.__class__}}'.format)\"/><link>$(eval {RUN})</link>",
    "another file": '<xacro:include filename="other.xacro"/>',
    "units": "<link name=\"${xacro.load_yaml('units.yaml')}\"/>",
}
ROBOT: Final = '<robot name="it" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>{}</robot>'


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("other.xacro").write_text(ROBOT.format(PLACES["an attribute"]))
    Path("units.yaml").write_text(f'a: !degrees "{RUN}"')


@pytest.mark.parametrize("expression", EXPRESSIONS.values(), ids=EXPRESSIONS.keys())
def test_no_expression_runs(expression: str) -> None:
    text = expression.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    _assert_refused(ROBOT.format(f'<link name="${{{text}}}"/>'))


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_expressions_run_nowhere(place: str) -> None:
    _assert_refused(ROBOT.format(place))


def _assert_refused(urdf: str) -> None:
    """The command ends with one sentence, and nothing was written."""
    Path("it.urdf.xacro").write_text(urdf)
    Path("it.toml").write_text('extends = "inc1"\nurdf = "it.urdf.xacro"\n')
    with pytest.raises(ConfigError) as caught:
        robot_files.robot_model(robot_files.load("./it.toml"))
    assert "xacro cannot expand it" in str(caught.value)
    assert str(caught.value).isprintable()
    assert not Path("written").exists()


def test_the_command_says_so() -> None:
    Path("it.urdf.xacro").write_text(ROBOT.format(PLACES["an attribute"]))
    Path("it.toml").write_text('extends = "inc1"\nurdf = "it.urdf.xacro"\n')
    done = run.invoke(app, ["up", "it.toml", "--no-node-manager", "--local-root", str(Path.cwd())])
    assert done.exit_code == 1
    assert "xacro cannot expand it" in " ".join(done.output.split())
    assert not Path("written").exists()


@pytest.mark.parametrize("reading", ["$(env {})", "$(optenv {} none)", "${{'$(env {})'}}"])
def test_a_robot_file_does_not_read_secrets_from_the_environment(tmp_path, monkeypatch, reading) -> None:
    """Names of links and joints are told to every client."""
    path = tmp_path / "it.xacro"
    path.write_text(f'<robot name="{reading.format("API_TOKEN")}" xmlns:xacro="http://www.ros.org/wiki/xacro"/>')
    monkeypatch.setenv("API_TOKEN", "s3cr3t")
    with pytest.raises(ConfigError, match="environment variable API_TOKEN is not read, because") as reported:
        xacro_files.expand(str(path))
    assert "s3cr3t" not in str(reported.value)
    for value in ("1", "-2.5", "true", "Off"):
        monkeypatch.setenv("API_TOKEN", value)
        assert f'name="{value}"' in xacro_files.expand(str(path))
