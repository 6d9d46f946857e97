"""Check a file of stored high-precision values against the twins: python -m tests.reference GOLDEN.json

float64: the Python twin at the stored inputs against the stored value. float32: the GLSL twin at the inputs rounded to
float32, against the Python twin at the same. Both in units of u (1 + cond + kappa), 8 allowed. Exit code 0: all within;
1: some beyond; 2: the file cannot be read or is garbled.
"""

import sys
from collections import Counter
from pathlib import Path

import numpy as np

from app.problem import Problem, Usage
from app.stress.golden import check, read
from app.stress.mapping import mapped
from app.tolerance import FACTOR


def main(argv: list[str]) -> int:
    if len(argv) != 1:
        raise Usage("usage: python -m tests.reference GOLDEN.json")
    found: dict[str, list[tuple[float, float]]] = {}
    left: Counter[str] = Counter()
    for record in read(Path(argv[0])):
        twin = mapped(record["name"])
        if twin is None:
            left[record["name"]] += 1
        else:
            found.setdefault(record["name"], []).append(check(record, twin))
    print(f"{'worst error in units of u (1 + cond + kappa)':<56}records   float64   float32")
    failed = 0
    for name, ratios in sorted(found.items()):
        worst = np.max(ratios, 0)
        beyond = bool(np.any(worst > FACTOR))
        failed += beyond
        print(f"{name:<56}{len(ratios):7d}{worst[0]:10.2f}{worst[1]:10.2f}{'   beyond 8' if beyond else ''}")
    if left:
        families = sorted({name.partition(".")[0] for name in left})
        print(f"not mapped yet: {len(left)} names, {left.total()} records, of {', '.join(families)}")
    if failed:
        print(f"{failed} names beyond the bound")
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Problem as problem:
        print(problem, file=sys.stderr)
        sys.exit(problem.code)
