#include "display/balls.glsl"
#include "display/brush.glsl"
#include "display/faults.glsl"
#include "display/lobe.glsl"
#include "display/look.glsl"
#include "display/scale.glsl"
// The board: models as balls, one of them large and as an object, and as lobes, on the large ball's picked point and,
// turned freely, on a plate of their own. The scene that includes it says MODELS, model_colour(which),
//     vec3 reflected(int which, vec3 n, vec3 l, vec3 v, vec3 x, vec3 y)    // 1/sr
//     vec3 factors(int which, vec3 n, vec3 l, vec3 v)                      // D, G, F; below 0 where there are none
uniform float theta_l, theta_v, phi, turned, light, lobe_top;
uniform int model;
uniform int shows;
uniform int stands;
uniform int board_channel;
uniform int lobe_scale;

const vec3 UP = vec3(0.0, 0.0, 1.0);
const float LARGE = 0.84, SMALL = 0.22, PLATE = 0.95, LOBE = 1.35, STANDING = 0.8, LONGEST = 1.3;

// What a surface is: its number is that of its model, in groups of MODELS
const int BALL = 0, OBJECT = 1, LOBE_ON_PLATE = 2, LOBE_ON_BALL = 3, GROUND = 4;

vec3 place(float right, float above) { return right * aside() + above * up(); }

vec3 large() { return place(-0.82, 0.7) - 2.0 * eye(); }

vec3 plate() { return place(0.66, -0.8); }

vec3 ball_at(int which) {
    if (which == model) return large();
    return place(-1.5 + 0.48 * float(which < model ? which : which - 1), -1.0);
}

float ball_size(int which) { return which == model ? LARGE : SMALL; }

vec3 lamp() { return picked_light(theta_l, theta_v, phi, turned); }

vec3 foot() { return large() + LARGE * picked_frame(theta_v, turned)[2]; }

float amount(vec3 f) {
    return board_channel == 3 ? dot(f, vec3(0.2126, 0.7152, 0.0722)) : f[board_channel];
}

float lobe_value(int which, vec3 d) {
    vec3 l = light_direction(theta_l, phi);
    vec3 x = picked_tangent(theta_v, turned);
    float f = amount(reflected(which, UP, l, d, x, cross(UP, x)));
    return lobe_scale == 1 ? f * l.z : f;
}

vec3 lobe_way(vec2 s) {
    vec3 l = light_direction(theta_l, phi);
    return lobe_direction(s, vec3(-l.xy, max(l.z, 0.03)), 0.12);
}

float lobe_length(float value) {
    if (isnan(value)) return 0.5;
    return min(lobe_radius(abs(value), lobe_top, lobe_scale == 2 ? 4.0 : 0.0), LONGEST);
}

vec4 corner; // of a lobe: its way and the value there, found once: a corner's value is asked for before its place

vec4 board_value(int surface, vec2 s) {
    int kind = surface / MODELS;
    if (kind == BALL) return vec4(lamp(), 0.0);
    if (kind == GROUND) return vec4(0.0);
    vec3 d = lobe_way(s);
    corner = vec4(d, lobe_value(surface % MODELS, d));
    return vec4(0.0, 0.0, 0.0, corner.w);
}

vec3 board_point(int surface, vec2 s) {
    int which = surface % MODELS, kind = surface / MODELS;
    if (kind == BALL) return cap_to_eye(s, ball_at(which), ball_size(which));
    bool gone = stands == 1 && kind != LOBE_ON_BALL;
    if (kind == GROUND) return plate() + (gone ? 0.0 : PLATE * s.y) * vec3(cos(2.0 * PI * s.x), sin(2.0 * PI * s.x), -0.001);
    vec3 d = corner.xyz * lobe_length(corner.w);
    if (kind == LOBE_ON_BALL) return foot() + STANDING * picked_frame(theta_v, turned) * d;
    return plate() + (gone ? 0.0 : LOBE) * d;
}

vec3 board_mesh(int surface, vec3 p) {
    return place(0.72, -0.3) + (stands == 1 && surface % MODELS == model ? 1.0 : 0.0) * p;
}

