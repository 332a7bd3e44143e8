"""What a camera does on a machine that is too slow for it, step by step, and when it does all again."""

from __future__ import annotations

import pytest

from jauspy.platform.video_settings import VideoSettings
from jauspy.video.pace import FIRST_HOLD, WINDOW, Effort, Niceness, Pace, efforts, reduced_text

SETTINGS = VideoSettings(640, 480, 15)
STEPS = efforts(SETTINGS, 2)


class Machine:
    """Takes pictures at the pace that the policy allows, each in the time that this machine needs for it."""

    def __init__(self, pace: Pace, seconds: float) -> None:
        self.pace, self.seconds = pace, seconds
        """Of one whole picture of the best quality."""
        self.now = 0.0
        self.chosen: list[Effort] = []
        self.sent = 0

    def run(self, duration: float) -> None:
        end = self.now + duration
        while self.now < end:
            period = 1.0 / self.pace.effort.rate
            took = self.seconds * self.pace.effort.cost
            skipped = int(took / period)
            self.sent += 1
            began = self.now
            self.now = began + period * (1 + skipped)
            if self.pace.add(began + took, took, skipped):
                self.chosen.append(self.pace.effort)


def test_first_the_rate_falls_to_a_third_then_quality_then_size_and_then_the_rate_again() -> None:
    assert efforts(SETTINGS, 1) == (
        Effort(15),
        Effort(10),
        Effort(8),
        Effort(5),
        Effort(5, 1),
        Effort(5, 1, 2),
        Effort(5, 1, 4),
        Effort(2, 1, 4),
        Effort(1, 1, 4),
    )
    assert efforts(VideoSettings(128, 96, 1), 0) == (Effort(1),)


@pytest.mark.parametrize("rate", [1, 2, 15, 60])
@pytest.mark.parametrize("size", [(16, 16), (128, 96), (352, 288), (1920, 1200)])
def test_each_step_takes_less_time_and_the_last_one_is_a_picture_a_second(rate: int, size: tuple[int, int]) -> None:
    steps = efforts(VideoSettings(*size, rate), 2)
    loads = [step.rate * step.cost for step in steps]
    assert loads == sorted(set(loads), reverse=True)
    assert steps[-1].rate == 1
    assert all(size[0] // step.divisor >= min(size[0], 160) for step in steps)


def test_a_camera_that_keeps_its_rate_does_all_that_is_set() -> None:
    machine = Machine(Pace(STEPS), 0.05)
    machine.run(60.0)
    assert machine.chosen == []


@pytest.mark.parametrize(
    ("seconds", "effort"),
    [
        (0.078, Effort(10)),
        (0.095, Effort(8)),
        (0.15, Effort(5)),
        (0.25, Effort(5, 1)),
        (0.40, Effort(5, 2)),
        (0.65, Effort(5, 2, 2)),
        (2.0, Effort(2, 2, 4)),
        (30.0, Effort(1, 2, 4)),
    ],
)
def test_a_slow_machine_gets_the_first_step_that_it_can_do_after_one_window(seconds: float, effort: Effort) -> None:
    machine = Machine(Pace(STEPS), seconds)
    machine.run(WINDOW + 3 * seconds)
    assert machine.chosen == [effort]
    before, began = machine.sent, machine.now
    machine.run(60.0)
    assert machine.chosen == [effort], "it stays"
    if effort.rate * effort.cost * seconds < 1.0:
        assert (machine.sent - before) / (machine.now - began) == pytest.approx(effort.rate, rel=0.1)


def test_a_machine_that_is_free_again_gets_all_after_a_while() -> None:
    machine = Machine(Pace(STEPS), 0.65)
    machine.run(2 * WINDOW)
    machine.seconds = 0.02
    machine.run(FIRST_HOLD)
    assert machine.chosen == [Effort(5, 2, 2)], "not at once"
    machine.run(2 * WINDOW)
    assert machine.chosen[1:] == [Effort(15)]


def test_a_machine_at_the_limit_goes_back_and_forth_less_and_less_often() -> None:
    """Other cameras take more of the processor as soon as this one does: what was free is not."""
    pace = Pace(STEPS)
    machine = Machine(pace, 0.0)
    for _ in range(3000):
        machine.seconds = 0.2 if pace.effort.rate > 5 else 0.03
        machine.run(0.2)
    ups = sum(effort == Effort(15) for effort in machine.chosen)
    assert 3 <= ups <= 6


def test_pictures_left_out_before_the_first_one_and_in_a_pause_do_not_count() -> None:
    pace = Pace(STEPS)
    assert not pace.add(0.0, 5.0, 100)
    pace.restart()
    assert not pace.add(1000.0, 1.0, 500)
    machine = Machine(pace, 0.01)
    machine.now = 1000.1
    machine.run(3 * WINDOW)
    assert machine.chosen == []


def test_the_sentence_has_what_is_sent_and_what_was_set() -> None:
    assert reduced_text("arm", SETTINGS, Effort(15)) == ""
    assert reduced_text("arm", SETTINGS, Effort(5, 0, 2)) == (
        "the robot's machine is too slow for camera arm: 320x240 at 5/s instead of 640x480 at 15/s"
    )
    assert "640x480 at 5/s, of lower quality, instead of" in reduced_text("arm", SETTINGS, Effort(5, 1))


class Processor:
    """Shared by weight with `others` that are as nice as the robot and always busy."""

    def __init__(self, niceness: Niceness, others: float) -> None:
        self.niceness, self.others = niceness, others
        self.now = 0.0
        self.chosen: list[int] = []

    def run(self, duration: float, *, skipped: int = 1) -> None:
        end = self.now + duration
        while self.now < end:
            weight = 1.25**-self.niceness.niceness
            share = weight / (weight + self.others)
            self.now += 0.02 / share
            if self.niceness.add(self.now, 0.02, 0.02 / share - 0.02, skipped if share < 0.3 else 0):
                self.chosen.append(self.niceness.niceness)


def test_a_camera_begins_a_little_nicer_than_control_and_gets_nicer_as_long_as_it_gets_its_share() -> None:
    processor = Processor(Niceness(15), 0.0)
    assert processor.niceness.niceness == 3
    processor.run(10.0)
    assert processor.chosen == [8, 13, 15]


def test_a_camera_that_others_leave_nothing_is_less_nice_but_nicer_than_control() -> None:
    processor = Processor(Niceness(15), 0.0)
    processor.run(60.0)
    processor.others = 9.0
    processor.run(120.0)
    assert processor.chosen == [8, 13, 15, 13, 8, 3]
    processor.others = 0.0
    processor.run(10.0)
    assert processor.niceness.niceness == 15


def test_it_takes_no_more_than_it_needs() -> None:
    processor = Processor(Niceness(15), 0.0)
    processor.run(60.0)
    processor.others = 1.0
    processor.run(20.0)
    assert processor.niceness.niceness == 8
    calm = Processor(Niceness(15), 0.0)
    calm.run(60.0)
    calm.others = 9.0
    calm.run(20.0, skipped=0)
    assert calm.niceness.niceness == 15, "no picture is missing"


def test_a_try_to_be_nicer_that_starves_is_repeated_less_and_less_often() -> None:
    processor = Processor(Niceness(15), 0.4)
    processor.run(600.0)
    assert processor.chosen.count(13) + processor.chosen.count(15) < 20


def test_no_niceness_at_all() -> None:
    processor = Processor(Niceness(0), 9.0)
    processor.run(10.0)
    assert processor.chosen == []
