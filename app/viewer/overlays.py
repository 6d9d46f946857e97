"""What lies over the lesson for a moment: the first picture, the outline with its search, the keys."""

from imgui_bundle import ImVec2, imgui

from app.search import search
from app.theme import Theme, colour, rgb
from app.viewer import marks, style
from app.viewer.text_panel import heading

KEYS = (
    ("Page Down, Page Up", "next and previous step"),
    ("O", "outline and search"),
    ("N", "the lecturer's notes"),
    ("T", "theme: dark, light, projector"),
    ("R", "this step as it was at first"),
    ("Ctrl+Z, Ctrl+Y", "undo and redo"),
    ("C", "copy the state of this step"),
    ("F", "freeze the picture for a guess"),
    ("B", "break it: naive forms where they fail; again: put right"),
    ("E", "edit the GLSL of this step; Ctrl+R: the course's text, Esc: close"),
    ("X", "the exercise beside its scene; Ctrl+R: start again, Esc: close"),
    ("P", "the next plot of a step that has several"),
    ("Tab, arrows, Space", "from control to control, change, press"),
    ("Shift and arrows, + or -", "turn the picture, zoom"),
    ("mouse in the picture", "drag a ring: the thing; elsewhere: turn; wheel: zoom; click: read the values"),
    ("?", "these keys"),
)
FIXED = imgui.WindowFlags_.no_decoration | imgui.WindowFlags_.no_move | imgui.WindowFlags_.no_saved_settings

OVERLAY = imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_saved_settings


def welcome(app, size: ImVec2) -> None:
    """The first picture, turning slowly, with the title and where to begin."""
    imgui.set_next_window_pos(ImVec2(0, 0))
    imgui.set_next_window_size(size)
    imgui.push_style_var(imgui.StyleVar_.window_padding, ImVec2(0, 0))
    imgui.begin("Welcome", None, FIXED)
    imgui.pop_style_var()
    app.cover_picture(size)
    unit = imgui.get_font_size()
    back = rgb(app.theme.background)
    dark, clear = style.u32(back, 0.92), style.u32(back, 0.0)
    imgui.get_window_draw_list().add_rect_filled_multi_color(
        ImVec2(0, 0), ImVec2(0.5 * size.x, size.y), dark, clear, clear, dark
    )
    imgui.set_cursor_pos(ImVec2(3 * unit, size.y * 0.16))
    imgui.begin_group()
    heading("Halfway", 4.0)
    heading("A course in local shading that you can touch.", 1.4)
    imgui.dummy(ImVec2(0, 1.2 * unit))
    imgui.push_style_color(imgui.Col_.text, style.vec(colour("quiet", app.theme)))
    imgui.push_text_wrap_pos(24 * unit)
    imgui.text_wrapped("Every number comes with its error and its cost. Every formula is taken to where it breaks.")
    imgui.pop_text_wrap_pos()
    imgui.pop_style_color()
    imgui.dummy(ImVec2(0, 1.6 * unit))
    wide = style.em(12, 2.2)
    imgui.push_style_color(imgui.Col_.button, style.vec(colour("l", app.theme)))
    imgui.push_style_color(imgui.Col_.text, style.vec((0.08, 0.08, 0.08)))
    if imgui.button("Start", wide):
        app.start(first=True)
    imgui.pop_style_color(2)
    imgui.set_item_default_focus()
    if not app.progress.first_start:
        imgui.same_line()
        if imgui.button("Continue", wide):
            app.start(first=False)
        if imgui.is_item_hovered():
            imgui.set_tooltip(f"{app.session.current.chapter.title}: {app.session.current.step.title}")
    if imgui.button("Outline", wide):
        app.start(first=False)
        app.show_outline = True
    imgui.end_group()
    imgui.end()


