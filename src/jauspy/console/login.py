"""ASGI middleware for all requests of the console, including NiceGUI's socket: sessions, logins, origins, shares.

With users, a session begins with a password. At a console without users, which serves its own machine only, it begins
with the token in the address that `jauspy console` prints. Who operates a robot is decided in `operation`.
"""

from __future__ import annotations

import asyncio
import hmac
import secrets
from collections.abc import Callable
from html import escape
from typing import Any, Final
from urllib.parse import SplitResult, parse_qs, urlsplit

from starlette.requests import cookie_parser
from starlette.responses import HTMLResponse, PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from jauspy.console.connections import Connections
from jauspy.console.languages import COOKIE, language_of, sentence, translated
from jauspy.console.login_limit import LoginLimit, Turns
from jauspy.console.peer_user import peer_user
from jauspy.console.users import LIFETIME, LOCAL, NAME, Session, Sessions, Users, current

LOCAL_HOSTS: Final = frozenset({"127.0.0.1", "localhost", "::1"})
"""Hosts of a console without a login."""
MAX_FORM: Final = 4096
"""Bytes of a login."""
MAX_SOCKETS: Final = 48
"""Sockets of one session, beside those for stopping and driving."""
MAX_SOCKETS_IN_ALL: Final = 256
CONTROL_PATHS: Final = ("/ws/stop/", "/ws/drive/", "/ws/jog/")
"""Sockets for stopping and driving, which have places of their own."""
MAX_CONTROL_SOCKETS: Final = 24
"""Sockets for stopping and driving of one session: three for each page."""
MAX_CONTROL_SOCKETS_IN_ALL: Final = 256
DEVICE_LIFETIME: Final = 180 * 24 * 3600
"""Seconds for which a browser keeps the cookie of a device."""
_OPEN_PATHS: Final = ("/static/theme.css",)
"""Paths that need no session: files of the login page."""
_FOREIGN: Final = "this page of another site may not use the console"
_EMBEDDED: Final = frozenset({"iframe", "frame", "embed", "object", "fencedframe"})
"""Values of Sec-Fetch-Dest for a page within another one."""
_CLOSED: Final = sentence(
    "This console opens only at the address with its token that `jauspy console` prints when it starts; "
    "open that address, or start the console again."
)
HEADERS: Final = [
    (b"x-frame-options", b"DENY"),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"same-origin"),  # with no-referrer, browsers send `Origin: null` with the login
]


def cookie_name(port: int, *, secure: bool) -> str:
    """The name of the session's cookie: cookies are shared by all ports of a host, so it contains the port.

    A browser takes a cookie with `__Host-` only with Secure, for this host only, with the path `/`.
    """
    return f"{'__Host-' if secure else ''}jauspy-{port}"


