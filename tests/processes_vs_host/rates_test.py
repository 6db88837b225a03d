#!/usr/bin/env python3
"""Tests the comparison of rates (rates.py) with simulated hosts and layers of known failure rates."""
import random
import unittest

import rates


def process(chance, end="hangs", numbers=random.Random(7)):
    return lambda: end if numbers.random() < chance else None


class Rates(unittest.TestCase):
    def test_chance(self):
        self.assertAlmostEqual(rates.chance(0, 10, 0, 10), 1)
        self.assertAlmostEqual(rates.chance(0, 2, 2, 2), 1 / 6)
        self.assertLess(rates.chance(2, 60, 15, 60), 0.01)

    def test_what_bare_never_does(self):
        self.assertTrue(rates.compare("hangs", process(0), process(0.02))[0])
        self.assertTrue(rates.compare("hangs", process(0.3, "SIGSEGV"), process(0.05))[0])
        # Another failure of the layer appears while the first is examined.
        layer = iter([None] * 6 + ["SIGSEGV"] + [None] * 300)
        self.assertTrue(rates.compare("hangs", process(0.05), lambda: next(layer))[0])

    def test_after_its_time(self):
        runs = []

        def layer():
            runs.append(1)
            return None
        for bare in (process(0), process(1)):  # the same end each time says nothing about rates
            worse, words = rates.compare("hangs", bare, layer, seconds=0)
            self.assertTrue(worse)
            self.assertIn("no time to compare", words)
        self.assertLess(len(runs), 20)

    def test_always(self):
        self.assertTrue(rates.compare("hangs", process(0.05), process(1))[0])

    def test_mostly_but_less_than_bare(self):
        found = sum(rates.compare("hangs", process(0.95), process(0.8))[0] for _ in range(50))
        self.assertEqual(found, 0)

    def test_more_often(self):
        found = sum(rates.compare("hangs", process(0.04), process(0.35))[0] for _ in range(50))
        self.assertGreater(found, 45)

    def test_as_often(self):
        found = sum(rates.compare("hangs", process(0.05), process(0.05))[0] for _ in range(200))
        self.assertLess(found, 6)


if __name__ == "__main__":
    unittest.main()
