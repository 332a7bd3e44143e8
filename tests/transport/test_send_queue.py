"""The bounded queue of one destination."""

import logging

import pytest

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet, Priority
from jauspy.transport import send_queue as outbox_module
from jauspy.transport.send_queue import MAX_QUEUED_BYTES, QueueMemory, SendQueue

A = JausID.parse("101.1.1")


def datagram(priority: Priority, sequence: int) -> bytes:
    return judp.pack(Packet(A, A, b"\x02\x20", sequence, priority))


def drained(outbox: SendQueue) -> list[bytes]:
    out = []
    while len(outbox):
        out.append(outbox.peek())
        outbox.pop()
    return out


def test_most_urgent_datagrams_are_sent_first_in_order() -> None:
    outbox = SendQueue()
    sent = [datagram(p, n) for n in range(2) for p in Priority]
    for data in (*sent, junior.accept(A)):
        assert not outbox.push(data)
    assert drained(outbox) == [sent[3], sent[7], junior.accept(A), sent[2], sent[6], sent[1], sent[5], sent[0], sent[4]]


def test_oldest_of_the_lowest_priority_is_dropped() -> None:
    outbox = SendQueue(limit=3)
    low, high = [datagram(Priority.LOW, n) for n in range(3)], datagram(Priority.HIGH, 9)
    assert [list(outbox.push(data)) for data in (*low, high)] == [[], [], [], low[:1]]
    assert drained(outbox) == [high, low[1], low[2]]
    for data in [high] * 3:
        outbox.push(data)
    assert len(outbox.push(low[0])) == 1
    assert drained(outbox) == [high] * 3


def test_bytes_are_bounded_too() -> None:
    outbox = SendQueue()
    large = [judp.pack(Packet(A, A, bytes(60000), n)) for n in range(100)]
    dropped = sum(len(outbox.push(data)) for data in large)
    assert dropped == 100 - MAX_QUEUED_BYTES // len(large[0])
    assert drained(outbox) == large[dropped:]


def test_control_messages_are_queued_as_most_urgent() -> None:
    outbox = SendQueue()
    for data in (b"", b"\x02", b"\x02\x40"):
        outbox.push(data)
    assert len(drained(outbox)) == 3


@pytest.mark.parametrize("way", ["one by one", "at once"])
def test_least_urgent_datagrams_have_a_share(way: str) -> None:
    """Though there is always something more urgent."""
    outbox, sent = SendQueue(), []
    low = [datagram(Priority.LOW, n) for n in range(10)]
    for data in low:
        outbox.push(data)
    for number in range(20 * outbox_module.LOW_PRIORITY_TURN):
        outbox.push(datagram(Priority.SAFETY_CRITICAL, number))
        if way == "at once":
            outbox.drain(sent.append, 1)
        else:
            sent.append(outbox.peek())
            outbox.pop()
    assert [data for data in sent if data in low] == low
    urgent = [judp.unpack(data)[0].sequence for data in sent if data not in low]
    assert urgent == list(range(len(urgent)))
    assert sent.index(low[9]) == 10 * outbox_module.LOW_PRIORITY_TURN - 1


def test_several_queues_share_a_memory_and_the_longest_loses_first() -> None:
    counters = Counters(logging.getLogger())
    memory = QueueMemory(10_000, counters)
    greedy, modest = SendQueue(memory=memory), SendQueue(memory=memory)
    small = judp.pack(Packet(A, A, bytes(100), 1))
    assert not modest.push(small)
    for number in range(100):
        greedy.push(judp.pack(Packet(A, A, bytes(1000), number)))
        assert memory.bytes <= 10_000
    assert greedy.bytes + modest.bytes == memory.bytes
    kept = [judp.unpack(data)[0].sequence for data in drained(greedy)]
    assert kept == list(range(100 - len(kept), 100))
    assert counters["dropped.queue_memory"] == 100 - len(kept)
    assert drained(modest) == [small]
    assert memory.bytes == 0


