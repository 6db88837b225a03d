#!/usr/bin/env python3
"""Tests of documents from outside: `arbiter draw` and `arbiter check` of texts with a panel.

usage: command_document_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import os
import pathlib
import struct
import subprocess

import command_session
from command_draw_test import read_png, write_png
from command_session import ROOT, Temporary, arbiter

SHOW = '!!ARBfp1.0\n{}\nPARAM p = program.local[0];\nMOV result.color, p;\nEND\n'
SAMPLE = '!!ARBfp1.0\n{}\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n'


class Bare(Temporary):
    """Draws on the bare host; Layered repeats the tests through the layer."""
    words = ('--bare',)

    def draw(self, document, *options):
        self.output = self.path('out.png')
        return arbiter('draw', *self.words, document, *options, '-o', self.output)

    def pixels(self, document, *options):
        result = self.draw(document, *options)
        said = [line for line in result.stderr.splitlines() if 'alpha is not 1' not in line]
        self.assertEqual((result.returncode, said), (0, []))
        return read_png(self.output)

    def pixel(self, document, *options):
        return list(self.pixels(document, *options)[2][0][:4])

    def test_the_panel_says_how(self):
        document = self.path('a.fp', SHOW.format('#@ size 6 4\n#@ local[0] = 1 0.4 0.2 1'))
        width, height, rows = self.pixels(document)
        self.assertEqual((width, height), (6, 4))
        self.assertEqual(list(rows[0][:4]), [255, 102, 51, 255])

    def test_options_take_its_place(self):
        document = self.path('a.fp', SHOW.format('#@ size 6 4\n#@ local[0].x = 1, local[0].w = 1'))
        self.assertEqual(self.pixel(document, '--local', '0=0,1,0,1'), [0, 255, 0, 255])
        width, height, _ = self.pixels(document, '--size', '3x2')
        self.assertEqual((width, height), (3, 2))

    def test_a_frame_of_an_animation(self):
        document = self.path('a.fp', SHOW.format(
            '#@ size 2 2, rate 10\n#@ local[0].x = 0 in 0..1 animate saw 1s, local[0].w = 1'))
        self.assertEqual([self.pixel(document, '--frame', frame)[0] for frame in ('0', '4', '14')],
                         [0, 102, 102])

    def test_files_lie_beside_it(self):
        write_png(self.path('blue.png'), 1, 1, [b'\0\0\xff\xff'])
        self.path('half.vp', '!!ARBvp1.0\n#@ local[0] = 0.5 1 1 1\n'
                             'MUL result.position, vertex.position, program.local[0];\n'
                             'MOV result.texcoord[0], vertex.texcoord[0];\nEND\n')
        document = self.path('a.fp', SAMPLE.format(
            '#@ size 8 2, vertex half.vp, clear 1 0 0 1\n#@ texture 0 = blue.png, nearest'))
        _, _, rows = self.pixels(document)
        self.assertEqual([rows[0][4 * x:4 * x + 3] for x in range(8)],
                         [b'\xff\0\0'] * 2 + [b'\0\0\xff'] * 4 + [b'\xff\0\0'] * 2)

    def test_passes_and_targets(self):
        self.path('b.fp', SAMPLE.format('#@ texture 0 = picture t, nearest'))
        document = self.path('a.fp', SHOW.format(
            '#@ size 4 4, target t 2 2, then b.fp\n#@ local[0] = 0.2 0.4 0.6 1'))
        self.assertEqual(self.pixel(document), [51, 102, 153, 255])

    def test_a_pass_that_keeps_adds(self):
        self.path('b.fp', SHOW.format('#@ keep, blend add\n#@ local[0] = 0 0.2 0 0'))
        document = self.path('a.fp', SHOW.format('#@ size 2 2, then b.fp\n#@ local[0] = 0.2 0.4 0.6 1'))
        self.assertEqual(self.pixel(document), [51, 153, 153, 255])

    def test_smaller_levels_are_the_files(self):
        # The file has 8x8 red texels, then a green and two blue levels.
        header = bytearray(128)
        header[0:4] = b'DDS '
        for at, value in ((4, 124), (12, 8), (16, 8), (28, 4), (76, 32), (80, 0x41), (88, 32),
                          (92, 0xFF), (96, 0xFF00), (100, 0xFF0000), (104, 0xFF000000)):
            struct.pack_into('<I', header, at, value)
        levels = b'\xff\0\0\xff' * 64 + b'\0\xff\0\xff' * 16 + b'\0\0\xff\xff' * 5
        self.path('a.dds').write_bytes(bytes(header) + levels)
        for side, colour in ((8, [255, 0, 0, 255]), (4, [0, 255, 0, 255]), (2, [0, 0, 255, 255])):
            document = self.path('a.fp', SAMPLE.format(f'#@ size {side} {side}\n#@ texture 0 = a.dds, mipmap'))
            self.assertEqual(self.pixel(document), colour, side)
        document = self.path('a.fp', SAMPLE.format('#@ size 2 2\n#@ texture 0 = a.dds, linear'))
        self.assertEqual(self.pixel(document), [255, 0, 0, 255], 'without the word the first level')

    def test_a_volume_has_its_slices_below_each_other(self):
        slices = [b'\xff\0\0\xff', b'\0\xff\0\xff', b'\0\0\xff\xff', b'\xff\xff\xff\xff']
        write_png(self.path('slices.png'), 1, 4, slices)
        text = ('!!ARBfp1.0\n#@ size 2 2{}\nTEMP t;\nMOV t, fragment.texcoord[0];\n'
                'MOV t.z, program.local[0].x;\nTEX result.color, t, texture[0], 3D;\nEND\n')
        document = self.path('a.fp', text.format(', texture 0 = slices.png, nearest, edge'))
        for i, colour in enumerate(slices):
            self.assertEqual(self.pixel(document, '--local', f'0={(i + 0.5) / 4}'), list(colour))
        self.assertEqual(self.pixel(document, '--local', '0=7'), list(slices[3]), 'the edge in r')
        bare = self.path('b.fp', text.format(''))
        self.assertEqual(self.pixel(bare, '--texture', f"0={self.path('slices.png')}", '--local',
                                    '0=0.125'), list(slices[0]))
        # An image that is no stack of squares becomes one slice.
        write_png(self.path('wide.png'), 2, 1, [b'\xff\0\0\xff\0\0\xff\xff'])
        document = self.path('c.fp', text.format(', texture 0 = wide.png, nearest'))
        self.assertEqual(self.pixel(document, '--local', '0=0.9'), list(slices[0]))
        result = self.draw(self.path('d.fp', text.format(', texture 0 = feedback of checker')))
        self.assertEqual(result.returncode, 2)
        self.assertIn('samples texture[0] as 3D, and this is a 2D image', result.stderr)

    def test_a_mesh_from_a_file(self):
        # The triangle covers the lower left half; its texture coordinates give red.
        mesh = self.path('a.obj', 'v 3 3 0\nv 5 3 0\nv 3 5 0\nvt 1 0\nvt 1 0\nvt 1 0\nf 1/1 2/2 3/3\n')
        text = '!!ARBfp1.0\n#@ size 8 8, {}\nMOV result.color, fragment.texcoord[0];\nEND\n'
        for document, options in ((self.path('a.fp', text.format('mesh a.obj fit 1')), ()),
                                  (self.path('b.fp', text.format('mesh a.obj at -4 -4 0')), ())):
            _, _, rows = self.pixels(document, *options)
            self.assertEqual(list(rows[6][4:8]), [255, 0, 0, 255])
            self.assertEqual(list(rows[1][24:28]), [0, 0, 0, 0])
        small = self.path('c.obj', mesh.read_text().replace('3', '-1').replace('5', '1'))
        _, _, rows = self.pixels(self.path('c.fp', text.format('mesh cube')), '--mesh', small)
        self.assertEqual((list(rows[6][4:8]), list(rows[1][24:28])), ([255, 0, 0, 255], [0, 0, 0, 0]))
        self.path('a.obj', 'v 0 0 0\nf 1 2 3\n')
        result = self.draw(document)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r'b\.fp:2:19: error: .*a\.obj: face 1 names vertex 2 of 1')

    def test_the_gallery_by_name(self):
        small = ('--size', '16x16')
        path = self.pixels(ROOT / 'demos' / 'gallery' / 'twirl.fp', *small)
        self.assertEqual(self.pixels('gallery:twirl', *small), path)
        for name, said in (('twir', 'did you mean gallery:twirl?'), ('zzzzzzzz', 'it has ati_bumps, '),
                           ('../gallery/twirl', 'no such document'), ('', 'no such document')):
            result = self.draw('gallery:' + name)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(said, result.stderr)
        self.assertNotIn('fur_fins', self.draw('gallery:zzzzzzzz').stderr, 'that is a pass of fur')

    def test_feedback_counts_frames(self):
        text = ('!!ARBfp1.0\n#@ size 4 4\n#@ texture 0 = feedback of constant r 0.2 g 0 b 0, nearest\n'
                'TEMP a;\nTEX a, fragment.texcoord, texture[0], 2D;\n'
                'ADD result.color, a, {0.0392156862745, 0, 0, 1};\nEND')
        self.assertEqual(self.pixel(self.path('a.fp', text), '--frame', '3')[0], 51 + 40)

    def test_a_folder(self):
        folder = self.path('life')
        folder.mkdir()
        (folder / 'life.fp').write_text(SHOW.format('#@ size 2 2\n#@ local[0] = 0 0 1 1'))
        self.assertEqual(self.pixel(folder), [0, 0, 255, 255])
        empty = self.path('empty')
        empty.mkdir()
        result = self.draw(empty)
        self.assertEqual(result.returncode, 1)
        self.assertIn('no document', result.stderr)

    def test_what_was_drawn_as_json(self):
        document = self.path('a.fp', SHOW.format('#@ size 5 3\n#@ local[0] = 0 0 1 1'))
        command = [os.path.abspath(command_session.ARBITER), 'draw', *self.words, str(document), '--json']
        result = subprocess.run(command, cwd=self.folder.name, capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        said = json.loads(result.stdout)
        self.assertEqual((said['width'], said['height'], said['passes'], said['picture']),
                         (5, 3, 1, 'a.png'))
        self.assertEqual(read_png(self.path('a.png'))[:2], (5, 3), 'the name without -o')

    def test_unknown_words_warn_and_draw(self):
        document = self.path('a.fp', SHOW.format('#@ sise 6 4, size 2 2\n#@ local[0] = 0 1 0 1'))
        result = self.draw(document)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(result.stderr.startswith(f"{document}:2:4: warning: 'sise' is no word"),
                        result.stderr)
        self.assertIn("did you mean 'size'?", result.stderr)
        self.assertEqual(read_png(self.output)[:2], (2, 2))

    def test_wrong_lines_are_told_with_their_place(self):
        for panel, place, said in (
                ('#@ size 2', '2:10', 'expected a height'),
                ('#@ texture 0 = none.png', '2:16', 'none.png'),
                ('#@ texture 0 = sky', '2:16', 'samples texture[0] as 2D, and this is a cube map'),
                ('#@ vertex none.vp', '2:11', 'none.vp'),
                ('#@ mesh shells count 64 of sphere parts 512', '2:9', 'vertices'),
                ('#@ texture 0 = picture q', '2:24', 'no pass draws into a target')):
            result = self.draw(self.path('a.fp', SAMPLE.format(panel)))
            self.assertEqual(result.returncode, 2, (panel, result.stderr))
            first = result.stderr.splitlines()[0]
            self.assertIn(f'a.fp:{place}: error: ', first, panel)
            self.assertIn(said, first)
            self.assertIn('^', result.stderr)
            self.assertFalse(self.output.exists())

    def test_a_wrong_program_of_a_pass_is_named(self):
        self.path('b.fp', '!!ARBfp1.0\nMOV result.color, q;\nEND\n')
        document = self.path('a.fp', SHOW.format('#@ size 2 2, then b.fp\n#@ local[0] = 1'))
        result = self.draw(document)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r'/b\.fp:2:\d+: error: ')


class Layered(Bare):
    words = ()

    def test_parameters_are_the_profiles(self):
        result = self.draw(self.path('a.fp', SAMPLE.format('#@ local[900] = 1')))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn('a.fp:2:4: error: ', result.stderr.splitlines()[0])
        self.assertIn('local parameters', result.stderr)

    def test_units_are_the_profiles(self):
        result = self.draw(self.path('a.fp', SAMPLE.format('#@ profile r300\n#@ texture 31 = noise')))
        self.assertEqual(result.returncode, 2)
        self.assertIn('a.fp:3:12: error: texture 31: there are 16 texture image units', result.stderr)

    def test_its_profile_and_numerics_hold(self):
        long = 'TEMP a;\nMOV a, fragment.color;\n' + 'ADD a, a, a;\n' * 70 + 'MOV result.color, a;\nEND\n'
        document = self.path('a.fp', '!!ARBfp1.0\n#@ size 2 2, profile r300\n' + long)
        self.assertEqual(self.draw(document).returncode, 2)
        self.assertEqual(self.draw(document, '--profile', 'host').returncode, 0)
        document = self.path('b.fp', '!!ARBfp1.0\n#@ size 2 2, profile host\n' + long)
        self.assertEqual(self.draw(document).returncode, 0)
        result = arbiter('draw', '-', '-o', self.path('c.png'), text=document.read_text())
        self.assertEqual(result.returncode, 0, 'from standard input too: ' + result.stderr)
        document = self.path('d.fp', '!!ARBfp1.0\n#@ size 2 2, profile nowhere\n' + long)
        result = self.draw(document)
        self.assertEqual(result.returncode, 2, 'a word without a meaning: the default holds')
        self.assertIn('d.fp:2:22: warning: this profile is unknown', result.stderr)

    def test_late_machine_code_changes_no_picture(self):
        # The host's twirl and the rasterizer's may differ by one level, so that both pictures must be the rasterizer's.
        small = ('gallery:twirl', '--size', '16x16')
        self.assertEqual(self.pixels(*small, '--debug', 'late-code'), self.pixels(*small))


class Check(Temporary):
    def test_panels_are_checked(self):
        document = self.path('a.fp', SHOW.format('#@ size 2 2, blend ad\n#@ local[0] = 1 2 3 4 5'))
        result = arbiter('check', document)
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn('a.fp:2:20: warning: ', result.stdout)
        self.assertIn('a.fp:3:23: error: more numbers than components [panel_syntax]', result.stdout)
        found = json.loads(arbiter('check', '--json', document).stdout)['files'][0]
        self.assertEqual(found['status'], 'invalid')
        self.assertEqual([each['id'] for each in found['diagnostics']], ['panel_word', 'panel_syntax'])

    def test_files_beside_are_looked_for(self):
        document = self.path('a.fp', SHOW.format('#@ then b.fp'))
        self.assertEqual(arbiter('check', document).returncode, 2)
        self.path('b.fp', SHOW.format(''))
        self.assertEqual(arbiter('check', document).returncode, 0)

    def test_images_and_meshes_are_looked_for(self):
        document = self.path('a.fp', SAMPLE.format('#@ mesh shells count 2 of none.obj\n'
                                                   '#@ texture 0 = normals strength 1 of none.png'))
        result = arbiter('check', document)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stdout, r'a\.fp:2:27: error: .*/none\.obj: .*\[panel_file\]')
        self.assertRegex(result.stdout, r'a\.fp:3:38: error: .*/none\.png: .*\[panel_file\]')

    def test_a_part_is_checked_with_its_document(self):
        part = self.path('part.fp', SAMPLE.format('#@ texture 0 = picture drawn, vertex part.vp'))
        vertex = self.path('part.vp', '!!ARBvp1.0\n#@ env[0..3] = camera drawn\n'
                                      'MOV result.position, vertex.position;\nEND\n')
        alone = arbiter('check', part)
        self.assertEqual(alone.returncode, 2)
        self.assertIn("no pass draws into a target 'drawn'", alone.stdout)
        # A document that names the part, but has no such target, does not supply it.
        other = self.path('a.fp', SHOW.format('#@ then part.fp'))
        self.assertEqual(arbiter('check', part).returncode, 2)
        main = self.path('main.fp', SHOW.format('#@ target drawn 4 4, then part.fp'))
        for file in (part, vertex, main):
            result = arbiter('check', file)
            self.assertEqual((result.returncode, 'panel' in result.stdout), (0, False), result.stdout)
        other.unlink()
        part.write_text(part.read_text().replace('picture drawn', 'picture drawm'))
        result = arbiter('check', part)
        self.assertEqual(result.returncode, 2)
        self.assertIn("no pass draws into a target 'drawm'", result.stdout)
        self.assertIn('there is drawn', result.stdout)

    def test_the_gallery_is_right(self):
        files = sorted((ROOT / 'demos' / 'gallery').glob('*.?p'))
        self.assertGreaterEqual(len(files), 30)
        result = arbiter('check', '--json', *files)
        for file in json.loads(result.stdout)['files']:
            self.assertEqual((file['diagnostics'], file['status']), ([], 'valid'),
                             pathlib.Path(file['file']).name)


if __name__ == '__main__':
    command_session.main()
