// 1 where nothing stands between two points, 0 where the ball does.
float seen_past_ball(vec3 p, vec3 q, vec3 centre, float radius) {
    vec3 along = q - p, off = p + clamp(dot(centre - p, along) / dot(along, along), 0.0, 1.0) * along - centre;
    return dot(off, off) >= radius * radius ? 1.0 : 0.0;
}
