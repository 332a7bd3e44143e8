"""Electrical data of drives by SDO: one question at a time, and answers of others are not taken."""

from __future__ import annotations

import pytest
from hypothesis import given, strategies as st
from tests.helpers.robot import described

pytest.importorskip("canopen", reason="canopen is not installed")

from jauspy.backends.can.drive import Drive
from jauspy.backends.can.motion import JointMotion
from jauspy.backends.can.readings import ANSWER_TIME, CURRENT, PERIOD, RATED_CURRENT, VOLTAGE, DriveReadings

TEMPERATURE = 0x2F10


@pytest.fixture
def readings() -> DriveReadings:
    _, model = described("inc1")
    setup = model.can.drives["arm_2"]
    joint = model.description.joint(setup.moves)
    gains = model.groups["arm"].gains[joint.name]
    return DriveReadings({"arm_2": Drive(setup, joint, JointMotion(joint, gains, lambda _: 0.0), 10)})


def answer(index: int, value: int, *, size: int = 4, sub: int = 0) -> bytes:
    data = value.to_bytes(size, "little", signed=value < 0) + bytes(4 - size)
    return bytes((0x43 | (4 - size) << 2, index & 0xFF, index >> 8, sub)) + data


def fill(readings: DriveReadings, values: dict[int, bytes], now: float = 0.0) -> None:
    """Answer each question with the bytes for its object; those without are aborted."""
    for _ in range(4):
        now += PERIOD
        cob_id, question = readings.ask(now)
        index = question[1] | question[2] << 8
        abort = bytes((0x80, *question[1:4], 0, 0, 2, 6))
        assert cob_id == 0x605
        assert readings.receive(5, values.get(index, abort))


def test_values_are_in_their_units(readings):
    fill(
        readings,
        {
            VOLTAGE: answer(VOLTAGE, 47_500),
            CURRENT: answer(CURRENT, -250, size=2),
            RATED_CURRENT: answer(RATED_CURRENT, 8000),
            TEMPERATURE: answer(TEMPERATURE, -55, size=2),
        },
    )
    (reading,) = readings.readings().values()
    assert reading.voltage == pytest.approx(47.5)
    assert reading.phase_current == pytest.approx(2.0)
    assert reading.temperature == pytest.approx(-5.5)
    assert reading.current is None


def test_objects_that_a_drive_lacks_are_absent_and_not_asked_for_again(readings):
    fill(readings, {VOLTAGE: answer(VOLTAGE, 24_000)})
    (reading,) = readings.readings().values()
    assert (reading.voltage, reading.temperature, reading.phase_current) == (24.0, None, None)
    asked = set()
    for number in range(20):
        _, question = readings.ask(10.0 + number)
        asked.add(question[1] | question[2] << 8)
    assert asked == {VOLTAGE}


def test_one_question_at_a_time_until_the_answer_is_late(readings):
    assert readings.ask(0.0) is not None
    assert readings.ask(PERIOD) is None
    assert readings.ask(ANSWER_TIME - 0.01) is None
    assert readings.ask(ANSWER_TIME) is not None
    assert readings.ask(ANSWER_TIME + 0.001) is None


@pytest.mark.slow
@given(node=st.integers(1, 127), data=st.binary(min_size=8, max_size=8))
def test_answers_that_were_not_asked_for_are_ignored(node, data):
    readings = DriveReadings({})
    assert not readings.receive(node, data)
    assert readings.ask(0.0) is None
    assert readings.readings() == {}


@given(data=st.binary(min_size=8, max_size=8))
def test_any_answer_leaves_a_number_or_nothing(data):
    _, model = described("inc1")
    setup = model.can.drives["arm_2"]
    joint = model.description.joint(setup.moves)
    drive = Drive(setup, joint, JointMotion(joint, model.groups["arm"].gains[joint.name], lambda _: 0.0), 10)
    readings = DriveReadings({"arm_2": drive})
    _, question = readings.ask(0.0)
    assert not readings.receive(6, data), "another node"
    assert not readings.receive(5, bytes((0x43, 0x00, 0x10, 0)) + data[4:]), "another object"
    readings.receive(5, data[:1] + question[1:4] + data[4:])
    (reading,) = readings.readings().values()
    assert reading.voltage is None or 0.0 <= reading.voltage <= 2**32 / 1e3
    assert readings.receive(5, data) is False, "a second answer"
