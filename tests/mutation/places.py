"""Where a tired programmer slips in C++ source, and what he writes instead.

A place is one change of one line. Comments, texts, preprocessor lines, input checks and declarations of interfaces are no
places: no run of a valid scene could show a change there."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Place:
    file: str  # relative to engine/
    line: int  # counted from 1
    kind: str
    before: str
    after: str


# An operand: a name, number, member, call or index without nested calls.
OPERAND = r"[\w.:]+(?:->\w+)*(?:\[[^\[\]]*\])?(?:\([^()]*\))?(?:\.\w+)*"
NUMBER = r"(?<![\w.\"'])(?:\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+)f?(?![\w.])"


def off_by_two_percent(match):
    return repr(float(match.group().rstrip("f")) * 1.02)


# kind, pattern, replacement. Spaces around binary operators are those of clang-format.
CHANGES = [
    ("sign", r" \+ ", " - "),
    ("sign", r" - ", " + "),
    ("sign", r" \+= ", " -= "),
    ("sign", r" -= ", " += "),
    ("sign", r"(?<=[=(,?:] )-(?=[\w(])|(?<=\()-(?=[\w(])|(?<=return )-(?=[\w(])", ""),
    ("index", r"\[(\w+)\]", r"[\1 + 1]"),
    ("index", r"\[(\w+) [-+] 1\]", r"[\1]"),
    ("index", r"\[0\]", "[1]"),
    ("index", r"\[1\]", "[0]"),
    ("bound", r"(?<=[\w)\]]) < (?=[\w(-])", " <= "),
    ("bound", r" <= ", " < "),
    ("bound", r"(?<=[\w)\]]) > (?=[\w(-])", " >= "),
    ("bound", r" >= ", " > "),
    ("bound", r"(?<== )0(?=; \w+ <)", "1"),
    ("comparison", r"(?<=[\w)\]]) < (?=[\w(-])", " > "),
    ("comparison", r"(?<=[\w)\]]) > (?=[\w(-])", " < "),
    ("comparison", r" == ", " != "),
    ("comparison", r" != ", " == "),
    ("comparison", r" && ", " || "),
    ("comparison", r" \|\| ", " && "),
    ("comparison", r"(?<=\()!(?=\w)|(?<=(?:&& |\|\| ))!(?=\w)|(?<=return )!(?=\w)", ""),
    ("comparison", r"std::min(?=[({<])", "std::max"),
    ("comparison", r"std::max(?=[({<])", "std::min"),
    ("dropped term", rf" [-+] {OPERAND}(?=[;,)]| [-+?:])", ""),
    ("dropped factor", rf" [*/] {OPERAND}(?=[;,)]| [-+*/?:])", ""),
    ("dropped factor", rf"(?<=[ (]){OPERAND} \* (?={OPERAND})", ""),
    ("swapped operand", rf"(?<=[ (])({OPERAND}) - ({OPERAND})(?=[;,)])", r"\2 - \1"),
    ("swapped operand", r"(?<=\w\()(?<!\bm(?:in|ax)\()(?<!\bdot\()([\w.]+), ([\w.]+)(?=\))", r"\2, \1"),
    ("swapped operand", r"(?<=[\w\])])\.x\b", ".y"),
    ("swapped operand", r"(?<=[\w\])])\.y\b", ".x"),
    ("swapped operand", r"(?<=[\w\])])\.a\b", ".b"),
    ("swapped operand", r"(?<=[\w\])])\.b\b", ".a"),
    ("swapped operand", r"\b(\w+)_a\b", r"\1_b"),
    ("swapped operand", r"\b(\w+)_b\b", r"\1_a"),
    ("constant", NUMBER, off_by_two_percent),
    ("constant", r"(?<=[*/] )2(?=[;,) ])|(?<![\w.])2(?= \*)", "2.04"),
    ("dropped statement", r"^\s*(?:[\w.:\[\]\->()*]+ (?:[-+*/|&]?=) .*|(?:\w+(?:\.|->|::))*\w+\(.*\));$", ""),
]
CHANGES = [(kind, re.compile(pattern), to) for kind, pattern, to in CHANGES]

# Texts, checks that no valid scene fails, compile-time matters, and what has no effect on a result: memory to come, longer arrays.
NO_PLACE = re.compile(r'^\s*(?:#|using |namespace |template|static_assert|assert|throw|//|friend |class |struct |enum |'
                      r'(?:check|require)\w*\()'
                      r'|throw |invalid_argument|IMPULSE_STAGE|prefetch|\.reserve\(|["]'
                      r'|^\s*(?:(?:const|constexpr|static) )*[\w:<>]+[*&]? \w+(?:\[[^\]]+\])+(?:;| = \{)')


def code_of(line):
    """The line without its comment."""
    return re.sub(r"\s*//.*$", "", line.rstrip("\n"))


def changes_of(line):
    """Every (kind, changed line) of a line of source."""
    code = code_of(line)
    if NO_PLACE.search(code):
        return []
    comment = line.rstrip("\n")[len(code):]
    found = []
    for kind, pattern, to in CHANGES:
        for match in pattern.finditer(code):
            change = to(match) if callable(to) else match.expand(to)
            changed = code[: match.start()] + change + code[match.end():]
            if changed != code:
                found.append((kind, changed + comment))
    return found


def places_in(file, text):
    """The places of a file, by line: a list of lists."""
    lines = text.split("\n")
    found = []
    checking = False  # inside a statement that may throw: it checks input
    for number, line in enumerate(lines):
        following = lines[number + 1] if number + 1 < len(lines) else ""
        checking = re.match(r"\s*(?:if|for) ", line) is not None and re.search(r"throw |\brefuse_", following) is not None
        if checking or line.lstrip().startswith("///"):
            continue
        places = [Place(file, number + 1, kind, line, changed) for kind, changed in changes_of(line)]
        if places:
            found.append(places)
    return found
