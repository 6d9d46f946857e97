#include "stage/camera.glsl"
// What a scene's shade() is told about the point it colours.
struct Surface {
    int id;         // the number of the surface in the scene
    vec2 st;        // place on its grid, in the unit square
    vec3 position;
    vec3 normal;    // geometric, on the side of the eye
    vec3 v;         // to the eye
    int face;       // of a mesh
    vec4 value;     // of surface_value or mesh_value
};
