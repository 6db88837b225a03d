#!/usr/bin/env python3
"""Installs the build tree, moves the installation as a whole, and uses it from there.

usage: install_test.py BUILD PREFIX LIBDIR CXX   (PREFIX and LIBDIR as configured)
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

BUILD, PREFIX, LIBDIR, CXX = sys.argv[1:5]


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix='arbiter-install-')
        cls.addClassCleanup(cls.folder.cleanup)
        first, moved = (pathlib.Path(cls.folder.name) / name for name in ('first', 'moved'))
        subprocess.run(['meson', 'install', '-C', BUILD, '--no-rebuild', '--quiet'], check=True,
                       env={**os.environ, 'DESTDIR': str(first)}, stdout=subprocess.DEVNULL)
        shutil.move(first, moved)
        cls.prefix = moved / PREFIX.lstrip('/')
        cls.environment = plain()

    def run_it(self, *words):
        result = subprocess.run([str(word) for word in words], capture_output=True, text=True,
                                env=self.environment, timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def package(self, *words):
        folder = self.prefix / LIBDIR / 'pkgconfig'
        return subprocess.run(['pkg-config', f'--define-variable=prefix={self.prefix}', *words,
                               'arbiter'], capture_output=True, text=True, check=True,
                              env={**self.environment, 'PKG_CONFIG_PATH': str(folder)}
                              ).stdout.strip()

    def test_draws_through_the_moved_layer(self):
        stats = pathlib.Path(self.folder.name) / 'stats.json'
        picture = pathlib.Path(self.folder.name) / 'picture.png'
        program = self.prefix / 'share' / 'arbiter' / 'programs' / 'pass_through.fp'
        self.run_it(self.prefix / 'bin' / 'arbiter', 'draw', '--size', '16x16', '--texture',
                    '0=checker', '--stats', stats, program, '-o', picture)
        self.assertTrue(picture.read_bytes().startswith(b'\x89PNG'))
        draws = json.loads(stats.read_text())['draws']
        self.assertEqual(draws['host_glsl'] + draws['host_assembly'] + draws['rasterizer'], 1)

    def test_the_gallery_is_there_and_known_by_name(self):
        folder = self.prefix / 'share' / 'arbiter' / 'gallery'
        picture = pathlib.Path(self.folder.name) / 'fur.png'
        arbiter = self.prefix / 'bin' / 'arbiter'
        said = json.loads(self.run_it(arbiter, 'draw', 'gallery:fur', '--size', '32x32', '--json', '-o', picture))
        self.assertEqual(pathlib.Path(said['document']).resolve(), (folder / 'fur.fp').resolve(),
                         'not one of the source tree')
        self.assertEqual(said['passes'], 2)
        files = sorted(folder.glob('*.?p'))
        self.assertGreaterEqual(len(files), 30)
        self.run_it(arbiter, 'check', '--brief', *files)
        self.run_it(arbiter, 'check', '--brief', 'gallery:shadow_map')
        self.run_it(arbiter, 'debug', 'gallery:twirl', '--pixel', '9,9')

    def test_defaults_of_programs_are_found_by_both(self):
        """The command finds them, and so does the layer in a process."""
        folder = (self.prefix / 'share/arbiter/defaults.d').resolve()
        listed = json.loads(self.run_it(self.prefix / 'bin/arbiter', 'defaults', '--json'))
        self.assertEqual({pathlib.Path(each['file']).resolve().parent for each in listed['entries']}, {folder})
        game, stats = (pathlib.Path(self.folder.name) / name for name in ('quake2', 'quake2.json'))
        shutil.copy(self.prefix / 'bin/arbiter', game)
        library = self.prefix / LIBDIR / 'arbiter/libGLX_arbiter.so.0'
        program = self.prefix / 'share/arbiter/programs/pass_through.fp'
        self.run_it('env', f'LD_PRELOAD={library}', f'ARBITER_STATS={stats}', game, 'draw', '--in-layer', '--size',
                    '16x16', '--texture', '0=checker', program, '-o', pathlib.Path(self.folder.name) / 'q.png')
        setting = json.loads(stats.read_text())['defaults']['settings']['extensions_max_length']
        self.assertEqual((setting['value'], pathlib.Path(setting['file']).resolve().parent), ('4079', folder))

    def test_one_environment_serves_processes_of_both_widths(self):
        folder = self.prefix / LIBDIR / 'arbiter' / 'preload'
        if not folder.is_dir():
            self.skipTest('the loader has no folder of both widths here')
        said = self.run_it(self.prefix / 'bin' / 'arbiter', 'run', '--', 'env').splitlines()
        self.assertIn(f'LD_PRELOAD={folder}/$LIB/libGLX_arbiter.so.0', said)
        of_32_bits = folder / 'lib' / 'i386-linux-gnu'
        if of_32_bits.is_dir() and folder.parent.parent.name == 'x86_64-linux-gnu':
            self.assertEqual((folder / 'lib32').resolve(), of_32_bits.resolve(), "libc6-i386's folder of libraries")
        files = list(folder.rglob('libGLX_arbiter.so.0'))
        widths = {path.read_bytes()[4] for path in files}
        self.assertEqual(widths, {1, 2}, 'ELF files of 32 and of 64 bits')
        for path in files:
            if path.is_symlink():
                self.assertTrue((path.parent / 'libarbiter_first.so').is_file(), 'found where the layer is')

    def test_pkg_config_leads_to_the_files(self):
        self.assertTrue(pathlib.Path(self.package('--variable=preload')).is_file())
        self.assertTrue((pathlib.Path(self.package('--variable=osmesadir')) / 'libOSMesa.so.8')
                        .is_file())

    def test_the_header_is_c_and_carries_the_version(self):
        source = pathlib.Path(self.folder.name) / 'use.c'
        source.write_text('#include <GL/arbiter.h>\n#include <GL/arbiter.h>\n'
                          'const char *preload = ARBITER_PRELOAD_LIBRARY;\n'
                          'char check[ARBITER_VERSION > 0 ? 1 : -1];\n')
        subprocess.run([CXX, '-x', 'c', '-std=c89', '-pedantic-errors', '-Wall', '-Werror',
                        '-fsyntax-only', *self.package('--cflags').split(), str(source)],
                       check=True)
        version = self.run_it(self.prefix / 'bin' / 'arbiter', '--version').split()[1]
        self.assertEqual(self.package('--modversion'), version)

    def test_manuals(self):
        for name in ('arbiter.1', 'arbiter-check.1', 'arbiter-doctor.1', 'arbiter.7', 'arbiter-defaults.5'):
            page = self.prefix / 'share' / 'man' / f'man{name[-1]}' / name
            self.assertTrue(page.is_file(), page)

    def test_completions(self):
        share = self.prefix / 'share'
        for name in ('bash-completion/completions/arbiter', 'fish/vendor_completions.d/arbiter.fish'):
            self.assertTrue((share / name).is_file(), name)
        self.assertEqual(len(list((share / 'zsh').glob('*/_arbiter'))), 1)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]], verbosity=2)
