#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages and comments name what is there: links, files, programs and identifiers.

TestLinks.py ROOT          checks the repository in ROOT, prints what is wrong, ends with 1 if anything
TestLinks.py --self-test   checks pages made up for the purpose, right and wrong ones

Wrong are, in all *.md,
  * a relative link to a file or folder that there is not, or to a heading that its page has not;
  * in `code` and in blocks of commands, a path or a file that there is not (Graph/EmbedArcs, a name
    in a room, stands for header and source), and a program of a build folder (build/vtk/bin/NAME)
    without a source of its name;
  * in `code`, a name LikeThis or ORTHOGONAL_LIKE_THIS that no source has;
and in sources of C++, shell, CMake and XML a path of the project (Core/Graph/NodeGraph.h) that there
is not.

Names with placeholders (*, <>, {}, %, $), hidden files and what commands write are left alone.
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

SOURCES = {".h", ".cxx", ".txx", ".py", ".sh", ".xml", ".txt", ".json", ".plugin", ".module"}
EXTENSIONS = SOURCES | {".md", ".cff", ".vtp", ".png"}
# Folders in which names may start, besides that of the page.
STARTS = ("", "Filters", "Filters/Core", "Testing", "Testing/Core", "Plugin")
LEFT_OUT = {".git", "build"}

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
PLACEHOLDER = re.compile(r"[*<>{}%$]|\.\.\.")
PROGRAM = re.compile(r"build/[^/]+/bin/(\w+)$")
# A path of the project in a comment, and the sources in which it is looked for.
MENTION = re.compile(
    r"(?<![\w/.}>-])(?:Core|Bridge|Filters|Testing|Plugin|Support)/[\w/]+\.(?:h|cxx|txx|md|py|sh)\b")
MENTIONING = {".h", ".cxx", ".txx", ".xml", ".sh", ".txt"}
IDENTIFIER = re.compile(r"(?:vtk)?(?:[A-Z][a-z0-9]+){2,}(?:::\w+)*$|ORTHOGONAL_\w+$")


def split_blocks(text):
    """Numbered lines outside of blocks of code, and those inside of blocks of commands."""
    prose, commands, language = [], [], None
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            language = line.strip("` ") or "text" if language is None else None
        elif language is None:
            prose.append((number, line))
        elif language in ("sh", "bash"):
            commands.append((number, line.partition("#")[0]))
    return prose, commands


