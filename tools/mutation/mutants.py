# SPDX-License-Identifier: Apache-2.0
"""The mutants of a file: small faults, each with the text that chooses between it and the original at run time."""
import dataclasses
import re

from mutation.source import CLOSERS, OPENERS, Source

LEVELS = {word: level for level, words in enumerate((
    "||", "&&", "|", "^", "&", "== !=", "< > <= >=", "<=>", "<< >>", "+ -", "* / %")) for word in words.split()}
SWAPPED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
           "+": "-", "-": "+", "*": "/", "/": "*"}
ASSIGNED = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
ENDS = {"return", "co_return", "throw", "case", "else", "?", ":", ";", ",", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=",
        "^=", "->", "do", "in"}
KEYWORDS = {"return", "if", "for", "while", "switch", "do", "else", "throw", "delete", "using", "case", "default", "break",
            "continue", "goto", "public", "private", "protected", "static_assert", "template", "typename", "friend",
            "namespace", "class", "struct", "enum", "constexpr", "const", "static", "auto", "operator", "try", "catch"}
NUMBER = re.compile(r"(\d+)([uU]?[lL]*)|(\d+\.\d*(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)([fF]?)")
CONSTANT = re.compile(r"\b(?:inline |static )?constexpr (double|int|unsigned|std::size_t) \w+ = [^;,{}]*;\Z")


@dataclasses.dataclass
class Mutant:
    file: str
    line: int
    kind: str
    start: int  # what is replaced, as positions in the file
    end: int
    original: str
    mutated: str
    pattern: str  # of the replacement, with {id}
    id: int = -1

    def replacement(self):
        return self.pattern.replace("{id}", str(self.id))


def mutated_number(text):
    """Another number of the same type: 0 and 1 exchanged, others 1; a thousandth more, or a thousandfold tolerance."""
    match = NUMBER.fullmatch(text)
    if not match:
        return None
    if match[1]:
        return ("1" if match[1] != "1" else "0") + match[2]
    value = float(match[3])
    if value == 0.0:
        return "1.0" + match[4]
    return repr(float(f"{value * (1e3 if 'e' in text.lower() else 1.001):.15g}")) + match[4]


