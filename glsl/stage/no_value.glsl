// What a scene that computes nothing at its corners gives to shade().
vec4 surface_value(int surface, vec2 s) {
    return vec4(0.0);
}

vec4 mesh_value(int surface, vec3 p, int face) {
    return vec4(0.0);
}
