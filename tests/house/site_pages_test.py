#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/site makes of the pages of the repository, before Sphinx sees them."""
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/site"))
import headers  # noqa: E402
import make  # noqa: E402
import markup  # noqa: E402
import pages  # noqa: E402

INDEX = """# Pages

## Start

| page | answers |
|---|---|
| [The `first`](first.md) | why |

## Methods

| method | continuity |
|---|---|
| [`slerp`](families/slerp.md) | C⁰ |

## Headers of the C++ library

| header | has |
|---|---|
| `all.hpp`, `part.hpp` | everything |

## Examples

1. [`one.cpp`](../examples/one.cpp): a program
"""
FILES = {
    "README.md": "# Front\n\n[first](docs/first.md#why)\n", "docs/index.md": INDEX, "docs/first.md": "# First\n\n[front](../README.md) [program](../examples/one.cpp) [data](data.csv)\n",
    "docs/data.csv": "t\n", "docs/families/slerp.md": "# slerp\n\n![A picture](slerp.svg)\n", "docs/families/slerp.svg": "<svg/>", "examples/one.cpp": "int main() {}\n",
    "bindings/c/orispline.h": "#pragma once\n"}


class Repository(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root, self.site = pathlib.Path(folder.name) / "root", pathlib.Path(folder.name) / "site"
        for name, text in FILES.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, "utf-8")

    def written(self):
        pages.Pages(self.root).write(self.site)
        return {path.relative_to(self.site).as_posix(): path.read_text("utf-8") for path in self.site.rglob("*") if path.is_file()}

    def test_the_readme_is_the_first_page_with_the_side_bar_of_the_index(self):
        front = self.written()["index.md"]
        self.assertTrue(front.startswith("# Front\n\n[first](docs/first.md#why)\n"))
        self.assertEqual(re.findall(r"^:caption: (.*)$", front, re.M), ["Start", "Reference"])
        self.assertIn("The first </docs/first>", front)

    def test_links_lead_to_the_copies_of_the_site(self):
        files = self.written()
        self.assertIn("[front](../index.md) [program](../examples/one.cpp.md) [data](data.csv)", files["docs/first.md"])
        self.assertEqual(files["docs/data.csv"], "t\n")
        self.assertEqual(files["examples/one.cpp.md"], "# one.cpp\n\n```cpp\nint main() {}\n```")

    def test_methods_have_their_pictures_on_one_page(self):
        text = self.written()["methods.md"]
        self.assertIn("[![Curves by slerp](docs/families/slerp.svg) slerp](docs/families/slerp.md)", text)
        self.assertIn("slerp </docs/families/slerp>", text)

    def test_a_link_to_what_is_not_listed_or_not_there_is_an_error(self):
        (self.root / "docs/second.md").write_text("# Second\n", "utf-8")
        for target, wanted in (("second.md", "a page that docs/index.md lists"), ("gone.md", "a file of the repository")):
            (self.root / "docs/first.md").write_text(f"# First\n\n[b]({target})\n", "utf-8")
            with self.assertRaisesRegex(markup.Fault, f"docs/first.md: found a link to {target}, wanted {wanted}"):
                self.written()

    def test_code_is_left_as_it_is(self):
        text = "[a](b.md)\n```sh\n[a](b.md)\n```\n"
        self.assertEqual(markup.with_targets(text, str.upper), "[a](B.MD)\n```sh\n[a](b.md)\n```\n")

    def test_a_header_is_told_with_the_nearest_that_includes_it(self):
        include = self.root / "include/orispline"
        for name, text in {"all.hpp": "#include <orispline/part.hpp>\n#include <orispline/deep/a.hpp>\n", "part.hpp": "#include <orispline/deep/b.hpp>\n",
                           "deep/a.hpp": "#include <orispline/deep/b.hpp>\n", "deep/b.hpp": "#include <vector>\n"}.items():
            (include / name).parent.mkdir(parents=True, exist_ok=True)
            (include / name).write_text(text, "utf-8")
        where = headers.page_of_each(self.root / "include", ["all.hpp", "part.hpp"])
        self.assertEqual((where["orispline/deep/a.hpp"], where["orispline/deep/b.hpp"]), ("all.hpp", "part.hpp"))

    def test_without_its_tools_there_is_no_site_but_a_sentence(self):
        with self.assertRaisesRegex(make.Missing, r"found no .*, wanted .*"):
            make.check_tools(self.root / "bin/python")


HEADER = """#pragma once
#define ORISPLINE_EXPORT
namespace orispline { inline namespace ORISPLINE_ABI {

/// How to go on, in `steps`.
enum class Way {
  left,   ///< to the left
  right,  ///< to the right
};

/// A body that turns.
class ORISPLINE_EXPORT Body {
 public:
  /// Turns by an angle [rad], as Way says.
  [[nodiscard]] bool turn(double angle, Way way = Way::left) const noexcept;

 private:
  double angle_ = 0.0;
};

/// Turns a Body.
template <class T>
T turned(const Body& body, T by);
/// Two of them at once.
double turned(const Body& first, const Body& second);

using Bodies = Body*;

}}  // namespace orispline
"""
PAGE = """# all.hpp

```cpp
#include <orispline/all.hpp>
```

All.

## `Way`

```cpp
enum class Way;
```

How to go on, in `steps`.

`Way::left`
: to the left

`Way::right`
: to the right

(cpp-orispline-body)=

## `Body`

```cpp
class Body;
```

A body that turns.

`bool turn(double angle, Way way = Way::left) const noexcept`
: Turns by an angle \\[rad\\], as Way says.

## `turned()`

```cpp
template <class T>
T turned(const Body& body, T by);
double turned(const Body& first, const Body& second);
```

Turns a [Body](#cpp-orispline-body).

Two of them at once.

## `Bodies`

```cpp
using Bodies = Body*;
```
"""


@unittest.skipUnless(shutil.which("doxygen"), "Doxygen is not here")
class Headers(unittest.TestCase):
    def test_a_header_is_a_page_in_its_own_order(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "include/orispline").mkdir(parents=True)
            (folder / "include/orispline/all.hpp").write_text(HEADER, "utf-8")
            make.write_headers(folder / "include", folder, folder / "source", {"all.hpp": "All."})
            self.assertEqual((folder / "source/cpp/all.hpp.md").read_text("utf-8"), PAGE)


class Index(unittest.TestCase):
    def test_every_page_is_in_the_side_bar(self):
        repository = pages.Pages(ROOT)
        absent = {path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").rglob("*.md")} - repository.all
        self.assertEqual(absent, set(), "wanted a row of docs/index.md")

    def test_pages_are_plain_markdown(self):
        for path in (ROOT / "docs").rglob("*.md"):
            self.assertIsNone(re.search(r"^(```|:::+)\{|^\(\w+\)=$", path.read_text("utf-8"), re.M), path.name)

    def test_what_is_searched_for_is_on_a_page(self):
        self.assertTrue(any("gimbal lock" in path.read_text("utf-8") for path in (ROOT / "docs").rglob("*.md")))


if __name__ == "__main__":
    unittest.main()
