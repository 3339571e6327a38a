"""Records of runs, against the tables that the program wrote of the same records."""

import csv
import json
import unittest
import warnings

import support
import numpy as np

import signorini
from signorini import BadInput, program

CATALOGUE = support.ROOT / "results" / "catalogue"


class Records(support.TemporaryFolder):
    def table(self):
        with open(CATALOGUE / "table.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_of_a_run_are_those_of_its_table(self):
        records = signorini.load(CATALOGUE)
        rows = self.table()
        self.assertEqual(len(records), len(rows))
        self.assertEqual(sorted(record["case"] for record in records), sorted(row["case"] for row in rows))

    def test_of_a_run_just_made_are_read(self):
        program.run(["run", "--scenes", "sdof-far-stop", "--methods", "exact-orbit[samples=64]:hat-lcp[samples=16]",
                     "--repetitions", "1", "--out", str(self.folder / "run")], allowed=(0, 1))
        cases = {record["case"]: record["status"] for record in signorini.load(self.folder / "run")}
        self.assertEqual(cases["sdof-far-stop/exact-orbit[samples=64]"], "converged")
        self.assertEqual(len(cases), 2)

    def test_that_are_damaged_doubled_or_stale_do_not_count(self):
        self.write("plan.txt", "aa scene/method\nbb scene/other\n")
        lines = [{"key": "aa", "case": "scene/method", "status": "timeout"}, {"key": "cc", "case": "scene/stale"},
                 {"key": "bb", "case": "scene/other"}, {"key": "aa", "case": "scene/method", "status": "converged"}]
        self.write("records.jsonl", "\n".join(map(json.dumps, lines)) + '\n{"key": "bb", "ca')
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            records = signorini.load(self.folder)
        self.assertEqual([(record["key"], record.get("status")) for record in records], [("bb", None), ("aa", "converged")])
        self.assertRegex(str(told[0].message), r"records.jsonl:5: no record; left out")

    def test_may_be_none(self):
        self.write("records.jsonl", "")
        self.assertEqual(signorini.load(self.folder), [])

    def test_of_a_folder_without_a_run_are_refused(self):
        with self.assertRaisesRegex(BadInput, "must hold records.jsonl"):
            signorini.load(self.folder / "none")

    @unittest.skipUnless(support.installed("pandas"), "pandas is not installed")
    def test_make_a_frame_with_flat_columns(self):
        frame = signorini.frame(CATALOGUE)
        rows = {row["case"]: row for row in self.table()}
        self.assertEqual(set(frame["case"]), set(rows))
        for _, one in frame[frame["status"] == "converged"].iterrows():
            for column, key in (("errors.x_l2", "x_l2"), ("seconds.median", "seconds_median"),
                                ("physics.penetration", "penetration")):
                told = rows[one["case"]][key]
                if told:
                    self.assertAlmostEqual(one[column] / float(told) if float(told) else one[column] + 1.0, 1.0, delta=1e-9)
                else:
                    self.assertTrue(np.isnan(one[column]))
        self.assertFalse({"certificate.events", "seconds.rounds", "waveforms"} & set(frame.columns))
        self.assertEqual(len(signorini.frame([])), 0)


if __name__ == "__main__":
    unittest.main()