class Finder:
    def __init__(self, file, text):
        self.file, self.source, self.mutants = file, Source(text), []

    def all(self):
        source = self.source
        for i, token in enumerate(source.tokens):
            if token.kind == "sign" and token.text in SWAPPED and source.is_spaced(i) and not source.is_fixed(i):
                self.operator(i)
            elif token.kind == "number" and source.word(i - 1) != "case" and not source.in_template[i]:
                self.number(i)
            elif token.text in ("min", "max") and source.word(i + 1) == "(":
                self.extreme(i)
            elif token.text == "if" and source.word(i + 1) == "(":
                self.condition(i)
            if source.in_body(i) and source.word(i - 1) in (";", "{", "}", ")", "else") and not source.is_fixed(i):
                self.statement(i)
        return self.mutants

    def add(self, kind, first, last, mutated, pattern):
        """`pattern`: the replacement of the tokens first to last with {id}, {mutated} and {original}."""
        source = self.source
        if source.has_gap(first, last):
            return
        start, end = source.tokens[first].start, source.tokens[last].end
        original = source.text[start:end]
        # Once on one line, once as it was: lines keep their numbers.
        flat = re.sub(r"\s*\n\s*", " ", mutated)
        pattern = pattern.replace("{mutated}", flat).replace("{original}", original)
        line = source.line(source.tokens[first].start)
        self.mutants.append(Mutant(self.file, line, kind, start, end, " ".join(original.split()), flat, pattern))

    def operand_end(self, i, step, level):
        """The last token of the operands of the operator i, which binds as `level`, on one side; None if unsure."""
        source, k = self.source, i
        while True:
            following = k + step
            if not 0 <= following < len(source.tokens):
                return None
            text = source.word(following)
            if source.tokens[following].kind != "sign" and text not in ENDS:
                if text in KEYWORDS | {"requires", "concept"}:
                    return None
                k = following
            elif source.in_template[following]:
                k = following
            elif text in (CLOSERS if step < 0 else OPENERS):
                if text in "{}" and source.scope(min(following, source.partner[following])) != "list":
                    return k if step < 0 else None
                k = source.partner[following]
            elif text in (OPENERS if step < 0 else CLOSERS) or text in ENDS and text != "->":
                return k
            elif text in LEVELS and source.is_spaced(following) and LEVELS[text] < level:
                return k
            else:
                k = following

    def operator(self, i):
        source = self.source
        token = source.tokens[i]
        level = LEVELS[token.text]
        first, last = self.operand_end(i, -1, level), self.operand_end(i, 1, level)
        if first is None or last is None or first >= i or last <= i:
            return
        if any(source.tokens[k].kind == "text" for k in (i - 1, i + 1)) or source.word(i - 1) == "operator":
            return
        before = source.text[source.tokens[first].start:token.start]
        after = source.text[token.end:source.tokens[last].end]
        self.add("operator", first, last, before + SWAPPED[token.text] + after,
                 "(orispline_mutation::is({id}) ? orispline_mutation::plain({mutated}) : "
                 "orispline_mutation::plain({original}))")

    def number(self, i):
        source = self.source
        mutated = mutated_number(source.word(i))
        if mutated is None or source.word(i - 1) == "default":
            return
        if not source.is_fixed(i):
            self.add("number", i, i, mutated, "(orispline_mutation::is({id}) ? {mutated} : {original})")
            return
        # A named constant becomes a variable that is initialised at the start.
        first = source.statement_start(i)
        last = next((k for k in range(i, len(source.tokens)) if source.word(k) == ";"), None)
        if last and source.parent[last] == source.parent[first] and CONSTANT.fullmatch(source.between(first, last)):
            up = source.parent[first]
            is_member = up is not None and source.scope(up) == "scope" and source.word(first) == "static"
            variable = "inline const" if is_member else "const"
            text = source.between(first, last).replace("constexpr", variable, 1)
            at = source.tokens[i].start - source.tokens[first].start - len("constexpr") + len(variable)
            choice = f"(orispline_mutation::is_at_start({{id}}) ? {mutated} : {source.word(i)})"
            mutated_text = text[:at] + mutated + text[at + len(source.word(i)):]
            self.add("constant", first, last, mutated_text, text[:at] + choice + text[at + len(source.word(i)):])

    def extreme(self, i):
        """std::min and std::max."""
        source = self.source
        if source.word(i - 1) != "::" or source.word(i - 2) != "std" or source.is_fixed(i):
            return
        last = source.partner[i + 1]
        other = "max" if source.word(i) == "min" else "min"
        self.add("extreme", i - 2, last, f"std::{other}" + source.between(i + 1, last),
                 "(orispline_mutation::is({id}) ? {mutated} : {original})")

    def condition(self, i):
        """Negated, and where it leads to a return, never met."""
        source = self.source
        first, last = i + 2, source.partner[i + 1] - 1
        for k in range(first, last + 1):
            if source.parent[k] == i + 1 and source.word(k) == ";":
                first = k + 1
        if any(source.parent[k] == i + 1 and source.word(k) == "=" for k in range(first, last + 1)) or first > last:
            return
        original = source.between(first, last)
        self.add("negated", first, last, f"!({original})", "(orispline_mutation::is({id}) != static_cast<bool>({original}))")
        body = last + 2 + (source.word(last + 2) == "{")
        if source.word(body) == "return":
            self.add("guard", first, last, "false", "(orispline_mutation::is({id}) ? false : static_cast<bool>({original}))")

    def statement(self, i):
        """An assignment, a call or a count left out; a compound assignment turned round."""
        source = self.source
        if source.word(i - 1) == ")" and source.word(source.partner[i - 1] - 1) not in ("if", "for", "while"):
            return
        last = next((k for k in range(i, len(source.tokens)) if source.parent[k] == source.parent[i]
                     and source.word(k) in (";", "}")), None)
        if last is None or source.word(last) != ";" or source.word(i) in KEYWORDS or last == i:
            return
        own = [k for k in range(i, last) if source.parent[k] == source.parent[i] and not source.in_template[k]]
        sign = next((k for k in own if source.word(k) in ("=", *ASSIGNED)), None)
        head = [k for k in own if sign is None or k < sign]
        if any(source.tokens[a].kind == source.tokens[b].kind == "word" for a, b in zip(head, head[1:])):
            return  # a variable is declared
        if any(source.word(k) in ("<<", ">>", "&") for k in head) or any(k + 1 < last and source.in_template[k + 1] and
               source.tokens[k].kind == "word" and sign is not None for k in head):
            return
        if any(source.word(k) == "*" and k > i and not source.is_spaced(k) for k in head):
            return  # a pointer is declared
        if source.word(last - 1) == ")" and source.word(source.partner[last - 1] - 1) == "reserve":
            return  # nothing but time depends on it
        if sign is None and not (self.is_call(i, last) or source.word(i) in ("++", "--")):
            return
        self.add("left out", i, last, ";", "{ if (!orispline_mutation::is({id})) {original} }")
        if sign and source.word(sign) in ASSIGNED:
            at, text = source.tokens[sign], source.text
            turned = text[source.tokens[i].start:at.start] + ASSIGNED[at.text] + text[at.end:source.tokens[last].end]
            self.add("operator", i, last, turned, "{ if (orispline_mutation::is({id})) {mutated} else {original} }")

    def is_call(self, i, last):
        source = self.source
        return (source.word(last - 1) == ")" and source.tokens[i].kind == "word" and not source.word(i).isupper()
                and not source.word(i).startswith("ORISPLINE") and source.word(i) != "void")


def mutants_of(file, text):
    return Finder(file, text).all()
