"""A real node manager in this process, with its own port and folder."""

from __future__ import annotations

import shutil
import tempfile
import time
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Any, Self, TypeVar

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.sync.portal import Portal
from jauspy.transport import LocalTransport
from jauspy.virtual.environment import Environment

T = TypeVar("T")


class LocalNode(Environment):
    """`with LocalNode() as node: ...`: a node manager in a thread, which serves while the test blocks.

    It listens on a free UDP port of 127.0.0.1 only, and has its sockets in a temporary folder. `settings` are those of
    `NodeConfig`, as in `LocalNode(tcp=True)`.
    """

    def __init__(self, **settings: Any) -> None:
        self.root = Path(tempfile.mkdtemp(prefix="j"))  # short: a socket's path has at most 107 bytes
        self.port = 0
        """The UDP port; it stays the same when the node manager is stopped and started again."""
        self._settings: dict[str, Any] = {"address": "127.0.0.1", "local_root": self.root} | settings
        self._portal = Portal("node manager")
        self._manager: NodeManager | None = None

    @property
    def udp(self) -> str:
        """The value of `OCU(connect=...)` for a connection by UDP."""
        return f"udp://127.0.0.1:{self.port}"

    @property
    def local(self) -> str:
        """The value of `OCU(connect=...)` for a connection by local sockets."""
        return f"local:{self.root}"

    @property
    def components(self) -> tuple[JausID, ...]:
        """The ids of the components that are registered."""
        return self._read(lambda manager: manager.components, ())

    @property
    def counters(self) -> Mapping[str, int]:
        """Packets received, routed and dropped, by reason."""
        return self._read(lambda manager: dict(manager.counters), {})

    def transport(self, id: str | JausID) -> LocalTransport:
        """A local transport for the component of this id."""
        return LocalTransport(JausID.of(id), self.root)

    @asynccontextmanager
    async def robot(self, name: str = "inc1") -> AsyncIterator[RobotRunner]:
        """A whole robot of this name on the `kinematic` backend; it runs in the node manager's thread."""
        runner = RobotRunner(robot_files.load(name), self.transport, backend="kinematic")
        self._portal.run(runner.open())
        try:
            yield runner
        finally:
            self._portal.leave(runner.close())

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def utc_now(self) -> datetime:
        """The wall clock."""
        return datetime.now(UTC)

    def start(self) -> None:
        """Start it, after `stop` too; without effect when started."""
        if self._manager is None:
            manager = NodeManager(NodeConfig(**{"port": self.port} | self._settings))
            self._portal.open()
            self._portal.run(manager.open())
            self._manager, self.port = manager, manager.port

    def stop(self) -> None:
        """Stop it; without effect when stopped."""
        manager, self._manager = self._manager, None
        if manager is not None:
            self._portal.run(manager.close())
        self._portal.close()

    def _read(self, read: Callable[[NodeManager], T], default: T) -> T:
        """A value of the manager, read in its own thread."""
        manager = self._manager

        async def call() -> T:
            assert manager is not None
            return read(manager)

        return default if manager is None else self._portal.run(call())

    def __enter__(self) -> Self:
        try:
            self.start()
        except BaseException:
            self.__exit__(None, None, None)
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()
        shutil.rmtree(self.root, ignore_errors=True)
