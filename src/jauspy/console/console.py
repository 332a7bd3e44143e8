"""The console: the state that all browsers share, whichever page or socket they use."""

from __future__ import annotations

import asyncio
from collections import Counter, deque
from collections.abc import Awaitable, Callable, Coroutine, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, Final

from jauspy.console.emergency import Emergencies, destination
from jauspy.console.fleet import NOTHING, Fleet
from jauspy.console.handoffs import Handoffs
from jauspy.console.killed_console import Watchdog
from jauspy.console.languages import ENGLISH, sentence
from jauspy.console.listening import Levels
from jauspy.console.map_tiles import TileSource
from jauspy.console.motion import Jogging
from jauspy.console.open_pages import OpenPages
from jauspy.console.operation import Operation
from jauspy.console.part_names import PartNames
from jauspy.console.saved_files import RobotPoses, SavedFiles
from jauspy.console.traffic import Traffic
from jauspy.console.users import LOCAL, User, current, current_user
from jauspy.console.video import AttitudeFeed, SharedCamera, camera_state
from jauspy.console.world_socket import Worlds
from jauspy.errors import CodecError, ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.ocu import OCU
from jauspy.ocu.arm import POSITION_DRIVER
from jauspy.ocu.emergency import Reports, obeys
from jauspy.ocu.robot import Robot
from jauspy.printable import printable
from jauspy.robot.audit import MAX_PAYLOAD, AuditLog
from jauspy.services.core.command_seal import needs_seal

MAX_EVENTS: Final = 500
"""Lines of the log that are kept."""
MAX_EVENT: Final = 500
"""Characters of a line of the log."""
BY_ITSELF: Final = "(console)"
"""The operator of commands without a user, in the audit log; no user has this name."""
NO_ANSWER: Final = sentence("no component answered")
RECORDINGS: Final = Path.home() / "jauspy-recordings"


@dataclass(frozen=True, slots=True)
class Event:
    """A line of the log."""

    time: datetime
    text: str
    user: str = ""
    """Who has caused it, by the session; empty for what the console does by itself."""

    @property
    def line(self) -> str:
        """The line in the log; only that of a user begins with a bracket."""
        return self.line_of(self.text)

    def line_of(self, text: str) -> str:
        """The line with the text in another language."""
        return f"{self.time:%H:%M:%S}  [{self.user}] {text}" if self.user else f"{self.time:%H:%M:%S}  {text}"


