"""The plots' own process: `python -m app.plots.child` reads wishes from its input and writes pictures to its output.

The end of the input is the end of the process, so that it never outlives the window, however that ended.
"""

import os
import sys
from typing import Any

from app.plots.wire import receive, send
from app.problem import Problem


class Draughtsman:
    """Keeps one drawing as long as plot, size, theme, ranges and mesh stay the same."""

    def __init__(self) -> None:
        self.drawing: Any = None
        self.key: Any = None
        self.triangles: Any = None

    def draw(self, wish) -> tuple[Any, str, tuple]:
        """The picture, the words of what went wrong in drawing it, and its points that can be pointed at."""
        from app.plots.draw import Drawing, failed

        if wish.mesh_changed:
            self.triangles = wish.triangles
        key = wish.plot, wish.size, wish.theme, wish.ranges
        try:
            if self.drawing is None or wish.fresh or wish.mesh_changed or key != self.key:
                self.close()
                self.drawing = Drawing(wish.plot, wish.size, wish.theme, self.triangles, wish.ranges)
                self.key = key
            return self.drawing.update(wish.values, wish.camera, wish.fine), "", self.drawing.spots
        except Exception as error:  # a drawing that fails is shown as its message, and the next may succeed
            self.close()
            words = str(error) if isinstance(error, Problem) else f"{type(error).__name__}: {error}"
            return failed(wish.plot, wish.size, wish.theme, words), words, ()

    def close(self) -> None:
        drawing, self.drawing = self.drawing, None
        if drawing is not None:
            drawing.close()


def main() -> None:
    source, sink = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what VTK or a driver prints must not end up between the pictures
    import app.plots.draw  # noqa: F401  the second that VTK takes to load passes before the first wish

    draughtsman = Draughtsman()
    try:
        while True:
            wish = receive(source)
            send(sink, draughtsman.draw(wish))
    except (EOFError, BrokenPipeError, KeyboardInterrupt):
        os._exit(0)  # no farewell from VTK: the window has gone


if __name__ == "__main__":
    main()
