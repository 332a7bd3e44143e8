"""What must hold for any bytes: the checks of one case."""

from __future__ import annotations

import json
import math
import re
import signal
import statistics
import sys
import threading
import time
import tracemalloc
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, Final, NoReturn

from jauspy.codec import reference, slow_path
from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Deviation, Message
from jauspy.errors import DecodeError, EncodeError
from jauspy.fuzz.findings import Problem
from jauspy.fuzz.messages import Target
from jauspy.fuzz.mutation import Seed


def difference(item: Item, ours: Any, theirs: Any) -> str | None:
    """The path of the first value that differs, list positions left out; `None` when all agree.

    `theirs` has the form of `to_dict`, with bytes where `ours` may have a message.
    """
    match item:
        case Composite():
            return _composite(item, ours, theirs)
        case Bits():
            return None if item.to_json(ours) == theirs else ""
        case Real():
            return None if abs(ours - theirs) <= _rounding(item) else ""
        case Choice():
            if item.index.to_json(ours.choice) != theirs["choice"]:
                return "choice"
            return _inside("value", item.items[ours.choice], ours.value, theirs["value"])
        case Formatted():
            same = item.formats.to_json(ours.format) == theirs["format"]
            return None if same and _hex(ours.data) == theirs["data"]["hex"] else "data"
        case Blob():
            return None if _hex(ours) == theirs["hex"] else ""
        case Repeat():
            return _elements(item.item, ours, theirs)
        case Grid():
            inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
            return _elements(inner, ours, theirs)
        case Union():
            ((name, value),) = theirs.items()
            arm = item.arms.get(name)
            return _inside(name, arm, ours, value) if arm and type(ours) is arm.cls else name
        case Number():
            return None if item.to_json(ours) == theirs else ""
        case _:
            return None if ours == theirs else ""


def _hex(data: Message | bytes) -> str:
    return (data.encode() if isinstance(data, Message) else data).hex()


def _inside(name: str, item: Item, ours: Any, theirs: Any) -> str | None:
    found = difference(item, ours, theirs)
    return None if found is None else f"{name}.{found}".rstrip(".")


def _elements(item: Item, ours: Any, theirs: Any) -> str | None:
    if len(ours) != len(theirs):
        return "length"
    found = (difference(item, mine, other) for mine, other in zip(ours, theirs, strict=True))
    return next((path for path in found if path is not None), None)


def _composite(item: Composite, ours: Any, theirs: dict[str, Any]) -> str | None:
    left = dict(theirs)
    for slot in item.slots:
        mine, other = getattr(ours, slot.name), left.pop(slot.name, None)
        if (mine is None) != (other is None):
            return slot.name
        found = None if mine is None else _inside(slot.name, slot.item, mine, other)
        if found is not None:
            return found
    spare = left.pop("reserved_presence", 0)
    if item.undefined and ours.reserved_presence != spare:
        return "reserved_presence"
    return next(iter(left), None)


def _rounding(item: Real) -> float:
    """How far two ways to compute a scaled value may be apart: a few steps of a float of the size of its limits."""
    return 8 * math.ulp(max(abs(item.scaling.lower), abs(item.scaling.upper)))


MOST_SECONDS: Final = 20.0
"""Processor time of one case: far beyond every limit, so only for what would never end."""


class TooLong(BaseException):
    """Raised in the middle of the case, past everything that handles exceptions."""


@contextmanager
def watched() -> Iterator[None]:
    """Raise `TooLong` when the block takes too much processor time; only the main thread can be watched."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGVTALRM, _stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, MOST_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def _stop(number: int, frame: Any) -> NoReturn:  # noqa: ARG001 - a signal handler gets both
    raise TooLong(f"no end after {MOST_SECONDS:g} s of processor time")


TIMES = 100
"""How much more than a normal message of its size an input may cost."""

SMALLEST = 512
"""Inputs below this many bytes are measured as if they had so many."""

USUAL_RATE = 250.0
"""Nanoseconds per byte where nothing can be measured."""

LONGEST = 50
"""Seeds that show what is normal; the shortest ones show what a call costs."""

BLOCKS_PER_BYTE = 100
PEAK_PER_BYTE = 5000
"""Normal are about 2 blocks and 100 bytes of memory for every byte of a list of small records."""


class Effort:
    """Measures with the processor time of this thread, which others on the machine do not change."""

    def __init__(self, normal: Iterable[tuple[Target, Seed]]) -> None:
        samples = sorted(normal, key=lambda pair: len(pair[1].data))[-LONGEST:]
        rates = [rate for target, seed in samples for rate in _time_per_byte(target, seed.data)]
        self._rate = max(1.0, statistics.median(rates)) if rates else USUAL_RATE

    def limit(self, size: int) -> float:
        """The nanoseconds that an input of this size may take."""
        return TIMES * self._rate * max(size, SMALLEST)

    def complaint(self, size: int, spent: float, again: Callable[[], object]) -> str | None:
        """What is wrong with the time of a case. What looks slow is measured three times more; the best counts."""
        limit = self.limit(size)
        if spent <= limit:
            return None
        best = spent
        for _ in range(3):
            best = min(best, spent_on(again))
            if best <= limit:
                return None
        return f"{size} bytes took {best / 1e6:.0f} ms, {best / limit * TIMES:.0f} times as long as normal ones"


def spent_on(call: Callable[[], object]) -> float:
    """Nanoseconds of processor time."""
    start = time.thread_time_ns()
    call()
    return time.thread_time_ns() - start


def memory_complaint(size: int, call: Callable[[], object]) -> str | None:
    """What is wrong with the memory that a call takes at its peak, and with what its result keeps."""
    before = sys.getallocatedblocks()
    kept = call()
    blocks = sys.getallocatedblocks() - before
    del kept
    if blocks > 2000 + BLOCKS_PER_BYTE * size:
        return f"the message made of {size} bytes keeps {blocks} blocks of memory"
    tracemalloc.start()
    try:
        call()
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    if peak > 1_000_000 + PEAK_PER_BYTE * size:
        return f"decoding {size} bytes takes {peak} bytes of memory"
    return None


def _time_per_byte(target: Target, data: bytes) -> list[float]:
    """Nothing for a message that cannot be decoded: why that is so, the checks will say."""
    try:
        with watched():
            return [min(spent_on(lambda: target.cls.decode(data)) for _ in range(5)) / len(data)]
    except (Exception, TooLong):  # noqa: BLE001 - see above
        return []


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
                _only("tolerant", (), lambda: slow_path.decode_tolerant(target.cls, data)),
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
        if _only("careful", (), lambda: slow_path.decode(target.cls, data)) != message:
            _fail("roads", "decode", f"straight-line code gives {message!r}, the careful codec something else")
        if _only("careful", (), lambda: slow_path.encode(message, clamp=False, strict=True)) != data:
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
            twice, found = _only("tolerant", (), lambda: slow_path.decode_tolerant(target.cls, again))
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
