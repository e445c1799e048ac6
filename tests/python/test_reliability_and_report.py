"""From a finished design: probabilities and the compliance report, the same as the program's."""
import json
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import apc

PROGRAM = pathlib.Path(apc.__file__).parents[2] / "apc"


class FromADesign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.home.name)
        cls.design = apc.design("acrp29_crj_200", folder=cls.folder / "d")

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    def test_design_keeps_what_it_promises(self):
        self.assertTrue(self.design.feasible)
        self.assertTrue(self.design.certificate.agreed)
        self.assertLessEqual(max(case.stop_distance for case in self.design.cases), self.design.bed.length + 1e-6)
        self.assertIsInstance(self.design.bed, apc.Bed)

    def test_reliability_is_that_of_the_program(self):
        folder = self.folder / "r"
        told = apc.reliability(self.design.file, folder, samples=200)[0]
        subprocess.run([PROGRAM, "reliability", "--design", self.design.file, "--samples", "200", "--quiet", "--json",
                        "j.json", "-o", "other"], cwd=self.folder, check=True)
        case = json.loads((self.folder / "j.json").read_text())["cases"][0]
        self.assertEqual(told.arrest[0], case["arrest"]["value"])
        self.assertEqual(told.runs, case["runs"])
        self.assertEqual(told.arrest_speeds.shape, (told.samples,))
        self.assertGreaterEqual(told.samples, 198)
        self.assertTrue(np.all(told.intact_speeds <= told.arrest_speeds[-1]))

    def test_report_counts_its_requirements(self):
        told = apc.report(self.design.file, self.folder / "c", site="example_runway_end")
        self.assertEqual(sum(told.counts.values()), len(told.requirements))
        for name in ("report.html", "report.json", "manifest.json", "site.geojson", "site.kml"):
            self.assertTrue((self.folder / "c" / name).exists(), name)
        self.assertFalse(any(each.result == "pass" and not each.clause_read for each in told.requirements))


if __name__ == "__main__":
    unittest.main()
