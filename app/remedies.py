"""The command that mends a part, by system: what `doctor` prints beside each part that does not work."""

import os
import platform
from pathlib import Path

SYSTEMS = {"debian": "Debian/Ubuntu", "fedora": "Fedora", "macos": "macOS", "windows": "Windows"}
MESA = {"debian": "sudo apt-get update && sudo apt-get install -y libegl1 libgl1 libgl1-mesa-dri",
        "fedora": "sudo dnf install -y mesa-libEGL mesa-libGL mesa-dri-drivers",
        "macos": "softwareupdate --install --all",  # OpenGL comes with the system
        "windows": "winget install --id 9NQPSL29BFFF --source msstore"}  # OpenGL over DirectX; or the card's own driver
WINDOW = MESA | {
    "debian": MESA["debian"] + " libx11-6 libxrandr2 libxinerama1 libxcursor1 libxi6",
    "fedora": MESA["fedora"] + " libX11 libXrandr libXinerama libXcursor libXi xorg-x11-server-Xwayland"}
DISPLAY = WINDOW | {"debian": "unset DISPLAY", "fedora": "unset DISPLAY"}
XWAYLAND = {"debian": "sudo apt-get update && sudo apt-get install -y xwayland",
            "fedora": "sudo dnf install -y xorg-x11-server-Xwayland"}
LEADS_AWAY = ("LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES", "__EGL_VENDOR_LIBRARY_DIRS", "GBM_BACKENDS_PATH")
LOCALE = {"debian": "sudo apt-get update && sudo apt-get install -y locales && "
                    "sudo localedef -i en_US -f UTF-8 en_US.UTF-8",
          "fedora": "sudo dnf install -y glibc-langpack-en"}
RUNTIME = "winget install --id Microsoft.VCRedist.2015+.x64"  # what wheels with C++ in them need on Windows
PACKAGES = {"headless": "moderngl", "window": "imgui-bundle", "plots": "pyvista", "latex": "imgui-bundle",
            "reference": "scikit-robot-pyrender", "grading": "moderngl"}
INSTALLED_AS = {"imgui_bundle": "imgui-bundle", "pyrender": "scikit-robot-pyrender", "vtkmodules": "vtk",
                "OpenGL": "pyopengl", "PIL": "pillow"}


def system() -> str:
    """The key of this system in SYSTEMS; a Linux of neither family counts as Debian."""
    name = {"Darwin": "macos", "Windows": "windows"}.get(platform.system())
    if name:
        return name
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        return "debian"
    family = f"{release.get('ID', '')} {release.get('ID_LIKE', '')}".split()
    return "fedora" if {"fedora", "rhel", "centos"} & set(family) else "debian"


def mend(part: str, kind: str = "", package: str = "", words: str = "") -> dict[str, str]:
    """The commands for a part that failed with an exception of this kind and these words, this system's first."""
    again = f"uv sync --reinstall-package {INSTALLED_AS.get(package.partition('.')[0], PACKAGES[part])}"
    if kind == "ModuleNotFoundError":
        table = dict.fromkeys(SYSTEMS, again)
    elif kind == "ImportError":  # a library that a wheel needs is missing: on Linux one of the graphics system
        table = WINDOW | {"macos": again, "windows": RUNTIME}
    elif part == "latex":
        table = LOCALE | {"macos": again, "windows": again}
    elif part == "window" and "open display" in words.lower():
        table = DISPLAY
    elif unset := [name for name in LEADS_AWAY if name in os.environ and not any_file(os.environ[name])]:
        table = MESA | dict.fromkeys(("debian", "fedora"), f"unset {' '.join(unset)}")
    else:
        table = WINDOW if part == "window" else MESA
    return first(table)


def first(table: dict[str, str]) -> dict[str, str]:
    """This system's command before the others'."""
    here = system()
    return {name: table[name] for name in sorted(table, key=lambda name: name != here)}


def any_file(paths: str) -> bool:
    return any(Path(path).exists() for path in paths.split(os.pathsep) if path)
