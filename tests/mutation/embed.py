"""Puts many mutants into one source, each behind a switch that is read when the program runs.

The unit of change is the statement around a mutant: `S` becomes `if (on(k)) S'; else S`. What is no statement of a function
(default values of members, constants at compile time, template code whose types change with an operator) stays out, and has
to be compiled by itself. Lines keep their numbers.
"""

import re

from mutants import OPENING, closing, tokens_of

#: Included by every unit before all else. Constant expressions are evaluated unmutated.
SWITCH = """\
#pragma once
namespace lubjoint_mutation {
extern int active;
extern unsigned char reached[];
constexpr bool on(int mutant) {
  if (__builtin_is_constant_evaluated()) return false;
  return (reached[mutant] = 1) && mutant == active;
}
}
"""

#: LUBJOINT_MUTANT: the mutant that is switched on; LUBJOINT_REACHED: file for the numbers of those that were asked for.
RUNTIME = """\
#include <cstdio>
#include <cstdlib>
namespace lubjoint_mutation {
unsigned char reached[1 << 16];
int active = -1;
__attribute__((constructor)) static void choose() {
  const char* text = std::getenv("LUBJOINT_MUTANT");
  std::atexit([] {
    const char* name = std::getenv("LUBJOINT_REACHED");
    std::FILE* file = name ? std::fopen(name, "w") : nullptr;
    if (!file) return;
    for (int i = 0; i < 1 << 16; ++i) if (reached[i]) std::fprintf(file, "%d\\n", i);
    std::fclose(file);
  });
  if (text) active = std::atoi(text);
}
}
"""

BEFORE_BLOCK = {")", "else", "do", "try", "const", "noexcept", "override", "mutable", "]", ":", ";", "{", "}"}
CONTROL = ("if", "for", "while")


def kinds_of_braces(tokens):
    """{index of each '{': block, scope (of a class, namespace or enumeration) or list}."""
    kinds = {}
    head = 0  # first token of the current statement
    for i, t in enumerate(tokens):
        if t.text == "{":
            # `class` between template brackets declares a parameter.
            words = [x.text for n, x in enumerate(tokens[head:i], head) if tokens[n - 1].text not in ("<", ",")]
            if any(w in ("struct", "class", "union", "namespace", "enum") for w in words) and ")" not in words[-1:]:
                kinds[i] = "scope"
            elif i == 0 or tokens[i - 1].text in BEFORE_BLOCK or ("->" in words and ")" in words):
                kinds[i] = "block"
            else:
                kinds[i] = "list"
        if t.text in (";", "{", "}"):
            head = i + 1
    return kinds


def statement_around(text, tokens, i):
    """(first, last) tokens of the simple statement or the condition around token i, and which of both; or None."""
    kinds = kinds_of_braces_of(text, tokens)
    first = last = None
    j = i - 1
    while j >= 0:
        t = tokens[j].text
        if t in (")", "]") or (t == "}" and "\n" not in text[tokens[j].end : tokens[j + 1].start]):
            j = opening(tokens, j)
        elif t == "{" and kinds[j] == "scope":
            return None
        elif t in (";", "}") or (t == "{" and kinds[j] == "block"):
            inside = enclosing(tokens, j) if t != "{" else j
            if inside is None or tokens[inside].text != "{" or kinds[inside] != "block":
                if inside is None or tokens[inside].text == "{":
                    return None
                j = inside  # the head of a for
            else:
                first = j + 1
                break
        j -= 1
    if first is None:
        return None
    # Past labels and the heads of control statements.
    while True:
        word = tokens[first].text
        if word == "else":
            first += 1
        elif word in ("case", "default"):
            while tokens[first].text != ":":
                first += 1
            first += 1
        elif word in CONTROL:
            if tokens[first + 1].text != "(":
                return None  # if constexpr
            end = closing(tokens, first + 1)
            if i <= end:
                return condition(tokens, first, end, i)
            first = end + 1
        else:
            break
    if i < first:
        return None
    last = first
    while tokens[last].text != ";":
        if tokens[last].text in OPENING:
            last = closing(tokens, last)
        last += 1
        if last >= len(tokens):
            return None
    return first, last, "statement"


def condition(tokens, first, end, i):
    """The condition in the head of a control statement, if token i is in it."""
    parts, start = [], first + 2
    j = start
    while j < end:
        if tokens[j].text in OPENING:
            j = closing(tokens, j)
        elif tokens[j].text in (";", ":"):
            parts.append((start, j - 1, tokens[j].text))
            start = j + 1
        j += 1
    parts.append((start, end - 1, ""))
    wanted = parts[0] if len(parts) == 1 and tokens[first].text != "for" else parts[1] if len(parts) == 3 else None
    if wanted is None or not wanted[0] <= i <= wanted[1] or "=" in [t.text for t in tokens[wanted[0] : wanted[1] + 1]]:
        return None
    return wanted[0], wanted[1], "condition"


def opening(tokens, i):
    """Index of the bracket that is closed at i."""
    depth = 0
    for j in range(i, -1, -1):
        if tokens[j].text in (")", "]", "}"):
            depth += 1
        elif tokens[j].text in OPENING:
            depth -= 1
            if depth == 0:
                return j
    return 0


