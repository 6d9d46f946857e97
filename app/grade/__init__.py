"""Homework: a student's function against the twin."""
