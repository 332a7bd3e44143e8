"""Unix sockets by name: who is alive, who is dead, and what a person is told who cannot have one."""

import os
import resource
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.transport import local as local_socket


@contextmanager
def listening(path: Path, kind: socket.SocketKind = socket.SOCK_DGRAM) -> Iterator[None]:
    with socket.socket(socket.AF_UNIX, kind) as sock:
        sock.bind(str(path))
        yield


@contextmanager
def without_rights(root: Path) -> Iterator[None]:
    """As a user who is stopped by permissions, which root is not."""
    if os.geteuid():
        yield
        return
    root.chmod(0o755)
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


def test_liveness_of_sockets_is_detected(root: Path) -> None:
    path = root / "x"
    states = []
    with listening(path):
        states.append((local_socket.is_alive(path), local_socket.is_dead(path)))
    states.append((local_socket.is_alive(path), local_socket.is_dead(path)))
    path.unlink()
    states.append((local_socket.is_alive(path), local_socket.is_dead(path)))
    assert states == [(True, False), (False, True), (False, True)]


def test_unknown_liveness_is_neither_alive_nor_dead(root: Path) -> None:
    file = root / "file"
    file.touch()
    for path in (file / "JuniorRTE", root / ("x" * 200)):
        assert (local_socket.is_alive(path), local_socket.is_dead(path)) == (False, False)


def test_forbidden_socket_is_neither_alive_nor_dead_and_is_reported(root: Path) -> None:
    path = root / "x"
    with listening(path):
        path.chmod(0)
        with without_rights(root):
            assert (local_socket.is_alive(path), local_socket.is_dead(path)) == (False, False)
            with pytest.raises(TransportError, match=rf"^this user may not use {path}; run as its owner"):
                local_socket.bind(path, owner="a node manager")
    assert path.is_socket()


def test_file_in_place_of_a_directory_is_an_error(root: Path) -> None:
    file = root / "file"
    file.touch()
    with pytest.raises(TransportError, match=rf"^{file} is not a directory; choose another"):
        local_socket.bind(file / "JuniorRTE", owner="a node manager")


def test_socket_of_another_kind_is_not_removed(root: Path) -> None:
    path = root / "x"
    with listening(path, socket.SOCK_STREAM), pytest.raises(TransportError, match="is a socket of another kind"):
        local_socket.bind(path, owner="a node manager")
    assert path.is_socket()


def test_socket_in_use_error_names_the_owner_and_remedy(root: Path) -> None:
    path = root / "x"
    with listening(path):
        with pytest.raises(TransportError) as caught:
            local_socket.bind(path, owner="a node manager")
        assert str(caught.value) == (
            f"a node manager is already running on {path}; stop it, or choose another directory for the local sockets"
        )
        with pytest.raises(TransportError, match="stop it, or use another id"):
            local_socket.bind(path, owner="another component", advice="use another id")


def test_no_hint_names_an_option_that_only_some_callers_have(root: Path) -> None:
    file = root / "file"
    file.touch()
    for path in (root / ("x" * 200), file, file / "x"):
        with pytest.raises(TransportError) as caught:
            local_socket.bind(path, owner="a node manager")
        assert "--" not in str(caught.value)


def test_only_dead_sockets_are_cleaned_up(root: Path) -> None:
    file, alive, dead = root / "file", root / "alive", root / "dead"
    file.touch()
    with listening(alive):
        with listening(dead):
            pass
        for path in (file, alive, dead, root / "nothing"):
            local_socket.clean_up(path)
        assert sorted(root.iterdir()) == [alive, file]


def test_missing_descriptors_mark_no_component_as_dead(tmp_path: Path) -> None:
    """A probe needs a socket of its own; a process that has no more must not drop its components for it."""
    path = tmp_path / "living"
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(str(path))
        with local_socket.SocketProbe() as probe:
            resource.setrlimit(resource.RLIMIT_NOFILE, (0, hard))
            try:
                found = local_socket.is_dead(path), probe.is_dead(path)
                with pytest.raises(TransportError, match=r"Too many open files; raise the limit"):
                    local_socket.bind(path, owner="a node manager")
                sock.close()
                assert probe.is_dead(path)
                assert not local_socket.is_alive(path)
            finally:
                resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert found == (False, False)
