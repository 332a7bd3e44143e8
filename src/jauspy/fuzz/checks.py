"""The checks of one case: invariants of decoding and encoding, agreement with the reference codec, time and memory."""

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
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import fields, is_dataclass
from typing import Any, Final, NoReturn

from jauspy.codec import reference, slow_path
from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Deviation, Message
from jauspy.codec.scalars import Scaling
from jauspy.errors import DecodeError, EncodeError
from jauspy.fuzz.findings import Problem
from jauspy.fuzz.messages import FuzzTarget
from jauspy.fuzz.mutation import Seed
from jauspy.ids import message_id


def difference(item: Item, value: Any, reference: Any) -> str | None:
    """The path of the first value that differs, without list positions; None if all agree.

    `reference` has the form of `to_dict`, with bytes where `value` may have a message.
    """
    compare = _COMPARE.get(type(item))
    return compare(item, value, reference) if compare else _differs(value != reference)


def _differs(different: bool, path: str = "") -> str | None:
    return path if different else None


def _hex(data: Message | bytes) -> str:
    return (data.encode() if isinstance(data, Message) else data).hex()


def _inside(name: str, item: Item, value: Any, reference: Any) -> str | None:
    found = difference(item, value, reference)
    return None if found is None else f"{name}.{found}".rstrip(".")


def _elements(item: Item, value: Any, reference: Any) -> str | None:
    if len(value) != len(reference):
        return "length"
    found = (difference(item, one, other) for one, other in zip(value, reference, strict=True))
    return next((path for path in found if path is not None), None)


def _choice(item: Choice, value: Any, reference: Any) -> str | None:
    if item.index.to_json(value.choice) != reference["choice"]:
        return "choice"
    return _inside("value", item.items[value.choice], value.value, reference["value"])


def _formatted(item: Formatted, value: Any, reference: Any) -> str | None:
    same = item.formats.to_json(value.format) == reference["format"] and _hex(value.data) == reference["data"]["hex"]
    return _differs(not same, "data")


def _grid(item: Grid, value: Any, reference: Any) -> str | None:
    return _elements(Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item, value, reference)


def _union(item: Union, value: Any, reference: Any) -> str | None:
    ((name, content),) = reference.items()
    arm = item.arms.get(name)
    return _inside(name, arm, value, content) if arm and type(value) is arm.cls else name


def _real(item: Real, value: Any, reference: Any) -> str | None:
    """Two ways to compute a scaled value may differ by a few float steps of the size of its limits."""
    rounding = 8 * math.ulp(max(abs(item.scaling.lower), abs(item.scaling.upper)))
    return _differs(abs(value - reference) > rounding)


def _composite(item: Composite, value: Any, reference: dict[str, Any]) -> str | None:
    left = dict(reference)
    for slot in item.slots:
        field_value, other = getattr(value, slot.name), left.pop(slot.name, None)
        if (field_value is None) != (other is None):
            return slot.name
        found = None if field_value is None else _inside(slot.name, slot.item, field_value, other)
        if found is not None:
            return found
    spare = left.pop("reserved_presence", 0)
    if item.undefined and value.reserved_presence != spare:
        return "reserved_presence"
    return next(iter(left), None)


_COMPARE: Final[Mapping[type[Item], Callable[[Any, Any, Any], str | None]]] = {
    Composite: _composite,
    Choice: _choice,
    Formatted: _formatted,
    Grid: _grid,
    Union: _union,
    Real: _real,
    Bits: lambda item, value, reference: _differs(item.to_json(value) != reference),
    Number: lambda item, value, reference: _differs(item.to_json(value) != reference),
    Blob: lambda _, value, reference: _differs(_hex(value) != reference["hex"]),
    Repeat: lambda item, value, reference: _elements(item.item, value, reference),
}
"""Functions that compare the values of items, by kind; other values must be equal."""

MAX_CPU_SECONDS: Final = 20.0
"""Processor time after which a case is aborted as endless; far beyond the limits of `CostLimit`."""


