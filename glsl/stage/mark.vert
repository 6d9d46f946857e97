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

float screen_length(float t, int pieces_to_sum) {
    float sum = 0.0;
    vec3 before = on_screen(0.0);
    for (int i = 1; i <= pieces_to_sum; i++) {
        vec3 now = on_screen(t * float(i) / float(pieces_to_sum));
        sum += length(now.xy - before.xy);
        before = now;
    }
    return sum;
}

void main() {
    float t = stage_corner.z > 0.5 ? 1.0 : stage_corner.x;
    vec3 here = on_screen(t);
    vec2 along = on_screen(min(t + 0.01, 1.0)).xy - on_screen(max(t - 0.01, 0.0)).xy;
    along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    v_length = length_steps > 0 ? screen_length(1.0, length_steps) : 1e9;
    vec2 pen = vec2(screen_length(t, measure_steps), stage_corner.y * (0.5 * line_width + 1.0));
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
