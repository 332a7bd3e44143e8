"""The console's server: sockets for driving, video and the emergency stop, and the page, in the OCU's event loop."""

from __future__ import annotations

import asyncio
import secrets
import socket
from collections import Counter, deque
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager, nullcontext, suppress
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from importlib.resources import files
from pathlib import Path
from typing import Any, Final
from urllib.parse import quote

import uvicorn
from fastapi import FastAPI, WebSocket, WebSocketDisconnect
from starlette.staticfiles import StaticFiles
from uvicorn.protocols.http.h11_impl import H11Protocol

from jauspy.console.body_limit import BodyLimit
from jauspy.console.browser_messages import drive_message, jog_message, messages, stop_request
from jauspy.console.certificates import check_certificate
from jauspy.console.connections import Connections
from jauspy.console.fleet import NOTHING, Fleet
from jauspy.console.login import LOCAL_HOSTS, LoginMiddleware
from jauspy.console.motion import Jogging
from jauspy.console.open_pages import OpenPages
from jauspy.console.operation import Operation
from jauspy.console.saved_files import RobotPoses, SavedFiles
from jauspy.console.traffic import Traffic
from jauspy.console.users import LOCAL, User, Users, current, current_user
from jauspy.console.video import AttitudeFeed, SharedCamera, camera_state
from jauspy.console.watchdog import Watchdog
from jauspy.console.world_socket import Worlds, add_world
from jauspy.errors import CodecError, ConfigError, JausError
from jauspy.ids import JausID
from jauspy.logs import adopt
from jauspy.messages import registry
from jauspy.node.manager import raise_open_files_limit
from jauspy.ocu import OCU
from jauspy.ocu.arm import POSITION_DRIVER
from jauspy.ocu.emergency import obeys, set_emergency
from jauspy.ocu.robot import Robot
from jauspy.printable import printable
from jauspy.robot.audit import MAX_PAYLOAD, AuditLog
from jauspy.services.core.command_seal import needs_seal

