#include "stage/triangles.glsl"
uniform sampler2D normals;

// The smooth normal of a mesh at the corner p of a face: what a scene's mesh_value gives on to shade.
vec3 corner_normal(vec3 p, int face) {
    ivec2 at = ivec2(3 * (face % 256), face / 256);
    bool first = texelFetch(triangles, at, 0).xyz == p, second = texelFetch(triangles, at + ivec2(1, 0), 0).xyz == p;
    return texelFetch(normals, at + ivec2(first ? 0 : second ? 1 : 2, 0), 0).xyz;
}
