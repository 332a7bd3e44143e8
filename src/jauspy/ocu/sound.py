"""Microphones and announcers of a robot: its sound recorded as WAV files, and WAV files played there."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what may be wrong

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncGenerator, AsyncIterator, Mapping
from contextlib import aclosing, asynccontextmanager, suppress
from ipaddress import IPv4Address
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from jauspy.arguments import check_number
from jauspy.audio import need_audio
from jauspy.errors import ConfigError, RequestError, ResponseTimeout, TransportError
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
)
from jauspy.messages.exp import (
    ConfirmAnnunciatorStream,
    ControlAnnunciatorStream,
    QueryAnnunciatorEndpoint,
    QueryDigitalAudioSensorCapabilities,
    ReportAnnunciatorEndpoint,
    ReportDigitalAudioSensorCapabilities,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.platform.video_settings import RTP_SERVER_TYPE

if TYPE_CHECKING:
    from jauspy.audio.coding import Sound
    from jauspy.audio.receiver import AudioReceiver

MICROPHONE: Final = "aeodrs:DigitalAudioSensor"
ANNOUNCER: Final = "aeodrs:DigitalAudioAnnuciator"
ENDPOINTS: Final = "DigitalResourceDiscovery"
RENEWAL_INTERVAL: Final = 60.0
"""Seconds between two registrations; a robot removes an endpoint after five minutes."""
PACKET_SILENCE: Final = 3.0
"""Seconds without a packet after which `sound` raises, once the sound runs."""
PORT_RETRIES: Final = 5
"""Queries for the port of an announcer, which takes some seconds to start."""
LEAD: Final = 0.1
"""Seconds of silence before and after a message, for what starts late."""

_Command = ControlAnnunciatorStream.StreamCommand
_Status = ConfirmAnnunciatorStream.StreamStatus


class Microphone:
    """A microphone of a robot; `number` counts those of its component, from 1."""

    def __init__(self, connection: Connection, info: ComponentInfo, number: int = 1) -> None:
        self.info: ComponentInfo = info
        """The component that streams it."""
        self.number: int = number
        """Its number there."""
        self._connection = connection
        self._receiver: AudioReceiver | None = None
        self._counters: Mapping[str, int] = MappingProxyType({})

    def __repr__(self) -> str:
        return f"<microphone {self.number} of {self.info.id}>"

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of the last `sound` or `record`: `packets`, `lost` ones, those that were `concealed`, ..."""
        return self._counters if self._receiver is None else self._receiver.counters

    async def record(self, path: str | Path, *, seconds: float, address: str | None = None) -> float:
        """Record so many seconds as a WAV file of 48 kHz; an existing file is replaced. Returns the seconds in it.

        Otherwise as `sound`. Raises `ConfigError` for a file that cannot be written.
        """
        check_number(seconds, "seconds")
        need_audio()
        from jauspy.audio.wav_files import MAX_LENGTH, WavWriter, check_wav_name  # noqa: PLC0415 - needs NumPy

        if not 0.0 < seconds <= MAX_LENGTH:
            raise ConfigError(f"seconds is {seconds:g}; a recording has up to {MAX_LENGTH:g} s")
        path = Path(path)
        check_wav_name(path)
        async with aclosing(self.sound(address=address)) as sounds:
            first = await anext(sounds)
            with WavWriter(path) as file:
                file.add(first)
                async for sound in sounds:
                    file.add(sound)
                    if file.seconds >= seconds:
                        break
                return file.seconds

    async def sound(
        self, *, address: str | None = None, timeout: float = 20.0, silence: float = PACKET_SILENCE
    ) -> AsyncGenerator[Sound, None]:
        """The sound as it arrives: NumPy arrays of float32 at 48 kHz, full scale -1..1; extra `video`.

        Lost packets are concealed, and counted. `address` is the IP address of this machine to which the robot sends;
        by default the one from which the robot is reached. Raises `ResponseTimeout` when nothing arrives within
        `timeout` seconds, or for `silence` seconds later. The robot stops sending when the loop is left.
        """
        check_number(timeout, "timeout")
        check_number(silence, "silence")
        need_audio()
        from jauspy.audio.receiver import AudioReceiver  # noqa: PLC0415 - needs NumPy

        host = address or await self._connection.address_towards(self.info.id)
        if host is None:
            raise ConfigError(f"it is unknown on which machine {self.info.id} is; name the own one: address=...")
        with AudioReceiver(host) as receiver:
            self._receiver = receiver
            try:
                url = f"rtp://{f'[{host}]' if ':' in host else host}:{receiver.port}"
                async with (
                    self._registered(url),
                    aclosing(self._received(receiver, url, timeout, silence)) as sounds,
                ):
                    async for sound in sounds:
                        yield sound
            finally:
                self._counters, self._receiver = dict(receiver.counters), None

    async def _received(
        self, receiver: AudioReceiver, url: str, timeout: float, silence: float
    ) -> AsyncGenerator[Sound, None]:
        loop, arrived = asyncio.get_running_loop(), asyncio.Event()
        loop.add_reader(receiver.fileno(), arrived.set)
        try:
            end = loop.time() + timeout
            while True:
                arrived.clear()
                if sounds := receiver.take():
                    end = loop.time() + silence
                for sound in sounds:
                    yield sound
                try:
                    async with asyncio.timeout_at(end):
                        await arrived.wait()
                except TimeoutError:
                    counted = ", ".join(f"{name} {count}" for name, count in sorted(receiver.counters.items()))
                    raise ResponseTimeout(
                        f"{self.info.id} sends no sound to {url} ({counted or 'no packet has arrived'}); a firewall or "
                        "another network may be in between (`address` says where it is to send)"
                    ) from None
        finally:
            loop.remove_reader(receiver.fileno())

    @asynccontextmanager
    async def _registered(self, url: str) -> AsyncIterator[None]:
        """The sound is sent to `url` while this context is open, or until the OCU is closed."""
        endpoint = await self._register(url)
        renewal = asyncio.create_task(self._renew(url), name=f"sound of {self.info.id}")

        async def end() -> None:
            if not renewal.cancelling():
                renewal.cancel()
                with suppress(RequestError, TransportError):  # a component that is gone sends no sound
                    await self._connection.query(self.info.id, Remove(endpoint, 2), expects=Confirm)

        with self._connection.on_close(end):
            try:
                yield
            finally:
                await end()

    async def _register(self, url: str) -> int:
        await self._check_number()
        if self.info.find(ENDPOINTS) is None:
            raise ConfigError(f"{self.info.id} sends no sound: it does not offer {ENDPOINTS}")
        record = Register.DigitalResourceEndpointRec(RTP_SERVER_TYPE, url, None, self.number)
        answer = await self._connection.query(self.info.id, Register(Register.RequestIDRec(1), record), expects=Confirm)
        assert isinstance(answer, Confirm)
        if not answer.id:
            raise RequestError(
                f"{self.info.id} does not send microphone {self.number} to {url}: is this an address from which the "
                "robot hears this machine, is there a free place among the receivers, and the extra 'video' on it?"
            )
        return answer.id

    async def _check_number(self) -> None:
        if self.info.find(MICROPHONE) is None:
            raise ConfigError(f"{self.info.id} has no microphones: it does not offer {MICROPHONE}")
        query = QueryDigitalAudioSensorCapabilities(0)
        report = await self._connection.query(self.info.id, query, expects=ReportDigitalAudioSensorCapabilities)
        assert isinstance(report, ReportDigitalAudioSensorCapabilities)
        known = [item.sensor_id_rec.sensor_id for item in report.audio_sensor_capability_list]
        if self.number not in known:
            listed = ", ".join(map(str, known)) or "none"
            raise ConfigError(f"{self.info.id} has no microphone {self.number}; it has: {listed}")

    async def _renew(self, url: str) -> None:
        while True:
            await asyncio.sleep(RENEWAL_INTERVAL)
            with suppress(RequestError):  # repeated in a minute; the endpoint lasts for five
                await self._register(url)


