"""The whole measurement: both arms without a load, with a tenth of the rated load, and with all of it."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from jauspy.cell.assembly import Assembler
from jauspy.cell.calibration import Parameters
from jauspy.cell.iso9283.bench import MISASSEMBLED, ModularArmBench, Plan, UR10Bench
from jauspy.cell.iso9283.characteristics import Drift, LaserTracker
from jauspy.cell.iso9283.loads import ARM_RATED, LOAD, UR10_RATED, with_bolted_load, with_load_part
from jauspy.cell.iso9283.results import Report, Run
from jauspy.cell.session import UNDISTURBED, simulated
from jauspy.cell.swing import ARM, BASE, TIP

WHOLE: Final = Plan()
"""As much as the standard requires."""
CALIBRATED: Final = "modular arm, calibrated"
SETTLE: Final = 0.1
"""Seconds until a prepared arm is known to all."""
LOADS: Final = (1.0, 0.1)
"""Fractions of the rated load, which are measured at the whole speed."""


async def measure(seed: int, plan: Plan = WHOLE, report: Callable[[str], None] = lambda _: None) -> Report:
    """Measure both arms, each with each load in a separate simulated cell."""
    tracker = LaserTracker(np.random.default_rng(seed))
    fastest = replace(plan, speeds=plan.speeds[:1])
    report("UR10")
    async with simulated(seed, UNDISTURBED) as session:
        bare = UR10Bench(session, tracker)
        ur10 = await bare.runs("UR10", plan, drifts=True)
        drifts = [("UR10", Drift(bare.drift))]
    for load in (UR10_RATED * part for part in LOADS):
        report(f"UR10, with {load:g} kg")
        async with simulated(seed, UNDISTURBED, change=partial(with_bolted_load, mass=load)) as session:
            ur10 += await UR10Bench(session, tracker, load).runs("UR10", fastest)
    async with _assembled(seed, tracker) as bench:
        report("modular arm, as it is assembled")
        before = await bench.run("modular arm", plan, on_path=False)
        report("modular arm, by the reports of its connectors")
        await bench.believe_connectors()
        reported = await bench.run("modular arm, reported", plan, on_path=False)
        report("calibration")
        parameters = await bench.calibrate(plan.samples)
        report(CALIBRATED)
        after = await bench.runs(CALIBRATED, plan, drifts=True)
        drifts.append((CALIBRATED, Drift(bench.drift)))
    for load in (ARM_RATED * part for part in LOADS):
        report(f"{CALIBRATED}, with {load:g} kg")
        after += await _loaded(seed, tracker, load, fastest, parameters)
    return Report(tuple(ur10), before, reported, tuple(after), parameters, tuple(drifts))


async def _loaded(seed: int, tracker: LaserTracker, load: float, plan: Plan, parameters: Parameters) -> list[Run]:
    """Runs of the modular arm with a load, by the calibration without it."""
    async with _assembled(seed, tracker, load) as bench:
        bench.believe(bench.library, parameters)
        return await bench.runs(CALIBRATED, plan)


@asynccontextmanager
async def _assembled(seed: int, tracker: LaserTracker, load: float = 0.0) -> AsyncIterator[ModularArmBench]:
    """The misassembled arm on its platform, with a load at its tip; the UR10 is parked."""
    change = partial(with_load_part, mass=load) if load else lambda model: model
    async with simulated(seed, UNDISTURBED, change=change) as session:
        session.true.prepare(BASE, ARM, MISASSEMBLED)
        if load:
            session.true.prepare(TIP, (LOAD,))
        await session.cell.sleep(SETTLE)
        ur10 = Assembler(session.cell, session.layout)
        ur10.at = await session.cell.posture()
        await ur10.park()
        yield ModularArmBench(session, tracker, seed, load)
