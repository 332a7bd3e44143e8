"""Campaigns that continue from a file."""

import json

import pytest

from jauspy.errors import ConfigError
from jauspy.fuzz.campaign import CampaignPlan, run

PLAN = CampaignPlan(1200, 3, only=("ConfirmControl",))


@pytest.mark.slow
def test_an_interrupted_campaign_continues_where_it_stopped(tmp_path):
    file, seen = tmp_path / "progress.json", []

    def interrupt(outcome):
        if outcome.cases == 500:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(PLAN, interrupt, resume=file)
    continued = run(PLAN, lambda outcome: seen.append(outcome.cases), resume=file)
    whole = run(PLAN)
    assert seen == [500, 1000, 1200]
    assert (continued.cases, continued.accepted) == (whole.cases, whole.accepted)


def test_findings_are_kept(tmp_path, plant, hunt):
    def bug(right, data):
        if len(data) > 20:
            raise ZeroDivisionError
        return right(data, 0)

    plant(bug)
    plan = CampaignPlan(500, 1, only=("RegisterServices",))
    first = run(plan, resume=tmp_path / "progress.json")
    assert first.findings
    again = run(plan, lambda _: None, resume=tmp_path / "progress.json")
    assert again.findings == first.findings


@pytest.mark.slow
def test_a_campaign_may_get_more_cases_and_jobs(tmp_path):
    file = tmp_path / "progress.json"
    run(CampaignPlan(500, only=("ConfirmControl",)), resume=file)
    more = run(CampaignPlan(1000, only=("ConfirmControl",), jobs=2), resume=file)
    assert more.accepted == run(CampaignPlan(1000, only=("ConfirmControl",))).accepted


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("", "not a progress file"),
        ("[]", "not a progress file"),
        (json.dumps({"campaign": "x", "cases": -1, "accepted": 0, "findings": []}), "not a progress file"),
        (json.dumps({"campaign": "x", "cases": 1, "accepted": 0, "findings": [{}]}), "not a progress file"),
        (json.dumps({"campaign": "x", "cases": 1, "accepted": 0, "findings": []}), "another seed"),
    ],
)
def test_other_files_are_refused(tmp_path, content, reason):
    (tmp_path / "progress.json").write_text(content)
    with pytest.raises(ConfigError, match=reason):
        run(PLAN, resume=tmp_path / "progress.json")
