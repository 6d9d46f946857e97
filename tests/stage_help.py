"""What the tests of the GPU share: a watch over what OpenGL made, small scenes, and a picture's numbers."""

import moderngl

KINDS = ("buffer", "texture", "renderbuffer", "depth_renderbuffer", "framebuffer", "vertex_array")


def watch(monkeypatch) -> list:
    """Everything made on the GPU from now to the end of the test, in order."""
    found: list = []
    for kind in KINDS:
        original = getattr(moderngl.Context, kind)

        def watched(self, *args, original=original, **kwargs):
            found.append(original(self, *args, **kwargs))
            return found[-1]

        monkeypatch.setattr(moderngl.Context, kind, watched)
    return found


def is_alive(thing) -> bool:
    return type(thing.mglo).__name__ != "InvalidObject"
