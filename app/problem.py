"""An error that speaks to a person: one sentence with the file, the line, the value and what would be right."""


class Problem(Exception):
    """The job cannot be done; the exit code is 1."""

    code = 1

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows of it, in place of the way through our code."""
        return [f"halfway: {self}"]


class Usage(Problem):
    """The person asked for something that does not exist or is out of range; the exit code is 2."""

    code = 2


def near(word: str, words) -> str:
    """' Did you mean a, b or c?' for the words nearest to a mistyped one, or the list when it is short."""
    from difflib import get_close_matches

    words = sorted(words)
    close = get_close_matches(word, words, n=3, cutoff=0.5) or [w for w in words if word and word in w][:3]
    if not close:
        close = words if len(words) <= 8 else []
    return f" Did you mean {' or '.join(close)}?" if close else ""
