#!/usr/bin/env python3
"""Follows docs/how-to-add.md word for word: makes the changes of its examples in a copy of the project.

    how_to_add_test.py                    the changes fit, and what can be said without a compiler is right
    how_to_add_test.py --build CACHE      also builds the copy, runs the commands of the page and the tests of what was added;
                                          CACHE: the CMakeCache.txt of a build, whose compilers and options are taken

A block of the page that begins with "# PATH" is a change of that file: lines with + are added and lines with - removed at the
one place where the others stand.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import links
import tidy

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = (ROOT / "docs" / "how-to-add.md").read_text(encoding="utf-8")
RULE, FAMILY, ENDING = "triangulation.index-of-none", "axes", ".neutral"
# The issue of a stranger: how many files have to be found and changed by hand.
MOST_PLACES = {"A rule": 9, "A format": 5, "A family of inputs": 4}
# What is built, and the names of the tests in it.
TESTS = {"A rule": (["judge_points_test", "picture_test", "corpus_test", "properties"],
                    "^(oracle/judge/points|oracle/picture)/[a-z]+_test$|^corpus/corpus_test$|^properties/periodic_property$"),
         "A format": (["formats_test"], "^oracle/formats/[a-z_]+_test$"),
         "A family of inputs": (["inputs_test"], "^inputs/[a-z]+_test$")}
CACHED = re.compile(r"^((?:CMAKE_(?:CXX_COMPILER|CXX_COMPILER_LAUNCHER|BUILD_TYPE)|CIRCUMSPECT_QUICK_BUILD):\w+=.*)$", re.MULTILINE)


def section(title):
    return re.search(rf"^## {title}$(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL)[1]


def changes(text):
    """The file and the lines of each change of a section, in their order."""
    for block in re.findall(r"^```diff\n# (\S+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield block[0], block[1].splitlines()


def change(root, path, lines):
    """Makes one change. ValueError if there is no such place, or more than one."""
    file = root / path
    before = [line[1:] for line in lines if line[:1] != "+"]
    after = [line[1:] for line in lines if line[:1] != "-"]
    if not before:
        if file.exists():
            raise ValueError(f"{path}: expected a new file, found one")
        file.write_text("\n".join(after) + "\n", encoding="utf-8")
        return
    text = file.read_text(encoding="utf-8")
    old, new = ("".join(f"{line}\n" for line in some) for some in (before, after))
    places = text.count("\n" + old)
    if places != 1:
        raise ValueError(f"{path}: expected one place for the change at {before[0]!r}, found {places}")
    file.write_text(text.replace("\n" + old, "\n" + new), encoding="utf-8")


def copied(root):
    """A copy of the project, without what was built; of an older copy only that stays."""
    for old in root.glob("*"):
        if old.is_dir() and old.name != "build":
            shutil.rmtree(old)
    for path in tidy.files(str(ROOT)):
        if path.startswith("docs/images/"):
            continue
        target = root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / path, target)


def run(root, *words):
    done = subprocess.run(words, cwd=root, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(words)}: exit code {done.returncode}\n{(done.stdout + done.stderr)[-4000:]}")
    return done.stdout


class Followed(unittest.TestCase):
    """What the page says, done."""
    place = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = cls.place or pathlib.Path(cls.folder.name)
        copied(cls.root)
        cls.golden = cls.golden_rows()
        for title in MOST_PLACES:
            for path, lines in changes(section(title)):
                change(cls.root, path, lines)

    @classmethod
    def golden_rows(cls):
        return (cls.root / "corpus/golden.tsv").read_text(encoding="utf-8").splitlines()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_no_more_places_than_the_page_says(self):
        for title, most in MOST_PLACES.items():
            with self.subTest(title):
                places = {path for path, _ in changes(section(title))}
                self.assertEqual(len(places), most, sorted(places))

    def test_a_change_has_one_place(self):
        with self.assertRaisesRegex(ValueError, "found 0"):
            change(self.root, "oracle/model/rules.def", ["+x", " there is no such line"])
        with self.assertRaisesRegex(ValueError, "found [^01]"):
            change(self.root, "oracle/model/rules.def", ["+x", '      "")'])
        with self.assertRaisesRegex(ValueError, "new file"):
            change(self.root, "oracle/model/rules.def", ["+x"])

    def test_numbers_of_rules_stay(self):
        sys.path.insert(0, str(self.root / "tidy"))
        import rules
        before = {one.identifier: one.number for one in rules.of_meshes(ROOT)}
        after = {one.identifier: one.number for one in rules.of_meshes(self.root)}
        self.assertEqual(after.pop(RULE), max(before.values()) + 1)
        self.assertEqual(after, before)
        self.assertEqual(rules.of_meshes(self.root)[0].identifier, RULE, "it is to stand first, not where numbers go on")

    def test_the_copy_has_its_style_its_links_and_its_proofs(self):
        run(self.root, "python3", "corpus/make/make.py")
        self.assertIn(f"reject/{RULE}.ele\tdelaunay\t{RULE}\n", (self.root / "corpus/expected.tsv").read_text(encoding="utf-8"))
        run(self.root, "python3", "tidy/tidy.py")
        self.assertEqual([one for one in links.faults(str(self.root)) if "images" not in one], [])
        run(self.root, "python3", "tidy/proved.py", "--update")
        self.assertIn(f"| `{RULE}` | no: ", (self.root / "docs/certificates.md").read_text(encoding="utf-8"))


class Built(Followed):
    """And built: the commands of the page run, the tests of what was added pass, and nothing else has changed."""
    cache = None
    place = ROOT / "build" / "how-to-add"  # ccache knows the sources there by their paths from the build

    def test_the_copy_builds_and_passes(self):
        root = self.root
        cache = [f"-D{line}" for line in CACHED.findall(self.cache.read_text(encoding="utf-8"))]
        run(root, "cmake", "--preset", "release", "-DCIRCUMSPECT_BUILD_TESTS=ON", *cache)
        for line in re.search(r"^```sh\n(.*?)^```$", section("A rule"), re.MULTILINE | re.DOTALL)[1].splitlines():
            run(root, "bash", "-c", line)
        for title, (targets, tests) in TESTS.items():
            run(root, "cmake", "--build", "--preset", "release", "--target", *targets)
            with self.subTest(title):
                run(root, "ctest", "--test-dir", "build/release", "-R", tests, "--no-tests=error")
        command = str(root / "build/release/bin/circumspect")
        run(root, "python3", "tidy/rule_pages.py", command)
        self.assertTrue(run(root, command, "generate", FAMILY, "--seed", "1"))
        self.assertIn(ENDING, run(root, command, "check", "--help"))
        was, now = self.golden, self.golden_rows()
        self.assertEqual([row for row in was if row not in now], [], "golden rows of before are to stay")
        self.assertEqual({row.split("\t")[0].removesuffix(" --format json") for row in now if row not in was},
                         {f"check reject/{RULE}.ele --claim delaunay",
                          "check periodic/index-of-none.ele --claim periodic-delaunay --box 0,0,1,1"})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, metavar="CACHE")
    options = parser.parse_args()
    Built.cache = options.build
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Built if options.build else Followed)
    return 0 if unittest.TextTestRunner(verbosity=1).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
