"""Expressions in xacro have the values that xacro gives them, within bounds; the rest is refused by name."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
import xacro

from jauspy.errors import ConfigError
from jauspy.robot import robot_files, xacro_expressions, xacro_files
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.robot.xacro_expressions import LIMITS, MAX_TOTAL, MAX_VALUE_LENGTH, PARTS
from jauspy.robot.xacro_files import expand

HEAD = '<robot name="it" xmlns:xacro="http://www.ros.org/wiki/xacro">'


@pytest.fixture
def written(tmp_path: Path):
    def write(body: str, name: str = "it.xacro") -> str:
        (tmp_path / name).write_text(f"{HEAD}{body}</robot>")
        return str(tmp_path / name)

    return write


USUAL = [
    "pi/2",
    "-1.5e-3 + 2*(3 - 1)**2 % 5 // 2",
    "1/12*4.2*(3*0.1**2 + 0.5**2)",
    "radians(45)",
    "math.cos(math.pi)",
    "max(1, 2.5, min(3, 4)) + round(2.567, 2)",
    "python.abs(-2) + python.sum([1, 2, 3])",
    "'left' if 1 else 'right'",
    "'a' + 'b' == 'ab' and not (1 > 2 or 3 in [1, 2])",
    "1 &lt; 2 &lt;= 2 != 3",
    "[1, 2, 3][1] + (4, 5)[-1]",
    "'front_left'[0:5]",
    "len('abc') + int('7') + float('1.5')",
    "str(3) + 'x'",
    "length * 2",
    "config['wheel']['radius'] + config.wheel.radius",
    "config['sides'][0]",
    "xacro.load_yaml('it.yaml')['turn']",
    "True and '' or 'none'",
    "'1 2 3'.split(' ')[1] + 'A b'.strip().lower()",
    "'wheel_'.rstrip('_') + ' a'.lstrip() + 'front_left'.removeprefix('front_').removesuffix('t')",
    "'a-b-c'.replace('-', '_', 1) + '_'.join(['x', 'y']) + ''.join('ab') + 'ab'.replace('', '.')",
    "'7'.zfill(3) + 'a'.ljust(3) + 'a'.rjust(3, '.') + 'a'.center(4)",
    "'a/b/c'.rsplit('/', 1)[1] + 'k=v'.partition('=')[2] + 'a.b.c'.rpartition('.')[0] + 'x y'.title().swapcase()",
    "'front_left'.find('left') + 'aba'.count('a') + 'aba'.rindex('a')",
    "'12'.isdigit() and 'ab'.isalpha() and not 'A'.islower()",
    "math.sqrt(2) if length &gt; 1 else 0",
]


@pytest.mark.parametrize("expression", USUAL)
def test_usual_expressions_have_their_usual_values(tmp_path: Path, written, expression: str) -> None:
    (tmp_path / "it.yaml").write_text("wheel: {radius: 0.2}\nsides: [left, right]\nturn: !degrees 180\n")
    properties = '<xacro:property name="length" value="3.5"/><xacro:property name="config" value="${{{0}}}"/>'
    body = properties.format("xacro.load_yaml('it.yaml')") + f'<link name="${{{expression}}}"/>'
    path = written(body)
    assert expand(path) == xacro.process_file(path).toxml()


@pytest.mark.parametrize("name", robot_files.known())
def test_robots_are_expanded_as_by_xacro(name: str) -> None:
    urdf = robot_files.load(name).urdf
    assert expand(urdf) == xacro.process_file(urdf).toxml()


def test_arguments_and_files(written) -> None:
    written('<link name="$(arg side)_wheel"/>', "other.xacro")
    path = written('<xacro:arg name="side" default="left"/><xacro:include filename="other.xacro"/>')
    assert 'name="left_wheel"' in expand(path)


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        ("'a'.format(1)", ".format is not evaluated: values have no attributes and methods here"),
        ("'a'.format_map(config)", ".format_map is not evaluated"),
        ("'a'.encode()", ".encode is not evaluated"),
        ("'a'.translate([1])", ".translate is not evaluated"),
        ("'a'.rstrip.__self__", ".rstrip is not evaluated"),
        ("'a'.__class__", ".__class__ is not evaluated"),
        ("[1].rstrip()", ".rstrip is not evaluated"),
        ("'a'.rstrip(chars='a')", "is not evaluated"),
        ("','.join([1, 2])", "join is evaluated for texts only"),
        ("','.join(7)", "7 has no parts"),
        ("'a'.replace(1, 2)", "must be str"),
        ("[x for x in [1]]", "is not evaluated: only numbers, texts, lists, and functions of math"),
        ("(lambda: 1)()", "is not evaluated"),
        ("nothing + 1", "'nothing' is not defined"),
        ("factorial(9)", "'factorial' is not defined"),
        ("1 +", "'1 +' is not an expression"),
        ("'%s' % 1", "% is not evaluated for texts"),
        ("'ab' * 3", "* is not evaluated for texts and lists"),
        ("9**9**9", "a number has more than 1024 bits"),
        ("10**300 * 10**300", "a number has more than 1024 bits"),
        ("1" + "+1" * 600, "expression longer than 1000 characters"),
        ("-" * 990 + "1", "recursion"),
        ("max(*[1, 2])", "is not evaluated"),
        ("$(eval 1+1)", "$(eval 1+1): write ${...}"),
        ("round(7, -999999999)", "round is not evaluated for more than 400 digits"),
        ("python.sum([[1], [2]])", "sum is not evaluated for texts and lists"),
        ("math.prod([2, 3])", "'prod' is not defined"),
    ],
)
def test_what_is_not_evaluated(written, expression: str, reason: str) -> None:
    text = expression if expression.startswith("$(") else f"${{{expression}}}"
    with pytest.raises(ConfigError) as caught:
        expand(written(f'<link name="{text}"/>'))
    assert reason in str(caught.value)
    assert str(caught.value).isprintable()


def test_properties_that_double_each_other(written) -> None:
    doubled = "".join(f'<xacro:property name="p{n + 1}" value="${{p{n}}}${{p{n}}}"/>' for n in range(60))
    path = written(f'<xacro:property name="p0" value="ten chars."/>{doubled}<link name="${{p60}}"/>')
    with pytest.raises(ConfigError, match=f"a value is longer than {MAX_VALUE_LENGTH}"):
        expand(path)


@pytest.mark.parametrize("use", ["${str(p60)}", "x${p60}", "${p60 == [p60]}"])
def test_lists_of_lists(written, use: str) -> None:
    lists = "".join(f'<xacro:property name="p{n + 1}" value="${{[p{n}, p{n}]}}"/>' for n in range(60))
    with pytest.raises(ConfigError, match=f"a value is longer than {MAX_VALUE_LENGTH}"):
        expand(written(f'<xacro:property name="p0" value="${{[1]}}"/>{lists}<link name="{use}"/>'))


def test_long_values_that_are_used_often(written) -> None:
    doubled = "".join(f'<xacro:property name="p{n + 1}" value="${{p{n}}}${{p{n}}}"/>' for n in range(13))
    with pytest.raises(ConfigError, match=f"the values of all expressions are longer than {MAX_TOTAL}"):
        expand(written(f'<xacro:property name="p0" value="ten chars."/>{doubled}<link name="{"${p13}" * 100}"/>'))


@pytest.mark.slow
@pytest.mark.parametrize(
    "use", ['<xacro:include filename="pipe"/>', """<link name="${xacro.load_yaml('pipe')}"/>"""], ids=["XML", "YAML"]
)
def test_files_that_never_end(tmp_path: Path, written, use: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(ConfigError, match="pipe: is not a regular file"):
        expand(written(use))


def test_macros_that_double_each_other(written, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xacro_expressions, "LIMITS", {**LIMITS, PARTS: 1000})
    doubled = "".join(f'<xacro:macro name="m{n + 1}"><xacro:m{n}/><xacro:m{n}/></xacro:macro>' for n in range(60))
    with pytest.raises(ConfigError, match="it has more than 1000 elements, attributes and texts"):
        expand(written(f'<xacro:macro name="m0"><link/></xacro:macro>{doubled}<xacro:m60/>'))


def test_an_unknown_way_to_evaluate_fails(written) -> None:
    """As in a version of xacro that calls `eval` elsewhere; the module that others import is not changed."""
    module = xacro_files._copy_of_xacro(Path("it.xacro"), PackagePaths())
    with pytest.raises(xacro_files.ExpressionError, match="not known to be safe"):
        module.eval("1")
    assert "eval" not in vars(xacro)
    assert xacro.safe_eval("len([c for c in [1]])", {"len": len}) == 1


def test_entities_do_not_multiply_and_are_not_read_from_files(tmp_path: Path) -> None:
    """What pyproject.toml gives as the reason why bandit may find xml.dom here."""
    steps = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
    secret = tmp_path / "secret"
    secret.write_text("stolen")
    texts = {
        "bomb": f'<!DOCTYPE robot [<!ENTITY a0 "lollollol">{steps}]><robot name="x"><link name="&a9;"/></robot>',
        "thief": f'<!DOCTYPE robot [<!ENTITY e SYSTEM "{secret.as_uri()}">]>'
        '<robot name="x"><link name="base">&e;</link></robot>',
    }
    for name, text in texts.items():
        (tmp_path / f"{name}.urdf").write_text(text)
        with pytest.raises(ConfigError, match=r"it has a <!DOCTYPE \.\.\.>, which is not read"):
            expand(str(tmp_path / f"{name}.urdf"))
