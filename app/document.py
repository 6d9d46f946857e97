"""The frame of every page the project writes: one file, in UTF-8, that asks the network for nothing."""

from html import escape

# No script, and pictures are in the page
STILL = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"


def document(title: str, style: str, body: str, policy: str = STILL, remark: str = "") -> str:
    """A page of HTML. The title is text; `style` is CSS; `body` and `remark`, which stands in the head, are HTML."""
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{escape(title)}</title>{remark}
<style>
{style}
</style>
</head>
<body>
{body}
</body>
</html>
"""