class LoginMiddleware:
    """Passes requests and WebSockets of users to `app`; refuses all others.

    With `users`, everything but the login page needs a session. Without, the host of a request must be one of
    `LOCAL_HOSTS`, so that other sites cannot reach the console by DNS rebinding, and `token` begins a session.
    """

    def __init__(
        self,
        app: ASGIApp,
        users: Users | None,
        note: Callable[[str], None],
        *,
        port: int,
        token: str = "",
        connections: Connections | None = None,
    ) -> None:
        self._app = app
        self._users = users
        self._note = note
        self._token = token.encode()
        self._cookie = cookie_name(port, secure=users is not None)
        self._connections = Connections() if connections is None else connections
        self._sessions = Sessions(lasting=users is None)
        self._limit = LoginLimit()
        self._turns = Turns()
        self._refused = self._strange_cookies = 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection, as ASGI defines."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        with self._connections.request_of(scope.get("client")):
            await self._handle(scope, receive, send)

    async def _handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers = _headers(scope)
        problem = self._foreign(scope, headers)
        if problem:
            await _refuse(scope, receive, send, PlainTextResponse(problem, 403))
            return
        session = self._session(headers)
        if session is not None and session.peer is not None and session.peer != _peer(scope):
            self._strange_cookies += 1
            if _is_power_of_two(self._strange_cookies):
                seen = f"{self._strange_cookies} so far"
                self._note(
                    f"requests of another user of this machine with the cookie of a session were refused: {seen}"
                )
            session = None
        if session is not None:
            self._connections.is_of(scope.get("client"), session, is_socket=scope["type"] == "websocket")
        if self._users is None and scope["type"] == "http" and (token := _token(scope)):
            await _refuse(scope, receive, send, self._entered(token, session, scope, headers))
        elif session is None:
            await self._unknown(scope, receive, send)
        elif scope["type"] == "websocket":
            await self._socket(session, scope, receive, send)
        elif self._users is not None and scope["path"] == "/login":
            await _refuse(scope, receive, send, RedirectResponse("/", 303))
        elif self._users is not None and scope["path"] == "/logout" and scope["method"] == "POST":
            self._sessions.end(session)
            self._note(sentence("{user} has signed out", user=session.user.name))
            response = RedirectResponse("/login", 303)
            response.delete_cookie(self._cookie, path="/", secure=True, httponly=True, samesite="strict")
            await _refuse(scope, receive, send, response)
        else:
            current.set(session)
            await self._app(scope, receive, _with_headers(send))

    def _foreign(self, scope: Scope, headers: dict[str, str]) -> str:
        """Why a request does not come from a page of this console; empty if it does."""
        host = headers.get("host", "")
        if self._users is None and _split(f"//{host}").hostname not in LOCAL_HOSTS:
            return f"the console serves this machine only, by the name localhost, not {host[:100]!r}"
        destination = headers.get("sec-fetch-dest", "document")
        is_foreign = headers.get("sec-fetch-site", "none") in ("cross-site", "same-site")
        is_link = scope.get("method") == "GET" and (headers.get("sec-fetch-mode"), destination) == (
            "navigate",
            "document",
        )
        if destination in _EMBEDDED or (is_foreign and not is_link):
            return _FOREIGN
        origin = headers.get("origin")
        if origin is None:
            needs_origin = scope["type"] == "websocket" or scope["method"] not in ("GET", "HEAD")
            return _FOREIGN if needs_origin else ""
        parts = _split(origin)
        secure = scope["scheme"] in ("https", "wss")
        return "" if (parts.netloc, parts.scheme) == (host, "https" if secure else "http") else _FOREIGN

    def _session(self, headers: dict[str, str]) -> Session | None:
        key = cookie_parser(headers.get("cookie", "")).get(self._cookie)
        return None if key is None else self._sessions.find(key, _now())

    def _entered(self, token: str, session: Session | None, scope: Scope, headers: dict[str, str]) -> Response:
        """Exchange the token in an address for a cookie, and send the browser to the address without it."""
        if not hmac.compare_digest(token.encode("utf-8", "replace"), self._token):
            return _sentence_page(_language(headers), _CLOSED, 403)
        response: Response = RedirectResponse("/", 303)
        if headers.get("sec-fetch-site", "none") in ("cross-site", "same-site"):
            response = HTMLResponse(_CONTINUE)  # after a redirect, a link of another page would still bring no cookie
        response.headers["cache-control"] = "no-store"
        if session is None:
            begun = self._sessions.begin(LOCAL, "localhost", _now())
            assert begun is not None, "the oldest session of the only user has ended"
            begun.peer = _peer(scope)
            response.set_cookie(self._cookie, begun.key, path="/", httponly=True, samesite="strict")
        return response

    async def _unknown(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the login page to a browser without a session."""
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 4401})
        elif self._users is None:
            await _refuse(scope, receive, send, _sentence_page(_language(_headers(scope)), _CLOSED, 403))
        elif scope["path"] in _OPEN_PATHS:
            await self._app(scope, receive, _with_headers(send))
        elif scope["path"] != "/login":
            page = scope["method"] == "GET" and scope["path"] == "/"
            response = RedirectResponse("/login", 303) if page else PlainTextResponse("log in first", 401)
            await _refuse(scope, receive, send, response)
        elif scope["method"] == "POST":
            await _refuse(scope, receive, send, await self._login(scope, receive))
        else:
            await _refuse(scope, receive, send, _login_page(_language(_headers(scope))))

    async def _login(self, scope: Scope, receive: Receive) -> Response:
        assert self._users is not None
        users = self._users
        address = str((scope.get("client") or ("?",))[0])
        form, language = await _form(receive), _language(_headers(scope))
        name, password = (form.get(field, [""])[0] for field in ("name", "password"))
        device = self._device(name, scope)
        trusted = self._limit.trusts(device, _now())
        wait = self._limit.wait(address, name, device, _now())
        if wait or not self._turns.has_room(address, trusted=trusted):
            return self._too_many(name, address, wait, language)
        succeeded = self._limit.begin(address, name, device, _now())
        user = await self._turns.take(lambda: users.verified(name, password), address, trusted=trusted)
        if user is None:
            self._note(sentence("login of {name} from {address} failed", name=_shown(name), address=address))
            return _login_page(language, sentence("Name or password is wrong."), name, 403)
        succeeded()
        session = self._sessions.begin(user, address, _now())
        if session is None:
            return _login_page(language, sentence("Too many users are logged in."), name, 503)
        self._note(
            sentence("{user} ({role}) has logged in from {address}", user=user.name, role=user.role, address=address)
        )
        device = device or secrets.token_urlsafe(16)
        response = RedirectResponse("/", 303)
        for cookie, value, lifetime in (
            (self._cookie, session.key, int(LIFETIME)),
            (self._device_cookie(name), f"{device}.{users.device_tag(name, device)}", DEVICE_LIFETIME),
        ):
            response.set_cookie(
                cookie, value, max_age=lifetime, path="/", secure=True, httponly=True, samesite="strict"
            )
        return response

    def _too_many(self, name: str, address: str, wait: float, language: str) -> Response:
        self._refused += 1
        if _is_power_of_two(self._refused):
            attempts = f"{self._refused} so far"
            self._note(f"login of {_shown(name)} from {address} was refused: too many attempts ({attempts})")
        if wait:
            text = sentence("Too many attempts; try again in {minutes} min.", minutes=max(1, round(wait / 60)))
        else:
            text = sentence("Too many attempts; try again in a few seconds.")
        return _login_page(language, text, name, 429)

    def _device_cookie(self, name: str) -> str:
        return f"{self._cookie}-device-{name}"

    def _device(self, name: str, scope: Scope) -> str:
        """The device of a browser with which this user has logged in before; empty for others."""
        assert self._users is not None
        if not NAME.fullmatch(name):
            return ""
        headers = _headers(scope)
        device, _, tag = cookie_parser(headers.get("cookie", "")).get(self._device_cookie(name), "").partition(".")
        expected = self._users.device_tag(name, device)
        return device if expected and hmac.compare_digest(tag.encode("utf-8", "replace"), expected.encode()) else ""

    async def _socket(self, session: Session, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a socket until it or its session ends."""
        controls = scope["path"].startswith(CONTROL_PATHS)
        if not self._has_room(session, controls=controls):
            await send({"type": "websocket.close", "code": 4429})
            return
        _count(session, 1, controls=controls)
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
            _count(session, -1, controls=controls)
            session.seen = _now()
            for task in (serving, ending):
                task.cancel()

    def _has_room(self, session: Session, *, controls: bool) -> bool:
        """True if this session may open one more socket."""
        if controls:
            in_all = sum(other.control_sockets for other in self._sessions)
            return session.control_sockets < MAX_CONTROL_SOCKETS and in_all < MAX_CONTROL_SOCKETS_IN_ALL
        in_all = sum(other.sockets for other in self._sessions)
        return session.sockets < MAX_SOCKETS and in_all < MAX_SOCKETS_IN_ALL

    async def _until_end(self, session: Session) -> None:
        if self._users is None:
            await session.ended.wait()
            return
        try:
            async with asyncio.timeout(session.began + LIFETIME - _now()):
                await session.ended.wait()
        except TimeoutError:
            self._sessions.end(session)


def _count(session: Session, change: int, *, controls: bool) -> None:
    if controls:
        session.control_sockets += change
    else:
        session.sockets += change


def _token(scope: Scope) -> str:
    """The token in the address of the page; empty if there is none."""
    if scope["path"] != "/" or scope["method"] != "GET":
        return ""
    try:
        fields = parse_qs(str(scope.get("query_string", b""), "latin-1"), max_num_fields=8)
    except ValueError:
        return ""
    return fields.get("token", [""])[0]


def _is_power_of_two(count: int) -> bool:
    """True for the 1st, 2nd, 4th, ... of lines that anybody can cause."""
    return count & (count - 1) == 0


def _peer(scope: Scope) -> int | None:
    """The user of this machine who has sent a request, if that is known."""
    client, server = scope.get("client"), scope.get("server")
    return peer_user(tuple(client), tuple(server)) if client and server else None


def _headers(scope: Scope) -> dict[str, str]:
    return {name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]}


