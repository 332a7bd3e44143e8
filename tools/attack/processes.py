"""Victims as processes, and what they use."""

from __future__ import annotations

import contextlib
import json
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Final

import psutil

from .attack import BoundBroken, NotStarted
from .hosts import Host
from .truth import TruthFile

OBSERVED: Final = str(Path(__file__).with_name("observed.py"))
SUBSCRIBER: Final = str(Path(__file__).with_name("subscriber.py"))
HONEST: Final = str(Path(__file__).with_name("honest.py"))
PILOT: Final = str(Path(__file__).with_name("pilot.py"))
_START_TIMEOUT: Final = 40.0
_ANSWER_TIMEOUT: Final = 20.0
_MIB: Final = 1 << 20


@dataclass(frozen=True, slots=True)
class Usage:
    """What a process uses: MiB of memory (the peak since the last look), open descriptors, tasks, logged lines."""

    memory: float
    descriptors: int
    tasks: int
    lines: int


class Victim:
    """A command of jauspy that runs until it is stopped; its standard error goes to a file.

    `mutant` is a name of `mutants.py`: a defect that the command has; empty for none.
    """

    def __init__(self, host: Host, folder: Path, name: str, arguments: Sequence[str], mutant: str = "") -> None:
        self.name = name
        self.truth = TruthFile(folder / f"{name}.truth")
        """Where a robot truly is."""
        self._log = folder / f"{name}.log"
        self._answer = folder / f"{name}.tasks"
        with self._log.open("wb") as log:
            self._process = subprocess.Popen(
                host.command(sys.executable, OBSERVED, str(self.truth.path), mutant, *arguments),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                env={**os.environ, "PYTHONUNBUFFERED": "1"},
            )

    @property
    def pid(self) -> int:
        """The process id."""
        return self._process.pid

    def wait_for(self, text: str) -> None:
        """Wait for a line of output with this text."""
        wait_for(self._output, text, self.name)

    def wait_until_logged(self, text: str) -> None:
        """Wait for this text in its log; raises `NotStarted` when the process ends before, or takes too long."""
        deadline = time.monotonic() + _START_TIMEOUT
        while text.encode() not in self._log.read_bytes():
            if self._process.poll() is not None or time.monotonic() > deadline:
                raise NotStarted(f"the {self.name} did not start: {self.last_line()}")
            time.sleep(0.1)

    def usage(self) -> Usage:
        """What it uses now; the peak of the memory begins anew. Raises `BoundBroken` when it has ended or hangs."""
        if (status := self._process.poll()) is not None:
            raise BoundBroken(f"the {self.name} ended with exit status {status}: {self.last_line()}")
        process = psutil.Process(self.pid)
        memory = _peak(self.pid)
        with contextlib.suppress(OSError):
            Path(f"/proc/{self.pid}/clear_refs").write_text("5")
        return Usage(memory, process.num_fds(), self._tasks(), self.lines())

    def lines(self) -> int:
        """Lines logged so far."""
        with self._log.open("rb") as log:
            return sum(chunk.count(b"\n") for chunk in iter(lambda: log.read(_MIB), b""))

    def last_line(self) -> str:
        """The last logged line."""
        text = self._log.read_bytes()[-4096:].decode(errors="replace").strip()
        return text.rpartition("\n")[2] or "it logged nothing"

    @contextlib.contextmanager
    def stopped(self) -> Iterator[None]:
        """Within this the process does not run."""
        self._process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self._process.send_signal(signal.SIGCONT)

    def stop(self) -> None:
        """End it."""
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                with contextlib.suppress(BrokenPipeError):
                    stream.close()

    @property
    def _output(self) -> IO[bytes]:
        assert self._process.stdout is not None
        return self._process.stdout

    def _tasks(self) -> int:
        assert self._process.stdin is not None
        self._answer.unlink(missing_ok=True)
        self._process.stdin.write(f"{self._answer}\n".encode())
        self._process.stdin.flush()
        deadline = time.monotonic() + _ANSWER_TIMEOUT
        while not self._answer.exists():
            if time.monotonic() > deadline:
                raise BoundBroken(f"the {self.name} hangs: it did not answer for {_ANSWER_TIMEOUT:g} s")
            time.sleep(0.01)
        return int(self._answer.read_text())


def _peak(pid: int) -> float:
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) / 1024
    return 0.0


class Honest:
    """A program of the operator that is told words on its standard input; its standard error goes to a file."""

    def __init__(self, host: Host, folder: Path, program: str, settings: Mapping[str, Any]) -> None:
        name = Path(program).stem
        with (folder / f"{name}.log").open("wb") as log:
            self._process = subprocess.Popen(
                host.command(sys.executable, program, json.dumps(settings)),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
            )
        self._name = name

    @property
    def pid(self) -> int:
        """The process id."""
        return self._process.pid

    def wait_for(self, text: str) -> None:
        """Wait for a line of output with this text."""
        assert self._process.stdout is not None
        wait_for(self._process.stdout, text, self._name)

    def tell(self, word: str) -> None:
        """Send a word."""
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(f"{word}\n".encode())
            self._process.stdin.flush()

    def ask(self, word: str) -> Any:
        """Send a word, and return the answer, which is JSON."""
        self.tell(word)
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise BoundBroken(f"the program {self._name} of the operator ended with an error")
        return json.loads(line)

    def pause(self) -> None:
        """Let it not run, until `resume`."""
        self._process.send_signal(signal.SIGSTOP)

    def resume(self) -> None:
        """Let it run again."""
        self._process.send_signal(signal.SIGCONT)

    @contextlib.contextmanager
    def stopped(self) -> Iterator[None]:
        """Within this it does not run."""
        self.pause()
        try:
            yield
        finally:
            self.resume()

    def kill(self) -> None:
        """End it at once, as a crash does."""
        self._process.kill()
        self._process.communicate()


def wait_for(stream: IO[bytes], text: str, name: str) -> None:
    """Read lines until one has this text; raises `NotStarted` when the process ends before."""
    deadline = time.monotonic() + _START_TIMEOUT
    for line in iter(stream.readline, b""):
        if text.encode() in line:
            return
        if time.monotonic() > deadline:
            break
    raise NotStarted(f"the {name} did not start")


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a command ended. `status` is that of `subprocess`; `memory` its peak in MiB."""

    status: int
    output: str
    seconds: float
    memory: float


def run_command(arguments: Sequence[str], folder: Path, *, timeout: float, memory: int = 0) -> Outcome:
    """Run `python ARGUMENTS` in a folder. After `timeout` seconds it is killed, which shows as status -9.

    `memory` is a limit of its address space in MiB; 0 is none.
    """

    def limit() -> None:
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory * _MIB, memory * _MIB))

    begin = time.monotonic()
    with (folder / "command.out").open("w+b") as output:
        process = subprocess.Popen(
            (sys.executable, *arguments),
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=output,
            preexec_fn=limit,  # noqa: PLW1509 - this program has no threads
        )
        while True:
            pid, status, used = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() - begin > timeout:
                os.kill(process.pid, signal.SIGKILL)
            time.sleep(0.005)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read(_MIB).decode(errors="replace")
    return Outcome(process.returncode, text, time.monotonic() - begin, used.ru_maxrss / 1024)
