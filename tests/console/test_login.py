"""The login middleware of the console: TLS and a login for other machines, and requests of other sites."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

import httpx

from jauspy.console import body_limit, login as login_module, users as users_module
from jauspy.console.body_limit import MAX_BODY, BodyLimit
from jauspy.console.certificates import check_certificate, make_certificate
from jauspy.console.login import (
    MAX_CONTROL_SOCKETS,
    MAX_FORM,
    MAX_SOCKETS,
    LoginMiddleware,
    cookie_name,
)
from jauspy.console.login_limit import MAX_FAILURES, MAX_FAILURES_IN_ALL, MAX_LOGINS_OF_HOST
from jauspy.console.users import Users, add_user, current_user
from jauspy.errors import ConfigError

PORT = 8101
HOST = f"ground:{PORT}"
LOCAL = f"http://localhost:{PORT}"
TOKEN = "token-of-this-start"
COOKIE = cookie_name(PORT, secure=True)
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


def gate(users: Users | None = None, note: Callable[[str], None] = lambda _: None) -> LoginMiddleware:
    return LoginMiddleware(behind, users, note, port=PORT, token=TOKEN)


def client(app: Any, base: str = f"https://{HOST}", address: str = "127.0.0.1") -> httpx.AsyncClient:
    return httpx.AsyncClient(transport=httpx.ASGITransport(app, client=(address, 1)), base_url=base)


async def login(at: httpx.AsyncClient, password: str = PASSWORD, **headers: str) -> httpx.Response:
    headers = {"origin": f"https://{HOST}", **headers}
    return await at.post("/login", data={"name": "anna", "password": password}, headers=headers)


class Socket:
    """A WebSocket at the middleware."""

    def __init__(
        self,
        middleware: LoginMiddleware,
        path: str,
        cookie: str = "",
        origin: str = f"https://{HOST}",
        host: str = HOST,
    ) -> None:
        headers = [(b"host", host.encode()), (b"origin", origin.encode()), (b"cookie", cookie.encode())]
        scheme = "wss" if host == HOST else "ws"
        scope = {"type": "websocket", "path": path, "scheme": scheme, "headers": headers, "client": ("10.0.0.1", 1)}
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
    middleware = gate(users, notes.append)
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
    middleware = gate(users)
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
    middleware = gate(users)
    async with client(middleware) as at:
        cookie = (await login(at)).headers["set-cookie"].partition(";")[0]
    for origin in ("https://elsewhere.example", f"http://{HOST}", "null", ""):
        socket = Socket(middleware, path, cookie, origin)
        assert await socket.next() == {"type": "websocket.close", "code": 4403}


async def test_other_sites_and_names_are_refused(users: Users) -> None:
    middleware = gate(users)
    async with client(middleware) as at:
        assert (await login(at, origin="https://elsewhere.example")).status_code == 403
        assert (await at.post("/login", data={})).status_code == 403, "a form without an origin"
    async with client(gate(), LOCAL) as at:
        assert (await at.get("/", params={"token": TOKEN})).status_code == 303
        assert (await at.get("/")).text == "local"
        assert (await at.get("/", headers={"origin": "http://elsewhere.example"})).status_code == 403
        for host in ("rebound.example:8101", "[", ""):
            assert (await at.get("/", headers={"host": host})).status_code == 403
        assert (await at.get("/", headers={"origin": "http://["})).status_code == 403


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
@pytest.mark.parametrize(
    ("mode", "destination"),
    [
        ("navigate", "iframe"),
        ("navigate", "object"),
        ("no-cors", "image"),
        ("cors", "empty"),
        ("websocket", "websocket"),
    ],
)
async def test_pages_of_other_sites_embed_and_request_nothing(site: str, mode: str, destination: str) -> None:
    async with client(gate(), LOCAL) as at:
        await at.get("/", params={"token": TOKEN})
        headers = {"sec-fetch-site": site, "sec-fetch-mode": mode, "sec-fetch-dest": destination}
        assert (await at.get("/", headers=headers)).status_code == 403
        assert (await at.get("/", params={"token": TOKEN}, headers=headers)).status_code == 403
        headers |= {"sec-fetch-mode": "navigate", "sec-fetch-dest": "document"}
        assert (await at.get("/", headers=headers)).text == "local", "a link of another page"
        assert (
            await at.get("/", headers={"sec-fetch-site": "same-origin", "sec-fetch-dest": "iframe"})
        ).status_code == 403


async def test_the_token_becomes_a_cookie_and_leaves_the_address() -> None:
    async with client(gate(), LOCAL) as at:
        for path in ("/", "/?token=", "/?token=guessed", "/static/theme.css", "/_nicegui_ws/socket.io/", "/login"):
            refused = await at.get(path)
            assert refused.status_code == 403
            assert "opens only at the address with its token" in refused.text
            assert "set-cookie" not in refused.headers
        entered = await at.get("/", params={"token": TOKEN})
        assert (entered.status_code, entered.headers["location"]) == (303, "/")
        cookie = entered.headers["set-cookie"]
        assert cookie.startswith(f"jauspy-{PORT}="), "cookies are shared by the ports of a host"
        assert {"HttpOnly", "Path=/", "SameSite=strict"} <= set(cookie.split("; "))
        assert TOKEN not in cookie
        assert (await at.get("/")).text == "local"
        again = await at.get("/", params={"token": TOKEN})
        assert (again.status_code, "set-cookie" in again.headers) == (303, False)
    async with client(gate(), LOCAL) as restarted:
        restarted.headers["cookie"] = cookie.partition(";")[0]
        assert (await restarted.get("/")).status_code == 403, "a restart ends all sessions"


async def test_a_cookie_is_of_the_user_who_has_entered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Browsers send it to all ports of the machine, to servers of other users, too."""
    notes: list[str] = []
    user: list[int | None] = [1000]
    monkeypatch.setattr(login_module, "peer_user", lambda *_: user[0])
    middleware = gate(note=notes.append)
    async with client(middleware, LOCAL) as at:
        cookie = (await at.get("/", params={"token": TOKEN})).headers["set-cookie"].partition(";")[0]
        assert (await at.get("/")).text == "local"
        for other in (1001, None):
            user[0] = other
            assert (await at.get("/")).status_code == 403
            socket = Socket(middleware, "/ws/stop/x", cookie, origin=LOCAL, host=f"localhost:{PORT}")
            assert await socket.next() == {"type": "websocket.close", "code": 4401}
        user[0] = 1000
        assert (await at.get("/")).text == "local"
    refused = "requests of another user of this machine with the cookie of a session were refused"
    assert notes == [f"{refused}: {count} so far" for count in (1, 2, 4)]


