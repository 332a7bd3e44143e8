"""What the screen shows, as texts of rich: names from peers are printable and never markup."""

from __future__ import annotations

import time
from itertools import islice
from typing import Final

from rich.text import Text

from jauspy.cli.render import styled_fields
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.inspection.observed import Control, Observed, ObservedComponent, State, Stream, within
from jauspy.inspection.peers import PeerRecogniser
from jauspy.inspection.rates import Route
from jauspy.inspection.series import Series, curve
from jauspy.inspection.traffic import SeenMessage
from jauspy.printable import printable

BLUE, GREEN, YELLOW, RED, PURPLE = "#7aa2f7", "#9ece6a", "#e0af68", "#f7768e", "#bb9af7"
BAR, FAINT = "#3d59a1", "#737aa2"
STATE_STYLES: Final = {
    "READY": GREEN,
    "STANDBY": YELLOW,
    "INITIALIZE": BLUE,
    "SHUTDOWN": FAINT,
    "FAILURE": f"bold {RED}",
    "EMERGENCY": f"bold {RED}",
}
STYLES: Final = {"cyan": BLUE, "dim": FAINT}
"""Styles of fields on other terminals, in the colours of this screen."""
UNKNOWN: Final = ("unknown", FAINT)
BARS: Final = " ▁▂▃▄▅▆▇█"
SILENT_SECONDS: Final = 10.0
"""A component that has not sent for so long is dimmed in the tree."""
MAX_LINES: Final = 2000
"""Lines of a message that are shown."""
MAX_DUMP: Final = 4096
"""Bytes of a message that are shown."""


def age(seconds: float) -> str:
    """A short time: 0.3 s, 12 s, 4 min, 2 h, 3 d."""
    seconds = max(0.0, seconds)
    if seconds < 10.0:
        return f"{seconds:.1f} s"
    for limit, unit, name in ((120.0, 1.0, "s"), (7200.0, 60.0, "min"), (172_800.0, 3600.0, "h")):
        if seconds < limit:
            return f"{seconds / unit:.0f} {name}"
    return f"{seconds / 86400.0:.0f} d"


def amount(number: float) -> str:
    """A count in at most five characters: 999, 12.3k, 4.5M."""
    for limit, unit, suffix in ((10_000, 1, ""), (1e6, 1e3, "k"), (1e9, 1e6, "M"), (1e12, 1e9, "G")):
        if number < limit:
            return f"{number / unit:.1f}{suffix}" if suffix else f"{number:.0f}"
    return ">999G"


def rate(value: float) -> str:
    """Messages a second."""
    return "·" if value == 0.0 else f"{value:.1f}" if value < 100.0 else amount(value)


def clock(seconds: float) -> str:
    """The time of day with tenths of a second, in local time."""
    try:
        return f"{time.strftime('%H:%M:%S', time.localtime(seconds))}.{int(seconds % 1.0 * 10.0)}"
    except (OverflowError, ValueError, OSError):  # a capture may have any time
        return f"{seconds:.1f}"


def bars(counts: list[int]) -> str:
    """A bar for each count."""
    top = max(counts, default=0)
    return "".join(BARS[0 if not count else max(1, round(count / top * 8))] for count in counts)


def subsystem_label(number: int, observed: Observed) -> Text:
    """A subsystem in the tree."""
    return Text.assemble((str(number), "bold"), " ", printable(observed.names.get((number, None), "")))


def node_label(subsystem: int, node: int, observed: Observed) -> Text:
    """A node in the tree."""
    return Text.assemble((f"node {node}", FAINT), " ", (printable(observed.names.get((subsystem, node), "")), FAINT))


def component_label(component: ObservedComponent, now: float) -> Text:
    """A component in the tree: its state, name and controller."""
    silent = component.heard is None or now - component.heard > SILENT_SECONDS
    state = component.state
    dot = ("○", FAINT) if state is None else ("●", STATE_STYLES.get(state.name, FAINT))
    text = Text.assemble(
        dot, " ", (str(component.id.component), FAINT if silent else "bold"), " ",
        (printable(component.name or ""), FAINT if silent else ""),
    )  # fmt: skip
    if component.control is not None and component.control.controller is not None:
        text.append(f" ◂ {component.control.controller}", PURPLE)
    return text


