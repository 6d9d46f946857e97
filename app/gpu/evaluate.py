"""A GLSL function as an array function: transform feedback over all points, float32 in, float32 out."""

import moderngl
import numpy as np

from app import shader
from app.gpu.context import context, pixel, program
from app.problem import Problem, Usage, near

WIDTH = {"float": 1, "int": 1, "vec2": 2, "vec3": 3, "vec4": 4}
MAX_CORNERS = 8  # as in glsl/core/constants.glsl
TEXTURE_TRIANGLES = 256  # triangles in a row of a mesh texture


def evaluate(function: str, args: dict, text: str | None = None, ctx: moderngl.Context | None = None) -> np.ndarray:
    """float32 values of a function of glsl/optics (or of `text`) at broadcast arguments.

    args: name -> array; scalars (...), vectors (..., 2|3|4), arrays of corners (..., n, 3), meshes (faces, 3, 3).
    Returns (...) for float, (..., 3) for vec3. An array argument and a mesh are the same for all points.
    """
    include, signature = find(function, text)
    source, varying, fixed = point_program(signature, include if text is None else None, text)
    ctx = ctx or context()
    with ctx:
        vertex = shader.assemble(source, function, header=shader.DESKTOP)
        feedback = program(ctx, vertex, varyings=("value",))
        for arg in fixed:
            bind(ctx, feedback, arg, args[arg.name])
        columns = {a.name: np.asarray(args[a.name], np.int32 if a.type == "int" else np.float32) for a in varying}
        shape = np.broadcast_shapes(*(c.shape[:-1] if WIDTH[a.type] > 1 else c.shape
                                      for a, c in zip(varying, columns.values(), strict=True)))
        count, width = int(np.prod(shape, dtype=int)), WIDTH[signature.returns]
        if count == 0:
            return np.empty((*shape, width) if width > 1 else shape, np.float32)
        buffers = []
        for a in varying:
            wide = WIDTH[a.type]
            full = np.broadcast_to(columns[a.name], (*shape, wide) if wide > 1 else shape)
            buffers.append((ctx.buffer(np.ascontiguousarray(full)), f"{wide}{'i' if a.type == 'int' else 'f'}", f"in_{a.name}"))
        used = [b for b in buffers if b[2] in feedback]
        points = ctx.vertex_array(feedback, used)
        out = ctx.buffer(reserve=4 * width * count)
        before = ctx.fbo
        pixel(ctx).use()
        points.transform(out, moderngl.POINTS, count)
        before.use()
        value = np.frombuffer(out.read(), np.float32)
        for thing in (points, out, *(b[0] for b in buffers)):
            thing.release()
    return value.reshape((*shape, width) if width > 1 else shape)


def find(function: str, text: str | None) -> tuple[str, shader.Signature]:
    known = shader.catalogue() if text is None else {n: ("", s) for n, s in shader.signatures(text).items()}
    if function not in known:
        raise Usage(f"there is no GLSL function {function}.{near(function, known)}")
    return known[function]


def point_program(signature: shader.Signature, include: str | None, text: str | None):
    """The vertex shader that calls the function once a point; which arguments vary and which are fixed."""
    varying = [a for a in signature.args if not a.size and a.type in WIDTH]
    fixed = [a for a in signature.args if a not in varying]
    lines = [f'#include "{include}"' if include else text or ""]
    lines += [f"in {a.type} in_{a.name};" for a in varying]
    lines += [f"uniform {a.type} in_{a.name}{f'[{a.size}]' if a.size else ''};" for a in fixed]
    call = ", ".join(f"in_{a.name}" for a in signature.args)
    lines += [f"flat out {signature.returns} value;" if signature.returns == "int" else f"out {signature.returns} value;",
              f"void main() {{ value = {signature.name}({call}); }}"]
    return "\n".join(lines), varying, fixed


def bind(ctx: moderngl.Context, feedback: moderngl.Program, arg: shader.Argument, given) -> None:
    name = f"in_{arg.name}"
    if name not in feedback:
        return
    if arg.type == "sampler2D":
        mesh_texture(ctx, np.asarray(given)).use(0)
        feedback[name] = 0
        return
    corners = np.asarray(given, np.float32).reshape(-1, WIDTH[arg.type])
    if len(corners) > MAX_CORNERS:
        raise Problem(f"{arg.name} has {len(corners)} corners; the GLSL side takes at most {MAX_CORNERS}.")
    padded = np.zeros((MAX_CORNERS, WIDTH[arg.type]), np.float32)
    padded[:len(corners)] = corners
    feedback[name].write(padded.tobytes())


def mesh_texture(ctx: moderngl.Context, triangles: np.ndarray) -> moderngl.Texture:
    """Triangles (faces, 3, 3) as a float texture: corner c of face f is texel (3 (f mod 256) + c, f div 256);
    the last row is filled up with triangles of no area, which subtend nothing."""
    rows = max(1, -(-len(triangles) // TEXTURE_TRIANGLES))
    padded = np.ones((rows * TEXTURE_TRIANGLES, 3, 3), np.float32)
    padded[:len(triangles)] = triangles
    texture = ctx.texture((3 * TEXTURE_TRIANGLES, rows), 3, padded.tobytes(), dtype="f4")
    texture.filter = moderngl.NEAREST, moderngl.NEAREST
    return texture