MAX_EVENTS: Final = 500
"""Lines of the log that are kept."""
MAX_EVENT: Final = 500
"""Characters of a line of the log."""
MAX_FRAME: Final = 1 << 16
"""Bytes of a message of a browser."""
BY_ITSELF: Final = "(console)"
"""The operator of commands without a user, in the audit log; no user has this name."""
BACKLOG: Final = 512
"""Connections that the kernel keeps until they are accepted."""
GRACE: Final = 2
"""Seconds that browsers have to leave when the console ends."""
LOGGERS: Final = ("nicegui", "engineio.server", "socketio.server", "uvicorn", "uvicorn.error", "uvicorn.access")
"""Loggers of the packages that serve the page; browsers can cause lines of all of them."""
RECORDINGS: Final = Path.home() / "jauspy-recordings"
STOP_TIME: Final = 1.0
"""Seconds in which an emergency stop is repeated until all obey."""


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
        return f"{self.time:%H:%M:%S}  [{self.user}] {self.text}" if self.user else f"{self.time:%H:%M:%S}  {self.text}"


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
        for each in (ocu, emergency_ocu):
            each.trace(self._trace)
        self._audit = audit
        self._emergency_ocu = emergency_ocu
        self._operations: dict[int, Operation] = {}
        self._jogging: dict[JausID, Jogging] = {}
        self._cameras: dict[JausID, SharedCamera] = {}
        self.worlds = Worlds(ocu, lambda: self.fleet.robots)
        self._attitudes: dict[int, AttitudeFeed] = {}
        self.pages = OpenPages()
        """By tokens; sockets without the token of a page are refused."""
        self._leaving: set[asyncio.Task[None]] = set()

    def note(self, text: str) -> None:
        """Add a line to the log about what the console itself has done or found."""
        self._add_event(text, None)

    def act(self, text: str) -> None:
        """Add a line to the log, and to the audit log, about what the user of the present task has done."""
        user = current_user()
        self._add_event(text, user)
        if self._audit is not None and user is not None:
            self._audit.note({"operator": user.name, "role": user.role, "event": printable(text)[:MAX_EVENT]})

    def _add_event(self, text: str, user: User | None) -> None:
        text, name = printable(text), "" if user is None else user.name
        text = text if len(text) <= MAX_EVENT else f"{text[: MAX_EVENT - 1]}\u2026"
        self.events.append(Event(datetime.now().astimezone(), text, name))
        self.traffic.event(text, name)
        self.total_events += 1

    def new_browser(self, remove: Callable[[], object]) -> tuple[str, User] | None:
        """A token for one page, and its user; None when there are too many pages. For `remove` see `OpenPages.add`."""
        user = current_user() or LOCAL
        token = self.pages.add(user, current.get(), remove)
        return None if token is None else (token, user)

    def refused(self, name: str, reason: str) -> None:
        """Count a message that the browser of this task has sent on the socket of this name, and that was refused."""
        key = f"{name}, {reason}"
        self.counters[key] += 1
        if (count := self.counters[key]).bit_count() == 1:  # the 1st, 2nd, 4th, 8th ...
            user = current_user() or LOCAL
            self.note(f"messages on {name} that were refused: {count}, {reason}; the last one of {user.name}")

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
                self.note(f"robot {operation.robot.id}: the browser of {operation.user.name} has left")
                await operation.release(token)
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
        """Apply a new discovery to the operations."""
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
            each.id == id and each.find(POSITION_DRIVER) for each in operation.robot.components
        ):
            return None
        return self._jogging.setdefault(id, Jogging(operation, id, self.note))

    def camera(self, id: JausID) -> SharedCamera | None:
        """The camera of a component; None when it is not there."""
        if id in self._cameras:
            return self._cameras[id]
        robot = self.fleet.robots.get(id.subsystem)
        if robot is None or not any(each.id == id and each.find("DigitalVideo") for each in robot.components):
            return None
        if robot.id not in self._attitudes:
            self._attitudes[robot.id] = AttitudeFeed(self.ocu, robot)

        def state() -> str:
            return camera_state(self.fleet.states.get(id, NOTHING).status, silent=self.fleet.is_silent(id))

        camera = robot.component(str(id)).camera
        self._cameras[id] = SharedCamera(camera, str(id), self.note, state, self._attitudes[robot.id])
        return self._cameras[id]

    async def stop(self, target: str, *, release: bool = False) -> str:
        """Set or clear the emergency of a robot or of all; returns a text with the components that obeyed."""
        to = JausID(int(target), 255, 255) if target.isdecimal() else JausID(65535, 255, 255)
        for operation in self._operations.values():
            if to.subsystem in (65535, operation.robot.id) and operation.operator and not release:
                operation.drive(operation.operator, 0.0, 0.0)
        found = await set_emergency(self._emergency_ocu, to, release=release, within=STOP_TIME)
        obeyed = sum(obeys(report, release=release) for report in found.values())
        what = "released from the emergency" if release else "stopped"
        text = f"{obeyed} of {len(found)} components {what}" if found else "no component answered"
        self.act(f"emergency {'release' if release else 'stop'} of {target}: {text}")
        return text

    async def close(self) -> None:
        """Release all robots."""
        if self._leaving:
            await asyncio.wait(self._leaving)
        for operation in self._operations.values():
            await operation.release()
        await self.worlds.close()
        for camera in self._cameras.values():
            await camera.close()
        await self.fleet.close()
        for each in (self.ocu, self._emergency_ocu):
            each.trace(None)


