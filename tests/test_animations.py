"""Animations: the frames between the ends, films that play as long as asked, the same bytes twice, sentences."""

import io
import math
import shutil
import subprocess
from argparse import ArgumentParser
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from app.catalog import step
from app.export import animate, film
from app.export.shooting import Shooting, shot
from app.export.still import data
from app.motion import sweep, there_and_back
from app.problem import Problem, Usage
from app.state import defaults
from app.theme import THEMES

BALL, PATCH = step("microfacets/beckmann"), step("solid_angle/patch")
DARK = THEMES["dark"]


def options(*words: str):
    parser = ArgumentParser()
    animate.add_arguments(parser)
    return parser.parse_args(words)


def made(path: Path, *words: str) -> Image.Image:
    small = ("solid_angle/patch", "--sweep", "tilt=-60..60", "--size", "128x96", "--seconds", "1", "--fps", "8")
    assert animate.run(options(*small, "-o", str(path), *words)) == 0
    return Image.open(io.BytesIO(path.read_bytes()))


# --- the way ---------------------------------------------------------------------------------------------------------
def test_a_sweep_goes_evenly_on_its_sliders_scale_and_meets_its_ends():
    way = sweep("m=0.01..1", BALL)
    assert (way.at(0.0), way.at(1.0)) == (0.01, 1.0) and math.isclose(way.at(0.5), 0.1)  # logarithmic
    tilt = sweep("tilt=-60..30", PATCH)
    assert math.isclose(tilt.at(0.5), math.radians(-15)) and tilt.told(tilt.at(1.0)).endswith("= 30°")
    assert sweep("tilt=60..-60", PATCH).at(0.0) == math.radians(60), "it may go down"
    whole = sweep("samples", PATCH)
    assert (whole.first, whole.last) == (64, 16384) and isinstance(whole.at(0.4), int)
    assert [there_and_back(x) for x in (0.0, 0.25, 0.5, 1.0, 1.75)] == [0.0, 0.5, 1.0, 0.0, 0.5]


@pytest.mark.parametrize(("text", "sentence"), [
    ("titl=1..2", "there is no value titl in solid_angle/patch. Did you mean tilt?"),
    ("tilt=1", "is no sweep; write where it begins and ends, like tilt=-90..90."),
    ("tilt=0..200", "takes tilt from -90 to 90°."),
    ("tilt=a..b", "takes a number, and a is none."),
])
def test_what_is_no_sweep_is_said(text, sentence):
    with pytest.raises(Usage, match=rf"^--sweep {text}.*") as said:
        sweep(text, PATCH)
    assert sentence in str(said.value)


def test_back_again_is_the_same_way():
    assert animate.ways(1.0, 8, True) == [0, 0.25, 0.5, 0.75, 1, 0.75, 0.5, 0.25]
    assert animate.ways(1.0, 5, False) == [0, 0.25, 0.5, 0.75, 1]
    assert set(animate.ways(1.0, 9, True)) == {0, 0.25, 0.5, 0.75, 1}
    with pytest.raises(Usage, match="makes 0 frames; it takes 2 to 1800"):
        animate.ways(0.01, 24, False)


# --- the film --------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("ending", ["webp", "gif", "avif"])
def test_a_film_has_its_frames_its_time_and_the_same_bytes_twice(tmp_path, ending):
    one = made(tmp_path / f"a.{ending}")
    made(tmp_path / f"b.{ending}")
    assert (tmp_path / f"a.{ending}").read_bytes() == (tmp_path / f"b.{ending}").read_bytes()
    assert (one.n_frames, one.size, one.info["loop"] if ending != "avif" else 0) == (8, (128, 96), 0)
    time, frames = 0, []
    for i in range(8):
        one.seek(i)
        one.load()
        time += one.info["duration"]
        frames.append(np.asarray(one.convert("RGB")).astype(int))
    assert abs(time - 1000) <= 8
    assert all(np.abs(a - b).max() > 60 for a, b in pairwise(frames)), "the patch turns"


def test_there_and_back_ends_where_it_begins(tmp_path):
    moving = made(tmp_path / "a.gif", "--loop")
    frames = []
    for i in range(moving.n_frames):
        moving.seek(i)
        frames.append(np.asarray(moving.convert("RGB")))
    assert np.array_equal(frames[1], frames[7]) and np.array_equal(frames[3], frames[5])
    assert not np.array_equal(frames[0], frames[4])


