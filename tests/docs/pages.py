# SPDX-License-Identifier: BSD-3-Clause
"""What the pages of the documentation hold: links, headings and blocks of code."""
import re
import textwrap
from dataclasses import dataclass

LINK = re.compile(r"(!?)\[([^][]*)\]\(([^() ]*)\)")
FENCE = re.compile(r"^ *```(.*)$")


@dataclass
class Link:
    line: int
    isPicture: bool
    target: str


@dataclass
class Block:
    line: int
    kind: str  # first word behind ```
    needs: str  # NAME of needs=NAME, else empty
    text: str


def allPages(top):
    """Every page, the first one first."""
    first = [top / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md",
                                     "share/benchmark/README.md")]
    return first + sorted((top / "docs").rglob("*.md"))


class Page:
    """A page, read once."""

    def __init__(self, file):
        self.file = file
        self.blocks = []
        self.prose = []  # (number of the line, line), code left out
        self._read(file.read_text(encoding="utf-8").splitlines())

    def _read(self, lines):
        self.length = len(lines)
        block = None
        for number, line in enumerate(lines, 1):
            fence = FENCE.match(line)
            if fence and block is None:
                words = fence.group(1).split()
                needs = [w[len("needs="):] for w in words[1:] if w.startswith("needs=")]
                block = Block(number, words[0] if words else "", needs[0] if needs else "", "")
            elif fence:
                block.text = textwrap.dedent(block.text)
                self.blocks.append(block)
                block = None
            elif block is not None:
                block.text += line + "\n"
            else:
                self.prose.append((number, re.sub(r"`[^`]*`", "``", line)))
        self.isOpen = block is not None

    def links(self):
        for number, line in self.prose:
            for found in LINK.finditer(line):
                yield Link(number, found.group(1) == "!", found.group(3))

    def children(self):
        """Targets of the list items that begin with a link: branches of the navigation tree."""
        for _, line in self.prose:
            found = re.match(r"- \[[^][]*\]\(([^() ]*)\)", line)
            if found:
                yield found.group(1)

    def anchors(self):
        """Those a git host gives the headings: of equal ones the later ones get a number."""
        seen, anchors = {}, set()
        for number, line in enumerate(self.file.read_text(encoding="utf-8").splitlines(), 1):
            heading = re.match(r"#+ (.*)", line)
            if not heading or number not in {n for n, _ in self.prose}:
                continue
            slug = re.sub(r"[^\w\- ]", "", heading.group(1).lower()).replace(" ", "-")
            times = seen.get(slug, 0)
            seen[slug] = times + 1
            anchors.add(f"{slug}-{times}" if times else slug)
        return anchors
