"""A mesh file before it is parsed: what can be said from its name, its size and its first bytes. No library needed."""

import json
import re
import struct
from pathlib import Path

from app.problem import Problem

KINDS = {".stl": "stl", ".obj": "obj", ".ply": "ply", ".glb": "glb"}
TRIANGLES = 1_000_000
BYTES = 512 << 20


def read(path: Path) -> tuple[str, bytes]:
    """The kind of file and its bytes; Problem where a look at them shows that no mesh will come out."""
    kind = KINDS.get(path.suffix.lower())
    try:
        if path.is_dir():
            raise Problem(f"{path} is a folder; give one file in it ({', '.join(KINDS)}).")
        size = path.stat().st_size
        if kind is None:
            hint = " Export a .gltf as .glb, which is the same in one file." if path.suffix.lower() == ".gltf" else ""
            what = f"ends in {path.suffix!r}" if path.suffix else "has no ending"
            raise Problem(f"{path} {what}; a mesh can be {', '.join(KINDS)}.{hint}")
        if not path.is_file():
            raise Problem(f"{path} is not a file on a disk; give the path of a mesh ({', '.join(KINDS)}).")
        if size > BYTES:
            raise Problem(f"{path} has {size / 2**20:.0f} MB; the limit is {BYTES >> 20} MB and {TRIANGLES} triangles. "
                          + SMALLER)
        data = path.read_bytes()
    except FileNotFoundError:
        raise Problem(f"There is no file {path}; give the path of a mesh ({', '.join(KINDS)}).") from None
    except PermissionError:
        raise Problem(f"{path} may not be read; give yourself the right, for example with chmod u+r.") from None
    except (OSError, ValueError) as error:
        raise Problem(f"{path} could not be read ({plain(error)}); copy it to a local disk and try again.") from None
    if not data.strip():
        raise Problem(f"{path} is empty; export the mesh again.")
    {"stl": stl, "ply": ply, "glb": glb, "obj": obj}[kind](path, data)
    return kind, data


SMALLER = "Make it smaller first: in Blender the modifier Decimate, in MeshLab Quadric Edge Collapse Decimation."


def limit(path: Path, count: int) -> None:
    if count > TRIANGLES:
        raise Problem(f"{path} has {count} triangles; the limit is {TRIANGLES}. {SMALLER}")


def plain(error: BaseException) -> str:
    """An exception's own words on one line, or its name."""
    words = " ".join(str(error).split()).rstrip(".") or type(error).__name__
    return words if len(words) <= 120 else words[:117] + "..."


def stl(path: Path, data: bytes) -> None:
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else None
    if count is not None and len(data) == 84 + 50 * count:
        return limit(path, count)
    if data.lstrip()[:5].lower() == b"solid" and b"\0" not in data[:1000]:
        if b"endsolid" not in data.lower():
            raise Problem(f"{path} is cut short: a text STL ends with 'endsolid', which is missing; export it again.")
        return limit(path, data.lower().count(b"endloop"))
    if count is None:
        raise Problem(f"{path} is not an STL file: it has {len(data)} bytes, a binary one at least 84, "
                      "and a text one begins with 'solid'.")
    whole = (len(data) - 84) // 50
    if whole < count <= 100 * TRIANGLES:
        raise Problem(f"{path} is cut short: it promises {count} triangles and holds {whole}; "
                      "copy or export it again.")
    raise Problem(f"{path} is not an STL file: its {len(data)} bytes do not fit the {count} triangles of its header; "
                  "check the ending of its name, or export it again.")


def ply(path: Path, data: bytes) -> None:
    if not data.startswith(b"ply"):
        raise Problem(f"{path} is not a PLY file: the first line has to be 'ply'; check the ending of its name.")
    header = re.match(rb"ply\s.*?end_header\s", data, re.S)
    if not header:
        raise Problem(f"{path} is cut short: its header has no 'end_header'; export it again.")
    counts = {name: int(n) for name, n in re.findall(rb"^element\s+(\w+)\s+(\d+)", header[0], re.M)}
    limit(path, counts.get(b"face", 0))
    rows, lines = sum(counts.values()), len(data[header.end():].split(b"\n")) - data.endswith(b"\n")
    if b"format ascii" in header[0] and lines < rows:
        raise Problem(f"{path} is cut short: its header promises {rows} lines and {lines} follow; export it again.")


def obj(path: Path, data: bytes) -> None:
    if b"\0" in data or not re.search(rb"^\s*v\s", data, re.M):
        raise Problem(f"{path} is not an OBJ file: no line of it is 'v x y z'; check the ending of its name.")
    limit(path, data.count(b"\nf "))


def glb(path: Path, data: bytes) -> None:
    if data[:4] != b"glTF" or len(data) < 20:
        raise Problem(f"{path} is not a GLB file: it has to begin with 'glTF'; check the ending of its name.")
    version, length, text = struct.unpack_from("<III", data, 4)
    if version != 2:
        raise Problem(f"{path} is glTF version {version}; version 2 is needed, so export it with a newer program.")
    if length > len(data) or 20 + text > len(data):
        raise Problem(f"{path} is cut short: it promises {length} bytes and has {len(data)}; copy or export it again.")
    try:
        header = json.loads(data[20:20 + text])
        needed = [name for name in header.get("extensionsRequired", []) if "compression" in name]
        outside = [uri for part in header.get("buffers", []) if (uri := part.get("uri", "")) and uri[:5] != "data:"]
        most = max([int(part["count"]) for part in header.get("accessors", [])], default=0)
    except (ValueError, LookupError, AttributeError, TypeError, RecursionError) as error:
        raise Problem(f"{path}: the description inside the GLB is damaged ({plain(error)}); export it again.") from None
    limit(path, most // 3)
    if needed:
        raise Problem(f"{path} is compressed ({', '.join(needed)}); export it without compression.")
    if outside:
        raise Problem(f"{path} keeps its geometry in another file ({outside[0]}); export all of it as one .glb.")


def promised(kind: str, data: bytes) -> int:
    """How many faces the file speaks of, where that is easy to tell; a face may be more than one triangle."""
    if kind == "ply" and (count := re.search(rb"^element\s+face\s+(\d+)", data[:100_000], re.M)):
        return int(count[1])
    return data.count(b"\nf ") if kind == "obj" else 0


def explain(path: Path, kind: str, data: bytes) -> None:
    """Problem with the first wrong line of an OBJ file; nothing where no line is to blame."""
    if kind != "obj":
        return
    corners = 0
    for row, line in enumerate(data.decode(errors="replace").splitlines(), 1):
        what, *words = line.split("#")[0].split() or [""]
        if what == "v":
            corners += 1
            if len(words) < 3 or not all(map(is_number, words)):
                raise Problem(f"{path}, line {row}: {line.strip()[:60]!r} should be 'v' and three numbers.")
        if what == "f":
            for word in words:
                first = word.split("/")[0]
                if not re.fullmatch(r"-?\d+", first):
                    raise Problem(f"{path}, line {row}: {word[:20]!r} should be the number of a corner.")
                if not 0 < abs(int(first)) <= corners:
                    raise Problem(f"{path}, line {row}: the face uses corner {first}, but up to there "
                                  f"the file has the corners 1 to {corners}.")


def is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