class CpuLimitExceeded(BaseException):
    """A case has used up its processor time. Not an `Exception`, so the code under test cannot catch it."""


@contextmanager
def cpu_limited() -> Iterator[None]:
    """Raise `CpuLimitExceeded` if the block takes too much processor time. Has no effect outside of the main thread."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGVTALRM, _stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, MAX_CPU_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def _stop(number: int, frame: Any) -> NoReturn:  # noqa: ARG001 - a signal handler gets both
    raise CpuLimitExceeded(f"no end after {MAX_CPU_SECONDS:g} s of processor time")


MAX_COST_RATIO = 100
"""Time that an input may take, relative to a normal message of its size."""

MIN_MEASURED_SIZE = 512
"""Bytes; smaller inputs get the limit of this size."""

DEFAULT_RATE = 250.0
"""Nanoseconds per byte, used if no seed can be measured."""

MAX_SAMPLES = 50
"""Seeds that are measured to find the normal rate, the largest first: in short ones the call dominates."""

MAX_BLOCKS_PER_BYTE = 100
MAX_PEAK_PER_BYTE = 5000
"""Memory blocks and peak bytes per byte of input; a list of small records takes about 2 blocks and 100 bytes."""


class CostLimit:
    """The limit of processor time per input size, derived from seeds. Other load on the machine does not change it."""

    def __init__(self, normal: Iterable[tuple[FuzzTarget, Seed]]) -> None:
        samples = sorted(normal, key=lambda pair: len(pair[1].data))[-MAX_SAMPLES:]
        rates = [rate for target, seed in samples for rate in _time_per_byte(target, seed.data)]
        self._rate = max(1.0, statistics.median(rates)) if rates else DEFAULT_RATE

    def limit(self, size: int) -> float:
        """The nanoseconds that an input of this size may take."""
        return MAX_COST_RATIO * self._rate * max(size, MIN_MEASURED_SIZE)

    def problem(self, size: int, spent: float, again: Callable[[], object]) -> str | None:
        """Describe a case that takes too long, or `None`. A slow case is measured three times more; the best counts."""
        limit = self.limit(size)
        if spent <= limit:
            return None
        best = spent
        for _ in range(3):
            best = min(best, spent_on(again))
            if best <= limit:
                return None
        return (
            f"{size} bytes took {best / 1e6:.0f} ms, {best / limit * MAX_COST_RATIO:.0f} times as long as normal ones"
        )


def spent_on(call: Callable[[], object]) -> float:
    """Nanoseconds of processor time."""
    start = time.thread_time_ns()
    call()
    return time.thread_time_ns() - start


def memory_problem(size: int, call: Callable[[], object]) -> str | None:
    """Describe a call that takes too much memory at its peak, or whose result keeps too much; `None` if it does not."""
    before = sys.getallocatedblocks()
    kept = call()
    blocks = sys.getallocatedblocks() - before
    del kept
    if blocks > 2000 + MAX_BLOCKS_PER_BYTE * size:
        return f"the message made of {size} bytes keeps {blocks} blocks of memory"
    tracemalloc.start()
    try:
        call()
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    if peak > 1_000_000 + MAX_PEAK_PER_BYTE * size:
        return f"decoding {size} bytes takes {peak} bytes of memory"
    return None


def _time_per_byte(target: FuzzTarget, data: bytes) -> list[float]:
    """Nanoseconds per byte; empty for a message that cannot be decoded, which the checks report."""
    try:
        with cpu_limited():
            return [min(spent_on(lambda: target.cls.decode(data)) for _ in range(5)) / len(data)]
    except (Exception, CpuLimitExceeded):  # noqa: BLE001 - see above
        return []


MAX_REFERENCE_SIZE: Final = 4096
"""Bytes; the reference codec is slow, so larger inputs are checked without it."""

MEMORY_INTERVAL: Final = 64
"""One in this many cases has its memory measured, and every case of more than `ALWAYS_MEASURED_SIZE` bytes."""

ALWAYS_MEASURED_SIZE: Final = 2048

TolerantResult = tuple[Message, list[Deviation]]


class _CheckFailed(Exception):
    """A check does not hold; ends the checks of the case."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.problem = problem


