"""ASGI middleware for all requests of the console, including NiceGUI's socket: login page, session cookies, origins.

Who operates a robot is decided in `operation`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from html import escape
from http.cookies import CookieError, SimpleCookie
from typing import Any, Final
from urllib.parse import parse_qs, urlsplit

from starlette.responses import HTMLResponse, PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from jauspy.console.users import LIFETIME, NAME, LoginLimit, Session, Sessions, User, Users, current, local_session

LOCAL_HOSTS: Final = frozenset({"127.0.0.1", "localhost", "::1"})
"""Hosts of a console without a login."""
COOKIE: Final = "__Host-jauspy"
"""A browser takes a cookie of this prefix only with Secure, for this host only, with the path `/`."""
MAX_FORM: Final = 4096
"""Bytes of a login."""
MAX_LOGINS: Final = 8
"""Logins that wait for verification. They are verified one at a time, since each needs 64 MiB."""
MAX_SOCKETS: Final = 64
"""Sockets of one session."""
_OPEN_PATHS: Final = ("/static/theme.css",)
"""Paths that need no session: files of the login page."""
_FOREIGN: Final = "this page of another site may not use the console"
HEADERS: Final = [
    (b"x-frame-options", b"DENY"),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"same-origin"),  # with no-referrer, browsers send `Origin: null` with the login
]


class LoginMiddleware:
    """Passes requests and WebSockets of users to `app`; refuses all others.

    With `users`, everything but the login page needs a session. Without, the host of a request must be one of
    `LOCAL_HOSTS`, so that other sites cannot reach the console by DNS rebinding.
    """

    def __init__(self, app: ASGIApp, users: Users | None, note: Callable[[str], None]) -> None:
        self._app = app
        self._users = users
        self._note = note
        self._sessions = Sessions()
        self._limit = LoginLimit()
        self._verifying = asyncio.Lock()
        self._waiting = 0
        self._local = local_session()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection, as ASGI defines."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = {name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]}
        problem = self._foreign(scope, headers)
        if problem:
            await _refuse(scope, receive, send, PlainTextResponse(problem, 403))
            return
        session = self._session(headers)
        if session is None:
            await self._unknown(scope, receive, send)
        elif scope["type"] == "websocket":
            await self._socket(session, scope, receive, send)
        elif self._users is not None and scope["path"] == "/login":
            await _refuse(scope, receive, send, RedirectResponse("/", 303))
        elif self._users is not None and scope["path"] == "/logout" and scope["method"] == "POST":
            self._sessions.end(session)
            self._note(f"{session.user.name} has signed out")
            await _refuse(scope, receive, send, _without_cookie(RedirectResponse("/login", 303)))
        else:
            current.set(session)
            await self._app(scope, receive, _with_headers(send))

    def _foreign(self, scope: Scope, headers: dict[str, str]) -> str:
        """Why a request does not come from a page of this console; empty if it does."""
        host = headers.get("host", "")
        if self._users is None and urlsplit(f"//{host}").hostname not in LOCAL_HOSTS:
            return f"the console serves this machine only, by the name localhost, not {host[:100]!r}"
        origin = headers.get("origin")
        if origin is None:
            needs_origin = scope["type"] == "websocket" or scope["method"] not in ("GET", "HEAD")
            is_foreign = headers.get("sec-fetch-site", "none") in ("cross-site", "same-site")
            is_page = headers.get("sec-fetch-mode") == "navigate" and scope.get("method") == "GET"
            return _FOREIGN if needs_origin or (is_foreign and not is_page) else ""
        parts = urlsplit(origin)
        secure = scope["scheme"] in ("https", "wss")
        return "" if (parts.netloc, parts.scheme) == (host, "https" if secure else "http") else _FOREIGN

    def _session(self, headers: dict[str, str]) -> Session | None:
        if self._users is None:
            return self._local
        try:
            cookie = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
        except CookieError:
            return None
        return None if cookie is None else self._sessions.find(cookie.value, _now())

    async def _unknown(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the login page to a browser without a session."""
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 4401})
        elif scope["path"] in _OPEN_PATHS:
            await self._app(scope, receive, _with_headers(send))
        elif scope["path"] != "/login":
            page = scope["method"] == "GET" and scope["path"] == "/"
            response = RedirectResponse("/login", 303) if page else PlainTextResponse("log in first", 401)
            await _refuse(scope, receive, send, response)
        elif scope["method"] == "POST":
            await _refuse(scope, receive, send, await self._login(scope, receive))
        else:
            await _refuse(scope, receive, send, _login_page())

    async def _login(self, scope: Scope, receive: Receive) -> Response:
        address = str((scope.get("client") or ("?",))[0])
        form = await _form(receive)
        name, password = (form.get(each, [""])[0] for each in ("name", "password"))
        shown = name if NAME.fullmatch(name) else "an unknown name"
        wait = self._limit.wait(address, _now())
        if wait or self._waiting >= MAX_LOGINS:
            self._note(f"login of {shown} from {address} was refused: too many attempts")
            said = f"Too many attempts; try again in {max(1, round(wait / 60))} min."
            return _login_page(said, name, 429)
        self._limit.failed(address, _now())  # until it has succeeded, so that attempts at the same time count, too
        user = await self._verified(name, password)
        if user is None:
            self._note(f"login of {shown} from {address} failed")
            return _login_page("Name or password is wrong.", name, 403)
        self._limit.succeeded(address)
        session = self._sessions.begin(user, address, _now())
        if session is None:
            return _login_page("Too many users are logged in.", name, 503)
        self._note(f"{user.name} ({user.role}) has logged in from {address}")
        response = RedirectResponse("/", 303)
        response.set_cookie(
            COOKIE, session.key, max_age=int(LIFETIME), path="/", secure=True, httponly=True, samesite="strict"
        )
        return response

    async def _verified(self, name: str, password: str) -> User | None:
        assert self._users is not None
        self._waiting += 1
        try:
            async with self._verifying:
                return await asyncio.to_thread(self._users.verified, name, password)
        finally:
            self._waiting -= 1

    async def _socket(self, session: Session, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a socket until it or its session ends."""
        if self._users is not None and session.sockets >= MAX_SOCKETS:
            await send({"type": "websocket.close", "code": 4429})
            return
        session.sockets += 1
        current.set(session)
        serving = asyncio.ensure_future(self._app(scope, receive, send))
        ending = asyncio.ensure_future(self._until_end(session))
        try:
            await asyncio.wait({serving, ending}, return_when=asyncio.FIRST_COMPLETED)
            if not serving.done():
                serving.cancel()
                await asyncio.wait({serving})
                await send({"type": "websocket.close", "code": 4401})
            elif not serving.cancelled():
                serving.result()
        finally:
            session.sockets -= 1
            session.seen = _now()
            for each in (serving, ending):
                each.cancel()

    async def _until_end(self, session: Session) -> None:
        if self._users is None:
            await session.ended.wait()
            return
        try:
            async with asyncio.timeout(session.began + LIFETIME - _now()):
                await session.ended.wait()
        except TimeoutError:
            self._sessions.end(session)


def _now() -> float:
    return asyncio.get_running_loop().time()


async def _form(receive: Receive) -> dict[str, list[str]]:
    """The fields of a form of up to `MAX_FORM` bytes; nothing of a longer one."""
    body = b""
    while True:
        message = await receive()
        body += message.get("body", b"")
        if message["type"] != "http.request" or len(body) > MAX_FORM:
            return {}
        if not message.get("more_body"):
            break
    try:
        return parse_qs(body.decode(), max_num_fields=8)
    except ValueError:
        return {}


async def _refuse(scope: Scope, receive: Receive, send: Send, response: Response) -> None:
    """Answer in place of the application."""
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 4403})
    else:
        await response(scope, receive, _with_headers(send))


def _with_headers(send: Send) -> Send:
    async def with_headers(message: Any) -> None:
        if message["type"] == "http.response.start":
            message = {**message, "headers": [*message.get("headers", ()), *HEADERS]}
        await send(message)

    return with_headers


def _without_cookie(response: Response) -> Response:
    response.delete_cookie(COOKIE, path="/", secure=True, httponly=True, samesite="strict")
    return response


def _login_page(problem: str = "", name: str = "", status: int = 200) -> Response:
    return HTMLResponse(_LOGIN.format(problem=escape(problem), name=escape(name[:32], quote=True)), status)


_LOGIN: Final = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>jauspy console: sign in</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark">
<link rel="stylesheet" href="/static/theme.css"></head>
<body class="login"><main><form method="post" action="/login" class="sign-in">
<h1>jauspy console</h1>
<label for="name">Name</label>
<input id="name" name="name" value="{name}" autocomplete="username" autofocus required
 autocapitalize="none" spellcheck="false">
<label for="password">Password</label>
<input id="password" name="password" type="password" autocomplete="current-password" required>
<p class="problem" role="alert">{problem}</p>
<button type="submit">Sign in</button>
</form></main></body></html>
"""
