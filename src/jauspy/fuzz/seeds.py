"""Where a campaign starts: messages of captures and hex files, and messages made from the schemas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random

from jauspy.capture.dissect import dissect
from jauspy.capture.hextext import from_lines
from jauspy.capture.reader import CaptureReader, is_capture
from jauspy.errors import ConfigError
from jauspy.fuzz.messages import Maker, Style, Target
from jauspy.fuzz.spots import Spot, spots_of
from jauspy.messages import registry

ANY_PER_MESSAGE = 3
"""Random seeds that are made of each message, beside the shortest and the one with everything."""


@dataclass(frozen=True, slots=True)
class Seed:
    """Bytes to start from, the message they are, and where its parts are."""

    target: int
    data: bytes
    spots: tuple[Spot, ...]


def file_payloads(path: Path) -> list[bytes]:
    """The messages in a pcap, pcapng or hex file, perhaps none; `ConfigError` when it is none of these."""
    try:
        with path.open("rb") as file:
            if is_capture(file.peek(4)):
                found = [
                    p for datagram in CaptureReader(file, name=str(path), port=None) for p in _of(datagram.payload)
                ]
            else:
                found = [p for _, data in from_lines(file.read().decode("ascii")) for p in _of(data) or [data]]
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, ConfigError) as error:
        reason = f": {error}" if isinstance(error, ConfigError) else ""
        raise ConfigError(f"{path} is neither a pcap or pcapng file nor hex text{reason}") from None
    return list(dict.fromkeys(payload for payload in found if len(payload) >= 2))


def _of(datagram: bytes) -> list[bytes]:
    return [bytes(part.packet.payload) for part in dissect(datagram, registry).parts]


def from_payloads(targets: Sequence[Target], payloads: Iterable[bytes]) -> Iterator[Seed]:
    """A seed for every message that has the id of a payload."""
    for payload in payloads:
        for number, target in enumerate(targets):
            if payload.startswith(target.id):
                yield Seed(number, payload, spots_of(target.layout, payload))


def from_schemas(targets: Sequence[Target]) -> Iterator[Seed]:
    """Seeds of every message, always the same ones."""
    rng = Random(0)  # noqa: S311 - chance, not secrets
    styles = (Style.SHORTEST, Style.FULL, *(Style.ANY,) * ANY_PER_MESSAGE)
    for number, target in enumerate(targets):
        made = {Maker(rng, style, targets).message(target) for style in styles}
        for data in sorted(made):
            yield Seed(number, data, spots_of(target.layout, data))
