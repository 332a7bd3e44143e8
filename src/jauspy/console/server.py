"""The console's server: sockets for driving, video and the emergency stop, and the page, in the OCU's event loop."""

from __future__ import annotations

import asyncio
import secrets
import socket
from collections.abc import AsyncIterator, Coroutine
from contextlib import asynccontextmanager, nullcontext, suppress
from dataclasses import dataclass
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
from jauspy.console.browser_messages import StopRequest, drive_message, jog_message, messages, stop_request
from jauspy.console.certificates import check_certificate
from jauspy.console.connections import Connections
from jauspy.console.console import RECORDINGS, Console
from jauspy.console.killed_console import Watchdog
from jauspy.console.languages import sentence, translated
from jauspy.console.listening import add_listening
from jauspy.console.login import LOCAL_HOSTS, LoginMiddleware
from jauspy.console.map_tiles import TileSource, add_tiles
from jauspy.console.recordings import add_recordings
from jauspy.console.saved_files import RobotPoses
from jauspy.console.users import Users, current_user
from jauspy.console.world_socket import add_world
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.logs import adopt
from jauspy.node.manager import raise_open_files_limit
from jauspy.ocu import OCU
from jauspy.robot.audit import AuditLog

MAX_FRAME: Final = 1 << 16
"""Bytes of a message of a browser."""
BACKLOG: Final = 512
"""Connections that the kernel keeps until they are accepted."""
MAX_REQUESTS: Final = 8
"""Stops and releases of one browser that are under way at the same time; further ones wait."""
GRACE: Final = 2
"""Seconds that browsers have to leave when the console ends."""
LOGGERS: Final = ("nicegui", "engineio.server", "socketio.server", "uvicorn", "uvicorn.error", "uvicorn.access")
"""Loggers of the packages that serve the page; browsers can cause lines of all of them."""


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
            problem = sentence("the robot has gone") if operation is None else operation.drive(token, forward, left)
            if problem != said:
                await _answer(page, translated(problem, console.pages.language(token)))
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
            await page.close(4404, translated(sentence("there is no such camera"), console.pages.language(token)))
            return
        await camera.serve(page, partial(console.refused, "/ws/video"), console.pages.language(token))

    _add_stop(app, console)
    add_world(
        app,
        console.worlds,
        lambda page, token: _accepted(page, console, token),
        lambda token: console.is_of(token, current_user()),
        refuse=partial(console.refused, "/ws/world"),
        language_of=console.pages.language,
    )
    _add_jog(app, console)
    add_listening(app, console)
    add_recordings(
        app,
        console.recordings,
        lambda token: console.is_of(token, current_user()),
        console.act,
        language_of=console.pages.language,
    )
    add_tiles(app, lambda: console.map, lambda token: console.is_of(token, current_user()), console.note)
    return app


def _add_stop(app: FastAPI, console: Console) -> None:
    @app.websocket("/ws/stop/{token}")
    async def stop(page: WebSocket, token: str) -> None:
        """Receive `stop 101`, `stop all`, `release 101`, on a separate connection that nothing can block.

        `leave` means that the page was closed or reloaded; a page that only falls silent may reconnect.
        """
        if not await _accepted(page, console, token):
            return
        running: dict[asyncio.Task[None], StopRequest] = {}
        async for request in messages(page, stop_request, partial(console.refused, "/ws/stop"), closes=False):
            if request is None:
                await _answer(page, sentence("not understood: stop or release, and a robot's number or all"))
                continue
            if request.verb == "leave":
                console.forget(token)
                break
            user = current_user()
            if request.verb == "release" and user is not None and not user.may_operate:
                await _answer(
                    page,
                    sentence("{user} may stop robots, and not release them ({role})", user=user.name, role=user.role),
                )
                continue
            if request.verb == "stop":
                console.emergencies.end_releases()
                if request in running.values() and console.emergencies.is_stopping(request.target):
                    continue  # as when a key is held
            while len(running) >= MAX_REQUESTS:
                await asyncio.wait(list(running), return_when=asyncio.FIRST_COMPLETED)
            work = console.stop(request.target, token) if request.verb == "stop" else console.release(request.target)
            task = asyncio.create_task(_tell(page, work, console.pages.language(token)), name="console: emergency")
            running[task] = request
            task.add_done_callback(running.pop)
        if running:
            await asyncio.wait(list(running))


async def _tell(page: WebSocket, work: Coroutine[Any, Any, str], language: str) -> None:
    """Tell a browser the result of what it has requested, in its language."""
    try:
        said = await work
    except JausError as error:
        said = str(error)
    await _answer(page, translated(said, language))


def _add_jog(app: FastAPI, console: Console) -> None:
    @app.websocket("/ws/jog/{component}/{token}")
    async def jog(page: WebSocket, component: str, token: str) -> None:
        """Receive velocities of a tool, see `motion.velocity`; the answer is why a command had no effect, or empty."""
        if not await _accepted(page, console, token):
            return
        said = ""
        async for wanted in messages(page, jog_message, partial(console.refused, "/ws/jog")):
            jogging = console.jogging(component)
            problem = sentence("the arm has gone") if jogging is None else jogging.move(token, wanted)
            if problem != said:
                await _answer(page, translated(problem, console.pages.language(token)))
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
    """Token for a console without users; by default a new one for each start."""


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
    map: TileSource | None = None,
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
    console.map = map
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
