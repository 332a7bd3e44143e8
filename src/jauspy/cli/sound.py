"""`jauspy listen` and `jauspy announce`: sound of a robot's microphone to a file, and a file to its loudspeaker."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from jauspy.audio import need_audio
from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu import OCU, Announcer, Microphone

Target = Annotated[str, typer.Argument(metavar="ID", help="A robot (101), or one component of it (101.1.113).")]


def listen(
    *,
    target: Target,
    output: Annotated[Path, typer.Option("--output", "-o", metavar="FILE", help="The WAV file; it is replaced.")],
    seconds: Annotated[
        float, typer.Option("--seconds", min=0.1, max=600.0, metavar="SECONDS", help="How long to record.")
    ] = 10.0,
    number: Annotated[int, typer.Option("--microphone", min=1, metavar="N", help="Which one of the component.")] = 1,
    to: Annotated[
        str | None,
        typer.Option("--to", metavar="IP", help="Own address to send to. Default: the one that routes to the robot."),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 3.0,
    as_json: Json = False,
) -> None:
    """Record what a robot's microphone hears.

    The robot sends Opus over RTP; the file has one channel of 16 bits at 48 kHz. Lost packets are concealed, and
    counted. No control is taken.

    Examples:
      jauspy listen 101 -o heard.wav
      jauspy listen 101.1.113 -o heard.wav --seconds 60
    """
    need_audio()
    robot, component = _target(target)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    found = run(_listen(ocu, robot, component, number=number, output=output, seconds=seconds, to=to, wait=timeout))
    if found is None:
        return
    recorded, counters = found
    if as_json:
        console.print_json({"file": str(output), "seconds": round(recorded, 3), "counters": dict(counters)})
    else:
        console.print_lines(f"{recorded:.1f} s in {output}, {counters.get('lost', 0)} packets lost")


async def _listen(
    ocu: OCU,
    robot: int,
    component: JausID | None,
    *,
    number: int,
    output: Path,
    seconds: float,
    to: str | None,
    wait: float,
) -> tuple[float, Mapping[str, int]]:
    async with ocu:
        found = await ocu.discover(robot, timeout=wait)
        which = found.microphone.info.id if component is None else component
        microphone: Microphone = found.component(which).microphone(number)
        return await microphone.record(output, seconds=seconds, address=to), microphone.counters


def announce(
    *,
    target: Target,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A WAV file, of up to 10 minutes.")],
    number: Annotated[
        int | None, typer.Option("--loudspeaker", min=1, metavar="N", help="Which device of the component.")
    ] = None,
    authority: Annotated[
        int, typer.Option("--authority", min=0, max=255, help="Authority with which control is taken.")
    ] = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 3.0,
    as_json: Json = False,
) -> None:
    """Play a WAV file on a robot's loudspeaker.

    Control of the component is taken meanwhile, and the file is sent in real time as Opus over RTP. Ctrl-C ends it.

    Examples:
      jauspy announce 101 message.wav
      jauspy announce 101.1.113 message.wav --loudspeaker 3
    """
    need_audio()
    robot, component = _target(target)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    played = run(_announce(ocu, robot, component, file=file, number=number, authority=authority, wait=timeout))
    if played is None:
        return
    if as_json:
        console.print_json({"file": str(file), "seconds": round(played, 3)})
    else:
        console.print_lines(f"played {played:.1f} s of {file}")


async def _announce(
    ocu: OCU, robot: int, component: JausID | None, *, file: Path, number: int | None, authority: int, wait: float
) -> float:
    async with ocu:
        found = await ocu.discover(robot, timeout=wait)
        which = found.announcer.info.id if component is None else component
        announcer: Announcer = found.component(which).announcer(number)
        return await announcer.play(file, authority=authority)


def _target(text: str) -> tuple[int, JausID | None]:
    """The subsystem, and the component if one is named; raises `ConfigError`."""
    if text.isascii() and text.isdigit():
        return client.destination(f"{text}.1.1").subsystem, None
    component = client.destination(text)
    if component.is_wildcard:
        raise ConfigError(f"{component} has wildcards; name a robot, as in 101, or one component, as in 101.1.113")
    return component.subsystem, component
