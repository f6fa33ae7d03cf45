#!/usr/bin/env python3
"""Every link of every page leads somewhere: to a file of the project, and to a heading if it names one.

    links.py        one line for each link that does not; exit 1 if there is one
"""
import os
import pathlib
import re
import sys

import tidy

LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")


def anchors(text):
    """What a link can name of a page: its headings, as both GitHub and mkdocs spell them."""
    found = set()
    for heading in re.findall(r"^#+ +(.*?)\s*$", FENCE.sub("", text), re.MULTILINE):
        words = re.sub(r"[^\w\s-]", "", LINK.sub("", heading).strip().lower())
        found.add(re.sub(r"\s+", "-", words.strip()))
    return found


def links(text):
    """The line and the target of each link that stands outside code."""
    blank = FENCE.sub(lambda match: "\n" * match[0].count("\n"), text)
    for number, line in enumerate(CODE.sub("", blank).split("\n"), 1):
        for target in LINK.findall(line):
            yield number, target


def faults(root):
    """One line for each link that leads nowhere."""
    found = []
    for path in tidy.files(root):
        if not path.endswith(".md"):
            continue
        text = pathlib.Path(root, path).read_text(encoding="utf-8")
        for number, target in links(text):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            file = pathlib.Path(root, path).parent / name if name else pathlib.Path(root, path)
            if not file.exists():
                found.append(f"{path}:{number}: there is no '{name}'")
            elif anchor and anchor not in anchors(file.read_text(encoding="utf-8")):
                found.append(f"{path}:{number}: '{name or path}' has no heading '#{anchor}'")
            elif path.startswith("docs/") and not any(file.resolve().is_relative_to(pathlib.Path(root, part).resolve())
                                                      for part in ("docs", "hunt/pages")):
                found.append(f"{path}:{number}: '{name}' is not part of the site; write its path as code")
    return found


def main():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    found = faults(root)
    print("\n".join(found + [f"links: {len(found)} lead nowhere"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
