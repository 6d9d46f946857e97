uniform mat4 view_projection;
uniform vec2 viewport;     // pixels
uniform int mark;
uniform float line_width;  // pixels
uniform float tip_size;    // pixels; 0: no tip
in vec3 stage_corner;           // x: t along the line, y: -1 or 1 across, z: 1 for the square of the tip
out vec3 v_pen;            // pixels: along the line, across it; z: 1 in the tip's square
flat out float v_length;   // of the line, pixels

vec3 on_screen(float t) {
    vec4 p = view_projection * vec4(mark_point(mark, t), 1.0);
    return vec3(0.5 * viewport * p.xy / p.w, (p.z - 0.0005) / p.w); // half a percent nearer, as dots
}

uniform int measure_steps; // 0 where nothing depends on how far along a point is
uniform int length_steps;  // 0 where nothing depends on the whole length

void main() {
    float t = stage_corner.z > 0.5 ? 1.0 : stage_corner.x;
    vec3 here = vec3(0.0), pen_before = here;
    vec2 along = vec2(0.0);
    float pen_way = 0.0, pen_whole = 0.0; // so far, pixels
    // One loop with one call: a compiler puts the scene's mark_point into every place that calls it.
    for (int i = -3; i <= max(measure_steps, length_steps > 0 ? measure_steps + 1 + length_steps : 0); i++) {
        int pen_piece = i > measure_steps ? i - measure_steps - 1 : i, pen_pieces = i > measure_steps ? length_steps : measure_steps;
        float pen_at = i == -3 ? t : i == -2 ? min(t + 0.01, 1.0) : i == -1 ? max(t - 0.01, 0.0) : 0.0;
        if (pen_piece > 0) pen_at = (i > measure_steps ? 1.0 : t) * float(pen_piece) / float(pen_pieces);
        vec3 pen_now = on_screen(pen_at);
        if (i == -3) here = pen_now;
        if (i == -2) along = pen_now.xy;
        if (i == -1) along -= pen_now.xy;
        if (pen_piece > 0 && i > measure_steps) pen_whole += length(pen_now.xy - pen_before.xy);
        else if (pen_piece > 0) pen_way += length(pen_now.xy - pen_before.xy);
        pen_before = pen_now;
    }
    along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    v_length = length_steps > 0 ? pen_whole : 1e9;
    vec2 pen = vec2(pen_way, stage_corner.y * (0.5 * line_width + 1.0));
    vec2 place = here.xy + across * pen.y;
    if (stage_corner.z > 0.5) {
        pen = vec2(stage_corner.x * 2.0 - 1.0, stage_corner.y) * tip_size;
        place = here.xy + along * pen.x + across * pen.y;
        float nearer = tip_size / (1.5 * viewport.y); // by about its own size, so that what it stands on does not cut it
        here.z = 1.0 - (1.0 - here.z) / (1.0 - nearer);
    }
    v_pen = vec3(pen, stage_corner.z);
    gl_Position = vec4(2.0 * place / viewport, here.z, 1.0);
}