class Console:
    """The state that all browsers share: the fleet, operations, cameras and the log."""

    def __init__(
        self,
        ocu: OCU,
        emergency_ocu: OCU,
        audit: AuditLog | None = None,
        recordings: Path = RECORDINGS,
        watchdog: Watchdog | None = None,
    ) -> None:
        self.ocu = ocu
        self._watchdog = watchdog
        self.recordings = recordings
        """The folder of recorded video."""
        self.poses: RobotPoses = {}
        """Named poses from the file given at start."""
        self.map: TileSource | None = None
        """The offline map, if one was given at start."""
        self.first_robot: int | None = None
        """The robot that each page shows first, if one was given at start."""
        self.fleet = Fleet(ocu)
        self.fleet.on_event = self.note
        self.fleet.on_robots = self._follow
        self.events: deque[Event] = deque(maxlen=MAX_EVENTS)
        self.total_events = 0
        self.counters: Counter[str] = Counter()
        """Messages of browsers that were refused, by socket and reason."""
        self.traffic = Traffic(registry)
        for client in (ocu, emergency_ocu):
            client.trace(self._trace)
        self._audit = audit
        self._emergency_ocu = emergency_ocu
        self.emergencies = Emergencies(emergency_ocu)
        self._operations: dict[int, Operation] = {}
        self._jogging: dict[JausID, Jogging] = {}
        self.handoffs = Handoffs(ocu, lambda: self.fleet.robots, self.note, self.operation)
        self.levels = Levels()
        self.names = PartNames()
        self._cameras: dict[JausID, SharedCamera] = {}
        self.worlds = Worlds(ocu, lambda: self.fleet.robots)
        self._attitudes: dict[int, AttitudeFeed] = {}
        self.pages = OpenPages()
        """Pages by their tokens; sockets without the token of a page are refused."""
        self._leaving: set[asyncio.Task[None]] = set()

    def note(self, text: str) -> None:
        """Add a line to the log about what the console itself has done or found."""
        self._add_event(text, None)

    def act(self, text: str) -> None:
        """Add a line to the log, and to the audit log, about what the user of the present task has done."""
        user = current_user()
        self._add_event(text, user)
        if self._audit is not None and user is not None:
            self._audit.note(
                {
                    "operator": user.name,
                    "role": user.role,
                    "event": printable(text)[:MAX_EVENT],
                }
            )

    def _add_event(self, text: str, user: User | None) -> None:
        text, name = printable(text), "" if user is None else user.name
        text = text if len(text) <= MAX_EVENT else f"{text[: MAX_EVENT - 1]}\u2026"
        self.events.append(Event(datetime.now().astimezone(), text, name))
        self.traffic.event(text, name)
        self.total_events += 1

    def new_browser(self, remove: Callable[[], object], language: str = ENGLISH) -> tuple[str, User] | None:
        """A token for one page, and its user; None when there are too many pages. For `remove` see `OpenPages.add`."""
        user = current_user() or LOCAL
        token = self.pages.add(user, current.get(), remove, language)
        return None if token is None else (token, user)

    def refused(self, name: str, reason: str) -> None:
        """Count a message that the browser of this task has sent on the socket of this name, and that was refused."""
        key = f"{name}, {reason}"
        self.counters[key] += 1
        if (count := self.counters[key]).bit_count() == 1:  # the 1st, 2nd, 4th, 8th ...
            user = current_user() or LOCAL
            self.note(
                sentence(
                    "messages on {name} that were refused: {count}, {reason}; the last one of {user}",
                    name=name,
                    count=count,
                    reason=reason,
                    user=user.name,
                )
            )

    def files(self, robot: Robot) -> SavedFiles:
        """The saved poses and trajectories of a robot, for the user of the present task."""
        return SavedFiles(robot.id, robot.name, current_user(), self.act)

    def is_of(self, token: str, user: User | None) -> bool:
        """True for the token of a page of this user that is open."""
        return user is not None and self.pages.user(token) == user

    def forget(self, token: str) -> None:
        """Handle the end of a page: robots that it operated are released soon."""
        self.pages.forget(token)
        task = asyncio.create_task(self._release_all_of(token), name="console: a browser has left")
        self._leaving.add(task)
        task.add_done_callback(self._leaving.discard)

    async def _release_all_of(self, token: str) -> None:
        for operation in self._operations.values():
            if operation.operator == token:
                self.note(
                    sentence(
                        "robot {robot}: the browser of {user} has left",
                        robot=operation.robot.id,
                        user=operation.user.name,
                    )
                )
                await operation.release(token)
        await self.handoffs.forget(token)
        await self.worlds.forget(token)

    def _trace(self, source: JausID, destination: JausID, payload: bytes, *, sent: bool) -> None:
        """Record a message for the log; a sent command also goes into the audit log, with its user."""
        if not sent or not _is_command(payload):
            self.traffic.note(source, destination, payload, sent=sent)
            return
        operation = self._operations.get(destination.subsystem)
        user = current_user() or (operation.user if operation is not None and operation.operator else None)
        self.traffic.note(source, destination, payload, sent=sent, user=user.name if user else BY_ITSELF)
        if self._audit is None:
            return
        self._audit.note(
            {
                "component": str(destination),
                "source": str(source),
                "operator": user.name if user else BY_ITSELF,
                "role": user.role if user else None,
                "message": self.traffic.name(payload),
                "outcome": "sent",
                "payload": payload[:MAX_PAYLOAD].hex(),
            }
        )

    def _follow(self, robots: Mapping[int, Robot]) -> None:
        """Apply a new discovery to the operations; ask new components what they are."""
        self.names.look(robots.values())
        for id, operation in self._operations.items():
            if id in robots:
                operation.follow(robots[id])

    def operation(self, subsystem: int) -> Operation | None:
        """The operation of a robot; None when there is no such robot."""
        robot = self.fleet.robots.get(subsystem)
        if robot is None:
            return self._operations.get(subsystem)
        return self._operations.setdefault(subsystem, Operation(robot, self.note, self._watchdog))

    def jogging(self, component: str) -> Jogging | None:
        """The `Jogging` of this arm; None when there is no such arm."""
        try:
            id = JausID.parse(component)
        except ConfigError:
            return None
        operation = self.operation(id.subsystem)
        if operation is None or not any(
            part.id == id and part.find(POSITION_DRIVER) for part in operation.robot.components
        ):
            return None
        return self._jogging.setdefault(id, Jogging(operation, id, self.note))

    def camera(self, id: JausID) -> SharedCamera | None:
        """The camera of a component; None when it is not there."""
        if id in self._cameras:
            return self._cameras[id]
        robot = self.fleet.robots.get(id.subsystem)
        if robot is None or not any(part.id == id and part.find("DigitalVideo") for part in robot.components):
            return None
        if robot.id not in self._attitudes:
            self._attitudes[robot.id] = AttitudeFeed(self.ocu, robot)

        def state() -> str:
            return camera_state(self.fleet.states.get(id, NOTHING).status, silent=self.fleet.is_silent(id))

        camera = robot.component(str(id)).camera
        self._cameras[id] = SharedCamera(camera, str(id), self.note, state, self._attitudes[robot.id])
        return self._cameras[id]

    def stop(self, target: str, page: str = "") -> Coroutine[Any, Any, str]:
        """Set the emergency of a robot or of all, from now on; await a text with the components that obeyed.

        `page` is the token of the page that asks for it.
        """
        what = sentence("STOP ALL") if target == "all" else sentence("an emergency stop")
        for operation in self._operations.values():
            if destination(target).subsystem in (65535, operation.robot.id) and operation.operator:
                operation.drive(operation.operator, 0.0, 0.0)
                operation.stopped(page, what)
        return self._stopped(target, self.emergencies.stop(target))

    async def _stopped(self, target: str, reports: Awaitable[Reports]) -> str:
        found = await reports
        obeyed = sum(obeys(report, release=False) for report in found.values())
        text = sentence("{obeyed} of {all} components stopped", obeyed=obeyed, all=len(found)) if found else NO_ANSWER
        self.act(sentence("emergency stop of {target}: {text}", target=target, text=text))
        return text

    async def release(self, target: str) -> str:
        """Clear the emergency of a robot or of all; returns a text with the components that obeyed."""
        found = await self.emergencies.release(target)
        if found is None:
            text = sentence("not released: a stop came meanwhile")
        else:
            obeyed = sum(obeys(report, release=True) for report in found.values())
            text = (
                sentence("{obeyed} of {all} components released from the emergency", obeyed=obeyed, all=len(found))
                if found
                else NO_ANSWER
            )
        self.act(sentence("emergency release of {target}: {text}", target=target, text=text))
        return text

    async def close(self) -> None:
        """Release all robots."""
        if self._leaving:
            await asyncio.wait(self._leaving)
        for operation in self._operations.values():
            await operation.release()
        await self.handoffs.close()
        await self.names.close()
        await self.worlds.close()
        for camera in self._cameras.values():
            await camera.close()
        await self.fleet.close()
        for client in (self.ocu, self._emergency_ocu):
            client.trace(None)


def _is_command(payload: bytes) -> bool:
    """True for a message that changes something."""
    try:
        return needs_seal(registry.decode(payload))
    except CodecError:
        return True
