# SPDX-License-Identifier: Apache-2.0
"""The reference of the C++ library: one page for each public header, from Doxygen's XML.

What a header only includes stands on the page of the public header that is nearest to it, so that everything is told once.
"""
import collections
import dataclasses
import pathlib
import re
import xml.etree.ElementTree as xml

import markup

INCLUDE = re.compile(r"^#include <(orispline/[^>]+)>", re.M)
WIDEST = 96  # characters of a declaration in one line
TYPES = ("class", "struct", "concept")


@dataclasses.dataclass
class Entity:
    """A type or a function that is told under a heading of its own, with the declarations that share its text."""
    name: str
    anchor: str
    place: tuple
    declarations: list
    text: str
    members: list = dataclasses.field(default_factory=list)  # (declaration, text)


def page_of_each(include, public):
    """The public header on whose page a header is told: the nearest that includes it, the first of those in the order of `public`."""
    page = {f"orispline/{name}": name for name in public}
    queue = collections.deque(page)
    while queue:
        header = queue.popleft()
        for inner in INCLUDE.findall((include / header).read_text("utf-8")):
            if inner not in page and (include / inner).exists():
                page[inner] = page[header]
                queue.append(inner)
    return page


def plain(node):
    """All text of a node, without the spaces that Doxygen puts within angle brackets."""
    text = "".join(node.itertext()) if node is not None else ""
    text = re.sub(r"<\s+", "<", re.sub(r"\s+>", ">", " ".join(text.split())))
    return re.sub(r"\s*([&*])\s*(?=[\w)>,.]|$)", lambda sign: sign[1] + " ", text).replace("& &", "&&").strip()


class Texts:
    """Descriptions as Markdown; `anchors` has those of the types by Doxygen's names for them."""

    def __init__(self, anchors):
        self.anchors = anchors

    def described(self, node):
        """What the comment of an entity says."""
        parts = [self.blocks(node.find(part)) for part in ("briefdescription", "detaileddescription")]
        return "\n\n".join(part for part in parts if part)

    def blocks(self, node):
        return "\n\n".join(filter(None, (self.paragraph(child) for child in node))) if node is not None else ""

    def paragraph(self, node):
        """A paragraph, whose lists are blocks of their own."""
        lists = [self.bullets(child) for child in node if child.tag == "itemizedlist"]
        line = " ".join(self.line(node).split())
        return "\n\n".join(filter(None, [line, *lists]))

    def bullets(self, node):
        return "\n".join("- " + " ".join(self.blocks(item).split()) for item in node)

    def line(self, node):
        text = markup.escaped(node.text or "")
        for child in node:
            text += self.inline(child) + markup.escaped(child.tail or "")
        return text

    def inline(self, node):
        match node.tag:
            case "computeroutput":
                target = next((self.anchors[ref.get("refid")] for ref in node if ref.get("refid") in self.anchors), None)
                text = markup.code("".join(node.itertext()))
                return f"[{text}](#{target})" if target and len(node) == 1 and not (node.text or node[0].tail) else text
            case "ref" if node.get("refid") in self.anchors:
                return f"[{self.line(node)}](#{self.anchors[node.get('refid')]})"
            case "ref" | "para":
                return self.line(node)
            case "emphasis":
                return f"*{self.line(node)}*"
            case "bold":
                return f"**{self.line(node)}**"
            case "lsquo" | "rsquo":
                return "'"
            case "itemizedlist":
                return ""
        raise markup.Fault(f"found <{node.tag}> in a comment, wanted a case for it in tools/site/headers.py")


def template_of(node):
    parameters = [" ".join(filter(None, [plain(p.find("type")), plain(p.find("declname")), f"= {plain(p.find('defval'))}" if p.find("defval") is not None else ""]))
                  for p in node.findall("templateparamlist/param")]
    return f"template <{', '.join(parameters)}>\n" if parameters else ""


def wrapped(head, arguments, tail):
    """A declaration in one line, or with one argument a line where that would be too wide."""
    one = f"{head}({', '.join(arguments)}){tail}"
    if len(one) <= WIDEST or not arguments:
        return one
    return f"{head}(\n    " + ",\n    ".join(arguments) + f"){tail}"


def argument(param):
    name, array, value = (plain(param.find(part)) for part in ("declname", "array", "defval"))
    kind = plain(param.find("type"))
    text = re.sub(r"([&*]) $", r"\1", f"{kind} {name}{array}".rstrip())
    return text + (f" = {value}" if value else "")


def function(node):
    marks = [word for word, attribute in (("static", "static"), ("explicit", "explicit")) if node.get(attribute) == "yes"]
    if node.get("virt") in ("virtual", "pure-virtual"):
        marks.append("virtual")
    kind = plain(node.find("type"))
    head = " ".join([*marks, *([kind] if kind else []), node.findtext("name")])
    arguments = [argument(param) for param in node.findall("param") if plain(param.find("type")) != "void"]
    tail = re.sub(r"^.*\)", "", node.findtext("argsstring") or "", flags=re.S).replace("=0", " = 0").replace("=default", " = default").replace("=delete", " = delete")
    return template_of(node) + wrapped(head, arguments, tail.rstrip())


