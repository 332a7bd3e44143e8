"""One step made from JSIDL: a situation, an input, and whether what follows is one of the right outcomes."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has
from jauspy.conformance.results import Late, Malformed, Silent
from jauspy.conformance.state_tests.behaviour import ComponentUnderTest, Output, Prediction, Situation
from jauspy.conformance.state_tests.explorer import (
    STATUS,
    Explorer,
    ObservedState,
    Stimulus,
    StimulusResult,
    explorer_of,
)
from jauspy.conformance.tester import CLIENTS, EVENTS, Tester
from jauspy.conformance.trace import ReceivedMessage, message_name
from jauspy.errors import DecodeError

INIT, INITIALIZED = "Init", "Initialized"
"""A state that is left by itself, and the internal event that leaves it."""


@dataclass(frozen=True)
class StateTest:
    """Callable as the action of a step."""

    subject: ComponentUnderTest
    situation: Situation
    path: tuple[tuple[str, str], ...]
    stimulus: Stimulus
    role: str

    @cached_property
    def predictions(self) -> tuple[Prediction, ...]:
        """All right outcomes."""
        judge = self.stimulus.judge(self.role)
        return self.subject.machine.predict(self.situation, self.stimulus.message, self.role, judge)

    @property
    def transitions(self) -> tuple[str, ...]:
        """Those that may be taken, with the id of the component."""
        found = [name for each in self.predictions if (name := self._transition(each))]
        found += [self._internal(event, self.situation) for event in self.stimulus.also]
        found += [self._internal(INITIALIZED, each.after) for each in self.predictions if each.after.state[-1] == INIT]
        return tuple(dict.fromkeys(found))

    def _internal(self, event: str, where: Situation) -> str:
        """The transition that takes an internal event there."""
        (first, *_) = self.subject.machine.predict(where, event, self.role, lambda *_: None)
        return self.subject.transition(first.rule)

    def _transition(self, prediction: Prediction) -> str:
        ignored = self.subject.machine.ignoring if self.stimulus.make else ""
        rule = prediction.rule or ignored
        return self.subject.transition(rule) if rule else ""

    def __call__(self, tester: Tester) -> None:
        """Bring the component to the situation, send the input, and check the outcome."""
        explorer = explorer_of(self.subject, tester)
        explorer.reach(self.situation, self.path)
        try:
            self.stimulus.before(explorer, self.role)
            seconds = self.stimulus.seconds(explorer) if self.stimulus.seconds else 0.0
            made = self.stimulus.make(explorer) if self.stimulus.make else None
            explorer.quiet()
            nothing = f"{self.situation}: nothing takes {self.stimulus.message}"
            tester.why += [each.rule or nothing for each in self.predictions]
            explorer.where = self.attempt(explorer, made, seconds)
        finally:
            self.stimulus.after(explorer, self.role)

    def attempt(self, explorer: Explorer, made: Message | None, seconds: float) -> Situation | None:
        """Send the input, if it is one that is sent, and look; where the component is then, when that is known."""
        if made is not None:
            explorer.client(self.role).send(made, to=self.subject.component)
        return self._look(explorer, seconds)

    def _look(self, explorer: Explorer, seconds: float) -> Situation | None:
        fitting = list(self.predictions)
        if len(fitting) == 1:
            self._taken(explorer, fitting)
            self._expect(explorer, fitting[0], seconds)
        else:
            fitting = self._compare(explorer, seconds)
            self._taken(explorer, fitting)
        self._end(explorer, fitting)
        return fitting[0].after if len(fitting) == 1 else None

    def _taken(self, explorer: Explorer, fitting: list[Prediction]) -> None:
        """Record which transition was taken, if only one fits."""
        names = {self._transition(each) for each in fitting} - {""}
        explorer.tester.taken += names if len(names) == 1 else ()

    def _expect(self, explorer: Explorer, prediction: Prediction, seconds: float) -> None:
        """The outputs that were declared, and no others."""
        tester, began = explorer.tester, explorer.tester.now
        if not prediction.outputs and seconds:
            tester.wait(seconds * 1.05)
        within = 1.0 + seconds / tester.timeout
        for output in prediction.outputs:
            kind = self.subject.kind(output.message)
            client, component = explorer.client(output.to), self.subject.component
            client.expect(kind, self._checks(kind, output), within=within, source=component)
        if prediction.outputs and self.stimulus.earliest:
            early = tester.now - began < self.stimulus.earliest * seconds
            tester.check("it does not come early", f"it came after {tester.now - began:.1f} s" if early else "")
        explorer.observe()
        extra = [name for role in CLIENTS for name in explorer.client(role).unasked()]
        rule = "nothing else comes" if prediction.outputs else "there is no answer"
        explorer.tester.expected.append(rule)
        explorer.tester.check(rule, f"{', '.join(extra)} came, which is not declared here" if extra else "")

    def _checks(self, kind: type[Message], output: Output) -> list[Check]:
        checks = list(self.stimulus.checks.get(output.message, ()))
        codes = getattr(kind, "ResponseCode", None)
        if output.code and codes is not None and output.code in codes.__members__:
            checks += has(response_code=codes[output.code])
        return checks

    def _compare(self, explorer: Explorer, seconds: float) -> list[Prediction]:
        """The outcomes that fit what came, when the tester cannot know which one is right."""
        tester = explorer.tester
        alternatives = " or ".join(
            dict.fromkeys(", ".join(out.message for out in each.outputs) or "no answer" for each in self.predictions)
        )
        tester.expected.append(alternatives)
        if all(each.outputs for each in self.predictions):
            self._await(explorer, alternatives, seconds)
        explorer.observe()
        came = Counter((role, heard.code) for role in CLIENTS for heard in self._heard(explorer, role))
        fitting = [each for each in self.predictions if self._wanted(each) == came]
        names = [explorer.client(role).name_of(heard) for role in CLIENTS for heard in self._heard(explorer, role)]
        problem = "" if fitting else f"{', '.join(names) or 'nothing'} came, and not {alternatives}"
        tester.check(f"what comes is {alternatives}", problem)
        for role in CLIENTS:
            for heard in self._heard(explorer, role):
                self._readable(explorer, heard)
                explorer.client(role).pending.remove(heard)
        return fitting

    def _await(self, explorer: Explorer, alternatives: str, seconds: float) -> None:
        """One of several answers comes, and in time."""
        tester = explorer.tester
        deadline = tester.now + tester.timeout + seconds
        tester.pump(2 * deadline - tester.now, lambda: any(self._heard(explorer, role) for role in CLIENTS))
        times = [heard.at for role in CLIENTS for heard in self._heard(explorer, role)]
        name = f"{alternatives} comes"
        tester.record_check(name, "" if times else "nothing came")
        if not times:
            raise Silent(f"neither {alternatives.replace(' or ', ' nor ')} came")
        late = min(times) - deadline
        tester.record_check(f"{name} in time", f"{late:.2f} s late" if late > 0 else "")
        if late > 0:
            raise Late(f"{alternatives} came {late:.2f} s after the deadline of {tester.timeout + seconds:g} s")

    def _wanted(self, prediction: Prediction) -> Counter[tuple[str, int]]:
        return Counter((output.to, self.subject.kind(output.message).CODE) for output in prediction.outputs)

    def _readable(self, explorer: Explorer, heard: ReceivedMessage) -> None:
        kind = next(
            self.subject.kind(output.message)
            for each in self.predictions
            for output in each.outputs
            if heard.code == self.subject.kind(output.message).CODE
        )
        try:
            message = kind.decode(heard.payload)
        except DecodeError as error:
            explorer.tester.record_check(f"{message_name(kind)} is as its definition says", str(error))
            raise Malformed(f"{message_name(kind)} from {heard.source} is malformed: {error}") from error
        for check in self.stimulus.checks.get(kind.NAME, ()):
            explorer.tester.check(f"{message_name(kind)} {check.name}", check.problem(message))

    def _heard(self, explorer: Explorer, role: str) -> list[ReceivedMessage]:
        return [
            each
            for each in explorer.client(role).pending
            if each.source == self.subject.component and each.code not in EVENTS
        ]

    def _note_initialized(self, explorer: Explorer, after: Situation, seen: ObservedState) -> None:
        """Initialization ends by itself, and the state shows that."""
        if after.state[-1] == INIT and seen.status == STATUS["Standby"]:
            explorer.tester.taken.append(self._internal(INITIALIZED, after))

    def _end(self, explorer: Explorer, fitting: list[Prediction]) -> None:
        """The state afterwards; and the effect, where it can be seen."""
        after = [each.after for each in fitting]
        seen = explorer.settle(after[0])
        self._note_initialized(explorer, after[0], seen)
        name = "the state is " + " or ".join(dict.fromkeys(map(str, after)))
        explorer.tester.expected.append(name)
        right = any(explorer.agrees(seen, each) for each in after)
        explorer.tester.check(name, "" if right else f"afterwards the component reports {seen}; {name} was expected")
        if self.stimulus.verify is not None:

            def took(event: str) -> None:
                explorer.tester.taken.append(self._internal(event, self.situation))

            self.stimulus.verify(StimulusResult(explorer, self.role, self.situation, fitting[0], took))
