"""Sends the heads of an audit log to another machine by syslog, and reads them from what that machine has collected.

Who rewrites the log on the robot's disk cannot change what another machine has. A thread sends; nothing waits for it.
"""

from __future__ import annotations

import os
import re
import socket
import threading
from collections import Counter
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Final, Self
from urllib.parse import urlsplit

from jauspy.errors import ConfigError
from jauspy.logs import get_logger

_LOG: Final = get_logger("jauspy.audit")

INTERVAL: Final = 1.0
"""Seconds from one head to the next; those in between are left out, since each covers all lines before it."""
TIMEOUT: Final = 3.0
"""Seconds that a connection may take."""
SYSLOG_PORT: Final = 514
PRIORITY: Final = 13 * 8 + 6
"""Priority of facility `log audit` and severity `informational` (RFC 5424)."""
MAX_LINE: Final = 4096
"""Bytes of a collected line."""
MAX_HEADS: Final = 1_000_000
"""Most heads of one log in a collected file."""

_HEAD: Final = re.compile(rb"\bjauspy-audit log=([0-9a-f]{64}) head=([0-9]{1,18}):([0-9a-f]{64})\b")


class HeadSender:
    """Sends heads to `syslog://HOST[:PORT]` (UDP) or `syslog+tcp://HOST[:PORT]`: `with HeadSender(url) as sender`."""

    def __init__(self, url: str, *, interval: float = INTERVAL) -> None:
        self.counters: Counter[str] = Counter()
        """`heads_sent`, and `heads_not_sent` for failed attempts."""
        self._address, self._is_tcp = _address(url)
        self._url = url
        self._interval = interval
        self._latest = ""
        self._lock = threading.Lock()
        self._changed = threading.Event()
        self._closing = threading.Event()
        self._socket: socket.socket | None = None
        self._failed = False
        self._thread = threading.Thread(target=self._run, name=f"audit heads to {url}", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._closing.set()
        self._changed.set()
        self._thread.join(TIMEOUT)

    def offer(self, log: str, head: str) -> None:
        """Have the head of a log sent, unless a later one comes first; never blocks. `log` is the hash of line 1."""
        with self._lock:
            self._latest = f"jauspy-audit log={log} head={head}"
        self._changed.set()

    def _run(self) -> None:
        """The thread: sends the latest head, again after a failure, until closed."""
        while True:
            self._changed.wait()
            self._changed.clear()
            with self._lock:
                text = self._latest
            is_sent = not text or self._sent(text)
            with self._lock:
                if is_sent and self._latest == text:
                    self._latest = ""
                is_done = not self._latest
            if self._closing.is_set() and (is_done or self._failed):
                break
            if not is_done:
                self._changed.set()
            self._closing.wait(self._interval)
        self._close()

    def _sent(self, text: str) -> bool:
        now = datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
        line = f"<{PRIORITY}>1 {now} {socket.gethostname()} jauspy {os.getpid()} - - {text}"
        try:
            if self._socket is None:
                self._socket = self._connected()
            self._socket.sendall(line.encode("ascii", "replace") + (b"\n" if self._is_tcp else b""))
        except OSError as error:
            self._close()
            self.counters["heads_not_sent"] += 1
            if not self._failed:
                _LOG.error("heads of the audit log are not sent to %s: %s", self._url, error)
            self._failed = True
            return False
        self.counters["heads_sent"] += 1
        self._failed = False
        return True

    def _connected(self) -> socket.socket:
        if self._is_tcp:
            return socket.create_connection(self._address, TIMEOUT)
        family, kind, protocol, _, address = socket.getaddrinfo(*self._address, type=socket.SOCK_DGRAM)[0]
        made = socket.socket(family, kind, protocol)
        made.settimeout(TIMEOUT)
        made.connect(address)
        return made

    def _close(self) -> None:
        if self._socket is not None:
            with suppress(OSError):
                self._socket.close()
        self._socket = None


def _address(url: str) -> tuple[tuple[str, int], bool]:
    """Host and port, and whether it is by TCP."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port
    except ValueError:
        host, port = None, None
    if host is None or parts.scheme not in ("syslog", "syslog+tcp") or parts.path or parts.query:
        raise ConfigError(f"{url!r} is not syslog://HOST:PORT (UDP) or syslog+tcp://HOST:PORT")
    return (host, SYSLOG_PORT if port is None else port), parts.scheme == "syslog+tcp"


def collected_heads(path: Path, log: str) -> list[tuple[int, str]]:
    """Numbers and hashes of the heads of one log among the lines of a syslog's file.

    Raises `ConfigError` if it has none, so that a log that was written anew is noticed, or cannot be read.
    """
    found: dict[tuple[int, str], None] = {}
    logs: set[str] = set()
    try:
        if path.exists() and not path.is_file():
            raise ConfigError(f"{path}: is not a regular file")
        with path.open("rb") as stream:
            while line := stream.readline(MAX_LINE):
                for match in _HEAD.finditer(line):
                    if match[1].decode() == log:
                        found[int(match[2]), match[3].decode()] = None
                    elif len(logs) < MAX_HEADS:
                        logs.add(match[1].decode())
                if len(found) > MAX_HEADS:
                    raise ConfigError(f"{path}: has more than {MAX_HEADS} heads of this log; give a part of the file")
    except OSError as error:
        raise ConfigError(f"{path}: cannot be read: {error.strerror}") from error
    if not found:
        raise ConfigError(
            f"{path}: has no head of this log, and has those of {len(logs)} others: it is not of this robot and time, "
            "or all lines of the log were written anew"
        )
    return list(found)
