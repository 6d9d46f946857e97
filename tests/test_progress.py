"""Progress on disk: whole or not at all, through crashes, damage, full disks and two windows."""

import errno
import json
import os
import re
import subprocess
import sys

import pytest
from filelock import FileLock

from app import progress
from app.paths import ROOT
from app.progress import Progress, data_folder, merged


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "data"


def on_disk(folder) -> dict:
    return json.loads((folder / "progress.json").read_text())


def test_what_is_put_is_there_another_day(folder):
    first = Progress(folder)
    assert first.first_start and first.message == "" and not folder.exists()
    first.put_state("a/b", "a/b?x=1")
    first.put_answer("a/b", 3.0, None, 4.0)
    first.put_setting("theme", "projector")
    assert first.save()
    second = Progress(folder)
    assert (second.state("a/b"), second.visited("a/b"), second.visited("a/c")) == ("a/b?x=1", True, False)
    assert second.setting("theme") == "projector" and second.setting("last_step") == "a/b"
    assert second.setting("other", 7) == 7
    answer = second.answer("a/b")
    assert answer is not None and (answer["guess"], answer["truth"]) == (3.0, 4.0) and answer["when"] > 1.7e9
    assert second.answer("a/c") is None and second.state("a/c") is None and not second.first_start
    assert sorted(path.name for path in folder.glob("*.json*")) == ["progress.json"]


def test_the_folder_can_be_chosen(folder, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(folder))
    assert data_folder() == folder == Progress().folder
    monkeypatch.delenv("HALFWAY_DATA")
    assert data_folder().name == "halfway"


@pytest.mark.parametrize("text", [
    b"", b"{", b"\xff\xfe\x00", b"[1, 2]", b'{"steps": [1]}', b'{"steps": {"a/b": 3}}', b'{"version": "new"}',
    b"[" * 100_000, b'{"settings": null}', b"null",
], ids=range(10))
def test_a_damaged_file_is_kept_aside(folder, text):
    folder.mkdir()
    (folder / "progress.json").write_bytes(text)
    damaged = Progress(folder)
    aside = next(folder.glob("progress.corrupt-*.json"))
    assert aside.read_bytes() == text and re.fullmatch(r"progress\.corrupt-\d{8}-\d{6}\.json", aside.name)
    assert damaged.message == f"Your progress file was damaged and is kept as {aside}; the course starts a new one."
    damaged.put_state("a/b", "a/b")
    assert damaged.save() and Progress(folder).visited("a/b")


def test_a_file_damaged_meanwhile_costs_nothing(folder):
    mine = Progress(folder)
    mine.put_state("a/b", "a/b?x=1")
    mine.save()
    for damage in (b"{", b"[]"):  # twice in a second: both are kept
        (folder / "progress.json").write_bytes(damage)
        mine.put_state("a/c", "a/c")
        assert mine.save() and "was damaged and is kept as" in mine.message
    assert Progress(folder).state("a/b") == "a/b?x=1" and Progress(folder).visited("a/c")
    assert sorted(path.read_bytes() for path in folder.glob("progress.corrupt-*")) == [b"[]", b"{"]


def test_a_damaged_file_that_cannot_be_put_aside_is_not_written_over(folder, monkeypatch):
    folder.mkdir()
    (folder / "progress.json").write_bytes(b"{")
    monkeypatch.setattr(progress.os, "replace", failing(errno.EROFS))
    mine = Progress(folder)
    assert "could not be read" in mine.message and "read-only file system" in mine.message
    mine.put_state("a/b", "a/b")
    assert not mine.save()
    assert (folder / "progress.json").read_bytes() == b"{"


def failing(number: int):
    def fail(*args, **kwargs):
        raise OSError(number, os.strerror(number))
    return fail


@pytest.mark.parametrize(("what", "number", "words"), [
    ("fsync", errno.ENOSPC, "no space left on device"), ("replace", errno.EACCES, "permission denied"),
])
def test_a_full_or_locked_disk_leaves_the_course_unsaved_and_the_file_whole(folder, monkeypatch, what, number, words):
    mine = Progress(folder)
    mine.put_state("a/b", "a/b")
    mine.save()
    before = (folder / "progress.json").read_bytes()
    with monkeypatch.context() as patch:
        patch.setattr(progress.os, what, failing(number))
        mine.put_state("a/c", "a/c")
        assert not mine.save()
    assert mine.message == f"Progress cannot be kept in {folder} ({words}); the course goes on unsaved."
    assert (folder / "progress.json").read_bytes() == before and not (folder / "progress.json.new").exists()
    assert mine.visited("a/c")
    assert mine.save() and Progress(folder).visited("a/c")  # there is room again


