"""`jauspy new component` for each service of IOP v3 and AEODRS: it starts, and answers or counts each query."""

from __future__ import annotations

import importlib
from pathlib import Path
from random import Random

import pytest
from tests.helpers.sampling import sampled

import jauspy
from jauspy.cli.new import component as template
from jauspy.codec.build import asks
from jauspy.fuzz.messages import MessageMaker, Style, targets
from jauspy.messages import registry
from jauspy.schema import load_builtin
from jauspy.services.state_machine import TriggerOutcome

PROFILE = [
    service
    for service in load_builtin().services
    if service.id.startswith(("urn:jaus:jss:iop:", "urn:jaus:jss:exp:")) and not service.id.endswith("Client")
]
ME, CLIENT = jauspy.JausID(101, 1, 120), jauspy.JausID(42, 1, 1)


def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, definition) -> list[jauspy.Service]:
    """The services of a new package, imported from its files."""
    name = f"template_of_{definition.name.lower()}"
    (tmp_path / name).mkdir()
    for file, text in template.package(name, definition, load_builtin(), None, ME).items():
        (tmp_path / name / file).write_text(text)
    monkeypatch.syspath_prepend(tmp_path)
    return importlib.import_module(f"{name}.services").services()


def test_all_services_of_the_profile_are_here():
    names = {service.id.rpartition(":")[2] for service in PROFILE}
    assert len(names) >= 56
    assert {"TirePressureService", "WiperService", "PlatformDoorService", "DebrisBlowerService"} <= names
    assert {"TamperDetection", "RenderUseless", "MilitaryIlluminationService"} <= names
    assert {"SeismicSensor", "MagneticSensor", "AcousticSensor"} <= names


@pytest.mark.slow
@pytest.mark.asyncio
@pytest.mark.parametrize("definition", sampled(PROFILE, fast=14), ids=lambda one: f"{one.name}-{one.version}")
async def test_each_query_is_answered_or_counted(tmp_path, monkeypatch, virtual_network, definition):
    services = write(tmp_path, monkeypatch, definition)
    queries = [one for one in definition.inputs if asks(one, definition)]
    made = targets(registry, load_builtin(), [one.name for one in queries]) if queries else ()
    async with (
        virtual_network.component(str(ME), services) as component,
        virtual_network.ocu() as ocu,
    ):
        assert component.host.definitions[definition.id].version == definition.version
        for target in made:
            if definition.id != target.cls.SERVICE or definition.version != target.cls.VERSION:
                continue
            before = component.counters.get("host.to_do", 0)
            query = target.cls.decode(MessageMaker(Random(1), Style.SHORTEST).message(target))
            outcome, reply = component.host.ask(query, CLIENT)
            assert outcome is TriggerOutcome.TAKEN, target.title
            if reply is not None and hasattr(target.cls, "REPORT"):
                (await ocu.query(str(ME), query)).encode()
            elif reply is None:
                assert component.counters.get("host.to_do", 0) > before, target.title
        assert "host.action_failed" not in component.counters
        assert "host.not_encoded" not in component.counters


def test_a_report_without_values_is_sent_and_others_are_marked(tmp_path, monkeypatch):
    """An empty list is a true answer; a number would be invented."""
    definition = load_builtin().service("urn:jaus:jss:iop:TirePressureService", "1.1")
    write(tmp_path, monkeypatch, definition)
    text = (tmp_path / "template_of_tirepressureservice" / "services.py").read_text()
    assert "# TODO: what it reports\n        return ReportTirePressureStatus(tire_pressure_status_list=[])" in text
    definition = load_builtin().service("urn:jaus:jss:iop:PlatformDoorService", "1.1")
    write(tmp_path, monkeypatch, definition)
    text = (tmp_path / "template_of_platformdoorservice" / "services.py").read_text()
    assert 'self.host.count("to_do", "' in text