def make_app(console: Console) -> FastAPI:
    """The sockets and static files; the page is added by `page.add_page`."""
    app = FastAPI(openapi_url=None, docs_url=None, redoc_url=None)
    app.mount("/static", StaticFiles(directory=str(files("jauspy.console") / "static")), name="static")

    @app.websocket("/ws/drive/{subsystem}/{token}")
    async def drive(page: WebSocket, subsystem: int, token: str) -> None:
        """Receive deflections of the stick as [forward, left]; the answer is why a command had no effect, or empty."""
        if not await _accepted(page, console, token):
            return
        said = ""
        async for wanted in messages(page, drive_message, partial(console.refused, "/ws/drive")):
            operation = console.operation(subsystem)
            forward, left = wanted or (0.0, 0.0)
            problem = "the robot has gone" if operation is None else operation.drive(token, forward, left)
            if problem != said:
                await _answer(page, problem)
                said = problem
        if (operation := console.operation(subsystem)) is not None and operation.operator == token:
            operation.drive(token, 0.0, 0.0)

    @app.websocket("/ws/video/{component}/{token}")
    async def video(page: WebSocket, component: str, token: str) -> None:
        if not await _accepted(page, console, token):
            return
        try:
            camera = console.camera(JausID.parse(component))
        except ConfigError:
            camera = None
        if camera is None:
            await page.close(4404, "there is no such camera")
            return
        await camera.serve(page, partial(console.refused, "/ws/video"))

    @app.websocket("/ws/stop/{token}")
    async def stop(page: WebSocket, token: str) -> None:
        """Receive `stop 101`, `stop all`, `release 101`, on a separate connection that nothing can block.

        `leave` means that the page was closed or reloaded; a page that only falls silent may reconnect.
        """
        if not await _accepted(page, console, token):
            return
        async for request in messages(page, stop_request, partial(console.refused, "/ws/stop"), closes=False):
            if request is None:
                await _answer(page, "not understood: stop or release, and a robot's number or all")
                continue
            if request.verb == "leave":
                console.forget(token)
                return
            user = current_user()
            if request.verb == "release" and user is not None and not user.may_operate:
                await _answer(page, f"{user.name} may stop robots, and not release them ({user.role})")
                continue
            try:
                said = await console.stop(request.target, release=request.verb == "release")
            except JausError as error:
                said = str(error)
            await _answer(page, said)

    add_world(
        app,
        console.worlds,
        lambda page, token: _accepted(page, console, token),
        lambda token: console.is_of(token, current_user()),
        partial(console.refused, "/ws/world"),
    )
    _add_jog(app, console)
    return app


def _add_jog(app: FastAPI, console: Console) -> None:
    @app.websocket("/ws/jog/{component}/{token}")
    async def jog(page: WebSocket, component: str, token: str) -> None:
        """Receive velocities of a tool, see `motion.velocity`; the answer is why a command had no effect, or empty."""
        if not await _accepted(page, console, token):
            return
        said = ""
        async for wanted in messages(page, jog_message, partial(console.refused, "/ws/jog")):
            jogging = console.jogging(component)
            problem = "the arm has gone" if jogging is None else jogging.move(token, wanted)
            if problem != said:
                await _answer(page, problem)
                said = problem
        if (jogging := console.jogging(component)) is not None:
            jogging.leave(token)


async def _accepted(page: WebSocket, console: Console, token: str) -> bool:
    """Accept a page of this console and of the user whose session it is; `LoginMiddleware` checks its origin."""
    if not console.is_of(token, current_user()):
        await page.close(4403)
        return False
    await page.accept()
    return True


async def _answer(page: WebSocket, text: str) -> None:
    """Send a text to a browser, unless it has left."""
    with suppress(WebSocketDisconnect, RuntimeError):
        await page.send_text(text)


def _is_command(payload: bytes) -> bool:
    """True for a message that changes something."""
    try:
        return needs_seal(registry.decode(payload))
    except CodecError:
        return True


class AcceptingServer(uvicorn.Server):
    """A uvicorn server that leaves signals to the program, and accepting to `connections`."""

    def __init__(self, config: uvicorn.Config, listener: socket.socket, connections: Connections) -> None:
        super().__init__(config)
        self._listener = listener
        self._connections = connections
        self._accepting: asyncio.Task[None] | None = None

    def capture_signals(self) -> Any:
        """Nothing: uvicorn's own handlers would end the program."""
        return nullcontext()

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:  # noqa: ARG002 - uvicorn's parameter
        """Start the application, then accept."""
        await super().startup(sockets=[])
        self._accepting = asyncio.create_task(
            self._connections.serve(self._listener, self._make_protocol, self.config.ssl), name="console: accepting"
        )

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """End in the opposite order."""
        if self._accepting is not None:
            self._accepting.cancel()
            await asyncio.wait({self._accepting})
        await super().shutdown(sockets)

    def _make_protocol(self) -> asyncio.Protocol:
        return H11Protocol(config=self.config, server_state=self.server_state, app_state=self.lifespan.state)


