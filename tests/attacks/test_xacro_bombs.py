"""A file author sends a xacro file that does not end, or grows to gigabytes: it is refused, in one sentence."""

from __future__ import annotations

import re
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Final

import pytest

from jauspy.errors import ConfigError
from jauspy.robot import xacro_expressions
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.urdf_files import read_urdf
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.robot.xacro_expressions import LIMITS, STEPS
from jauspy.robot.xacro_files import expand

pytestmark = pytest.mark.slow

HEAD: Final = '<robot name="it" xmlns:xacro="http://www.ros.org/wiki/xacro">'


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., str]:
    def write(body: str, name: str = "it.xacro") -> str:
        (tmp_path / name).write_text(f"{HEAD}{body}</robot>")
        return str(tmp_path / name)

    return write


def _refusal(path: str) -> str:
    with pytest.raises(ConfigError) as caught:
        expand(path)
    text = str(caught.value)
    assert text.isprintable()
    assert len(text) < 1000
    return text


def test_files_that_include_each_other_ten_times_each(write) -> None:
    """Nine files, and 10^9 includes."""
    write('<link name="l"/>', "f0.xacro")
    for number in range(1, 10):
        write(f'<xacro:include filename="f{number - 1}.xacro"/>' * 10, f"f{number}.xacro")
    assert "it has more than 1000 files" in _refusal(write('<xacro:include filename="f9.xacro"/>'))


def test_a_file_that_is_read_again_and_again_as_yaml(tmp_path: Path, write) -> None:
    (tmp_path / "it.yaml").write_text("a: 1\n")
    once = """<xacro:property name="p" value="${xacro.load_yaml('it.yaml')}" lazy_eval="false"/>"""
    assert "it has more than 1000 files" in _refusal(write(once * 1001))


def test_a_large_file_that_is_included_often(write) -> None:
    write("<!--" + "x" * 2_000_000 + "-->", "large.xacro")
    assert "bytes in all files" in _refusal(write('<xacro:include filename="large.xacro"/>' * 20))


def test_yaml_that_takes_minutes(tmp_path: Path, write) -> None:
    (tmp_path / "it.yaml").write_text("[" + "{a: 1}," * 200_000 + "]")
    assert "bytes of YAML" in _refusal(write("""<link name="${xacro.load_yaml('it.yaml')}"/>"""))


def test_a_long_text_in_a_macro_that_is_used_often(write) -> None:
    """Four gigabytes of output."""
    macro = '<xacro:macro name="m"><link name="{}"/></xacro:macro>'.format("x" * 100_000)
    assert "characters in elements" in _refusal(write(macro + "<xacro:m/>" * 40_000))


@pytest.mark.parametrize("hidden", ["<!--{}-->", "<link>{}</link>", "<![CDATA[{}]]>"], ids=["comment", "text", "CDATA"])
def test_a_long_text_that_is_not_an_attribute(write, hidden: str) -> None:
    macro = f'<xacro:macro name="m"><link/>{hidden.format("x" * 100_000)}</xacro:macro>'
    assert "characters in elements" in _refusal(write(macro + "<xacro:m/>" * 40_000))


@pytest.mark.parametrize(
    "body", ["<a/>" * 300_000, "<!---->x" * 200_000, "<a {}/>".format(" ".join(f'a{n}=""' for n in range(300_000)))]
)
def test_more_elements_than_a_robot_has(write, body: str) -> None:
    assert "elements, attributes and texts" in _refusal(write(body))


def test_what_macros_copy_and_nobody_sees(write) -> None:
    """A part that is never true is copied with the macro each time."""
    hidden = '<xacro:if value="false">' + "<a/>" * 50_000 + "</xacro:if>"
    path = write(f'<xacro:macro name="m">{hidden}</xacro:macro>' + "<xacro:m/>" * 30_000)
    assert "elements, attributes and texts" in _refusal(path)


def test_blocks_that_double_each_other(write) -> None:
    doubled = "".join(
        f'<xacro:property name="b{n + 1}"><xacro:insert_block name="b{n}"/><xacro:insert_block name="b{n}"/>'
        "</xacro:property>"
        for n in range(60)
    )
    path = write(f'<xacro:property name="b0"><a/></xacro:property>{doubled}<xacro:insert_block name="b60"/>')
    assert "elements, attributes and texts" in _refusal(path)


def test_arguments_that_double_each_other(write) -> None:
    doubled = "".join(f'<xacro:arg name="a{n + 1}" default="$(arg a{n})$(arg a{n})"/>' for n in range(60))
    path = write(f'<xacro:arg name="a0" default="ten chars."/>{doubled}<link name="$(arg a60)"/>')
    assert "longer than" in _refusal(path)


