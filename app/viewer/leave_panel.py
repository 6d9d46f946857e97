"""What the scene does without at these values, the error of that beside the one it accepts, and a switch for each."""

from imgui_bundle import imgui

from app.leaving import EXACT, Decision, share
from app.theme import colour
from app.viewer import style

HEADS = ("left out", "off by", "accepts")


def draw(app) -> None:
    if not app.own.decided or app.session.frozen:
        return
    imgui.spacing()
    if app.theme.name != "projector":
        table(app)
    elif imgui.tree_node("What is left out"):  # fewer things, where letters are large
        table(app)
        imgui.tree_pop()


def table(app) -> None:
    flags = imgui.TableFlags_.sizing_fixed_fit | imgui.TableFlags_.pad_outer_x
    if not imgui.begin_table("left out", len(HEADS), flags):
        return
    imgui.table_setup_column(HEADS[0], imgui.TableColumnFlags_.width_stretch)
    for name in HEADS[1:]:
        imgui.table_setup_column(name)
    imgui.table_next_row()
    for name in HEADS:
        imgui.table_next_column()
        imgui.text_disabled(name)
    for one in app.own.decided:
        imgui.table_next_row()
        row(app, one)
    imgui.end_table()


def row(app, one: Decision) -> None:
    """A box, ticked where it is out; who has decided it by hand can let the scene do it again."""
    beyond = one.is_out and one.error > one.of.limit
    imgui.table_next_column()
    changed, out = imgui.checkbox(f"##{one.of.label}", one.is_out)
    told(one)
    imgui.same_line()
    imgui.align_text_to_frame_padding()
    imgui.text_wrapped(one.of.label)
    told(one)
    if one.by_hand and imgui.small_button(f"let the scene decide##{one.of.label}"):
        app.session.decide(one.of.label, None)
    elif changed:
        app.session.decide(one.of.label, out)
    for text in (share(one.error) if one.error > EXACT else "exact", share(one.of.limit)):
        imgui.table_next_column()
        imgui.align_text_to_frame_padding()
        imgui.text_colored(style.vec(style.ink("printed", app.theme) if beyond else colour("quiet", app.theme)), text)
        told(one)


def told(one: Decision) -> None:
    if imgui.is_item_hovered():
        imgui.set_tooltip(one.words)
