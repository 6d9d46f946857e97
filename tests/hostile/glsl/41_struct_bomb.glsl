// 41: pass|memory|timeout_cpu|crash|compile_error|runtime_error: structures of structures, 8^9 numbers
struct S0 { float x[8]; };
struct S1 { S0 x[8]; };
struct S2 { S1 x[8]; };
struct S3 { S2 x[8]; };
struct S4 { S3 x[8]; };
struct S5 { S4 x[8]; };
struct S6 { S5 x[8]; };
struct S7 { S6 x[8]; };
struct S8 { S7 x[8]; };
float asked(float x) {
    S8 s;
    s.x[1].x[2].x[3].x[4].x[5].x[6].x[7].x[0].x[1] = x;
    S8 t = s;
    return 2.0 * t.x[1].x[2].x[3].x[4].x[5].x[6].x[7].x[0].x[1];
}
