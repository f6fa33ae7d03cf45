#!/usr/bin/env python3
"""`make check` runs the tests that a change concerns, and names those that it leaves out."""

import os
import tempfile
import unittest

import check


def test(name, *command):
    return {"name": name, "command": [str(check.ROOT / word) for word in command], "properties": []}


JUDGE = test("oracle/judge/judge_test")
POINTS = test("oracle/judge/points/cells_test")
GOLDEN = test("corpus/golden", "corpus/golden.py")
DEMO = test("corpus/demo", "corpus/demo.sh")
COMMAND = test("command/check/check_command_test")


class Distance(unittest.TestCase):
    def distances(self, *changed):
        return [check.distance(one, set(changed)) for one in [JUDGE, POINTS, GOLDEN, COMMAND]]

    def test_a_source_is_near_the_tests_of_its_folder_and_far_from_what_the_command_prints(self):
        self.assertEqual(self.distances("oracle/judge/verdict_of_faults.cpp"),
                         [check.NEAR, None, check.FAR, check.FAR])

    def test_a_test_is_about_itself_and_no_other_test_is_about_it(self):
        self.assertEqual(self.distances("oracle/judge/judge_test.cpp")[:2], [check.NEAR, None])
        self.assertEqual(self.distances("corpus/golden.py")[2], check.NEAR)

    def test_a_property_is_about_the_folders_whose_headers_it_includes(self):
        insertion = test("properties/insertion_property")
        self.assertEqual(check.distance(insertion, {"reference/delaunay/bowyer_watson.cpp"}), check.NEAR)
        self.assertIsNone(check.distance(insertion, {"oracle/picture/picture.cpp"}))

    def test_a_subcommand_is_near_its_own_tests(self):
        self.assertEqual(self.distances("command/check/check.cpp")[3], check.NEAR)

    def test_what_nobody_tests_concerns_nobody(self):
        self.assertEqual(self.distances("bench/README.md"), [None] * 4)


class Choice(unittest.TestCase):
    def chosen(self, seconds, jobs=1):
        found = [JUDGE, GOLDEN, DEMO, COMMAND]
        chosen, left_out = check.choose(found, {"oracle/judge/verdict_of_faults.cpp"}, seconds, jobs)
        return [one["name"] for one in chosen], left_out

    def test_everything_runs_that_is_quick_enough_together(self):
        chosen, left_out = self.chosen({})
        self.assertEqual(len(chosen), 4)
        self.assertEqual(left_out, [])

    def test_the_slowest_distant_tests_are_left_out(self):
        long = check.FAR_SECONDS
        chosen, left_out = self.chosen({"corpus/golden": long, "corpus/demo": 0.75 * long,
                                        "command/check/check_command_test": 0.25 * long})
        self.assertEqual(chosen, ["oracle/judge/judge_test", "command/check/check_command_test", "corpus/demo"])
        self.assertEqual(left_out, ["corpus/golden"])

    def test_two_processors_run_twice_as_many(self):
        long = check.FAR_SECONDS
        self.assertEqual(self.chosen({"corpus/golden": long, "corpus/demo": long}, jobs=2)[1], [])

    def test_a_near_test_runs_however_long_it_takes(self):
        self.assertIn("oracle/judge/judge_test", self.chosen({"oracle/judge/judge_test": 1000.0})[0])


class Targets(unittest.TestCase):
    def targets(self, *command, name="a/b_test"):
        return check.targets({"name": name, "command": list(command)}, "build/release")

    def test_the_program_and_those_that_a_script_starts(self):
        release = os.path.abspath("build/release")
        self.assertEqual(self.targets(f"{release}/tests/judge_test", "--source-file=*/a.cpp"), {"judge_test"})
        self.assertEqual(self.targets("/usr/bin/python3", "/a/mpi_test.py", f"{release}/bin/circumspect-mpi",
                                      f"{release}/bin/circumspect"), {"circumspect_mpi", "circumspect_cli"})

    def test_everything_for_a_script_that_is_given_the_folder(self):
        release = os.path.abspath("build/release")
        self.assertEqual(self.targets("/a/outside_test.sh", release), {"all"})
        self.assertEqual(self.targets("/a/replay.py", f"{release}/tests"), {"all"})

    def test_a_program_that_was_never_built_is_found_where_cmake_registered_it(self):
        with tempfile.TemporaryDirectory() as build:
            os.makedirs(os.path.join(build, "corpus"))
            with open(os.path.join(build, "CTestTestfile.cmake"), "w", encoding="utf-8") as file:
                file.write(f'add_test([=[a/a_test]=] "{build}/tests/a_test" "--source-file=*/a/a_test.cpp")\n'
                           f'add_test([=[b/c_test]=] "{build}/tests/b_test" "--source-file=*/b/c_test.cpp")\n')
            self.assertEqual(check.targets({"name": "b/c_test"}, build), {"b_test"})


class Times(unittest.TestCase):
    def test_they_are_read_from_the_log_of_ctest(self):
        with tempfile.TemporaryDirectory() as build:
            self.assertEqual(check.times(build), {})
            folder = os.path.join(build, "Testing", "Temporary")
            os.makedirs(folder)
            with open(os.path.join(folder, "LastTest.log"), "w", encoding="utf-8") as log:
                log.write("1/2 Testing: a/b_test\n1/2 Test: a/b_test\nCommand: x\nOutput:\nTest time = never\n"
                          "<end of output>\nTest time =   1.25 sec\n----\nTest Passed.\n"
                          "2/2 Testing: c\n2/2 Test: c\nOutput:\n<end of output>\nTest time =  10.00 sec\n")
            self.assertEqual(check.times(build), {"a/b_test": 1.25, "c": 10.0})


if __name__ == "__main__":
    unittest.main()
