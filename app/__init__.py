"""Halfway: the course in local shading that you can touch."""
