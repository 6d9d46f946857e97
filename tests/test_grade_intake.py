"""What is handed in: read in memory, never unpacked; what could be read in two ways is refused with a reason."""

import io
import os
import random
import tarfile
import zipfile
from pathlib import Path

import pytest

from app.grade import archives, intake
from app.grade.intake import Submission, read, students
from app.problem import Usage

SOURCE = b"def f(x):\n    return x\n"


def zipped(*members: tuple[str, bytes], kind=zipfile.ZIP_DEFLATED, **more) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", kind) as archive:
        for name, data in members:
            info = zipfile.ZipInfo("x")
            info.filename, info.compress_type = name, kind
            for key, value in more.items():
                setattr(info, key, value)
            archive.writestr(info, data)
    return out.getvalue()


def tarred(*members: tuple[str, bytes], mode="w:gz", **more) -> bytes:
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode=mode) as archive:
        for name, data in members:
            info = tarfile.TarInfo(name)
            info.size = len(data)
            for key, value in more.items():
                setattr(info, key, value)
            archive.addfile(info, io.BytesIO(data))
    return out.getvalue()


def overlapping() -> bytes:
    """Two entries of the directory that share one member's bytes."""
    data = bytearray(zipped(("submission.py", SOURCE), ("submission.glsl", SOURCE)))
    entry = data.index(b"PK\1\2", data.index(b"PK\1\2") + 4)
    data[entry + 42:entry + 46] = (0).to_bytes(4, "little")
    return bytes(data)


def changed(old: bytes, new: bytes, count: int = -1) -> bytes:
    data = zipped(("submission.py", b"x = 1  # " + b"y" * 50), kind=zipfile.ZIP_STORED)
    assert old in data
    return data.replace(old, new, count)


def lying() -> bytes:
    data = bytearray(zipped(("submission.py", b"x = 1\n" * 100)))
    entry = data.index(b"PK\1\2")
    data[entry + 24:entry + 28] = (50).to_bytes(4, "little")
    return bytes(data)


NAMES = ["../../submission.py", "a/../../submission.py", "/submission.py", "C:\\submission.py", "C:submission.py",
         "..\\submission.py", "\\\\host\\share\\submission.py", "a.py\0.txt", "\u202eyp.noissimbus", "CON", "a/nul.py",
         "submission.py.", "submission.py ", "x" * 300, "a\nb", "a//b", "inner.zip", "inner.tar.gz"]
PAIRS = [("submission.py", "submission.py"), ("A.py", "a.py"), ("caf\u00e9.py", "cafe\u0301.py"), ("a", "a/b"),
         ("x/submission.py", "y/submission.py")]
BROKEN = {
    "a bomb": zipped(("submission.py", bytes(200 << 20))),
    "nested": zipped(("a.zip", zipped(("submission.py", SOURCE)))),
    "overlapping": overlapping(), "lying sizes": lying(), "bad CRC": changed(b"x = 1", b"x = 2", 1),
    "too many": zipped(*((f"a{i}", b"") for i in range(60))), "cut": zipped(("submission.py", SOURCE))[:-30],
    "noise": random.Random(1).randbytes(5000), "encrypted": zipped(("submission.py", SOURCE)).replace(
        b"PK\1\2\x14\x03\x14\0\0\0", b"PK\1\2\x14\x03\x14\0\1\0"),
    "a link": zipped(("submission.py", b"/etc/passwd"), external_attr=0o120777 << 16),
    "too big": zipped(("submission.py", random.Random(2).randbytes(2 << 20))),
}
TARS = {
    "a bomb": tarred(("submission.py", bytes(200 << 20))),
    "a link": tarred(("submission.py", b""), type=tarfile.SYMTYPE, linkname="/etc/passwd"),
    "a device": tarred(("submission.py", b""), type=tarfile.CHRTYPE), "cut": tarred(("submission.py", SOURCE))[:-20],
    "a pipe": tarred(("submission.py", b""), type=tarfile.FIFOTYPE), "out": tarred(("../submission.py", SOURCE)),
    "xz bomb": tarred(("submission.py", bytes(100 << 20)), mode="w:xz"),
}


def of(tmp_path: Path, name: str, data: bytes) -> Submission:
    (tmp_path / name).write_bytes(data)
    (student, entries), = students(tmp_path / name).items()
    return read(student, entries)


@pytest.mark.parametrize("name", NAMES, ids=ascii)
def test_a_name_that_means_more_than_one_thing_is_refused(tmp_path, name):
    found = of(tmp_path, "jane.zip", zipped((name, SOURCE)))
    assert found.refused and not found.files and found.student == "jane"
    if "\0" not in name:
        assert of(tmp_path, "joe.tgz", tarred((name, SOURCE))).refused


@pytest.mark.parametrize("pair", PAIRS, ids=ascii)
@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_two_names_for_one_file_are_refused(tmp_path, pair):
    members = [(name, SOURCE) for name in pair]
    assert of(tmp_path, "a.zip", zipped(*members)).refused
    assert of(tmp_path, "a.tar", tarred(*members, mode="w")).refused


@pytest.mark.parametrize("what", BROKEN)
def test_a_zip_that_lies_is_refused(tmp_path, what):
    found = of(tmp_path, "a.zip", BROKEN[what])
    assert found.refused and found.refused.isprintable() and len(found.refused) < 400 and not found.files


