"""Publishing and subscribing, with subscribers that see all, miss some, or get rubbish."""

from __future__ import annotations

import struct
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

pytest.importorskip("pynng", reason="pynng is not installed")

import pynng

from jauspy.cloud import stream
from jauspy.cloud.stream import Cloud, CloudPublisher, CloudSubscriber
from jauspy.errors import ConfigError, TransportError

POINT = struct.pack("<3f", 1.0, 2.0, 3.0)
TIMEOUT = 20.0


@pytest.fixture
def address(tmp_path: Path) -> str:
    return f"ipc://{tmp_path}/c"


@pytest.fixture
def subscriber(address: str) -> Iterator[CloudSubscriber]:
    with CloudSubscriber(address) as opened:
        yield opened


def until_heard(publish: Callable[[], None], subscriber: CloudSubscriber) -> Cloud:
    """Publish until the subscriber, which connects in its own time, gets something."""
    until = time.monotonic() + TIMEOUT
    while time.monotonic() < until:
        publish()
        if (cloud := subscriber.receive(0.05)) is not None:
            return cloud
    pytest.fail("nothing ever arrived")


def test_clouds_arrive_in_order_with_their_numbers(address: str, subscriber: CloudSubscriber) -> None:
    with CloudPublisher(address) as publisher:
        last = until_heard(lambda: publisher.publish(POINT, "lidar_link", 5.0), subscriber)
        while subscriber.receive(0.3) is not None:
            pass
        before = subscriber.counters["received"]
        for _ in range(5):
            publisher.publish(POINT * 2, "other", 6.0)
        found = [subscriber.receive(TIMEOUT) for _ in range(5)]
    assert last.rows() == [(1.0, 2.0, 3.0)]
    assert [(len(each), each.frame, each.time) for each in found if each] == [(2, "other", 6.0)] * 5
    assert [each.number - found[0].number for each in found if each and found[0]] == [0, 1, 2, 3, 4]
    assert subscriber.counters == {"received": before + 5, "lost": 0}


def test_slow_subscriber_counts_lost_clouds(address: str, subscriber: CloudSubscriber) -> None:
    with CloudPublisher(address) as publisher:
        first = until_heard(lambda: publisher.publish(POINT, "a", 0.0), subscriber)
        big = POINT * 100_000
        for _ in range(200):
            publisher.publish(big, "a", 0.0)
        found = [first]
        while (cloud := subscriber.receive(1.0)) is not None:
            found.append(cloud)
        publisher.publish(POINT, "a", 0.0)
        while found[-1].number < first.number + 201:
            found.append(cloud := subscriber.receive(TIMEOUT))
            assert cloud is not None
    assert len(found) < 150, "it was to lose some"
    assert subscriber.counters["lost"] == found[-1].number - first.number - (len(found) - 1)


def test_malformed_messages_are_counted_and_skipped(address: str, subscriber: CloudSubscriber) -> None:
    with pynng.Pub0(listen=address) as rubbish:
        good = Cloud(POINT, "a", 0.0).encode()

        def publish() -> None:
            rubbish.send(b"rubbish")
            rubbish.send(good)

        assert until_heard(publish, subscriber).frame == "a"
        assert subscriber.counters["malformed"] >= 1


def test_restart_of_the_publisher_is_no_loss(address: str, subscriber: CloudSubscriber) -> None:
    for _ in range(2):
        with CloudPublisher(address) as publisher:
            until_heard(lambda publisher=publisher: publisher.publish(POINT, "a", 0.0), subscriber)  # type: ignore[misc]
    assert subscriber.counters["restarts"] == 1


def test_invalid_addresses_are_rejected(address: str) -> None:
    with CloudPublisher(address), pytest.raises(TransportError, match="cannot publish there"):
        CloudPublisher(address)
    with pytest.raises(TransportError, match="cannot publish there"):
        CloudPublisher("nonsense")
    with pytest.raises(ConfigError, match="no address to subscribe to"):
        CloudSubscriber("nonsense")


def test_missing_pynng_error_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(stream.importlib, "import_module", missing)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[cloud\]'"):
        CloudPublisher("tcp://127.0.0.1:1")


def test_a_stream_of_rubbish_does_not_keep_it_from_returning(address: str, subscriber: CloudSubscriber) -> None:
    """Nor do empty messages, which pynng cannot hand on."""
    with pynng.Pub0(listen=address, send_buffer_size=8) as rubbish:
        until_heard(lambda: rubbish.send(Cloud(POINT, "a", 0.0).encode()), subscriber)
        stop = threading.Event()

        def flood() -> None:
            while not stop.is_set():
                rubbish.send(b"rubbish")
                rubbish.send(b"")

        thread = threading.Thread(target=flood)
        thread.start()
        begin = time.monotonic()
        try:
            while subscriber.receive(0.1) is not None:
                pass
        finally:
            took = time.monotonic() - begin
            stop.set()
            thread.join()
    assert took < TIMEOUT / 4
    assert subscriber.counters["malformed"] > 1
