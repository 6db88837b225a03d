"""Pairwise covering arrays: rows that together contain every pair of values of every two factors."""

import itertools
import random


class Array:
    """Chooses rows greedily: each starts from an uncovered pair, and each further factor takes the value that covers
    the
    most new pairs with the chosen values. make_valid(row, names) changes a row into a possible one, if it can without
    changing the two factors that the row is for."""

    def __init__(self, factors, make_valid=lambda row, kept: row, seed=1):
        self.names = list(factors)
        self.values = {name: list(factors[name]) for name in self.names}
        self.make_valid, self.random = make_valid, random.Random(seed)
        self.place = {name: i for i, name in enumerate(self.names)}
        self.open = {frame for a, b in itertools.combinations(self.names, 2)
                     for frame in ((a, x, b, y) for x in self.values[a] for y in self.values[b])}
        self.all = len(self.open)
        self.tried = set()  # pairs that make_valid() rejected

    def pair(self, a, x, b, y):
        return (a, x, b, y) if self.place[a] < self.place[b] else (b, y, a, x)

    def row(self):
        """Returns the next row; None when every possible pair is covered."""
        while True:
            candidates = sorted(self.open - self.tried)
            if not candidates:
                return None
            start = self.random.choice(candidates)
            chosen = self.make_valid(self.fill(start), (start[0], start[2]))
            before = len(self.open)
            self.cover(chosen)
            if len(self.open) < before:
                if start in self.open:
                    self.tried.add(start)
                return chosen
            self.tried.add(start)

    def fill(self, start):
        a, x, b, y = start
        chosen = {a: x, b: y}
        others = [name for name in self.names if name not in chosen]
        self.random.shuffle(others)
        for name in others:
            values = self.values[name][:]
            self.random.shuffle(values)
            chosen[name] = max(values, key=lambda value: sum(
                self.pair(name, value, other, chosen[other]) in self.open for other in chosen))
        return {name: chosen[name] for name in self.names}

    def cover(self, row):
        for a, b in itertools.combinations(self.names, 2):
            self.open.discard((a, row[a], b, row[b]))

    def covered(self):
        """Returns the fraction of all pairs."""
        return 1 - len(self.open) / self.all


def rows(factors, make_valid, count, seed):
    """Returns (rows, the fraction of pairs that they contain); count 0: until no pair can be added."""
    array, found = Array(factors, make_valid, seed), []
    while not count or len(found) < count:
        row = array.row()
        if row is None:
            break
        found.append(row)
    return found, array.covered()


def self_test():
    small = {"a": ["1", "2", "3"], "b": ["x", "y"], "c": ["p", "q", "r", "s"], "d": ["0", "1"]}
    found, part = rows(small, lambda row, kept: row, 0, 1)
    held = {(a, row[a], b, row[b]) for row in found for a, b in itertools.combinations(small, 2)}
    wanted = {(a, x, b, y) for a, b in itertools.combinations(small, 2)
              for x in small[a] for y in small[b]}
    assert held == wanted and part == 1, (wanted - held, part)
    assert 12 <= len(found) <= 18, len(found)
    # Impossible pairs are given up, and the rest is still covered.
    forbidden, part = rows(small, lambda row, kept: {**row, "d": "0"}, 0, 1)
    assert part < 1 and all(row["d"] == "0" for row in forbidden)
    held = {(row["a"], row["c"]) for row in forbidden}
    assert len(held) == 12
    assert rows(small, lambda row, kept: row, 0, 1)[0] == found
    return 4