async def test_a_link_with_the_token_on_another_page_opens_the_console() -> None:
    """A redirect of such a link would not bring the cookie, which is only sent from pages of the same site."""
    async with client(gate(), LOCAL) as at:
        link = {"sec-fetch-site": "cross-site", "sec-fetch-mode": "navigate", "sec-fetch-dest": "document"}
        entered = await at.get("/", params={"token": TOKEN}, headers=link)
        assert entered.status_code == 200
        assert '<meta http-equiv="refresh" content="0; url=/">' in entered.text
        assert entered.headers["cache-control"] == "no-store"
        assert (await at.get("/")).text == "local"


async def test_sockets_need_a_session_and_have_places_for_stopping() -> None:
    middleware = gate()
    async with client(middleware, LOCAL) as at:
        cookie = (await at.get("/", params={"token": TOKEN})).headers["set-cookie"].partition(";")[0]

    async def open_one(path: str, cookie: str = cookie) -> dict[str, Any]:
        return await Socket(middleware, path, cookie, origin=LOCAL, host=f"localhost:{PORT}").next()

    accepted, refused = {"type": "websocket.accept"}, {"type": "websocket.close", "code": 4429}
    assert await open_one("/ws/stop/x", cookie="") == {"type": "websocket.close", "code": 4401}
    found = [await open_one("/ws/video/101.1.106/x") for _ in range(MAX_SOCKETS + 1)]
    assert found == [*[accepted] * MAX_SOCKETS, refused]
    for path in ("/ws/stop/x", "/ws/drive/101/x", "/ws/jog/101.1.104/x"):
        assert await open_one(path) == accepted
    found = [await open_one("/ws/stop/x") for _ in range(MAX_CONTROL_SOCKETS)]
    assert found[-1] == refused


async def test_attempts_are_limited_and_forms_are_bounded(users: Users) -> None:
    middleware = gate(users)
    async with client(middleware) as at:
        answers = await asyncio.gather(*(login(at, "wrong password") for _ in range(MAX_FAILURES)))
        waiting = MAX_LOGINS_OF_HOST
        assert sorted(each.status_code for each in answers) == [*[403] * waiting, *[429] * (MAX_FAILURES - waiting)]
        for _ in range(MAX_FAILURES - waiting):
            assert (await login(at, "wrong password")).status_code == 403
        refused = await login(at)
        assert refused.status_code == 429
        assert "try again in 5 min" in refused.text
    async with client(gate(users)) as at:
        assert (await login(at, "x" * MAX_FORM)).status_code == 403


