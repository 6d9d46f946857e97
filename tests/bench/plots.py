"""From a slider's move to the plot's picture, through the process that draws it."""

from app import catalog
from app.export.still import data
from app.plots.process import PlotProcess
from app.state import defaults
from app.theme import THEMES
from tests.bench.rows import Row, in_turn, timed

SIZE = (420, 420)


def plots(rounds: int = 12) -> list[Row]:
    """The first step's plot is the reference; every plot of every step."""
    with PlotProcess(SIZE, THEMES["dark"]) as process:
        def move(step, plot) -> None:
            values = defaults(step)
            move.count += 1
            share = 0.3 + 0.4 * (move.count % 97) / 97
            if "eye" in values:
                values["eye"] = (share, 0.0, 0.0)
            else:
                name = next(name for name, value in values.items() if isinstance(value, float))
                spec = step.values[name]
                values[name] = spec.low + (spec.high - spec.low) * share
            more = data(step, values)
            triangles = more.pop("triangles", None)
            process.request(plot, values | more, triangles=triangles, fine=False)
            process.wait(30.0)

        move.count = 0

        def once(step, plot) -> float:
            move(step, plot)  # to this plot; what is measured is the next move
            return timed(lambda: move(step, plot))()

        jobs = {f"{step.id}, {plot.title}, after a move": lambda step=step, plot=plot: once(step, plot)
                for step in catalog.steps() for plot in step.step.plots}
        return in_turn(jobs, rounds, asked=dict.fromkeys(jobs, 60.0))
