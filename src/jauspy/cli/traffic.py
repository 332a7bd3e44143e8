"""What the verbs that look at traffic share: where it comes from, and which of it is looked at."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from jauspy.capture.filters import Filter
from jauspy.capture.reader import CaptureReader, up_to_damage
from jauspy.cli import console
from jauspy.cli.definitions import Definitions
from jauspy.cli.options import DEFAULT_PORT
from jauspy.errors import ConfigError
from jauspy.inspection.live import LiveCapture
from jauspy.inspection.network import GroupCapture, InterfaceCapture
from jauspy.inspection.traffic import SeenMessage, seen_messages
from jauspy.recording.mcap_capture import McapCapture, open_capture_file
from jauspy.transport import multicast

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
Interface = Annotated[
    str | None,
    typer.Option(
        "--interface",
        metavar="NAME",
        help="What passes this interface, UDP and TCP (needs CAP_NET_RAW), or with --multicast, where to join "
        "the group.",
    ),
]
Multicast = Annotated[
    str | None, typer.Option("--multicast", metavar="GROUP", help="What is sent to this group; 239.255.0.1 is JAUS's.")
]
NetworkPort = Annotated[
    int | None,
    typer.Option(
        "--port", min=1, max=65535, help=f"The port for --interface and --multicast. Default: {DEFAULT_PORT}."
    ),
]
Capture = CaptureReader | McapCapture | InterfaceCapture | GroupCapture


@dataclass(frozen=True, slots=True)
class Network:
    """A network to listen to, instead of a node manager of this machine."""

    interface: str | None
    group: str | None
    port: int
    with_rtp: bool = False
    """Whether an interface shows what may be RTP of other ports, too."""

    def open(self, seconds: float | None) -> InterfaceCapture | GroupCapture:
        """Listen for some time. Raises `ConfigError` or `TransportError`."""
        if self.group is not None:
            interfaces = (multicast.ANY,) if self.interface is None else (self.interface,)
            return GroupCapture(self.group, self.port, interfaces, seconds)
        assert self.interface is not None
        return InterfaceCapture(self.interface, self.port, seconds, with_rtp=self.with_rtp)


def chosen_network(interface: str | None, group: str | None, port: int | None, file: Path | None) -> Network | None:
    """The network that options name; None if they name none. Raises `ConfigError` if they contradict each other."""
    if interface is None and group is None:
        if port is not None:
            raise ConfigError("--port needs --interface or --multicast; a node manager shows all that it routes")
        return None
    if file is not None:
        raise ConfigError("--capture reads a file; leave out --interface and --multicast")
    return Network(interface, group, DEFAULT_PORT if port is None else port)


class Traffic:
    """The messages that fit, in the order in which they were routed; endless unless from a file.

    A note tells of a file that is damaged or cut off behind its first datagram.
    """

    def __init__(self, capture: Capture, definitions: Definitions, only: str | None) -> None:
        self._capture = capture
        self._registry = definitions.registry
        self._fits = None if only is None else Filter(only, definitions.registry)

    def __iter__(self) -> Iterator[SeenMessage]:
        fits = self._fits
        for seen in seen_messages(up_to_damage(self._capture, console.note), self._registry):
            if fits is None or fits(seen.part):
                yield seen


@contextmanager
def open_capture(
    file: Path | None, root: Path, seconds: float | None = None, *, network: Network | None = None
) -> Iterator[Capture]:
    """A capture file, or what a network or the node manager of a local root carries for some time.

    Ctrl-C ends it in order.
    """
    with ExitStack() as stack:
        capture: Capture
        if network is not None:
            capture = stack.enter_context(closing(network.open(seconds)))
        elif file is None:
            capture = stack.enter_context(closing(LiveCapture(root, seconds)))
        else:
            try:
                opened = stack.enter_context(file.open("rb"))
            except OSError as error:
                raise ConfigError(f"{file} cannot be read: {error.strerror}") from None
            capture = open_capture_file(opened, name=str(file))
        with suppress(KeyboardInterrupt):
            yield capture
        if lost := capture.lost:
            console.note(f"{lost} packets were lost, because they were not read in time")


@contextmanager
def traffic(
    file: Path | None,
    root: Path,
    definitions: Definitions,
    only: str | None,
    seconds: float | None = None,
    *,
    network: Network | None = None,
) -> Iterator[Traffic]:
    """The messages of `open_capture` that fit a filter."""
    with open_capture(file, root, seconds, network=network) as capture:
        yield Traffic(capture, definitions, only)


def combined(source: str | None, message: str | None, only: str | None) -> str | None:
    """One filter of an id or a pattern of ids, a name of messages and a filter."""
    parts = [] if source is None else [f"src == {source}"]
    parts += [] if message is None else [f"msg == {message}"]
    parts += [] if only is None else [f"({only})"]
    return " and ".join(parts) or None
