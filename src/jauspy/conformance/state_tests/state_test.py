"""One step made from JSIDL: a situation, an input, and whether what follows is one of the right outcomes."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has
from jauspy.conformance.results import Late, Malformed, Silent
from jauspy.conformance.state_tests.behaviour import Output, Prediction, Situation, Subject
from jauspy.conformance.state_tests.explorer import STATUS, Aftermath, Seen, Stimulus, Walker, walker_of
from jauspy.conformance.tester import CLIENTS, EVENTS, Tester
from jauspy.conformance.trace import Heard, named
from jauspy.errors import DecodeError

INIT, INITIALIZED = "Init", "Initialized"
"""A state that is left by itself, and the internal event that leaves it."""


@dataclass(frozen=True)
class Trial:
    """Callable as the action of a step."""

    subject: Subject
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
        swallowed = self.subject.machine.ignoring if self.stimulus.make else ""
        rule = prediction.rule or swallowed
        return self.subject.transition(rule) if rule else ""

    def __call__(self, tester: Tester) -> None:
        """Bring the component there, send, and look."""
        walker = walker_of(self.subject, tester)
        walker.reach(self.situation, self.path)
        try:
            self.stimulus.before(walker, self.role)
            seconds = self.stimulus.seconds(walker) if self.stimulus.seconds else 0.0
            made = self.stimulus.make(walker) if self.stimulus.make else None
            walker.quiet()
            nothing = f"{self.situation}: nothing takes {self.stimulus.message}"
            tester.why += [each.rule or nothing for each in self.predictions]
            walker.where = self.attempt(walker, made, seconds)
        finally:
            self.stimulus.after(walker, self.role)

    def attempt(self, walker: Walker, made: Message | None, seconds: float) -> Situation | None:
        """Send the input, if it is one that is sent, and look; where the component is then, when that is known."""
        if made is not None:
            walker.client(self.role).send(made, to=self.subject.component)
        return self._look(walker, seconds)

    def _look(self, walker: Walker, seconds: float) -> Situation | None:
        fitting = list(self.predictions)
        if len(fitting) == 1:
            self._taken(walker, fitting)
            self._expect(walker, fitting[0], seconds)
        else:
            fitting = self._compare(walker, seconds)
            self._taken(walker, fitting)
        self._end(walker, fitting)
        return fitting[0].after if len(fitting) == 1 else None

    def _taken(self, walker: Walker, fitting: list[Prediction]) -> None:
        """Note which transition this was, when that is clear."""
        names = {self._transition(each) for each in fitting} - {""}
        walker.tester.taken += names if len(names) == 1 else ()

    def _expect(self, walker: Walker, prediction: Prediction, seconds: float) -> None:
        """The outputs that were declared, and no others."""
        tester, began = walker.tester, walker.tester.now
        if not prediction.outputs and seconds:
            tester.wait(seconds * 1.05)
        within = 1.0 + seconds / tester.timeout
        for output in prediction.outputs:
            kind = self.subject.kind(output.message)
            client, component = walker.client(output.to), self.subject.component
            client.expect(kind, self._checks(kind, output), within=within, source=component)
        if prediction.outputs and self.stimulus.earliest:
            early = tester.now - began < self.stimulus.earliest * seconds
            tester.check("it does not come early", f"it came after {tester.now - began:.1f} s" if early else "")
        walker.look()
        extra = [name for role in CLIENTS for name in walker.client(role).unasked()]
        rule = "nothing else comes" if prediction.outputs else "there is no answer"
        walker.tester.expected.append(rule)
        walker.tester.check(rule, f"{', '.join(extra)} came, which is not declared here" if extra else "")

    def _checks(self, kind: type[Message], output: Output) -> list[Check]:
        checks = list(self.stimulus.checks.get(output.message, ()))
        codes = getattr(kind, "ResponseCode", None)
        if output.code and codes is not None and output.code in codes.__members__:
            checks += has(response_code=codes[output.code])
        return checks

    def _compare(self, walker: Walker, seconds: float) -> list[Prediction]:
        """The outcomes that fit what came, when the tester cannot know which one is right."""
        tester = walker.tester
        alternatives = " or ".join(
            dict.fromkeys(", ".join(out.message for out in each.outputs) or "no answer" for each in self.predictions)
        )
        tester.expected.append(alternatives)
        if all(each.outputs for each in self.predictions):
            self._await(walker, alternatives, seconds)
        walker.look()
        came = Counter((role, heard.code) for role in CLIENTS for heard in self._heard(walker, role))
        fitting = [each for each in self.predictions if self._wanted(each) == came]
        names = [walker.client(role).name_of(heard) for role in CLIENTS for heard in self._heard(walker, role)]
        problem = "" if fitting else f"{', '.join(names) or 'nothing'} came, and not {alternatives}"
        tester.check(f"what comes is {alternatives}", problem)
        for role in CLIENTS:
            for heard in self._heard(walker, role):
                self._readable(walker, heard)
                walker.client(role).pending.remove(heard)
        return fitting

    def _await(self, walker: Walker, alternatives: str, seconds: float) -> None:
        """One of several answers comes, and in time."""
        tester = walker.tester
        deadline = tester.now + tester.timeout + seconds
        tester.pump(2 * deadline - tester.now, lambda: any(self._heard(walker, role) for role in CLIENTS))
        times = [heard.at for role in CLIENTS for heard in self._heard(walker, role)]
        name = f"{alternatives} comes"
        tester.look(name, "" if times else "nothing came")
        if not times:
            raise Silent(f"neither {alternatives.replace(' or ', ' nor ')} came")
        late = min(times) - deadline
        tester.look(f"{name} in time", f"{late:.2f} s late" if late > 0 else "")
        if late > 0:
            raise Late(f"{alternatives} came {late:.2f} s after the deadline of {tester.timeout + seconds:g} s")

    def _wanted(self, prediction: Prediction) -> Counter[tuple[str, int]]:
        return Counter((output.to, self.subject.kind(output.message).CODE) for output in prediction.outputs)

    def _readable(self, walker: Walker, heard: Heard) -> None:
        kind = next(
            self.subject.kind(output.message)
            for each in self.predictions
            for output in each.outputs
            if heard.code == self.subject.kind(output.message).CODE
        )
        try:
            message = kind.decode(heard.payload)
        except DecodeError as error:
            walker.tester.look(f"{named(kind)} is as its definition says", str(error))
            raise Malformed(f"{named(kind)} from {heard.source} is malformed: {error}") from error
        for check in self.stimulus.checks.get(kind.NAME, ()):
            walker.tester.check(f"{named(kind)} {check.name}", check.problem(message))

    def _heard(self, walker: Walker, role: str) -> list[Heard]:
        return [
            each
            for each in walker.client(role).pending
            if each.source == self.subject.component and each.code not in EVENTS
        ]

    def _note_initialized(self, walker: Walker, after: Situation, seen: Seen) -> None:
        """Initialization ends by itself, and the state shows that."""
        if after.state[-1] == INIT and seen.status == STATUS["Standby"]:
            walker.tester.taken.append(self._internal(INITIALIZED, after))

    def _end(self, walker: Walker, fitting: list[Prediction]) -> None:
        """The state afterwards; and the effect, where it can be seen."""
        after = [each.after for each in fitting]
        seen = walker.settle(after[0])
        self._note_initialized(walker, after[0], seen)
        name = "the state is " + " or ".join(dict.fromkeys(map(str, after)))
        walker.tester.expected.append(name)
        right = any(walker.agrees(seen, each) for each in after)
        walker.tester.check(name, "" if right else f"afterwards the component reports {seen}; {name} was expected")
        if self.stimulus.verify is not None:

            def took(event: str) -> None:
                walker.tester.taken.append(self._internal(event, self.situation))

            self.stimulus.verify(Aftermath(walker, self.role, self.situation, fitting[0], took))
