"""Halfway: the course in local shading that you can touch."""

VERSION = "0.1.0"  # as in pyproject.toml
