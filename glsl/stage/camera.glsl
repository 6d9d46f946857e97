uniform vec3 camera_position;
