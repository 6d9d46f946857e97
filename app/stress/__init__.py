"""Stability: every twin over its extremes, every scene over the corners of its sliders."""
