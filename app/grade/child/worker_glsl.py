"""Evaluates the functions of a student's GLSL text on the software renderer, in a process that is locked already.

Transform feedback, not pixels: each point is a vertex with its arguments, and its value goes to its own place in a
buffer. There is no raster, no neighbour, no discard and no second target to get wrong, and nothing runs in a thread.
Blocks of 4096 points are read at once; the buffer is filled before each with a NaN that nobody can guess.
"""

import re
import sys

from frames import LOADED, READY, STARTED, VALUES, Pipe, Questions

CONTEXT = {"backend": "egl", "libgl": "libGL.so.1", "libegl": "libEGL.so.1"}  # by name: a search is a process
BLOCK = 4096
FEW = 4  # steps of a loop of ours after the student's: llvmpipe allows all loops of one call 65 535 together
TYPES = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}
MESSAGE = re.compile(r"^\s*(?:ERROR:\s*)?(\d+)[:(](\d+)\)?(?:\((\d+)\))?\s*:?\s*(.*)$")


def compiled(ctx, source: str):
    made = ctx.program(vertex_shader=source, varyings=("halfway_value", "halfway_steps"))
    made["halfway_few"] = FEW
    return made


def program_text(text: str, call: dict) -> str:
    """Prologue, the student's text as source 1, our main as source 2: the compiler names lines by these numbers."""
    inputs = "".join(f"in {TYPES[width]} halfway_{i};\n" for i, width in enumerate(call["columns"]))
    names = ", ".join(f"halfway_{i}" for i in range(len(call["columns"])))
    return (f"#version 330 core\n#line 1 1\n{text}\n#line 1 2\n{inputs}out {TYPES[call['width']]} halfway_value;\n"
            f"out float halfway_steps;\nuniform int halfway_few;\n"
            f"void main() {{ halfway_value = {call['function']}({names}); halfway_steps = 0.0;\n"
            f"for (int i = 0; i < halfway_few; i++) halfway_steps += 1.0; }}\n")


def told(message: str, lines: int) -> str:
    """The compiler's words about the student's own lines, three at most; never a line of ours."""
    if "halfway_value undeclared" in message:
        return "it compiles, but gives no value: a loop that never ends does that"
    found = []
    for raw in message.splitlines():
        match = MESSAGE.match(raw)
        if match and "warning" not in match[4][:20] and match[1] != "2" and int(match[2]) <= lines:
            more = " - is one missing at the end of the line above?" if match[4].endswith("';'") else ""
            found.append((f"line {match[2]}: {match[4]}" if int(match[2]) else match[4]) + more)
    return "; ".join(dict.fromkeys(found[:3])) or "it does not compile together with a call of the asked function"


def main(order: dict) -> None:
    import moderngl  # noqa: TID251 - a process of its own, which cannot import app.gpu
    import numpy

    pipe, questions = Pipe(order["out"]), Questions()
    text, calls = questions.header["text"], questions.header["calls"]
    names: dict = CONTEXT if sys.platform.startswith("linux") else {}
    ctx = moderngl.create_context(standalone=True, require=330, **names)
    ctx.simple_framebuffer((1, 1)).use()
    pipe.send(STARTED, READY)
    pipe.send(LOADED, READY)
    programs: dict[str, moderngl.Program | str] = {}
    sentinel = numpy.uint32(0x7FC00000 | (questions.header["sentinel"] & 0x1FFFFF) | 1)
    place = questions.start
    for index, call in enumerate(calls):
        count, width, columns = call["count"], call["width"], call["columns"]
        source = program_text(text, call)
        if source not in programs:
            try:
                programs[source] = compiled(ctx, source)
            except moderngl.Error as error:
                programs[source] = told(str(error), text.count("\n") + 1)
        program = programs[source]
        starts = []
        for n in columns:
            starts.append(place)
            place += 4 * count * n
        if isinstance(program, str):
            pipe.refuse(index, "compile_error", program)
            continue
        values, steps = numpy.empty((count, width), "<f4"), numpy.empty(count, "<f4")
        filler = numpy.full(BLOCK * (width + 1), sentinel, "<u4")
        used = [i for i in range(len(columns)) if f"halfway_{i}" in program]
        buffers = [ctx.buffer(reserve=4 * BLOCK * columns[i]) for i in used]
        out = ctx.buffer(reserve=4 * BLOCK * (width + 1))
        points = ctx.vertex_array(program, [(buffer, f"{columns[i]}f", f"halfway_{i}")
                                            for i, buffer in zip(used, buffers, strict=True)])
        for first in range(0, count, BLOCK):
            here = min(BLOCK, count - first)
            for i, buffer in zip(used, buffers, strict=True):
                buffer.write(questions.read(4 * here * columns[i], starts[i] + 4 * first * columns[i]))
            out.write(filler)
            points.transform(out, moderngl.POINTS, here)
            got = numpy.frombuffer(out.read(4 * here * (width + 1)), "<f4").reshape(here, width + 1)
            values[first:first + here], steps[first:first + here] = got[:, :width], got[:, width]
        points.release()
        for buffer in (out, *buffers):
            buffer.release()
        left = int(numpy.count_nonzero(values.view("<u4") == sentinel))
        cut = int(numpy.count_nonzero(steps != FEW))
        if cut:
            pipe.refuse(index, "wrong", f"at {cut} of {count} points its loops were cut off: all loops of one call "
                        "have 65 535 steps together here, and one that never ends has no more")
        elif left:
            pipe.refuse(index, "unwritten", f"{left} of {count * width} numbers were never written")
        else:
            pipe.send(index, VALUES, values.astype("<f8").tobytes())
