"""What the verbs that look at traffic share: where it comes from, and which of it is looked at."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from pathlib import Path
from typing import Annotated

import typer

from jauspy.capture.filters import Filter
from jauspy.capture.reader import CaptureReader
from jauspy.cli import console
from jauspy.cli.definitions import Definitions
from jauspy.errors import ConfigError
from jauspy.inspection.live import LiveCapture
from jauspy.inspection.traffic import SeenMessage, seen_messages
from jauspy.recording.mcap_capture import McapCapture, open_capture_file

Sender = Annotated[
    str | None, typer.Argument(metavar="[ID]", help="Only messages of this sender: 101.1.102, 101.* or '*'.")
]
MessageName = Annotated[
    str | None, typer.Argument(metavar="[MESSAGE]", help="Only messages of this name; * and ? are wildcards.")
]
CaptureFile = Annotated[
    Path | None,
    typer.Option("--capture", metavar="CAPTURE", help="A pcap, pcapng or MCAP file instead of what is routed now."),
]


class Traffic:
    """The messages that fit, in the order in which they were routed; endless unless from a file."""

    def __init__(self, capture: CaptureReader | McapCapture, definitions: Definitions, only: str | None) -> None:
        self._capture = capture
        self._registry = definitions.registry
        self._fits = None if only is None else Filter(only, definitions.registry)

    def __iter__(self) -> Iterator[SeenMessage]:
        fits = self._fits
        for seen in seen_messages(self._capture, self._registry):
            if fits is None or fits(seen.part):
                yield seen


@contextmanager
def open_capture(file: Path | None, root: Path, seconds: float | None = None) -> Iterator[CaptureReader | McapCapture]:
    """A capture file, or what the node manager of a local root routes for some time; Ctrl-C ends it in order."""
    with ExitStack() as stack:
        if file is None:
            capture: CaptureReader | McapCapture = stack.enter_context(closing(LiveCapture(root, seconds)))
        else:
            try:
                opened = stack.enter_context(file.open("rb"))
            except OSError as error:
                raise ConfigError(f"{file} cannot be read: {error.strerror}") from None
            capture = open_capture_file(opened, name=str(file))
        with suppress(KeyboardInterrupt):
            yield capture
        if capture.lost:
            console.note(f"{capture.lost} packets were lost, because they were not read in time")


@contextmanager
def traffic(
    file: Path | None, root: Path, definitions: Definitions, only: str | None, seconds: float | None = None
) -> Iterator[Traffic]:
    """The messages of `open_capture` that fit a filter."""
    with open_capture(file, root, seconds) as capture:
        yield Traffic(capture, definitions, only)


def combined(source: str | None, message: str | None, only: str | None) -> str | None:
    """One filter of an id or a pattern of ids, a name of messages and a filter."""
    parts = [] if source is None else [f"src == {source}"]
    parts += [] if message is None else [f"msg == {message}"]
    parts += [] if only is None else [f"({only})"]
    return " and ".join(parts) or None
