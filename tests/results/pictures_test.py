#!/usr/bin/env python3
"""Tests of the pictures of the results page: those of the tree are what their record says, and planted faults are seen.

usage: pictures_test.py [BUILD]     with a build, some are drawn anew and must be the tree's
"""

import json
import pathlib
import random
import shutil
import sys
import tempfile
import unittest

import fixture

import pictures
from pictures import picture

BUILD = None


def parts_of(strip):
    """Returns ours and the reference of a strip, without the grey between them."""
    side = (strip.width - 8) // 3
    rows = [strip.rgb[y * strip.width * 3:(y + 1) * strip.width * 3] for y in range(strip.height)]
    return [picture.Picture(side, strip.height, b"".join(row[x * 3:(x + side) * 3] for row in rows))
            for x in (0, side + 4)]


def far(drawn, kept, levels):
    """Returns how many pixels of two pictures are more than some levels apart."""
    if (drawn.width, drawn.height) != (kept.width, kept.height):
        return drawn.width * drawn.height
    return sum(max(abs(drawn.rgb[at + i] - kept.rgb[at + i]) for i in range(3)) > levels
               for at in range(0, len(kept.rgb), 3))


class Record(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.here = pathlib.Path(holder.name) / "results"
        shutil.copytree(pictures.HERE, self.here, ignore=shutil.ignore_patterns("__pycache__"))
        self.root = pathlib.Path(holder.name) / "tree"
        for name in ("demos/gallery", "demos/programs"):
            shutil.copytree(fixture.ROOT / name, self.root / name)
        for name in ("tests/gallery_vs_interpreter/gallery_test.cpp", "demos/meson.build"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(fixture.ROOT / name, self.root / name)

    def stale(self, reason):
        with self.assertRaisesRegex(pictures.Stale, reason):
            pictures.published(self.here, self.root)

    def edited(self, name, old, new):
        text = (self.root / name).read_text()
        self.assertIn(old, text)
        (self.root / name).write_text(text.replace(old, new, 1))

    def test_the_trees_pictures_are_those_of_the_record(self):
        record = pictures.published(self.here, self.root)
        self.assertEqual({path.name for path in pictures.FOLDER.iterdir()},
                         {pathlib.Path(row["file"]).name for row in record["pictures"]})
        self.assertLess(sum(path.stat().st_size for path in pictures.FOLDER.iterdir()), pictures.MOST_BYTES)
        for row in record["pictures"]:
            for way in row["ways"].values():
                self.assertTrue(way["largest"] <= way["levels"] or 0 < way["beyond"] <= way["most"], row)

    def test_a_program_that_changes(self):
        self.edited("demos/gallery/twirl.fp", "\n", "\n\n")
        self.stale("demos/gallery has changed")

    def test_a_picture_that_is_missing_or_another(self):
        first, second = sorted((self.here / "pictures").iterdir())[:2]
        shutil.copy(first, second)
        self.stale(f"{second.name}: not the picture")
        second.unlink()
        self.stale(f"{second.name}: not the picture")

    def test_a_case_without_a_picture(self):
        self.edited("tests/gallery_vs_interpreter/gallery_test.cpp", '    {"blur.fp", ',
                    '    {"added.fp", 0, "96x96", 2, 0},\n    {"blur.fp", ')
        self.stale("lacks added")

    def test_a_demonstration_without_a_picture(self):
        self.edited("demos/meson.build", "  'twirl': [['', []]],", "  'twirl': [['', []]],\n  'more': [['', []]],")
        self.stale("lacks more")

    def test_the_page_has_each_picture_once(self):
        record = json.loads(pictures.RECORD.read_text())
        text = pictures.page(record)
        for row in record["pictures"]:
            self.assertEqual(text.count(f"]({row['file']})"), 1)
        self.assertEqual(pictures.figures({"largest": 79, "levels": 2, "beyond": 3, "most": 18}),
                         "79 of 2, 3 pixels of 18 beyond")


class Files(unittest.TestCase):
    def test_a_small_png_holds_every_pixel(self):
        dice = random.Random(1)
        noise = bytes(dice.randrange(256) for _ in range(17 * 9 * 3))
        slopes = bytes((7 * x + 3 * y + 50 * i) & 255 for y in range(9) for x in range(17) for i in range(3))
        for rgb in (noise, slopes, bytes(17 * 9 * 3)):
            shown = picture.Picture(17, 9, rgb)
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "a.png"
                file.write_bytes(pictures.small_png(shown))
                self.assertEqual(picture.read(file), shown)
                picture.write_png(pathlib.Path(folder) / "b.png", shown)
                if rgb is slopes:
                    self.assertLess(file.stat().st_size, (pathlib.Path(folder) / "b.png").stat().st_size)

    def test_a_blank_picture_is_none(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.png"
            picture.write_png(file, picture.Picture(4, 4, bytes(48)))
            with self.assertRaisesRegex(pictures.Failed, "blank"):
                pictures.entry(pathlib.Path(folder), "gallery", "a", {"swrast": file, "reference": file}, {})


class Drawn(unittest.TestCase):
    """Draws some pictures anew. Another driver under the layer may differ by what the tests allow, twice."""

    DEMOS = ("brightness-contrast", "life", "twirl")

    @classmethod
    def setUpClass(cls):
        if BUILD is None:
            raise unittest.SkipTest("no build")
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.out = pathlib.Path(cls.holder.name)
        cls.rows = [*pictures.gallery(BUILD, cls.out, cls.out, "twirl.fp"),
                    *pictures.demonstrations(BUILD, cls.out, cls.out, *cls.DEMOS)]

    def apart(self, row, kept):
        """Returns how many pixels of a row's strip are not those of a kept one, in ours and in the reference."""
        strip, other = (parts_of(picture.read(file))
                        for file in (self.out / pathlib.Path(row["file"]).name, pictures.HERE / kept["file"]))
        return [far(*pair, row["ways"]["swrast"]["levels"]) for pair in zip(strip, other)]

    def test_they_are_the_trees(self):
        kept = {row["file"]: row for row in pictures.published()["pictures"]}
        self.assertEqual([row["name"] for row in self.rows],
                         ["twirl", "brightness-contrast", "life-naive", "life-packed", "twirl"])
        for row in self.rows:
            ours, reference = self.apart(row, kept[row["file"]])
            self.assertLessEqual(ours, 2 * row["ways"]["swrast"]["most"], row["name"])
            self.assertLessEqual(reference, row["ways"]["swrast"]["most"], row["name"])

    def test_another_picture_is_seen(self):
        twirl, other = [row for row in self.rows if row["name"] in ("twirl", "brightness-contrast")
                        and row["group"] == "demonstrations"]
        self.assertGreater(min(self.apart(twirl, other)), 1000)


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and pathlib.Path(sys.argv[1]).is_dir():
        BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
