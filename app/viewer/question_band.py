"""The question to the class: large, with the hands as bars once the truth is told."""

from imgui_bundle import ImVec2, imgui

from app.prediction import quantity
from app.theme import Theme, colour, rgb
from app.viewer import style


def draw(app) -> None:
    talk, theme = app.talk, app.theme
    hands, ask = talk.hands, app.session.current.step.ask
    imgui.push_font(None, 1.1 * imgui.get_style().font_size_base)
    imgui.text_wrapped(ask.question)
    imgui.pop_font()
    truth = app.session.answer.truth if talk.is_told else None
    if ask.choices:
        choices(hands, truth, theme)
    elif truth is not None:
        histogram(hands, truth, theme)
    said = f"{hands.total} hands" if hands.total != 1 else "1 hand"
    if truth is None:
        imgui.text_disabled("Make up your mind; then hands up." if not hands.total else said)
    else:
        told = ask.told if ask.choices else f"It is {quantity(truth, ask.unit)}. {ask.told}"
        imgui.text_wrapped(f"{hands.words(truth)} {told}".strip())


def choices(hands, truth: float | None, theme: Theme) -> None:
    unit, right = imgui.get_font_size(), hands.right(truth) if truth is not None else None
    room = imgui.get_content_region_avail().x
    longest = max(imgui.calc_text_size(choice.text).x for choice in hands.ask.choices)
    left = min(longest + 3.2 * unit, 0.7 * room)
    most = max([*hands.counts, 1])
    for i, (text, count) in enumerate(hands.bars()):
        at = imgui.get_cursor_screen_pos()
        ink = style.u32(colour("v" if i == right else "quiet", theme), 0.85)
        draw = imgui.get_window_draw_list()
        sign = "✓" if i == right else "abcdefgh"[i % 8]
        draw.add_text(ImVec2(at.x + 0.2 * unit, at.y), style.u32(style.ink("v", theme) if i == right else
                                                                rgb(theme.quiet)), sign)
        imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + 1.6 * unit)
        imgui.push_text_wrap_pos(imgui.get_cursor_pos_x() + left - 2.0 * unit)
        imgui.text_wrapped(text)
        imgui.pop_text_wrap_pos()
        if truth is not None and hands.total:  # not before: a class follows the longest bar
            wide = (room - left - 3 * unit) * count / most
            draw.add_rect_filled(ImVec2(at.x + left, at.y + 0.15 * unit),
                                 ImVec2(at.x + left + max(wide, 2.0), at.y + 1.05 * unit), ink, 3.0)
            draw.add_text(ImVec2(at.x + left + wide + 0.5 * unit, at.y), style.u32(rgb(theme.foreground)), str(count))


def histogram(hands, truth: float, theme: Theme) -> None:
    """The guesses along the slider, and where the truth lies."""
    unit, at, wide = imgui.get_font_size(), imgui.get_cursor_screen_pos(), imgui.get_content_region_avail().x
    draw, high, bars = imgui.get_window_draw_list(), 3.6 * unit, hands.bars()
    most, each = max([n for _, n in bars] + [1]), wide / len(bars)
    foot = at.y + high + 0.9 * unit
    for i, (_, n) in enumerate(bars):
        if n:
            top = foot - high * n / most
            draw.add_rect_filled(ImVec2(at.x + i * each + 2, top), ImVec2(at.x + (i + 1) * each - 2, foot),
                                 style.u32(colour("estimate", theme), 0.85), 2.0)
    draw.add_line(ImVec2(at.x, foot), ImVec2(at.x + wide, foot), style.u32(rgb(theme.quiet)), 1.5)
    x = at.x + wide * hands.along(truth)
    draw.add_line(ImVec2(x, at.y), ImVec2(x, foot), style.u32(colour("v", theme)), 0.16 * unit)
    for i, (_, n) in enumerate(bars):
        middle = at.x + (i + 0.5) * each - imgui.calc_text_size(str(n)).x / 2
        if n:  # beside the line, should it pass through the bar
            middle += 0.8 * unit if abs(x - at.x - (i + 0.5) * each) < 0.6 * unit else 0.0
            at_top = ImVec2(middle, foot - high * n / most - 1.05 * unit)
            draw.add_text(at_top, style.u32(rgb(theme.foreground)), str(n))
    ends = [quantity(end, hands.ask.unit) for end in (hands.ask.low, hands.ask.high)]
    draw.add_text(ImVec2(at.x, foot + 0.1 * unit), style.u32(rgb(theme.quiet)), ends[0])
    draw.add_text(ImVec2(at.x + wide - imgui.calc_text_size(ends[1]).x, foot + 0.1 * unit),
                  style.u32(rgb(theme.quiet)), ends[1])
    imgui.dummy(ImVec2(wide, high + 2.2 * unit))
