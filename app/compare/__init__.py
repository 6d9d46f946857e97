"""A second opinion: the same mesh, light and material by our GLSL and by pyrender, and how far they are apart."""
