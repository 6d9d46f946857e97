"""The sliders under the scene: dragged, typed (Ctrl+click), reset (double click); a tool-tip says what each means."""

from imgui_bundle import imgui

from app.catalog import ValueSpec
from app.lesson import Number
from app.quantities import shown
from app.typed import digits
from app.viewer import style

LABEL = 9.5  # em
BOUNDED = imgui.SliderFlags_.always_clamp


def draw(app) -> None:
    """The few controls of the step, and the rest behind "more"."""
    specs = list(app.session.current.values.values())
    imgui.begin_disabled(app.session.frozen)
    for spec in (s for s in specs if not s.more):
        row(app, spec)
    rest = [s for s in specs if s.more]
    if rest and imgui.tree_node("more"):
        for spec in rest:
            row(app, spec)
        imgui.tree_pop()
    imgui.end_disabled()


def row(app, spec: ValueSpec) -> None:
    width = imgui.get_font_size() * LABEL
    imgui.align_text_to_frame_padding()
    imgui.text(words(spec))
    tool_tip(spec)
    imgui.same_line(width)
    imgui.set_next_item_width(-1)
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


GREEK = {"theta": "angle θ", "phi": "azimuth φ", "alpha": "width α", "rho": "albedo ρ", "eta": "index η"}


def words(spec: ValueSpec) -> str:
    """The name a person reads: distance, half angle, angle θ."""
    return GREEK.get(spec.name, spec.name.replace("_", " "))


def choice(spec: ValueSpec, value: Number) -> tuple[bool, Number]:
    found, new = False, value
    for i, text in enumerate(spec.choices):
        if i:
            imgui.same_line()
        if imgui.radio_button(f"{text}##{spec.name}", value == i) and value != i:
            found, new = True, i
    return found, new


def slider(spec: ValueSpec, value: Number) -> tuple[bool, Number]:
    """A slider in screen units; the value comes back in internal ones."""
    flags = BOUNDED | (imgui.SliderFlags_.logarithmic if spec.scale == "log" else 0)
    low, high = (float(shown(spec.name, x)) for x in (spec.low, spec.high))  # type: ignore[arg-type]
    unit = spec.quantity.screen_unit
    label, form = f"##{spec.name}", f"%.{places(spec, low, high)}" + (unit if unit in ("", "°") else f" {unit}")
    now = shown(spec.name, value)
    if spec.quantity.kind == "int":
        return imgui.slider_int(label, int(now), int(low), int(high), "%d", flags)  # type: ignore[arg-type]
    if isinstance(now, tuple):
        draw_slider = imgui.slider_float2 if len(now) == 2 else imgui.slider_float3
        changed, numbers = draw_slider(label, list(now), low, high, form, flags)
        return changed, inside(spec, tuple(numbers))
    changed, number = imgui.slider_float(label, now, low, high, form, flags)
    return changed, inside(spec, number)


def places(spec: ValueSpec, low: float, high: float) -> str:
    if spec.scale == "log" and high / low > 1e3:
        return "3g"
    return "1f" if spec.quantity.is_angle else "2f" if high - low > 0.5 else "3f"


def inside(spec: ValueSpec, value: Number) -> Number:
    from app.quantities import entered

    new = entered(spec.name, value)
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
        f"{words(spec)}: {spec.quantity.words}.\n{low} to {high}{gap}{unit}, at first {first}{gap}{unit}.\n"
        "Ctrl+click to type, double click to reset."
    )


def text(spec: ValueSpec, value: Number) -> str:
    number = shown(spec.name, value)
    return ", ".join(map(digits, number)) if isinstance(number, tuple) else digits(number)


def badge(text: str, shade) -> None:
    """A small word in a colour of the grammar."""
    imgui.push_style_color(imgui.Col_.text, style.vec(shade))
    imgui.text(text)
    imgui.pop_style_color()
