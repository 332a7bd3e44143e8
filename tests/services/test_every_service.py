"""The behaviour of every shipped service can be carried out, given its actions."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from jauspy.schema import load_builtin, model
from jauspy.services.bind import Binder
from jauspy.services.lineage import definitions_of
from jauspy.services.service import Service
from jauspy.services.tree import merge, start_of


class Willing(Service):
    """Has a method for everything."""

    def __getattr__(self, name: str) -> Callable[[], None]:
        return lambda: None


@pytest.mark.parametrize("definition", load_builtin().services, ids=lambda each: f"{each.name}-{each.version}")
def test_is_bound_without_a_problem(definition: model.Service) -> None:
    one = type("One", (Willing,), {}, urn=definition.id, version=definition.version)()
    definitions = definitions_of([one], load_builtin())
    binder = Binder(definitions, dict.fromkeys(definitions, one), lambda *_: None)
    roots = merge(list(definitions.values()))
    rules = [rule for root in roots.values() for state in binder.states(root).values() for rule in state.transitions]
    assert binder.problems == []
    assert {rule.kind for rule in rules if rule.end is None} <= {"internal", "pop"}
    assert all(start_of(root, name, list(definitions.values())) for name, root in roots.items())