def anchors(text):
    """What a link may name in a page: the headings as GitHub writes them."""
    found = set()
    for _, line in split_blocks(text)[0]:
        heading = re.match(r"#{1,6}\s+(.*?)\s*$", line)
        if heading:
            title = LINK.sub(lambda link: link[0][1:link[0].index("]")], heading[1])
            found.add(re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-"))
    return found


class Checker:
    """Reads a repository and lists what its pages name wrongly."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = set()
        for folder, folders, names in os.walk(self.root):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
            self.files.update((pathlib.Path(folder) / name).relative_to(self.root).as_posix()
                              for name in names)
        self.stems = {os.path.splitext(name)[0] for name in self.files}
        self.names = {name.rpartition("/")[2] for name in self.files}
        self.words = {stem.rpartition("/")[2] for stem in self.stems}
        for name in self.files:
            if os.path.splitext(name)[1] in SOURCES:
                self.words.update(re.findall(r"\w+", self.read(name)))

    def read(self, name):
        return (self.root / name).read_text(encoding="utf-8", errors="replace")

    def complaints(self):
        return self.complaints_of_pages() + self.complaints_of_sources()

    def complaints_of_sources(self):
        found = []
        for source in sorted(self.files):
            if os.path.splitext(source)[1] not in MENTIONING:
                continue
            for number, line in enumerate(self.read(source).splitlines(), 1):
                found += [f"{source}:{number}: there is no {path}" for path in MENTION.findall(line)
                          if not any(f"{start}/{path}".lstrip("/") in self.files for start in STARTS)]
        return found

    def complaints_of_pages(self):
        found = []
        for page in sorted(name for name in self.files if name.endswith(".md")):
            prose, commands = split_blocks(self.read(page))
            written = set()
            for number, line in prose:
                found += [f"{page}:{number}: broken link {target}" for target in LINK.findall(line)
                          if not self.leads_somewhere(page, target)]
                for code in CODE.findall(line):
                    found += [f"{page}:{number}: there is no {word}" for word in code.split()
                              if not (self.is_known(code, word) and self.is_there(page, word))]
            for number, line in commands:
                written.update(re.findall(r">\s*(\S+)", line))
                found += [f"{page}:{number}: there is no {word}" for word in line.split()
                          if word not in written and not self.is_there(page, word)]
        return found

    def leads_somewhere(self, page, target):
        if re.match(r"[a-z]+:", target):
            return True
        path, _, anchor = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not (self.root / path).exists():
            return False
        return not anchor or path.endswith(".md") and anchor in anchors(self.read(path))

    def is_known(self, code, word):
        """Whether the sources have an identifier; of code of several words, each may be anything."""
        if code != word or not IDENTIFIER.match(word):
            return True
        return all(part in self.words for part in word.split("::"))

    def is_there(self, page, word):
        """Whether there is the file that a word names, if it names one."""
        name = word.strip("\"'`()[],=;:").rstrip("/.")
        if PLACEHOLDER.search(name) or name.startswith((".", "-", "/", "~")):
            return True
        program = PROGRAM.match(name)
        if program:
            return f"{program[1]}.cxx" in self.names
        if name.startswith("build/") or ":" in name:
            return True
        extension = os.path.splitext(name)[1]
        if "/" not in name:
            return extension not in EXTENSIONS or name in self.names
        starts = [os.path.dirname(page), *STARTS]
        if extension not in EXTENSIONS and (extension or not self.is_folder(starts, name)):
            return True  # a fraction, a choice, a path elsewhere
        paths = [os.path.normpath(os.path.join(start, name)) for start in starts]
        return any((self.root / path).exists() or path in self.stems for path in paths)

    def is_folder(self, starts, name):
        """Whether a name begins with a folder of the repository."""
        first = name.partition("/")[0]
        return any((self.root / start / first).is_dir() for start in starts)


class SelfTest(unittest.TestCase):
    """What is wrong in made-up pages is found, and what is right is not complained of."""

    FILES = {
        "README.md": "# Title\n## Two words, one `code`\n",
        "Filters/Core/README.md": "# Method\n",
        "Filters/Core/Graph/EmbedArcs.h": "void EmbedArcs(); // ORTHOGONAL_CHECK\n",
        "Testing/Compare.cxx": "int main() { return SmoothAll::Two; }\n",
    }
    RIGHT = (
        "[a](../../README.md) [b](../../README.md#two-words-one-code) [c](#method) [d](Graph)",
        "[e](https://example.org/none) ![f](../../README.md)",
        "`Graph/EmbedArcs` `Core/Graph/EmbedArcs.h` `EmbedArcs.h` `EmbedArcs` `Testing/Compare.cxx`",
        "`SmoothAll::Two` `ORTHOGONAL_CHECK` `build/vtk/bin/Compare` `build/vtk` `Test*.cxx` `1/2`",
        "`.hidden` `any/thing` `d38bd26/seg.nrrd` `-DNAME=Value`",
        "```sh\nbash Testing/Compare.cxx > a.txt # none.txt\ndiff a.txt\n```",
        "```cpp\nNone::Such none.h\n```",
    )
    WRONG = (
        ("[a](none.md)", "broken link none.md"),
        ("[a](../../README.md#none)", "broken link ../../README.md#none"),
        ("[a](#none)", "broken link #none"),
        ("`Graph/NodeGraph`", "there is no Graph/NodeGraph"),
        ("`NodeGraph.h`", "there is no NodeGraph.h"),
        ("`SmoothAll::Three`", "there is no SmoothAll::Three"),
        ("`NoSuchName`", "there is no NoSuchName"),
        ("`ORTHOGONAL_NONE`", "there is no ORTHOGONAL_NONE"),
        ("`build/vtk/bin/None --all`", "there is no build/vtk/bin/None"),
        ("```sh\nbash Testing/none.sh\n```", "there is no Testing/none.sh"),
    )

    def complaints_with(self, text, files=None):
        """Complaints if one of the pages also has this text, and there are these files, too."""
        with tempfile.TemporaryDirectory() as root:
            for name, content in {**self.FILES, **(files or {})}.items():
                path = pathlib.Path(root) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(content, encoding="utf-8")
            page = pathlib.Path(root) / "Filters/Core/README.md"
            page.write_text(page.read_text(encoding="utf-8") + text + "\n", encoding="utf-8")
            return Checker(root).complaints()

    def test_what_is_right(self):
        for text in self.RIGHT:
            self.assertEqual(self.complaints_with(text), [], text)

    def test_what_is_wrong(self):
        for text, complaint in self.WRONG:
            found = self.complaints_with(text)
            self.assertEqual(len(found), 1, text)
            self.assertTrue(found[0].endswith(complaint), found[0])

    def test_what_sources_mention(self):
        name = "Filters/Core/Reconstruct.h"
        self.assertEqual(self.complaints_with("", {name: "// See Core/Graph/EmbedArcs.h.\n"}), [])
        self.assertEqual(self.complaints_with("", {name: "// See Core/EmbedArcs.h.\n"}),
            [f"{name}:1: there is no Core/EmbedArcs.h"])


def main(arguments):
    if arguments == ["--self-test"]:
        return unittest.main(argv=["TestLinks.py"], exit=False).result.wasSuccessful()
    if len(arguments) != 1:
        sys.exit(__doc__)
    found = Checker(arguments[0]).complaints()
    for complaint in found:
        print(complaint)
    print(f"{len(found)} complaints")
    return not found


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1:]) else 1)
