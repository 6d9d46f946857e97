// Beside the picture: the line of the loop that was left, in this text, and in that of the vertices.
#include "stage/turns.glsl"
flat in int v_endless;
layout(location = 2) out vec4 o_endless;

void main() {
    stage_main();
    o_endless = vec4(float(halfway_endless), float(v_endless), 0.0, 1.0);
}
