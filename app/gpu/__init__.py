"""The only moderngl: contexts, programs, evaluating a function, drawing a scene."""
