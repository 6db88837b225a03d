#!/usr/bin/env python3
"""Compares docs/driver/extensions.md with the extension strings of contexts, on the bare host and under the layer
with each profile that a row names.

The layer must offer a row's extension under the profiles that the row names, and under others only if the host has it.
A row of the host's, or of what is not implemented or refused, is offered if the host has it.
"""
import pathlib
import re
import sys

import self_client
from self_client import expect

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE.parents[1] / 'docs/driver/extensions.md'
ROW = re.compile(r'^\| (GL_\w+) \| ([\w\' ]+) \|([^|]*)\|', re.M)
OURS = ("the layer's", 'where missing')
OTHERS = ("the host's", 'not yet', 'refused')


def table(text):
    """Returns {extension: (whose, [profile])} of the rows."""
    return {name: (whose, re.findall(r'`([\w-]+)`', profiles))
            for name, whose, profiles in ROW.findall(text)}


def wrong(rows, bare, names, profile):
    """Yields the disagreements between the table and the list of a profile."""
    for name, (whose, profiles) in sorted(rows.items()):
        expected = name in bare or (whose in OURS and profile in profiles)
        if (name in names) != expected:
            yield f'{profile}: {name} is {"not " if expected else ""}announced'


def check(options):
    rows = table(TABLE.read_text())
    unknown = [name for name, (whose, _) in rows.items() if whose not in OURS + OTHERS]
    expect(len(rows) >= 30 and not unknown, f'{len(rows)} rows, not understood: {unknown}')
    client = HERE / 'identity.py'
    bare = self_client.ask(client, options, 'egl', None)
    if bare is None:
        return False
    failed = []
    for profile in sorted({'host', 'r300', 'i915'}.union(*(named for _, named in rows.values()))):
        answers = self_client.ask(client, options, 'egl', ['--profile', profile])
        expect(not answers['missing'], f'{profile}: no function {answers["missing"]}')
        failed += wrong(rows, set(bare['names']), set(answers['names']), profile)
        print(f'{profile}: {answers["count"]} extensions', flush=True)
    expect(not failed, '\n'.join(failed))
    return True


if __name__ == '__main__':
    sys.exit(self_client.main('extensions_table', None, check))
