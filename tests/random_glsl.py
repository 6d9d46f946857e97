"""Random vertex programs full of whole numbers, conditions and calls: what a pruned text is compared with."""

from random import Random

KNOWN = "kind", "mode", "surface"
HEAD = "".join(f"uniform int {name};\n" for name in KNOWN) + "const int TWO = 2, THREE = TWO + 1;\n"


class Writer:
    def __init__(self, seed: int):
        self.random, self.functions = Random(seed), []
        self.fixed: set[str] = set()  # names of the present function that are not to be set

    def pick(self, *of):
        return self.random.choice(of)

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    # --- expressions: nothing negative, as GLSL leaves open what its remainder is ---------------------------------
    def number(self, names: list[str], depth: int = 0) -> str:
        if depth > 2 or self.chance(0.4):
            return self.pick(str(self.random.randint(0, 5)), *names)
        one, other = (self.number(names, depth + 1) for _ in "ab")
        return self.pick(f"{one} + {other}", f"({one}) * {self.pick(0, 1, 2)}", f"({one}) % {self.pick(1, 2, 3)}",
                         f"({one}) / {self.pick(1, 2, 3)}", f"({self.condition(names, depth + 1)} ? {one} : {other})")

    def condition(self, names: list[str], depth: int = 0) -> str:
        if depth > 2 or self.chance(0.6):
            return (f"{self.number(names, depth + 1)} {self.pick('==', '!=', '<', '>', '<=', '>=')} "
                    f"{self.number(names, depth + 1)}")
        one, other = (self.condition(names, depth + 1) for _ in "ab")
        return self.pick(f"!({one})", f"({one}) && ({other})", f"({one}) || ({other})", "x > 1.0")

    def call(self, names: list[str]) -> str:
        name, parameters = self.pick(*(self.functions or [("float", [])]))
        own = [one for one in names if one not in self.fixed]
        if name == "float" or ("inout" in parameters and not own):
            return "1.0"
        given = [self.pick(*own) if one == "inout" else self.number(names) for one in parameters]
        return f"{name}({', '.join([*given, 'x'])})"

    # --- statements ----------------------------------------------------------------------------------------------
    def statement(self, names: list[str], depth: int, loops: bool) -> str:
        own = [one for one in names if one not in self.fixed]
        inner = (lambda: self.block(names, depth + 1, loops)) if depth < 3 else (lambda: "sum += 2.0;")
        kinds = [
            lambda: f"if ({self.condition(names)}) {inner()}",
            lambda: f"if ({self.condition(names)}) {inner()} else {inner()}",
            lambda: f"if ({self.condition(names)}) sum += {self.call(names)}; else sum *= 1.5;",
            lambda: f"sum += {self.condition(names)} ? {self.call(names)} : {self.condition(names)} ? 3.0 : 5.0;",
            lambda: f"if ({self.condition(names)}) return sum;",
            lambda: f"sum += float({self.number(names)}); // if (kind == 1) {{",
            lambda: f"switch ({self.number(names)}) {{ case 0: sum = 1.0; break; default: sum -= 2.0; }}",
        ]
        if own:
            kinds.append(lambda: f"{self.pick(*own)} {self.pick('=', '+=')} {self.number(names)};")
        if loops:
            kinds.append(lambda: f"if ({self.condition(names)}) {self.pick('break', 'continue')};")
        if depth < 2:
            kinds.append(lambda: f"for (int i{depth} = 0; i{depth} < 4 && i{depth} < {self.number(names)}; i{depth}++) "
                                 + self.block([*names, f"i{depth}"], depth + 1, True))
        return self.pick(*kinds)()

    def block(self, names: list[str], depth: int = 0, loops: bool = False) -> str:
        found, here, fixed = [], set(), set(self.fixed)
        names = list(names)
        self.fixed |= {one for one in names if one.startswith("i")}
        for _ in range(self.random.randint(1, 4)):
            name = f"v{self.random.randint(0, 4)}"
            if self.chance(0.35) and name not in here:
                found.append(f"int {name} = {self.number(names)};")
                here.add(name)
                names.append(name)
                self.fixed.discard(name)
            else:
                found.append(self.statement(names, depth, loops))
        self.fixed = fixed
        return "{ " + "\n".join(found) + "\n}"

    def function(self) -> str:
        """One that may hide what is known behind its parameters, and share its name with one of fewer parameters."""
        parameters = [self.pick("int", "int", "inout") for _ in range(self.random.randint(0, 3))]
        taken = {len(other) for name, other in self.functions if name == "f"}
        name = f"f{len(self.functions)}" if len(parameters) in taken else self.pick("f", f"f{len(self.functions)}")
        called = self.random.sample(["a", "b", "kind", "mode", "v0", "v1"], len(parameters))
        self.fixed = {*KNOWN, "TWO", "THREE"} - set(called)
        head = [f"{kind} {one}" if kind == "int" else f"inout int {one}"
                for kind, one in zip(parameters, called, strict=True)]
        body = self.block(sorted({*KNOWN, "THREE", *called}))
        self.functions.append((name, parameters))
        return f"float {name}({', '.join([*head, 'float x'])}) {{ float sum = 0.5;\n{body}\nreturn sum; }}"

    def program(self) -> str:
        functions = [self.function() for _ in range(self.random.randint(2, 6))]
        self.fixed = {*KNOWN, "THREE"}
        calls = " + ".join(self.call([*KNOWN, "THREE"]) for _ in range(3))
        main = f"in float place;\nout float value;\nvoid main() {{ float x = place; value = {calls}; }}\n"
        return HEAD + "\n".join([*functions, main])
