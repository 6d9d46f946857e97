float chance(int of, int which) {
    // O'Neill 2014, PCG: one of many numbers from 0 to 1 that belong to a thing, the same every time
    uint h = uint(of * 16 + which) * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    return float(((h >> 22u) ^ h) & 65535u) / 65535.0;
}