def about_component(
    component: ObservedComponent, observed: Observed, peers: PeerRecogniser, now: float, width: int
) -> Text:
    """Four lines about a component, and one for its implementation if it is a known one."""
    name = ("name unknown", FAINT) if component.name is None else (printable(component.name), "bold")
    text = Text.assemble((f"{component.id} ", f"bold {BLUE}"), name)
    if component.type is not None:
        text.append(f"  {component.type.lower()}", FAINT)
    if component.authority is not None:
        text.append(f"  authority {component.authority}", FAINT)
    text.append("\nstate ", FAINT)
    _append_state(text, component.state, now)
    text.append("  control ", FAINT)
    _append_control(text, component.control, now)
    text.append("\nsent ", FAINT)
    text.append(f"{amount(component.sent)}  {rate(component.history.rate(now))}/s  ")
    text.append(bars(component.history.counts(now)[-20:]), BAR)
    text.append("  last ", FAINT)
    text.append("never" if component.heard is None else age(now - component.heard))
    sequence = component.sequence
    for what, count in (("missing", sequence.missing), ("resent", sequence.resent), ("restarts", sequence.restarts)):
        if count:
            text.append(f"  {what} ", FAINT)
            text.append(amount(count), YELLOW)
    client_of = observed.controlled_by(component.id)
    if client_of:
        text.append("\ncontrols ", FAINT)
        text.append(", ".join(map(str, client_of)), PURPLE)
    _append_kinds(text, {component.host}, peers)
    text.append("\nservices ", FAINT)
    if component.services is None:
        text.append(*UNKNOWN)
    else:
        text.append(printable(", ".join(map(short_service, component.services))) or "none")
    return _cut(text, width)


def _append_kinds(text: Text, hosts: set[str], peers: PeerRecogniser) -> None:
    """A line for each known implementation at these addresses, with the sign by which it was recognised."""
    for host in sorted(hosts):
        for kind, sign in peers.kinds_of(host):
            text.append(f"\n{printable(host)} ", FAINT)
            text.append(f"looks like {kind.name.upper()}", YELLOW)
            text.append(f": {printable(sign)}", FAINT)


def about_group(scope: str, observed: Observed, peers: PeerRecogniser, now: float, width: int) -> Text:
    """Lines about a subsystem or node."""
    inside = [component for id, component in observed.components.items() if within(str(id), scope)]
    subsystem, _, node = scope.partition(".")
    name = observed.names.get((int(subsystem), int(node) if node else None))
    text = Text.assemble(
        (f"{'node' if node else 'subsystem'} {scope} ", f"bold {BLUE}"),
        ("name unknown", FAINT) if name is None else (printable(name), "bold"),
    )
    text.append(f"\n{len(inside)} component{'s' * (len(inside) != 1)}: ", FAINT)
    states: dict[str, int] = {}
    for component in inside:
        state = "unknown" if component.state is None else component.state.name
        states[state] = states.get(state, 0) + 1
    for number, (state, count) in enumerate(sorted(states.items())):
        text.append("  " if number else "")
        text.append(f"{count} {state}", STATE_STYLES.get(state, FAINT))
    text.append("\nsent ", FAINT)
    text.append(f"{amount(sum(component.sent for component in inside))}  ")
    text.append(f"{rate(sum(component.history.rate(now) for component in inside))}/s")
    clients = {component.control.controller for component in inside if component.control is not None} - {None}
    if clients:
        text.append("\ncontrolled by ", FAINT)
        text.append(", ".join(sorted(map(str, clients))), PURPLE)
    _append_kinds(text, {component.host for component in inside}, peers)
    return _cut(text, width)


def component_page(component: ObservedComponent, observed: Observed, peers: PeerRecogniser, now: float) -> Text:
    """Everything that is known about a component."""
    text = about_component(component, observed, peers, now, 1000)
    for service in component.services or ():
        text.append(f"\n  {printable(service)}")
    for kind, _ in peers.kinds_of(component.host):
        text.append(f"\nknown of {kind.name.upper()}, {kind.title} (docs/peers.md)", FAINT)
        for deviation in kind.deviations:
            text.append(f"\n  {deviation.what} ({deviation.reference})")
    waiting = sorted(component.requests.items())
    if waiting:
        text.append("\nrequests for control that were not answered", FAINT)
    for client, authority in waiting:
        text.append(f"\n  {client} with authority {authority}")
    return text


def short_service(service: str) -> str:
    """The last part of a service's name."""
    name, _, _ = service.rpartition(" ")
    return name.rpartition(":")[2] or name


def cells(route: Route, stream: Stream, scope: str, now: float) -> tuple[str, ...]:
    """The cells of a row of messages: name, direction and peer, count, rate, age, bytes, rate over time."""
    sent = within(route.source, scope)
    peer = route.destination if sent else route.source
    if scope.count(".") < 2:  # which component of the group it is
        peer = f"{route.source} → {route.destination}"
    elif sent:
        peer = f"→ {peer}"
    else:
        peer = f"← {peer}"
    peer = peer.replace("65535.255.255", "all")
    return (
        printable(route.message),
        peer,
        amount(stream.count),
        rate(stream.history.rate(now)),
        age(now - stream.latest.time),
        amount(stream.latest.size),
        bars(stream.history.counts(now)[-20:]),
    )


