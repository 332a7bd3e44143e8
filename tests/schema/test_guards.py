from __future__ import annotations

import pytest
from hypothesis import given, settings, strategies as st

from jauspy.errors import SchemaError
from jauspy.schema.behavior import And, Call, Not, Or, calls, compile_guard, parse

NAMES = ("a", "b", "c", "d")


def names() -> st.SearchStrategy[tuple[str, str]]:
    return st.sampled_from([(f"{name}( msg )", f"v[{name!r}]") for name in NAMES])


def extend(inner: st.SearchStrategy[tuple[str, str]]) -> st.SearchStrategy[tuple[str, str]]:
    """Pairs of the same expression, as a guard and as Python."""

    def joined(pairs: list[tuple[str, str]], guard: str, python: str) -> tuple[str, str]:
        return f" {guard} ".join(p[0] for p in pairs), f" {python} ".join(p[1] for p in pairs)

    several = st.lists(inner, min_size=2, max_size=4)
    return st.one_of(
        inner.map(lambda p: (f"!({p[0]})", f"(not ({p[1]}))")),
        inner.map(lambda p: (f"({p[0]})", f"({p[1]})")),
        several.map(lambda ps: joined(ps, "&&", "and")),
        several.map(lambda ps: joined(ps, "||", "or")),
    )


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(st.recursive(names(), extend, max_leaves=12), st.tuples(*[st.booleans()] * len(NAMES)))
def test_guards_evaluate_like_python(pair: tuple[str, str], values: tuple[bool, ...]) -> None:
    guard, python = pair
    v = dict(zip(NAMES, values, strict=True))
    run = compile_guard(parse(guard), lambda call: lambda given: given[call.name])
    assert run(v) == eval(python, {"v": v})


def test_precedence_and_arguments() -> None:
    guard = parse("!a.isX( msg ) && b(msg, 'CODE', transportData) || (c() && !d)")
    assert guard == Or(
        (
            And((Not(Call("a.isX", ("msg",))), Call("b", ("msg", "'CODE'", "transportData")))),
            And((Call("c"), Not(Call("d")))),
        )
    )
    assert [call.name for call in calls(guard)] == ["a.isX", "b", "c", "d"]


def test_operands_are_evaluated_lazily_from_the_left() -> None:
    asked: list[str] = []

    def resolve(call: Call):
        return lambda given: asked.append(call.name) or given[call.name]

    assert compile_guard(parse("a() || b()"), resolve)({"a": True, "b": True})
    assert not compile_guard(parse("c() && d()"), resolve)({"c": False, "d": True})
    assert asked == ["a", "c"]


@pytest.mark.parametrize(
    "text", ["", "a(", "a(msg", "a() &&", "&& a()", "a() b()", "(a()", "a())", "a(,)", "a() & b()", "1"]
)
def test_invalid_guards_are_rejected_with_their_text(text: str) -> None:
    with pytest.raises(SchemaError, match="guard"):
        parse(text)


def test_nesting_is_bounded() -> None:
    with pytest.raises(SchemaError, match="nested"):
        parse("(" * 5000 + "a()" + ")" * 5000)
