"""Frames as a film's bytes: WebP, GIF and AVIF by Pillow alone, MP4 by the ffmpeg that is there; the same each time."""

import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from io import BytesIO
from itertools import pairwise
from pathlib import Path

from PIL import Image

from app.problem import Problem

ENDINGS = (".webp", ".gif", ".avif", ".mp4")
LIKE: dict[str, dict] = {".webp": {"quality": 80, "method": 4}, ".avif": {"quality": 70, "max_threads": 1}, ".gif": {}}
X264 = ("-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-threads", "1", "-movflags", "+faststart",
        "-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1")


def film(frames: Sequence[Image.Image], ending: str, fps: int) -> bytes:
    """The file's content; it plays again and again where the format can say so."""
    if ending == ".mp4":
        return mp4(frames, fps)
    out = BytesIO()
    frames = few_colours(frames) if ending == ".gif" else frames
    frames[0].save(out, ending[1:].upper(), save_all=True, append_images=frames[1:],
                   duration=durations(len(frames), fps, 10 if ending == ".gif" else 1), loop=0, **LIKE[ending])
    return undated(out.getvalue()) if ending == ".avif" else out.getvalue()


def undated(data: bytes) -> bytes:
    """An AVIF sequence without the seconds of its making, which stand in three kinds of boxes (ISO/IEC 14496-12)."""
    found, at = bytearray(data), [(0, len(data))]
    while at:
        begin, end = at.pop()
        while begin + 8 <= end:
            size, kind = int.from_bytes(found[begin:begin + 4], "big"), bytes(found[begin + 4:begin + 8])
            size = size if size >= 8 else end - begin
            if kind in (b"moov", b"trak", b"mdia"):
                at.append((begin + 8, begin + size))
            elif kind in (b"mvhd", b"tkhd", b"mdhd"):
                wide = 16 if found[begin + 8] else 8  # two times, of 8 or 4 bytes, behind version and flags
                found[begin + 12:begin + 12 + wide] = bytes(wide)
            begin += size
    return bytes(found)


def durations(count: int, fps: int, unit: int) -> list[int]:
    """ms of each frame in the whole units a format has; together they are the film's time."""
    ends = [unit * round(1000 * i / fps / unit) for i in range(count + 1)]
    return [b - a for a, b in pairwise(ends)]


def few_colours(frames: Sequence[Image.Image]) -> list[Image.Image]:
    """256 colours that all frames share, found in some of them; no dithering, which would crawl."""
    some = frames[::max(1, len(frames) // 6)]
    width, height = frames[0].size
    sheet = Image.new("RGB", (width, height * len(some)))
    for i, one in enumerate(some):
        sheet.paste(one, (0, i * height))
    palette = sheet.quantize(256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    made = {id(one): one.quantize(palette=palette, dither=Image.Dither.NONE) for one in frames}
    return [made[id(one)] for one in frames]


def ffmpeg() -> str:
    """The ffmpeg on the PATH, or the one of the extra `video`; a sentence where there is none."""
    if found := shutil.which("ffmpeg"):
        return found
    try:
        from imageio_ffmpeg import get_ffmpeg_exe

        return str(get_ffmpeg_exe())
    except (ImportError, RuntimeError):
        raise Problem("MP4 needs ffmpeg, and there is none here: install it, or `uv sync --extra video`, "
                      "or write a .webp, .gif or .avif, which need nothing.") from None


def mp4(frames: Iterable[Image.Image], fps: int) -> bytes:
    """H.264 with an even number of pixels a side, as its colours want it: an odd side loses its last line."""
    use, frames = ffmpeg(), list(frames)
    width, height = (side - side % 2 for side in frames[0].size)
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile() as words:
        path = Path(folder) / "film.mp4"
        command = [use, "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
                   "-r", str(fps), "-i", "-", *X264, str(path)]
        child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=words)
        assert child.stdin
        try:
            for one in frames:
                child.stdin.write(one.crop((0, 0, width, height)).tobytes())
            child.stdin.close()
        except BrokenPipeError:  # it has said why
            pass
        except BaseException:
            child.kill()
            raise
        finally:
            code = child.wait()
        if code or not path.exists():
            words.seek(0)
            said = words.read().decode(errors="replace").strip().splitlines()
            raise Problem(f"ffmpeg wrote no film: {said[-1] if said else f'exit code {code}'}.")
        return path.read_bytes()
