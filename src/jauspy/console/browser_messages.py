"""The messages of a browser on the console's sockets: their schemas, and their limits of size, number and rate.

A message that does not have the form of its socket is refused as a whole, and counted; nothing is clamped or guessed.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Annotated, Final, Literal, TypeAlias, TypeVar

from fastapi import WebSocket, WebSocketDisconnect
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

MAX_MESSAGE: Final = 1000
"""Characters of a message; nesting ends where its schema ends."""
MAX_RATE: Final = 60.0
"""Messages in a second on one socket; the page sends 20."""
MAX_AT_ONCE: Final = 200
"""Messages that may arrive at once after the network was interrupted: 10 s of them."""
MAX_INVALID: Final = 16
"""Invalid messages after which a socket is closed."""
MAX_SUBSYSTEM: Final = 65534
MAX_NUMBER: Final = 100.0
"""m/s or rad/s in a message; `motion` limits velocities further."""

T = TypeVar("T")
_Share = Annotated[float, Field(ge=-1.0, le=1.0, allow_inf_nan=False, strict=True)]
_Number = Annotated[float, Field(ge=-MAX_NUMBER, le=MAX_NUMBER, allow_inf_nan=False, strict=True)]
Deflections: TypeAlias = tuple[_Share, _Share]
"""Deflections of the stick: forward and left."""
ToolVelocity: TypeAlias = tuple[_Number, _Number, _Number, _Number, _Number, _Number, Literal["robot", "tool"]]
"""x, y, z in m/s, roll, pitch, yaw in rad/s, and the frame."""


class StopRequest(BaseModel):
    """`stop 101`, `stop all`, `release 101`; `leave` when the page is closed."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    verb: Literal["stop", "release", "leave"]
    target: Annotated[str, Field(pattern=r"^(all|[1-9][0-9]{0,4}|)$")]


class VideoRequest(BaseModel):
    """The pictures that a browser requests, and whether it shows the attitude."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)
    want: Literal["all", "keys", "nothing"] | None = None
    attitude: bool = False


def _parser(adapter: TypeAdapter[T]) -> Callable[[str], T | None]:
    """A function that returns the message in a text; None if it does not have the form of the schema."""

    def parse(text: str) -> T | None:
        try:
            return adapter.validate_json(text)
        except ValidationError:
            return None

    return parse


drive_message: Final = _parser(TypeAdapter[Deflections](Deflections))
jog_message: Final = _parser(TypeAdapter[ToolVelocity](ToolVelocity))
video_request: Final = _parser(TypeAdapter(VideoRequest))


def stop_request(text: str) -> StopRequest | None:
    """The request in a message of the socket for stops; None for anything else."""
    verb, _, target = text.partition(" ")
    try:
        request = StopRequest.model_validate({"verb": verb, "target": target})
    except ValidationError:
        return None
    if (verb == "leave") != (target == "") or (target.isdecimal() and int(target) > MAX_SUBSYSTEM):
        return None
    return request


def nothing(_: str) -> None:
    """The parser of a socket on which a browser sends nothing."""
    return


Parse: TypeAlias = Callable[[str], T | None]
Refuse: TypeAlias = Callable[[str], None]
"""Counts a refused message, by this reason."""
NOT_VALID: Final = "not valid"
TOO_MANY: Final = "too many"


class Budget:
    """The messages that one sender may still send: `at_once`, and `rate` in a second."""

    def __init__(self, now: float, rate: float = MAX_RATE, at_once: int = MAX_AT_ONCE) -> None:
        self._rate = rate
        self._most = self._left = float(at_once)
        self._since = now

    def take(self, now: float) -> bool:
        """True if one more message may be taken."""
        self._left = min(self._most, self._left + (now - self._since) * self._rate)
        self._since = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


async def messages(page: WebSocket, parse: Parse[T], refuse: Refuse, *, closes: bool = True) -> AsyncIterator[T | None]:
    """Yield the messages of a browser until it leaves; None for one that is not valid.

    After `MAX_INVALID` of these, and when there are too many of any kind, the socket is closed; with `closes` false it
    stays open, and what is too much waits in the browser.
    """
    clock = asyncio.get_running_loop().time
    budget, invalid = Budget(clock()), 0
    try:
        while True:
            message = await page.receive()
            if message["type"] != "websocket.receive":
                return
            if closes and not budget.take(clock()):
                refuse(TOO_MANY)
                await page.close(1008, "too many messages")
                return
            text = message.get("text")
            found = parse(text) if text is not None and len(text) <= MAX_MESSAGE else None
            if found is None:
                invalid += 1
                refuse(NOT_VALID)
                if closes and invalid >= MAX_INVALID:
                    await page.close(1008, "messages that are not valid")
                    return
            yield found
    except (WebSocketDisconnect, RuntimeError):
        return
