"""The login middleware of the console: TLS and a login for other machines, and requests of other sites."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

import httpx

from jauspy.console import users as users_module
from jauspy.console.certificates import check_certificate, make_certificate
from jauspy.console.login import COOKIE, MAX_FORM, LoginMiddleware
from jauspy.console.users import MAX_FAILURES, Users, add_user, current_user
from jauspy.errors import ConfigError

HOST = "ground:8101"
PASSWORD = "a long password"


async def behind(scope: Any, receive: Any, send: Any) -> None:
    """The protected application: it replies with the name of the user; a socket stays open until it is closed."""
    user = current_user()
    assert user is not None
    if scope["type"] == "websocket":
        await send({"type": "websocket.accept"})
        while (await receive())["type"] != "websocket.disconnect":
            pass
        return
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": user.name.encode()})


@pytest.fixture
def users(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Users:
    monkeypatch.setattr(users_module, "MEMORY_COST", 64)
    monkeypatch.setattr(users_module, "ITERATIONS", 1)
    add_user(tmp_path / "users.toml", "anna", "operator", PASSWORD)
    return Users(tmp_path / "users.toml")


def client(middleware: LoginMiddleware, base: str = f"https://{HOST}") -> httpx.AsyncClient:
    return httpx.AsyncClient(transport=httpx.ASGITransport(middleware), base_url=base)  # type: ignore[arg-type]  # ASGI


async def login(at: httpx.AsyncClient, password: str = PASSWORD, **headers: str) -> httpx.Response:
    headers = {"origin": f"https://{HOST}", **headers}
    return await at.post("/login", data={"name": "anna", "password": password}, headers=headers)


class Socket:
    """A WebSocket at the middleware."""

    def __init__(
        self, middleware: LoginMiddleware, path: str, cookie: str = "", origin: str = f"https://{HOST}"
    ) -> None:
        headers = [(b"host", HOST.encode()), (b"origin", origin.encode()), (b"cookie", cookie.encode())]
        scope = {"type": "websocket", "path": path, "scheme": "wss", "headers": headers, "client": ("10.0.0.1", 1)}
        self._middleware, self._scope = middleware, scope
        self.said: asyncio.Queue[dict[str, Any]] = asyncio.Queue()
        self.task = asyncio.ensure_future(middleware(scope, self._receive, self.said.put))

    async def _receive(self) -> dict[str, Any]:
        await asyncio.Event().wait()
        return {}

    async def next(self) -> dict[str, Any]:
        return await asyncio.wait_for(self.said.get(), 5.0)


async def test_nothing_is_reached_without_a_login_and_everything_with_one(users: Users) -> None:
    notes: list[str] = []
    middleware = LoginMiddleware(behind, users, notes.append)
    async with client(middleware) as at:
        assert (await at.get("/")).headers["location"] == "/login"
        for path in ("/static/console.js", "/_nicegui/x/components/y", "/_nicegui_ws/socket.io/"):
            assert (await at.get(path)).status_code == 401
        page = await at.get("/login")
        assert page.headers["x-frame-options"] == "DENY"
        assert "<h1>jauspy console</h1>" in page.text
        assert (await login(at, "wrong password")).status_code == 403
        answer = await login(at)
        cookie = answer.headers["set-cookie"]
        assert cookie.startswith(f"{COOKIE}=")
        assert {"HttpOnly", "Secure", "Path=/", "SameSite=strict"} <= set(cookie.split("; "))
        assert (await at.get("/")).text == "anna"
        assert (await at.get("/login")).headers["location"] == "/"
    assert notes == ["login of anna from 127.0.0.1 failed", "anna (operator) has logged in from 127.0.0.1"]


async def test_logging_out_closes_sockets(users: Users) -> None:
    middleware = LoginMiddleware(behind, users, lambda _: None)
    async with client(middleware) as at:
        cookie = (await login(at)).headers["set-cookie"].partition(";")[0]
        socket = Socket(middleware, "/_nicegui_ws/socket.io/", cookie)
        assert (await socket.next())["type"] == "websocket.accept"
        assert (await at.post("/logout", headers={"origin": f"https://{HOST}"})).headers["location"] == "/login"
        assert (await socket.next())["type"] == "websocket.close"
        await socket.task
        assert (await at.get("/")).headers["location"] == "/login"
        replayed = Socket(middleware, "/ws/stop/x", cookie)
        assert await replayed.next() == {"type": "websocket.close", "code": 4401}


@pytest.mark.parametrize("path", ["/ws/stop/x", "/ws/drive/101/x", "/_nicegui_ws/socket.io/"])
async def test_sockets_of_other_sites_are_closed(users: Users, path: str) -> None:
    middleware = LoginMiddleware(behind, users, lambda _: None)
    async with client(middleware) as at:
        cookie = (await login(at)).headers["set-cookie"].partition(";")[0]
    for origin in ("https://elsewhere.example", f"http://{HOST}", "null", ""):
        socket = Socket(middleware, path, cookie, origin)
        assert await socket.next() == {"type": "websocket.close", "code": 4403}


async def test_other_sites_and_names_are_refused(users: Users) -> None:
    middleware = LoginMiddleware(behind, users, lambda _: None)
    async with client(middleware) as at:
        assert (await login(at, origin="https://elsewhere.example")).status_code == 403
        assert (await at.post("/login", data={})).status_code == 403, "a form without an origin"
    local = LoginMiddleware(behind, None, lambda _: None)
    async with client(local, "http://localhost:8101") as at:
        assert (await at.get("/")).text == "local"
        assert (await at.get("/", headers={"origin": "http://elsewhere.example"})).status_code == 403
        foreign = {"sec-fetch-site": "cross-site", "sec-fetch-mode": "no-cors"}
        assert (await at.get("/", headers=foreign)).status_code == 403
        assert (await at.get("/", headers={"host": "rebound.example:8101"})).status_code == 403


async def test_attempts_are_limited_and_forms_are_bounded(users: Users) -> None:
    middleware = LoginMiddleware(behind, users, lambda _: None)
    async with client(middleware) as at:
        answers = await asyncio.gather(*(login(at, "wrong password") for _ in range(MAX_FAILURES + 2)))
        assert sorted(each.status_code for each in answers) == [*[403] * MAX_FAILURES, 429, 429]
        refused = await login(at)
        assert refused.status_code == 429
        assert "try again in 5 min" in refused.text
    async with client(LoginMiddleware(behind, users, lambda _: None)) as at:
        assert (await login(at, "x" * MAX_FORM)).status_code == 403


def test_certificates_that_fit_and_that_do_not(tmp_path: Path) -> None:
    first, second = ([tmp_path / f"{n}.pem", tmp_path / f"{n}-key.pem"] for n in "ab")
    fingerprint = make_certificate(["ground.local", "192.168.1.20"], *first)
    assert len(fingerprint.split(":")) == 32
    make_certificate(["ground.local"], *second)
    check_certificate(*first)
    with pytest.raises(ConfigError, match="do not fit"):
        check_certificate(first[0], second[1])
    with pytest.raises(ConfigError, match="no such file"):
        check_certificate(tmp_path / "none.pem", first[1])
    with pytest.raises(ConfigError, match="neither an IP address nor a host name"):
        make_certificate(["." * 80], tmp_path / "c.pem", tmp_path / "c-key.pem")
