"""The sliders under the scene: dragged, typed (Ctrl+click), reset (double click); a tool-tip says what each means."""

from collections.abc import Iterable

from imgui_bundle import imgui

from app.catalog import ValueSpec
from app.lesson import Number
from app.spoken import said, words
from app.typed import digits, places
from app.viewer import style
from app.viewer.cut import on_a_line

LABEL = 9.5  # em: at most
BOUNDED = imgui.SliderFlags_.always_clamp


def draw(app) -> bool:
    """The few controls of the step, and the rest behind "more": whether that is open."""
    return rows(app, app.session.current.below)


def rows(app, specs: Iterable[ValueSpec]) -> bool:
    specs = list(specs)
    left = label_width(specs)
    imgui.begin_disabled(app.session.frozen)
    for spec in (s for s in specs if not s.more):
        row(app, spec, left)
    rest = [s for s in specs if s.more]
    is_open = bool(rest) and imgui.tree_node("more")
    if is_open:
        for spec in rest:
            row(app, spec, left)
        imgui.tree_pop()
    imgui.end_disabled()
    return is_open


def label(spec: ValueSpec) -> str:
    if spec.label:
        return spec.label
    return said(spec.name) if spec.choices else words(spec.name)


def label_width(specs: Iterable[ValueSpec]) -> float:
    unit = imgui.get_font_size()
    return min(max((imgui.calc_text_size(label(s)).x for s in specs), default=0.0) + 2.5 * unit, LABEL * unit)


def height(specs: Iterable[ValueSpec], room: float, is_open: bool) -> float:
    """What the controls take of a column `room` wide, with or without those behind "more"."""
    specs = list(specs)
    room -= label_width(specs)
    rows = sum(len(lines(s, room)) for s in specs if is_open or not s.more) + any(s.more for s in specs)
    return rows * imgui.get_frame_height_with_spacing() + imgui.get_style().item_spacing.y


def lines(spec: ValueSpec, room: float) -> list[list[int]]:
    """The choices of a value, in as many lines as they need; a slider is one."""
    found: list[list[int]] = [[]]
    if spec.unfolds:
        return found
    style, x = imgui.get_style(), 0.0
    for i in range(int(spec.low), int(spec.high) + 1) if spec.choices else ():
        width = imgui.get_frame_height() + style.item_inner_spacing.x + imgui.calc_text_size(spec.choices[i]).x
        if found[-1] and x + width > room:
            found.append([])
            x = 0.0
        found[-1].append(i)
        x += width + style.item_spacing.x
    return found


def row(app, spec: ValueSpec, width: float, left_free: float = 1.0) -> None:
    """A label, `width` wide, and the slider in the rest of the line but for what is left free."""
    imgui.align_text_to_frame_padding()
    on_a_line(label(spec), width - 0.4 * imgui.get_font_size())
    tool_tip(spec)
    imgui.same_line(width)
    imgui.set_next_item_width(-left_free)
    value = app.session.values[spec.name]
    changed, new = choice(spec, value) if spec.choices else slider(spec, value)
    if imgui.is_item_activated():
        app.session.begin_change()
    if changed:
        app.set_value(spec.name, new)
    if imgui.is_item_deactivated():
        app.session.end_change()
    if imgui.is_item_hovered(imgui.HoveredFlags_.allow_when_disabled):
        if imgui.is_mouse_double_clicked(0) and not spec.choices:
            app.session.reset(spec.name)
        tool_tip(spec)


def choice(spec: ValueSpec, value: Number) -> tuple[bool, Number]:
    found, new = False, value
    if spec.unfolds:
        return imgui.combo(f"##{spec.name}", int(value), list(spec.choices))  # type: ignore[arg-type]
    left = imgui.get_cursor_pos_x()
    for line in lines(spec, imgui.get_content_region_avail().x):
        imgui.set_cursor_pos_x(left)
        for i in line:
            if i != line[0]:
                imgui.same_line()
            if imgui.radio_button(f"{spec.choices[i]}##{spec.name}", value == i) and value != i:
                found, new = True, i
    return found, new


def slider(spec: ValueSpec, value: Number) -> tuple[bool, Number]:
    """A slider in screen units; the value comes back in internal ones."""
    flags = BOUNDED | (imgui.SliderFlags_.logarithmic if spec.scale == "log" else 0)
    low, high = (float(spec.quantity.shown(x)) for x in (spec.low, spec.high))  # type: ignore[arg-type]
    unit = spec.quantity.screen_unit
    now = spec.quantity.shown(value)
    label, form = f"##{spec.name}", f"%.{places(spec, now)}" + (unit if unit in ("", "°") else f" {unit}")
    if spec.quantity.kind == "int":
        return imgui.slider_int(label, int(now), int(low), int(high), "%d", flags)  # type: ignore[arg-type]
    if spec.quantity.kind == "color" and isinstance(now, tuple):
        changed, numbers = imgui.color_edit3(label, list(now), imgui.ColorEditFlags_.float)
        return changed, inside(spec, tuple(numbers))
    if isinstance(now, tuple):
        draw_slider = imgui.slider_float2 if len(now) == 2 else imgui.slider_float3
        changed, numbers = draw_slider(label, list(now), low, high, form, flags)
        return changed, inside(spec, tuple(numbers))
    changed, number = imgui.slider_float(label, now, low, high, form, flags)
    return changed, inside(spec, number)


def inside(spec: ValueSpec, value: Number) -> Number:
    new = spec.quantity.entered(value)
    if isinstance(new, tuple):
        return tuple(min(max(x, spec.low), spec.high) for x in new)
    return min(max(new, spec.low), spec.high)


def tool_tip(spec: ValueSpec) -> None:
    if not imgui.is_item_hovered(imgui.HoveredFlags_.delay_normal | imgui.HoveredFlags_.allow_when_disabled):
        return
    unit = spec.quantity.screen_unit
    low, high, first = (text(spec, x) for x in (spec.low, spec.high, spec.default))
    gap = "" if unit in ("", "°") else " "
    imgui.set_tooltip(
        f"{spec.label or words(spec.name)}: {spec.quantity.words}.\n"
        f"{low} to {high}{gap}{unit}, at first {first}{gap}{unit}.\n"
        "Ctrl+click to type, double click to reset."
    )


def text(spec: ValueSpec, value: Number) -> str:
    number = spec.quantity.shown(value)
    return ", ".join(map(digits, number)) if isinstance(number, tuple) else digits(number)


def badge(text: str, shade) -> None:
    """A small word in a colour of the grammar."""
    imgui.push_style_color(imgui.Col_.text, style.vec(shade))
    imgui.text(text)
    imgui.pop_style_color()