def test_a_frame_is_the_still_and_its_words_keep_their_places():
    values = defaults(PATCH)
    with Shooting(PATCH, (400, 300), DARK) as one:
        camera = one.camera([values], None)
        first, stage = one.picture(values, camera), one.on_stage
        alone = shot(PATCH, values, None, (400, 300), DARK)
        assert np.array_equal(np.asarray(first), np.asarray(alone)), "one stage for all draws what one for each draws"
        before = dict(one.kept)
        one.picture({**values, "tilt": 0.2}, camera)
        assert one.kept == before and one.on_stage is stage
        again = one.picture(values, camera)
        assert np.array_equal(np.asarray(again), np.asarray(first))


def test_scene_and_plot_move_together_on_steady_axes(tmp_path):
    moving = made(tmp_path / "a.webp", "--view", "both", "--size", "300x400", "--fps", "3")
    frames = []
    for i in range(3):
        moving.seek(i)
        frames.append(np.asarray(moving.convert("RGB")).astype(int))
    half = 180
    assert all(np.abs(a[part] - b[part]).max() > 60 for a, b in pairwise(frames)
               for part in (slice(0, half), slice(half, 350)))


def test_the_whole_way_has_room(tmp_path):
    """The lens is the widest that any part of the way needs."""
    near, far = {"distance": 0.5}, {"distance": 5.0}
    values = [{**defaults(PATCH), **one} for one in (near, far)]
    with Shooting(PATCH, (200, 200), DARK) as one:
        wide = one.camera(values, None).field_of_view
        assert wide == max(one.camera([each], None).field_of_view for each in values)
        assert wide > min(one.camera([each], None).field_of_view for each in values)


def test_interrupted_it_leaves_nothing(tmp_path, monkeypatch):
    monkeypatch.setattr(animate, "film", lambda *given: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        made(tmp_path / "a.webp")
    assert list(tmp_path.iterdir()) == []


# --- what goes wrong, and MP4 ----------------------------------------------------------------------------------------
def test_an_animation_that_cannot_be_is_a_sentence(tmp_path):
    for words, sentence in ((("-o", str(tmp_path / "a.mov")), "does not end in .webp or .gif or .avif or .mp4"),
                            (("--sweep", "tilt=0..1"), "a value is swept twice"),
                            (("--view", "plots"), "there are scene, plot, both")):
        with pytest.raises(Usage, match=sentence):
            made(tmp_path / "a.webp", *words)


def test_without_ffmpeg_the_others_are_named(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.setitem(__import__("sys").modules, "imageio_ffmpeg", None)
    with pytest.raises(Problem, match=r"MP4 needs ffmpeg.*or write a \.webp"):
        made(tmp_path / "a.mp4")
    assert not (tmp_path / "a.mp4").exists()


def test_mp4_has_its_frames_and_the_same_bytes_twice():
    frames = [Image.fromarray(np.full((49, 65, 3), 20 * i, np.uint8)) for i in range(8)]
    first, second = (film.mp4(frames, 8) for _ in range(2))
    assert first == second and first[4:8] == b"ftyp"
    use = [film.ffmpeg(), "-v", "error", "-i", "-", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    seen = subprocess.run(use, input=first, capture_output=True, check=True).stdout
    played = np.frombuffer(seen, np.uint8).reshape(-1, 48, 64, 3)
    assert len(played) == 8 and np.abs(played.mean((1, 2, 3)) - 20 * np.arange(8)).max() < 6
    assert io.BytesIO(first).getbuffer().nbytes < 20_000


def test_data_follows_the_way():
    """A shape that is swept over brings its own triangles."""
    found = step("solid_angle/mesh")
    way = [sweep("shape", found)]
    with animate.Filming(found, defaults(found), None, way, (96, 96), DARK, "scene", 0) as one:
        assert len(one.at(0.0)["triangles"]) != len(one.at(1.0)["triangles"])
        assert one.at(0.0)["triangles"] is one.at(0.0)["triangles"]
        assert np.array_equal(one.at(1.0)["triangles"], data(found, one.at(1.0))["triangles"])