class Checks:
    """All checks. `accepted` counts the cases that were valid messages."""

    def __init__(self, cost: CostLimit) -> None:
        self._cost = cost
        self.accepted = 0

    def problem(self, target: FuzzTarget, data: bytes, *, valid: bool = False, memory: bool = True) -> Problem | None:
        """The first problem with these bytes, or None; `valid` when they are a message by construction."""
        try:
            with cpu_limited():
                self._run(target, data, valid=valid, memory=memory)
        except _CheckFailed as broken:
            return broken.problem
        except CpuLimitExceeded as error:
            return Problem("time", "", str(error))
        return None

    def _run(self, target: FuzzTarget, data: bytes, *, valid: bool, memory: bool) -> None:
        def both() -> tuple[Message | None, TolerantResult]:
            return (
                _call("decode", (DecodeError,), lambda: target.cls.decode(data)),
                _call("tolerant", (), lambda: slow_path.decode_tolerant(target.cls, data)),
            )

        results: list[tuple[Message | None, TolerantResult]] = []
        spent = spent_on(lambda: results.append(both()))
        message, (tolerant, deviations) = results[0]
        _fail_if("time", self._cost.problem(len(data), spent, both))
        if memory or len(data) > ALWAYS_MEASURED_SIZE:
            _fail_if("memory", memory_problem(len(data), both))
        if valid and message is None:
            _fail("valid", deviations[0].path if deviations else "", f"rejected: {_first_deviation(deviations)}")
        self._check_foreign(target, data)
        self._check_tolerant(target, data, message, tolerant, deviations)
        if message is not None:
            self.accepted += 1
            self._check_stable(target, data, message)
        if len(data) <= MAX_REFERENCE_SIZE:
            self._check_reference(target, data, message)

    @staticmethod
    def _check_foreign(target: FuzzTarget, data: bytes) -> None:
        """The same bytes with the id of another message are not accepted."""
        for foreign in (bytes([data[0] ^ 1]), bytes([data[0], data[1] ^ 0x40])):
            other = foreign + data[len(foreign) :]
            for path, call in (
                ("decode", lambda: target.cls.decode(other)),  # noqa: B023 - called at once
                ("tolerant", lambda: slow_path.decode_tolerant(target.cls, other)),  # noqa: B023
            ):
                if _call("foreign", (DecodeError,), call) is not None:
                    id = message_id(other)
                    _fail("foreign", path, f"it takes a message with the id {id:04X}h, which is not its own")

    @staticmethod
    def _check_stable(target: FuzzTarget, data: bytes, message: Message) -> None:
        again = _call("encode", (), message.encode)
        if again != data and not _loses_bits(message):
            _fail("stable", "bytes", f"decodes to {message!r}, which encodes to {_short(again)}")
        if again != data and _call("decode", (), lambda: target.cls.decode(again)) != message:
            _fail("stable", "values", f"decodes to {message!r}, which encodes to another message")
        if _call("decode", (), lambda: target.cls.decode(data)) != message:
            _fail("stable", "values", "decodes to two different messages")
        if _call("slow path", (), lambda: slow_path.decode(target.cls, data)) != message:
            _fail("paths", "decode", f"the fast path gives {message!r}, the slow path something else")
        if _call("slow path", (), lambda: slow_path.encode(message, clamp=False, strict=True)) != again:
            _fail("paths", "encode", "the fast path and the slow path encode differently")
        carried = _call("json", (), lambda: target.cls.from_dict(json.loads(json.dumps(message.to_dict()))))
        if carried != message:
            _fail("json", "", f"{message!r} becomes {carried!r}")

    @staticmethod
    def _check_tolerant(
        target: FuzzTarget, data: bytes, message: Message | None, tolerant: Message, deviations: list[Deviation]
    ) -> None:
        if (message is None) != bool(deviations):
            _fail("tolerant", "verdict", f"strict says {message!r}, tolerant says {_first_deviation(deviations)}")
        if message is not None and tolerant != message:
            _fail("tolerant", "values", f"strict gives {message!r}, tolerant {tolerant!r}")
        if deviations and not any(deviation.lost for deviation in deviations):
            again = _call("tolerant", (), lambda: tolerant.encode(strict=False))
            if again != data and not _loses_bits(tolerant):
                _fail("tolerant", "bytes", f"nothing was lost, and it encodes to {_short(again)}")
            twice, found = _call("tolerant", (), lambda: slow_path.decode_tolerant(target.cls, again))
            if found != deviations or repr(twice) != repr(tolerant):
                _fail("tolerant", "values", "decodes to two different messages")
            carried = _call("json", (), lambda: target.cls.from_dict(json.loads(json.dumps(tolerant.to_dict()))))
            if _call("json", (), lambda: carried.encode(strict=False)) != again:
                _fail("json", "", f"{tolerant!r} becomes {carried!r}")

    @staticmethod
    def _check_reference(target: FuzzTarget, data: bytes, message: Message | None) -> None:
        values = _call("reference", (DecodeError,), lambda: reference.parse(target.model, data))
        if (message is None) != (values is None):
            accepts = "the reference codec" if message is None else "generated code"
            _fail("agreement", "verdict", f"only {accepts} takes these bytes")
        if message is None or values is None:
            return
        path = difference(target.layout, message, values)
        if path is not None:
            _fail("agreement", path or "value", f"{message!r} is {values!r} for the reference codec")
        built = _call("reference", (), lambda: reference.build(target.model, values))
        if built != data and not (_loses_bits(message) and reference.parse(target.model, built) == values):
            _fail("agreement", "bytes", f"the reference codec encodes to {_short(built)}")