def message_text(seen: SeenMessage, *, head: bool = False) -> Text:
    """The fields of a message; with `head`, also its header and bytes."""
    part = seen.part
    packet = part.packet
    text = Text()
    if head:
        text.append(f"{clock(seen.time)}  {packet.source} → {packet.destination}\n", BLUE)
        text.append(
            f"sequence {packet.sequence}, priority {packet.priority.name}, acknowledgement {packet.ack.name}, "
            f"{packet.data_flag.name.lower()}, {seen.size} bytes\n\n",
            FAINT,
        )
    if part.content.problem:
        text.append(f"{printable(part.content.problem)}\n", YELLOW)
    for deviation in part.content.deviations:
        text.append(f"{printable(deviation)}\n", YELLOW)
    if part.content.message is not None:
        text.append_text(fields_text(part.content.message))
    if head:
        text.append("\n")
        payload = part.content.payload
        for offset in range(0, min(len(payload), MAX_DUMP), 16):
            row = payload[offset : offset + 16]
            shown = "".join(chr(byte) if 32 <= byte < 127 else "·" for byte in row)
            text.append(f"{offset:04x}  ", FAINT)
            text.append(f"{row.hex(' '):<47}  ")
            text.append(f"{shown}\n", FAINT)
        if len(payload) > MAX_DUMP:
            text.append(f"{len(payload) - MAX_DUMP} more bytes\n", FAINT)
    return text


def fields_text(message: Message) -> Text:
    """The fields of a message, one line each."""
    text = Text()
    for line in islice(styled_fields(message), MAX_LINES):
        text.append_text(Text.assemble(*((printable(piece), STYLES.get(style, style)) for piece, style in line), "\n"))
    return text


def plot(series: Series, start: float, end: float, size: tuple[int, int], *, cursor: float | None = None) -> Text:
    """The curve of a field with its limits; `cursor` is a time to mark below it."""
    width, height = size
    points = [point for point in series.points if start <= point[0] <= end]
    title = Text.assemble((series.path, "bold"), (f"  {series.route.source}", FAINT))
    if not points:
        return title.append("\nno values yet", FAINT)
    low, high = min(value for _, value in points), max(value for _, value in points)
    before = [value for time, value in points if cursor is None or time <= cursor]
    title.append("  " + (f"{before[-1]:.6g}" if before else ""), f"bold {GREEN}")
    labels = [f"{high:.4g}", f"{low:.4g}"]
    margin = max(map(len, labels)) + 1
    inner = max(4, width - margin - 1)
    rows = max(1, height - 2)
    title.truncate(width, overflow="ellipsis")
    for number, line in enumerate(curve(points, start, end, inner, rows)):
        label = labels[0] if number == 0 else labels[1] if number == rows - 1 else ""
        title.append(f"\n{label:>{margin - 1}} ", FAINT)
        title.append(line, GREEN)
    left, right = clock(start), clock(end)
    axis = f"{left}{right:>{max(0, inner - len(left))}}"[:inner]
    title.append("\n" + " " * margin)
    if cursor is not None and end > start:
        column = min(inner - 1, max(0, round((cursor - start) / (end - start) * (inner - 1))))
        padded = f"{axis:<{inner}}"
        title.append(padded[:column], FAINT).append("▲", YELLOW).append(padded[column + 1 :], FAINT)
    else:
        title.append(axis, FAINT)
    return title


def slider(start: float, end: float, position: float, *, playing: bool, speed: float, width: int) -> Text:
    """The time of a capture."""
    head = f"{'▶' if playing else '⏸'} {clock(position)}  +{position - start:.1f} s "
    tail = f" {end - start:.1f} s  {speed:g}x"
    inner = max(4, width - len(head) - len(tail))
    column = round((position - start) / (end - start) * (inner - 1)) if end > start else inner - 1
    text = Text.assemble((head, f"bold {YELLOW}" if playing else "bold"))
    return (
        text.append("━" * column, BLUE)
        .append("●", YELLOW)
        .append("─" * (inner - 1 - column), FAINT)
        .append(tail, FAINT)
    )


def _append_state(text: Text, state: State | None, now: float) -> None:
    if state is None:
        text.append(*UNKNOWN)
        return
    text.append(state.name, STATE_STYLES.get(state.name, ""))
    text.append(f"{'' if state.reported else ' commanded'} {age(now - state.time)} ago", FAINT)


def _append_control(text: Text, control: Control | None, now: float) -> None:
    if control is None:
        text.append(*UNKNOWN)
        return
    text.append("nobody" if control.controller is None else str(control.controller), PURPLE)
    if control.authority is not None:
        text.append(f" authority {control.authority}", FAINT)
    text.append(f" {age(now - control.time)} ago", FAINT)


def _cut(text: Text, width: int) -> Text:
    """The lines, cut to a width."""
    lines = text.split("\n", allow_blank=True)
    for line in lines:
        line.truncate(max(1, width), overflow="ellipsis")
    return Text("\n").join(lines)


def id_of(scope: str) -> JausID | None:
    """The component of a scope; None for a subsystem or node."""
    return JausID.parse(scope) if scope.count(".") == 2 else None
