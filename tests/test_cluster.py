"""Campaigns on Dask: a lost worker loses no finding."""

import os
import signal
import sys
from pathlib import Path

import pytest

from jauspy.cluster import spread
from jauspy.errors import ConfigError
from jauspy.fuzz.campaign import CampaignPlan, run

distributed = pytest.importorskip("distributed", reason="needs jauspy[cell-cluster]")
pytestmark = pytest.mark.filterwarnings("default")  # of Dask, about its own processes
PARTS = 12
CULPRIT = 7


def found(part: tuple[int, str]) -> tuple[int, bool]:
    """A part of a campaign; the first attempt at one of them kills its worker before it returns the finding."""
    number, folder = part
    mark = Path(folder) / "killed"
    if number == CULPRIT and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number, number == CULPRIT


def fatal(number: int) -> int:
    """A part that ends every worker."""
    os.kill(os.getpid(), signal.SIGKILL)
    return number


@pytest.fixture
def cluster(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(Path(__file__).parents[1]), *sys.path]))
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as made:
        yield made.scheduler_address


@pytest.mark.slow
def test_a_lost_worker_loses_no_finding(cluster, tmp_path):
    results = list(spread(cluster, found, [(number, str(tmp_path)) for number in range(PARTS)]))
    assert (tmp_path / "killed").exists()
    assert results == [(number, number == CULPRIT) for number in range(PARTS)]


@pytest.mark.slow
def test_a_part_that_ends_every_worker_is_an_error(cluster):
    with pytest.raises(ConfigError, match="ended every worker"):
        list(spread(cluster, fatal, [1]))


@pytest.mark.slow
def test_a_campaign_on_a_cluster_is_the_same(cluster):
    plan = CampaignPlan(1500, 2, only=("ConfirmControl",))
    there, here = run(plan, cluster=cluster), run(plan)
    assert (there.cases, there.accepted, there.findings) == (here.cases, here.accepted, here.findings)


def test_a_missing_package_is_an_error(monkeypatch):
    def missing(name):
        raise ImportError(name)

    monkeypatch.setattr("jauspy.cluster.import_module", missing)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[cell-cluster\]'"):
        list(spread("tcp://127.0.0.1", fatal, [1]))


def test_no_scheduler_is_an_error():
    with pytest.raises(ConfigError, match="no Dask scheduler answers"):
        list(spread("tcp://127.0.0.1", fatal, [1]))
