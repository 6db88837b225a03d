#!/usr/bin/env python3
"""Tests `arbiter builder --screenshot` as a script runs it: without a display it writes a picture and exits.

usage: screenshot_command_test.py ARBITER GALLERY [UNITTEST ARGUMENT...]
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import screenshots


class Screenshot(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.png = self.folder / 'window.png'

    def run_builder(self, *words):
        environment = {name: value for name, value in os.environ.items()
                       if name not in ('DISPLAY', 'WAYLAND_DISPLAY', 'QT_QPA_PLATFORM')}
        environment.update(XDG_CONFIG_HOME=str(self.folder), XDG_STATE_HOME=str(self.folder),
                           XDG_CACHE_HOME=str(self.folder), ARBITER_GALLERY=GALLERY)
        return subprocess.run([ARBITER, 'builder', *map(str, words)], env=environment,
                              capture_output=True, text=True, timeout=120)

    def test_a_picture_of_the_size_that_was_asked_for(self):
        result = self.run_builder('--screenshot', self.png, '--size', '1024x700', 'gallery:twirl')
        self.assertEqual(result.returncode, 0, result.stderr)
        size, colourful = screenshots.size_of(self.png)
        self.assertEqual(size, (1024, 700))
        self.assertTrue(colourful)

    def test_a_wrong_program_is_shown_too(self):
        wrong = self.folder / 'wrong.fp'
        wrong.write_text('!!ARBfp1.0\nMOV result.color, bogus;\nEND\n')
        result = self.run_builder('--screenshot', self.png, wrong)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(screenshots.size_of(self.png)[0], (1280, 800))

    def test_panels_have_names(self):
        window = pathlib.Path(ARBITER).parents[1] / 'builder' / 'view' / 'arbiter-builder'
        environment = {**os.environ, 'QT_QPA_PLATFORM': 'offscreen', 'XDG_STATE_HOME': str(self.folder),
                       'XDG_CONFIG_HOME': str(self.folder), 'ARBITER_GALLERY': GALLERY}

        def start(*words):
            return subprocess.run([window, *map(str, words)], env=environment, capture_output=True,
                                  text=True, timeout=120)

        names = 'Program, Picture, Parameters, Textures, Scene'
        shown = ' '.join(start('--help').stdout.split())
        self.assertIn(names, shown)
        refused = start('--panel', 'nothing')
        self.assertEqual(refused.returncode, 1)
        self.assertIn(f'arbiter-builder: --panel nothing: the panels are {names}', refused.stderr)
        document = pathlib.Path(GALLERY) / 'twirl.fp'
        for name in ('Scene', 'scene'):
            result = start('--panel', name, '--screenshot', self.folder / f'{name}.png', document)
            self.assertEqual(result.returncode, 0, result.stderr)
        pictures = [screenshots.size_of(self.folder / f'{name}.png') for name in ('Scene', 'scene')]
        self.assertEqual(*pictures)

    def test_options_reach_the_window(self):
        def taken(*words):
            result = self.run_builder('--screenshot', self.png, *words, 'gallery:twirl')
            self.assertEqual(result.returncode, 0, (words, result.stderr))
            return self.png.read_bytes()

        light, traced = ('--colors', 'light'), ('--panel', 'Debug', '--pixel', '200,200')
        plain = taken(*light)
        self.assertNotEqual(taken('--colors', 'dark'), plain)
        for words in (('--panel', 'Scene'), ('--small',), ('--edit', 'END=># edited\nEND'), traced):
            self.assertNotEqual(taken(*light, *words), plain, words)
        self.assertNotEqual(taken(*light, *traced, '--watch', '12'), taken(*light, *traced))

    def test_both_commands_say_the_same_version(self):
        window = pathlib.Path(ARBITER).parents[1] / 'builder' / 'view' / 'arbiter-builder'
        command = subprocess.run([ARBITER, '--version'], capture_output=True, text=True)
        for word in ('--version', '-V'):
            shown = subprocess.run([window, word], capture_output=True, text=True,
                                   env={**os.environ, 'QT_QPA_PLATFORM': 'offscreen'})
            self.assertEqual(shown.returncode, 0)
            self.assertEqual(shown.stdout, command.stdout.replace('arbiter ', 'arbiter-builder '))

    def test_what_cannot_be_is_said(self):
        for words, said in (
                (('--screenshot', self.png, self.folder / 'none.fp'), 'none.fp'),
                (('--screenshot', self.png, '--size', '10x10', 'gallery:twirl'), 'WxH'),
                (('--screenshot', self.png, '--size', 'wide', 'gallery:twirl'), 'WxH'),
                (('--size', '640x480', 'gallery:twirl'), '--screenshot'),
                (('--watch', '3', '--screenshot', self.png, 'gallery:twirl'), '--watch needs --pixel'),
                (('--colors', 'pink', 'gallery:twirl'), 'light'),
                (('--panel', 'nothing', '--screenshot', self.png, 'gallery:twirl'), 'the panels are'),
                (('--screenshot', self.folder / 'no' / 'a.png', 'gallery:pass_through'),
                 'cannot be written'),
                (('gallery:twirl',), 'no display')):
            result = self.run_builder(*words)
            self.assertEqual(result.returncode, 1, (words, result.stderr))
            self.assertIn(said, result.stderr)
            self.assertFalse(self.png.exists())


if __name__ == '__main__':
    ARBITER, GALLERY = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
