#include "core/angle.glsl"

vec3 groove_point(float facet, float t) {
    // Torrance and Sparrow 1967: from the valley up to the ridge at z = 0
    return vec3((facet < 0.0 ? t : -t) * cos(facet), 0.0, (t - 1.0) * abs(sin(facet)));
}

float facet_lean(vec3 n, vec3 h) {
    // Kahan 2006: the angle between two unit vectors
    return 2.0 * arctan2(length(h - n), length(h + n));
}

float groove_lean(vec3 n, vec3 h, vec3 v) {
    // Blinn 1977: a direction as one sees it along the groove
    vec3 t = cross(n, cross(h - n, n)); // at right angles to n also where h is nearly n
    return arctan2(dot(v, t), length(t) * dot(v, n));
}

float groove_hidden(float facet, float lean) {
    // Torrance and Sparrow 1967: up to where the line from the other ridge meets the facet
    float facing = cos(facet - lean);
    return facing > 0.0 ? clamp(-cos(facet + lean) / facing, 0.0, 1.0) : 1.0;
}

float groove_reach(float facet, float t, float lean) {
    // Two lines crossing: 0 into its own facet, else to the other one between valley and ridge; 1e9: free
    vec3 valley = groove_point(facet, 0.0), up = groove_point(facet, 1.0) - valley;
    float towards = -cos(facet + lean);
    if (cos(facet - lean) <= 0.0) return 0.0;
    if (towards <= 0.0) return 1e9;
    float far = t * abs(sin(2.0 * facet)) / towards;
    float along = dot(t * up + far * vec3(sin(lean), 0.0, cos(lean)), groove_point(-facet, 1.0) - valley);
    return far > 0.0 && along >= 0.0 && along <= 1.0 ? far : 1e9;
}

float groove_blocked(float facet, float t, float lean) {
    // Into its own facet, or on the other one
    return groove_reach(facet, t, lean) < 1e9 ? 1.0 : 0.0;
}

float groove_open(float facet, float lean_l, float lean_v) {
    // Torrance and Sparrow 1967: both hidden parts begin in the valley, so the larger one counts
    float lit = cos(facet - lean_l), seen = cos(facet - lean_v);
    if (lit <= 0.0 || seen <= 0.0) return 0.0;
    return clamp(2.0 * cos(facet) * min(cos(lean_l) / lit, cos(lean_v) / seen), 0.0, 1.0);
}

float groove_open_counted(float facet, float lean_l, float lean_v, int samples) {
    // Two rays from each of evenly spaced points
    float both = 0.0;
    for (int i = 0; i < samples; i++) {
        float t = (float(i) + 0.5) / float(samples);
        both += (1.0 - groove_blocked(facet, t, lean_l)) * (1.0 - groove_blocked(facet, t, lean_v));
    }
    return both / float(samples);
}

float groove_hidden_counted(float facet, float lean, int samples) {
    // One ray from each of evenly spaced points
    float hidden = 0.0;
    for (int i = 0; i < samples; i++) hidden += groove_blocked(facet, (float(i) + 0.5) / float(samples), lean);
    return hidden / float(samples);
}

float groove_exchange(float facet) {
    // Hottel 1954, crossed strings: what a diffuse facet sends to the other one
    float s = sin(0.5 * facet);
    return 2.0 * s * s;
}
