"""A GLSL function as an array function: transform feedback over all points, float32 in, float32 out."""

from typing import cast

import moderngl
import numpy as np

from app import loops, shader
from app.gpu.context import context, endless, kept, pixel, program
from app.problem import Problem, Usage, near
from app.shader import WIDTH

MAX_CORNERS = 8  # as in glsl/core/constants.glsl
PASSING = 32  # programs of texts that are being edited
TEXTURE_TRIANGLES = 256  # triangles in a row of a mesh texture


def evaluate(function: str, args: dict, text: str | None = None, ctx: moderngl.Context | None = None,
             overrides: dict[str, shader.Source] | None = None, uniforms: dict | None = None) -> np.ndarray:
    """float32 values of a function of glsl/optics (or of `text`) at broadcast arguments; int32 of one that returns int.

    args: name -> array; scalars (...), vectors (..., 2|3|4), arrays of corners (n, 2|3|4), meshes (faces, 3, 3), tables
    (rows, columns). Returns (...) for float, (..., 3) for vec3. Arrays, meshes and tables are the same for all points.
    A `text` may include what `overrides` holds, and have `uniforms` of its own.
    """
    include, signature = find(function, text)
    source, varying, fixed = point_program(signature, include if text is None else None, text)
    assembled = assembled_with(source, function, overrides)
    columns = {arg.name: column(function, arg, args) for arg in varying}
    for arg in fixed:
        column(function, arg, args)
    try:
        shape = np.broadcast_shapes(*(c.shape[:-1] if WIDTH[a.type] > 1 else c.shape
                                      for a, c in zip(varying, columns.values(), strict=True)))
    except ValueError:
        raise Usage(f"{function}: the shapes of its arguments do not fit together: "
                    + ", ".join(f"{name} {c.shape}" for name, c in columns.items()) + ".") from None
    count, width = int(np.prod(shape, dtype=int)), WIDTH[signature.returns]
    ctx = ctx or context()
    with ctx:
        feedback = linked(ctx, assembled, overrides)
        for name in (uniforms or {}).keys() & set(feedback):
            cast(moderngl.Uniform, feedback[name]).value = (uniforms or {})[name]
        if count == 0:
            return np.empty((*shape, width) if width > 1 else shape, np.float32)
        made: list = [bind(ctx, feedback, arg, args[arg.name]) for arg in fixed]
        used = []
        for a in varying:
            if f"in_{a.name}" in feedback:
                full = np.broadcast_to(columns[a.name], (*shape, WIDTH[a.type]) if WIDTH[a.type] > 1 else shape)
                made.append(ctx.buffer(np.ascontiguousarray(full)))
                used.append((made[-1], f"{WIDTH[a.type]}{'i' if a.type == 'int' else 'f'}", f"in_{a.name}"))
        points = ctx.vertex_array(feedback, used)
        columns_out = width + is_watched(assembled)
        out = ctx.buffer(reserve=4 * columns_out * count)
        before = ctx.fbo
        pixel(ctx).use()
        points.transform(out, moderngl.POINTS, count)
        before.use()
        found = np.frombuffer(out.read(), np.int32).reshape(count, columns_out)
        for thing in (points, out, *made):
            if thing is not None:
                thing.release()
    if line := found[:, width:].max(initial=0):
        raise endless(int(line), assembled)
    value = np.ascontiguousarray(found[:, :width]).view(np.int32 if signature.returns == "int" else np.float32)
    return value.reshape((*shape, width) if width > 1 else shape)


def column(function: str, arg: shader.Argument, args: dict) -> np.ndarray:
    """An argument as numbers of its type, its last axes as the type wants them."""
    if arg.name not in args:
        raise Usage(f"{function} needs {arg.name}.{near(arg.name, args)}")
    data = np.asarray(args[arg.name], np.int32 if arg.type == "int" else np.float32)
    if arg.type == "sampler2D" and arg.name != "triangles":
        if data.ndim != 2 and not is_map(data):
            raise Usage(f"{function}: {arg.name} is one table of rows and columns for all points, not {data.shape}.")
        return data
    tail: tuple[int, ...] = (3, 3) if arg.type == "sampler2D" else (WIDTH[arg.type],) if WIDTH[arg.type] > 1 else ()
    if arg.type == "sampler2D" or arg.size:
        if data.ndim != len(tail) + 1 or data.shape[1:] != tail:
            raise Usage(f"{function}: {arg.name} is one array of shape {('n', *tail)} for all points, "
                        f"not {data.shape}.")
        if arg.size and len(data) > MAX_CORNERS:
            raise Problem(f"{arg.name} has {len(data)} corners; the GLSL side takes at most {MAX_CORNERS}.")
    elif data.shape[data.ndim - len(tail):] != tail:
        raise Usage(f"{function}: {arg.name} is a {arg.type}, its last axis has {tail[0]} numbers; "
                    f"it has shape {data.shape}.")
    return data


def assembled_with(source: str, function: str, overrides: dict[str, shader.Source] | None) -> shader.Assembled:
    """The text to compile; one with loops of the user's also tells which of them was left."""
    assembled = shader.assemble(source, function, header=shader.DESKTOP, overrides=overrides)
    if not is_watched(assembled):
        return assembled
    watched = f'#define main stage_main\n{source}\n#undef main\n#include "stage/watched.vert"'
    return shader.assemble(watched, function, header=shader.DESKTOP, overrides=overrides)


