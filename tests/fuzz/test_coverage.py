"""Coverage-guided fuzzing finds what is behind comparisons; blind fuzzing does not."""

import sys

import pytest

from jauspy.errors import ConfigError
from jauspy.fuzz.coverage import PythonPlan, run

DECODER = "tests.fuzz.deep_decoder:decode"
CASES = 15_000


def plan(**changes):
    return PythonPlan(DECODER, CASES, only=("SetWrenchEffort",), **changes)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_guided_fuzzing_finds_a_deep_branch_that_blind_fuzzing_misses(seed):
    guided, blind = run(plan(seed=seed)), run(plan(seed=seed, guided=False))
    assert guided.cases == blind.cases == CASES
    assert guided.lines > blind.lines
    assert not blind.findings
    (finding,) = guided.findings.values()
    assert (finding.exception, finding.seen) == ("ZeroDivisionError", "deep")
    assert finding.data.hex() == "05047fff80017f00"  # nothing more than what the decoder compares


@pytest.mark.slow
def test_the_same_seed_gives_the_same_campaign():
    assert run(plan(seed=5)) == run(plan(seed=5))


@pytest.mark.slow
def test_given_payloads_are_run_first():
    found = run(PythonPlan(DECODER, 0, payloads=(bytes.fromhex("05047fff80017f00"),)))
    assert [finding.exception for finding in found.findings.values()] == ["ZeroDivisionError"]


@pytest.mark.slow
def test_measuring_ends_with_the_campaign():
    before = sys.gettrace()
    run(PythonPlan(DECODER, 10))
    assert sys.gettrace() is before


@pytest.mark.parametrize("name", ["no_such_module:f", "tests.fuzz.deep_decoder:missing", "sys:exit", "nothing"])
def test_wrong_functions_are_refused(name):
    with pytest.raises(ConfigError):
        run(PythonPlan(name, 1))