@pytest.mark.slow
async def test_guesses_of_others_lock_nobody_out(users: Users) -> None:
    notes: list[str] = []
    middleware = gate(users, notes.append)
    async with client(middleware) as known:
        cookie = (await login(known)).headers.get_list("set-cookie")[1]
        assert cookie.startswith(f"{COOKIE}-device-anna=")
        assert {"HttpOnly", "Secure", "Path=/", "SameSite=strict"} <= set(cookie.split("; "))
        for each in range(MAX_FAILURES_IN_ALL):
            async with client(middleware, address=f"10.0.0.{each}") as attacker:
                assert (await login(attacker, "wrong password")).status_code == 403
                await login(attacker, "wrong password")
        assert (await known.get("/")).text == "anna", "who is logged in stays so"
        async with client(middleware, address="10.9.9.9") as elsewhere:
            assert (await login(elsewhere)).status_code == 303, "an address without failures"
        async with client(middleware, address=f"10.0.0.{MAX_FAILURES_IN_ALL - 1}") as beside:
            beside.headers["cookie"] = cookie.partition(";")[0]
            assert (await login(beside)).status_code == 303, "a device that is known, beside an attacker"
        async with client(middleware, address=f"10.0.0.{MAX_FAILURES_IN_ALL - 1}") as forged:
            forged.headers["cookie"] = cookie.partition(";")[0] + "0"
            assert (await login(forged)).status_code == 429, "a cookie that was not issued"
    assert sum("refused" in each for each in notes) < 10


async def test_a_device_is_of_one_user_and_one_password(users: Users, tmp_path: Path) -> None:
    async with client(gate(users)) as at:
        cookie = (await login(at)).headers.get_list("set-cookie")[1].partition(";")[0]
    device, _, tag = cookie.partition("=")[2].partition(".")
    assert users.device_tag("anna", device) == tag
    assert users.device_tag("nobody", device) == ""
    assert Users(tmp_path / "users.toml").device_tag("anna", device) == tag, "after a restart"
    add_user(tmp_path / "users.toml", "anna", "operator", "another password")
    assert Users(tmp_path / "users.toml").device_tag("anna", device) != tag


async def reading(scope: Any, receive: Any, send: Any) -> None:
    """An application that reads the whole body, as for an upload."""
    size, more = 0, True
    while more:
        message = await receive()
        if message["type"] == "http.disconnect":
            raise RuntimeError("the browser has left")
        size, more = size + len(message.get("body", b"")), message.get("more_body", False)
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": str(size).encode()})


async def test_bodies_are_bounded_by_the_server() -> None:
    async def parts(size: int) -> AsyncIterator[bytes]:
        for _ in range(size // 1024):
            yield bytes(1024)

    async with client(BodyLimit(reading)) as at:
        assert (await at.post("/upload", content=bytes(MAX_BODY))).text == str(MAX_BODY)
        assert (await at.post("/upload", content=parts(MAX_BODY))).text == str(MAX_BODY)
        for content in (bytes(MAX_BODY + 1), parts(MAX_BODY + 1024)):
            refused = await at.post("/upload", content=content)
            assert refused.status_code == 413
            assert refused.text == "a request to the console has at most 1088 kB; send a smaller file"
            assert refused.headers["connection"] == "close"
        assert (await at.post("/upload", content=b"", headers={"content-length": "-1"})).status_code == 413


async def test_a_body_that_never_ends_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(body_limit, "BODY_TIME", 0.05)
    sent: list[dict[str, Any]] = []

    async def receive() -> dict[str, Any]:
        await asyncio.Event().wait()
        return {}

    async def send(message: dict[str, Any]) -> None:
        sent.append(message)

    await BodyLimit(reading)({"type": "http", "path": "/", "method": "POST", "headers": []}, receive, send)
    assert sent[0]["status"] == 408


async def test_a_long_answer_has_no_time_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(body_limit, "BODY_TIME", 0.0)

    async def downloading(scope: Any, receive: Any, send: Any) -> None:
        await send({"type": "http.response.start", "status": 200, "headers": []})
        await receive()
        await send({"type": "http.response.body", "body": b"the end"})

    async with client(BodyLimit(downloading)) as at:
        assert (await at.get("/")).text == "the end"


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
