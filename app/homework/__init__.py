"""Homework: start files, a check on one's own machine, and the test of the tests."""
