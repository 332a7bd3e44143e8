from __future__ import annotations

import math

import pytest

from jauspy.schema.library import MAX_LENGTH, ConstantExpressionError, evaluate

NAMES = {"PI": math.pi, "basic.PI": math.pi, "two": 2}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("12", 12),
        ("-3", -3),
        ("1e3", 1000.0),
        ("-0.5", -0.5),
        ("PI", math.pi),
        ("-basic.PI", -math.pi),
        ("10*basic.PI", 10 * math.pi),
        (" 2 * (two + 1) / 3 - +1 ", 1.0),
        ("18446744073709551615", 2**64 - 1),
    ],
)
def test_constant_expressions_are_evaluated(text, value):
    assert evaluate(text, NAMES.__getitem__) == value


def test_whole_numbers_stay_whole():
    assert isinstance(evaluate("two * 8", NAMES.__getitem__), int)


def lookup(name):
    if name not in NAMES:
        raise ConstantExpressionError(name)
    return NAMES[name]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "one two",
        "2 ** 1000",
        "f(2)",
        "'x'",
        "True",
        "two.x()",
        "[1]",
        "1/0",
        "1e999",
        "nan",
        "inf",
        "1+" * MAX_LENGTH + "1",
        "(" * 150,
    ],
)
def test_invalid_expressions_are_rejected(text):
    with pytest.raises(ConstantExpressionError):
        evaluate(text, lookup)