def test_a_short_queue_takes_room_from_a_long_one() -> None:
    memory = QueueMemory(10_000, Counters(logging.getLogger()))
    greedy, modest = SendQueue(memory=memory), SendQueue(memory=memory)
    for number in range(100):
        greedy.push(judp.pack(Packet(A, A, bytes(1000), number)))
    before = len(greedy)
    for number in range(3):
        modest.push(judp.pack(Packet(A, A, bytes(1000), number)))
    assert (len(modest), len(greedy)) == (3, before - 3)
    assert greedy.clear() == before - 3
    assert memory.bytes == modest.bytes


def test_one_datagram_may_take_the_room_of_many() -> None:
    memory = QueueMemory(100_000, Counters(logging.getLogger()))
    queue, other = SendQueue(memory=memory), SendQueue(memory=memory)
    for number in range(500):
        queue.push(datagram(Priority.LOW, number))
    other.push(judp.pack(Packet(A, A, bytes(40_000), 1)))
    assert (len(other), memory.bytes <= 100_000) == (1, True)


def test_a_source_that_floods_a_queue_loses_its_own() -> None:
    outbox, operator = SendQueue(limit=100), JausID(42, 1, 1)
    wanted = judp.pack(Packet(operator, A, b"\x02\x00", 1))
    for number in range(100):
        outbox.push(datagram(Priority.STANDARD, number))
    outbox.push(wanted)
    dropped = sum(len(outbox.push(datagram(Priority.STANDARD, number))) for number in range(1000))
    assert dropped == 1000
    assert wanted in drained(outbox)


def test_a_flood_of_urgent_packets_leaves_others_their_share() -> None:
    outbox, operator = SendQueue(limit=100), JausID(42, 1, 1)
    wanted = [judp.pack(Packet(operator, A, b"\x02\x00", number)) for number in range(12)]
    for each in wanted:
        outbox.push(each)
    for number in range(1000):
        outbox.push(datagram(Priority.SAFETY_CRITICAL, number))
    assert len(outbox) == 100
    assert [each for each in drained(outbox) if each in wanted] == wanted


def test_senders_take_turns_and_each_keeps_its_order() -> None:
    outbox = SendQueue(limit=100)
    flood = [datagram(Priority.STANDARD, number) for number in range(90)]
    other = [judp.pack(Packet(JausID(42, 1, 1), A, b"\x02\x00", number)) for number in range(3)]
    for each in (*flood, *other):
        outbox.push(each)
    sent = drained(outbox)
    assert [each for each in sent if each in other] == other
    assert [each for each in sent if each not in other] == flood
    assert sent.index(other[2]) == 5


def test_of_many_senders_those_with_most_lose() -> None:
    outbox = SendQueue(limit=100)
    modest = [judp.pack(Packet(JausID(42, 1, 1 + n), A, b"\x02\x00", n)) for n in range(60)]
    for number, each in enumerate(modest):
        outbox.push(datagram(Priority.STANDARD, 2 * number))
        outbox.push(each)
        outbox.push(datagram(Priority.STANDARD, 2 * number + 1))
    assert [each for each in drained(outbox) if each in modest] == modest


def test_what_a_sender_sends_to_all_and_to_one_stays_in_order() -> None:
    outbox = SendQueue()
    everyone, other = JausID.parse("255.255.255"), JausID.parse("101.1.2")
    sent = [
        judp.pack(Packet(A, each, b"\x02\x20", n)) for n, each in enumerate((everyone, everyone, other, A, everyone))
    ]
    for data in sent:
        outbox.push(data)
    assert drained(outbox) == sent


def test_answers_to_many_questions_of_one_do_not_displace_those_to_others() -> None:
    outbox = SendQueue(limit=64)
    flooder, operator = JausID.parse("43.1.1"), JausID.parse("42.1.1")
    answers = [judp.pack(Packet(A, operator, b"\x02\x40", n)) for n in range(20)]
    for number, answer in enumerate(answers):
        outbox.push(answer)
        for n in range(100):
            outbox.push(judp.pack(Packet(A, flooder, b"\x02\x40", 1000 + 100 * number + n)))
    left = drained(outbox)
    assert len(left) == 64
    assert [each for each in left if each in answers] == answers
    assert left[-1] == judp.pack(Packet(A, flooder, b"\x02\x40", 2999)), "of the others, the newest are left"
