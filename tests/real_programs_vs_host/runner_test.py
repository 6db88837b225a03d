"""Tests the runner's own parts: a comparison that cannot notice a difference proves nothing."""

import sys
import tempfile
import unittest
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import evidence
import picture
from picture import Picture


def _gradient(width: int = 5, height: int = 4) -> Picture:
    return Picture(width, height, bytes((i * 7) & 255 for i in range(width * height * 3)))


class Pictures(unittest.TestCase):
    def test_png_round_trip(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "p.png"
            picture.write_png(path, _gradient())
            self.assertEqual(picture.read(path), _gradient())

    def test_png_filters_are_undone(self):
        # There are two pixels of grey a row; the rows are filtered by Sub, Up, Average and Paeth.
        rows = bytes([1, 10, 5, 2, 1, 1, 3, 10, 4, 4, 1, 1])
        expected = [10, 15, 11, 16, 15, 19, 16, 20]
        self.assertEqual(list(picture._unfilter(rows, 2, 4, 1)), expected)

    def test_ppm(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "p.ppm"
            path.write_bytes(b"P6\n5 4\n255\n" + _gradient().rgb)
            self.assertEqual(picture.read(path), _gradient())

    def test_one_step_in_one_channel_is_seen(self):
        changed = bytearray(_gradient().rgb)
        changed[7] += 1
        apart = picture.compare(_gradient(), Picture(5, 4, bytes(changed)))
        self.assertFalse(apart.identical)
        self.assertEqual((apart.maximum, apart.pixels, apart.pixels_over), (1, 1, 0))
        self.assertAlmostEqual(apart.mean, 1 / 60)
        self.assertTrue(picture.compare(_gradient(), _gradient()).identical)

    def test_other_size_is_the_largest_difference(self):
        apart = picture.compare(_gradient(), _gradient(4, 5))
        self.assertFalse(apart.same_size)
        self.assertFalse(apart.identical)
        self.assertEqual(apart.maximum, 255)

    def test_blank(self):
        self.assertTrue(Picture(3, 2, b"\x01\x02\x03" * 6).is_blank())
        self.assertFalse(_gradient().is_blank())

    def test_crop_and_side_by_side(self):
        left = _gradient().crop(2, 3)
        self.assertEqual(left.rgb[:6], _gradient().rgb[:6])
        self.assertEqual(left.rgb[6:12], _gradient().rgb[15:21])
        both = picture.side_by_side([left, left], gap=1)
        self.assertEqual((both.width, both.height), (5, 3))
        self.assertEqual(both.rgb[:6], both.rgb[9:15])

    def test_a_truncated_png_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "p.png"
            picture.write_png(path, _gradient())
            path.write_bytes(path.read_bytes()[:60])
            with self.assertRaises((picture.PictureError, zlib.error)):
                picture.read(path)


class Evidence(unittest.TestCase):
    def test_strings_of_a_dump(self):
        dump = ('12 glProgramStringARB(target = GL_VERTEX_PROGRAM_ARB, format = F, len = 3, '
                'string = "!!ARBvp1.0 END")\n'
                '13 glProgramStringARB(target = GL_FRAGMENT_PROGRAM_ARB, format = F, len = 3, '
                'string = "!!ARBfp1.0\nMOV a, \\"b\\\\;\\r\\n\\351END")\n')
        self.assertEqual(evidence._strings(dump), ['!!ARBfp1.0\nMOV a, "b\\;\r\n\xe9END'])

    def test_statistics_of_all_processes_count(self):
        good = {"target": "fragment", "error": None}
        stats = [{}, {"programs": [good, {"target": "vertex"}], "draws": {"host_glsl": 3}},
                 {"programs": [good], "draws": {"host_glsl": 1, "reasons": {"no_program": 2}}}]
        summary = evidence.summarise(stats)
        self.assertEqual((summary["programs"], summary["draws_programs"]), (2, 4))
        self.assertEqual(summary["reasons"], {"no_program": 2})
        self.assertEqual(evidence.problems(summary, 2), [])
        self.assertEqual(len(evidence.problems(summary, 3)), 1)

    def test_no_statistics_is_a_problem(self):
        self.assertEqual(len(evidence.problems(evidence.summarise([]), 1)), 2)

    def test_a_dropped_draw_is_a_problem(self):
        stats = [{"programs": [{"target": "fragment"}],
                  "draws": {"host_glsl": 1, "dropped": 1, "reasons": {"host_refused": 1}}}]
        found = evidence.problems(evidence.summarise(stats), 1)
        self.assertEqual(len(found), 1)
        self.assertIn("host_refused", found[0])

    def test_a_refused_program_is_a_problem(self):
        stats = [{"programs": [{"target": "fragment"}, {"target": "fragment", "error": "line 1"}],
                  "draws": {"host_glsl": 1}}]
        self.assertEqual(len(evidence.problems(evidence.summarise(stats), 1)), 1)


if __name__ == "__main__":
    unittest.main()
