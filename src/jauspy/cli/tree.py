"""Discovered subsystems on paper: a tree for people, and a JSON object for each."""

from __future__ import annotations

from typing import Any

from rich.text import Text
from rich.tree import Tree

from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, SubsystemInfo, kind_of


def tree_of(subsystem: SubsystemInfo) -> Tree:
    """Subsystem, nodes, components, and services with their versions."""
    tree = Tree(_label("subsystem", subsystem.id, subsystem.name, subsystem.kind, style="bold cyan"), guide_style="dim")
    for node in subsystem.nodes:
        branch = tree.add(_label("node", node.id, node.name, kind_of(node.type) if node.type else ""))
        for component in node.components:
            kind = component.kind if component.type else ""
            leaf = branch.add(_label("component", component.id, component.name, kind, style="bold"))
            for service in component.services:
                leaf.add(Text.assemble(service.short, (f"  {service.version}", "dim")))
    return tree


def as_json(subsystem: SubsystemInfo) -> dict[str, Any]:
    """The same, as an object."""
    return {
        "subsystem": subsystem.id,
        "name": subsystem.name,
        "type": subsystem.kind,
        "nodes": [_node_json(node) for node in subsystem.nodes],
    }


def _label(what: str, id: object, name: str, kind: str, style: str = "") -> Text:
    text = Text.assemble((what, "dim"), " ", (f"{id}", style), f"  {name}" if name else "")
    return text.append(f"  {kind}", "dim") if kind and kind != "unknown" else text


def _node_json(node: NodeInfo) -> dict[str, Any]:
    return {"node": node.id, "name": node.name, "components": [_component_json(each) for each in node.components]}


def _component_json(component: ComponentInfo) -> dict[str, Any]:
    return {
        "id": str(component.id),
        "name": component.name,
        "services": [{"urn": service.urn, "version": service.version} for service in component.services],
    }
