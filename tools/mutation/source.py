# SPDX-License-Identifier: Apache-2.0
"""C++ as tokens with their brackets, as far as a file in the layout of .clang-format can be told without a compiler.

The layout decides what is otherwise ambiguous: binary operators stand between blanks, brackets of templates do not.
"""
import bisect
import functools
import re

SKIPPED = r"""//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*"""
TOKEN = re.compile(
    SKIPPED.join((r"(?P<skipped>", ")|")) +
    r"""(?P<text>(?:u8|[uUL])?R"(?P<mark>[^()\s]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')|"""
    r"""(?P<number>\.?\d(?:[eE][+-]?\d|'?[\w.])*)|(?P<word>[A-Za-z_]\w*)|"""
    r"""(?P<sign><<=|>>=|<=>|->\*|\.\.\.|<<|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|%=|&=|\|=|\^=|\+\+|--|->|::|\.\*|[^\s\w])""",
    re.M | re.S)
OPENERS, CLOSERS = "([{", ")]}"
SCOPES = {"class", "struct", "union", "namespace", "enum"}
UNEVALUATED = {"constexpr", "requires", "noexcept", "decltype", "static_assert", "sizeof", "alignas", "explicit", "alignof"}
FIXED = {"constexpr", "using", "template", "enum", "case", "concept", "friend", "static_assert", "typedef", "requires",
         "consteval", "constinit"}


class Token:
    def __init__(self, match):
        self.kind, self.text = match.lastgroup, match.group()
        self.start, self.end = match.span()
        if self.kind == "mark":
            self.kind = "text"


class Source:
    """The tokens of a file; `partner[i]` is the other bracket of i, `parent[i]` the bracket that encloses i."""

    def __init__(self, text):
        self.text = text
        self.tokens = [Token(match) for match in TOKEN.finditer(text) if match.lastgroup != "skipped"]
        self.lines = [match.start() for match in re.finditer(r"^", text, re.M)]
        self._match_brackets()
        self._mark_templates()

    def _match_brackets(self):
        self.partner, self.parent, stack = {}, [], []
        for i, token in enumerate(self.tokens):
            if token.text in CLOSERS and token.kind == "sign":
                if not stack:
                    raise ValueError(f"bracket without partner in line {self.line(token.start)}")
                opener = stack.pop()
                self.partner[i], self.partner[opener] = opener, i
            self.parent.append(stack[-1] if stack else None)
            if token.text in OPENERS and token.kind == "sign":
                stack.append(i)
        if stack:
            raise ValueError(f"bracket without partner in line {self.line(self.tokens[stack[-1]].start)}")

    def _mark_templates(self):
        """The tokens in brackets of templates, those brackets among them."""
        self.in_template = [False] * len(self.tokens)
        i = 0
        while i < len(self.tokens):
            end = self._template_end(i) if self._opens_template(i) else None
            if end is not None:
                for k in range(i, end + 1):
                    self.in_template[k] = True
                i = end
            i += 1

    def _opens_template(self, i):
        if self.word(i) != "<" or i == 0:
            return False
        return self.tokens[i - 1].text == "template" or (self.tokens[i - 1].kind == "word" and not self.is_spaced(i))

    def _template_end(self, i):
        depth, k = 0, i
        while k < len(self.tokens):
            text = self.tokens[k].text
            if text in OPENERS:
                k = self.partner[k]
            elif text in CLOSERS or text == ";":
                return None
            elif text == "<":
                depth += 1
            elif text == ">":
                depth -= 1
                if depth == 0:
                    return k
            k += 1
        return None

    def word(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def line(self, position):
        return bisect.bisect_right(self.lines, position)

    def is_spaced(self, i):
        """Whether a token stands between blanks, as binary operators do."""
        token = self.tokens[i]
        return self.text[token.start - 1].isspace() and self.text[token.end:token.end + 1].isspace()

    def between(self, first, last):
        """The text of the tokens first to last."""
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def has_gap(self, first, last):
        """Whether a comment or a directive stands between."""
        pairs = zip(self.tokens[first:last], self.tokens[first + 1:last + 1])
        return any(self.text[a.end:b.start].strip() for a, b in pairs)

    def statement_start(self, i):
        """The first token of the statement, or of the header of a block, in whose own depth i is."""
        k = i
        while k > 0 and self.parent[k - 1] == self.parent[i]:
            before = self.word(k - 1)
            if before == ";" or before == "}" and self.tokens[k].kind != "sign":
                break
            k = min(self.partner.get(k - 1, k - 1), k - 1)
        return k

    @functools.lru_cache(maxsize=None)
    def scope(self, i):
        """What the brace i opens: "body" of statements, "scope" of declarations, "enum", or "list" of values."""
        first = self.statement_start(i)
        heads = {self.word(k) for k in range(first, i) if self.parent[k] == self.parent[i] and not self.in_template[k]}
        if heads & SCOPES:
            return "enum" if "enum" in heads else "scope"
        has_statements = any(self.word(k) == ";" and self.parent[k] == i for k in range(i, self.partner[i]))
        return "body" if has_statements else "list"

    def is_fixed(self, i):
        """Whether i belongs to what the compiler must know: a type, a constant, a condition of `if constexpr`."""
        if self.in_template[i]:
            return True
        at = i
        while at is not None:
            up = self.parent[at]
            first = self.statement_start(at)
            if FIXED & {self.word(k) for k in range(first, min(first + 4, at))}:
                return True
            if up is not None and self.word(up) == "(" and self.word(up - 1) in UNEVALUATED:
                return True
            if up is not None and self.word(up) == "[" and self.word(up + 1) == "[":
                return True
            if up is not None and self.word(up) == "{" and self.scope(up) != "list":
                return self.scope(up) == "enum"
            at = up
        return False

    def in_body(self, i):
        """Whether i is at the depth of statements of a function."""
        up = self.parent[i]
        return up is not None and self.word(up) == "{" and self.scope(up) == "body"
