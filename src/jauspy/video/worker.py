"""A camera's process, started by `camera_process`: orders come by standard input, words go by standard output.

It ends with the robot's process, however that ends, since standard input ends then.
"""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Iterator
from typing import Final

from jauspy.video.orders import LENGTH, Report, Start, length, packed, unpacked
from jauspy.workers import give_way

POLITENESS: Final = 15
"""By how much it is nicer than the robot's process: video never delays control, and has what is left."""

READ: Final = 1 << 16


class Inbox:
    """Orders, whole, out of a pipe."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        self._bytes = bytearray()
        self.ended = False

    def wait(self, seconds: float | None) -> Iterator[object]:
        """Orders that are there, or come within that time."""
        patience = 0.0 if self._end() else seconds
        if not self.ended and select.select([self._descriptor], [], [], patience)[0]:
            heard = os.read(self._descriptor, READ)
            self.ended = not heard
            self._bytes += heard
        while end := self._end():
            body = bytes(self._bytes[LENGTH:end])
            del self._bytes[:end]
            yield unpacked(body)

    def _end(self) -> int:
        """Where the first order ends; 0 while it is not whole."""
        end = LENGTH + length(bytes(self._bytes[:LENGTH]))
        return end if LENGTH < end <= len(self._bytes) else 0


def _speaker() -> int:
    """Standard output for words alone; what libraries print goes to standard error."""
    out = os.dup(sys.stdout.fileno())
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return out


def main() -> None:
    """Film until standard input ends."""
    out = _speaker()
    give_way(POLITENESS)
    inbox = Inbox(sys.stdin.fileno())
    begin: object = None
    while begin is None and not inbox.ended:
        begin = next(inbox.wait(None), None)
    if isinstance(begin, Start):
        _film(begin, inbox, out)


def _film(begin: Start, inbox: Inbox, out: int) -> None:
    import cv2  # noqa: PLC0415 - the robot's process has looked for the extra

    from jauspy.video.studio import CameraWorker  # noqa: PLC0415

    cv2.setNumThreads(1)  # others would spin while they wait for the next picture

    def say(word: Report) -> None:
        rest = packed(word)
        while rest:
            rest = rest[os.write(out, rest) :]

    studio = CameraWorker(begin, say)
    try:
        while not inbox.ended:
            for order in inbox.wait(studio.wait()):
                studio.obey(order)
            studio.film()
    except BrokenPipeError:  # nobody is there to hear
        return
    finally:
        studio.close()


if __name__ == "__main__":
    main()
