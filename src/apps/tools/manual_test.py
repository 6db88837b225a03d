#!/usr/bin/env python3
"""Tests that the manual pages match the built command, and that man formats them without a warning.

usage: manual_test.py ARBITER SOURCE_ROOT
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

ARBITER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
MAN = ROOT / 'docs' / 'man'


class Manual(unittest.TestCase):
    def test_pages_are_fresh(self):
        done = subprocess.run([sys.executable, MAN / 'pages.py', ARBITER, '--check'], capture_output=True,
                              text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (0, ''), done.stderr)

    def test_man_has_no_warning(self):
        if not shutil.which('man'):
            self.skipTest('not installed: man')
        pages = sorted(MAN.glob('*.[1-8]'))
        self.assertGreater(len(pages), 15)
        for page in pages:
            done = subprocess.run(['man', '-l', '--warnings', '-Tutf8', '-Z', page], capture_output=True, text=True,
                                  timeout=60, env={**os.environ, 'LC_ALL': 'C.UTF-8', 'MANROFFSEQ': ''})
            self.assertEqual((done.returncode, done.stderr), (0, ''), page)

    def test_every_page_is_named_and_installed(self):
        overview = (MAN / 'arbiter.1').read_text().replace('\\-', '-')
        build = (ROOT / 'docs' / 'meson.build').read_text()
        for page in MAN.glob('arbiter-*.1'):
            verb = page.stem.removeprefix('arbiter-')
            self.assertIn(f'arbiter-{verb} (1)', overview)
            self.assertTrue(re.search(rf"'{verb}'|man/{page.name}", build), page.name)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]], verbosity=2)