def test_a_text_with_many_dollars(write) -> None:
    assert "steps" in _refusal(write(f"<link>{'$a' * 200_000}</link>"))


def test_many_long_expressions(write) -> None:
    added = "1" + "+1" * 100
    assert "characters of expressions" in _refusal(write(f'<link name="${{{added}}}"/>' * 6_000))


def test_thousands_of_macros_among_many_elements(write) -> None:
    body = '<xacro:macro name="m"><a/></xacro:macro>' + "<xacro:m/>" * 60_000 + "<b/>" * 60_000
    assert "steps" in _refusal(write(body))


@pytest.mark.parametrize("params", ["a:=" + "x" * 60 + "'", "a:=" + "''" * 40 + '"', "a " * 20_000])
def test_parameters_that_a_pattern_reads_for_ever(write, params: str) -> None:
    quoted = params.replace('"', "&quot;")
    path = write(f'<xacro:macro name="m" params="{quoted}"><a/></xacro:macro><link name="l"/>')
    if params.count("a ") > 1:
        assert "steps" in _refusal(path)
    else:
        assert "<link" in expand(path)


@pytest.mark.parametrize(
    "expression",
    [
        "'a'.ljust(10**9)",
        "'a'.rjust(10**9, 'b')",
        "'a'.center(10**12)",
        "'1'.zfill(10**300)",
        "p.replace('x', p)",
        "p.replace('', p)",
        "p.replace('x', p, 10**9)",
        "p.join(p)",
        "p.join([p, p, p, p, p, p, p, p, p, p, p, p, p])",
        "p.join(p.split('x'))",
        "p.expandtabs(10**9)",
        "p.translate([p])",
        "p.format(10**9)",
        "p.format_map(p)",
        "'a' * 10**9",
        "'%1000000000d' % 1",
    ],
)
def test_methods_that_make_gigabytes_of_a_text(write, expression: str) -> None:
    """Refused before the text is made."""
    path = write(f'<xacro:property name="p" value="{"x" * 10_000}"/><link name="${{{expression}}}"/>')
    tracemalloc.start()
    said = _refusal(path)
    assert re.search(r"a value is longer than|is not evaluated", said)
    assert tracemalloc.get_traced_memory()[1] < 50_000_000
    tracemalloc.stop()


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("".join(f'<xacro:include filename="$(find a{n})/x.xacro"/>' for n in range(2_000)), "more than 32 packages"),
        ("".join(f'<mesh filename="package://a{n}/x.stl"/>' for n in range(2_000)), "more than 32 packages"),
        ('<xacro:include filename="$(find a)/x.xacro"/>' + "<xacro:m/>" * 5_000, "steps"),
        ("".join(f'<xacro:include filename="no{n}.xacro"/>' for n in range(2_000)), "steps"),
        ("".join(f'<mesh filename="{n}.stl"/>' for n in range(3_000)), "3000 parts are missing"),
        (f'<mesh filename="{"x" * 100_000}.stl"/>', "cannot be read: File name too long"),
    ],
    ids=["packages", "packages of meshes", "macros", "includes", "meshes", "long names"],
)
def test_thousands_of_missing_parts(
    write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str, said: str
) -> None:
    """Each package is searched for in thousands of directories."""
    monkeypatch.setattr(xacro_expressions, "LIMITS", {**LIMITS, STEPS: 10_000_000})
    path = write(f'<link name="l"/>{body}')
    for policy in (MissingPolicy(), MissingPolicy(skip_packages=True)):
        with pytest.raises(ConfigError) as caught:
            read_urdf(path, PackagePaths((tmp_path,), {}), None, policy)
        assert re.search(said, str(caught.value))
        assert len(str(caught.value)) < 100_000
        assert str(caught.value).count("\n") < 60


def test_entities_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "it.xacro"
    path.write_text('<!DOCTYPE robot [<!ATTLIST link name CDATA "long">]><robot name="it"><link/></robot>')
    assert "DOCTYPE" in _refusal(str(path))


def test_warnings_reach_the_terminal_printable_and_in_number(
    write, capfd: pytest.CaptureFixture[str], caplog: pytest.LogCaptureFixture
) -> None:
    expand(write('<xacro:include filename="no*\u202e.xacro"/>' * 500))
    assert capfd.readouterr() == ("", "")
    assert 0 < len(caplog.messages) < 50
    assert all(message.isprintable() for message in caplog.messages)
