"""A page's badges: what the desktop finds at the first values, and what the page needs to find them at others."""

from app import badges as judge
from app import furnace
from app.badges import SHORT, of_model, told
from app.export.web.texts import Data, Twins
from app.lesson import Model
from app.optics import arguments
from app.quadrature import gauss_legendre
from app.quantities import FROM_ANGLES

TILE = 5  # nodes of a tile along a side, of the page's own sums
SAME = 3e-6  # two ways around one of our float32 twins differ by up to 3e-7, other formulas by more
TILE = 5  # nodes along a side of a page's tile


def badges(model: Model, values: dict, twins: Twins) -> Data:
    """A model's badges at these values (float64), its twin, and the names of the values they change with."""
    used = [name for name in model_values(model) if name in values]
    return {"label": model.label, "ink": model.colour, "depends": used, "term": twins.term(model.term),
            "shading": model.is_shading, "linear": "radiance" in arguments(model.term.function),
            "found": [{"name": name, "short": SHORT[name], "ok": badge.ok, "told": told(name, badge)}
                      for name, badge in of_model(model, values).items()]}


def model_values(model: Model) -> list[str]:
    term = model.term
    named = [term.args.get(name, name) for name in arguments(term.function)]
    return [name for name in named if isinstance(name, str) and name not in FROM_ANGLES]


def rules() -> Data:
    """The directions at which badges look, their limits and their words: one source for desktop and page."""
    return {"views": judge.VIEWS.tolist(), "extremes": judge.EXTREMES.tolist(), "turns": judge.AROUND.tolist(),
            "seen": judge.SEEN, "same": SAME, "limit": judge.MOST, "radiances": judge.RADIANCES,
            "along": rule(furnace.FIRST[0]), "around": furnace.FIRST[1], "tile": rule(TILE),
            "narrowest": furnace.NARROWEST, "part": furnace.PART,
            "told": judge.TOLD, "unknown": judge.UNKNOWN, "names": judge.PLACES}


def rule(count: int) -> list[tuple[float, float]]:
    """Nodes and weights on [0, 1]."""
    nodes, weights = gauss_legendre(count)
    return list(zip(nodes.tolist(), weights.tolist(), strict=True))
