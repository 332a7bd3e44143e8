"""A service of a user, with ids that do not say what they are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import jauspy
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.messages.core import CreateEvent, QueryEvents
from jauspy.schema import builtin_paths, load_files
from jauspy.services.core import Discovery
from jauspy.services.service import Service

LAMP = Path(__file__).parents[1] / "vendor" / "Lamp.xml"


@pytest.fixture
def own() -> Registry:
    return jauspy.load(LAMP)


@pytest.fixture
async def lamp(own: Registry, world: Any) -> Any:
    class Lamp(Service, urn="urn:example:vendor:Lamp"):
        brightness = 10

        def set_lamp(self, msg: Any) -> None:
            self.brightness = msg.brightness

        def report_lamp(self) -> Any:
            return own.by_name("ReportLamp")(self.brightness)

    schema = load_files([LAMP, *builtin_paths()])
    return await world.component(
        jauspy.JausID(101, 1, 7),
        [Lamp(), Discovery()],
        options=jauspy.component.ComponentOptions(schema=schema, registry=own),
    )


def test_user_defined_queries_are_recognised(own: Registry) -> None:
    assert [own.by_name(name).IS_QUERY for name in ("SetLamp", "QueryLamp", "ReportLamp")] == [False, True, False]
    assert own.by_name("QueryUGVSummary").IS_QUERY
    assert not any(each.IS_QUERY for each in own if each.NAME.startswith(("Report", "Set")))


@pytest.mark.slow
async def test_user_defined_query_is_answered(own: Registry, lamp: Any, world: Any) -> None:
    ocu = await world.ocu(registry=own)
    await ocu.send(lamp.id, own.by_name("SetLamp")(70))
    assert await ocu.query(lamp.id, own.by_name("QueryLamp")()) == own.by_name("ReportLamp")(70)


@pytest.mark.slow
async def test_user_defined_reports_can_be_subscribed(own: Registry, lamp: Any, world: Any) -> None:
    ocu = await world.ocu(registry=own)
    query = own.by_name("QueryLamp")()
    await ocu.query(lamp.id, CreateEvent(1, 0, 1.0, query), expects=own.by_name("ConfirmEventRequest"))
    report = await ocu.query(lamp.id, QueryEvents(QueryEvents.AllEventsRec(0)))
    (event,) = report.event_list
    assert event.query_message == query


@pytest.mark.slow
async def test_ocu_without_the_definition_can_query(own: Registry, lamp: Any, world: Any) -> None:
    ocu = await world.ocu()
    assert await ocu.query(lamp.id, own.by_name("QueryLamp")()) == own.by_name("ReportLamp")(10)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("known", "problem"),
    [
        (True, "Lamp has no message QueryLmap$"),
        (
            False,
            r"no definition of urn:example:vendor:Lamp is known; pass it: OCU\(registry=jauspy\.load\(FILE\)\)$",
        ),
    ],
)
async def test_messages_are_found_by_name(own: Registry, lamp: Any, world: Any, known: bool, problem: str) -> None:
    ocu = await world.ocu(registry=own if known else None)
    with pytest.raises(ConfigError, match=problem):
        (await ocu.discover(101)).service("Lamp").message("QueryLmap")


async def test_query_without_known_report_is_an_error(own: Registry, world: Any, tmp_path: Path) -> None:
    ocu = await world.ocu()
    file = tmp_path / "Lamp.xml"
    text = LAMP.read_text().replace("'ReportLamp'", "'SetLamp'")  # no state sends the report, which has another name
    file.write_text(text.replace("ReportLamp", "TellLamp").replace("'SetLamp'", "msg"))
    with pytest.raises(ConfigError, match=r"no message called ReportLamp .* is known to answer QueryLamp"):
        await ocu.query("101.1.7", jauspy.load(file).by_name("QueryLamp")())
    with pytest.raises(ConfigError, match="SetLamp is not a query"):
        await ocu.query("101.1.7", own.by_name("SetLamp")(1))


@pytest.mark.slow
async def test_queries_to_the_ocu_are_not_answers(own: Registry, lamp: Any, world: Any) -> None:
    ocu = await world.ocu(registry=own)
    lamp.send(ocu.id, own.by_name("QueryLamp")())
    lamp.send(ocu.id, own.by_name("SetLamp")(1))
    await ocu.query(lamp.id, own.by_name("QueryLamp")())
    assert ocu.counters["host.unknown_message"] == 2
