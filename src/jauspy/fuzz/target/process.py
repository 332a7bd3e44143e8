"""The process of a target: whether it runs, its memory, and how it is started again."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
import sys
import tempfile
from typing import IO, Final

import psutil

from jauspy.errors import ConfigError

END_TIME: Final = 2.0
"""Seconds that a target has to end after SIGTERM, before SIGKILL."""
GUARD: Final = "import os, sys; sys.stdin.readline() or os.killpg(int(sys.argv[1]), 9)"
"""A program that kills a process group when its standard input closes without a line."""
MAX_ERRORS: Final = 2000
"""Bytes of the standard error of a process that died which a finding quotes: the last ones."""


class TargetProcess:
    """The process of a target: that of `pid`, or one that `command` starts, or neither, so that little is known.

    A process that was started ends with this one, even if this one is killed, as a worker of a cluster may be.
    """

    def __init__(self, command: str = "", pid: int | None = None) -> None:
        self._command = shlex.split(command)
        self._started: subprocess.Popen[bytes] | None = None
        self._guard: subprocess.Popen[bytes] | None = None
        self._errors: IO[bytes] | None = None
        self._process = _process(pid) if pid is not None else None

    @property
    def can_restart(self) -> bool:
        """True if there is a command."""
        return bool(self._command)

    @property
    def is_known(self) -> bool:
        """True if there is a process to look at."""
        return self._process is not None

    @property
    def pid(self) -> int | None:
        """The number of the process, if it is known."""
        return None if self._process is None else self._process.pid

    @property
    def is_running(self) -> bool:
        """False once the known process has ended."""
        if self._started is not None:
            return self._started.poll() is None
        try:
            return self._process is not None and self._process.status() != psutil.STATUS_ZOMBIE
        except psutil.Error:
            return False

    @property
    def memory(self) -> int | None:
        """Resident bytes; None without a process."""
        try:
            return None if self._process is None else int(self._process.memory_info().rss)
        except psutil.Error:
            return None

    @property
    def ending(self) -> str:
        """How the process ended, and the end of what it wrote to standard error."""
        if self._started is None or self._errors is None:
            return "its process is gone"
        status = self._started.poll()
        how = f"by {signal.Signals(-status).name}" if status is not None and status < 0 else f"with status {status}"
        size = self._errors.seek(0, os.SEEK_END)
        self._errors.seek(max(0, size - MAX_ERRORS))
        text = self._errors.read().decode("utf-8", "replace").strip()
        return f"its process ended {how}" + (f": {text}" if text else "")

    def restart(self) -> None:
        """End the process that was started, and start a new one. Raises `ConfigError` if that is not possible."""
        self.close()
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - until the process is closed
        try:
            self._started = subprocess.Popen(  # noqa: S603 # nosec B603 # the user's own command
                self._command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=self._errors,
                start_new_session=True,
            )
        except OSError as error:
            raise ConfigError(f"--restart: {self._command[0]} cannot be started: {error.strerror}") from error
        self._guard = subprocess.Popen(  # noqa: S603 # nosec B603
            [sys.executable, "-I", "-S", "-c", GUARD, str(self._started.pid)],
            stdin=subprocess.PIPE,
            start_new_session=True,
        )
        self._process = _process(self._started.pid)

    def close(self) -> None:
        """End the process that was started, with all that it has started; that of `pid` is left alone."""
        if self._started is not None:
            for sign in (signal.SIGTERM, signal.SIGKILL):
                try:
                    os.killpg(self._started.pid, sign)
                except ProcessLookupError:
                    break
                try:
                    self._started.wait(END_TIME)
                except subprocess.TimeoutExpired:
                    continue
            self._started.wait()
            self._started = self._process = None
        if self._guard is not None:
            self._guard.communicate(b"ended\n")
            self._guard = None
        if self._errors is not None:
            self._errors.close()
            self._errors = None


def _process(pid: int) -> psutil.Process:
    try:
        return psutil.Process(pid)
    except psutil.Error as error:
        raise ConfigError(f"there is no process {pid}; give --pid the one of the target") from error
