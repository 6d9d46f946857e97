"""What the toolkit is told before its first frame: size, OpenGL, fonts, the calls of the window, how prose is shown."""

from imgui_bundle import hello_imgui, immapp, rich_md

from app.viewer import glfw, style
from app.viewer.window import Window


def parameters(window: Window) -> tuple[hello_imgui.RunnerParams, immapp.AddOnsParams]:
    params = hello_imgui.RunnerParams()
    params.ini_disable = True
    params.app_window_params.window_title = "Halfway"
    params.app_window_params.window_geometry.size = window.size
    params.app_window_params.restore_previous_geometry = False
    params.renderer_backend_options.open_gl_options = hello_imgui.OpenGlOptions(
        major_version=3,
        minor_version=3,
        use_core_profile=True,
        use_forward_compat=True,
        glsl_version="330",
        anti_aliasing_samples=0,
    )  # eight samples, the default, cost 40 % of the frame rate
    params.imgui_window_params.default_imgui_window_type = hello_imgui.DefaultImGuiWindowType.no_default_window
    params.imgui_window_params.show_menu_bar = params.imgui_window_params.show_status_bar = False
    params.fps_idling.fps_idle = 1.0
    params.fps_idling.time_active_after_last_event = 0.7
    params.callbacks.load_additional_fonts = style.load_font
    params.callbacks.post_init, params.callbacks.before_exit = window.post_init, window.before_exit
    params.callbacks.show_gui, params.callbacks.after_swap = window.gui, window.after_swap
    markdown = rich_md.MarkdownOptions()
    markdown.with_latex, markdown.autolinks = True, False
    markdown.callbacks.on_open_link = window.open_link
    add_ons = immapp.AddOnsParams()
    add_ons.with_markdown_options = markdown
    return params, add_ons


def open_window(params: hello_imgui.RunnerParams, add_ons: immapp.AddOnsParams) -> None:
    """Until it is closed; without a display on GLFW's null platform."""
    if not glfw.has_display():
        glfw.without_display()
    glfw.without_depth()
    immapp.run(params, add_ons)
