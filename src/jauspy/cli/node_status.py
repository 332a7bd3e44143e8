"""How the status of a node manager looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from jauspy.cli import console


def show(status: Mapping[str, Any]) -> None:
    """Print everything, in short lines under headings."""
    out = console.stdout().print
    out(f"node manager, process {status['pid']}, up {_duration(status['uptime'])}, sockets in {status['local_root']}")
    _table("networks", map(_network, status["networks"]))
    _table("components", ((each["id"], each["path"], f"{each['waiting']} waiting") for each in status["components"]))
    _table("peers", map(_peer, status["peers"]))
    _table("queues", ((name, str(count)) for name, count in status["queues"].items()))
    counters = status["counters"]
    dropped = {name: count for name, count in counters.items() if name.startswith("dropped.")}
    _table("counted", _counts({name: n for name, n in counters.items() if name not in dropped}, status["rates"]))
    _table("dropped", _counts(dropped, status["rates"]))


def _network(network: Mapping[str, Any]) -> tuple[str, ...]:
    buffer = network["receive_buffer"]
    notes = [word for word in ("inside", "authenticated") if network[word]]
    kernel = f"{buffer['bytes']} of {buffer['limit']} bytes buffered, {buffer['dropped']} dropped by the kernel"
    return network["name"], network["address"], f"group {network['multicast_group']}", ", ".join([*notes, kernel])


def _peer(peer: Mapping[str, Any]) -> tuple[str, ...]:
    heard = "from the address book" if peer["heard"] is None else f"heard {_duration(peer['heard'])} ago"
    return peer["id"], peer["address"], peer["network"], heard


def _counts(counters: Mapping[str, int], rates: Mapping[str, float]) -> Iterable[tuple[str, ...]]:
    for name, count in counters.items():
        yield name.removeprefix("dropped."), str(count), f"{rates.get(name, 0.0):.0f}/s"


def _table(title: str, rows: Iterable[tuple[str, ...]]) -> None:
    cells = list(rows)
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    console.stdout().print(f"{title}:" if cells else f"{title}: none", markup=False)
    for row in cells:
        line = "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        console.stdout().print(f"  {line.rstrip()}", markup=False)


def _duration(seconds: float) -> str:
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {rest} s" if minutes else f"{seconds:.1f} s"
