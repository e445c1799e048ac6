"""One overrun from Python: the numbers of the program, in NumPy arrays."""
import json
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import apc

PROGRAM = pathlib.Path(apc.__file__).parents[2] / "apc"


class Simulate(unittest.TestCase):
    def test_gives_the_numbers_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [PROGRAM, "simulate", "--aircraft", "CRJ-200", "--bed", "emas_18in_50psi", "--speed", "60 kt", "--braking",
                 "0.2", "--json", "r.json", "--quiet", "-o", "o"], cwd=folder, check=True)
            told = json.loads((pathlib.Path(folder) / "r.json").read_text())
        run = apc.simulate("CRJ-200", "emas_18in_50psi", "60 kt", braking=0.2)
        self.assertEqual(run.outcome, told["outcome"])
        self.assertEqual(run.stop_distance, told["stop_distance"])
        self.assertEqual(run.gears.nose.peak_drag, told["gears"]["nose"]["peak_drag"])

    def test_histories_are_arrays_of_one_length_that_own_their_data(self):
        run = apc.simulate("CRJ-200", "emas_18in_50psi", 30.0)
        history = run.history
        self.assertIsInstance(history.distance, np.ndarray)
        self.assertEqual(history.distance.dtype, np.float64)
        for column in (history.time, history.speed, history.gears.nose.drag, history.gears.main.vertical):
            self.assertEqual(column.shape, history.time.shape)
        self.assertTrue(np.all(np.diff(history.time) >= 0))
        self.assertAlmostEqual(history.distance[-1], run.stop_distance, delta=0.05)
        self.assertAlmostEqual(history.gears.nose.drag.max() / run.gears.nose.peak_drag / run.gears.nose.struts, 1, delta=0.01)
        history.distance[0] = 7.0
        self.assertEqual(history.distance[0], 7.0)

    def test_a_bed_of_arrays_is_the_bed_of_the_file(self):
        shipped = apc.load_bed("emas_18in_50psi")
        made = apc.Bed(shipped.distance, shipped.depth, setback=shipped.setback, width=shipped.width)
        one = apc.simulate("CRJ-200", shipped, "50 kt", sampling=0)
        other = apc.simulate("CRJ-200", made, "50 kt", sampling=0)
        self.assertAlmostEqual(one.stop_distance, other.stop_distance, places=6)
        self.assertNotIn("history", one)

    def test_quantities_are_texts_with_units_or_numbers_in_si(self):
        text = apc.simulate("CRJ-200", "emas_18in_50psi", "60 kt", mass="48000 lb", sampling=0)
        number = apc.simulate("CRJ-200", "emas_18in_50psi", 60 * 1852 / 3600, mass=48000 * 0.45359237, sampling=0)
        self.assertAlmostEqual(text.stop_distance, number.stop_distance, places=6)


if __name__ == "__main__":
    unittest.main()
