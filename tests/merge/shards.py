"""Divides a run into N shards, numbered from 1, with every test in exactly one.

Named tests are assigned by name alone, so that adding or removing a test moves no other. Numbered tests
are assigned in blocks, as one process draws a block faster than scattered numbers."""

import hashlib
import re


class Shard:
    def __init__(self, index, of):
        if not 1 <= index <= of:
            raise ValueError("shard %d of %d: numbers go from 1 to the count" % (index, of))
        self.index, self.of = index, of

    @classmethod
    def parse(cls, text):
        match = re.fullmatch(r"(\d+)/(\d+)", text)
        if not match:
            raise ValueError("%r is no shard: write it as 3/8" % text)
        return cls(int(match.group(1)), int(match.group(2)))

    def __str__(self):
        return "%d/%d" % (self.index, self.of)

    def has(self, name):
        """True if the test of this name belongs to the shard."""
        number = int.from_bytes(hashlib.sha256(name.encode()).digest()[:8], "big")
        return number % self.of == self.index - 1

    def block(self, count):
        """Returns (first, how many) of `count` things numbered from 0; blocks differ by one at most."""
        first, end = ((index * count) // self.of for index in (self.index - 1, self.index))
        return first, end - first


WHOLE = Shard(1, 1)
