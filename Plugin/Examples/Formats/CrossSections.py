# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two text formats of the literature on surfaces from planar cross-sections.

.contour (Liu, Bajaj, Deasy, Low and Ju, "Surface Reconstruction From Non-parallel Curve Networks",
2008): the number of planes; for each plane its parameters a b c d (a x + b y + c z + d = 0), the
numbers of vertices and edges, the vertices (x y z) and the edges: two vertices, from 0, and the
materials on the left and on the right of the edge. Material 0 is outside.

.csl (Bermano, Vaxman and Gotsman, "Online Reconstruction of 3D Objects from Arbitrary
Cross-Sections", 2011): the word CSLC; the numbers of planes and labels; for each plane its number,
the numbers of vertices and components, and its parameters; its vertices; and its components: the
number of vertices, the label, and the vertices, from 0. A hole has an h, and the component around
it, behind its number of vertices ("10h0"). Label 0 is outside.

Each material or label becomes a structure. Where two materials meet, the border belongs to both.
"""

from .Structures import FormatError, Structure


class Numbers:
    """The words of a file one after another, for a message that says where they end or fail."""

    def __init__(self, path):
        self.path = path
        with open(path, encoding="utf-8") as file:
            self.words = [word for line in file for word in line.partition("#")[0].split()]
        self.next = 0

    def word(self):
        if self.next >= len(self.words):
            raise FormatError(f"{self.path} ends too early, after {self.next} numbers.")
        self.next += 1
        return self.words[self.next - 1]

    def peek(self):
        return self.words[self.next] if self.next < len(self.words) else ""

    def number(self, kind):
        word = self.word()
        try:
            return kind(word)
        except ValueError:
            raise FormatError(f"{self.path} has {word!r} where a number should be.") from None

    def integers(self, count):
        return [self.number(int) for _ in range(count)]

    def points(self, count):
        return [[self.number(float) for _ in range(3)] for _ in range(count)]


def vertex(points, index, path):
    if not 0 <= index < len(points):
        raise FormatError(f"{path} names vertex {index} of a plane with {len(points)} vertices.")
    return points[index]


def named(structures, label):
    return structures.setdefault(label, Structure(f"label {label}", label))


def read_contour(path):
    numbers = Numbers(path)
    structures = {}
    for _ in range(numbers.number(int)):
        for _ in range(4):
            numbers.number(float)
        vertices, edges = numbers.integers(2)
        points = numbers.points(vertices)
        borders = {}
        for _ in range(edges):
            start, end, left, right = numbers.integers(4)
            vertex(points, start, path), vertex(points, end, path)
            if left == right:
                continue
            borders.setdefault(left, []).append((start, end))
            borders.setdefault(right, []).append((end, start))
        for label, pieces in sorted(borders.items()):
            if label > 0:
                for chain in chained(pieces):
                    named(structures, label).add([points[i] for i in chain], closed=False)
    return [structures[label] for label in sorted(structures)]


def chained(pieces):
    """Directed edges joined end to start: chains of vertices; a closed one ends with its first."""
    following = {}
    for start, end in pieces:
        following.setdefault(start, []).append(end)
    ends = {end for _, end in pieces}
    chains = []
    # Open chains first: a start that no edge leads to. What is left then is closed.
    for first in sorted(following, key=lambda start: start in ends):
        while following.get(first):
            chain = [first]
            while following.get(chain[-1]):
                chain.append(following[chain[-1]].pop())
                if chain[-1] == first:
                    break
            chains.append(chain)
    return chains


def read_csl(path):
    numbers = Numbers(path)
    if numbers.word() != "CSLC":
        raise FormatError(f"{path} does not begin with the word CSLC.")
    planes, _ = numbers.integers(2)
    structures = {}
    for _ in range(planes):
        _, vertices, components = numbers.integers(3)
        for _ in range(4):
            numbers.number(float)
        points = numbers.points(vertices)
        for _ in range(components):
            count, label = component_head(numbers)
            loop = [vertex(points, index, path) for index in numbers.integers(count)]
            if label > 0:
                named(structures, label).add(loop)
    return [structures[label] for label in sorted(structures)]


def component_head(numbers):
    """Number of vertices and label of a component, of which a hole may have "h" and a number."""
    count, hole, around = numbers.word().partition("h")
    if not hole and numbers.peek().startswith("h"):
        hole, around = "h", numbers.word()[1:]
    if not count.isdigit() or (around and not around.lstrip("-").isdigit()):
        raise FormatError(f"{numbers.path} has {count + hole + around!r} where a component starts.")
    label = numbers.number(int)
    if numbers.peek().startswith("h"):
        numbers.word()
    return int(count), label
