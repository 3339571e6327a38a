"""Tests of build_cost.py and of the tables of limits.py, on a tree of three sources."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import build_cost  # noqa: E402
import limits  # noqa: E402

TREE = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.25)
project(tiny LANGUAGES CXX)
add_library(numerics STATIC numerics/a.cpp numerics/b.cpp)
set_target_properties(numerics PROPERTIES UNITY_BUILD ON)
add_executable(signorini main.cpp)
target_link_libraries(signorini PRIVATE numerics)
enable_testing()
add_test(NAME Passes COMMAND signorini)
add_test(NAME Fails COMMAND false)
add_test(NAME LeftOut COMMAND false)
set_tests_properties(LeftOut PROPERTIES LABELS slow)
""",
    "CMakePresets.json": """{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja",
"binaryDir": "${sourceDir}/build/release", "cacheVariables": {"CMAKE_BUILD_TYPE": "Release"}}]}""",
    "numerics/a.cpp": "int a() { return 1; }\n",
    "numerics/b.cpp": "int b() { return 0; }\n",
    "main.cpp": "int b();\nint main() { return b(); }\n",
}


class Builds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source = pathlib.Path(folder.name, "source")
        for path, text in TREE.items():
            (source / path).parent.mkdir(parents=True, exist_ok=True)
            (source / path).write_text(text)
        author = ["-c", "user.name=a", "-c", "user.email=a@b"]
        for words in (["init", "-q"], ["add", "-A"], [*author, "commit", "-qm", "x"]):
            subprocess.run(["git", "-C", source, *words], check=True)
        self.tree = build_cost.Tree(source, folder.name)

    def test_tell_units_by_name_and_what_they_took(self):
        cost, units = self.tree.target("signorini")
        self.assertEqual({unit["unit"] for unit in units}, {"numerics/unity_0", "signorini/main"})
        self.assertEqual(units, sorted(units, key=lambda unit: -unit["processor"]))
        for unit in units:
            self.assertGreater(unit["processor"], 0.0)
            self.assertTrue(5 < unit["mib"] < 2000, unit["mib"])
        self.assertGreater(cost["processor"], sum(unit["processor"] for unit in units))
        self.assertEqual(cost["mib"], max(unit["mib"] for unit in units))
        again, units = self.tree.target("signorini")
        self.assertEqual((units, again["mib"]), ([], None))
        _, units = self.tree.edit("main.cpp", "signorini")
        self.assertEqual([unit["unit"] for unit in units], ["signorini/main"])

    def test_run_what_bench_runs_and_count_what_fails(self):
        self.tree.target("all")
        self.assertEqual(self.tree.tests()[1:], (2, 1))


class Costs(unittest.TestCase):
    def test_end_with_what_the_compiler_says(self):
        with self.assertRaisesRegex(SystemExit, "no such"):
            build_cost.run(["sh", "-c", "echo no such; exit 3"])

    def test_name_precompiled_headers_too(self):
        self.assertEqual(build_cost.unit_name(["g++", "-o", "methods/CMakeFiles/n.dir/cmake_pch.hxx.gch", "-c", "x"]), "methods/n/cmake_pch")
        self.assertEqual(build_cost.unit_name(["g++", "-o", "methods/CMakeFiles/n.dir/Unity/unity_2_cxx.cxx.o"]), "methods/n/unity_2")

    def test_list_what_is_dear(self):
        units = [{"unit": "a", "processor": 5.0, "mib": 900.0}, {"unit": "b", "processor": 3.5, "mib": 100.0}]
        self.assertEqual(build_cost.dear_units(units, 4.0), [{"unit": "a", "seconds": 5.0, "ratio": 1.25, "mib": 900.0}])


class Tables(unittest.TestCase):
    def test_keep_rows_of_before_there_were_these_columns(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "limits.csv").write_text(
                "line,what,limit,limit_seconds,seconds,ratio,before_seconds,gain,goal,reached,commit,before\n"
                "case,a case,an empty process,0.0008,0.0017,2.1,,,2 ms above it,True,aa,\n"
                "build,the program,,,320.4,,,,180 s,False,bb,\n")
            rows = limits.read_rows(folder / "limits.csv", limits.COLUMNS)
            self.assertEqual(limits.read_rows(folder / "none.csv", limits.COLUMNS), [])
            rows.append(dict.fromkeys(limits.COLUMNS, "") | limits.row("build", "its tests", "one source", 10.0, 180.0, None, "ratio 34", True)
                        | {"wall_seconds": 95.0, "load": 0.25, "peak_mib": 1234.5, "commit": "cc"})
            limits.write_rows(folder / "limits.csv", limits.COLUMNS, rows)
            rows = limits.read_rows(folder / "limits.csv", limits.COLUMNS)
            limits.write_table(rows, [{"unit": "numerics/unity_2", "seconds": 27.0, "ratio": 2.7, "mib": 900.4}], folder / "table.md")
            text = (folder / "table.md").read_text()
        self.assertIn("| a case | an empty process | 800 us | 1.7 ms | 2.1 |  |  | 2 ms above it | yes |\n", text)
        self.assertIn("| the program |  |  | 320 s |  |  | 180 s | no |\n", text)
        self.assertIn("| its tests | 180 s | 18 | 95 s | 0.25 | 1234 MiB | ratio 34 | yes |\n", text)
        self.assertIn("| numerics/unity_2 | 27 s | 2.7 | 900 MiB |\n", text)


if __name__ == "__main__":
    unittest.main()
