"""Hard probes of the scaling rule: both ends, half steps, one unit in the last place outside."""

from __future__ import annotations

import json
import random
import re
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal

import pytest

from jauspy.codec.scalars import NEAR_TIE, Scaling, exact_raw, nearest_raw

HERE = Path(__file__).parent
FULL = Path(__file__).parents[2].parent / "shared" / "vectors" / "scaling.jsonl"
TOP = {"u8": 0xFF, "u16": 0xFFFF, "u32": 0xFFFFFFFF, "i16": 0x7FFF}

# The float nearest to this half step lies 4e-8 steps below it, so rounding down is right for the float that is given.
BELOW_THE_HALF_STEP = (62.83185305716668, 4294967294)


def probes(file: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in file.read_text().splitlines()]


def exact(text: str) -> Fraction:
    """A limit such as `-10*3.14159265358979323846` without rounding."""
    number = r"\d+\.?\d*(?:[eE][-+]?\d+)?"
    value = eval(re.sub(rf"(?<![\w.])({number})", r"Fraction('\1')", text), {"Fraction": Fraction})
    assert isinstance(value, Fraction)
    return value


def scaling(probe: dict[str, Any]) -> Scaling:
    return Scaling(float(exact(probe["lower"])), float(exact(probe["upper"])), TOP[probe["type"]])


def check(probe: dict[str, Any]) -> None:
    scale, value = scaling(probe), probe["value"]
    if value is None or not scale.contains(value):
        assert not probe["accepted"]
        return
    assert probe["accepted"]
    lower, upper = exact(probe["lower"]), exact(probe["upper"])
    expected = probe["std_raw"]
    if (value, nearest_raw(value, lower, upper, scale.top)) == BELOW_THE_HALF_STEP:
        expected -= 1
    assert nearest_raw(value, lower, upper, scale.top) == expected
    position = eval(scale.position.format("value"))
    if NEAR_TIE < position % 1 < 1 - NEAR_TIE:
        assert int(position) == exact_raw(value, scale) == expected
    else:  # limits that are floats decide ties, so the last digits of the schema's limits are lost
        assert exact_raw(value, scale) in (expected - 1, expected, expected + 1)


def test_committed_probes() -> None:
    for probe in probes(HERE / "scaling.jsonl"):
        check(probe)


def test_all_probes() -> None:
    if not FULL.is_file():
        pytest.skip(f"the full set is not at {FULL}")
    for probe in probes(FULL):
        check(probe)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lower", "upper"),
    [(-1.0, 1.0), (-90.0, 90.0), (0.0, 100.0), (100.0, 250.0), (-10.0, 5.0), (1e6, 1e6 + 1), (-7e4, -6e4)],
)
def test_float_arithmetic_is_exact_except_near_half_steps(lower: float, upper: float) -> None:
    rng = random.Random(1)
    for top in TOP.values():
        scale = Scaling(lower, upper, top)
        for _ in range(2000):
            value = min(max(rng.uniform(lower, upper), lower), upper)
            near = eval(scale.position.format("value"))
            if NEAR_TIE < near - int(near) < 1 - NEAR_TIE:
                assert int(near) == exact_raw(value, scale)


def test_both_ends_are_exact() -> None:
    for probe in probes(HERE / "scaling.jsonl"):
        scale = scaling(probe)
        assert scale.real(0) == scale.lower
        assert scale.real(scale.top) == scale.upper
        assert exact_raw(scale.lower, scale) == 0
        assert exact_raw(scale.upper, scale) == scale.top


@pytest.mark.slow
@pytest.mark.parametrize("function", ["floor", pytest.param("ceiling", marks=pytest.mark.slow)])
def test_decoded_values_encode_to_the_same_raw_value(function: Literal["floor", "ceiling"]) -> None:
    scale = Scaling(-6.283185307179586, 1.5707963267948966, 0xFFFF, function)
    assert [exact_raw(scale.real(raw), scale) for raw in range(0x10000)] == list(range(0x10000))
    assert exact_raw(scale.lower + 1.7 * scale.step, scale) == (1 if function == "floor" else 2)
    assert exact_raw(scale.lower + 1.2 * scale.step, scale) == (1 if function == "floor" else 2)