class Announcer:
    """A loudspeaker of a robot; by default the first one of its component."""

    def __init__(self, connection: Connection, info: ComponentInfo, number: int | None = None) -> None:
        self.info: ComponentInfo = info
        """The component that plays."""
        self.number: int | None = number
        """Number of the loudspeaker there; None is the first one."""
        self._connection = connection

    def __repr__(self) -> str:
        return f"<announcer {self.number or ''} of {self.info.id}>"

    async def play(self, path: str | Path, *, authority: int = DEFAULT_AUTHORITY) -> float:
        """Play a WAV file at the robot, in real time; returns its length in seconds.

        Takes control of the component meanwhile. Raises `ConfigError` for a file that cannot be read, and
        `RequestError` when the robot does not play. If the call is cancelled, the robot stops playing.
        """
        need_audio()
        from jauspy.audio.coding import FRAME, FRAME_TIME  # noqa: PLC0415 - needs NumPy
        from jauspy.audio.sender import AudioSender  # noqa: PLC0415
        from jauspy.audio.wav_files import padded, read_wav  # noqa: PLC0415

        sound = await asyncio.to_thread(read_wav, Path(path))
        frames = padded(sound, LEAD)
        info = self.info.find(ANNOUNCER)
        if info is None:
            raise ConfigError(f"{self.info.id} plays nothing: it does not offer {ANNOUNCER}")
        service = ServiceClient(self._connection, self.info.id, info)
        loop = asyncio.get_running_loop()
        async with service.control(authority) as control:
            await service.resume()
            number, address = await self._endpoint()
            await self._command(number, _Command.STREAM_START, _Status.STREAMING)
            try:
                with AudioSender("jauspy") as sender:
                    sender.add(address)
                    due = loop.time()
                    for begin in range(0, len(frames), FRAME):
                        control.check()
                        sender.send(frames[begin : begin + FRAME], loop.time(), time.time())
                        due += FRAME_TIME
                        await asyncio.sleep(max(0.0, due - loop.time()))
            finally:
                with suppress(RequestError, TransportError):  # it stops when control ends, in any case
                    await self._command(number, _Command.STREAM_STOP, _Status.STOPPED)
        return len(sound) / (FRAME / FRAME_TIME)

    async def _endpoint(self) -> tuple[int, tuple[str, int]]:
        """Number of the loudspeaker, and where it takes sound."""
        for _ in range(PORT_RETRIES):
            report = await self._connection.query(
                self.info.id, QueryAnnunciatorEndpoint(self.number or 0), expects=ReportAnnunciatorEndpoint
            )
            assert isinstance(report, ReportAnnunciatorEndpoint)
            if not report.annunciator_endpoint_list:
                raise ConfigError(f"{self.info.id} has no loudspeaker {self.number or ''}".rstrip())
            first = report.annunciator_endpoint_list[0]
            if first.endpoint_rec.port:
                host = str(IPv4Address(first.endpoint_rec.ip_addr))
                return first.annunciator_id_rec.annunciator_id, (host, first.endpoint_rec.port)
        raise RequestError(
            f"{self.info.id} opens no port for sound: is the extra 'video' on the robot, and is this machine known?"
        )

    async def _command(self, number: int, command: _Command, wanted: _Status) -> None:
        kind = ControlAnnunciatorStream
        answer = await self._connection.query(
            self.info.id,
            kind(kind.AnnunciatorIdRec(number), kind.StreamControlRec(command)),
            expects=ConfirmAnnunciatorStream,
        )
        assert isinstance(answer, ConfirmAnnunciatorStream)
        if answer.annunciator_stream_status.stream_status != wanted:
            raise RequestError(f"{self.info.id} does not play: its loudspeaker {number} did not change its state")
