"""The plot beside the scene: wished for when something changed, drawn by a process of its own, shown when it comes."""

import moderngl
from imgui_bundle import ImVec2, imgui

from app import needs
from app.edit import EDITED, marked
from app.lesson import Camera, Curves, Faces, Figure, ImageSlice, Ledger, Lobes, ModelPlot, Plot, Slice, Study
from app.plots import PlotDied, PlotProcess
from app.plots.wire import Spot
from app.problem import Problem
from app.theme import rgb
from app.viewer import glfw, style
from app.viewer.study_panel import StudyPanel

TAB = 0.9  # of the text: seven stand side by side
TURN = 0.5  # degrees a pixel
WIDE, HIGH = 1.05, 1.35  # over the width, at most: of a plot; of a ledger's rows, of one with large words above it
ROW, ROOF = 6.2, 4.5  # em: of a ledger, from a row to the next, and all but that
LEAST = 0.5  # of the column
ON_ITS_WAY = "drawing…"
TABS = {Curves: "curves", Figure: "space", Faces: "faces", Ledger: "ledger", Lobes: "lobe", Slice: "slice",
        ImageSlice: "image", Study: "study"}


def tab_words(plots: tuple[Plot, ...]) -> list[str]:
    """One word for each plot, with a number where two have the same."""
    words = [getattr(plot, "tab", "") or TABS[type(plot)] for plot in plots]
    return [word if words.count(word) == 1 else f"{word} {words[:i].count(word) + 1}" for i, word in enumerate(words)]


class PlotPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.process: PlotProcess | None = None
        self.texture: moderngl.Texture | None = None
        self.of = ""  # the step the picture is of
        self.showing: Plot | None = None  # the plot the picture is of
        self.asked: tuple = ()
        self.fine = False
        self.cameras: dict[tuple[str, str], Camera] = {}  # how a plot of a step was turned
        self.fault = ""
        self.spots: tuple[Spot, ...] = ()  # of the picture, that can be pointed at
        self.study = StudyPanel(app)
        self.is_sized = True
        self.at = ImVec2(0, 0)  # where the picture is in the window
        self.shown = 0  # pictures so far
        self.marks: tuple = (None, (), None)  # the plot, the user's texts, the plot with them marked

    @property
    def follows(self) -> bool:
        """Whether anything in the plot is made of the user's texts."""
        return self.marks[2] != self.marks[0]

    @property
    def waiting(self) -> bool:
        return self.process is not None and not self.process.idle

    def tabs(self) -> None:
        """A small tab for each plot of a step that has several."""
        session = self.app.session
        plots = session.current.step.plots
        if len(plots) < 2:
            return
        imgui.push_font(None, TAB * imgui.get_style().font_size_base)
        gap = 0.2 * imgui.get_font_size()
        right = imgui.get_cursor_pos_x() + imgui.get_content_region_avail().x
        for i, word in enumerate(tab_words(plots)):
            if i:
                imgui.same_line(0, gap)
                wide = imgui.calc_text_size(word).x + 2 * imgui.get_style().frame_padding.x
                if imgui.get_cursor_pos_x() + wide > right:
                    imgui.new_line()
            chosen = i == session.visit.plot
            if chosen:
                imgui.push_style_color(imgui.Col_.button, imgui.get_style_color_vec4(imgui.Col_.button_active))
            if imgui.small_button(f"{word}##plot{i}"):
                session.show_plot(i)
            if chosen:
                imgui.pop_style_color()
            if imgui.is_item_hovered():
                imgui.set_tooltip(f"{plots[i].title}  (P: the next one)")
        imgui.pop_font()

    def height(self, room: float, width: float, below: float) -> float:
        """What the numbers leave of a column, so that nothing scrolls and nothing is empty; but never so low that it
        could not be read, nor much higher than wide. The most that the numbers took in this step counts, so that it
        holds still while they change; before they are known (0) nothing is asked for."""
        self.is_sized = below > 0
        plot, large = self.app.session.plot, self.app.theme.name == "projector"
        tall = HIGH if isinstance(plot, Ledger) or (large and isinstance(plot, Curves)) else WIDE
        most = tall * width
        if isinstance(plot, Ledger):
            rows = max(map(len, plot.columns))
            most = min(most, (ROW * (rows - 1) + ROOF) * imgui.get_font_size())
        least = min(LEAST * room, most)
        left = room - below - 2 * imgui.get_style().item_spacing.y
        return min(max(left, least), most) if below else least

    def draw(self, values: dict, room: ImVec2) -> None:
        before = imgui.get_cursor_pos_y()
        self.tabs()
        room = ImVec2(room.x, room.y - (imgui.get_cursor_pos_y() - before))
        scale = imgui.get_io().display_framebuffer_scale
        size = max(64, int(room.x * scale.x)), max(64, int(room.y * scale.y))
        if self.app.frame > 1 and self.is_sized:  # the lesson is shown first
            self.ask(values, size)
        self.at = at = imgui.get_cursor_screen_pos()
        hidden = self.app.session.frozen
        current = self.of == self.app.session.current.id and self.showing is self.app.session.plot
        if self.texture is not None and current and not self.fault and not hidden:
            imgui.image(imgui.ImTextureRef(self.texture.glo), room)
        else:
            self.empty(at, room, hidden)
        imgui.set_cursor_screen_pos(at)
        if self.fault and not hidden:
            imgui.dummy(room)
            imgui.set_cursor_screen_pos(ImVec2(at.x + imgui.get_font_size(), at.y + 0.65 * room.y))
            if imgui.button("Restart the plots"):
                self.restart()
            imgui.set_cursor_screen_pos(ImVec2(at.x, at.y + room.y + imgui.get_style().item_spacing.y))
        else:
            imgui.invisible_button("plot", room)
            self.turn()
            if current and not hidden:
                self.study.point(self.spots, at)

    def ask(self, values: dict, size: tuple[int, int]) -> None:
        """Wish for a picture when something it shows has changed; a finer one when the hand rests."""
        found, theme, plot = self.app.session.current, self.app.theme, self.app.session.plot
        camera = self.cameras.get((found.id, plot.title))
        triangles = None if isinstance(plot, ModelPlot) else values.get("triangles")  # a model is of no mesh
        shown = {k: v for k, v in values.items() if k != "triangles"}
        wanted = found.id, id(plot), needs.key(values, needs.plotted(plot)), size, theme.name, camera
        rest = wanted == self.asked and not self.fine and not self.waiting and not imgui.is_mouse_down(0)
        if (wanted == self.asked and not rest) or self.fault or self.app.session.frozen or self.app.text_is_new:
            return
        if self.process is None:
            self.process = PlotProcess(on_picture=glfw.wake)
        self.fine, self.asked = rest, wanted
        edits = shown.get(EDITED, ())
        if self.marks[0] is not plot or self.marks[1] != edits:
            self.marks = plot, edits, marked(plot, edits)
        ranges = {name: (spec.low, spec.high, spec.scale) for name, spec in found.values.items()}
        self.process.request(self.marks[2], shown, ranges, camera, size, theme, triangles, fine=rest)

    def take(self) -> None:
        """Show the picture that has come; say so when the process has died."""
        if self.process is None:
            return
        try:
            picture = self.process.poll()
        except PlotDied as died:
            self.fault = str(died)
            return
        if picture is None:
            return
        height, width = picture.image.shape[:2]
        if self.texture is None or self.texture.size != (width, height):
            if self.texture is not None:
                self.texture.release()
            self.texture = self.app.ctx.texture((width, height), 3, alignment=1)
        self.texture.write(picture.image.tobytes(), alignment=1)
        self.shown += 1
        if self.marks[0] is self.app.session.plot and picture.wish.plot is self.marks[2]:
            self.spots = picture.spots
            self.of, self.showing = self.app.session.current.id, self.marks[0]

    def empty(self, at: ImVec2, room: ImVec2, hidden: bool) -> None:
        """A plot on its way shows its axes; a dead or hidden one says so."""
        theme, draw, unit = self.app.theme, imgui.get_window_draw_list(), imgui.get_font_size()
        back, quiet = style.u32(rgb(theme.background)), style.u32(rgb(theme.quiet))
        draw.add_rect_filled(at, ImVec2(at.x + room.x, at.y + room.y), back, 4.0)
        low = ImVec2(at.x + 4 * unit, at.y + room.y - 3.5 * unit)
        if not self.fault and not hidden and isinstance(self.app.session.plot, Curves):
            draw.add_line(low, ImVec2(at.x + room.x - unit, low.y), quiet, 1.5)
            draw.add_line(low, ImVec2(low.x, at.y + 2.5 * unit), quiet, 1.5)
        text = self.fault or (self.hidden_words() if hidden else ON_ITS_WAY)
        left = 5 * unit if text == ON_ITS_WAY else unit  # right of the axis
        begin = ImVec2(at.x + left, at.y + 0.45 * room.y)
        draw.add_text(imgui.get_font(), unit, begin, quiet, text, room.x - left - unit)

    def hidden_words(self) -> str:
        told = self.app.session.answer.stage == "revealed"
        return "hidden while the picture is frozen; F lets it go on" if told else "hidden until you have guessed"

    def turn(self) -> None:
        """A plot in space is turned like the scene."""
        plot = self.app.session.plot
        if not isinstance(plot, Figure | Faces | Lobes):
            return
        from dataclasses import replace

        key = self.app.session.current.id, plot.title
        io, camera = imgui.get_io(), self.cameras.get(key, plot.camera)
        if imgui.is_item_active() and (io.mouse_delta.x or io.mouse_delta.y):
            self.cameras[key] = replace(
                camera,
                azimuth=camera.azimuth - TURN * io.mouse_delta.x,
                elevation=min(max(camera.elevation + TURN * io.mouse_delta.y, -89), 89),
            )
        elif imgui.is_item_hovered() and imgui.is_mouse_double_clicked(0):
            self.cameras.pop(key, None)

    def restart(self) -> None:
        self.fault, self.asked = "", ()
        if self.process is not None:
            try:
                self.process.restart()
            except Problem as problem:
                self.fault = str(problem)

    def close(self) -> None:
        if self.process is not None:
            self.process.close()
        if self.texture is not None:
            self.texture.release()