def _language(headers: dict[str, str]) -> str:
    """The code of the language of a browser."""
    return language_of(cookie_parser(headers.get("cookie", "")).get(COOKIE), headers.get("accept-language"))


def _split(url: str) -> SplitResult:
    """The parts of an address; empty ones if it is none."""
    try:
        return urlsplit(url)
    except ValueError:
        return urlsplit("")


def _shown(name: str) -> str:
    return name if NAME.fullmatch(name) else "an unknown name"


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


def _sentence_page(language: str, text: str, status: int) -> Response:
    return HTMLResponse(_SENTENCE.format(language=language, sentence=escape(translated(text, language))), status)


def _login_page(language: str, problem: str = "", name: str = "", status: int = 200) -> Response:
    texts = {name: escape(translated(text, language)) for name, text in _LOGIN_TEXTS.items()}
    said = escape(translated(problem, language))
    shown = escape(name[:32], quote=True)
    return HTMLResponse(_LOGIN.format(language=language, problem=said, name=shown, **texts), status)


_CONTINUE: Final = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>jauspy console</title>
<meta http-equiv="refresh" content="0; url=/"></head><body><a href="/">jauspy console</a></body></html>
"""
_SENTENCE: Final = """<!doctype html>
<html lang="{language}"><head><meta charset="utf-8"><title>jauspy console</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark">
</head><body><p>{sentence}</p></body></html>
"""
_LOGIN_TEXTS: Final = {
    "of_name": sentence("Name"),
    "of_password": sentence("Password"),
    "of_button": sentence("Sign in"),
}
_LOGIN: Final = """<!doctype html>
<html lang="{language}"><head><meta charset="utf-8"><title>jauspy console: {of_button}</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark">
<link rel="stylesheet" href="/static/theme.css"></head>
<body class="login"><main><form method="post" action="/login" class="sign-in">
<h1>jauspy console</h1>
<label for="name">{of_name}</label>
<input id="name" name="name" value="{name}" autocomplete="username" autofocus required
 autocapitalize="none" spellcheck="false">
<label for="password">{of_password}</label>
<input id="password" name="password" type="password" autocomplete="current-password" required>
<p class="problem" role="alert">{problem}</p>
<button type="submit">{of_button}</button>
</form></main></body></html>
"""
