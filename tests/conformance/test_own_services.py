"""A service of a user's own definition is tested as those of the standard: every state and transition."""

from __future__ import annotations

import pytest
from tests.conformance.simulated import START
from tests.conformance.winch import ID, SOURCE, URN, winch, winch_messages
from typer.testing import CliRunner

from jauspy.cli import conformance_runs
from jauspy.cli.main import app
from jauspy.conformance import Report, Settings, TargetComponent, Verdict, VirtualTarget, run
from jauspy.conformance.state_tests.plan import service_profile
from jauspy.errors import ConfigError
from jauspy.ids import JausID

READY = "Controlled.Available.Ready"


def judged(target: VirtualTarget, **settings: object) -> Report:
    messages = winch_messages()
    return run(
        service_profile(URN, messages),
        target,
        ID,
        began=START.timestamp(),
        settings=Settings(**settings),
        registry=messages,
    )


def test_every_state_and_transition_is_tested() -> None:
    report = judged(winch())
    assert (report.problem, [(each.id, each.reason) for each in report.failures]) == ("", [])
    ids = {each.id for each in report.results if each.verdict is Verdict.PASS}
    assert {
        f"{READY}.Idle/PullWinch/controller",
        f"{READY}.Pulling/LockWinch/controller",
        f"{READY}.Locked/StopWinch/controller",
        f"{READY}.Locked/QueryWinch/other-client",
        f"{READY}.Idle/QueryWinch/other-client",
        f"{READY}.Pulling/StopWinch/other-client",
    } <= ids
    assert not [each for each in report.transitions if not each.step and "Winch," in each.name]


def test_mistakes_are_found() -> None:
    class Chatty(TargetComponent):
        """Answers QueryWinch in every state."""

        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            if payload[:2] == b"\x24\xd0":
                self.host.send(source, winch_messages().by_name("ReportWinch")(load=1))
            else:
                super().receive(payload, source, now)

    failed = {each.id for each in judged(winch(Chatty)).failures}
    assert f"{READY}.Idle/QueryWinch/other-client" in failed
    assert f"{READY}.Locked/QueryWinch/other-client" not in failed


def test_own_commands_count_as_motion() -> None:
    report = judged(winch(), motion=False)
    for state in ("Pulling", "Locked"):
        steps = [each for each in report.results if each.id.startswith(f"{READY}.{state}/")]
        assert {each.verdict for each in steps} == {Verdict.SKIPPED}


def test_unknown_service_is_an_error() -> None:
    with pytest.raises(ConfigError, match=r"no definition of urn:acme:Hoist is known; the files define urn:example"):
        service_profile("urn:acme:Hoist", winch_messages())


@pytest.mark.slow
def test_verb_tests_a_service_by_its_urn(monkeypatch: pytest.MonkeyPatch) -> None:
    target = winch()

    async def open_link(connect: str | None) -> VirtualTarget:
        return target

    monkeypatch.setattr(conformance_runs, "open_link", open_link)
    where = ["--target", str(ID), "--schemas", str(SOURCE)]
    listed = CliRunner().invoke(app, ["conformance", URN, "--list", *where])
    assert f"{READY}.Pulling/LockWinch/controller" in listed.stdout
    result = CliRunner().invoke(app, ["conformance", URN, *where])
    assert result.exit_code == 0, result.stdout
    named = CliRunner().invoke(app, ["conformance", URN, *where, "--services", "Winch", "--only", READY])
    assert named.exit_code == 0
