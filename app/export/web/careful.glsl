// Functions as exact as float32 allows, for the numbers of a page: WebGL promises sin and cos to 1/2048 only (Vulkan
// 1.3, "Precision of GLSL.std.450 Instructions"), and drivers make use of it. A function under its own name stands in
// for the built-in one; nothing else of the course's text changes. Errors: 2 units in the last place, tan and pow more.

float careful_quarter(float x, out float rest) {
    // x = quarter * pi/2 + rest, |rest| <= pi/4; pi/2 in three parts, so that a product with a small number is exact
    float quarter = floor(x * 0.636619772 + 0.5);
    rest = ((x - quarter * 1.5703125) - quarter * 4.8375129699707031e-4) - quarter * 7.5497899487686e-8;
    return quarter;
}

float careful_wave(float quarter, float r) {
    // sin(quarter * pi/2 + r): least squares at Chebyshev nodes
    float z = r * r;
    float s = r + r * z * (-0.166666646 + z * (0.00833273693 - z * 0.00019585433));
    float c = 1.0 - 0.5 * z + z * z * (0.0416666646 + z * (-0.00138882913 + z * 2.454542828e-5));
    int turn = int(quarter) & 3;
    float found = (turn & 1) == 1 ? c : s;
    return turn > 1 ? -found : found;
}

float careful_sin(float x) {
    float r;
    float quarter = careful_quarter(x, r);
    return careful_wave(quarter, r);
}

float careful_cos(float x) {
    float r;
    float quarter = careful_quarter(x, r);
    return careful_wave(quarter + 1.0, r);
}

float careful_tan(float x) {
    return careful_sin(x) / careful_cos(x);
}

float careful_acos(float x) {
    return 2.0 * atan(sqrt(1.0 - x), sqrt(1.0 + x));
}

float careful_exp(float x) {
    // 2^k exp(r), |r| <= log(2) / 2; 2^k in two factors, so that neither overflows before the whole does
    float y = clamp(x, -104.0, 89.0);
    float k = floor(y * 1.44269504 + 0.5);
    float r = (y - k * 0.693359375) + k * 2.12194440e-4;
    float e = 1.0 + (r + r * r * (0.500000001 + r * (0.166665734 + r * (0.0416664568 + r * (0.00836377647
              + r * 0.00139345445)))));
    int half_k = int(k) / 2;
    float found = e * intBitsToFloat((half_k + 127) << 23) * intBitsToFloat((int(k) - half_k + 127) << 23);
    return x == x ? found : x;
}

float careful_sinh(float x) {
    float z = x * x;
    if (z < 0.25) return x + x * z * (0.166666667 + z * (0.00833333333 + z * (1.98412698e-4 + z * 2.75573192e-6)));
    float e = careful_exp(x);
    return 0.5 * (e - 1.0 / e);
}

float careful_cosh(float x) {
    float e = careful_exp(abs(x));
    return 0.5 * (e + 1.0 / e);
}

vec2 careful_sin(vec2 x) {
    return vec2(careful_sin(x.x), careful_sin(x.y));
}

vec2 careful_cos(vec2 x) {
    return vec2(careful_cos(x.x), careful_cos(x.y));
}

#define sin careful_sin
#define cos careful_cos
#define tan careful_tan
#define acos careful_acos
#define exp careful_exp
#define sinh careful_sinh
#define cosh careful_cosh
