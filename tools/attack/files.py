"""Hostile files: a program reads them, and has to refuse or read each, with one sentence and no other effect."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from .arena import Arena

READERS: Final = str(Path(__file__).with_name("readers.py"))
TIMEOUT: Final = 120.0
"""Seconds for all files of a round."""
MAX_SECONDS: Final = 20.0
"""Seconds of CPU time for one of them; a large file that is read as it should takes one, on a loaded machine three."""
MAX_MEMORY: Final = 400.0
"""MiB at the peak of the program, with what Python and the libraries need."""
CANARY: Final = "canary"
"""The file that hostile files try to write, in the folder of the program."""
EXPRESSION: Final = f"__import__('pathlib').Path('{CANARY}').touch()"
_READING: Final = re.compile(r"^reading (.*)$", re.MULTILINE)
_TOOK: Final = re.compile(r"^took (.*) s$", re.MULTILINE)
_KILLED: Final = -9

Make = Callable[[random.Random], bytes]
"""Makes a hostile file."""


@dataclass(frozen=True, slots=True)
class FileKind:
    """Files that one of the `readers` reads: an honest one, and hostile ones by what they are."""

    reader: str
    suffix: str
    honest: bytes
    hostile: Mapping[str, Make]

    def attack(self, arena: Arena) -> None:
        """One round: the hostile files, and the honest one."""
        names = {}
        for number, (what, make) in enumerate(self.hostile.items()):
            names[name := f"hostile{number}{self.suffix}"] = what
            (arena.folder / name).write_bytes(make(arena.chance))
            arena.sent += 1
        (arena.folder / f"honest{self.suffix}").write_bytes(self.honest)
        self._check(arena, names)
        arena.asked += 1
        arena.lost += arena.command(READERS, self.reader, f"honest{self.suffix}", timeout=TIMEOUT).status != 0

    def _check(self, arena: Arena, names: Mapping[str, str]) -> None:
        outcome = arena.command(READERS, self.reader, *names, timeout=TIMEOUT)
        arena.memory = max(arena.memory, outcome.memory)
        read = _READING.findall(outcome.output)
        where = f"{names.get(read[-1], '') if read else 'no file'} ({self.reader})"
        slowest = max([0.0, *map(float, _TOOK.findall(outcome.output))])
        last = outcome.output.strip().rpartition("\n")[2]
        arena.require(outcome.status != _KILLED, f"{where}: takes longer than {TIMEOUT:g} s")
        arena.require("Traceback" not in outcome.output and outcome.status in (0, 2), f"{where}: {last}")
        arena.require(slowest <= MAX_SECONDS, f"{self.reader}: a file takes {slowest:.1f} s")
        arena.require(outcome.memory <= MAX_MEMORY, f"{self.reader}: reading needs {outcome.memory:.0f} MiB")
        arena.require("\x1b" not in outcome.output, f"{self.reader}: the output has escape sequences of a terminal")
        arena.require(not (arena.folder / CANARY).exists(), f"{self.reader}: a file is run as code")


def attacked_by(*kinds: FileKind) -> Callable[[Arena], None]:
    """An attack with all these kinds in turn."""

    def run(arena: Arena) -> None:
        for _ in arena.paced(1.0):
            for kind in kinds:
                kind.attack(arena)

    return run


def noise(chance: random.Random) -> bytes:
    """Bytes at random."""
    return chance.randbytes(chance.randrange(5000))


def damaged(honest: bytes) -> Make:
    """A file with a few bytes changed, or cut off."""

    def make(chance: random.Random) -> bytes:
        data = bytearray(honest)
        for _ in range(chance.randrange(1, 6)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        return bytes(data[: chance.randrange(len(data) // 2, len(data) + 1)])

    return make


def several(what: str, make: Make, count: int) -> dict[str, Make]:
    """The same kind of file so many times."""
    return {f"{what} ({number})": make for number in range(1, count + 1)}
