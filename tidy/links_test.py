#!/usr/bin/env python3
"""Links that lead nowhere are found, and no others."""

import os
import tempfile
import unittest

import links

PAGES = {
    "README.md": "See [the page](docs/page.md#a-heading-of-2-words).\n",
    "docs/page.md": "# Page\n\n## A heading, of `2` words\n\n[up](#page) [there](https://example.org/x)\n",
}


def faults(name, text):
    """What is found in two good pages and this one."""
    with tempfile.TemporaryDirectory() as root:
        for path, content in {**PAGES, name: text}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(content)
        return links.faults(root)


class Links(unittest.TestCase):
    def test_good_links_are_good(self):
        self.assertEqual(faults("docs/other.md", "[page](page.md)\n"), [])

    def test_a_file_that_is_not_there(self):
        self.assertEqual(faults("CONTRIBUTING.md", "\n[page](docs/pages.md)\n"),
                         ["CONTRIBUTING.md:2: there is no 'docs/pages.md'"])

    def test_a_heading_that_is_not_there(self):
        self.assertEqual(faults("docs/other.md", "[page](page.md#heading)\n"),
                         ["docs/other.md:1: 'page.md' has no heading '#heading'"])

    def test_the_site_has_no_other_files(self):
        self.assertEqual(faults("docs/other.md", "[root](../README.md)\n"),
                         ["docs/other.md:1: '../README.md' is not part of the site; write its path as code"])

    def test_code_has_no_links(self):
        self.assertEqual(faults("docs/other.md", "`[a](b)`\n\n```\n[a](b)\n```\n[a](c)\n"),
                         ["docs/other.md:6: there is no 'c'"])


if __name__ == "__main__":
    unittest.main()
