#include "stage/turns.glsl"
flat out int v_endless;

void main() {
    stage_main();
    v_endless = halfway_endless;
}
