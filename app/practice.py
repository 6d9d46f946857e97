"""What a student has written for the exercises, kept with the progress: nothing that was typed is lost."""

from app.exercises import Language
from app.lesson import Exercise
from app.progress import Progress

TABLE = "exercises"


class Practice:
    """Texts by exercise (chapter/name) and language; the stub where nothing was typed."""

    def __init__(self, progress: Progress):
        self.progress = progress

    def text(self, name: str, exercise: Exercise, language: Language) -> str:
        return self.kept(name, "texts").get(language, exercise.stubs[language].strip("\n"))

    def type(self, name: str, exercise: Exercise, language: Language, text: str) -> None:
        texts = self.kept(name, "texts")
        if text == exercise.stubs[language].strip("\n"):
            texts.pop(language, None)
        else:
            texts[language] = text
        self.put(name, texts=texts)

    def typed(self, name: str, language: Language) -> bool:
        return language in self.kept(name, "texts")

    def can_go_back(self, name: str, language: Language) -> bool:
        return language in self.kept(name, "aside")

    def start_again(self, name: str, language: Language) -> None:
        """The stub again; what was typed can be brought back."""
        texts = self.kept(name, "texts")
        if language in texts:
            self.put(name, aside={**self.kept(name, "aside"), language: texts.pop(language)}, texts=texts)

    def bring_back(self, name: str, language: Language) -> None:
        aside = self.kept(name, "aside")
        if language in aside:
            self.put(name, texts={**self.kept(name, "texts"), language: aside.pop(language)}, aside=aside)

    def language(self, name: str) -> Language:
        """The one written in last."""
        return "python" if self.progress.entry(TABLE, name).get("language") == "python" else "glsl"

    def write_in(self, name: str, language: Language) -> None:
        self.put(name, language=language)

    def solved(self, name: str) -> bool:
        """Whether a text of it has passed every visible check, in either language."""
        return self.progress.entry(TABLE, name).get("solved") is True

    def solve(self, name: str) -> None:
        self.put(name, solved=True)

    # --- on disk -----------------------------------------------------------------------------------------------------
    def kept(self, name: str, which: str) -> dict[str, str]:
        """Texts by their language; what is damaged is none."""
        found = self.progress.entry(TABLE, name).get(which)
        return {k: v for k, v in found.items() if isinstance(v, str)} if isinstance(found, dict) else {}

    def put(self, name: str, **fields) -> None:
        entry = self.progress.entry(TABLE, name)
        if any(entry.get(key) != value for key, value in fields.items()):
            self.progress.put(TABLE, name, **fields)
