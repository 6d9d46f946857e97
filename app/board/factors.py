"""The models of the course that are D G F over a denominator: which twins they are made of."""

from app.lesson import Term
from app.optics import arguments

LABELS = {"denominator": "4 (n·l)(n·v)", "denominator_printed": "π (n·l)(n·v)"}
OF = {  # model -> D, G, F and the denominator
    "cook_torrance": ("d_beckmann", "g_vgroove", "f_schlick", "denominator"),
    "cook_torrance_printed": ("d_beckmann", "g_vgroove", "f_schlick", "denominator_printed"),
    "cook_torrance_smith": ("d_beckmann", "g_smith_correlated", "f_schlick", "denominator"),
    "ggx": ("d_ggx", "g_smith_correlated_ggx", "f_schlick", "denominator"),
}
GIVEN = "n", "h", "n_dot_l", "n_dot_v", "n_dot_h", "l_dot_h"  # what follows from the angles


def factors(model: str, prefix: str = "") -> tuple[Term, ...]:
    """D, G, F and the denominator as terms; the model's parameters have a prefix. None of them: ()."""
    return tuple(Term(name, {a: prefix + a for a in arguments(name) if a not in GIVEN}) for name in OF.get(model, ()))


def labels(model: str) -> tuple[str, ...]:
    return tuple(LABELS.get(name, "DGF"[min(i, 2)]) for i, name in enumerate(OF.get(model, ())))


def call(term: Term) -> str:
    """The term as GLSL, where n, h and the cosines have their own names."""
    return f"{term.function}({', '.join(str(term.args.get(a, a)) for a in arguments(term.function))})"
