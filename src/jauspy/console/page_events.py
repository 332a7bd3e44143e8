"""Checks what a browser sends on NiceGUI's socket, before Socket.IO and NiceGUI parse it.

A packet passes if it is one that NiceGUI's page sends, on behalf of a page of the same user, and if its value is one
that its element can have: a slider's is between its ends, a choice is one of the options. All others are counted and
dropped; too many end the connection. Lines of the browser for the server's log are dropped.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Final, Literal, TypeAlias
from urllib.parse import parse_qs

from nicegui import Client, ui
from nicegui.element import Element
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from pydantic_core import from_json
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from jauspy.console.browser_messages import MAX_INVALID, NOT_VALID, TOO_MANY, Budget
from jauspy.console.users import User, current_user

SOCKET_PATH: Final = "/_nicegui_ws/"
NAME: Final = "the page's socket"
MAX_PACKET: Final = 32 * 1024
"""Characters of a packet."""
MAX_VALUES: Final = 600
"""Numbers, texts, lists and objects in one argument of an event; the fields of a pointer's event are 50."""
MAX_DEPTH: Final = 6
MAX_TEXT: Final = 1000
"""Characters of a text in an argument."""
MAX_FIELD: Final = 200
"""Characters that may be typed into a field."""
MAX_EVENT_RATE: Final = 100.0
MAX_EVENTS_AT_ONCE: Final = 400
MAX_INTEGER: Final = 2**53
_FRAME: Final = re.compile("[1-6]")
"""The beginning of a frame of Engine.IO."""
_PACKET: Final = re.compile(r"(?P<kind>[012])(?P<ack>[0-9]{0,9})(?P<data>[\[{].*)?", re.DOTALL | re.ASCII)
_CONNECT, _DISCONNECT = "0", "1"
ENDING: Final = "jauspy.ending"
"""Where the ASGI scope of a socket has an event, which is set to end the socket with its next frame.

`disconnect` of Engine.IO would wait until all packets are sent, for ever if the browser has left.
"""

_Id = Annotated[str, Field(max_length=64)]
_Count = Annotated[int, Field(ge=0, le=MAX_INTEGER)]


class _OfClient(BaseModel):
    model_config = ConfigDict(extra="ignore", frozen=True)
    client_id: _Id


class _Handshake(_OfClient):
    tab_id: _Id
    document_id: _Id
    old_tab_id: _Id | None = None
    next_message_id: _Count | None = None


class _Event(_OfClient):
    id: _Count
    listener_id: _Id
    args: Annotated[list[str | None], Field(max_length=16)] = []


class _Ack(_OfClient):
    next_message_id: _Count


_HANDSHAKE: Final = TypeAdapter(_Handshake)
_Packet: TypeAlias = (
    tuple[Literal["handshake"], _Handshake]
    | tuple[Literal["event"], _Event]
    | tuple[Literal["ack"], _Ack]
    | tuple[Literal["log", "javascript_response"], Any]
)
_PACKETS: Final[TypeAdapter[_Packet]] = TypeAdapter(_Packet)


@dataclass
class _Connection:
    """State of one connection."""

    budget: Budget
    invalid: int = 0
    clients: set[str] = field(default_factory=set)
    """Pages that have made a handshake on it."""


