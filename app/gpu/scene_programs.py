"""A scene's programs: of its texts as they stand, for what is decided at the values now."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import moderngl

from app import loops
from app.gpu.context import program
from app.gpu.scene_texts import SceneTexts
from app.gpu.stage_text import KINDS, Pair, Programs, Source, needed, reads, typed_alone
from app.gpu.uniforms import on_gpu
from app.lesson import Surface
from app.shader import Overrides

KEPT = 4  # choices whose programs are kept beside the present one's: of one scene they may take 10 MB each
MANY = 8  # surfaces for which each is worth a program of its own: they are compiled before the first picture


@dataclass(frozen=True)
class Made:
    """Programs by what they are called, their texts, those with a loop of the user's, what draws each surface."""

    programs: dict[str, moderngl.Program] = field(default_factory=dict)
    texts: Programs = field(default_factory=dict)
    watched: Programs = field(default_factory=dict)
    drawn_by: dict[int, str] = field(default_factory=dict)

    def __or__(self, more: "Made") -> "Made":
        return Made(self.programs | more.programs, self.texts | more.texts, self.watched | more.watched,
                    self.drawn_by | more.drawn_by)


class ScenePrograms:
    kind_of_texts: type[SceneTexts] = SceneTexts
    one_program = False  # for all surfaces, rather than one for each

    def __init__(self, ctx: moderngl.Context, source: Source, values: dict, forget: Callable[[moderngl.Program], None]):
        """`forget` is told what is about to be released."""
        self.ctx, self.scene, self.texts = ctx, source.scene, self.kind_of_texts(source)
        self.forget = forget
        self.made = Made()
        self.others: dict[tuple[int, ...], Made] = {}  # of other choices, the latest last
        self.passing: dict = {}  # made for edited texts and for later choices: released with the stage
        self.seen = dict.fromkeys((*self.scene.decided, *reads(source)), 0)  # choices as they are now
        self.see(values)
        self.compile()

    @property
    def source(self) -> Source:
        return self.texts.source

    # --- choices ---------------------------------------------------------------------------------------------------
    @property
    def decided(self) -> dict[str, int]:
        """Of the choices now what the scene decides."""
        return {name: self.seen[name] for name in self.scene.decided}

    @property
    def choice(self) -> dict[str, int]:
        """What its programs are compiled for: of a text that is being edited for every choice. The less is left of
        it, the sooner it is compiled, and compiled it is at every key."""
        return self.seen if self.source.overrides else self.decided

    def see(self, values: dict) -> None:
        """What these values choose; what they do not have stays."""
        values = on_gpu(self.scene, values)
        self.seen = {name: int(values.get(name, now)) for name, now in self.seen.items()}

    def decide(self, values: dict) -> bool:
        """Whether there are others for what is chosen now: compiled when it is chosen first, found again later."""
        before = tuple(self.choice.values())
        self.see(values)
        now = tuple(self.choice.values())
        if now == before:
            return False
        self.others[before] = self.made
        if now in self.others:
            self.made = self.others.pop(now)
        else:
            self.compile()
        if len(self.others) > KEPT:
            self.others.pop(next(iter(self.others)))
        self.let_go()
        return True

    def rewrite(self, overrides: Overrides, trial: Callable[[], None]) -> None:
        """Other texts in the scene. One that does not compile is a Problem, and so is one that fails in the `trial`;
        what was there before goes on. Programs without these texts are found again, not compiled."""
        before, runs = (self.source, self.made, self.others), False
        self.texts.source, self.others = replace(self.source, overrides=overrides), {}
        try:
            with self.ctx:
                for pair in typed_alone(self.source):  # a mistake counts also where it is not chosen now
                    program(self.ctx, *pair, (), self.passing)
                self.compile()
            trial()
            runs = True
        finally:
            if not runs:
                self.texts.source, self.made, self.others = before
            with self.ctx:
                self.let_go()

    # --- programs --------------------------------------------------------------------------------------------------
    def compile(self) -> None:
        """All that the scene has work for."""
        wanted = {name: self.pair(name) for name in needed(self.scene) if name not in KINDS}
        drawn_by: dict[int, str] = {}
        for called, surfaces in self.shared().items():
            kinds = {program_of(self.scene.surfaces[i]) for i in surfaces}
            wanted[called] = self.pair(kinds.pop() if len(kinds) == 1 else "either",
                                       () if self.one_program else surfaces)
            drawn_by |= dict.fromkeys(surfaces, called)
        self.made = self.of(wanted, drawn_by)

    def pair(self, name: str, surfaces: tuple[int, ...] = ()) -> Pair:
        return self.texts.pair(name, surfaces, self.decided, self.choice)

    def add(self, name: str) -> None:
        """One more kind of program, for all surfaces."""
        if name not in self.made.programs:
            self.made = self.made | self.of({name: self.pair(name)}, {})

    def shared(self) -> dict[str, tuple[int, ...]]:
        """Which surfaces share a program, by what it is called.

        Where they are few each has its own, with its number as a constant: a CPU (llvmpipe) runs both sides of every
        branch that stays, and so what the scene does for other surfaces would make its frames up to twice as slow. Of
        a text that is being edited as little as possible is compiled, as a hand that types waits for it: one program
        for all surfaces that run it at their corners, and one for those that run it at their pixels. These are solid
        ones alone or ones that one looks through, for a program is compiled anew for the other way of drawing."""
        found: dict[str, tuple[int, ...]] = {}
        for i, surface in enumerate(self.scene.surfaces):
            kind = called = program_of(surface)
            if not self.is_shown(surface):
                continue
            if not self.one_program:
                glass, typed = " glass" * (surface.opacity < 1), self.texts.typed_in(kind, i, self.choice)
                is_few = len(self.scene.surfaces) <= MANY or (self.source.overrides and self.has_own(i))
                called = f"{kind} {i}" if is_few else kind + glass
                if typed:
                    called = f"typed {', '.join(typed)}{glass * ('pixels' in typed)}"
            found[called] = *found.get(called, ()), i
        return {f"{program_of(self.scene.surfaces[which[0]])} {which[0]}" if len(which) == 1 and not self.one_program
                else called: which for called, which in found.items()}

    def is_shown(self, surface: Surface) -> bool:
        """Whether it is drawn at what is decided now."""
        name, number = surface.where or ("", 0)
        return self.choice.get(name, number) == number

    def has_own(self, i: int) -> bool:
        return self.made.drawn_by.get(i) == f"{program_of(self.scene.surfaces[i])} {i}"

    def one_more(self) -> bool:
        """Where surfaces share a program, one of them gets its own. False: there is none left."""
        for i in () if self.one_program else self.made.drawn_by:
            if not self.has_own(i):
                own = f"{program_of(self.scene.surfaces[i])} {i}"
                self.made = self.made | self.of({own: self.pair(program_of(self.scene.surfaces[i]), (i,))}, {i: own})
                return True
        return False

    def of(self, wanted: Programs, drawn_by: dict[int, str]) -> Made:
        """The programs of these texts."""
        made = Made(texts=wanted, drawn_by=drawn_by)
        passing = self.passing if self.source.overrides or self.others else None
        for called, pair in wanted.items():
            vertex, fragment = pair
            if has_loops(pair):
                made.watched[called] = pair
            values = () if fragment else ("value", "v_endless") if called in made.watched else ("value",)
            made.programs[called] = program(self.ctx, vertex, fragment, values, passing)
        return made

    def let_go(self) -> None:
        """Release the programs of its own that nothing here draws with."""
        used = {use for made in (self.made, *self.others.values()) for use in made.programs.values()}
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
