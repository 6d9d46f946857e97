// A lobe standing on a surface whose normal is +z: a grid of cells over the hemisphere, its pole in the lobe's peak and
// its rim on the horizon, so that a narrow lobe is drawn as well as a wide one.
//
//     vec3 surface_point(int surface, vec2 s) {
//         vec3 d = lobe_direction(s, peak, width);                                    // e.g. of reflection
//         return d * lobe_radius(brdf_phong(n, l, d, exponent), largest, 0.0);
//     }

vec3 lobe_direction(vec2 st, vec3 peak, float width) {
    // st.x goes once around the peak, st.y from it along a great circle to the horizon; half of the way to a few
    // `width` (radians) lies in the first half of the cells. A width of 10 or more spaces them evenly.
    float k = -1.0 / (1.0 + max(peak.z, 0.0));
    vec3 across = vec3(1.0 + peak.x * peak.x * k, peak.x * peak.y * k, -peak.x); // Duff et al. 2017
    vec3 along = vec3(peak.x * peak.y * k, 1.0 + peak.y * peak.y * k, -peak.y);
    float turn = 6.283185307 * st.x;
    vec3 way = across * cos(turn) + along * sin(turn);
    float rim = atan(max(peak.z, 0.0), -way.z);
    float angle = width * sinh(st.y * asinh(rim / width));
    vec3 d = peak * cos(angle) + way * sin(angle);
    return vec3(d.xy, max(d.z, 1e-4)); // the rim is still lit and seen
}

float lobe_radius(float value, float largest, float powers) {
    // The length of a lobe that is 1 where the value is `largest`; 0 powers is linear, else so many powers of ten
    // below the largest reach the middle.
    float share = value / largest;
    return powers > 0.0 ? clamp(1.0 + log(max(share, 1e-30)) / (2.302585093 * powers), 0.0, 1.0) : max(share, 0.0);
}
