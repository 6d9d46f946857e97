"""Stills and the gallery: the course as files, without a window."""
