"""A scene's texts as programs: as it is written, and with what is being typed in place of some functions."""

from app.gpu.stage_text import Pair, Programs, Source, programs, typed_in


class SceneTexts:
    def __init__(self, source: Source):
        self.source = source
        self.plain: dict[tuple, Pair] = {}  # as the scene is written
        self.typed: dict[tuple, tuple[str, ...]] = {}

    def programs(self, names: tuple[str, ...] | None, known: dict | None = None, plain: bool = False) -> Programs:
        """What is compiled, for what is `known`; `plain`, as the scene is written."""
        source = self.source
        return programs(source.scene, source.file, source.first, names=names, known=known, watched=True,
                        overrides=() if plain else source.overrides)

    def pair(self, name: str, surfaces: tuple[int, ...], decided: dict[str, int], choice: dict[str, int]) -> Pair:
        """The texts of a program, for the `choice` where it runs what is being typed, else for what the scene has
        `decided`; of one that draws some surfaces alone their numbers are known."""
        number = {"surface": frozenset(surfaces)} if surfaces else {}
        if any(self.typed_in(name, i, choice) for i in surfaces or (None,)):
            return self.programs((name,), choice | number)[name]
        key = name, surfaces, *decided.values()
        if key not in self.plain:
            self.plain[key] = self.programs((name,), decided | number, plain=True)[name]
        return self.plain[key]

    def typed_in(self, name: str, surface: int | None, choice: dict[str, int]) -> tuple[str, ...]:
        """Where a program, or that of one surface, runs a text that is being typed: at its "vertices", its "pixels".
        What leads to that text does not change while it is typed, so the answer stays; but a directive in it may reach
        everything."""
        overrides = self.source.overrides
        if not overrides:
            return ()
        key = name, surface, *choice.values(), *(one for one, _ in overrides)
        stays = not any("#" in text.text for _, text in overrides if text.is_own)
        if not stays or key not in self.typed:
            known = choice | ({} if surface is None else {"surface": surface})
            found = typed_in(self.programs((name,), known)[name], overrides)
            if not stays:
                return found
            self.typed[key] = found
        return self.typed[key]
