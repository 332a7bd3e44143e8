"""Workers of microphones and loudspeakers as processes: what they do after one of them has died."""

from __future__ import annotations

import asyncio
import os
import signal
import socket

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

from tests.audio.signals import joined, level, packets, tone
from tests.helpers.robot import described

from jauspy.audio.device_processes import MAX_LISTENERS, MAX_PENDING_PORTS, LoudspeakerProcess, MicrophoneProcess
from jauspy.audio.receiver import AudioReceiver
from jauspy.errors import ConfigError
from jauspy.platform.sound import LoudspeakerSetup
from jauspy.platform.sound_scene import MachineState, SoundScene

LIMIT = 60.0


@pytest.fixture
def microphone():
    _, model = described("inc1")
    scene = SoundScene.of(model, model.microphones[0])
    return MicrophoneProcess(scene, lambda: MachineState(left=0.7, right=0.7))


async def heard(receiver, frames):
    sounds = []
    async with asyncio.timeout(LIMIT):
        while len(sounds) < frames:
            sounds += receiver.take()
            await asyncio.sleep(0.01)
    return joined(sounds)


@pytest.mark.slow
async def test_microphone_goes_on_after_its_worker_died(microphone):
    async with microphone:
        with AudioReceiver() as receiver:
            microphone.watch(("127.0.0.1", receiver.port))
            await heard(receiver, 20)
            before = microphone.pid
            os.kill(before, signal.SIGKILL)
            receiver.end()
            async with asyncio.timeout(LIMIT):
                while microphone.pid in (before, None):
                    receiver.take()
                    await asyncio.sleep(0.01)
            receiver.end()
            assert level((await heard(receiver, 60))[-9600:]) > -40.0, "the new one knows the state of the machine"
            assert microphone.counters["started"] == 2


async def test_microphone_has_few_listeners(microphone):
    for number in range(MAX_LISTENERS):
        microphone.watch(("127.0.0.1", 5000 + 2 * number))
    with pytest.raises(ConfigError, match="8 listeners hear this microphone already"):
        microphone.watch(("127.0.0.1", 6000))
    microphone.leave(("127.0.0.1", 5000))
    microphone.watch(("127.0.0.1", 6000))
    assert microphone.pid is None, "nothing starts before it is open"


async def port_of(loudspeaker):
    found = asyncio.get_running_loop().create_future()
    loudspeaker.listen("127.0.0.1", found.set_result)
    async with asyncio.timeout(LIMIT):
        return await found


@pytest.mark.slow
async def test_loudspeaker_keeps_its_port_and_source_after_its_worker_died():
    played = []
    async with LoudspeakerProcess(LoudspeakerSetup("announcer", "base_link"), played.append) as loudspeaker:
        address = await port_of(loudspeaker)
        assert address is not None
        loudspeaker.play(frozenset({"127.0.0.1"}))
        before = loudspeaker.pid
        os.kill(before, signal.SIGKILL)
        async with asyncio.timeout(LIMIT):
            while loudspeaker.pid in (before, None):
                await asyncio.sleep(0.01)
        assert await port_of(loudspeaker) == address
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            async with asyncio.timeout(LIMIT):
                for packet in packets(tone(600.0, 30.0)):
                    sender.sendto(packet.encode(), address)
                    await asyncio.sleep(0.01)
                    if len(played) >= 5:
                        break
        assert len(played) >= 5


async def test_clients_that_wait_for_a_port_are_few_and_are_answered_at_the_end():
    answers = []
    loudspeaker = LoudspeakerProcess(LoudspeakerSetup("announcer", "base_link"), lambda _: None)
    for _ in range(MAX_PENDING_PORTS):
        loudspeaker.listen("127.0.0.1", answers.append)
    with pytest.raises(ConfigError, match="16 clients wait for the port"):
        loudspeaker.listen("127.0.0.1", answers.append)
    await loudspeaker.close()
    assert answers == [None] * MAX_PENDING_PORTS


async def test_loudspeaker_without_a_route_to_the_client_says_so(monkeypatch):
    monkeypatch.setattr("jauspy.audio.device_processes.address_towards", lambda _: None)
    loudspeaker = LoudspeakerProcess(LoudspeakerSetup("announcer", "base_link"), lambda _: None)
    with pytest.raises(ConfigError, match=r"no route to 192\.0\.2\.1"):
        loudspeaker.listen("192.0.2.1", lambda _: None)
