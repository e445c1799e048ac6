"""What is wrong is told in one message that names it; InputError is a ValueError."""
import unittest

import apc


class BadInput(unittest.TestCase):
    def refused(self, text, call):
        with self.assertRaisesRegex(apc.InputError, text) as told:
            call()
        self.assertIsInstance(told.exception, ValueError)
        self.assertEqual(str(told.exception).count("\n"), 0)

    def test_names_the_argument_and_the_remedy(self):
        bed = "emas_18in_50psi"
        self.refused("speed: .*70 ms", lambda: apc.simulate("CRJ-200", bed, "70 ms"))
        self.refused("speed: is no quantity", lambda: apc.simulate("CRJ-200", bed, [70]))
        self.refused("speed: -3", lambda: apc.simulate("CRJ-200", bed, -3.0))
        self.refused("CRJ-200", lambda: apc.simulate("CRJ-20", bed, "70 kt"))
        self.refused("mass: .*no mass of a CRJ-200", lambda: apc.simulate("CRJ-200", bed, "70 kt", mass="2 t"))
        self.refused("method: ", lambda: apc.simulate("CRJ-200", bed, "70 kt", method="slow"))
        self.refused("braking: 2 ", lambda: apc.study("CRJ-200", bed, "70 kt", braking=2))
        self.refused("speeds: is empty", lambda: apc.study("CRJ-200", bed, []))
        self.refused("objective: ", lambda: apc.design("acrp29_crj_200", objective="cost"))
        self.refused("samples", lambda: apc.reliability("none.json", "o", samples=3))
        self.refused("none.json", lambda: apc.reliability("none.json", "o"))
        self.refused("none.json", lambda: apc.report("none.json", "o"))

    def test_a_bed_is_checked_as_its_file_would_be(self):
        self.refused("/profile/distance", lambda: apc.Bed([0, 50, 40], [0, 0.4, 0.4]))
        self.refused("/profile", lambda: apc.Bed([0, 50], [0, 0.4, 0.4]))
        self.refused("flush: ", lambda: apc.Bed([0, 50], [0, 0.4], flush="side"))

    def test_an_attribute_that_is_not_there_names_those_that_are(self):
        run = apc.simulate("CRJ-200", "emas_18in_50psi", "40 kt", sampling=0)
        with self.assertRaisesRegex(AttributeError, "stop_distance"):
            run.stopping_distance


if __name__ == "__main__":
    unittest.main()
