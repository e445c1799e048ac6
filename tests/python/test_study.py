"""Sweeps from Python: one row per case, resumable, and ^C ends them."""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

import apc


class Study(unittest.TestCase):
    def test_one_row_per_case_with_speeds_fastest(self):
        study = apc.study(["CRJ-200", "B737-800"], "emas_18in_50psi", ["40 kt", "60 kt"], braking=[0.0, 0.25])
        self.assertEqual(study.speed.shape, (8,))
        self.assertEqual(list(study.aircraft[:4]), ["CRJ-200"] * 4)
        self.assertTrue(np.allclose(study.speed[0::2], 40 * 1852 / 3600))
        one = apc.simulate("CRJ-200", "emas_18in_50psi", "60 kt", method="fast", sampling=0)
        row = (study.aircraft == "CRJ-200") & (study.speed > 25) & (study.braking == 0)
        self.assertEqual(study.stop_distance[row].item(), one.stop_distance)

    def test_a_store_is_continued_and_belongs_to_one_study(self):
        with tempfile.TemporaryDirectory() as folder:
            store = pathlib.Path(folder) / "cases.store"
            first = apc.study("CRJ-200", "emas_18in_50psi", [20.0, 25.0], store=store)
            lines = len(store.read_text().splitlines())
            again = apc.study("CRJ-200", "emas_18in_50psi", [20.0, 25.0, 30.0], store=store)
            self.assertEqual(lines + 1, len(store.read_text().splitlines()))
            self.assertTrue(np.array_equal(first.stop_distance, again.stop_distance[:2]))
            with self.assertRaisesRegex(apc.InputError, "other work"):
                apc.study("CRJ-200", "emas_24in_50psi", [20.0], store=store)

    def test_interrupt_ends_it_and_keeps_what_was_finished(self):
        with tempfile.TemporaryDirectory() as folder:
            store = pathlib.Path(folder) / "cases.store"
            code = ("import apc, numpy\n"
                    "try:\n"
                    f"    apc.study('B747-400', 'emas_18in_50psi', numpy.linspace(20, 40, 20000), store={str(store)!r})\n"
                    "except KeyboardInterrupt:\n"
                    "    print('interrupted')\n")
            child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
            for _ in range(600):
                time.sleep(0.1)
                if store.exists() and store.stat().st_size > 2000:
                    break
            child.send_signal(signal.SIGINT)
            said, _ = child.communicate(timeout=120)
            self.assertIn("interrupted", said)
            self.assertGreater(len(store.read_text().splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
