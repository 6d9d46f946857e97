"""IES LM-63 photometric files: read, checked, and turned into the table of numbers a scene samples.

Every complaint is one sentence with the file, the line and what the standard asks. The rules are collected in the
optics reference, section 7, from LM-63-1986 to LM-63-2019.
"""

from app.ies.photometry import Photometry
from app.ies.read import parse, read

__all__ = ["Photometry", "parse", "read"]
