"""A client in control sends each message of the profile at the limits of its fields, cut off, and with random bytes."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.robot.workcell import CLIENT, Workcell

from jauspy.messages.core import ClearEmergency

pytestmark = pytest.mark.slow

GOLDEN = Path(__file__).parents[1] / "golden"
SETS = ("iop_v3", "aeodrs", "iop")
RETAKEN = 20
"""Messages after which the client takes control again, which some of them end."""
MAX_TIMERS = 20


def payloads(source: random.Random) -> Iterator[bytes]:
    for name in SETS:
        for line in (GOLDEN / f"{name}.jsonl").read_text().splitlines():
            payload = bytes.fromhex(json.loads(line)["hex"])
            yield payload
            yield payload[: source.randrange(2, len(payload) + 1)]
            changed = bytearray(payload)
            for _ in range(3 if len(payload) > 2 else 0):
                changed[source.randrange(2, len(changed))] = source.randrange(256)
            yield bytes(changed)


@pytest.mark.parametrize("component", [102, 103, 104, 105, 106, 108, 110])
def test_no_message_breaks_a_module(component: int) -> None:
    work = Workcell("kinematic", "inc1", component)
    for number, payload in enumerate(payloads(random.Random(component))):
        if number % RETAKEN == 0:
            work.host.receive(ClearEmergency(1).encode(), CLIENT, work.now)
            work.take_control()
        work.host.receive(payload, CLIENT, work.now)
        for message in work.host.poll_output(work.now):
            if message.on_acknowledged is not None:
                message.on_acknowledged(True)
        work.run(0.01)
    assert work.host.first_error is None
    assert len(work.host._timers) <= MAX_TIMERS
