// The grammar of colour, linear light, set by the theme; the order is that of `Colour` in app/lesson.py.
uniform vec3 palette[13];
uniform vec3 background;
uniform vec3 colormap_stops[17];
const int COLOUR_N = 0;
const int COLOUR_L = 1;
const int COLOUR_V = 2;
const int COLOUR_H = 3;
const int COLOUR_R = 4;
const int COLOUR_EXACT = 5;
const int COLOUR_ESTIMATE = 6;
const int COLOUR_PRINTED = 7;
const int COLOUR_LOST = 8;
const int COLOUR_D = 9;
const int COLOUR_G = 10;
const int COLOUR_F = 11;
const int COLOUR_QUIET = 12;

vec3 colormap(float x) {
    // The theme's perceptually uniform map (viridis or cividis) over [0, 1]
    float at = clamp(x, 0.0, 1.0) * 16.0;
    int i = int(min(floor(at), 15.0));
    return mix(colormap_stops[i], colormap_stops[i + 1], at - float(i));
}
