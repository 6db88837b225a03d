#!/usr/bin/env python3
"""Checks what desktops read: the launcher, the store page, file types by their first bytes, thumbnails.

usage: desktop_files_test.py ARBITER METAINFO DOCUMENT [unittest arguments]
"""
import configparser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ARBITER, METAINFO, DOCUMENT = (os.path.abspath(path) for path in sys.argv[1:4])
MIME = '{http://www.freedesktop.org/standards/shared-mime-info}'

# The first line of a text of each type.
FIRST_LINES = {
    '!!ARBfp1.0': 'text/x-arb-fragment-program',
    '!!ARBvp1.0': 'text/x-arb-vertex-program',
    '!!ATIfs1.0': 'text/x-ati-fragment-shader',
    '!!FP1.0': 'text/x-nv-fragment-program',
    '!!VP1.0': 'text/x-nv-vertex-program',
    '!!VP1.1': 'text/x-nv-vertex-program',
    '!!VP2.0': 'text/x-nv-vertex-program',
    '!!VSP1.0': 'text/x-nv-vertex-program',
    '!!RC1.0': 'text/x-nv-register-combiners',
    '!!TS1.0': 'text/x-nv-texture-shaders',
    '#version 120': 'text/plain',
}
# The endings that captures, the compiler and the editors use, each for one type.
ENDINGS = {
    '.atifs': ('!!ATIfs1.0', 'text/x-ati-fragment-shader'),
    '.nvrc': ('!!RC1.0', 'text/x-nv-register-combiners'),
    '.nvts': ('!!TS1.0', 'text/x-nv-texture-shaders'),
    '.vsp': ('!!VSP1.0', 'text/x-nv-vertex-program'),
    '.vfp': ('!!ARBvp1.0', 'text/x-arb-program-pair'),
}


def needs(*commands):
    missing = [command for command in commands if not shutil.which(command)]
    return unittest.skipIf(missing, f'not installed: {", ".join(missing)}')


def entries(path, section):
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str
    parser.read(path)
    return parser[section]


def types_of(words):
    return {word for word in words.split(';') if word}


def content_type(path, environment):
    run = subprocess.run(['gio', 'info', '-a', 'standard::content-type', path], env=environment,
                         capture_output=True, text=True)
    return (re.search('standard::content-type: (.*)', run.stdout) or ['', run.stderr])[1]


class DesktopFiles(unittest.TestCase):
    def check(self, *command):
        run = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    @needs('desktop-file-validate')
    def test_the_launcher_is_valid(self):
        self.assertEqual(self.check('desktop-file-validate', HERE / 'arbiter-builder.desktop'), '')

    @needs('appstreamcli')
    def test_the_store_page_is_valid(self):
        self.check('appstreamcli', 'validate', '--no-net', METAINFO)

    def test_all_know_the_same_types(self):
        declared = {row.get('type') for row in
                    ElementTree.parse(HERE / 'arbiter-mime.xml').iter(f'{MIME}mime-type')}
        self.assertEqual(types_of(entries(HERE / 'arbiter-builder.desktop', 'Desktop Entry')['MimeType']), declared)
        self.assertEqual({row.text for row in ElementTree.parse(METAINFO).iter('mediatype')}, declared)
        thumbnails = types_of(entries(HERE / 'arbiter.thumbnailer', 'Thumbnailer Entry')['MimeType'])
        self.assertLess(thumbnails, declared)
        self.assertEqual({kind for kind in FIRST_LINES.values() if kind != 'text/plain'} |
                         {kind for _, kind in ENDINGS.values()}, declared)

    @needs('update-mime-database', 'gio')
    def test_a_text_is_known_by_its_first_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            packages = pathlib.Path(folder) / 'mime' / 'packages'
            packages.mkdir(parents=True)
            shutil.copy(HERE / 'arbiter-mime.xml', packages / 'arbiter.xml')
            subprocess.run(['update-mime-database', packages.parent], check=True, capture_output=True)
            environment = dict(os.environ, XDG_DATA_HOME=folder, XDG_DATA_DIRS='/usr/share')
            for line, kind in FIRST_LINES.items():
                for name in ('text', 'text.vp' if 'vertex' in kind else 'text.fp'):
                    if name != 'text' and kind.rpartition('-')[2] not in ('program', 'shader'):
                        continue  # the ending is all that is known of it
                    text = pathlib.Path(folder) / name
                    text.write_text(f'{line}\n# a program\nEND\n')
                    self.assertEqual(content_type(text, environment), kind, f'{line} in {name}')
            for ending, (line, kind) in ENDINGS.items():
                for first in (line, '# a comment'):
                    text = pathlib.Path(folder) / f'text{ending}'
                    text.write_text(f'{first}\n# a program\nEND\n')
                    self.assertEqual(content_type(text, environment), kind, f'{first} in {ending}')

    def test_the_thumbnailer_draws(self):
        command = entries(HERE / 'arbiter.thumbnailer', 'Thumbnailer Entry')['Exec'].split()
        self.assertEqual(command[0], 'arbiter')
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / 'thumbnail.png'
            for code, value in (('%i', DOCUMENT), ('%o', str(picture)), ('%s', '128')):
                command = [word.replace(code, value) for word in command]
            self.check(ARBITER, *command[1:])
            header = picture.read_bytes()[:24]
            self.assertEqual(header[:8], b'\x89PNG\r\n\x1a\n')
            self.assertEqual((int.from_bytes(header[16:20], 'big'), int.from_bytes(header[20:24], 'big')), (128, 128))


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=2)
