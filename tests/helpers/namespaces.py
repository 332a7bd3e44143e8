"""Verbs and peers in network namespaces: processes forked from one that has imported jauspy, which takes a second."""

from __future__ import annotations

import ctypes
import multiprocessing
import os
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

from tests.helpers.command_line import jauspy_in_process
from tests.helpers.udp_peer import Faults, UdpPeer

FORKED = multiprocessing.get_context("forkserver")
FORKED.set_forkserver_preload([__name__, "jauspy.cli.doctor", "jauspy.cli.record"])
TIMEOUT = 60.0
"""Seconds for what one process does."""


class Done(NamedTuple):
    """What a verb printed, and its exit status."""

    status: int
    stdout: str
    stderr: str


def run_verb(namespace: str, *arguments: str) -> Done:
    """Run a verb in a network namespace."""
    with _process(namespace, _verb, arguments) as ours:
        assert ours.poll(TIMEOUT), f"{arguments} did not end"
        return Done(*ours.recv())


@contextmanager
def peer(namespace: str, host: str, port: int = 3794) -> Iterator[None]:
    """A peer without faults in a network namespace, while the context is open."""
    with _process(namespace, _peer, (host, port)) as ours:
        assert ours.poll(TIMEOUT), "the peer did not start"
        ours.recv()
        yield


@contextmanager
def _process(namespace: str, target: object, arguments: tuple[object, ...]) -> Iterator[Connection]:
    """A process, which has the other end of a connection, and ends when this one is closed."""
    ours, theirs = FORKED.Pipe()
    process = FORKED.Process(target=_enter, args=(namespace, target, theirs, arguments), daemon=True)
    process.start()
    theirs.close()
    try:
        yield ours
    finally:
        ours.close()
        process.join(TIMEOUT)
        process.kill()
        process.close()


def _enter(namespace: str, target: object, connection: Connection, arguments: tuple[object, ...]) -> None:
    assert callable(target)
    with Path("/var/run/netns", namespace).open("rb") as opened:
        if ctypes.CDLL(None, use_errno=True).setns(opened.fileno(), 0):
            raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    target(connection, *arguments)


def _verb(connection: Connection, *arguments: str) -> None:
    done = jauspy_in_process(*arguments)
    connection.send((done.exit_code, done.stdout, done.stderr))


def _peer(connection: Connection, host: str, port: int) -> None:
    with UdpPeer(port, Faults(), host=host):
        connection.send("ready")
        connection.poll(None)  # until its other end is closed
