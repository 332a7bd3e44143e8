"""Microphones and loudspeakers in worker processes, which start at first use and are restarted when they die."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Sequence
from typing import Final

from jauspy.audio import need_audio
from jauspy.audio.worker_messages import (
    AddListener,
    ChangeAudio,
    MachineMoved,
    OpenPort,
    PlaySource,
    PortOpened,
    RemoveListener,
    SoundPlayed,
    StartLoudspeaker,
    StartMicrophone,
)
from jauspy.errors import ConfigError
from jauspy.logs import get_logger
from jauspy.platform.sound import Address, AudioSettings, Coding, LoudspeakerSetup, MicrophoneSetup
from jauspy.platform.sound_scene import MachineState, SoundScene
from jauspy.transport.multicast import address_towards
from jauspy.worker_process import SupervisedWorker

_LOG: Final = get_logger("jauspy.audio")

NICENESS: Final = 5
"""Niceness above that of the robot's process: sound needs little, but in time."""
MAX_LISTENERS: Final = 8
STATE_PERIOD: Final = 0.04
"""Seconds between two states of the machine that a microphone hears."""
MAX_PENDING_PORTS: Final = 16
"""Clients that may wait for the port of a loudspeaker."""


class MicrophoneProcess(SupervisedWorker):
    """A microphone. Listeners and settings survive a restart of the worker. `state`: what moves on the robot now."""

    def __init__(self, scene: SoundScene, state: Callable[[], MachineState]) -> None:
        super().__init__("jauspy.audio.microphone_worker", NICENESS, f"microphone {scene.microphone.name}", _LOG)
        self._scene, self._state = scene, state
        self._settings = AudioSettings()
        self._listeners: dict[Address, AddListener] = {}
        self._is_open = False
        self._timer: asyncio.TimerHandle | None = None

    @property
    def setup(self) -> MicrophoneSetup:
        """Name and link."""
        return self._scene.microphone

    @property
    def settings(self) -> AudioSettings:
        """Bit rate and gain."""
        return self._settings

    @settings.setter
    def settings(self, settings: AudioSettings) -> None:
        self._settings = settings
        self._send(ChangeAudio(settings))

    @property
    def listeners(self) -> Sequence[Address]:
        """Addresses that the sound is sent to."""
        return tuple(address for address, listener in self._listeners.items() if listener.playing)

    def watch(self, address: Address, *, playing: bool = True, coding: Coding = Coding.OPUS) -> None:
        """Send to this address, or pause sending.

        Raises `ConfigError` without the packages for sound, or for one listener too many.
        """
        if address not in self._listeners and len(self._listeners) >= MAX_LISTENERS:
            raise ConfigError(f"{MAX_LISTENERS} listeners hear this microphone already; one must leave first")
        if self._is_open:
            need_audio()
            self._supervise()
        self._listeners[address] = listener = AddListener(address, playing, coding)
        self._send(listener)
        self._tell_state()

    def leave(self, address: Address) -> None:
        """Stop sending to this address; without effect for an unknown one."""
        if self._listeners.pop(address, None) is not None:
            self._send(RemoveListener(address))

    def hear(self, played: SoundPlayed) -> None:
        """A loudspeaker of the robot plays this."""
        if self.listeners:
            self._send(played)

    async def open(self) -> None:
        """Allow the worker to start when somebody listens; without effect when open."""
        self._is_open = True

    async def close(self) -> None:
        """Stop the worker; without effect when closed."""
        self._is_open = False
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        await super().close()

    @property
    def _descriptors(self) -> Sequence[int]:
        return ()

    def _on_started(self) -> None:
        self._send(StartMicrophone(self._scene, self._settings))
        for listener in self._listeners.values():
            self._send(listener)
        self._tell_state()

    def _tell_state(self) -> None:
        """Send the state of the machine now, and again while somebody listens."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if self._is_open and self.listeners and self.pid is not None:
            self._send(MachineMoved(self._state()))
            self._timer = asyncio.get_running_loop().call_later(STATE_PERIOD, self._tell_state)


class LoudspeakerProcess(SupervisedWorker):
    """A loudspeaker; `on_played` is called with what it plays. Settings and source survive a restart of the worker."""

    def __init__(self, setup: LoudspeakerSetup, on_played: Callable[[SoundPlayed], None]) -> None:
        super().__init__("jauspy.audio.loudspeaker_worker", NICENESS, f"loudspeaker {setup.name}", _LOG)
        self._setup, self._on_played = setup, on_played
        self._settings = AudioSettings()
        self._source = PlaySource(frozenset())
        self._address: Address | None = None
        """Where it receives, for the worker after this one: clients go on sending there."""
        self._waiting: deque[tuple[str, Callable[[Address | None], None]]] = deque()
        self._is_open = False

    @property
    def setup(self) -> LoudspeakerSetup:
        """Name, link and level."""
        return self._setup

    @property
    def settings(self) -> AudioSettings:
        """Bit rate that senders are to use, and volume."""
        return self._settings

    @settings.setter
    def settings(self, settings: AudioSettings) -> None:
        self._settings = settings
        self._send(ChangeAudio(settings))

    def listen(self, client: str, then: Callable[[Address | None], None]) -> None:
        """Open a port at the address of this machine that the client reaches; pass it to `then`, None if that fails.

        Raises `ConfigError` without the packages for sound, without a route to the client, or when too many wait.
        """
        host = address_towards(client)
        if host is None:
            raise ConfigError(f"there is no route to {client}")
        if len(self._waiting) >= MAX_PENDING_PORTS:
            raise ConfigError(f"{MAX_PENDING_PORTS} clients wait for the port of this loudspeaker already")
        if self._is_open:
            need_audio()
            self._supervise()
        self._waiting.append((host, then))
        self._send(OpenPort(host))

    def play(self, hosts: frozenset[str], port: int | None = None) -> None:
        """Play what arrives from these addresses, and that port if one is given."""
        self._source = PlaySource(hosts, port)
        self._send(self._source)

    def stop(self) -> None:
        """Play nothing, and end the recording."""
        self.play(frozenset())

    async def open(self) -> None:
        """Allow the worker to start when a port is needed; without effect when open."""
        self._is_open = True

    async def close(self) -> None:
        """Stop the worker; without effect when closed."""
        self._is_open = False
        await super().close()
        self._answer_all()

    @property
    def _descriptors(self) -> Sequence[int]:
        return ()

    def _on_started(self) -> None:
        self._send(StartLoudspeaker(self._setup, self._settings))
        hosts = dict.fromkeys(host for host, _ in self._waiting)
        if self._address is not None:
            self._send(OpenPort(*self._address))
        for host in hosts:
            self._send(OpenPort(host))
        self._send(self._source)

    def _on_message(self, message: object) -> None:
        match message:
            case PortOpened(host, port):
                self._address = (host, port) if port else None
                self._answer(host, self._address)
            case SoundPlayed():
                self._on_played(message)
            case _:
                super()._on_message(message)

    def _on_ended(self) -> None:
        self._answer_all()

    def _answer(self, host: str, address: Address | None) -> None:
        """Answer those who wait for a port at this address."""
        ready = [then for wanted, then in self._waiting if wanted == host]
        self._waiting = deque(item for item in self._waiting if item[0] != host)
        for then in ready:
            then(address)

    def _answer_all(self) -> None:
        while self._waiting:
            self._waiting.popleft()[1](None)
