"""What a study names: the twins it calls, the arguments it sweeps, the values of the step it depends on."""

from app.lesson import Method, Study, Term
from app.optics import arguments

SWEPT = {"directions": {"n", "l", "v"}, "halfways": {"n", "h", "theta_h"}, "sphere": {"towards"},
         "angles": {"theta", "phi"}, "wavelengths": {"wavelength"}}


def terms(study: Study) -> tuple[Term, ...]:
    """Every twin it calls."""
    exact = study.exact if isinstance(study.exact, tuple) else (study.exact,)
    given = (*exact, *study.methods, study.width)
    found = [one.term if isinstance(one, Method) else one for one in given]
    return (*study.integrand, *(term for term in found if isinstance(term, Term)))


def swept(study: Study) -> frozenset[str]:
    """Arguments of its twins that are no values of the step: directions, costs, seeds, the cosine of theta_v."""
    return frozenset(SWEPT.get(study.over, set()) | {method.cost for method in study.methods} | {"seed", "n_dot_v"})


def inputs(study: Study) -> frozenset[str]:
    """The values it depends on: not those that a method sets itself, as a cost, a seed or its kind."""
    found = {name for name in (study.width, study.exact) if isinstance(name, str) and name}
    for term in terms(study):  # a sampler draws from what is integrated, with its arguments
        given = [term.args.get(name, name) for name in arguments(term.function)]
        found |= {name for name in given if isinstance(name, str)}
    return frozenset((found | {study.eye} if study.eye and found & {"v", "n_dot_v"} else found) - swept(study))
