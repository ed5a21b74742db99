"""Where the library's source can be changed by one operator, constant or sign, and a stratified sample of these places.

The rules read tokens, not syntax; they rest on the layout that .clang-format gives: binary operators stand between
blanks, template brackets, pointers and references do not. What slips through does not compile and does not count.
"""

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

FOLDERS = ("film", "joint", "multibody", "ode", "run", "motion")

#: Sources in lib/src that belong to one of the folders; the others there make scenes.
SOURCES = {
    "film_batch.cpp": "film",
    "film_rows.hpp": "film",
    "choose_integrator.cpp": "motion",
    "integrators.cpp": "ode",
    "rosenbrock4.cpp": "ode",
    "rosenbrock4_integrator.hpp": "ode",
}


@dataclass(frozen=True)
class Mutant:
    """One change: `old` at `position` of the file becomes `new`."""

    ident: str
    folder: str
    file: str  # from the repository's root
    position: int
    line: int
    column: int
    kind: str
    old: str
    new: str

    def apply(self, text):
        assert text.startswith(self.old, self.position)
        return text[: self.position] + self.new + text[self.position + len(self.old) :]


TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')
  | (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<number>0[xX][0-9a-fA-F']+[uUlLzZ]*|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfFzZ]*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<operator><=>|<<=|>>=|\.\.\.|->\*?|::|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[^\s\w])
  | (?P<blank>\s+)
    """,
    re.X | re.S | re.M,
)


@dataclass
class Token:
    kind: str
    text: str
    start: int

    @property
    def end(self):
        return self.start + len(self.text)


def tokens_of(text):
    """Tokens that mean something: no comments, no preprocessor."""
    found = [Token(m.lastgroup if m.lastgroup != "mark" else "string", m.group(), m.start()) for m in TOKEN.finditer(text)]
    return [t for t in found if t.kind not in ("comment", "directive", "blank")]


OPENING = {"(": ")", "[": "]", "{": "}"}


def closing(tokens, i):
    """Index of the bracket that closes the one at i."""
    depth = 0
    for j in range(i, len(tokens)):
        if tokens[j].text in OPENING:
            depth += 1
        elif tokens[j].text in (")", "]", "}"):
            depth -= 1
            if depth == 0:
                return j
    return len(tokens) - 1


def closing_angle(tokens, i):
    """Index of the > that closes the template bracket at i, or i if there is none near."""
    depth = 0
    for j in range(i, min(i + 80, len(tokens))):
        t = tokens[j].text
        depth += {"<": 1, ">": -1, ">>": -2}.get(t, 0)
        if depth <= 0:
            return j
        if t in (";", "{"):
            break
    return i


def until(tokens, i, ends):
    """Index of the first of `ends` outside brackets opened after i."""
    while i < len(tokens) and tokens[i].text not in ends:
        i = closing(tokens, i) if tokens[i].text in OPENING else i
        i += 1
    return i


def excluded(text, tokens):
    """Tokens in which nothing is changed: assertions at compile time, constraints, template brackets, and messages."""
    out = set()
    for i, t in enumerate(tokens):
        last = None
        if t.text in ("static_assert", "throw", "concept", "typedef", "using", "namespace", "extern", "friend"):
            last = until(tokens, i, (";", "{") if t.text in ("namespace", "extern", "friend") else (";",))
        elif t.text == "message" and tokens[i + 1].text in (".", "<<", "=", "+="):
            last = until(tokens, i, (";",))
        elif t.text in ("noexcept", "decltype", "sizeof", "alignas") and tokens[i + 1].text == "(":
            last = closing(tokens, i + 1)
        elif t.text == "requires":
            last = until(tokens, i, (";", "{")) if tokens[i + 1].text == "(" else i
            while last + 1 < len(tokens) and "\n" not in text[tokens[last].end : tokens[last + 1].start]:
                last += 1
        elif t.text == "operator":
            last = i + 2
        elif t.text == "<" and i > 0 and (tokens[i - 1].text == "template" or text[t.start - 1] not in " \n"):
            last = closing_angle(tokens, i)
        elif t.text == "[" and i > 0 and tokens[i - 1].text in ("(", ",", "=", "return", "{", "["):
            last = closing(tokens, i)  # captures of a lambda, attributes
        if last is not None:
            out.update(range(i, last + 1))
    return out


BINARY = {
    "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
    "<": ["<=", ">"], ">": [">=", "<"], "<=": ["<", ">="], ">=": [">", "<="], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"],
}  # fmt: skip
NAMES = {"min": "max", "max": "min", "sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh", "true": "false",
         "false": "true", "minCoeff": "maxCoeff", "maxCoeff": "minCoeff", "front": "back", "back": "front",
         "floor": "ceil", "ceil": "floor"}  # fmt: skip


def other_numbers(literal):
    """×2, +1 and 0; a number far from 1 is a tolerance or a limit, and takes ×1000 for ×2, which would show nowhere."""
    m = re.fullmatch(r"([\d'.]+(?:[eE][+-]?\d+)?)([uUlLfFzZ]*)", literal)
    if not m or literal[:2] in ("0x", "0X"):
        return []
    digits, suffix = m.group(1).replace("'", ""), m.group(2)
    if re.fullmatch(r"\d+", digits):
        values = [2 * int(digits), int(digits) + 1, 0]
        return [f"{v}{suffix}" for v in dict.fromkeys(values) if v != int(digits)]
    value = float(digits)
    scale = 2 if 1e-4 <= abs(value) <= 1e4 else 1000
    return [f"{v!r}{suffix}" for v in dict.fromkeys([scale * value, value + 1, 0.0]) if v != value]


def is_unary(tokens, i):
    before = tokens[i - 1]
    return before.text == "return" or (before.kind == "operator" and before.text not in (")", "]", "}"))


FUNCTION_HEAD = re.compile(
    r"^[ ]*(?:\[\[\w+\]\] )?(?:(?:static|constexpr|inline|virtual|friend|explicit|const) )*([\w:<>, *&]+?)[&*]? ~?\w+\(", re.M
)


def returns_bool(text, position):
    """Whether the function around a position returns a truth value, which has no sign."""
    types = [m.group(1).split() for m in FUNCTION_HEAD.finditer(text, 0, position)]
    types = [words for words in types if words and words[0] not in ("return", "else", "throw")]
    return bool(types) and types[-1][-1] == "bool"


def changes(text):
    """All (position, kind, old, [new...]) of one file."""
    tokens = tokens_of(text)
    skip = excluded(text, tokens)
    blank = lambda p: 0 <= p < len(text) and text[p] in " \n"  # noqa: E731
    for i, t in enumerate(tokens):
        if t.text in (";", "{", "}", ")") and i + 2 < len(tokens) and i + 1 not in skip:
            statement = dropped_statement(text, tokens, i + 1)
            if statement:
                yield tokens[i + 1].start, "dropped", statement, [";"]
        if i in skip or i == 0:
            continue
        spaced = blank(t.start - 1) and blank(t.end)
        if t.kind == "number":
            yield t.start, "constant", t.text, other_numbers(t.text)
        elif t.text in NAMES and t.kind == "name":
            if t.text in ("true", "false") or tokens[min(i + 1, len(tokens) - 1)].text in ("(", "<"):
                yield t.start, "name", t.text, [NAMES[t.text]]
        elif t.text in BINARY and spaced and not is_unary(tokens, i):
            yield t.start, "operator", t.text, BINARY[t.text]
        elif t.text in ("-", "!") and is_unary(tokens, i) and not blank(t.end):
            yield t.start, "sign" if t.text == "-" else "not", t.text, [""]
        elif t.text == "return" and tokens[i + 1].text not in (";", "{"):
            end = until(tokens, i + 1, (";",))
            value = text[t.end : tokens[end].start]
            truth = re.search(r"[<>=!]=| [<>] |&&|\|\||!|\btrue\b|\bfalse\b|\"", value) or returns_bool(text, t.start)
            if not truth and "[" not in value and re.search(r"[\w)]", value):
                yield t.start, "return sign", "return" + value, [f"return -({value.strip()})"]


def dropped_statement(text, tokens, i):
    """The assignment or call that is the whole statement from token i, or nothing: declarations are none."""
    if tokens[i].kind != "name" or tokens[i].text in ("return", "if", "for", "while", "else", "case", "do", "switch",
                                                       "const", "auto", "constexpr", "static", "new", "delete"):  # fmt: skip
        return None
    if tokens[i - 1].text == ")" and not re.search(r"^\s*(?:\} )?(?:else )?(?:if|for|while)\b", line_at(text, tokens[i].start)):
        return None
    end = until(tokens, i, (";", "{", "}"))
    if end >= len(tokens) or tokens[end].text != ";":
        return None
    statement = text[tokens[i].start : tokens[end].end]
    place = r"[A-Za-z_][\w.]*(?:->\w+|\[[^\]]*\]|\([^()]*\)|\.\w+|::\w+)*"
    if re.match(rf"{place} [-+*/]?= ", statement) or re.fullmatch(rf"{place}\(.*\);", statement, re.S):
        return statement
    return None


def line_at(text, position):
    return text[text.rfind("\n", 0, position) + 1 : position]


def digest(*parts):
    return hashlib.sha256("\0".join(str(p) for p in parts).encode()).hexdigest()


def mutants_of(root, file, folder, seed):
    """One mutant for each place of a file; which of the changes possible there is a matter of the seed.

    The identifier depends on the text of the line, not on its number: it outlives changes elsewhere in the file.
    """
    text = (Path(root) / file).read_text()
    seen = {}
    for position, kind, old, news in changes(text):
        if not news:
            continue
        begin = text.rfind("\n", 0, position) + 1
        line_text = text[begin : text.find("\n", begin)]
        where = (line_text.strip(), position - begin - (len(line_text) - len(line_text.lstrip())), kind)
        seen[where] = seen.get(where, 0) + 1
        choice = digest(seed, file, *where, seen[where])
        new = news[int(choice[:8], 16) % len(news)]
        ident = digest(file, *where, seen[where], new)[:10]
        yield Mutant(ident, folder, file, position, text.count("\n", 0, position) + 1, position - begin + 1, kind, old, new)


def all_mutants(root, seed):
    """{folder: its mutants in the order in which they are drawn}."""
    drawn = {folder: [] for folder in FOLDERS}
    files = [(p, p.parent.name) for p in Path(root).glob("lib/include/lubjoint/*/*.hpp") if p.parent.name in FOLDERS]
    files += [(Path(root) / "lib/src" / name, folder) for name, folder in SOURCES.items()]
    for path, folder in sorted(files):
        drawn[folder] += mutants_of(root, path.relative_to(root).as_posix(), folder, seed)
    for folder in FOLDERS:
        drawn[folder].sort(key=lambda m: digest(seed, m.ident))
    return drawn


def shares(drawn, count):
    """How many to take of each folder: by the number of places, but at least an eighth of the sample."""
    least = min(count // 8, *(len(m) for m in drawn.values()))
    total = sum(len(m) for m in drawn.values())
    rest = count - least * len(drawn)
    share = {folder: least + rest * len(m) // total for folder, m in drawn.items()}
    largest = max(share, key=share.get)
    share[largest] += count - sum(share.values())
    return share
