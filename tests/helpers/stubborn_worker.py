"""A worker that goes on when its parent wants it to end."""

import signal

from jauspy.worker_process import Parent


def run(first: object, parent: Parent) -> None:
    parent.send("began")
    while True:
        signal.pause()
