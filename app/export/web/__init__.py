"""Pages that run in any browser: one self-contained HTML file a step, with the GLSL of the desktop, and an index.

content.py and figures.py say what a step needs as plain data, page.py puts it into HTML with the player (player/*.js)
and, for formulas, KaTeX (katex/, MIT); index.py lists the course; command.py writes it all.
"""
