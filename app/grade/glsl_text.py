"""A student's GLSL text before it is compiled: one rule for comments, functions of numbers only, the asked signature.

`plain` is what the compiler sees: comments blanked out, so that no compiler has its own idea of where one ends.
"""

import re
from dataclasses import dataclass

from app.grade.question import FILES, Question

NAME = FILES["glsl"]
MOST = 64 << 10  # characters; hygiene, the process limits protect
DEEPEST = 6000  # brackets within brackets
TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.]*|\.\d\w*|[{}()\[\];,=]|\S")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/|/\*.*\Z", re.S)
TYPES = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}
BOUNDARY = {"uniform", "attribute", "varying", "layout", "flat", "smooth", "centroid", "noperspective", "invariant",
            "atomic_uint"}
AT_TOP = {"in", "out", "inout", "buffer", "shared", "coherent", "volatile", "restrict", "readonly", "writeonly",
          "subroutine", "patch", "sample", "precise"}  # in a function some of them are ordinary names
PIXEL = {"discard": "a function of numbers has no pixel to discard", "dFdx": "a point has no neighbours",
         "dFdy": "a point has no neighbours", "fwidth": "a point has no neighbours"}
OPENING = {"{": "}", "(": ")", "[": "]"}
BUILT_IN = re.compile(
    "radians|degrees|a?(sin|cos|tan)h?|pow|exp2?|log2?|(inverse)?sqrt|abs|sign|floor|trunc|round(Even)?|ceil|fract|"
    "modf?|min|max|clamp|mix|(smooth)?step|isnan|isinf|floatBitsToU?[iI]nt|u?intBitsToFloat|length|distance|dot|cross|"
    "normalize|"
    "faceforward|reflect|refract|matrixCompMult|outerProduct|transpose|determinant|inverse|(less|greater)Than(Equal)?|"
    "equal|notEqual|any|all|not")
READS = re.compile(r"tex(ture|el)\w*|image(Load|Store|Atomic\w*|Size)|barrier|memoryBarrier\w*|interpolateAt\w+|"
                   r"EmitVertex|EndPrimitive|dFd[xy]\w+|fwidth\w+")
CALL = re.compile(r"\s*\(")
HANDLES = re.compile(r"[iu]?(sampler|image|texture)([12]D|3D|Cube|Buffer)\w*")


@dataclass(frozen=True)
class Function:
    name: str
    returns: str
    parameters: tuple[str, ...]  # the types, with in, out or inout before them where written
    line: int
    body: bool


def plain(text: str) -> str:
    """The text with every comment as white space; its lines stay where they are."""
    return COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def fault(text: str) -> tuple[str, str]:
    """('rejected' or 'compile_error', the student's line and why), or ('', '')."""
    if len(text) > MOST:
        return "rejected", f"{NAME} has more than {MOST >> 10} KB."
    for match in COMMENT.finditer(text):
        if match[0].startswith("/*") and not (match[0].endswith("*/") and len(match[0]) > 3):
            return "compile_error", at(text, match.start(), "a comment /* that is never closed")
    code = plain(text)
    for match in re.finditer(r"[^\t\n -~]|[#\\\"'$@`]", code):
        c = match[0]
        why = ("no line with # is allowed: no #define, #include or #version" if c == "#" else
               f"the character {c if c.isprintable() else f'U+{ord(c):04X}'} has no place in GLSL")
        return "rejected", at(text, match.start(), why)
    return brackets(text, code) or words(text, code) or outside(text, code) or ("", "")


def at(text: str, place: int, why: str) -> str:
    return f"{NAME}, line {text.count(chr(10), 0, place) + 1}: {why}."


def brackets(text: str, code: str) -> tuple[str, str] | None:
    still: list[tuple[str, int]] = []
    for match in re.finditer(r"[{}()\[\]]", code):
        c = match[0]
        if c in OPENING:
            still.append((c, match.start()))
            if len(still) > DEEPEST:
                return "rejected", at(text, match.start(), f"more than {DEEPEST} brackets within one another")
        elif not still:
            return "compile_error", at(text, match.start(), f"a {c} that closes nothing")
        elif OPENING[still[-1][0]] != c:
            opened = still[-1]
            return "compile_error", at(text, opened[1], f"a {opened[0]} that is never closed")
        else:
            still.pop()
    if still:
        return "compile_error", at(text, still[-1][1], f"a {still[-1][0]} that is never closed")
    return None