@pytest.mark.parametrize("what", TARS)
def test_a_tar_that_lies_is_refused(tmp_path, what):
    assert of(tmp_path, "a.tar.gz", TARS[what]).refused


@pytest.mark.parametrize(("name", "data"), [
    ("a.zip", zipped(("submission.py", SOURCE), ("notes.txt", b"hello"))),
    ("a.zip", zipped(("work/", b""), ("work/submission.py", SOURCE))), ("a.tgz", tarred(("./submission.py", SOURCE))),
    ("a.tar.xz", tarred(("submission.py", SOURCE), mode="w:xz")), ("a.py", SOURCE), ("a.tar", tarred(
        ("submission.py", SOURCE), mode="w"))])
def test_what_is_plain_is_read(tmp_path, name, data):
    found = of(tmp_path, name, data)
    assert found == Submission("a", {"submission.py": SOURCE}) and found.files == {"submission.py": SOURCE}
    assert not found.faults and sorted(path.name for path in tmp_path.iterdir()) == [name]  # nothing was unpacked


def test_a_class_is_read_by_its_names(tmp_path):
    (tmp_path / "ann").mkdir()
    (tmp_path / "ann" / "submission.py").write_bytes(SOURCE)
    (tmp_path / "ann" / "numpy.py").write_bytes(b"raise SystemExit")
    (tmp_path / "ben.glsl").write_bytes(b"float f(float x) { return x; }")
    (tmp_path / "ben.py").write_bytes(SOURCE)
    (tmp_path / "cem.zip").write_bytes(zipped(("submission.py", SOURCE)))
    (tmp_path / "dee").mkdir()
    (tmp_path / "dee" / "upload.zip").write_bytes(zipped(("submission.glsl", b"x")))
    (tmp_path / ".DS_Store").write_bytes(b"")
    found = {student: read(student, entries) for student, entries in students(tmp_path).items()}
    assert {name: sorted(one.files) for name, one in found.items()} == {
        "ann": ["submission.py"], "ben": ["submission.glsl", "submission.py"], "cem": ["submission.py"],
        "dee": ["submission.glsl"]}
    assert not any(one.refused for one in found.values())
    assert found["ann"].hash == found["cem"].hash != found["ben"].hash


@pytest.mark.parametrize("ending", [".pyc", ".so", ".pth", ".pyi", ".ipynb", ".doc"])
def test_what_is_no_source_is_refused_by_its_kind(tmp_path, ending):
    assert of(tmp_path, f"jane{ending}", b"x").refused
    (tmp_path / "joe").mkdir()
    (tmp_path / "joe" / f"submission{ending}").write_bytes(b"x")
    found = read("joe", [tmp_path / "joe"])
    assert not found.files and (found.refused or ending == ".doc")


def test_links_and_pipes_are_not_followed(tmp_path):
    place = tmp_path / "eve"
    place.mkdir()
    (place / "submission.py").symlink_to("/etc/hostname")
    assert "cannot be read" in read("eve", [place]).refused
    (place / "submission.py").unlink()
    os.mkfifo(place / "submission.py")
    assert "no ordinary file" in read("eve", [place]).refused


def test_a_student_is_not_two(tmp_path):
    (tmp_path / "ann.py").write_bytes(SOURCE)
    (tmp_path / "ann.zip").write_bytes(zipped(("submission.py", SOURCE)))
    (student, entries), = students(tmp_path).items()
    assert "twice" in read(student, entries).refused


@pytest.mark.parametrize(("data", "why"), [
    (SOURCE.decode().encode("utf-16"), "UTF-8"), ("# é\n".encode("latin-1"), "UTF-8"), (b"x = 1\0", "U+0000"),
    (b"# coding: rot13\nk = 1\n", "rot13"), (b"#!/usr/bin/python\n# -*- coding: utf-7 -*-\n", "utf-7"),
    (b"x = 1\rwhile True: pass\n", "carriage return"), ("x = 1 # \u202e".encode(), "U+202E"),
    ("\u2028".encode(), "U+2028"), (b"x = 1\n\x1b[2J", "line 2")])
def test_a_text_that_can_be_read_two_ways_is_refused(data, why):
    fault = Submission("a", {"submission.py": data}).faults["submission.py"]
    assert why in fault and fault.isprintable()


@pytest.mark.parametrize("data", [b"\xef\xbb\xbfx = 1\n", b"x = 1\r\ny = 2\r\n", b"# coding: utf-8\nx = 1\n", b"",
                                  "# Größe, \u03b8\nθ = 1\n".encode()])
def test_an_ordinary_text_is_taken(data):
    one = Submission("a", {"submission.py": data})
    assert not one.faults
    assert "\r" not in one.texts["submission.py"] and "\ufeff" not in one.texts["submission.py"]


def test_limits_of_size(tmp_path):
    assert "larger than 1 MB" in of(tmp_path, "a.py", b"#" * (10 << 20)).refused
    assert archives.MOST_MEMBERS == 50 and archives.MOST_BYTES == 5 << 20


def test_where_nothing_is_handed_in(tmp_path):
    with pytest.raises(Usage, match="is empty"):
        students(tmp_path)
    with pytest.raises(Usage, match="nothing at"):
        students(tmp_path / "no")
    assert intake.printable("a\x1bb\u202ec\ud800").isprintable()
