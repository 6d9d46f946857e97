uniform sampler2D triangles;
uniform sampler2D normals;

// The smooth normal of a mesh at the corner p of a face: what a scene's mesh_value gives on to shade.
vec3 corner_normal(vec3 p, int face) {
    ivec2 at = ivec2(3 * (face % 256), face / 256);
    for (int c = 0; c < 2; c++) {
        if (texelFetch(triangles, at + ivec2(c, 0), 0).xyz == p) return texelFetch(normals, at + ivec2(c, 0), 0).xyz;
    }
    return texelFetch(normals, at + ivec2(2, 0), 0).xyz;
}
