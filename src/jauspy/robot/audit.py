"""The audit log of a robot: commands with their operators, as JSON lines. Each line has the hash of the one before.

A thread writes, so that a slow disk does not slow the robot. `FILE.head` has the number and hash of the last line. What
this proves, and what it does not, is in docs/security.md.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import queue
import threading
import time
from collections import Counter, defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import partial
from itertools import chain, pairwise
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, Final, Self

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages import registry
from jauspy.messages.operators import SealedCommand
from jauspy.protocol.duplicates import ReplayWindow
from jauspy.protocol.seal import Operator
from jauspy.robot.audit_files import MAX_LINE, AuditFiles, head_file, parsed
from jauspy.robot.audit_heads import HeadSender, collected_heads
from jauspy.services.core.command_seal import CommandRecord

_LOG: Final = get_logger("jauspy.audit")

MAX_WAITING: Final = 1024
"""Records that wait for the disk; further ones are lost, and counted."""
MAX_UNSEALED: Final = 20
"""Records in a second without the seal of an operator: anybody can cause these. Further ones are counted only."""
MAX_PAYLOAD: Final = 16 * 1024
"""Bytes of a message that are recorded; of a longer one the hash."""
REPORT_INTERVAL: Final = 1.0
"""Seconds from one line about what was not recorded to the next."""
ATTEMPTS: Final = 4
"""Times that a log is read whose head file is behind: a robot that writes it saves the head after the lines."""
ATTEMPT_PAUSE: Final = 0.1
"""Seconds."""
CLOSE_TIMEOUT: Final = 5.0
"""Seconds that a disk has for the last lines."""
FIRST: Final = "0" * 64
"""The hash before the first line."""


@dataclass(frozen=True, slots=True)
class Head:
    """The last line of a log: its number, and its hash. With it, removal of the last lines can be detected."""

    number: int = 0
    hash: str = FIRST

    def __str__(self) -> str:
        return f"{self.number}:{self.hash}"

    @classmethod
    def parse(cls, text: str) -> Head:
        """Parse the text that `str` returns; raises `ConfigError`."""
        number, _, hash = text.strip().partition(":")
        if not number.isdecimal() or len(hash) != len(FIRST) or set(hash) - set("0123456789abcdef"):
            raise ConfigError(f"{text[:100]!r} is not the head of an audit log, which is NUMBER:HASH")
        return cls(int(number), hash)


class AuditLog:
    """Writes the log: `with AuditLog(path, "inc1") as log: log.record(...)`; continues an existing file.

    Raises `ConfigError` for a file that cannot be written, is written by another robot, or has something else. With
    `follow_links`, `path` may be a link. `heads` sends the heads to another machine.
    """

    def __init__(self, path: Path, robot: str, *, follow_links: bool = False, heads: HeadSender | None = None) -> None:
        self.path = path = path.resolve() if follow_links else path
        self.head = Head()
        self.counters: Counter[str] = Counter()
        """`lost`: the disk is slow; `not_written`: it is full or broken; `not_recorded`: more than `MAX_UNSEALED`."""
        self._robot = robot
        self._waiting: queue.Queue[CommandRecord | dict[str, Any] | None] = queue.Queue(MAX_WAITING)
        self._second = (0, 0)
        self._thread = threading.Thread(target=self._run, name=f"audit log {path}", daemon=True)
        self._files = AuditFiles(path)
        self._heads = heads
        self._first = ""
        self._size = 0
        self._failed = False

    def __enter__(self) -> Self:
        try:
            self._append([self._open() | {"event": "started", "robot": self._robot}])
        except OSError as error:
            self._files.close()
            raise ConfigError(f"audit_log {self.path}: {error.strerror}") from error
        except ConfigError:
            self._files.close()
            raise
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with suppress(queue.Full):
            self._waiting.put(None, timeout=CLOSE_TIMEOUT)
            self._thread.join(CLOSE_TIMEOUT)
        if not self._thread.is_alive():
            self._files.close()

    def record(self, record: CommandRecord) -> None:
        """Queue a record for the writing thread; never blocks.

        Records that cannot be written are counted, and the log notes their number later.
        """
        if record.operator is None:
            second, number = int(record.time.timestamp()), 0
            if second == self._second[0]:
                number = self._second[1]
            self._second = (second, number + 1)
            if number >= MAX_UNSEALED:
                self.counters["not_recorded"] += 1
                return
        try:
            self._waiting.put_nowait(record if len(record.payload) <= MAX_PAYLOAD else _line_of(record))
        except queue.Full:
            self.counters["lost"] += 1

    def note(self, entry: dict[str, Any]) -> None:
        """Queue a line with these keys; never blocks. For programs that know the users of commands without seals."""
        try:
            self._waiting.put_nowait(entry)
        except queue.Full:
            self.counters["lost"] += 1

    # --- the file -------------------------------------------------------------------------------------------------

    def _open(self) -> dict[str, Any]:
        """Open the files; returns a note for the log about its state."""
        self._files.open()
        self._size = os.fstat(self._files.log).st_size
        end = os.pread(self._files.log, MAX_LINE, max(0, self._size - MAX_LINE))
        expected = os.pread(self._files.head, 256, 0).decode("ascii", "replace").partition("\n")[0]
        first, newline, _ = os.pread(self._files.log, MAX_LINE, 0).partition(b"\n")
        self._first = _hash(first) if newline else ""
        found: dict[str, Any] = {}
        whole = end[: end.rfind(b"\n") + 1]
        if torn := end[len(whole) :]:
            found["torn"] = torn[:MAX_PAYLOAD].hex()  # a line that was being written when the power failed
            self._size -= len(torn)
        last = whole[:-1].rpartition(b"\n")[2]
        self.head = Head(_number(last), _hash(last)) if last else Head()
        if self._files.was_empty:
            found["emptied"] = True
            _LOG.error("%s exists and is empty, and should not be: its lines were removed", self.path)
        if expected and expected != str(self.head):
            found["expected_head"] = expected
            _LOG.error("%s ends at line %d, and should not: its head was %s", self.path, self.head.number, expected)
        return found

    def _run(self) -> None:
        """The thread: writes waiting records, and within a second the number of those that were not recorded."""
        reported = Counter[str]()
        closing = False
        while not closing:
            records: list[CommandRecord | dict[str, Any] | None] = []
            with suppress(queue.Empty):
                records.append(self._waiting.get(timeout=REPORT_INTERVAL if self.counters != reported else None))
                while len(records) < MAX_WAITING:
                    records.append(self._waiting.get_nowait())
            closing = None in records
            entries = [
                record if isinstance(record, dict) else _line_of(record) for record in records if record is not None
            ]
            counted = self.counters.copy()
            is_due = counted != reported and (closing or not entries)
            if is_due:
                entries.append({"event": "not recorded", **(counted - reported)})
            if closing:
                entries.append({"event": "closed"})
            if self._write(entries) and is_due:
                reported = counted

    def _write(self, entries: list[dict[str, Any]]) -> bool:
        """Append lines; false if that fails: then commands among them are counted, and the file is as before."""
        try:
            self._append(entries)
        except OSError as error:
            self.counters["not_written"] += sum("message" in entry for entry in entries)
            if not self._failed:
                _LOG.error("%s cannot be written: %s; commands are not recorded", self.path, error.strerror)
            self._failed = True
        else:
            self._failed = False
        return not self._failed

    def _append(self, entries: list[dict[str, Any]]) -> None:
        """Write lines and the head; `OSError` when they cannot be written as a whole."""
        head, lines = self.head, bytearray()
        for fields in entries:
            entry = {"n": head.number + 1, "time": datetime.now(UTC).isoformat(), **fields, "previous": head.hash}
            line = json.dumps(entry).encode("ascii")
            head = Head(head.number + 1, _hash(line))
            self._first = self._first or head.hash
            lines += line + b"\n"
        written = os.pwrite(self._files.log, lines, self._size)
        os.ftruncate(self._files.log, self._size + (len(lines) if written == len(lines) else 0))
        if written < len(lines):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        os.fsync(self._files.log)
        self._size += len(lines)
        self.head = head
        text = f"{head}\n".encode("ascii")
        os.pwrite(self._files.head, text, 0)
        os.ftruncate(self._files.head, len(text))
        if self._heads is not None:
            self._heads.offer(self._first, str(head))


def _line_of(record: CommandRecord) -> dict[str, Any]:
    operator, payload = record.operator, record.payload
    return {
        "time": record.time.isoformat(),
        "component": str(record.component),
        "source": str(record.source),
        "operator": operator.name if operator else None,
        "role": operator.role if operator else None,
        "message": record.message,
        "outcome": record.outcome,
        **({"payload": payload.hex()} if len(payload) <= MAX_PAYLOAD else {"sha256": _hash(payload)}),
    }


# --- verifying --------------------------------------------------------------------------------------------------------


@dataclass(slots=True)
class AuditReport:
    """The result of verifying a log: its head, the number of commands by operator, and the first problem."""

    head: Head = field(default_factory=Head)
    commands: Counter[str] = field(default_factory=Counter)
    """Counts by operator; `-` stands for commands without one."""
    refused: int = 0
    verified: int = 0
    """Commands whose signature was verified."""
    unverifiable: int = 0
    """Commands of operators above `MAX_PAYLOAD`: the log has their hash, and no signature."""
    not_recorded: int = 0
    problem: str = ""
    size: int = 0
    """Bytes of the lines that were verified."""
    numbers: defaultdict[Hashable, ReplayWindow] = field(default_factory=partial(defaultdict, ReplayWindow), repr=False)
    """The numbers of the commands that were sealed with one challenge: a robot takes each only once."""


def verify(
    path: Path, anchors: Iterable[Head] = (), operators: Iterable[Operator] = (), heads: Path | None = None
) -> AuditReport:
    """Check a log and its head file. `anchors`: heads that were noted earlier. `operators`: check their signatures.

    `heads`: a file with the heads that another machine has collected. Raises `ConfigError` for files that cannot be
    read.
    """
    path, anchors, by_name = path.resolve(), list(anchors), {operator.name: operator for operator in operators}
    try:
        if heads is not None:
            with path.open("rb") as stream:
                first = _hash(stream.readline(MAX_LINE).removesuffix(b"\n"))
            anchors += [Head(*collected_head) for collected_head in collected_heads(heads, first)]
        for attempt in range(ATTEMPTS):
            before = _saved_head(path)
            with path.open("rb") as stream:
                report = _verify(stream, before, anchors, by_name)
                stream.seek(report.size)
                is_torn = not _is_begin(stream.read(MAX_LINE), report.head.number + 1)
            if report.problem:
                break
            is_behind = before and report.head.number > (last := Head.parse(before).number)
            if not is_torn and not is_behind:
                break
            if _saved_head(path) == before and attempt == ATTEMPTS - 1:
                report.problem = _beyond(last, report.head.number) if is_behind else _no_line(report.head.number + 1)
            time.sleep(ATTEMPT_PAUSE)  # the robot may be writing: lines first, then the head
    except (OSError, UnicodeDecodeError) as error:
        raise ConfigError(f"{path}: cannot be read: {error}") from error
    return report


def _saved_head(path: Path) -> str:
    return head_file(path).read_text("ascii").strip() if head_file(path).exists() else ""


def _verify(stream: BinaryIO, head: str, anchors: list[Head], operators: Mapping[str, Operator]) -> AuditReport:
    report = AuditReport()
    wanted = [*anchors, *([Head.parse(head)] if head else [])]
    hashes: dict[int, str] = {}
    for expected in wanted:
        if hashes.setdefault(expected.number, expected.hash) != expected.hash:
            report.problem = f"the heads of line {expected.number} differ: one of them is of other lines"
            return report
    lines: Iterator[bytes | None] = chain(_lines(stream), [None])
    for line, following in pairwise(lines):
        assert line is not None
        problem = _problem(line, following, report.head, hashes)
        entry = parsed(line) or {}
        problem = problem or _count(entry, report, operators)
        if problem:
            report.problem = problem
            return report
        report.head = Head(report.head.number + 1, _hash(line))
        report.size += len(line) + 1
    for expected in wanted:
        if expected.number > report.head.number:
            report.problem = f"lines {report.head.number + 1} to {expected.number} were cut off at the end"
    if report.problem:
        return report
    if not report.head.number:
        report.problem = "has no lines: all were removed, since a robot writes the first one when it makes the file"
    elif not wanted:
        report.problem = "there is no head file; it is not known whether lines were cut off at the end"
    return report


def _problem(line: bytes, following: bytes | None, before: Head, hashes: Mapping[int, str]) -> str:
    """The problem of the next line."""
    number, entry = before.number + 1, parsed(line)
    if entry is None:
        return f"line {number} was changed: it is no line of an audit log"
    if entry["n"] != number or entry["previous"] != before.hash:
        after = parsed(following) if following is not None else None
        is_as_written = (after or {}).get("previous") == _hash(line) or hashes.get(entry["n"]) == _hash(line)
        if not is_as_written or entry["n"] < number:
            return f"line {number} was changed"
        if entry["n"] > number:
            return f"lines {number} to {entry['n'] - 1} were removed"
        return f"line {before.number} was changed" if before.number else "line 1 was changed"
    if (expected := hashes.get(number)) is not None and expected != _hash(line):
        return f"line {number} was changed: its hash is not that of the head"
    if "emptied" in entry:
        return f"all lines before line {number} were removed: the file was empty when the robot started"
    if "torn" in entry and not _is_begin(_of_hex(str(entry["torn"])), number):
        return _no_line(number)
    if "expected_head" in entry:
        expected_head = str(entry["expected_head"])
        last, _, _ = expected_head.partition(":")
        if last.isdecimal() and int(last[:18]) < number - 1:
            return _beyond(int(last[:18]), number - 1)
        return f"lines were cut off before line {number}: the head was {expected_head!r}"
    return ""


def _is_begin(data: bytes, number: int) -> bool:
    """True for bytes with which the line of this number may begin, as when the power fails while it is written."""
    begin = f'{{"n": {number}, "time": "'.encode("ascii")
    return data[: len(begin)] == begin[: len(data)] and all(0x20 <= byte < 0x7F for byte in data)


def _of_hex(text: str) -> bytes:
    try:
        return bytes.fromhex(text)
    except ValueError:
        return b"\0"


def _no_line(number: int) -> str:
    """The meaning of bytes that are no part of a line."""
    return (
        f"before line {number} are bytes that no robot writes: they were added by somebody else, or the disk lost what "
        "was being written when the power failed"
    )


def _beyond(head: int, last: int) -> str:
    """The meaning of lines after the one in the head file."""
    return (
        f"lines {head + 1} to {last} follow the line of the head file: they were added by somebody else, or the robot "
        "lost power before it could write its head"
    )


def _count(entry: dict[str, Any], report: AuditReport, operators: Mapping[str, Operator]) -> str:
    if entry.get("event") == "not recorded":
        report.not_recorded += sum(number for number in entry.values() if isinstance(number, int)) - entry["n"]
    if "message" not in entry:
        return ""
    name = entry.get("operator")
    if not isinstance(name, str | None):
        return f"line {entry['n']} was changed: it is no line of an audit log"
    report.commands[name or "-"] += 1
    report.refused += str(entry.get("outcome", "")).startswith("refused")
    if not operators or name is None:
        return ""
    if "payload" not in entry:
        report.unverifiable += 1
        return ""
    sealed = _sealed_as_recorded(entry, operators[name]) if name in operators else None
    if sealed is None:
        return f"line {entry['n']} was not written by the robot: {name!r} has not sealed this command"
    window = report.numbers[sealed.operator_key, sealed.destination, sealed.source, sealed.challenge_tag]
    if not window.is_new(sealed.counter):
        return f"line {entry['n']} was not written by the robot: {name!r} has sealed this command only once"
    window.add(sealed.counter)
    report.verified += 1
    return ""


def _sealed_as_recorded(entry: dict[str, Any], operator: Operator) -> SealedCommand | None:
    """The command of a line; None if this operator has not sealed what the line says."""
    try:
        payload = bytes.fromhex(entry["payload"])
        sealed = registry.decode_as(SealedCommand, payload)
    except (ValueError, TypeError, DecodeError):
        return None
    inside = sealed.command.NAME if isinstance(sealed.command, Message) else entry["message"]
    ids = [str(JausID.from_int(number)) for number in (sealed.destination, sealed.source)]
    recorded = [entry["message"], entry.get("component"), entry.get("source")]
    return sealed if operator.key.has_signed(payload) and [inside, *ids] == recorded else None


def _lines(stream: BinaryIO) -> Iterator[bytes]:
    """The whole lines; one at the end that is being written does not count."""
    while (line := stream.readline(MAX_LINE)).endswith(b"\n") or len(line) == MAX_LINE:
        yield line.removesuffix(b"\n")


def _number(line: bytes) -> int:
    entry = parsed(line)
    return entry["n"] if entry else 0


def _hash(line: bytes) -> str:
    return hashlib.sha256(line).hexdigest()
