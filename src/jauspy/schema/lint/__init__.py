"""The linter: its rules, and the run that finds all mistakes that break other tools, also in files the loader rejects.

Codes of rules are stable: people write them into their build files.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from jauspy.errors import SchemaError
from jauspy.schema.behavior import read_behavior
from jauspy.schema.document import location
from jauspy.schema.lint import behavior, behavior as shadows, fields, messages, messages as references
from jauspy.schema.lint.context import LintContext, LintFinding, LintRule, Problem, Severity
from jauspy.schema.lint.messages import problem_of
from jauspy.schema.loader import load_beside_builtin
from jauspy.schema.services import read_event, read_message

__all__ = ["REFUSED", "RULES", "UNREADABLE", "LintContext", "LintFinding", "LintRule", "Problem", "Severity", "lint"]

RULES: tuple[LintRule, ...] = (
    LintRule(
        "grammar",
        "error",
        "an element or attribute that JSIDL does not have, or one missing",
        references.broken_grammar,
    ),
    LintRule("duplicate-definition", "error", "one id or name for two definitions", references.duplicate_definition),
    LintRule("dangling-set", "error", "a reference to a type set or constant set in no file", references.dangling_set),
    LintRule("dangling-reference", "error", "a reference to a type that is not there", references.dangling_type),
    LintRule(
        "dangling-constant",
        "error",
        "a number that is not an expression of known constants",
        references.dangling_constant,
    ),
    LintRule("missing-parent", "error", "a service that inherits from one in no file", references.missing_parent),
    LintRule(
        "duplicate-message", "error", "two messages of a service under one id or name", messages.duplicate_message
    ),
    LintRule(
        "conflicting-message", "warning", "one id, different content in two services", messages.conflicting_message
    ),
    LintRule(
        "presence-vector", "error", "a presence vector too small for its optional members", fields.small_presence_vector
    ),
    LintRule("bit-range", "error", "bits beyond the type of the bit field", fields.bits_beyond_type),
    LintRule("bit-overlap", "error", "sub-fields that share bits", fields.overlapping_bits),
    LintRule("count-limits", "error", "limits of a count upside down or beyond its type", fields.count_limits),
    LintRule("missing-count", "warning", "a count without min_count or max_count", fields.missing_count),
    LintRule("unbounded-list", "error", "a list of items that may have no content", fields.unbounded_list),
    LintRule("tag-limits", "warning", "limits of a variant's tag that are not those of its arms", fields.tag_limits),
    LintRule("scale-limits", "error", "a scale with nothing between its limits", fields.scale_limits),
    LintRule("scale-type", "warning", "a scale that a float cannot follow", fields.scale_types),
    LintRule("unknown-unit", "warning", "a unit that JSIDL does not have", fields.unknown_unit),
    LintRule("value-range", "error", "a range of values upside down", fields.value_range_limits),
    LintRule("value-set", "error", "values that the type cannot carry", fields.values_beyond_type),
    LintRule("duplicate-value", "warning", "two names for one value", fields.duplicate_value),
    LintRule("duplicate-name", "error", "two members of one container under one name", fields.duplicate_name),
    LintRule("duplicate-index", "error", "two alternatives with one index", fields.duplicate_index),
    LintRule("dead-trigger", "error", "a transition that no input can fire", behavior.dead_trigger),
    LintRule("output-trigger", "warning", "a transition on a message that is only sent", behavior.output_trigger),
    LintRule(
        "shadowed-transition", "warning", "a transition that another one always precedes", shadows.shadowed_transition
    ),
    LintRule(
        "guard-parameter", "error", "a guard with a parameter that its transition lacks", behavior.guard_parameter
    ),
    LintRule("uncontrolled-command", "warning", "a command that any client may give", behavior.uncontrolled_command),
    LintRule("unknown-send", "error", "a Send of a message that is not an output", behavior.unknown_send),
    LintRule("unknown-state", "error", "a start, initial or end state that does not exist", behavior.unknown_state),
    LintRule("unreachable-state", "warning", "a state that nothing leads to", behavior.unreachable_state),
    LintRule("no-description", "hint", "a message or field without a description", messages.no_description),
)


def refused(context: LintContext) -> Iterator[Problem]:
    """Messages, events and behaviour that the loader rejects; other rules find most of them before."""
    for element, scope in context.elements("message_def", "event_def", "protocol_behavior"):
        if context.is_sound(element) and not context.too_deep:
            try:
                match element.tag:
                    case "message_def":
                        read_message(element, scope)
                    case "event_def":
                        read_event(element, scope)
                    case _:
                        read_behavior(element, ())
            except SchemaError as error:
                yield problem_of(error)
            except RecursionError:
                context.too_deep = True
                yield location(element), "refers to declared types too deeply; flatten them"


def refused_together(context: LintContext) -> Iterator[Problem]:
    """The mistake at which loading all files together stops, if there is one."""
    try:
        load_beside_builtin(context.paths)
    except SchemaError as error:
        yield problem_of(error)


REFUSED = LintRule("refused", "error", "anything else that the loader refuses", refused)
LAST = LintRule("refused", "error", "what the loader refuses when nothing else is wrong", refused_together)
UNREADABLE = "unreadable"


def lint(paths: Iterable[Path], rules: Sequence[LintRule] = RULES) -> list[LintFinding]:
    """All findings in these files, by location; they may refer to built-in definitions.

    A file that cannot be read at all is one finding with the code `unreadable`.
    """
    context = LintContext(paths)
    found = {
        LintFinding(error.file or "", error.line or 0, UNREADABLE, "error", error.reason)
        for error in context.unreadable
    }
    for rule in rules:
        found.update(_findings(rule, context))
    found.update(_in_other_lines(_findings(REFUSED, context), found))
    if not any(finding.severity == "error" for finding in found):
        found.update(_findings(LAST, context))
    checked = {str(path) for path in context.paths}
    return sorted(finding for finding in found if finding.file in checked)


def _in_other_lines(more: Iterable[LintFinding], found: Iterable[LintFinding]) -> list[LintFinding]:
    """The findings in lines without an earlier finding."""
    known = {(finding.file, finding.line) for finding in found if finding.severity == "error"}
    return [finding for finding in more if (finding.file, finding.line) not in known]


def _findings(rule: LintRule, context: LintContext) -> Iterable[LintFinding]:
    for where, message in rule.check(context):
        yield LintFinding(where.file, where.line, rule.code, rule.severity, message)
