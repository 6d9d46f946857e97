vec3 studio(vec3 d) {
    // A room to be mirrored in: evening sky, a window behind the eye, a floor of tiles. A look, no radiometry.
    vec3 sky = mix(vec3(0.78, 0.72, 0.66), vec3(0.20, 0.25, 0.34), smoothstep(0.0, 0.8, d.z));
    if (d.z < 0.0) {
        vec2 at = d.xy / max(-d.z, 0.02);
        float tile = mod(floor(at.x * 0.9) + floor(at.y * 0.9), 2.0);
        vec3 ground = mix(vec3(0.05, 0.05, 0.06), vec3(0.42, 0.40, 0.37), tile);
        return mix(ground, vec3(0.42, 0.39, 0.36), smoothstep(2.5, 12.0, length(at)));
    }
    vec2 pane = vec2(d.x + 0.42 * d.y + 0.1, d.z - 0.62);
    bool window = d.y < -0.1 && abs(pane.x) < 0.40 && abs(pane.y) < 0.26 && abs(pane.x) > 0.02 && abs(pane.y) > 0.02;
    return window ? vec3(1.0, 0.97, 0.92) : sky;
}
