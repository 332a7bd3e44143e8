"""One step made from JSIDL: a situation, an input, and a check that the outcome is a right one."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has
from jauspy.conformance.results import Late, Malformed, Silent
from jauspy.conformance.state_tests.behaviour import INITIALIZED, ComponentUnderTest, Output, Prediction, Situation
from jauspy.conformance.state_tests.explorer import (
    STATUS,
    Explorer,
    Stimulus,
    StimulusResult,
    explorer_of,
)
from jauspy.conformance.steering import ObservedState, Path, judged_at_pace
from jauspy.conformance.tester import CLIENTS, EVENTS, Tester
from jauspy.conformance.trace import ReceivedMessage, message_name
from jauspy.errors import DecodeError

INIT: Final = "Init"
"""The state of initialization."""


@dataclass(frozen=True)
class StateTest:
    """One generated step; its instance is the action of the step."""

    subject: ComponentUnderTest
    situation: Situation
    path: Path
    stimulus: Stimulus
    role: str

    @cached_property
    def predictions(self) -> tuple[Prediction, ...]:
        """All right outcomes."""
        judge = self.stimulus.judge(self.role)
        return self.subject.machine.predict(self.situation, self.stimulus.message, self.role, judge)

    @cached_property
    def _unsolicited(self) -> frozenset[int]:
        """The ids of messages that may come, and that no right outcome has."""
        predicted = {output.message for prediction in self.predictions for output in prediction.outputs}
        besides = self.subject.unsolicited | {self.subject.kind(name).CODE for name in self.stimulus.may_send}
        return besides - {self.subject.kind(name).CODE for name in predicted}

    @property
    def transitions(self) -> tuple[str, ...]:
        """Names of the transitions that may be taken, with the id of the component."""
        found = [name for prediction in self.predictions if (name := self._transition(prediction))]
        found += [self._internal(event, self.situation) for event in self.stimulus.also]
        found += [
            self._internal(INITIALIZED, prediction.after)
            for prediction in self.predictions
            if prediction.after.state[-1] == INIT
        ]
        return tuple(dict.fromkeys(found))

    def _internal(self, event: str, where: Situation) -> str:
        """Name of the transition that an internal event triggers in a situation."""
        (first, *_) = self.subject.machine.predict(where, event, self.role, lambda *_: None)
        return self.subject.transition(first.rule)

    def _transition(self, prediction: Prediction) -> str:
        ignored = self.subject.machine.ignoring if self.stimulus.make else ""
        rule = prediction.rule or ignored
        return self.subject.transition(rule) if rule else ""

    def __call__(self, tester: Tester) -> None:
        """Bring the component to the situation, send the input, and check the outcome."""
        explorer = explorer_of(self.subject, tester)
        judged_at_pace(
            tester, lambda: explorer.reach(self.situation, self.path), lambda: self._send_and_check(explorer)
        )

    def _send_and_check(self, explorer: Explorer) -> None:
        """Send the input in the situation, and check the outcome."""
        with explorer.silences.of_input(self.stimulus.message, str(self.situation)):
            self._try(explorer)

    def _try(self, explorer: Explorer) -> None:
        tester = explorer.tester
        try:
            self.stimulus.before(explorer, self.role)
            seconds = self.stimulus.seconds(explorer) if self.stimulus.seconds else 0.0
            made = self.stimulus.make(explorer) if self.stimulus.make else None
            explorer.discard_received()
            nothing = f"{self.situation}: nothing takes {self.stimulus.message}"
            tester.why += [prediction.rule or nothing for prediction in self.predictions]
            explorer.where = self.attempt(explorer, made, seconds)
        finally:
            self.stimulus.after(explorer, self.role)

    def attempt(self, explorer: Explorer, made: Message | None, seconds: float) -> Situation | None:
        """Send the input, if it is a message, and check the outcome. Returns the situation afterwards, if known."""
        if made is not None:
            explorer.client(self.role).send(made, to=self.subject.component)
        return self._check_outcome(explorer, seconds)

    def _check_outcome(self, explorer: Explorer, seconds: float) -> Situation | None:
        fitting = list(self.predictions)
        if len(fitting) == 1:
            self._taken(explorer, fitting)
            self._expect(explorer, fitting[0], seconds)
        else:
            fitting = self._compare(explorer, seconds)
            self._taken(explorer, fitting)
        self._check_state(explorer, fitting)
        return fitting[0].after if len(fitting) == 1 else None

    def _taken(self, explorer: Explorer, fitting: list[Prediction]) -> None:
        """Record which transition was taken, if only one fits."""
        names = {self._transition(row) for row in fitting} - {""}
        explorer.tester.taken += names if len(names) == 1 else ()

    def _expect(self, explorer: Explorer, prediction: Prediction, seconds: float) -> None:
        """Check that the predicted outputs arrive, and no others."""
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
        extra = [name for role in CLIENTS for name in explorer.client(role).unasked(self._unsolicited)]
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
        """Return the outcomes that fit the received messages, if several outcomes are right."""
        tester = explorer.tester
        alternatives = " or ".join(
            dict.fromkeys(
                ", ".join(out.message for out in prediction.outputs) or "no answer" for prediction in self.predictions
            )
        )
        tester.expected.append(alternatives)
        if all(prediction.outputs for prediction in self.predictions):
            self._await(explorer, alternatives, seconds)
        explorer.observe()
        came = Counter((role, received.code) for role in CLIENTS for received in self._answers(explorer, role))
        fitting = [prediction for prediction in self.predictions if self._expected_counts(prediction) == came]
        names = [
            explorer.client(role).name_of(received) for role in CLIENTS for received in self._answers(explorer, role)
        ]
        problem = "" if fitting else f"{', '.join(names) or 'nothing'} came, and not {alternatives}"
        tester.check(f"what comes is {alternatives}", problem)
        for role in CLIENTS:
            for received in self._answers(explorer, role):
                self._check_answer(explorer, received)
                explorer.client(role).pending.remove(received)
        return fitting

    def _await(self, explorer: Explorer, alternatives: str, seconds: float) -> None:
        """Wait for one of several answers, and check that it is in time."""
        tester = explorer.tester
        deadline = tester.now + tester.timeout + seconds
        tester.pump(2 * deadline - tester.now, lambda: any(self._answers(explorer, role) for role in CLIENTS))
        times = [received.at for role in CLIENTS for received in self._answers(explorer, role)]
        name = f"{alternatives} comes"
        tester.record_check(name, "" if times else "nothing came")
        if not times:
            raise Silent(f"neither {alternatives.replace(' or ', ' nor ')} came")
        late = min(times) - deadline
        tester.record_check(f"{name} in time", f"{late:.2f} s late" if late > 0 else "")
        if late > 0:
            raise Late(f"{alternatives} came {late:.2f} s after the deadline of {tester.timeout + seconds:g} s")

    def _expected_counts(self, prediction: Prediction) -> Counter[tuple[str, int]]:
        return Counter((output.to, self.subject.kind(output.message).CODE) for output in prediction.outputs)

    def _check_answer(self, explorer: Explorer, received: ReceivedMessage) -> None:
        kind = next(
            self.subject.kind(output.message)
            for prediction in self.predictions
            for output in prediction.outputs
            if received.code == self.subject.kind(output.message).CODE
        )
        try:
            message = kind.decode(received.payload)
        except DecodeError as error:
            explorer.tester.record_check(f"{message_name(kind)} is as its definition says", str(error))
            raise Malformed(f"{message_name(kind)} from {received.source} is malformed: {error}") from error
        for check in self.stimulus.checks.get(kind.NAME, ()):
            explorer.tester.check(f"{message_name(kind)} {check.name}", check.problem(message))

    def _answers(self, explorer: Explorer, role: str) -> list[ReceivedMessage]:
        return [
            packet
            for packet in explorer.client(role).pending
            if packet.source == self.subject.component and packet.code not in EVENTS | self._unsolicited
        ]

    def _note_initialized(self, explorer: Explorer, after: Situation, seen: ObservedState) -> None:
        """Record the end of initialization if the state shows it."""
        if after.state[-1] == INIT and seen.status == STATUS["Standby"]:
            explorer.tester.taken.append(self._internal(INITIALIZED, after))

    def _check_state(self, explorer: Explorer, fitting: list[Prediction]) -> None:
        """Check the state afterwards, and the effect if it is visible."""
        after = [row.after for row in fitting]
        seen = explorer.settle(*after)
        self._note_initialized(explorer, after[0], seen)
        name = "the state is " + " or ".join(dict.fromkeys(map(str, after)))
        explorer.tester.expected.append(name)
        right = any(explorer.agrees(seen, state) for state in after)
        explorer.tester.check(name, "" if right else f"afterwards the component reports {seen}; {name} was expected")
        if self.stimulus.verify is not None:

            def took(event: str) -> None:
                explorer.tester.taken.append(self._internal(event, self.situation))

            self.stimulus.verify(StimulusResult(explorer, self.role, self.situation, fitting[0], took))
