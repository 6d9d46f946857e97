"""The doctor finds what is broken, survives it, and names the command that mends it."""

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from app import doctor, locale_alias, remedies

CODE = """import argparse, sys
from app import doctor
parser = argparse.ArgumentParser()
doctor.add_arguments(parser)
sys.exit(doctor.run(parser.parse_args()))"""
linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="EGL and glibc are of Linux")


def diagnose(*arguments, **environment):
    clean = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([sys.executable, "-c", CODE, *arguments], capture_output=True, text=True, check=False,
                          env=clean | environment)


def findings(done):
    report = json.loads(done.stdout)
    return report, {part["name"]: part for part in report["parts"]}


@linux
def test_a_healthy_machine_without_a_display():
    done = diagnose("--json")
    report, parts = findings(done)
    assert done.returncode == 0 and report["can_run"] and done.stderr == ""
    assert all(part["works"] and not part["mend"] for part in parts.values())
    assert "renders the lessons to files" in parts["window"]["words"]
    assert set(report["graphics"]) == {"vendor", "renderer", "version"} and all(report["graphics"].values())
    assert "missing" not in report["packages"].values()


@linux
@pytest.mark.parametrize("variable", ["LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES"])
def test_no_driver(variable):
    done = diagnose("--json", **{variable: "/nowhere/at/all.json"})
    report, parts = findings(done)
    assert done.returncode == 1 and not report["can_run"]
    assert not report["graphics"]
    assert parts["latex"]["works"]
    for name in ("headless", "window", "plots", "reference"):
        assert not parts[name]["works"] and "\n" not in parts[name]["words"]
        assert set(parts[name]["mend"]) == set(remedies.SYSTEMS)
        assert parts[name]["mend"]["debian"] == f"unset {variable}"
    assert "doctor" not in parts["headless"]["words"]


@linux
def test_a_display_that_is_not_there():
    done = diagnose(DISPLAY=":4321")
    assert done.returncode == 0 and done.stderr == ""
    assert "BROKEN  window" in done.stdout and "Failed to open display :4321" in done.stdout
    assert "unset DISPLAY" in done.stdout and "The course can run, without what is broken above." in done.stdout


def probe(code, timeout=30.0):
    return doctor.try_part("plots", [sys.executable, "-c", code], timeout)


@pytest.mark.skipif(sys.platform == "win32", reason="signals are of POSIX")
def gone(state: Path) -> bool:
    """Within a moment: the system may still be busy with it."""
    for _ in range(100):
        try:
            if state.read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.1)
    return False


