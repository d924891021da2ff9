# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestLinks.py [repository]

Fails if a page of the repository (*.md) names something that is not there:

  * a relative link to a file or folder that does not exist, or to a heading that its page has not;
  * a file named in `code` or in a block of commands: a path, a file of some room (Graph/EmbedArcs
    stands for header and source), or a program of a build folder (build/vtk/bin/NAME needs a
    NAME.cxx).

Names with placeholders (*, <>, {}, %, $) and what commands write (build/...) are left alone.
"""

import os
import re
import sys

EXTENSIONS = ("h", "cxx", "txx", "md", "py", "sh", "xml", "json", "cff", "vtp", "png", "txt", "plugin",
              "module")
# Where a name may start, besides the folder of its page.
ROOTS = ("", "Filters", "Filters/Core", "Testing", "Testing/Core", "Plugin", "Data")
LEFT_OUT = {".git", "build"}

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
PLACEHOLDER = re.compile(r"[*<>{}%$]|\.\.\.")
PROGRAM = re.compile(r"^build/[^/]+/bin/(\w+)$")


def list_files(top):
    files = []
    for folder, folders, names in os.walk(top):
        folders[:] = sorted(name for name in folders if name not in LEFT_OUT)
        files += [os.path.relpath(os.path.join(folder, name), top) for name in names]
    return sorted(files)


def split_blocks(text):
    """The text without blocks of code, line by line, and the lines of those blocks."""
    prose, blocks, fence = [], [], None
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fence = None if fence is not None else line.strip("` ")
            prose.append("")
        elif fence is None:
            prose.append(line)
        else:
            blocks.append((fence, line))
            prose.append("")
    return prose, blocks


def anchors(text):
    """The anchors that GitHub gives to the headings of a page."""
    found, counts = set(), {}
    for line in split_blocks(text)[0]:
        match = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if match:
            title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", match[1])
            slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
            number = counts.get(slug, 0)
            counts[slug] = number + 1
            found.add(f"{slug}-{number}" if number else slug)
    return found


class Checker:
    def __init__(self, top):
        self.top = top
        self.files = list_files(top)
        self.stems = {os.path.splitext(name)[0] for name in self.files}
        self.names = {os.path.basename(name) for name in self.files}
        self.problems = []

    def read(self, name):
        with open(os.path.join(self.top, name), encoding="utf-8") as file:
            return file.read()

    def exists(self, path):
        return os.path.exists(os.path.join(self.top, path))

    def check_link(self, page, target):
        if re.match(r"[a-z]+:", target):
            return True
        path, _, anchor = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not self.exists(path):
            return False
        if not anchor:
            return True
        return path.endswith(".md") and anchor in anchors(self.read(path))

    def is_named(self, page, name):
        """Whether there is what a word of code names, or it names no file."""
        name = name.rstrip("/.,;:")
        if PLACEHOLDER.search(name) or name.startswith(("-", "/", "~")):
            return True
        program = PROGRAM.match(name)
        if program:
            return program[1] + ".cxx" in self.names
        if name.startswith(("build/", "http:", "https:")):
            return True
        has_extension = name.rpartition(".")[2] in EXTENSIONS and "." in name
        if "/" not in name:
            return not has_extension or name in self.names
        known_folder = name.split("/")[0] in self.folders(page)
        if not has_extension and not known_folder:
            return True  # a fraction, a choice, a path elsewhere
        starts = (os.path.dirname(page),) + ROOTS
        paths = [os.path.normpath(os.path.join(start, name)) for start in starts]
        return any(self.exists(path) or path in self.stems for path in paths)

    def folders(self, page):
        found = set()
        for start in (os.path.dirname(page),) + ROOTS:
            folder = os.path.join(self.top, start)
            if os.path.isdir(folder):
                found.update(entry.name for entry in os.scandir(folder) if entry.is_dir())
        return found - LEFT_OUT

    def check_page(self, page):
        prose, blocks = split_blocks(self.read(page))
        for number, line in enumerate(prose, 1):
            for target in LINK.findall(CODE.sub("", line)) + [
                    match for match in LINK.findall(line)]:
                if not self.check_link(page, target):
                    self.problems.append(f"{page}:{number}: broken link {target}")
            for span in CODE.findall(line):
                self.check_words(page, number, span)
        for language, line in blocks:
            if language in ("sh", "bash"):
                self.check_words(page, "commands", line.partition("#")[0])

    def check_words(self, page, number, text):
        # Arguments after a program of a build folder may be files that it writes.
        after_output = False
        for word in text.split():
            if not after_output and not self.is_named(page, word.strip("\"'`()[],=;")):
                self.problems.append(f"{page}:{number}: there is no {word}")
            after_output = word in (">", "--csv", "--picture", "--surfaces", "--output")

    def run(self):
        pages = [name for name in self.files if name.endswith(".md")]
        for page in pages:
            self.check_page(page)
        for problem in sorted(set(self.problems)):
            print(problem)
        print(f"{len(pages)} pages, {len(set(self.problems))} names of what is not there")
        return 1 if self.problems else 0


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    sys.exit(Checker(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(here)).run())
