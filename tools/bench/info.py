"""How long `jauspy info` reads a large MCAP file, and how much of it, compared with the whole summary.

python tools/bench/info.py [--gigabytes 10]

The file has a megabyte in each chunk, as those of `jauspy record`, and 30 channels with messages in each chunk. It is
sparse: zeros in it take no room on the disk. The summary is what `mcap` reads: with the index of all chunks.
"""

from __future__ import annotations

import argparse
import io
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from mcap.reader import make_reader
from mcap.writer import CompressionType, Writer

from jauspy.recording.mcap_summary import read_summary
from jauspy.recording.run_files import CHUNK_SIZE

CHANNELS = 30
GOAL = 50.0
"""Milliseconds, for 10 GB."""


class Sparse:
    """A file in which large data of zeros takes no room."""

    def __init__(self, file: io.BufferedWriter) -> None:
        self._file = file

    def write(self, data: Any) -> int:
        """Skip zeros at the end of large data."""
        kept = bytes(data).rstrip(b"\0") if len(data) >= CHUNK_SIZE else data
        self._file.write(kept)
        self._file.seek(len(data) - len(kept), io.SEEK_CUR)
        return len(data)

    def tell(self) -> int:
        """The place of the next write."""
        return self._file.tell()


def write(path: Path, size: int) -> None:
    """Write the file."""
    with path.open("wb") as file:
        sparse: Any = Sparse(file)
        run = Writer(sparse, chunk_size=CHUNK_SIZE // 2, compression=CompressionType.NONE, enable_crcs=False)
        run.start("jaus", "bench")
        channels = [run.register_channel(f"/101.1.{number}/ReportStatus", "json", 0) for number in range(CHANNELS)]
        for chunk in range(size // CHUNK_SIZE):
            for channel in channels[1:]:
                run.add_message(channel, chunk, b"{}", chunk)
            run.add_message(channels[0], chunk, bytes(CHUNK_SIZE), chunk)
        run.finish()  # type: ignore[no-untyped-call]


class Counted(io.FileIO):
    """A file that counts what is read of it."""

    count = 0

    def readinto(self, buffer: Any) -> int:
        """Read and count."""
        found = super().readinto(buffer) or 0
        self.count += found
        return found


def measured(path: Path, read: Callable[[Any], object]) -> tuple[float, int]:
    """Milliseconds, the least of five runs, and bytes that were read."""
    times = []
    for _ in range(5):
        with Counted(str(path)) as raw, io.BufferedReader(raw) as file:
            began = time.perf_counter()
            read(file)
            times.append((time.perf_counter() - began) * 1e3)
    return min(times), raw.count


def main() -> None:
    """Print a line for each way."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gigabytes", type=float, default=10.0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "run.mcap")
        write(path, int(options.gigabytes * 1e9))
        print(f"{path.stat().st_size / 1e9:.1f} GB{'ms':>16}{'bytes read':>14}")
        whole, count = measured(path, lambda file: make_reader(file).get_summary())
        print(f"{'whole summary':15}{whole:9.1f}{count:14}")
        taken, count = measured(path, lambda file: read_summary(file, str(path)))
        print(f"{'jauspy info':15}{taken:9.1f}{count:14}   1 : {whole / taken:.0f}, goal {GOAL:g} ms")


if __name__ == "__main__":
    main()
