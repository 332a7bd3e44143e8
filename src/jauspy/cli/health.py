"""`jauspy health`: the battery of a robot, and the health of its drives, cameras and computers."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any, Final

import typer
from rich.text import Text

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OwnId
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU, BatteryReport, HealthReport

STYLES: Final = {"NONE": "green", "INFO": "cyan", "WARN": "yellow", "ERR": "bold red", "FAIL": "bold red"}


def health(
    *,
    subsystem: Annotated[int, typer.Argument(min=1, max=65534, metavar="SUBSYSTEM", help="The robot, as in 101.")],
    connect: Connect = None,
    own_id: OwnId = None,
    as_json: Json = False,
) -> None:
    """Show a robot's battery, and the health of its drives, cameras and computers.

    The exit status is 1 if something has failed or needs an operator: severities WARN, ERR and FAIL.

    Example:
      jauspy health 101
    """
    found = run(_ask(client.own_id(own_id, connect), connect, subsystem))
    if found is None:
        return
    battery, entries, node = found
    ids = [f"{subsystem}.{node}.{entry.component}" for entry in entries]
    if as_json:
        rows: list[dict[str, Any]] = [{"battery": asdict(battery)}] if battery else []
        for row in (*rows, *({"id": id, **asdict(entry)} for id, entry in zip(ids, entries, strict=True))):
            console.print_json(_plain(row))
    else:
        if battery is not None:
            console.stdout().print(battery_line(battery))
        width = max(map(len, ids), default=0)
        for id, entry in zip(ids, entries, strict=True):
            severity = (f"{entry.severity:<5}", STYLES.get(entry.severity, ""))
            console.stdout().print(Text.assemble(severity, f"{id:<{width}}  {entry.text}"))
    if not all(entry.is_well for entry in entries):
        raise typer.Exit(1)


def battery_line(battery: BatteryReport) -> str:
    """The battery in one line, with what it reports."""
    values = ((battery.charge and 100.0 * battery.charge, "%"), (battery.voltage, "V"), (battery.current, "A"))
    parts = [f"{value:.1f} {unit}" for value, unit in (*values, (battery.power, "W")) if value is not None]
    return "battery: " + (", ".join(parts) or "it reports nothing")


async def _ask(
    own_id: str, connect: str | None, subsystem: int
) -> tuple[BatteryReport | None, list[HealthReport], int]:
    """The battery, the health of all parts, and the node of the component that reports it."""
    async with OCU(own_id, connect) as ocu:
        robot = await ocu.robot(subsystem)
        offered = {name: any(part.find(name) for part in robot.components) for name in (BATTERY, HEALTH)}
        if not any(offered.values()):
            raise ConfigError(f"subsystem {subsystem} offers neither {HEALTH} nor {BATTERY}, which tell it")
        battery = await robot.battery() if offered[BATTERY] else None
        if not offered[HEALTH]:
            return battery, [], 0
        return battery, await robot.health(), robot.service(HEALTH).id.node


BATTERY: Final = "PowerPlantManager"
HEALTH: Final = "HealthReporter"


def _plain(row: dict[str, Any]) -> dict[str, Any]:
    """The row with times as text."""
    return {
        key: _plain(value) if isinstance(value, dict) else value.isoformat() if hasattr(value, "isoformat") else value
        for key, value in row.items()
    }