def variable(node):
    value = plain(node.find("initializer"))
    static = "static " if node.get("static") == "yes" else ""
    text = f"{static}{plain(node.find('type'))} {node.findtext('name')}{plain(node.find('argsstring'))}"
    return template_of(node) + text + (f" {value}" if value and len(value) <= 40 and value != "{}" else "")


def alias(node):
    return template_of(node) + f"using {node.findtext('name')} = {plain(node.find('type'))}"


def declaration(node):
    match node.get("kind"):
        case "function" | "friend":
            return function(node)
        case "enum":
            return f"enum {'class ' if node.get('strong') == 'yes' else ''}{node.findtext('name')}"
        case "typedef":
            return alias(node)
    return variable(node)


def type_head(node):
    if node.get("kind") == "concept":
        return re.sub(r"concept orispline::(\w+::)*", "concept ", "".join(node.find("initializer").itertext())).strip()
    bases = ", ".join(plain(base).replace("orispline::", "") for base in node.findall("basecompoundref") if base.get("prot") == "public")
    name = short(node.findtext("compoundname")).split("<")[0]
    return template_of(node) + f"{node.get('kind')} {name}" + (f" : {bases}" if bases else "")


def short(name):
    return re.sub(r"^orispline::", "", re.sub(r"<\s+", "<", re.sub(r"\s+>", ">", name)))


def place_of(node):
    location = node.find("location")
    return location.get("file"), int(location.get("line"))


def public_members(node):
    members = [member for section in node.findall("sectiondef") for member in section.findall("memberdef") if member.get("prot") != "private"]
    members = [member for member in members if member.get("kind") != "friend" or "operator" in member.findtext("name")]
    return sorted(members, key=lambda member: place_of(member)[1])


def told(members, texts):
    """Members with their texts; those of enumerations are their values. One that says nothing is told with the one before it."""
    for member in members:
        yield declaration(member), texts.described(member)
        for value in member.findall("enumvalue"):
            yield f"{member.findtext('name')}::{value.findtext('name')}", texts.described(value)


def is_told(node):
    """Whether users name the type: no specialisation of a template, nothing private."""
    name = node.findtext("compoundname")
    return name.startswith("orispline") and "<" not in name and node.get("prot", "public") != "private"


class Library:
    """All that Doxygen wrote."""

    def __init__(self, folder):
        documents = [xml.parse(file).getroot() for file in sorted(pathlib.Path(folder).glob("*.xml")) if file.name not in ("index.xml", "Doxyfile.xml")]
        nodes = [node for document in documents for node in document.findall("compounddef")]
        self.types = [node for node in nodes if node.get("kind") in TYPES and is_told(node)]
        self.namespaces = [node for node in nodes if node.get("kind") == "namespace" and node.findtext("compoundname").startswith("orispline")]
        self.texts = Texts({node.get("id"): f"cpp-{self.slug(node)}" for node in self.types})

    @staticmethod
    def slug(node):
        return re.sub(r"\W+", "-", node.findtext("compoundname")).strip("-").lower()

    def entities(self):
        """Everything that has a place in a header, in the order of the headers."""
        found = [Entity(short(node.findtext("compoundname")), self.texts.anchors[node.get("id")], place_of(node), [type_head(node)], self.texts.described(node),
                        list(told(public_members(node), self.texts))) for node in self.types]
        for space in self.namespaces:
            prefix = short(space.findtext("compoundname") + "::").removeprefix("orispline::")
            for member in public_members(space):
                values = list(told([member], self.texts))[1:]
                name = prefix + member.findtext("name") + ("()" if member.get("kind") == "function" else "")
                found.append(Entity(name, "", place_of(member), [declaration(member)], self.texts.described(member), values))
        return joined(sorted(found, key=lambda entity: entity.place))


def joined(entities):
    """Neighbours of one name are told together, and so is one that says nothing with the one before it."""
    result = []
    for entity in entities:
        last = result[-1] if result else None
        if last and last.name == entity.name and last.place[0] == entity.place[0]:
            last.declarations += entity.declarations
            last.text = "\n\n".join(filter(None, [last.text, entity.text]))
        else:
            result.append(entity)
    return result


def member_lines(members):
    lines = []
    for text, told_of in members:
        one_line = " ".join(text.split()).replace("( ", "(")
        lines += [markup.code(one_line), ": " + (told_of.replace("\n", "\n  ") or "&nbsp;"), ""]
    return lines


def page(title, about, entities):
    lines = [f"# {title}", "", markup.block("cpp", f"#include <orispline/{title}>"), "", about, ""]
    for entity in entities:
        if entity.anchor:
            lines += [f"({entity.anchor})=", ""]
        lines += [f"## {markup.code(entity.name)}", "", markup.block("cpp", ";\n".join(entity.declarations) + ";"), "", entity.text, "", *member_lines(entity.members)]
    return "\n".join(lines).rstrip() + "\n"


def pages(include, folder, public):
    """Name of the page -> its text, for the public headers with what is said about each."""
    where = page_of_each(include, list(public))
    entities = collections.defaultdict(list)
    for entity in Library(folder).entities():
        entities[entity.place[0]].append(entity)
    order = collections.defaultdict(list)
    for header, public_header in where.items():
        order[public_header] += entities[header]
    return {name: page(name, about, order[name]) for name, about in public.items()}
