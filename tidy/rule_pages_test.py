#!/usr/bin/env python3
"""rule_pages.py notices what is wrong with a page, the table is read as the compiler reads it, and the menu has the pages."""
import importlib.util
import pathlib
import tempfile
import types
import unittest

import rule_pages
import rules

RULE = next(one for one in rules.of_meshes() if one.identifier == "complex.overlap")
BREACH = next(one for one in rules.of_domains() if one.identifier == "plc.polygons-cross")


def page(entry):
    return (rule_pages.FOLDER / f"{entry.identifier}.md").read_text(encoding="utf-8")


class Pages(unittest.TestCase):
    def faults(self, entry, was="", becomes=""):
        self.assertIn(was, page(entry))
        return list(rule_pages.faults_of_text(entry, page(entry).replace(was, becomes) if was else page(entry)))

    def test_pages_that_are_right(self):
        for entry in (RULE, BREACH):
            self.assertEqual(self.faults(entry), [])

    def test_another_number(self):
        self.assertRegex(self.faults(RULE, "Rule 8,", "Rule 9,")[0], "expected the heading .*Rule 8, judged")
        self.assertRegex(self.faults(BREACH, "Breach 10 ", "Breach 11 ")[0], "Breach 10 of Definition 4.3")
        self.assertRegex(self.faults(RULE, "# complex.overlap", "# complex.overlaps")[0], "heading")

    def test_a_section_that_is_missing_or_empty(self):
        self.assertRegex(self.faults(RULE, "## How to mend it\n", "")[0], "expected the sections")
        emptied = page(BREACH)[:page(BREACH).index("## What stands behind it")] + "## What stands behind it\n"
        self.assertIn("a section is empty", list(rule_pages.faults_of_text(BREACH, emptied)))

    def test_a_link_an_image_and_an_example(self):
        self.assertRegex(self.faults(RULE, "theory/points.md#the-conditions", "check.md")[0], "expected a link to theory/points.md")
        self.assertRegex(self.faults(RULE, "../images/rules/complex.overlap.svg", "none.svg")[0], "expected the image")
        self.assertRegex(self.faults(RULE, "$ circumspect", "$ other")[0], "expected an example")

    def test_a_file_and_an_option_that_are_not_there(self):
        self.assertRegex(self.faults(RULE, "t-junction-2d.ele`", "t-junction.ele`")[0], "a file of the corpus, found corpus/reject/")
        self.assertRegex(self.faults(RULE, "`-q`", "`--quick`")[0], "an option of the command, found --quick")

    def test_a_rule_that_no_property_names(self):
        self.assertEqual(list(rule_pages.faults_of_property(RULE, "{Rule::kHangingVertex, Rule::kOverlap}")), [])
        self.assertRegex(list(rule_pages.faults_of_property(RULE, "Rule::kOverlapping"))[0], "requires Rule::kOverlap to come up")
        self.assertEqual(list(rule_pages.faults_of_property(BREACH, "")), [])

    def test_too_long_and_too_short(self):
        self.assertRegex(self.faults(RULE, "## How to mend it\n", "## How to mend it\n" + "\nMore.\n" * 20)[0], "expected 20 to 45 lines")


class Table(unittest.TestCase):
    def rows(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "a.def").write_text(text, encoding="utf-8")
            return rules.rows("a.def", "BREACH", rules.Breach, root)

    def test_commas_quotes_and_parentheses_in_a_text(self):
        self.assertEqual(self.rows('BREACH(7, kSome, "plc.some",\n       "one, (two)",\n       "a \\"b\\"")\n'),
                         [rules.Breach(7, "kSome", "plc.some", "one, (two)", 'a "b"')])

    def test_a_column_too_few(self):
        with self.assertRaisesRegex(ValueError, "expected 5 columns in the row of 7, found 4"):
            self.rows('BREACH(7, kSome, "plc.some", "one")\n')

    def test_a_comment_is_no_row(self):
        self.assertEqual(self.rows("// BREACH(number, name)\n"), [])


def site_of_docs():
    """tidy/site.py, by its path: the standard library has a `site` too."""
    spec = importlib.util.spec_from_file_location("site_of_docs", pathlib.Path(rule_pages.__file__).parent / "site.py")
    site = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(site)
    return site


class Site(unittest.TestCase):
    def test_a_picture_to_turn_stands_below_the_image_of_a_rule(self):
        site = site_of_docs()
        page = types.SimpleNamespace(file=types.SimpleNamespace(src_path="rules/complex.overlap.md"))
        image = '<p><img alt="a" src="../images/rules/complex.overlap.svg" /></p>'
        content = site.on_page_content(f"<h1>a</h1>{image}<p>b</p>", page=page)
        self.assertIn(f'{image}<details class="seen"', content)
        self.assertIn('data-src="../pictures/complex.overlap.html"', content)
        self.assertEqual(site.PLACED, {"complex.overlap"})
        self.assertEqual(site.of_rules()["complex.overlap"], ["check", "corpus/reject/complex.overlap--2d.ele"])

    def test_the_pages_stand_behind_their_overview(self):
        menu = site_of_docs().rules_in_menu([{"Reference": [{"Rules": ["rules.md"]}, {"Other": "other.md"}]}])
        inside = menu[0]["Reference"][0]["Rules"]
        self.assertEqual(inside[0], "rules.md")
        names = [next(iter(one)) for one in inside[1:]]
        self.assertEqual(set(names), {entry.identifier for entry in rules.of_meshes() + rules.of_domains()})
        self.assertTrue(names[-1].startswith("plc."))
        self.assertEqual(menu[0]["Reference"][1], {"Other": "other.md"})


if __name__ == "__main__":
    unittest.main()
