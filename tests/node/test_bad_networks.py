"""Two to five hosts, each a network namespace with a node manager, on a switch that loses, delays and doubles."""

import contextlib
import itertools
import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.node.hosts.switch import PROGRAMS, Switch, started


def converse(hosts: list[str], root: Path, count: int, **settings: Any) -> list[dict[str, Any]]:
    """Each host sends to each other; what each tells of it."""
    ids = [f"{101 + number}.1.1" for number in range(len(hosts))]
    with contextlib.ExitStack() as stack:
        members = []
        for host, id in zip(hosts, ids, strict=True):
            others = [each for each in ids if each != id]
            reported = {"root": str(root / id), "id": id, "others": others, "count": count, "settings": settings}
            member = stack.enter_context(started(host, str(PROGRAMS / "member.py"), json.dumps(reported)))
            members.append((member.stdin, member.stdout))
        for word, answer in (("go", "sent"), ("stop", None)):
            for writer, _ in members:
                assert writer is not None
                writer.write(f"{word}\n")
                writer.flush()
            lines = [reader.readline().strip() for _, reader in members if reader is not None]
            assert answer is None or lines == [answer] * len(members)
        return [json.loads(each) for each in lines]


@pytest.mark.slow
@pytest.mark.parametrize("how", ["netem", "relay"])
@pytest.mark.parametrize("count", [2, pytest.param(5, marks=pytest.mark.slow)])
def test_acknowledged_messages_arrive_once_each(
    switch: Callable[[int], Switch], root: Path, how: str, count: int
) -> None:
    """One tenth of the packets is lost; a fifth of the messages is large, in five packets of three frames each."""
    made = switch(count)
    getattr(made, how)()
    reported = converse(made.hosts, root, 40 // count)
    delivered = {text for each in reported for text, arrived in each["sent"].items() if arrived}
    received = Counter(itertools.chain.from_iterable(each["received"] for each in reported))
    assert max(received.values()) == 1
    assert delivered <= set(received)
    assert len(delivered) == count * (count - 1) * (40 // count)
    counted = sum((Counter(each["counters"]) for each in reported), Counter())
    assert min(counted["resent"], counted["dropped.duplicate"]) > 0


@pytest.mark.slow
def test_compressed_headers_survive_a_bad_network(switch: Callable[[int], Switch], root: Path) -> None:
    made = switch(2)
    made.relay()
    reported = converse(made.hosts, root, 60, header_compression="propose")
    received = Counter(itertools.chain.from_iterable(each["received"] for each in reported))
    assert received == Counter(text for each in reported for text in each["sent"])
    assert sum(each["counters"].get("compression.received", 0) for each in reported) > 10
