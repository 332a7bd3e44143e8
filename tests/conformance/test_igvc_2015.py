"""The judge's interface test sends what the judge sent, and our robot gets its points."""

from __future__ import annotations

import csv

import pytest
from tests.conformance.simulated import TARGET, examined, robot

from jauspy.conformance.trace import Direction
from jauspy.ids import JausID

EVENT_ID_AT = {"01f1": 4, "01f2": 1, "21f0": 1}
"""Where the robot's own event id is in the body; the robot of 2015 had others."""


@pytest.fixture(scope="module")
def report():
    return examined("igvc-2015", robot())


@pytest.mark.slow
def test_robot_passes(report):
    assert [f"{each.id}: {each.reason}" for each in report.failures] == []
    assert report.points == (80, 80)
    assert report.status == 0


def test_sent_bytes_equal_those_of_the_judge(report, shared):
    with (shared / "facts" / "igvc_2015_interface_test.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(report.results)
    for row, result in zip(rows, report.results, strict=True):
        packet = next(each for each in result.entries if each.direction is Direction.SENT).packets[0]
        assert str(packet.source) == row["from"], result.id
        assert str(packet.destination) == row["to"].replace("105.", f"{TARGET.subsystem}."), result.id
        assert f"{int.from_bytes(packet.payload[:2], 'little'):04x}" == row["message_id"], result.id
        assert packet.broadcast == int(row["broadcast_flag"]), result.id
        assert packet.priority == 1
        assert packet.ack == 0
        body, wanted = bytearray(packet.payload[2:]), bytearray.fromhex(row["body_hex"])
        if row["message_id"] in EVENT_ID_AT and body[0] != 3:
            body[EVENT_ID_AT[row["message_id"]]] = wanted[EVENT_ID_AT[row["message_id"]]]
        assert body.hex() == wanted.hex(), result.id


@pytest.mark.slow
def test_several_components_that_answer_are_an_error_before_the_first_step():
    report = examined("igvc-2015", robot(name="inc1", tick=None), JausID(101, 1, 255))
    assert report.results == ()
    assert report.status == 2
    assert report.problem.startswith("10 components answer; name one: 101.1.10")
    assert "(as in --target 101.1.10" in report.problem