class FrameCheck:
    """ASGI middleware: passes frames of Engine.IO on NiceGUI's socket, ends it at others; HTTP instead is refused."""

    def __init__(self, app: ASGIApp, refused: Callable[[str, str], None]) -> None:
        self._app = app
        self._refused = refused

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection, as ASGI defines."""
        if not scope.get("path", "").startswith(SOCKET_PATH):
            await self._app(scope, receive, send)
        elif scope["type"] == "websocket":
            ending = asyncio.Event()
            await self._app({**scope, ENDING: ending}, lambda: self._next(receive, ending), send)
        else:
            await PlainTextResponse("the console needs WebSockets", 400)(scope, receive, send)

    async def _next(self, receive: Receive, ending: asyncio.Event) -> Message:
        message: Message = {"type": "websocket.disconnect", "code": 1008} if ending.is_set() else await receive()
        if message["type"] != "websocket.receive" or _FRAME.match(message.get("text") or ""):
            return message
        self._refused(NAME, NOT_VALID)
        return {"type": "websocket.disconnect", "code": 1008}


class PageEvents:
    """The check, installed at this server; `refused` is called with the name of the socket and the reason."""

    def __init__(self, server: Any, refused: Callable[[str, str], None], now: Callable[[], float]) -> None:
        self._server = server
        self._refused = refused
        self._now = now
        self._users: dict[str, User] = {}
        """Users by the page that they have loaded."""
        handlers: dict[str, Callable[[str, Any], Awaitable[None]]] = server.eio.handlers
        self._pass_on = handlers["message"]
        handlers["message"] = self.receive

    def add(self, client: Client, user: User) -> None:
        """Accept events of this page from its user."""
        self._users[client.id] = user
        client.on_delete(lambda: self._users.pop(client.id, None))

    async def receive(self, connection: str, data: Any) -> None:
        """Handle a packet of a browser."""
        environ: dict[str, Any] | None = self._server.environ.get(connection)
        if environ is None:
            return
        state = environ.setdefault("jauspy.page_events", None)
        if state is None:
            state = environ["jauspy.page_events"] = _Connection(Budget(self._now(), MAX_EVENT_RATE, MAX_EVENTS_AT_ONCE))
        if not state.budget.take(self._now()):
            self._refused(NAME, TOO_MANY)
            environ["asgi.scope"][ENDING].set()
        elif (passes := self._passes(state, environ, data)) is None:
            state.invalid += 1
            self._refused(NAME, NOT_VALID)
            if state.invalid >= MAX_INVALID:
                environ["asgi.scope"][ENDING].set()
        elif passes:
            await self._pass_on(connection, data)

    def _passes(self, state: _Connection, environ: Mapping[str, Any], data: Any) -> bool | None:
        """True if a packet is passed on, False if it is dropped, None if it is not valid."""
        found = _PACKET.fullmatch(data) if isinstance(data, str) and len(data) <= MAX_PACKET else None
        if found is None:
            return None
        if found["kind"] == _CONNECT:
            return self._connects(state, environ) if not found["ack"] and found["data"] in (None, "{}") else None
        if found["kind"] == _DISCONNECT:
            return True if not found["ack"] and found["data"] is None else None
        try:
            name, content = _PACKETS.validate_json(found["data"] or "")
        except ValidationError:
            return None
        if name in ("log", "javascript_response"):
            return False  # the page does not ask for answers, and a browser does not write the server's log
        if name == "handshake":
            return self._begins(state, content.client_id)
        if content.client_id not in state.clients:
            return None
        return _fits(content) if isinstance(content, _Event) else True

    def _connects(self, state: _Connection, environ: Mapping[str, Any]) -> bool | None:
        query = {key: values[0] for key, values in parse_qs(str(environ.get("QUERY_STRING", ""))).items()}
        if query.get("implicit_handshake") != "true":
            return True
        try:
            handshake = _HANDSHAKE.validate_python(query)
        except ValidationError:
            return None
        return self._begins(state, handshake.client_id)

    def _begins(self, state: _Connection, client: str) -> bool | None:
        """A handshake of a page that is closed passes: NiceGUI then tells the browser to load it again."""
        if client in self._users:
            if self._users[client] != current_user():
                return None
            state.clients.add(client)
        return True if client in self._users or client not in Client.instances else None


def _fits(event: _Event) -> bool | None:
    """True if an element can have caused this event; False if its element or listener has gone meanwhile."""
    try:
        args = [None if arg is None else from_json(arg, allow_inf_nan=False) for arg in event.args]
    except ValueError:
        return None
    if not all(_is_small(arg) for arg in args):
        return None
    client = Client.instances.get(event.client_id)
    element = None if client is None else client.elements.get(event.id)
    if element is None or (listener := _listener(element, event.listener_id)) is None:
        return False
    if isinstance(element, ui.table) and listener == "update:pagination":
        return False  # a table says how many rows it has room for, which is set here
    if listener.startswith("update:"):
        return True if len(args) == 1 and can_have(element, args[0]) else None
    return True


def _listener(element: Element, id: str) -> str | None:
    """The name of the event for which an element has this listener."""
    listener = element._event_listeners.get(id)  # noqa: SLF001 - NiceGUI has no other access
    return None if listener is None else listener.type


def _is_small(value: Any, depth: int = MAX_DEPTH) -> bool:
    """True for a value with few parts, short texts and numbers that browsers have."""
    left = [(value, depth)]
    for count, (part, levels) in enumerate(left):
        if count >= MAX_VALUES or levels < 0:
            return False
        if isinstance(part, str) and len(part) > MAX_TEXT:
            return False
        if isinstance(part, int | float) and not abs(part) <= MAX_INTEGER:
            return False
        if isinstance(part, list):
            left.extend((element, levels - 1) for element in part[: MAX_VALUES + 1])
        elif isinstance(part, dict):
            if any(len(key) > MAX_TEXT for key in part):
                return False
            left.extend((element, levels - 1) for element in list(part.values())[: MAX_VALUES + 1])
    return True


def can_have(element: Element, value: Any) -> bool:
    """True if a browser can set this value of an element; of other kinds than these it sets none."""
    match element:
        case ui.slider():
            return _is_number(value) and element.props["min"] <= value <= element.props["max"]
        case ui.number():
            return value is None or value == "" or _is_number(value) or _is_typed_number(value)
        case ui.select():
            return _is_choice(value, len(element.options), several=element.multiple)
        case ui.toggle():
            return _is_index(value, len(element.options))
        case ui.checkbox() | ui.switch() | ui.dialog() | ui.menu():
            return isinstance(value, bool)
        case ui.input():
            return value is None or (isinstance(value, str) and len(value) <= MAX_FIELD)
    return False


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= MAX_INTEGER


def _is_typed_number(value: Any) -> bool:
    try:
        return isinstance(value, str) and len(value) <= 32 and abs(float(value)) <= MAX_INTEGER
    except ValueError:
        return False


def _is_index(value: Any, many: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < many


def _is_choice(value: Any, many: int, *, several: bool) -> bool:
    if several:
        items = value or []
        return isinstance(items, list) and all(_is_choice(choice, many, several=False) and choice for choice in items)
    return value is None or (isinstance(value, dict) and _is_index(value.get("value"), many))