def enclosing(tokens, i):
    """Index of the innermost bracket open at token i, or None."""
    j = i if tokens[i].text not in (")", "]", "}") else opening(tokens, i)
    j -= 1
    while j >= 0:
        if tokens[j].text in (")", "]", "}"):
            j = opening(tokens, j)
        elif tokens[j].text in OPENING:
            return j
        j -= 1
    return None


_kinds = {}


def kinds_of_braces_of(text, tokens):
    key = hash(text)
    if key not in _kinds:
        _kinds.clear()
        _kinds[key] = kinds_of_braces(tokens)
    return _kinds[key]


DECLARATION = re.compile(r"(const )?((?:typename )?[\w:]+(?:<[^=;()]*>)?(?:::\w+)*) (\w+)( = |\()(.*)\)?;", re.S)


def squeezed(source):
    """Without comments, on one line."""
    return re.sub(r"\s+", " ", re.sub(r"//[^\n]*", "", source)).strip()


def switched(source, kind, variants):
    """The statement or condition with a switch for each (number, mutated source); None if its form is not known."""
    if kind == "condition":
        for k, other in variants:
            source = f"(lubjoint_mutation::on({k}) ? static_cast<bool>({squeezed(other)}) : static_cast<bool>({source}))"
        return source
    if re.match(r"(static|constexpr|using|throw|switch|break|continue|do|typedef|struct|class)\b", source):
        return None
    if source.startswith("return"):
        first = "".join(f"if (lubjoint_mutation::on({k})) {squeezed(other)} " for k, other in variants)
        return "{ " + first + source + " }"
    m = DECLARATION.fullmatch(source)
    if m and m.group(2) not in ("return", "delete", "new", "else"):
        constant, kind_of, name, form = m.group(1) or "", m.group(2), m.group(3), m.group(4)
        returned = "" if kind_of == "auto" else f" -> {kind_of}"
        begin = m.start(5) if form == " = " else m.end(3)
        wrap = "{}" if form == " = " else kind_of + "{}"
        value = wrap.format(source[begin:-1])
        if form == " = " and source[begin] in "[{":
            return None
        first = ""
        for k, other in variants:
            if not other.startswith(source[:begin]):
                return None
            first += f"if (lubjoint_mutation::on({k})) return {squeezed(wrap.format(other[begin:-1]))}; "
        return f"{constant}{kind_of} {name} = [&](){returned} {{ {first}return {value}; }}();"
    first = "".join(f"if (lubjoint_mutation::on({k})) {{ {squeezed(other)} }} else " for k, other in variants)
    if re.match(r"(const\b|auto\b|[\w:]+(<.*>)?[&*]? \w+)", source):
        return None  # a declaration of another form
    return "{ " + first + "{ " + source + " } }"


def embed(text, mutants):
    """(text with switches, {identifier of a mutant in it: lines of its statement}). mutants: [(number, mutant)] of this file."""
    tokens = tokens_of(text)
    index = {t.start: i for i, t in enumerate(tokens)}
    groups, literals = {}, []
    for k, m in mutants:
        i = index.get(m.position)
        around = statement_around(text, tokens, i) if i is not None else None
        if around:
            groups.setdefault(around, []).append((k, m))
        elif m.kind == "constant" or m.old in ("true", "false"):
            literals.append((k, m))
    edits, inside = [], {}
    for (first, last, kind), members in sorted(groups.items()):
        begin, end = tokens[first].start, tokens[last].end
        variants = [(k, m.apply(text)[begin : end + len(m.new) - len(m.old)]) for k, m in members]
        new = switched(text[begin:end], kind, variants)
        if new is None:
            literals += [(k, m) for k, m in members if m.kind == "constant" or m.old in ("true", "false")]
        elif not any(b < end and begin < e for b, e, _, _ in edits):
            edits.append((begin, end, new, [m.ident for _, m in members]))
    for k, m in literals:
        begin, end = m.position, m.position + len(m.old)
        if in_function(text, tokens, index[m.position]) and not any(b < end and begin < e for b, e, _, _ in edits):
            edits.append((begin, end, f"(lubjoint_mutation::on({k}) ? {m.new} : {m.old})", [m.ident]))
    for begin, end, new, idents in sorted(edits, reverse=True):
        lines = (text.count("\n", 0, begin) + 1, text.count("\n", 0, end) + 1)
        inside |= dict.fromkeys(idents, lines)
        text = text[:begin] + new + text[end:]
    return text, inside


def in_function(text, tokens, i):
    """Whether a value at token i is evaluated when the program runs."""
    kinds = kinds_of_braces_of(text, tokens)
    begin = text.rfind("\n", 0, tokens[i].start) + 1
    if re.match(r"\s*(static )?constexpr\b|\s*case\b|\s*if constexpr\b", text[begin : tokens[i].start]):
        return False
    j = enclosing(tokens, i)
    while j is not None:
        if tokens[j].text == "{" and kinds[j] != "list":
            # Default values of members are evaluated then, too.
            return kinds[j] == "block" or not re.search(r"\b(static|virtual|enum|template)\b", text[begin : tokens[i].start])
        j = enclosing(tokens, j)
    return False
