uniform sampler2D triangles; // the corners of a mesh, three for each face
