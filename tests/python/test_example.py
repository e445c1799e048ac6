"""The example runs as it stands, and draws where matplotlib is installed."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXAMPLE = pathlib.Path(__file__).parents[2] / "apc" / "python" / "examples" / "size_a_bed.py"


class Example(unittest.TestCase):
    def test_sizes_a_bed_and_plots_it(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, EXAMPLE, folder], capture_output=True, text=True, env=os.environ)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("m long", done.stdout)
            self.assertIn("95 %", done.stdout)
            if importlib.util.find_spec("matplotlib"):
                picture = pathlib.Path(folder) / "size_a_bed.png"
                self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
                self.assertGreater(picture.stat().st_size, 20000)


if __name__ == "__main__":
    unittest.main()
