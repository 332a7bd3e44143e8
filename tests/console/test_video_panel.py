"""The view Video without a browser: names of cameras after lost queries, and what is said about pointing."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client
from nicegui.page import page as make_page

from jauspy.console.conventions import Conventions
from jauspy.console.panels import video
from jauspy.console.panels.video import VideoPanel
from jauspy.console.users import LOCAL
from jauspy.errors import ConfigError, ResponseTimeout


def panel() -> VideoPanel:
    console: Any = SimpleNamespace(camera=lambda _: None)
    with Client(make_page(""), request=None):
        return VideoPanel(console, "page", LOCAL, Conventions())


async def test_a_camera_is_asked_for_its_name_until_it_tells(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = panel()
    asked: list[str] = []

    async def sensor_name(component: str) -> str:
        asked.append(component)
        if len(asked) == 1:
            raise ResponseTimeout("101.1.106 does not answer")
        return "arm"

    monkeypatch.setattr(video, "sensor_name", sensor_name)
    robot: Any = SimpleNamespace(component=lambda component: component)
    label = SimpleNamespace(text="101.1.106  CM-VIS")
    label.set_text = lambda text: setattr(label, "text", text)
    shown._robot, shown._unnamed = robot, {"101.1.106"}
    shown._captions = {"101.1.106": label}  # type: ignore[dict-item]
    for wanted in ("101.1.106  CM-VIS", "arm  101.1.106", "arm  101.1.106"):
        await shown._name_cameras()
        assert label.text == wanted
    assert len(asked) == 2, "a camera that has told its name is asked no more"


async def test_a_refusal_to_turn_goes_when_the_camera_has_turned() -> None:
    shown = panel()

    async def act(problem: str = "") -> None:
        if problem:
            raise ConfigError(problem)

    said = shown._said
    await shown._pointing._try(act("the camera is not turned: take control first"))
    assert said.text == "the camera is not turned: take control first"
    await shown._pointing._try(act())
    assert said.text == ""
    await shown._pointing._try(act("no"))
    said.set_text("saved a.png")
    await shown._pointing._try(act())
    assert said.text == "saved a.png", "another text stays"