def test_a_folder_that_cannot_be_made_leaves_the_course_unsaved(tmp_path):
    (tmp_path / "file").write_text("")
    mine = Progress(tmp_path / "file" / "data")
    assert mine.message == "" and mine.first_start
    mine.put_state("a/b", "a/b")
    assert not mine.save() and "the course goes on unsaved" in mine.message


def test_two_windows_add_up_and_the_newest_entry_wins(folder, monkeypatch):
    clock = iter(range(1000, 2000))
    monkeypatch.setattr(progress.time, "time", lambda: next(clock))
    left, right = Progress(folder), Progress(folder)
    left.put_state("a/b", "a/b?x=1")
    right.put_state("a/b", "a/b?x=2")
    right.put_state("a/c", "a/c")
    left.put_answer("a/b", 1.0, None, 2.0)
    assert right.save() and left.save() and right.save()
    last = Progress(folder)
    assert last.state("a/b") == "a/b?x=2" and last.visited("a/c") and last.answer("a/b")
    assert left.state("a/b") == "a/b?x=2"


def test_a_clock_set_back_does_not_lose_what_comes_later(folder, monkeypatch):
    mine = Progress(folder)
    monkeypatch.setattr(progress.time, "time", lambda: 2000.0)
    mine.put_state("a/b", "a/b?x=1")
    mine.save()
    monkeypatch.setattr(progress.time, "time", lambda: 1000.0)
    mine.put_state("a/b", "a/b?x=2")
    mine.save()
    assert Progress(folder).state("a/b") == "a/b?x=2"


def test_a_window_that_holds_the_lock_is_waited_for_only_shortly(folder, monkeypatch):
    monkeypatch.setattr(progress, "PATIENCE", 0.01)
    folder.mkdir()
    mine = Progress(folder)
    mine.put_state("a/b", "a/b")
    with FileLock(folder / "progress.lock"):
        assert not mine.save()
    assert "Another window is holding" in mine.message
    assert mine.save()


def test_what_a_newer_version_has_written_is_kept(folder):
    folder.mkdir()
    newer = {"version": 9, "badges": ["first"], "steps": {"a/b": {"state": "a/b", "when": 5, "mood": "good"}},
             "answers": {}, "settings": {"sound": {"value": "off", "when": 5}}}
    (folder / "progress.json").write_text(json.dumps(newer))
    mine = Progress(folder)
    mine.put_state("a/b", "a/b?x=1")
    mine.save()
    kept = on_disk(folder)
    assert (kept["version"], kept["badges"], kept["steps"]["a/b"]["mood"]) == (9, ["first"], "good")
    assert kept["steps"]["a/b"]["state"] == "a/b?x=1" and kept["settings"]["sound"]["value"] == "off"


def test_merging_keeps_fields_of_both():
    disk = {"steps": {"s": {"when": 1, "old": 1, "state": "x"}}, "more": 1}
    mine = {"steps": {"s": {"when": 2, "state": "y"}, "t": {"when": "never"}}}
    both = merged(disk, mine)
    assert both["steps"] == {"s": {"when": 2, "old": 1, "state": "y"}, "t": {"when": "never"}} and both["more"] == 1


def test_many_processes_lose_nothing(folder):
    script = ("import sys\nfrom app import progress\nprogress.PATIENCE = 30\n"
              "for i in range(10):\n"
              "    mine = progress.Progress()\n    mine.put_state(f'{sys.argv[1]}/{i}', 'x')\n"
              "    assert mine.save(), mine.message")
    children = [subprocess.Popen([sys.executable, "-c", script, name], cwd=ROOT,
                                 env={**os.environ, "HALFWAY_DATA": str(folder)}) for name in "abc"]
    assert [child.wait(60) for child in children] == [0, 0, 0]
    assert len(on_disk(folder)["steps"]) == 30
    assert not list(folder.glob("progress.corrupt-*"))


def test_a_crash_while_writing_leaves_the_last_whole_file(folder):
    script = ("import os, sys\nfrom app.progress import Progress\n"
              "mine = Progress()\nmine.put_state('a/b', 'x')\nmine.save()\n"
              "os.fsync = lambda number: os._exit(9)\nmine.put_state('a/c', 'x')\nmine.save()")
    child = subprocess.run([sys.executable, "-c", script], cwd=ROOT, env={**os.environ, "HALFWAY_DATA": str(folder)},
                           check=False)
    assert child.returncode == 9
    after = Progress(folder)
    assert after.visited("a/b") and not after.visited("a/c") and after.message == ""
    after.put_state("a/d", "x")
    assert after.save()