def _call(check: str, allowed: tuple[type[Exception], ...], call: Callable[[], Any]) -> Any:
    """The result of a call; `None` if it raises an allowed exception. Any other exception is a problem."""
    try:
        return call()
    except allowed:
        return None
    except (DecodeError, EncodeError) as error:
        _fail(check, f"{type(error).__name__} {error.path}".strip(), str(error))
    except Exception as error:  # noqa: BLE001 - that nothing else is raised is what is tested
        _fail(check, type(error).__name__, repr(error))


def _fail_if(check: str, seen: str | None) -> None:
    if seen is not None:
        _fail(check, "", seen)


def _fail(check: str, what: str, seen: str) -> NoReturn:
    raise _CheckFailed(Problem(check, re.sub(r"\[\d+\]", "", what), seen if len(seen) <= 400 else f"{seen[:397]}..."))


def _loses_bits(value: object) -> bool:
    """True for values with a real that is sent in more bits than a float has; nested messages included."""
    if isinstance(value, Message) and _has_fine_scale(type(value)):
        return True
    if is_dataclass(value):
        return any(_loses_bits(getattr(value, field.name)) for field in fields(value))
    return isinstance(value, list) and any(map(_loses_bits, value))


def _has_fine_scale(cls: type[Message]) -> bool:
    left: list[object] = [cls.layout()]
    while left:
        item = left.pop()
        if isinstance(item, Scaling):
            if item.is_finer_than_floats:
                return True
        elif isinstance(item, Item | Slot):
            left += [getattr(item, field.name) for field in fields(item)]  # type: ignore[arg-type]
        elif isinstance(item, Mapping):
            left += item.values()
        elif isinstance(item, list | tuple):
            left += item
    return False


def _short(data: bytes) -> str:
    return data.hex() if len(data) <= 64 else f"{data[:64].hex()}..."


def _first_deviation(deviations: list[Deviation]) -> str:
    return str(deviations[0]) if deviations else "nothing"