def is_watched(assembled: shader.Assembled) -> bool:
    return loops.COUNT in assembled.text


def linked(ctx: moderngl.Context, assembled: shader.Assembled, overrides: object):
    varyings = ("value", "v_endless") if is_watched(assembled) else ("value",)
    return program(ctx, assembled, varyings=varyings, passing=passing(ctx) if overrides else None)


def passing(ctx: moderngl.Context) -> dict:
    """The programs of the texts that were edited last."""
    programs = kept(ctx).setdefault("passing", {})
    while len(programs) > PASSING:
        programs.pop(next(iter(programs))).release()
    return programs


def find(function: str, text: str | None) -> tuple[str, shader.Signature]:
    known = shader.catalogue() if text is None else {n: ("", s) for n, s in shader.signatures(text).items()}
    if function not in known:
        raise Usage(f"there is no GLSL function {function}.{near(function, known)}")
    signature = known[function][1]
    types = (signature.returns, *(a.type for a in signature.args))
    odd = [kind for kind in types if kind not in (*WIDTH, "sampler2D")]
    if odd or signature.returns == "sampler2D":
        raise Usage(f"{function} cannot be called point by point: it has the type {(odd or ['sampler2D'])[0]}; "
                    f"possible are {', '.join(WIDTH)}.")
    return known[function]


def point_program(signature: shader.Signature, include: str | None, text: str | None):
    """The vertex shader that calls the function once a point; which arguments vary and which are fixed."""
    varying = [a for a in signature.args if not a.size and a.type in WIDTH]
    fixed = [a for a in signature.args if a not in varying]
    lines = [f'#include "{include}"' if include else text or ""]
    lines += [f"in {a.type} in_{a.name};" for a in varying]
    lines += [f"uniform {a.type} in_{a.name}{f'[{a.size}]' if a.size else ''};" for a in fixed]
    call = ", ".join(f"in_{a.name}" for a in signature.args)
    lines += [f"{'flat ' * (signature.returns == 'int')}out {signature.returns} value;",
              f"void main() {{ value = {signature.name}({call}); }}"]
    return "\n".join(lines), varying, fixed


def bind(ctx: moderngl.Context, feedback: moderngl.Program, arg: shader.Argument, given) -> moderngl.Texture | None:
    """Set an argument that is the same for all points; the texture it made, to be released after the call."""
    name = f"in_{arg.name}"
    if name not in feedback:
        return None
    if arg.type == "sampler2D":
        texture = data_texture(ctx, np.asarray(given))
        texture.use(0)
        feedback[name] = 0
        return texture
    padded = np.zeros((MAX_CORNERS, WIDTH[arg.type]), np.int32 if arg.type == "int" else np.float32)
    padded[:len(given)] = np.reshape(given, (len(given), -1))
    uniform = cast(moderngl.Uniform, feedback[name])
    uniform.write(padded[:uniform.array_length].tobytes())
    return None


def data_texture(ctx: moderngl.Context, data: np.ndarray) -> moderngl.Texture:
    """Constant data as a float texture to be read by texelFetch: a mesh (faces, 3, 3), or a table (rows, columns),
    whose number at [row, column] is texel (column, row)."""
    if is_map(data):
        return map_texture(ctx, data)
    if data.ndim == 3:
        return mesh_texture(ctx, data)
    rows, columns = data.shape
    limit = ctx.info["GL_MAX_TEXTURE_SIZE"]
    if max(rows, columns) > limit:
        raise Problem(f"a table of {rows} x {columns} numbers is larger than this OpenGL can hold ({limit} a side).")
    texture = ctx.texture((columns, rows), 1, np.ascontiguousarray(data, "f4").tobytes(), dtype="f4")
    texture.filter = moderngl.NEAREST, moderngl.NEAREST
    return texture


def is_map(data: np.ndarray) -> bool:
    """Four channels a texel (rows, columns, 4): no mesh, whose corners have three numbers."""
    return data.ndim == 3 and data.shape[-1] == 4


def map_texture(ctx: moderngl.Context, texels: np.ndarray) -> moderngl.Texture:
    """A picture's stored bytes, 0 to 1, to be sampled at any scale; the lowest row first."""
    rows, columns, _ = texels.shape
    texture = ctx.texture((columns, rows), 4, np.ascontiguousarray(texels, "u1").tobytes())
    texture.build_mipmaps()
    texture.filter = moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR
    return texture


def mesh_texture(ctx: moderngl.Context, triangles: np.ndarray) -> moderngl.Texture:
    """Triangles (faces, 3, 3) as a float texture: corner c of face f is texel (3 (f mod 256) + c, f div 256);
    the last row is filled up with triangles of no area, which subtend nothing."""
    rows = max(1, -(-len(triangles) // TEXTURE_TRIANGLES))
    padded = np.ones((rows * TEXTURE_TRIANGLES, 3, 3), np.float32)
    padded[:len(triangles)] = triangles
    texture = ctx.texture((3 * TEXTURE_TRIANGLES, rows), 3, padded.tobytes(), dtype="f4")
    texture.filter = moderngl.NEAREST, moderngl.NEAREST
    return texture
