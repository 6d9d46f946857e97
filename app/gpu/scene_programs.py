"""A scene's programs: of its texts as they stand, for what the scene decides at the values now."""

from collections.abc import Callable
from dataclasses import replace

import moderngl

from app import loops
from app.gpu.context import program
from app.gpu.stage_text import Programs, Source, is_made_of, needed, programs, typed_alone
from app.gpu.uniforms import on_gpu
from app.lesson import Surface
from app.shader import Assembled, Overrides

KEPT = 4  # choices whose programs are kept beside the present one's: of one scene they may take 10 MB each
MANY = 8  # surfaces for which each is worth a program of its own: they are compiled before the first picture
Pair = tuple[Assembled, Assembled | None]
Made = tuple[dict[str, moderngl.Program], Programs]  # programs, and the texts of those with a loop of the user's


class ScenePrograms:
    one_program = False  # for all surfaces, rather than one for each

    def __init__(self, ctx: moderngl.Context, source: Source, values: dict, forget: Callable[[moderngl.Program], None]):
        """`forget` is told what is about to be released."""
        self.ctx, self.source, self.scene = ctx, source, source.scene
        self.forget = forget
        self.now: dict[str, moderngl.Program] = {}
        self.watched: Programs = {}
        self.others: dict[tuple[int, ...], Made] = {}  # of other choices, the latest last
        self.passing: dict = {}  # made for edited texts and for later choices: released with the stage
        self.choice = dict.fromkeys(self.scene.decided, 0)  # what `now` is compiled for
        self.choice |= self.chosen(values)
        self.compile(None)

    # --- choices ---------------------------------------------------------------------------------------------------
    def chosen(self, values: dict) -> dict[str, int]:
        """Of these values what the scene decides; what they do not have stays."""
        values = on_gpu(self.scene, values)
        return {name: int(values.get(name, now)) for name, now in self.choice.items()}

    def decide(self, values: dict) -> bool:
        """Whether there are others for what is chosen now: compiled when it is chosen first, found again later."""
        choice = self.chosen(values)
        if choice == self.choice:
            return False
        before, self.choice = self.choice, choice
        self.others[tuple(before.values())] = self.now, self.watched
        seen = tuple(choice.values())
        if seen in self.others:
            self.now, self.watched = self.others.pop(seen)
        else:
            self.compile(None)
        if len(self.others) > KEPT:
            self.others.pop(next(iter(self.others)))
        self.let_go()
        return True

    def one_more(self) -> bool:
        """Where surfaces share a program, one of them gets its own. False: there is none left."""
        for i, surface in enumerate(self.scene.surfaces):
            use = program_of(surface)
            if use in self.now and f"{use} {i}" not in self.now:
                own, watched = self.made({f"{use} {i}": self.text(use, surface=i)})
                self.now, self.watched = self.now | own, self.watched | watched
                return True
        return False

    # --- texts -----------------------------------------------------------------------------------------------------
    def rewrite(self, overrides: Overrides, trial: Callable[[], None]) -> None:
        """Other texts in the scene. One that does not compile is a Problem, and so is one that fails in the `trial`;
        what was there before goes on. Programs without these texts are found again, not compiled."""
        before, runs = (self.source, self.now, self.watched, self.others), False
        self.source, self.others = replace(self.source, overrides=overrides), {}
        try:
            with self.ctx:
                if typed := typed_alone(self.source):  # a mistake counts also where it is not chosen now
                    program(self.ctx, *typed, (), self.passing)
                self.compile(None)
            trial()
            runs = True
        finally:
            if not runs:
                self.source, self.now, self.watched, self.others = before
            with self.ctx:
                self.let_go()

    def texts(self, names: tuple[str, ...] | None, known: dict[str, int] | None = None) -> Programs:
        """What is compiled, for the values that are `known`."""
        source = self.source
        return programs(self.scene, source.file, source.first, names=names, overrides=source.overrides, known=known,
                        watched=True)

    def text(self, name: str, **known: int) -> Pair:
        return self.texts((name,), self.choice | known)[name]

    # --- programs --------------------------------------------------------------------------------------------------
    def compile(self, names: tuple[str, ...] | None) -> None:
        """The named programs, or anew all that the scene has work for."""
        wanted = [self.wanted(name) for name in (needed(self.scene) if names is None else names)]
        found, watched = self.made({called: pair for each in wanted for called, pair in each.items()})
        self.now, self.watched = (found, watched) if names is None else (self.now | found, self.watched)

    def wanted(self, name: str) -> Programs:
        """The texts of the programs of that kind, by what each is called: one, or one for each surface.

        Its number is a constant then: a CPU (llvmpipe) runs both sides of every branch that stays, and so what the
        scene does for other surfaces would make its frames up to twice as slow. Of a text that is being edited no
        more than one program of a kind is compiled: a hand that types waits for it."""
        if name not in ("surface", "mesh") or self.one_program or len(self.scene.surfaces) > MANY:
            return {name: self.text(name)}
        each = {f"{name} {i}": self.text(name, surface=i) for i, surface in enumerate(self.scene.surfaces)
                if program_of(surface) == name}
        mine = [called for called, pair in each.items() if is_made_of(pair, self.source.overrides)]
        if len(mine) < 2:
            return each
        return {called: pair for called, pair in each.items() if called not in mine} | {name: self.text(name)}

    def made(self, wanted: Programs) -> Made:
        found: dict[str, moderngl.Program] = {}
        watched: Programs = {}
        passing = self.passing if self.source.overrides or self.others else None
        for called, pair in wanted.items():
            vertex, fragment = pair
            if has_loops(pair):
                watched[called] = pair
            values = () if fragment else ("value", "v_endless") if called in watched else ("value",)
            found[called] = program(self.ctx, vertex, fragment, values, passing)
        return found, watched

    def let_go(self) -> None:
        """Release the programs of its own that nothing here draws with."""
        kept = (self.now, *(made for made, _ in self.others.values()))
        used = {use for made in kept for use in made.values()}
        for key in [key for key, use in self.passing.items() if use not in used]:
            gone = self.passing.pop(key)
            self.forget(gone)
            gone.release()

    def release(self) -> None:
        for use in self.passing.values():
            use.release()


def program_of(surface: Surface) -> str:
    return "mesh" if surface.mesh else "surface"


def has_loops(pair: Pair) -> bool:
    """Whether a loop of the user's is counted in it."""
    return any(part and loops.COUNT in part.text for part in pair)