def test_a_crash_and_a_hang_do_no_harm(tmp_path):
    part = probe("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
    assert not part.works and part.words == "the driver or a library crashed (SIGSEGV)" and part.mend
    note = tmp_path / "pid"
    part = probe(f"""import subprocess, sys, time
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
open({str(note)!r}, "w").write(str(child.pid))
time.sleep(600)""", 2.0)
    assert not part.works and part.words == "did not answer within 2 s and was stopped" and part.mend
    assert gone(Path(f"/proc/{note.read_text()}/stat"))  # its child went with it


def test_silence_noise_and_an_exit_code():
    assert probe("print('hello')").words == "ended without an answer (exit code 0)"
    assert probe("import sys; sys.exit('no luck')").words == "ended without an answer (exit code 1: no luck)"


def test_what_a_probe_says_becomes_words():
    missing = '{"error": "No module named \'vtkmodules\'", "kind": "ModuleNotFoundError", "package": "vtkmodules.all"}'
    part = probe(f"print({missing!r})")
    assert part.words == "No module named 'vtkmodules'"
    assert part.mend[remedies.system()] == "uv sync --reinstall-package vtk"


def parts(**broken):
    facts = {"window": {"display": True},
             "headless": {"graphics": {"vendor": "X", "renderer": "llvmpipe", "version": "4"}}}
    return {name: doctor.Part(name, broken.get(name, True), "words", facts=facts.get(name, {}))
            for name in doctor.SHOWN}


def test_what_the_course_needs():
    assert doctor.can_run(parts())
    assert doctor.can_run(parts(reference=False)) and doctor.can_run(parts(window=False))
    assert doctor.can_run(parts(headless=False))  # the window does
    assert not doctor.can_run(parts(headless=False, window=False))
    assert not doctor.can_run(parts(plots=False)) and not doctor.can_run(parts(latex=False))
    blind = parts(headless=False)
    blind["window"].facts["display"] = False
    assert not doctor.can_run(blind)


def test_words():
    assert "The processor draws" in doctor.words(parts()) and "The course can run." in doctor.words(parts())
    assert "needed from chapter 2 on" in doctor.words(parts(reference=False))
    assert "cannot run yet" in doctor.words(parts(plots=False))


def test_run(monkeypatch, capsys):
    monkeypatch.setattr(doctor, "try_all", lambda progress: parts(plots=False))
    assert doctor.run(argparse.Namespace(json=True)) == 1
    assert not json.loads(capsys.readouterr().out)["can_run"]
    monkeypatch.setattr(doctor, "try_all", lambda progress: parts())
    assert doctor.run(argparse.Namespace(json=False)) == 0
    assert "BROKEN" not in capsys.readouterr().out


@pytest.mark.parametrize("name", doctor.SHOWN)
@pytest.mark.parametrize("kind", ["Problem", "ImportError", "ModuleNotFoundError", "NoPicture", ""])
def test_every_part_can_be_mended_on_every_system(name, kind):
    table = remedies.mend(name, kind)
    assert set(table) == set(remedies.SYSTEMS) and all(table.values())
    assert next(iter(table)) == remedies.system()


@pytest.mark.parametrize(("release", "family"), [
    ({"ID": "ubuntu", "ID_LIKE": "debian"}, "debian"), ({"ID": "fedora"}, "fedora"),
    ({"ID": "rocky", "ID_LIKE": "rhel centos fedora"}, "fedora"), ({"ID": "arch"}, "debian")])
def test_family(monkeypatch, release, family):
    monkeypatch.setattr("platform.system", lambda: "Linux")
    monkeypatch.setattr("platform.freedesktop_os_release", lambda: release)
    assert remedies.system() == family
    monkeypatch.setattr("platform.system", lambda: "Darwin")
    assert remedies.system() == "macos"


# the locale of the formulas

FORMULAS = [r"a = b", r"F = F_0 + (1 - F_0)(1 - v \cdot h)^5", r"\begin{aligned} a &= b \\ c &= d \end{aligned}",
            r"L_o = \int_\Omega f_r \, L_i \, (n \cdot \omega_i) \, d\omega_i"]


def test_formulas_are_drawn_and_nothing_is_left_behind():
    code = f"""import os, pathlib, tempfile
from app import locale_alias
files = lambda: set(pathlib.Path(tempfile.gettempdir()).glob("halfway-locale-*"))
before = os.environ.get("LOCPATH"), files()
assert locale_alias.ensure() == locale_alias.ensure() != "missing"
assert os.environ.get("LOCPATH") == before[0] and files() <= before[1]
assert all(locale_alias.draws(formula) for formula in {FORMULAS!r})"""
    subprocess.run([sys.executable, "-c", code], check=True)


@linux
def test_without_any_source_it_is_missing(monkeypatch):
    monkeypatch.setattr(locale_alias, "SOURCES", (Path("/nowhere"),))
    monkeypatch.setattr(locale_alias, "present", lambda: False)
    assert locale_alias.ensure.__wrapped__() == "missing"


@linux
def test_locpath_comes_back(monkeypatch):
    for before in ("/some/where", None):
        if before:
            monkeypatch.setenv("LOCPATH", before)
        else:
            monkeypatch.delenv("LOCPATH", raising=False)
        with locale_alias.named(Path("/usr")):
            folder = Path(os.environ["LOCPATH"].split(":")[0])
            assert (folder / locale_alias.NEEDED).resolve() == Path("/usr")
        assert os.environ.get("LOCPATH") == before and not folder.exists()


def test_the_doctor_itself_loads_nothing_heavy():
    code = ("import sys\nfrom app import doctor\n"
            "sys.exit(bool({'numpy', 'moderngl', 'vtkmodules', 'imgui_bundle', 'rich'} & set(sys.modules)))")
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
