"""Runs a command of jauspy, and says when asked how many tasks of asyncio it has.

python observed.py VERB ARGUMENTS... with one path a line on standard input: the number is written to this path.
"""

from __future__ import annotations

import asyncio
import gc
import sys
import threading
from pathlib import Path

from jauspy.cli.main import main


def tasks() -> int:
    """Tasks of all event loops of this process."""
    loops = [each for each in gc.get_objects() if isinstance(each, asyncio.AbstractEventLoop)]
    return sum(len(asyncio.all_tasks(loop)) for loop in loops)


def answer() -> None:
    """Answer until standard input is closed."""
    for line in sys.stdin:
        path = Path(line.strip())
        part = path.with_suffix(".part")
        part.write_text(str(tasks()))
        part.rename(path)


if __name__ == "__main__":
    threading.Thread(target=answer, daemon=True).start()
    main()
