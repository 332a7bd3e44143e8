"""`jauspy ls`: list subsystems, nodes, components and services on the network."""

from __future__ import annotations

from typing import Annotated, Any, Final

import typer
from rich.text import Text
from rich.tree import Tree

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OwnId
from jauspy.cli.processes import run
from jauspy.errors import ResponseTimeout
from jauspy.ocu import OCU
from jauspy.ocu.discovery import MAX_SEARCH
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, SubsystemInfo, kind_of
from jauspy.printable import printable

CORE: Final = "urn:jaus:jss:core:"
"""Beginning of the names of core services."""


def ls(
    *,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Annotated[
        float | None,
        typer.Option(
            "--timeout",
            min=0.01,
            metavar="SECONDS",
            help="How long to listen for answers. Default: about a second, until all that answered are complete.",
        ),
    ] = None,
    verbose: Annotated[
        bool, typer.Option("--verbose", "-v", help="Show core services, too, which most components have.")
    ] = False,
    as_json: Json = False,
) -> None:
    """List subsystems, nodes, components and services that answer discovery.

    Core services (Transport, Events, AccessControl, ...) are shown with -v; --json lists everything.

    Example:
      jauspy ls --connect udp://192.168.1.20:3794 --timeout 5
    """
    found = run(_discover(client.own_id(own_id, connect), connect, timeout)) or []
    for subsystem in found:
        if as_json:
            console.print_json(to_json(subsystem))
        else:
            console.stdout().print(tree_of(subsystem, verbose=verbose))
    if not found:
        raise ResponseTimeout(
            f"no component answered within {timeout or MAX_SEARCH:g} s; start a robot (`jauspy up inc1`), or give the "
            "node manager's address with --connect"
        )


async def _discover(own_id: str, connect: str | None, max_wait: float | None) -> list[SubsystemInfo]:
    """All subsystems but the client's own."""
    async with OCU(own_id, connect) as ocu:
        found = await ocu.discover_all(timeout=max_wait)
        return [robot.info for robot in found if robot.id != ocu.id.subsystem]


def tree_of(subsystem: SubsystemInfo, *, verbose: bool = True) -> Tree:
    """A subsystem as a tree of nodes, components, and services with their versions; core ones only if `verbose`."""
    tree = Tree(_label("subsystem", subsystem.id, subsystem.name, subsystem.kind, style="bold cyan"), guide_style="dim")
    for node in subsystem.nodes:
        branch = tree.add(_label("node", node.id, node.name, kind_of(node.type) if node.type else ""))
        for component in node.components:
            kind = component.kind if component.type else ""
            leaf = branch.add(_label("component", component.id, component.name, kind, style="bold"))
            for service in component.services:
                if not verbose and service.urn.startswith(CORE):
                    continue
                leaf.add(Text.assemble(service.short, (f"  {service.version}", "dim")))
    return tree


def to_json(subsystem: SubsystemInfo) -> dict[str, Any]:
    """A subsystem as a JSON object."""
    return {
        "subsystem": subsystem.id,
        "name": subsystem.name,
        "type": subsystem.kind,
        "nodes": [_node_json(node) for node in subsystem.nodes],
    }


def _label(what: str, id: object, name: str, kind: str, style: str = "") -> Text:
    text = Text.assemble((what, "dim"), " ", (f"{id}", style), f"  {printable(name)}" if name else "")
    return text.append(f"  {kind}", "dim") if kind and kind != "unknown" else text


def _node_json(node: NodeInfo) -> dict[str, Any]:
    return {
        "node": node.id,
        "name": node.name,
        "components": [_component_json(component) for component in node.components],
    }


def _component_json(component: ComponentInfo) -> dict[str, Any]:
    return {
        "id": str(component.id),
        "name": component.name,
        "services": [{"urn": service.urn, "version": service.version} for service in component.services],
    }
