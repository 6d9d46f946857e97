"""A theme as the look of the window; every length is in em, so that it grows with the text."""

from imgui_bundle import ImVec2, ImVec4, hello_imgui, imgui

from app.fonts import font_files
from app.theme import Theme, colour, rgb

Rgb = tuple[float, float, float]
CODE: list = []  # the font of code, once it is loaded
READABLE = 4.5  # contrast of words with their ground (WCAG 2, AA)


def vec(c: Rgb, alpha: float = 1.0) -> ImVec4:
    return ImVec4(*c, alpha)


def u32(c: Rgb, alpha: float = 1.0) -> int:
    return imgui.get_color_u32(vec(c, alpha))


def mix(a: Rgb, b: Rgb, share: float) -> Rgb:
    return tuple(x + (y - x) * share for x, y in zip(a, b, strict=True))  # type: ignore[return-value]


def ink(name: str, theme: Theme) -> Rgb:
    """A colour of the grammar for words: as it is if it can be read on the panel, else nearer to the foreground."""
    shade, panel, front = colour(name, theme), luminance(rgb(theme.panel)), rgb(theme.foreground)
    share = 0.0
    while share < 1.0 and contrast(luminance(mix(shade, front, share)), panel) < READABLE:
        share += 0.05
    return mix(shade, front, share)


def luminance(c: Rgb) -> float:
    red, green, blue = (x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in c)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(a: float, b: float) -> float:
    return (max(a, b) + 0.05) / (min(a, b) + 0.05)


def em(x: float, y: float | None = None) -> ImVec2:
    size = imgui.get_font_size()
    return ImVec2(x * size, (x if y is None else y) * size)


def load_font() -> None:
    """One font for everything; its glyphs are made when they are first drawn."""
    hello_imgui.get_runner_params().callbacks.default_icon_font = hello_imgui.DefaultIconFont.no_icons
    hello_imgui.load_font_ttf("fonts/Roboto/Roboto-Regular.ttf", 16.0)
    merged = hello_imgui.FontLoadingParams()
    merged.merge_to_last_font = True
    hello_imgui.load_font("fonts/latex/latinmodern-math.otf", 16.0, merged)  # what Roboto lacks: arrows, ⊥, ≥
    if files := font_files():  # and what both lack: ₀, ₁
        merged.inside_assets = False
        hello_imgui.load_font(str(files[0]), 16.0, merged)


    CODE[:] = [hello_imgui.load_font_ttf("fonts/Inconsolata-Medium.ttf", 16.0)]


def code_font():
    return CODE[0]


def apply(theme: Theme, height: float) -> None:
    """Colours, roundings and the text size for a window `height` pixels high."""
    hello_imgui.get_runner_params().imgui_window_params.background_color = vec(rgb(theme.panel))
    style = imgui.get_style()
    (imgui.style_colors_dark if theme.name == "dark" else imgui.style_colors_light)()
    style.font_size_base = style._next_frame_font_size_base = text_size(
        theme, height
    )  # as Dear ImGui's own style editor
    style.frame_rounding = style.grab_rounding = style.popup_rounding = style.child_rounding = 5.0
    style.window_rounding = 0.0
    style.window_border_size = 0.0
    style.frame_border_size = 1.0 if theme.name == "projector" else 0.0
    style.window_padding, style.item_spacing = ImVec2(14, 10), ImVec2(9, 7)
    style.frame_padding = ImVec2(8, 4)
    front, panel, quiet = rgb(theme.foreground), rgb(theme.panel), rgb(theme.quiet)
    accent = colour("l", theme)
    grab = mix(accent, panel, 0.45) if theme.name == "dark" else accent  # a number is read on it
    shades = {
        "text": (front, 1.0),
        "text_disabled": (quiet, 1.0),
        "window_bg": (panel, 1.0),
        "child_bg": (panel, 0.0),
        "popup_bg": (mix(panel, front, 0.04), 1.0),
        "border": (quiet, 0.45),
        "frame_bg": (mix(panel, front, 0.09), 1.0),
        "frame_bg_hovered": (mix(panel, front, 0.15), 1.0),
        "frame_bg_active": (mix(panel, front, 0.2), 1.0),
        "slider_grab": (grab, 1.0),
        "slider_grab_active": (grab, 1.0),
        "check_mark": (accent, 1.0),
        "button": (mix(panel, front, 0.11), 1.0),
        "button_hovered": (mix(panel, front, 0.19), 1.0),
        "button_active": (mix(panel, front, 0.27), 1.0),
        "header": (mix(panel, front, 0.1), 1.0),
        "header_hovered": (mix(panel, front, 0.16), 1.0),
        "header_active": (mix(panel, front, 0.22), 1.0),
        "separator": (quiet, 0.35),
        "scrollbar_bg": (panel, 0.0),
        "scrollbar_grab": (quiet, 0.5),
        "nav_cursor": (accent, 1.0),
        "text_link": (colour("estimate" if theme.name == "dark" else "n", theme), 1.0),
        "title_bg": (panel, 1.0),
        "title_bg_active": (mix(panel, front, 0.08), 1.0),
        "plot_histogram": (accent, 1.0),
        "modal_window_dim_bg": (rgb(theme.background), 0.6),
    }
    for name, (shade, alpha) in shades.items():
        style.set_color_(getattr(imgui.Col_, name), vec(shade, alpha))


def text_size(theme: Theme, height: float) -> float:
    """The theme's size at 720 pixels, growing with the window, slower than it."""
    return round(theme.text * min(max((height / 720) ** 0.6, 0.85), 2.0), 1)
