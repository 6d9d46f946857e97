"""The film beside a page: what moves in it, how long, and that only who asks waits for it."""

import numpy as np
from PIL import Image

from app.__main__ import main
from app.catalog import step, steps
from app.export.web.moving import SECONDS, SIZE, main_value


def test_every_steps_film_shows_what_its_plot_goes_over():
    assert all(main_value(found) for found in steps())
    assert main_value(step("brdfs/phong")).name == "theta_l" and main_value(step("lights/ies")).name == "height"


def test_a_film_goes_there_and_back(tmp_path, capsys):
    assert main(["export", "fresnel/schlick", "-o", str(tmp_path)]) == 0
    frames, lasts = [], 0
    with Image.open(tmp_path / "fresnel-schlick.gif") as film:
        assert film.size == SIZE and film.info["loop"] == 0
        for i in range(film.n_frames):
            film.seek(i)
            lasts += film.info["duration"]
            frames.append(np.asarray(film.convert("RGB")).astype(int))
    assert lasts == 1000 * SECONDS
    assert len({frame.tobytes() for frame in frames}) > len(frames) // 3
    assert np.abs(frames[1] - frames[-1]).max() <= 48 < np.abs(frames[0] - frames[len(frames) // 2]).max()


def test_it_is_left_out_where_nobody_asks(tmp_path, capsys):
    assert main(["export", "fresnel/schlick", "--no-film", "-o", str(tmp_path)]) == 0
    assert {path.suffix for path in tmp_path.iterdir()} == {".html", ".png"}
