"""Files of robots: TOML that leads to itself, xacro with expressions of Python, URDF with entities and loops."""

from __future__ import annotations

import random
from pathlib import Path

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import CANARY, EXPRESSION, FileKind, Make, attacked_by, damaged, noise, several

_EXAMPLES = Path(__file__).parents[3] / "examples"
URDF = (_EXAMPLES / "tracked.urdf").read_bytes()
TOML = (
    (_EXAMPLES / "tracked.toml")
    .read_bytes()
    .replace(b'backend = "tracked"', b'backend = "kinematic"')
    .replace(b'urdf = "tracked.urdf"', f'urdf = "{_EXAMPLES / "tracked.urdf"}"'.encode())
)
EXPRESSIONS = (
    "${" + EXPRESSION + "}",
    "${load_yaml.__globals__['os'].mknod('" + CANARY + "')}",
    "${xacro.load_yaml.__globals__['os'].mknod('" + CANARY + "')}",
    "${(lambda: 0).__globals__['__builtins__']['open']('" + CANARY + "', 'w')}",
    "${[c for c in ().__class__.__base__.__subclasses__() if c.__name__ == 'Popen'][0](['touch', '" + CANARY + "'])}",
    "${[c for c in ().__class__.__mro__[1].__subclasses__() if 'warning' in c.__name__]"
    "[0]()._module.__builtins__['open']('" + CANARY + "', 'w')}",
    "$(eval " + EXPRESSION + ")",
)
COSTLY = ("${9**9**9}", "${'a' * 10**10}", "${[0] * 10**10}", "${sum(range(10**11))}", "${round(7, -10**9)}")
_OPEN = b'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'


def expression(text: str) -> Make:
    """A xacro file with this expression."""
    return lambda _: _OPEN + f'<link name="{text}"/></robot>'.encode()


def entities(_: random.Random) -> bytes:
    """Entities that grow to gigabytes."""
    names = [f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12)]
    return f'<?xml version="1.0"?><!DOCTYPE r [<!ENTITY e0 "ha">{"".join(names)}]>'.encode() + _OPEN + b"&e11;</robot>"


def endless_macro(_: random.Random) -> bytes:
    """A macro that uses itself."""
    return _OPEN + b'<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/></robot>'


def includes_itself(_: random.Random) -> bytes:
    """A file that includes /dev/zero."""
    return _OPEN + b'<xacro:include filename="/dev/zero"/></robot>'


def bomb(body: str) -> Make:
    """A short xacro file that stands for gigabytes, or takes for ever."""
    return lambda _: _OPEN + body.encode() + b"</robot>"


def _doubled(first: str, each: str, use: str) -> str:
    """Sixty definitions, of which each uses the one before twice."""
    return first + "".join(each.format(n + 1, n) for n in range(60)) + use


BOMBS = {
    "a file that includes its folder": '<xacro:include filename="*"/>' * 20,
    "a long text that a macro repeats": f'<xacro:macro name="m"><link name="{"x" * 100_000}"/></xacro:macro>'
    + "<xacro:m/>" * 40_000,
    "elements that a macro copies and hides": '<xacro:macro name="m"><xacro:if value="false">'
    + "<a/>" * 20_000
    + "</xacro:if></xacro:macro>"
    + "<xacro:m/>" * 20_000,
    "arguments that double": _doubled(
        '<xacro:arg name="a0" default="ten chars."/>',
        '<xacro:arg name="a{0}" default="$(arg a{1})$(arg a{1})"/>',
        '<link name="$(arg a60)"/>',
    ),
    "blocks that double": _doubled(
        '<xacro:property name="b0"><a/></xacro:property>',
        '<xacro:property name="b{0}"><xacro:insert_block name="b{1}"/><xacro:insert_block name="b{1}"/>'
        "</xacro:property>",
        '<xacro:insert_block name="b60"/>',
    ),
    "a pattern that backtracks": f"""<xacro:macro name="m" params="a:={"x" * 60}'"><a/></xacro:macro>""",
    "a text with many dollars": f"<link>{'$a' * 200_000}</link>",
    "the passwords as YAML": "<link name=\"${str(xacro.load_yaml('/etc/passwd'))}\"/>",
}


def loop(_: random.Random) -> bytes:
    """Links that carry each other."""
    joints = [
        f'<joint name="j{n}" type="fixed"><parent link="{a}"/><child link="{b}"/></joint>'
        for n, (a, b) in enumerate((("a", "b"), ("b", "a")))
    ]
    return f'<robot name="r"><link name="a"/><link name="b"/>{"".join(joints)}</robot>'.encode()


def chain(_: random.Random) -> bytes:
    """A chain of 5,000 links."""
    links = "".join(f'<link name="l{n}"/>' for n in range(5_000))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>' for n in range(4_999)
    )
    return f'<robot name="r">{links}{joints}</robot>'.encode()


def extends(other: bytes) -> Make:
    """A robot that extends another file."""
    return lambda _: b'extends = "' + other + b'"\n' + TOML


def set_to(key: bytes, value: bytes) -> Make:
    """A robot with another value of a key."""
    return lambda _: b"\n".join(
        key + b" = " + value if line.startswith(key + b" =") else line for line in TOML.splitlines()
    )


HOSTILE_URDF: dict[str, Make] = {
    **{f"the expression {text}": expression(text) for text in EXPRESSIONS},
    **several("a damaged URDF", damaged(URDF), 3),
    "entities that grow": entities,
    "a macro that uses itself": endless_macro,
    "links that carry each other": loop,
    "a chain of 5,000 links": chain,
    **{f"the expression {text}": expression(text) for text in COSTLY},
    "a file that includes /dev/zero": includes_itself,
    **{what: bomb(body) for what, body in BOMBS.items()},
    "noise": noise,
}
HOSTILE_TOML: dict[str, Make] = {
    **several("a damaged file", damaged(TOML), 5),
    "a file that extends itself": extends(b"hostile5.toml"),
    "a file that extends /dev/zero": extends(b"/dev/zero"),
    "the URDF /dev/zero": set_to(b"urdf", b'"/dev/zero"'),
    "the URDF /dev/stdin": set_to(b"urdf", b'"/dev/stdin"'),
    "an audit log elsewhere": set_to(b"world", f'"empty"\naudit_log = "../{CANARY}"'.encode()),
    "a huge number": set_to(b"subsystem", b"9" * 4000),
    "a backend with a path": set_to(b"backend", b'"../../canary"'),
    "5000 nested lists": set_to(b"world", b"[" * 5000 + b"]" * 5000),
    "noise": noise,
}
ATTACK = Attack(
    "robot-files",
    Attacker.AUTHOR,
    "files",
    attacked_by(FileKind("robot", ".toml", TOML, HOSTILE_TOML), FileKind("urdf", ".urdf.xacro", URDF, HOSTILE_URDF)),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
