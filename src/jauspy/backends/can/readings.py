"""Electrical data of drives: read by SDO in turn while the drives run, one object at a time, without waiting.

Objects of CiA 402: the voltage of the DC link (6079h, mV), the current (6078h, thousandths of the rated one) and the
motor's rated current (6075h, mA); and the temperature, whose object each maker has elsewhere (0.1 degrees Celsius).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Final, NamedTuple

from jauspy.backends.can import pdo
from jauspy.backends.can.drive import Drive
from jauspy.platform.motors import MotorReading, Motors

VOLTAGE: Final = 0x6079
CURRENT: Final = 0x6078
RATED_CURRENT: Final = 0x6075

PERIOD: Final = 0.05
"""Seconds between two questions."""
ANSWER_TIME: Final = 0.3
"""Seconds after which an answer is not waited for any longer."""

UPLOAD: Final = 0x40
"""Command of the question for an object (CiA 301), and of its answer: the upper three bits."""
COMMAND: Final = 0xE0
ABORT: Final = 0x80
EXPEDITED: Final = 0x02
SIZE_INDICATED: Final = 0x01


class _Question(NamedTuple):
    node: int
    object: int
    asked_at: float


class DriveReadings:
    """Answers of the drives. `ask` is called in each cycle, `receive` by the thread that receives frames."""

    def __init__(self, drives: Mapping[str, Drive]) -> None:
        self._drives = tuple(drives.values())
        self._values: dict[tuple[int, int], int] = {}
        """Last answers, by node and object."""
        self._missing: set[tuple[int, int]] = set()
        """Objects that drives do not have."""
        self._turn: Iterator[tuple[int, int]] = iter(())
        self._next = 0.0
        self._question: _Question | None = None

    def ask(self, now: float) -> tuple[int, bytes] | None:
        """COB-ID and bytes of the next question, if one is due."""
        if now < self._next or (self._question is not None and now - self._question.asked_at < ANSWER_TIME):
            return None
        self._next = now + PERIOD
        found = next(self._turn, None)
        if found is None:
            self._turn = iter([key for key in self._objects() if key not in self._missing])
            found = next(self._turn, None)
        if found is None:
            return None
        node, index = found
        self._question = _Question(node, index, now)
        return pdo.SDO_REQUEST + node, bytes((UPLOAD, index & 0xFF, index >> 8, 0, 0, 0, 0, 0))

    def receive(self, node: int, data: bytes) -> bool:
        """Take an answer; False for one that was not asked for."""
        question = self._question
        index = data[1] | data[2] << 8
        if question is None or (node, index, 0) != (question.node, question.object, data[3]):
            return False
        command = data[0]
        if command == ABORT:
            self._missing.add((node, index))
        elif command & COMMAND == UPLOAD and command & EXPEDITED:
            size = 4 - (command >> 2 & 3) if command & SIZE_INDICATED else 4
            self._values[node, index] = int.from_bytes(data[4 : 4 + size], "little", signed=index != VOLTAGE)
        else:
            return False
        self._question = None
        return True

    def _objects(self) -> Iterator[tuple[int, int]]:
        for drive in self._drives:
            for index in (VOLTAGE, CURRENT, RATED_CURRENT, drive.setup.temperature):
                if index is not None:
                    yield drive.setup.node, index

    def readings(self) -> dict[str, MotorReading]:
        """The last answers, by the joint that a drive moves; a drive does not tell the current from its supply."""
        found = {}
        for drive in self._drives:
            node, temperature = drive.setup.node, drive.setup.temperature
            tenths = None if temperature is None else self._values.get((node, temperature))
            millivolts, share = self._values.get((node, VOLTAGE)), self._values.get((node, CURRENT))
            rated = self._values.get((node, RATED_CURRENT))
            found[drive.setup.moves] = MotorReading(
                temperature=None if tenths is None else tenths / 10.0,
                voltage=None if millivolts is None else millivolts / 1e3,
                phase_current=None if share is None or rated is None else abs(share) / 1e3 * rated / 1e3,
            )
        return found


class CanMotors(Motors):
    """The motors of a robot on CAN."""

    def __init__(self, readings: Callable[[], Mapping[str, MotorReading]]) -> None:
        self._readings = readings

    def state(self) -> Mapping[str, MotorReading]:
        """The last answers of the drives."""
        return self._readings()
