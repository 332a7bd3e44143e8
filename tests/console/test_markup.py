"""Text in the page: keys are fixed, values are never parsed, and arguments of scripts are data."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client, ui
from nicegui.page import page
from tools.attack.hostile_robot import IN_FILES

from jauspy.console import markup
from jauspy.console.manipulators import JointInfo
from jauspy.console.panels.arm import _JointRow
from jauspy.ocu.motion_limits import MotionLimits
from jauspy.printable import printable


@pytest.fixture(autouse=True)
def client() -> Iterator[Client]:
    with Client(page("/markup")) as made:
        yield made


@pytest.mark.parametrize("text", IN_FILES)
def test_a_value_is_one_value(text: str) -> None:
    element = ui.element("div")
    before = dict(element.props)
    markup.attributes(element, aria_label=text, data_state=text)
    assert dict(element.props) == {**before, "aria-label": printable(text), "data-state": printable(text)}


@pytest.mark.parametrize("text", IN_FILES)
def test_the_name_of_a_joint_is_no_property(text: str) -> None:
    row = _JointRow(JointInfo(text, True, -1.0, 1.0, MotionLimits(1.0)), 0.0)
    for element in (row._slider, row._number):
        assert element.props["aria-label"] == printable(text)
        assert not [key for key in element.props if key.startswith(":")]


def test_numbers_and_truth() -> None:
    element = markup.attributes(ui.element("div"), min=-1.5, max=2, aria_expanded=True, data_at=0.25)
    assert {key: element.props[key] for key in ("min", "max", "aria-expanded", "data-at")} == {
        "min": -1.5,
        "max": 2,
        "aria-expanded": "true",
        "data-at": 0.25,
    }
    assert markup.style_number(ui.element("div"), "at", 1 / 3).style["--at"] == "0.333333"


@pytest.mark.parametrize("key", ["href", "src", "onclick", ":aria_label", "innerHTML", "style", "is", "label"])
def test_other_attributes_are_refused(key: str) -> None:
    with pytest.raises(ValueError, match="is not an attribute that may vary"):
        markup.attributes(ui.element("div"), **{key: "x"})
    with pytest.raises(ValueError, match="min is not"):
        markup.attributes(ui.element("div"), min="x")
    with pytest.raises(ValueError, match="is not the name of a CSS variable"):
        markup.style_number(ui.element("div"), f"{key};", 1.0)


@pytest.mark.parametrize("text", IN_FILES)
def test_a_text_in_which_a_line_may_end_is_text(text: str) -> None:
    html = markup.breakable([text, "x"]).content
    assert html.endswith("<wbr>x")
    assert html.count("<") == 1


def test_arguments_of_scripts_are_data(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[str] = []
    monkeypatch.setattr(ui, "run_javascript", calls.append)
    given = [{"name": text, "points": [[1.0, math.nan], (2.0, math.inf)]} for text in IN_FILES]
    markup.call("jauspy.plot", 5, given, True, None)
    function, _, rest = calls[0].partition("(")
    assert function == "jauspy.plot"
    five, sent, true, none = json.loads(f"[{rest.removesuffix(')')}]")
    assert (five, true, none) == (5, True, None)
    assert sent == [{"name": text, "points": [[1.0, None], [2.0, None]]} for text in IN_FILES]
    assert rest.isascii(), "line separators of Unicode, too, are escaped"
    with pytest.raises(ValueError, match="is not the name of a function"):
        markup.call("alert(1);jauspy.plot")