vec3 board_normal(Surface s) {
    int which = s.id % MODELS, kind = s.id / MODELS;
    if (kind == BALL) return ball_normal((s.position - ball_at(which)) / ball_size(which), s.v);
    if (kind != OBJECT) return s.normal;
    return normalize(s.value.xyz) * (dot(s.value.xyz, s.normal) < 0.0 ? -1.0 : 1.0);
}

vec3 as_colour(vec3 w) {
    vec3 c = max(0.5 + 0.5 * vec3(dot(w, aside()), dot(w, up()), dot(w, eye())), 0.0);
    return c * (0.0125 + c * (0.6822 + c * 0.3053)); // about the power 2.2, which is dear on a CPU
}

vec3 taken_apart(int which, vec3 n, vec3 l, vec3 v) {
    vec3 s = l + v, h = s / max(length(s), 1e-6);
    if (shows <= 4) return as_colour(shows == 1 ? n : shows == 2 ? l : shows == 3 ? v : h);
    if (shows <= 8) {
        float c = shows == 5 ? dot(n, l) : shows == 6 ? dot(n, v) : shows == 7 ? dot(n, h) : dot(l, h);
        return vec3(max(c, 0.0) * max(c, 0.0));
    }
    vec3 dgf = factors(which, n, l, v);
    if (dgf.x < 0.0 || min(dot(n, l), dot(n, v)) <= 0.0) return 0.5 * (background + 0.3 * palette[COLOUR_QUIET]);
    if (shows == 9) return decades(dgf.x, -3.0, 2.0);
    return mix(0.15 * background, palette[shows == 10 ? COLOUR_G : COLOUR_F], shows == 10 ? dgf.y : sqrt(dgf.z));
}

vec3 lit(int which, vec3 n, vec3 l, vec3 v) {
    vec3 x = ball_tangent(n), f = reflected(which, n, l, v, x, cross(n, x));
    float n_dot_l = max(dot(n, l), 0.0);
    if (shows >= 12) return decades(amount(f) * (shows == 13 ? n_dot_l : 1.0), -3.0, 2.0);
    vec3 radiance = light * n_dot_l * (board_channel == 3 ? f : vec3(f[board_channel]));
    return radiance + 0.02;
}

vec3 board_colour(Surface s) {
    int which = s.id % MODELS, kind = s.id / MODELS;
    if (kind == GROUND) return mix(background, palette[COLOUR_QUIET], 0.22 + 0.3 * grid_lines(s.st, vec2(12.0, 4.0)));
    if (kind >= LOBE_ON_PLATE) {
        if (!(s.value.w >= 0.0)) return fault_colour(vec3(isnan(s.value.w) ? 1.0 : 0.0, 0.0, 1.0), gl_FragCoord.xy);
        vec3 body = soft_light(palette[model_colour(which)], s.normal, s.v);
        return mix(body, background, 0.3 * grid_lines(s.st, vec2(24.0, 12.0)));
    }
    vec3 n = board_normal(s), l = kind == BALL ? s.value.xyz : lamp(), v = eye();
    vec3 colour = shows == 0 || shows >= 12 ? lit(which, n, l, v) : taken_apart(which, n, l, v);
    if (kind == BALL && which == model) return colour;
    float ring = abs(distance(n, picked_frame(theta_v, turned)[2]) - 0.14);
    return mix(palette[COLOUR_N], colour, smoothstep(0.02, 0.04, ring));
}

vec3 board_mark(int mark, float t) {
    vec3 l = light_direction(theta_l, phi), v = view_direction(theta_v), h = normalize(l + v + 1e-6 * UP);
    int which = mark % 4;
    vec3 d = which == 0 ? UP : which == 1 ? 1.15 * l : which == 2 ? 1.1 * v : h;
    if (mark < 4) return foot() + 0.75 * t * (picked_frame(theta_v, turned) * d);
    return stands == 1 ? vec3(1e3) : plate() + 1.25 * t * d;
}

vec4 board_probe(int i) { // names, then handles: the picked point, the light on the ball, and over the plate
    float low = i == model || (i > model) != (i % 2 == 1) ? 0.13 : 0.33; // neighbours' names have room
    if (i < MODELS) return vec4(ball_at(i) - (ball_size(i) + low) * up(), 1.0);
    if (i == MODELS) return vec4(foot(), 1.0);
    return vec4(board_mark(i == MODELS + 1 ? 1 : 5, 1.0), 1.0);
}
