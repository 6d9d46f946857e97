"""The members of a zip or tar archive, in memory; whatever two programs could read differently is refused."""

import bz2
import io
import lzma
import re
import stat
import tarfile
import unicodedata
import zipfile
import zlib

ENDINGS = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz")
NESTED = (*ENDINGS, ".gz", ".bz2", ".xz", ".7z", ".rar", ".whl", ".egg", ".jar", ".zst")
MOST_OF_ONE, MOST_BYTES, MOST_MEMBERS, MOST_RATIO, LONGEST_NAME = 1 << 20, 5 << 20, 50, 100, 200
DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d|conin\$|conout\$)(\..*)?", re.I)
FORMATTING = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")  # categories of characters no name needs


class Refused(Exception):
    """Why a submission is not taken."""


def members(name: str, data: bytes) -> dict[str, bytes]:
    """Path -> bytes of every file; folders are left out."""
    try:
        return of_zip(data) if name.lower().endswith(".zip") else of_tar(data)
    except Refused:
        raise
    except (zipfile.BadZipFile, tarfile.TarError, zlib.error, lzma.LZMAError, EOFError, OSError, ValueError,
            NotImplementedError, RuntimeError, KeyError, IndexError, MemoryError, OverflowError) as error:
        raise Refused(f"the archive {name} is broken ({str(error)[:120] or type(error).__name__}).") from None


def of_zip(data: bytes) -> dict[str, bytes]:
    found: dict[str, bytes] = {}
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        infos = archive.infolist()
        counted([info.filename for info in infos])
        names([getattr(info, "orig_filename", info.filename) for info in infos])
        end = 0
        for info in sorted(infos, key=lambda info: info.header_offset):
            if info.header_offset < end:
                raise Refused("members of the archive overlap.")
            end = info.header_offset + 30 + info.compress_size
        for info in infos:
            kind = stat.S_IFMT(info.external_attr >> 16)
            if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
                raise Refused(f"{info.filename} is a link or a device.")
            if info.flag_bits & 0x1:
                raise Refused(f"{info.filename} is encrypted.")
            if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                raise Refused(f"{info.filename} is packed in a way that is not read here.")
            if info.file_size > MOST_RATIO * max(info.compress_size, 100):
                raise Refused(f"{info.filename} unpacks to more than {MOST_RATIO} times its size.")
        sizes([(info.filename, info.file_size) for info in infos])
        for info in infos:
            if info.is_dir():
                continue
            with archive.open(info) as member:
                found[info.filename] = content = member.read(info.file_size + 1)
                if len(content) != info.file_size or member.read(1):
                    raise Refused(f"{info.filename} has another size than the archive says.")
    return found


def of_tar(data: bytes) -> dict[str, bytes]:
    found: dict[str, bytes] = {}
    with tarfile.open(fileobj=io.BytesIO(unpacked(data)), mode="r:") as archive:
        infos = []
        for info in archive:
            infos.append(info)
            counted(infos)
            if not (info.isreg() or info.isdir()) or info.issparse():
                raise Refused(f"{info.name} is a link, a device or full of holes.")
        names([info.name + ("/" if info.isdir() else "") for info in infos])
        sizes([(info.name, info.size) for info in infos])
        for info in infos:
            member = archive.extractfile(info) if info.isreg() else None
            if member:
                found[info.name] = content = member.read(info.size + 1)
                if len(content) != info.size:
                    raise Refused(f"{info.name} has another size than the archive says.")
    return found


def unpacked(data: bytes) -> bytes:
    """The tar within gzip, bzip2 or xz, as far as it may be long."""
    most = MOST_BYTES + 1024 * (2 * MOST_MEMBERS + 20)
    tool: zlib._Decompress | bz2.BZ2Decompressor | lzma.LZMADecompressor
    if data.startswith(b"\x1f\x8b"):
        tool = zlib.decompressobj(31)
    elif data.startswith(b"BZh"):
        tool = bz2.BZ2Decompressor()
    elif data.startswith(b"\xfd7zXZ"):
        tool = lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=128 << 20)
    else:
        return data
    whole = tool.decompress(data, most + 1)
    if len(whole) > most:
        raise Refused(f"it unpacks to more than {MOST_BYTES >> 20} MB.")
    if not tool.eof:
        raise Refused("the archive is broken (its end is missing).")
    if len(whole) > 10240 + 1024 * MOST_MEMBERS + MOST_RATIO * len(data):
        raise Refused(f"it unpacks to more than {MOST_RATIO} times its size.")
    return whole


def counted(entries: list) -> None:
    if len(entries) > MOST_MEMBERS:
        raise Refused(f"the archive has more than {MOST_MEMBERS} members.")


def sizes(entries: list[tuple[str, int]]) -> None:
    for name, size in entries:
        if not 0 <= size <= MOST_OF_ONE:
            raise Refused(f"{name} is larger than {MOST_OF_ONE >> 20} MB.")
    if sum(size for _, size in entries) > MOST_BYTES:
        raise Refused(f"it unpacks to more than {MOST_BYTES >> 20} MB.")


def names(entries: list[str]) -> None:
    """Names that mean one file on every system; two that could be one are refused."""
    seen: dict[str, str] = {}
    for name in entries:
        why = name_fault(name)
        if why:
            raise Refused(f"the name {name[:100]!a} in the archive {why}.")
        key = unicodedata.normalize("NFC", name.rstrip("/")).casefold()
        if key in seen:
            raise Refused(f"two names in the archive could be the same file: {seen[key][:100]!a} and {name[:100]!a}.")
        seen[key] = name
    folders = {key[:i] for key in seen for i, c in enumerate(key) if c == "/"}
    for key in folders & set(seen):
        if not seen[key].endswith("/"):
            raise Refused(f"{seen[key][:100]!a} is a file and a folder.")


def name_fault(name: str) -> str:
    parts = name.rstrip("/").split("/")
    parts = parts[1:] if parts[:1] == ["."] else parts
    if not name or len(name) > LONGEST_NAME:
        return f"is empty or longer than {LONGEST_NAME} characters"
    if any(unicodedata.category(c) in FORMATTING for c in name):
        return "has characters that cannot be seen"
    if "\\" in name or ":" in name or name.startswith("/"):
        return "is a path from the root, or one of Windows"
    if any(part in ("", ".", "..") for part in parts):
        return "leads out of the archive"
    if any(part.endswith((".", " ")) or DEVICES.fullmatch(part) for part in parts):
        return "means something else on Windows"
    return "is an archive within the archive" if name.lower().endswith(NESTED) else ""
