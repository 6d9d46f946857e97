"""The pages of a PDF as pictures and as words; the only pypdfium2, of the extra `slides`."""

from pathlib import Path

import numpy as np

from app.problem import Problem, Usage


class Deck:
    def __init__(self, path: str | Path):
        try:
            import pypdfium2
        except ImportError:
            raise Problem("slides need pypdfium2: `uv sync --extra slides`, or pip install pypdfium2.") from None
        path = Path(path).expanduser()
        if not path.is_file():
            raise Usage(f"there is no deck {path}.")
        try:
            self.document = pypdfium2.PdfDocument(path)
        except pypdfium2.PdfiumError as error:
            raise Problem(f"{path} is no PDF that can be shown: {str(error).rstrip('.')}.") from None
        if not len(self.document):
            raise Problem(f"{path} has no pages.")

    def __len__(self) -> int:
        return len(self.document)

    def aspect(self, page: int) -> float:
        """Width over height of a page, from 1."""
        wide, high = self.document.get_page_size(page - 1)
        return wide / high

    def picture(self, page: int, width: int) -> np.ndarray:
        """A page (rows, width, 3), from 1."""
        one = self.document[page - 1]
        try:
            bitmap = one.render(scale=width / one.get_width(), rev_byteorder=True)
            return np.ascontiguousarray(bitmap.to_numpy()[..., :3])
        finally:
            one.close()

    def lines(self, page: int) -> list[str]:
        """The page's words, line by line."""
        one = self.document[page - 1]
        try:
            text = one.get_textpage()
            try:
                return [line.strip() for line in text.get_text_bounded().splitlines() if line.strip()]
            finally:
                text.close()
        finally:
            one.close()

    def close(self) -> None:
        self.document.close()
