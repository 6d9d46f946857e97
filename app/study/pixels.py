"""The same study on the GPU: every pixel of a frame against the float64 closed form, as samples and frame time grow."""

from time import perf_counter

import numpy as np

from app.lesson import Study, Term
from app.study.measure import REPEATS, Report
from app.study.record import Line, Point, Record
from app.study.rules import is_random, ladder
from app.terms import evaluate

SIZE = 160, 120  # px
FLOOR = (-1.5, -1.5), (1.5, 1.5)  # m


def measure_pixels(study: Study, values: dict, budget: float, step: str = "", case: str = "",
                   report: Report = lambda: None) -> Record:
    """RMS error over the pixels, relative to the RMS of the exact ones; the time is that of a whole frame."""
    from app.gpu.frame import Frame

    begin = perf_counter()
    assert isinstance(study.exact, Term)
    methods = [m for m in study.methods if m.term is not None]
    lines = [Line(m.label, random=is_random(m), reference=m.term == study.exact) for m in methods]
    frames = [Frame(m.term.function, study.pixels, SIZE, *FLOOR, is_random(m)) for m in methods if m.term]
    right = evaluate(study.exact, values | {study.pixels: frames[0].places})
    scale = float(np.sqrt(np.mean(right**2)))
    record = Record(step, study.title, case, {k: v for k, v in values.items() if isinstance(v, int | float)},
                    {"mean over the floor": float(np.mean(right))}, lines, where="GPU", why=study.why)
    rungs = [list(ladder(m)) for m in methods]
    begin = perf_counter()  # the programs are compiled
    while any(rungs):
        for i, (method, line, frame) in enumerate(zip(methods, lines, frames, strict=True)):
            if not rungs[i]:
                continue
            left = budget - (perf_counter() - begin)
            wait = 4 * line.points[-1].time * REPEATS if line.points else 0.0
            if wait > left / sum(map(bool, rungs)):
                rungs[i], line.stopped = [], "the time was up"
                continue
            rung = rungs[i].pop(0)
            given = values | (method.term.args if method.term else {}) | ({method.cost: rung} if method.cost else {})
            frame.draw(given)  # warm
            times = []
            for _ in range(REPEATS):
                start = perf_counter()
                frame.draw(given)
                times.append(perf_counter() - start)
            error = float(np.sqrt(np.mean((frame.read() - right) ** 2))) / scale
            line.points.append(Point(rung, 4**rung if method.cost == "level" else rung, error, times))
            report()
    for frame in frames:
        frame.release()
    record.seconds = perf_counter() - begin
    return record