def words(text: str, code: str) -> tuple[str, str] | None:
    """Names and keywords that are not for a function of numbers."""
    for match in re.finditer(r"[A-Za-z_]\w*", code):
        word, why = match[0], ""
        if word in BOUNDARY:
            why = f"{word}: hand in functions and constants; the arguments are all they get"
        elif word in PIXEL:
            why = f"{word}: {PIXEL[word]}"
        elif re.match(r"(gl_|halfway_)", word) or "__" in word:
            why = f"{word}: names with gl_, halfway_ or __ are not yours"
        elif HANDLES.fullmatch(word) or (READS.fullmatch(word) and CALL.match(code, match.end())):
            why = f"{word}: nothing is read but the arguments, nothing written but the value"
        if why:
            return "rejected", at(text, match.start(), why)
    return None


def outside(text: str, code: str) -> tuple[str, str] | None:
    """What stands outside functions: constants, structures, functions; none called main or like a built-in one."""
    for tokens, place in declarations(code):
        if tokens[0] in AT_TOP:
            return "rejected", at(text, place, f"{tokens[0]}: hand in functions; the arguments are all they get")
        if is_function(tokens) or tokens[0] in ("const", "struct", "precision", ";"):
            continue
        if len(tokens) > 2 and re.fullmatch(r"[A-Za-z_]\w*", tokens[0]) and re.fullmatch(r"[A-Za-z_]\w*", tokens[1]):
            return "rejected", at(text, place, f"{tokens[1]}: a variable outside a function must be const")
    for function in functions(code):
        if function.name == "main":
            return "rejected", line_of(function, "main: the grader calls your functions, hand in no main")
        if BUILT_IN.fullmatch(function.name):
            return "rejected", line_of(function, f"{function.name} is a function of GLSL; give yours another name")
    return None


def line_of(function: Function, why: str) -> str:
    return f"{NAME}, line {function.line}: {why}."


def declarations(code: str) -> list[tuple[list[str], int]]:
    """Tokens of each top-level declaration, what stands in braces left out but for the braces."""
    found: list[tuple[list[str], int]] = []
    tokens: list[str] = []
    depth, begin = 0, 0
    for match in TOKEN.finditer(code):
        token = match[0]
        if token == "{":
            depth += 1
        if depth == 0 or (depth == 1 and token == "{"):
            if not tokens:
                begin = match.start()
            tokens.append(token)
        if token == "}":
            depth -= 1
            if depth == 0:
                tokens.append(token)
        if depth == 0 and tokens and (token == ";" or (token == "}" and is_function(tokens))):
            found.append((tokens, begin))
            tokens = []
    if tokens:
        found.append((tokens, begin))
    return found


def is_function(tokens: list[str]) -> bool:
    head = tokens[1:] if tokens[0] in ("highp", "mediump", "lowp") else tokens
    return len(head) > 3 and head[2] == "(" and head[0] not in ("const", "struct") and "=" not in head[:3]


def functions(code: str) -> list[Function]:
    found = []
    for tokens, place in declarations(code):
        if is_function(tokens):
            head = tokens[1:] if tokens[0] in ("highp", "mediump", "lowp") else tokens
            end = head.index(")") if ")" in head else len(head)
            inside = [part.split() for part in " ".join(head[3:end]).split(",")]
            kinds = tuple(kind for kind in (kind_of(part) for part in inside) if kind)
            found.append(Function(head[1], head[0], kinds, code.count("\n", 0, place) + 1, "{" in head))
    return found


def kind_of(parameter: list[str]) -> str:
    left = [word for word in parameter if word not in ("const", "in", "highp", "mediump", "lowp")]
    if not left or left == ["void"]:
        return ""
    way = left.pop(0) if left[0] in ("out", "inout") else ""
    size = "".join(left[left.index("["):]) if "[" in left else ""
    return " ".join(filter(None, (way, left[0]))) + size


def signature_fault(text: str, question: Question) -> tuple[str, str]:
    """Whether the text has the asked function once, as it was asked for."""
    widths = [1 if a.ndim == 1 else a.shape[1] for a in question.args.values()]
    asked = tuple(TYPES[width] for width in widths)
    inside = ", ".join(f"{kind} {name}" for kind, name in zip(asked, question.args, strict=True))
    wanted = f"{TYPES[question.width]} {question.function}({inside})"
    own = [one for one in functions(plain(text)) if one.name == question.function]
    if not own:
        same = [one for one in functions(plain(text)) if one.name.lower() == question.function.lower()]
        return "missing", (f"there is no function {question.function}; {same[0].name} is another name" if same else
                           f"there is no function {question.function}; asked for is {wanted}")
    with_body = [one for one in own if one.body]
    if not with_body:
        return "missing", line_of(own[0], f"{question.function} has no body")
    if len(with_body) > 1:
        return "rejected", line_of(with_body[1], f"{question.function} stands here a second time; write it once")
    if with_body[0].parameters != asked or with_body[0].returns != TYPES[question.width]:
        return "compile_error", line_of(with_body[0], f"asked for is {wanted}")
    return "", ""
