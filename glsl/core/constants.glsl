const float PI = 3.14159265358979;
const int MAX_CORNERS = 8; // of a polygon
