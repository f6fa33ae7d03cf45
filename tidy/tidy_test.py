#!/usr/bin/env python3
"""Every rule of tidy fires on what it forbids and is silent on what it allows."""

import os
import tempfile
import unittest

import tidy


def rules(path, text):
    """The rules that fire on a tree with this one file."""
    return [fault.split(": ")[1] for fault in faults(path, text)]


def faults(path, text):
    with tempfile.TemporaryDirectory() as root:
        file = os.path.join(root, path)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8", newline="") as out:
            out.write(text)
        return tidy.Tidy(root).run()


class Arrows(unittest.TestCase):
    def test_a_checker_must_not_see_a_construction(self):
        self.assertEqual(faults("kernel/complex/a.cpp", '\n#include "reference/delaunay/b.hpp"\n'),
                         ["kernel/complex/a.cpp:2: arrow: kernel/complex must not see "
                          "reference/delaunay; move what it needs to a layer that both see"])
        self.assertEqual(rules("oracle/judge/points/a.cpp", '#include "reference/constructions.hpp"\n'), ["arrow"])

    def test_others_ask_the_book_by_one_header(self):
        for folder in ["oracle/judge/points", "c", "python", "include/circumspect", "fuzz/harness"]:
            for header in ["reference/delaunay/b.hpp", "reference/constrained/b.hpp", "reference/b.hpp"]:
                for name in ["a.cpp", "a_test.cpp"]:
                    self.assertEqual(rules(f"{folder}/{name}", f'#include "{header}"\n'), ["constructions"])
        self.assertEqual(rules("c/a.cpp", '#include "reference/constructions.hpp"\n'), [])
        self.assertEqual(rules("command/build/a.cpp", '#include "reference/delaunay/b.hpp"\n'), [])

    def test_the_reference_must_not_see_the_oracle(self):
        for folder in tidy.ARROWS:
            if folder.startswith(("kernel/", "reference/")):
                for header in ["oracle/model/a.hpp", "oracle/judge/points/a.hpp"]:
                    self.assertEqual(rules(f"{folder}/a.hpp", f'#include "{header}"\n'), ["arrow"])

    def test_angle_brackets_do_not_hide_an_arrow(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", "#include <reference/delaunay/b.hpp>\n"), ["constructions"])

    def test_an_arrow_leads_through_the_layers_between(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", '#include "kernel/exact/number.hpp"\n'), [])
        self.assertEqual(rules("oracle/formats/a.cpp", '#include "oracle/model/mesh.hpp"\n'), [])

    def test_siblings_do_not_see_each_other(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", '#include "oracle/formats/b.hpp"\n'), ["arrow"])

    def test_a_test_may_generate_its_inputs(self):
        text = '#include "inputs/points.hpp"\n'
        self.assertEqual(rules("kernel/exact/a_test.cpp", text), [])
        self.assertEqual(rules("kernel/exact/a_test.hpp", text), [])
        self.assertEqual(rules("kernel/exact/a.cpp", text), ["arrow"])

    def test_a_path_begins_at_the_root(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", '#include "b.hpp"\n'), ["include"])
        self.assertEqual(rules("oracle/judge/points/a.cpp", '#include "../mesh.hpp"\n'), ["include"])

    def test_a_new_folder_needs_an_arrow(self):
        self.assertEqual(rules("oracle/new/a.cpp", ""), ["folder"])

    def test_a_program_apart_includes_what_it_likes(self):
        self.assertEqual(rules("corpus/make/cgal/a.cpp", '#include <CGAL/b.h>\n#include "c.hpp"\n'), [])

    def test_a_commented_include_is_none(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", '// #include "reference/delaunay/b.hpp"\n'), [])

    def test_the_build_draws_the_same_arrows(self):
        line = "circumspect_layer(exact kernel/exact)\ncircumspect_layer(predicates " \
               "kernel/predicates\n  DEPENDS {} LINKS fmt::fmt)\n"
        self.assertEqual(rules("CMakeLists.txt", line.format("exact")), [])
        self.assertEqual(rules("CMakeLists.txt", line.format("exact complex")), ["build"])
        self.assertEqual(rules("CMakeLists.txt", line.replace("DEPENDS {} ", "")), ["build"])
        self.assertEqual(rules("CMakeLists.txt", "circumspect_layer(new reference/new)\n"), ["build"])


class Libraries(unittest.TestCase):
    def test_only_exact_names_the_number_library(self):
        for text in ["#include <gmpxx.h>\n", "#include <mpfr.h>\n", "mpq_class a;\n",
                     "mpz_t a;\n", "mpfr_t a;\n"]:
            self.assertEqual(rules("kernel/complex/a.cpp", text), ["number-library"], text)
            self.assertEqual(rules("kernel/complex/a_test.cpp", text), ["number-library"], text)
            self.assertEqual(rules("kernel/exact/a.cpp", text), [], text)
            self.assertEqual(rules("kernel/complex/a_cgal_test.cpp", text), [], text)
        self.assertEqual(rules("kernel/complex/a.cpp", "// an mpq_class inside\n"), [])

    def test_cgal_stays_in_its_own_tests(self):
        text = "#include <CGAL/Exact_rational.h>\n"
        self.assertEqual(rules("oracle/judge/points/a.cpp", text), ["cgal"])
        self.assertEqual(rules("oracle/judge/points/a_test.cpp", text), ["cgal"])
        self.assertEqual(rules("oracle/judge/points/a_cgal_test.cpp", text), [])

    def test_the_reference_has_no_floating_point(self):
        for text in ["double a;\n", "f(1, float());\n", "std::vector<double> v;\n"]:
            self.assertEqual(rules("reference/delaunay/a.cpp", text), ["floating-point"], text)
            self.assertEqual(rules("reference/delaunay/a_test.cpp", text), [], text)
            self.assertEqual(rules("kernel/exact/a.cpp", text), [], text)
            self.assertEqual(rules("oracle/judge/points/a.cpp", text), [], text)
        for text in ["// a double point\n", 'f("double ");\n', "int double_count;\n",
                     "/* a\n double */\n", 'R"(\n" double "\n)";\n', "f('\"', 1'000); // double '\n"]:
            self.assertEqual(rules("reference/delaunay/a.cpp", text), [], text)

    def test_vector_algebra_stands_in_one_place(self):
        for text in ["x = a[1] * b[2] - a[2] * b[1];\n", "f(u[0] * v[1], u[1] * v[0]);\n",
                     "x = a.x * b.y - b.x * a.y;\n", "x = p[axes[0]] * q[axes[1]] - q[axes[0]] * p[axes[1]];\n",
                     "x = a.at[1] * b.at[2] -\n    a.at[2] * b.at[1];\n", "b = u[0] * v[1] < u[1] * v[0];\n",
                     "x = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);\n"]:
            self.assertEqual(rules("oracle/judge/within/a.cpp", text), ["cross-product"], text)
            self.assertEqual(rules("kernel/exact/point.cpp", text), [], text)
            self.assertEqual(rules("oracle/judge/within/a_test.cpp", text), [], text)
        for text in ["x = a[0] * b[0] - a[1] * b[1];\n", "x = a[0] * b[1] - c[1] * d[0];\n",
                     "x = a[0] * b[1] + a[1] * b[0];\n", "// a[1] * b[2] - a[2] * b[1]\n",
                     "x = m[i][j] * m[k][k] - m[i][k] * m[k][j];\n"]:
            self.assertEqual(rules("oracle/judge/within/a.cpp", text), [], text)

    def test_a_long_has_32_bits_somewhere(self):
        self.assertEqual(rules("kernel/exact/a.cpp", "constexpr long kMost = 1'000'000'000'000;\n"), ["long"])
        self.assertEqual(rules("kernel/exact/a.cpp", "constexpr long kMost = 1'000'000'000;\n"), [])

    def test_nothing_refers_to_what_a_call_returned(self):
        for text in ["const auto ends = std::minmax(at(a), at(b));\n", "const auto [low, high] = std::minmax(3, rank(b));\n",
                     "const auto& most = std::max(first(), 3);\n", "auto&& most = std::clamp(size(a), 1, 2);\n"]:
            self.assertEqual(rules("oracle/judge/points/a.cpp", text), ["dangling"], text)
        for text in ["const auto ends = std::minmax({at(a), at(b)});\n", "const auto [low, high] = std::minmax(a[0], a[(i + 1) % 3]);\n",
                     "const auto most = std::max(first(), 3);\n", "const Ends ends = std::minmax(at(a), at(b));\n"]:
            self.assertEqual(rules("oracle/judge/points/a.cpp", text), [], text)

    def test_what_runs_in_a_browser_has_no_algorithms_of_ranges(self):
        for folder in ["reference/delaunay", "oracle/judge/points", "command/check"]:
            self.assertEqual(rules(f"{folder}/a.cpp", "return std::ranges::find(a, b);\n"), ["ranges"])
            self.assertEqual(rules(f"{folder}/a_test.cpp", "return std::ranges::find(a, b);\n"), [])
        self.assertEqual(rules("fuzz/campaign/a.cpp", "return std::ranges::find(a, b);\n"), [])


class Style(unittest.TestCase):
    def test_a_file_holds_one_idea(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", "\n" * 450), [])
        self.assertEqual(rules("oracle/judge/points/a.cpp", "\n" * 451), ["length"])

    def test_a_function_fits_a_screen(self):
        def function(lines, row="  f();\n", head="int f(int a) {"):
            return f"{head}\n{row * (lines - 2)}}}\n"
        self.assertEqual(rules("kernel/exact/a.cpp", function(60)), [])
        self.assertEqual(faults("kernel/exact/a.cpp", "\n" + function(61)),
                         ["kernel/exact/a.cpp:2: function: 61 lines are more than a screen; cut the function "
                          "where an idea ends (at most 60 lines)"])
        for head in ["template <class T>\nvoid f(T (*g)()) {", 'TEST_CASE("a {") {', "A::A(int b) : c(b) {",
                     "struct B {\n  void f() const {"]:
            self.assertEqual(rules("kernel/exact/a_test.cpp", function(62, head=head)), ["function"], head)
        for text in [function(80, head="struct B {", row="  void f();\n"), function(80, head='extern "C" {'),
                     function(80, row="  // a {\n", head="namespace a {")]:
            self.assertEqual(rules("kernel/exact/a.cpp", text), [], text)

    def test_a_table_is_read_row_by_row(self):
        rows = '      {"a;", "b", {1, 2}, [] { return 1; }},\n' * 80
        self.assertEqual(rules("kernel/exact/a.cpp", f"T f() {{\n  return {{\n{rows}  }};\n}}\n"), [])
        self.assertEqual(rules("kernel/exact/a.cpp", f"T f() {{\n  g();\n  return {{\n{rows}  }};\n}}\n"), ["function"])

    def test_no_banner_replaces_a_file(self):
        for path, line in [("kernel/exact/a.cpp", "// ---- Points ----"), ("kernel/exact/a.hpp", "  // --- Points ---"),
                           ("python/a.py", "# ---- points ----"), ("oracle/judge/fast/a.cpp", "  // ── Points ──────"), ("cmake/a.cmake", "# ---- points ----"),
                           ("js/a.mjs", "// ---- Points ----"), ("python/a.py", "# ---------------- points")]:
            self.assertEqual(rules(path, line + "\n"), ["banner"], line)
        for line in ["// a -- b", "// --points and --mesh", "// ----", "int a = b--- --c;"]:
            self.assertEqual(rules("kernel/exact/a.cpp", line + "\n"), [], line)

    def test_comments_end_at_a_hundred_columns(self):
        self.assertEqual(rules("kernel/exact/a.cpp", "// " + "é" * 97 + "\n"), [])
        self.assertEqual(rules("kernel/exact/a.cpp", "  // " + "a" * 96 + "\n"), ["comment"])
        self.assertEqual(rules("cmake/a.sh", "# " + "a" * 99 + "\n"), ["comment"])
        self.assertEqual(rules("cmake/a.sh", "echo " + "a" * 99 + "\n"), [])

    def test_a_name_says_what_the_file_is_about(self):
        for name in ["util.hpp", "point_utils.cpp", "test_helpers.hpp", "mesh_manager.hpp",
                     "common.hpp", "misc.py"]:
            self.assertEqual(rules(f"oracle/judge/points/{name}", ""), ["name"], name)

    def test_nothing_is_left_unfinished(self):
        for mark in ["TODO", "FIXME", "XXX", "HACK"]:
            self.assertEqual(rules("oracle/judge/points/a.cpp", f"// {mark}: later\n"), ["mark"])
        self.assertEqual(rules("corpus/demo.sh", "# TODO\n"), ["mark"])

    def test_whitespace(self):
        self.assertEqual(rules("oracle/judge/points/a.cpp", "int a;\t// b\n"), ["whitespace"])
        self.assertEqual(rules("oracle/judge/points/a.cpp", "int a; \n"), ["whitespace"])
        self.assertEqual(rules("oracle/judge/points/a.cpp", "int a;\r\n"), ["whitespace"])
        self.assertEqual(rules("oracle/judge/points/a.cpp", "int a;"), ["whitespace"])

    def test_data_and_builds_are_left_alone(self):
        self.assertEqual(rules("corpus/reject/a.node", "1\t2 \n"), [])
        self.assertEqual(rules("build/release/a.cpp", "int a; \n"), [])


if __name__ == "__main__":
    unittest.main()
