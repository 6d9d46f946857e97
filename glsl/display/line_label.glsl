// What the scene shows at a point, for the words at its lines.
float shown_value(vec3 p);

// Where the line of a value crosses the way between two points; far up, outside every picture, where it does not.
vec4 line_label(float value, vec3 from, vec3 to) {
    bool above = shown_value(from) > value;
    if ((shown_value(to) > value) == above) return vec4(0.0, 0.0, 1e4, 1.0);
    float near = 0.0, far = 1.0;
    for (int i = 0; i < 16; i++) {
        float middle = 0.5 * (near + far);
        if ((shown_value(mix(from, to, middle)) > value) == above) near = middle;
        else far = middle;
    }
    return vec4(mix(from, to, near), 1.0);
}
