"""The panel Fleet without a browser: what has not changed keeps its elements, so that no click on them is lost."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from hypothesis import given, settings, strategies as st
from nicegui import Client, ui
from nicegui.page import page as make_page

from jauspy.console.panels.fleet import FleetPanel
from jauspy.console.part_names import PartNames
from jauspy.console.traffic import Traffic
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.ocu.subsystems import ComponentInfo

CHOSEN: list[int] = []


def component(robot: int, number: int, name: str = "") -> ComponentInfo:
    return ComponentInfo(JausID(robot, 1, number), name)


def panel_of(robots: dict[int, Any]) -> FleetPanel:
    fleet = SimpleNamespace(robots=robots, states={}, is_silent=lambda _: False, age=lambda _: 0.0)
    ocu = SimpleNamespace(id=JausID(42, 1, 1))
    console: Any = SimpleNamespace(fleet=fleet, traffic=Traffic(registry), ocu=ocu, names=PartNames())
    with Client(make_page(""), request=None):
        return FleetPanel(console, CHOSEN.append)


def robot(id: int, *components: ComponentInfo, name: str = "inc1") -> Any:
    return SimpleNamespace(id=id, name=name, components=components)


def buttons(panel: FleetPanel) -> list[ui.element]:
    """What can be clicked, as the page shows it."""
    return [each for each in panel._list.descendants() if each.tag in ("button", "q-btn")]


def texts(panel: FleetPanel) -> list[str]:
    """The names of robots, and the ids and names of their components, as the page shows them."""
    shown: list[str] = []
    for button in buttons(panel):
        labels = [each.text for each in button.descendants() if isinstance(each, ui.label)]
        shown.append(button.text if isinstance(button, ui.button) else " ".join(labels[:2]))
    return shown


def wanted(robots: dict[int, Any]) -> list[str]:
    shown: list[str] = []
    for each in robots.values():
        shown.append(f"{each.id}  {each.name}")
        shown += [f"{at.id.node}.{at.id.component} {at.name or 'component'}" for at in each.components]
    return shown


async def test_what_has_not_changed_keeps_its_elements() -> None:
    robots = {101: robot(101, component(101, 1), component(101, 3))}
    panel = panel_of(robots)
    panel._update()
    first = buttons(panel)
    robots[101] = robot(101, component(101, 1), component(101, 2), component(101, 3), name="renamed")
    robots[7] = robot(7, component(7, 1))
    panel._update()
    assert texts(panel) == wanted(robots)
    assert [each for each in buttons(panel) if each in first] == first
    assert not any(each.is_deleted for each in first)


async def test_a_component_that_reports_another_name_stays_open() -> None:
    robots = {101: robot(101, component(101, 1), component(101, 2))}
    panel = panel_of(robots)
    panel._update()
    panel._rows[JausID(101, 1, 1)]._toggle()
    robots[101] = robot(101, component(101, 1, "pose"), component(101, 2))
    panel._update()
    assert texts(panel) == wanted(robots)
    assert panel._rows[JausID(101, 1, 1)].is_open
    assert not panel._rows[JausID(101, 1, 2)].is_open


NAMES = st.sampled_from(["", "pose"])
ROBOTS = st.dictionaries(st.integers(1, 4), st.tuples(NAMES, st.dictionaries(st.integers(1, 4), NAMES)), max_size=4)


@pytest.mark.slow
@given(st.lists(ROBOTS, min_size=2, max_size=5))
@settings(max_examples=30)
def test_whatever_comes_and_goes_the_page_shows_what_is_there(history: list[Any]) -> None:
    robots: dict[int, Any] = {}
    panel = panel_of(robots)
    for state in history:
        robots.clear()
        for id, (name, components) in sorted(state.items()):
            parts = [component(id, number, each) for number, each in sorted(components.items())]
            robots[id] = robot(id, *parts, name=name)
        panel._update()
        assert texts(panel) == wanted(robots)
        assert panel._rows.keys() == {each.id for robot in robots.values() for each in robot.components}
