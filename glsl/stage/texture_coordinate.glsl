#include "stage/triangles.glsl"
uniform sampler2D texture_coordinates; // s and t of each corner
uniform int own_coordinates; // 1: the mesh has them

// Where on its maps a point p of a face of the mesh lies; without coordinates of its own they are laid on from the six
// sides of a cube, each point from the side that its normal n looks at.
vec2 texture_coordinate(vec3 p, vec3 n, int face) {
    if (own_coordinates == 0) {
        vec3 size = abs(n);
        vec2 at = size.x > max(size.y, size.z) ? p.yz : size.y > size.z ? p.xz : p.xy;
        return 0.5 + 0.5 * at;
    }
    ivec2 at = ivec2(3 * (face % 256), face / 256);
    vec3 a = texelFetch(triangles, at, 0).xyz;
    vec3 b = texelFetch(triangles, at + ivec2(1, 0), 0).xyz - a, c = texelFetch(triangles, at + ivec2(2, 0), 0).xyz - a;
    vec3 across = cross(b, c), q = p - a;
    float whole = max(dot(across, across), 1e-30), of_b = dot(cross(q, c), across) / whole, of_c = dot(cross(b, q), across) / whole;
    return texelFetch(texture_coordinates, at, 0).xy * (1.0 - of_b - of_c)
         + texelFetch(texture_coordinates, at + ivec2(1, 0), 0).xy * of_b
         + texelFetch(texture_coordinates, at + ivec2(2, 0), 0).xy * of_c;
}
