"""A study's quantity as an integral over the unit square: maps from (s, t) to what is summed there.

Each map returns values (N,) whose weighted sum over points of the square estimates the integral: the integrand times
the area (solid angle) that a piece of the square becomes.
"""

from collections.abc import Callable

import numpy as np
from numpy import pi

from app.hemisphere import NORMAL, around, frame
from app.lesson import Study, Term
from app.optics import arguments, twin
from app.optics.spherical import direction
from app.terms import bound, evaluate

VISIBLE = 380.0, 780.0  # nm


class Integral:
    def __init__(self, study: Study, values: dict):
        self.study, self.values = study, values
        self.theta_v = float(values[study.eye]) if study.eye in values else 0.0
        self.v = direction(self.theta_v, 0.0)
        self.evaluations = 0
        self.maps: dict[str, Callable[[np.ndarray, np.ndarray], np.ndarray]] = {
            "directions": {"uniform": self.uniform, "cosine": self.cosine, "angles": self.angles,
                           "importance": self.importance, "both": self.both, "half": self.half,
                           "mirror": self.mirror},
            "halfways": {"uniform": self.uniform, "cosine": self.cosine, "angles": self.angles,
                         "half": self.half_itself},
            "sphere": {"uniform": self.whole}, "angles": {"uniform": self.whole, "angles": self.whole_angles},
            "wavelengths": {"line": self.line}}.get(study.over, {})

    def at(self, **swept) -> np.ndarray:
        """The product of the twins."""
        name, some = next(iter(swept.items()))
        self.evaluations += np.size(some) // (3 if name in ("l", "h", "towards") else 1)
        if name == "h" and any("theta_h" in arguments(term.function) for term in self.study.integrand):
            swept["theta_h"] = np.arctan2(np.hypot(some[..., 0], some[..., 1]), some[..., 2])
        value = np.ones(())
        for term in self.study.integrand:
            value = value * evaluate(term, self.values, **swept)
        return value

    def above(self, way: np.ndarray) -> np.ndarray:
        """The integrand at directions (N, 3), without their cosine."""
        if self.study.over == "halfways":
            return self.at(h=way, n=NORMAL)
        if self.study.over == "sphere":
            return self.at(towards=way)
        return self.at(l=way, n=NORMAL, v=self.v)

    # --- the hemisphere ----------------------------------------------------------------------------------------------
    def uniform(self, s, t):
        z = 1 - s
        return 2 * pi * self.above(turned(z, np.sqrt(s * (2 - s)), t)) * z

    def cosine(self, s, t):
        return pi * self.above(turned(np.sqrt(1 - s), np.sqrt(s), t))

    def angles(self, s, t):
        theta = 0.5 * pi * s
        return pi * pi * self.above(turned(np.cos(theta), np.sin(theta), t)) * np.sin(theta) * np.cos(theta)

    def importance(self, s, t):
        """f n.l / pdf, of facets drawn from the distribution or of directions drawn about the mirror direction."""
        drawn = self.called(f"sample_{self.study.sampler}", xi_1=s, xi_2=t)
        if self.study.about == "mirror":
            l, e = self.around_mirror(drawn), self.values["exponent"]
            pdf = (e + 2) / (2 * pi) * np.exp((e + 1) * np.log(drawn[:, 2]))
        else:
            l = self.mirrored(drawn)
            pdf = self.called(f"pdf_{self.study.sampler}", n=NORMAL, l=l, v=self.v)
        return self.weighed(l, pdf)

    def both(self, s, t):
        """Half of the samples as `importance`, half by the cosine; each weighs 1 over the mean of both densities."""
        lobe = s < 0.5
        drawn = self.mirrored(self.called(f"sample_{self.study.sampler}", xi_1=2 * s[lobe], xi_2=t[lobe]))
        u = 2 * s[~lobe] - 1
        l = np.concatenate([drawn, turned(np.sqrt(1 - u), np.sqrt(u), t[~lobe])])
        pdf = self.called(f"pdf_{self.study.sampler}", n=NORMAL, l=l, v=self.v)
        found = np.empty(len(s))
        found[np.concatenate([np.nonzero(lobe)[0], np.nonzero(~lobe)[0]])] = self.weighed(
            l, 0.5 * (pdf + np.maximum(l[:, 2], 0) / pi))
        return found

    def weighed(self, l, pdf):
        good = (l[:, 2] > 0) & (pdf > 0)
        return np.where(good, self.above(l) * l[:, 2] / np.where(good, pdf, 1), 0.0)

    def half(self, s, t):
        """Even in psi, tan a = width tan psi, a the tilt of the halfway vector or the angle to the mirror direction."""
        h, area = self.tilted(s, t)
        if self.study.about == "mirror":
            l = self.around_mirror(h)
        else:
            l = self.mirrored(h)
            area = area * 4 * np.maximum(h @ self.v, 0)
        good = (l[:, 2] > 0) & (area > 0)
        return np.where(good, self.above(l) * l[:, 2] * area, 0.0)

    def mirror(self, s, t):
        """From the mirror direction along great circles to the horizon, denser towards it."""
        l, area = around(self.v * (-1, -1, 1), t, s, np.full(np.shape(s), self.wide))
        return self.above(l) * np.maximum(l[:, 2], 0) * area

    def half_itself(self, s, t):
        h, area = self.tilted(s, t)
        return self.above(h) * h[:, 2] * area

    def tilted(self, s, t):
        psi = 0.5 * pi * s
        slope = self.wide * np.tan(psi)
        cosine = 1 / np.sqrt(1 + slope * slope)
        sine = slope * cosine
        return turned(cosine, sine, t), pi * pi * sine * self.wide * (cosine / np.cos(psi)) ** 2

    @property
    def wide(self) -> float:
        """How wide the lobe is, in tan a or rad."""
        given = self.study.width
        if isinstance(given, Term):
            return float(evaluate(given, self.values))
        return float(self.values[given] if isinstance(given, str) else given)

    def mirrored(self, h):
        return 2 * (h @ self.v)[:, None] * h - self.v

    def around_mirror(self, way):
        pole = self.v * (-1, -1, 1)
        across, along = frame(pole)
        return way[:, :1] * across + way[:, 1:2] * along + way[:, 2:] * pole

    def called(self, name: str, **swept):
        names = arguments(name)
        same = {k: v for k, v in self.study.integrand[0].args.items() if k in names}  # it is drawn as it is integrated
        same |= {k: self.wide for k in names if k in ("m", "alpha")}
        return twin(name)(**bound(Term(name, same), self.values, **{k: v for k, v in swept.items() if k in names}))

    # --- the sphere and the spectrum ---------------------------------------------------------------------------------
    def whole(self, s, t):
        if self.study.over == "angles":
            return 4 * pi * self.at(theta=np.arccos(np.clip(1 - 2 * s, -1, 1)), phi=2 * pi * t - pi)
        return 4 * pi * self.above(turned(1 - 2 * s, 2 * np.sqrt(s * (1 - s)), t))

    def whole_angles(self, s, t):
        return 2 * pi * pi * self.at(theta=pi * s, phi=2 * pi * t - pi) * np.sin(pi * s)

    def line(self, s, t):
        low, high = VISIBLE
        return (high - low) * self.at(wavelength=low + (high - low) * s)


def turned(z, sine, t) -> np.ndarray:
    return np.stack([sine * np.cos(2 * pi * t), sine * np.sin(2 * pi * t), z + 0 * t], -1)
