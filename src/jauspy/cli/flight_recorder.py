"""`jauspy flight-recorder`: keep the last traffic, and write it to a file when something happens."""

from __future__ import annotations

import os
import sys
import threading
import time
from contextlib import closing, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.beside import ALL_KINDS, DEFAULT_AFTER, DEFAULT_BEFORE, MAX_AFTER, MAX_BEFORE, RECORDINGS, parse_kinds
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, LocalRoot, WithParent
from jauspy.cli.processes import end_with_parent, stoppable
from jauspy.errors import TransportError
from jauspy.inspection.live import LiveCapture
from jauspy.recording.flight_recorder import FlightRecorder, Folder
from jauspy.recording.incidents import IncidentDetector, Kind
from jauspy.recording.run_files import prepared

NICENESS: Final = 10
"""The robot and its node manager run first."""
RECONNECT_DELAY: Final = 1.0
TICK: Final = 0.5

RecordOn = Annotated[
    str, typer.Option("--on", metavar="KINDS", help=f"What starts a file, separated by commas: {', '.join(Kind)}.")
]
Before = Annotated[
    float, typer.Option("--before", min=0.0, max=MAX_BEFORE, metavar="SECONDS", help="How much before it is recorded.")
]
After = Annotated[
    float, typer.Option("--after", min=0.0, max=MAX_AFTER, metavar="SECONDS", help="How much after it is recorded.")
]


def flight_recorder(
    *,
    on: RecordOn = ALL_KINDS,
    before: Before = DEFAULT_BEFORE,
    after: After = DEFAULT_AFTER,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="The folder of the files; it is made if need be.")
    ] = RECORDINGS,
    subsystem: Annotated[
        int | None, typer.Option("--subsystem", min=1, max=65534, help="Only incidents of this robot. Default: of all.")
    ] = None,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
    with_parent: WithParent = False,
) -> None:
    """Keep the last traffic of this machine in memory, and write it to a file when something happens, until Ctrl-C.

    emergency: a component reports Emergency, or a client sets it. control-lost: a client has lost control without
    releasing it. failure: a component reports Failure. It only listens, so it sees a state when a client asks for it,
    has an event for it or causes it. The 100 newest files, and at most 2 GB, are kept. `jauspy up --record-on` runs it
    beside a robot.

    Examples:
      jauspy flight-recorder
      jauspy flight-recorder --on emergency,failure --before 60 -o /var/log/robot
    """
    kinds = parse_kinds(on, "--on")
    if with_parent:
        end_with_parent()
    with suppress(OSError):  # not allowed everywhere
        os.nice(NICENESS)
    known = definitions(schemas)
    prefix = "all" if subsystem is None else str(subsystem)
    suffix = ".mcap" if find_spec("foxglove") is not None else ".pcapng"
    prepared(output / f"run{suffix}", known.registry)  # now, so that an incident's traffic does not wait for it
    with stoppable(), suppress(KeyboardInterrupt), closing(LiveCapture(root)) as capture:
        recorder = FlightRecorder(
            Folder(output, prefix, suffix),
            known.registry,
            IncidentDetector(subsystem, kinds),
            before=before,
            after=after,
            log=lambda line: console.print_if_read(line, file=sys.stderr),
        )
        console.print_lines(f"{output}/{prefix}-*{suffix} on {', '.join(kinds)}")
        _Listener(recorder, root).run(capture)


class _Listener:
    """Gives a recorder what a node manager routes, also after the node manager was started again."""

    def __init__(self, recorder: FlightRecorder, root: Path) -> None:
        self._recorder, self._root = recorder, root
        self._lock = threading.Lock()
        """Held while the recorder works: the traffic and the clock come from two threads."""
        self._recorded = time.monotonic()
        """When the last datagram was given to the recorder."""

    def run(self, capture: LiveCapture) -> None:
        """Listen until interrupted."""
        threading.Thread(target=self._tick, name="clock", daemon=True).start()
        try:
            while True:
                self._listen(capture)
                with self._lock:
                    console.print_if_read("the node manager has ended; waiting for it", file=sys.stderr)
                capture = self._reconnected()
        finally:
            with self._lock:
                self._recorder.close()

    def _listen(self, capture: LiveCapture) -> None:
        told = 0
        with closing(capture):
            for datagram in capture:
                with self._lock:
                    self._recorder.add(datagram)
                    self._recorded = time.monotonic()
                if capture.lost > told:
                    told = capture.lost
                    console.print_if_read(f"{told} packets were lost so far: not read in time", file=sys.stderr)

    def _reconnected(self) -> LiveCapture:
        while True:
            time.sleep(RECONNECT_DELAY)
            with suppress(TransportError):
                return LiveCapture(self._root)

    def _tick(self) -> None:
        while True:
            time.sleep(TICK)
            with self._lock:
                # datagrams tell the time themselves; after a slow one, as the first of a file, others wait to be read
                if time.monotonic() - self._recorded >= TICK:
                    self._recorder.tick(time.time())
