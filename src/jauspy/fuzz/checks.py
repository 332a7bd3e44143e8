"""What must hold for any bytes: the checks of one case."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any, Final, NoReturn

from jauspy.codec import careful, reference
from jauspy.codec.base import Deviation, Message
from jauspy.errors import DecodeError, EncodeError
from jauspy.fuzz.agreement import difference
from jauspy.fuzz.effort import Effort, memory_complaint, spent_on
from jauspy.fuzz.findings import Problem
from jauspy.fuzz.targets import Target
from jauspy.fuzz.watch import TooLong, watched

LARGEST_FOR_REFERENCE: Final = 4096
"""The reference codec is slow; larger inputs are checked without it."""

MEMORY_EVERY: Final = 64
"""One case in so many has its memory measured, beside all of more than `LARGE` bytes."""

LARGE: Final = 2048

Tolerant = tuple[Message, list[Deviation]]


class _Broken(Exception):
    """Ends the checks of a case."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.problem = problem


class Checks:
    """All checks. `accepted` counts the cases that were valid messages."""

    def __init__(self, effort: Effort) -> None:
        self._effort = effort
        self.accepted = 0

    def problem(self, target: Target, data: bytes, *, valid: bool = False, memory: bool = True) -> Problem | None:
        """What is wrong with these bytes; `valid` when they are known to be a message."""
        try:
            with watched():
                self._run(target, data, valid=valid, memory=memory)
        except _Broken as broken:
            return broken.problem
        except TooLong as error:
            return Problem("time", "", str(error))
        return None

    def _run(self, target: Target, data: bytes, *, valid: bool, memory: bool) -> None:
        def both() -> tuple[Message | None, Tolerant]:
            return (
                _only("decode", (DecodeError,), lambda: target.cls.decode(data)),
                _only("tolerant", (), lambda: careful.decode_tolerant(target.cls, data)),
            )

        results: list[tuple[Message | None, Tolerant]] = []
        spent = spent_on(lambda: results.append(both()))
        message, (tolerant, deviations) = results[0]
        _complain("time", self._effort.complaint(len(data), spent, both))
        if memory or len(data) > LARGE:
            _complain("memory", memory_complaint(len(data), both))
        if valid and message is None:
            _fail("valid", deviations[0].path if deviations else "", f"rejected: {_first(deviations)}")
        self._check_tolerant(target, data, message, tolerant, deviations)
        if message is not None:
            self.accepted += 1
            self._check_stable(target, data, message)
        if len(data) <= LARGEST_FOR_REFERENCE:
            self._check_reference(target, data, message)

    @staticmethod
    def _check_stable(target: Target, data: bytes, message: Message) -> None:
        again = _only("encode", (), message.encode)
        if again != data:
            _fail("stable", "bytes", f"decodes to {message!r}, which encodes to {_short(again)}")
        if _only("decode", (), lambda: target.cls.decode(data)) != message:
            _fail("stable", "values", "decodes to two different messages")
        if _only("careful", (), lambda: careful.decode(target.cls, data)) != message:
            _fail("roads", "decode", f"straight-line code gives {message!r}, the careful codec something else")
        if _only("careful", (), lambda: careful.encode(message, clamp=False, strict=True)) != data:
            _fail("roads", "encode", "straight-line code and the careful codec encode differently")
        carried = _only("json", (), lambda: target.cls.from_dict(json.loads(json.dumps(message.to_dict()))))
        if carried != message:
            _fail("json", "", f"{message!r} becomes {carried!r}")

    @staticmethod
    def _check_tolerant(
        target: Target, data: bytes, message: Message | None, tolerant: Message, deviations: list[Deviation]
    ) -> None:
        if (message is None) != bool(deviations):
            _fail("tolerant", "verdict", f"strict says {message!r}, tolerant says {_first(deviations)}")
        if message is not None and tolerant != message:
            _fail("tolerant", "values", f"strict gives {message!r}, tolerant {tolerant!r}")
        if deviations and not any(deviation.lost for deviation in deviations):
            again = _only("tolerant", (), lambda: tolerant.encode(strict=False))
            if again != data:
                _fail("tolerant", "bytes", f"nothing was lost, and it encodes to {_short(again)}")
            twice, found = _only("tolerant", (), lambda: careful.decode_tolerant(target.cls, again))
            if found != deviations or repr(twice) != repr(tolerant):
                _fail("tolerant", "values", "decodes to two different messages")
            carried = _only("json", (), lambda: target.cls.from_dict(json.loads(json.dumps(tolerant.to_dict()))))
            if _only("json", (), lambda: carried.encode(strict=False)) != data:
                _fail("json", "", f"{tolerant!r} becomes {carried!r}")

    @staticmethod
    def _check_reference(target: Target, data: bytes, message: Message | None) -> None:
        values = _only("reference", (DecodeError,), lambda: reference.parse(target.model, data))
        if (message is None) != (values is None):
            accepts = "the reference codec" if message is None else "generated code"
            _fail("agreement", "verdict", f"only {accepts} takes these bytes")
        if message is None or values is None:
            return
        path = difference(target.layout, message, values)
        if path is not None:
            _fail("agreement", path or "value", f"{message!r} is {values!r} for the reference codec")
        built = _only("reference", (), lambda: reference.build(target.model, values))
        if built != data:
            _fail("agreement", "bytes", f"the reference codec encodes to {_short(built)}")


def _only(check: str, allowed: tuple[type[Exception], ...], call: Callable[[], Any]) -> Any:
    """The result of a call; `None` when it raises what it may. All else that is raised is a problem."""
    try:
        return call()
    except allowed:
        return None
    except (DecodeError, EncodeError) as error:
        _fail(check, f"{type(error).__name__} {error.path}".strip(), str(error))
    except Exception as error:  # noqa: BLE001 - that nothing else is raised is what is tested
        _fail(check, type(error).__name__, repr(error))


def _complain(check: str, seen: str | None) -> None:
    if seen is not None:
        _fail(check, "", seen)


def _fail(check: str, what: str, seen: str) -> NoReturn:
    raise _Broken(Problem(check, re.sub(r"\[\d+\]", "", what), seen if len(seen) <= 400 else f"{seen[:397]}..."))


def _short(data: bytes) -> str:
    return data.hex() if len(data) <= 64 else f"{data[:64].hex()}..."


def _first(deviations: list[Deviation]) -> str:
    return str(deviations[0]) if deviations else "nothing"
