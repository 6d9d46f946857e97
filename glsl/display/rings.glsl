// A disc whose value is worked out at the corners of its rings and is the same all around: few columns are enough, for a
// pixel puts right what the straight edges of a ring do to it. `at` is the ring carried to the pixel, `true_at` its own.
float round_value(float value, float at, float true_at) {
    vec2 rise = vec2(dFdx(value), dFdy(value)), step_at = vec2(dFdx(at), dFdy(at));
    return value + dot(rise, step_at) / max(dot(step_at, step_at), 1e-20) * (true_at - at); // the slope within a triangle
}
