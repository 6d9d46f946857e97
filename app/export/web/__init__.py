"""Pages that run in any browser: one self-contained HTML file a step, with the GLSL of the desktop, and an index.

content.py and figures.py say what a step needs as plain data; controls.py and drawings.py write the HTML that does not
wait for a browser; page.py puts it all into one file with the player (player/*.js) and, for formulas, KaTeX (katex/,
MIT); index.py lists the course; command.py writes it all. The player's page.js is where a page begins to be read.
"""