@dataclass(frozen=True, slots=True)
class Access:
    """Who may use the console: users at a console for other machines, else those who know the token."""

    users: Path | None = None
    certificate: Path | None = None
    key: Path | None = None
    token: str = ""
    """For a console without users; by default a new one for each start."""


@asynccontextmanager
async def serving(
    ocu: OCU,
    emergency_ocu: OCU,
    host: str,
    port: int,
    *,
    access: Access | None = None,
    audit: AuditLog | None = None,
    recordings: Path = RECORDINGS,
    watchdog: Watchdog | None = None,
    poses: RobotPoses | None = None,
    robot: int | None = None,
) -> AsyncIterator[str]:
    """Serve the console at this address while the context is open; the URL. OCUs and watchdog must be open.

    Without users, the URL contains the token that begins a session. NiceGUI has one application in a process: a process
    can serve once.
    """
    access = access or Access()
    users = _users(access, host)
    listener = _listener(host, port)
    from jauspy.console.content_security_policy import ContentSecurityPolicy  # noqa: PLC0415 - imports NiceGUI
    from jauspy.console.page import add_page  # noqa: PLC0415 - NiceGUI takes a second

    adopt(*LOGGERS)
    console = Console(ocu, emergency_ocu, audit, recordings, watchdog)
    console.poses = poses or {}
    console.first_robot = robot
    app = make_app(console)
    add_page(app, console)
    served, connections = listener.getsockname()[1], Connections(console.note)
    token = access.token or secrets.token_urlsafe(32)
    gate = LoginMiddleware(BodyLimit(app), users, console.note, port=served, token=token, connections=connections)
    config = uvicorn.Config(
        ContentSecurityPolicy(gate),
        log_config=None,
        log_level="warning",
        lifespan="on",
        http="h11",  # its headers are bounded
        ws_max_size=MAX_FRAME,
        ws_per_message_deflate=False,  # video is compressed
        proxy_headers=False,
        server_header=False,
        timeout_graceful_shutdown=GRACE,
        ssl_certfile=access.certificate,
        ssl_keyfile=access.key,
    )
    server = AcceptingServer(config, listener, connections)
    raise_open_files_limit()
    console.fleet.start()
    task = asyncio.create_task(server.serve(), name="console: server")
    try:
        while not server.started and not task.done():  # noqa: ASYNC110 - uvicorn has no event for it
            await asyncio.sleep(0.05)
        address = f"[{host}]:{served}" if ":" in host else f"{host}:{served}"
        yield f"http://{address}/?token={quote(token)}" if users is None else f"https://{address}"
    finally:
        await console.close()
        server.should_exit = True
        await task
        listener.close()


def _users(access: Access, host: str) -> Users | None:
    """The users who may log in; None at a console without a login, which serves its own machine only."""
    given = (access.users, access.certificate, access.key)
    if given == (None, None, None) and host in LOCAL_HOSTS:
        return None
    if access.users is None or access.certificate is None or access.key is None:
        raise ConfigError(
            f"--host {host}: other machines reach the console only with TLS and a login; give --users, --certificate "
            "and --key, whose files `jauspy console user add NAME` and `jauspy console certificate HOST` make"
        )
    check_certificate(access.certificate, access.key)
    users = Users(access.users)
    if not len(users):
        raise ConfigError(f"{access.users}: has no users; add one: jauspy console user add NAME")
    return users


def _listener(host: str, port: int) -> socket.socket:
    try:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        return socket.create_server((host, port), family=family, backlog=BACKLOG)
    except OSError as error:
        raise ConfigError(
            f"the console cannot listen at {host} port {port}: {error.strerror}; choose another one with --port"
        ) from error