def outline(app, size: ImVec2) -> None:
    """Every step, and a search over text, slide titles and terms."""
    centred("Outline", size, 46, 34)
    shown, app.show_outline = framed("Outline")
    if shown:
        if imgui.is_window_appearing():
            imgui.set_keyboard_focus_here()
        imgui.set_next_item_width(-1)
        _, app.query = imgui.input_text_with_hint("##search", "search text, slides, terms", app.query)
        imgui.separator()
        imgui.begin_child("found")
        (hits if app.query.strip() else entries)(app)
        imgui.end_child()
    imgui.end()


def entries(app) -> None:
    chapter = ""
    for entry in app.session.outline():
        if entry.chapter != chapter:
            chapter = entry.chapter
            heading(f"{entry.number}  {chapter}", 1.15)
        if entry.fault:
            imgui.text_wrapped(entry.fault)
            continue
        mark = "answered" if entry.answered else "seen" if entry.visited else ""
        if imgui.selectable(f"    {entry.title}##{entry.id}", entry.current)[0]:
            app.go(entry.id)
            app.show_outline = False
        count = len(entry.exercises)
        words = [mark, "beyond the deck" if entry.beyond else "",
                 "" if not count else "exercise" if count == 1 else f"{count} exercises"]
        if any(words):
            imgui.same_line(imgui.get_content_region_avail().x - 19 * imgui.get_font_size())
            imgui.text_disabled(", ".join(filter(None, words)))
            ticks(sum(map(app.exercise.practice.solved, entry.exercises)), app.theme)


def ticks(count: int, theme: Theme) -> None:
    """A small mark for each solved exercise."""
    size = imgui.get_font_size()
    for _ in range(count):
        imgui.same_line(0, 0.35 * size)
        at = imgui.get_cursor_screen_pos()
        imgui.dummy(ImVec2(size, size))
        marks.mark(at.x + 0.5 * size, at.y + 0.5 * size, True, theme)
        if imgui.is_item_hovered():
            imgui.set_tooltip("solved")


def hits(app) -> None:
    found = search(app.query)
    if not found:
        imgui.text_wrapped(f"Nothing in the course says “{app.query.strip()}”.")
    for i, hit in enumerate(found):
        if imgui.selectable(f"{hit.title}##{i}", False)[0]:
            app.go(hit.step)
            app.show_outline = False
        imgui.push_text_wrap_pos(0)
        imgui.text_disabled(f"{hit.where}: {hit.snippet}")
        imgui.pop_text_wrap_pos()


def help_keys(app, size: ImVec2, keys: tuple[tuple[str, str], ...] = KEYS) -> None:
    centred("Keys", size, 44, 22)
    shown, app.show_help = framed("Keys")
    if shown and imgui.begin_table("keys", 2):
        imgui.table_setup_column("key", imgui.TableColumnFlags_.width_fixed, 13 * imgui.get_font_size())
        for key, meaning in keys:
            imgui.table_next_row()
            imgui.table_next_column()
            imgui.text(key)
            imgui.table_next_column()
            imgui.text_wrapped(meaning)
        imgui.end_table()
    imgui.end()


def framed(name: str) -> tuple[bool, bool]:
    """It begins with an edge: what lies below has the same colour. Whether it is to be drawn, and to stay."""
    imgui.push_style_var(imgui.StyleVar_.window_border_size, 0.12 * imgui.get_font_size())
    imgui.push_style_color(imgui.Col_.border, imgui.get_style_color_vec4(imgui.Col_.text_disabled))
    shown, stays = imgui.begin(name, True, OVERLAY)
    imgui.pop_style_color()
    imgui.pop_style_var()
    return shown, bool(stays)


def centred(name: str, size: ImVec2, wide: float, high: float) -> None:
    unit = imgui.get_font_size()
    x, y = min(wide * unit, 0.94 * size.x), min(high * unit, 0.9 * size.y)
    imgui.set_next_window_size(ImVec2(x, y), imgui.Cond_.appearing)
    at = imgui.get_main_viewport().pos
    imgui.set_next_window_pos(ImVec2(at.x + (size.x - x) / 2, at.y + (size.y - y) / 2), imgui.Cond_.appearing)
