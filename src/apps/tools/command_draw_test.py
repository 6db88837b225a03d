#!/usr/bin/env python3
"""Tests of `arbiter draw` from outside, on the bare host and through the layer: its pictures.

usage: command_draw_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import pathlib
import struct
import zlib

import command_session
from command_session import BAD, GOOD, PROGRAMS, ROOT, Temporary, alu, arbiter


def read_png(path):
    """Returns width, height and RGBA rows from the top of an 8-bit RGBA file of libpng."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b'\x89PNG\r\n\x1a\n'
    at, packed, size = 8, b'', None
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b'IHDR':
            size = struct.unpack('>II', body[:8])
            assert body[8:10] == b'\x08\x06', 'not 8-bit RGBA'
        elif kind == b'IDAT':
            packed += body
        at += 12 + length
    raw, rows, above = zlib.decompress(packed), [], bytearray(4 * size[0])
    stride = 4 * size[0]
    for y in range(size[1]):
        start = y * (stride + 1)
        method, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for x in range(stride):
            left = row[x - 4] if x >= 4 else 0
            up, corner = above[x], above[x - 4] if x >= 4 else 0
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda value: abs(guess - value))
            row[x] = (row[x] + (0, left, up, (left + up) // 2, paeth)[method]) & 255
        rows.append(bytes(row))
        above = row
    return size[0], size[1], rows


def write_png(path, width, height, rows):
    def chunk(kind, body):
        return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    packed = zlib.compress(b''.join(b'\0' + row for row in rows))
    pathlib.Path(path).write_bytes(
        b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)) +
        chunk(b'IDAT', packed) + chunk(b'IEND', b''))


class Draw(Temporary):
    """Draws on the bare host; Layered repeats the tests through the layer."""
    words = ('--bare',)

    def draw(self, text, *options, size='8x4'):
        self.output = self.path('out.png')
        return arbiter('draw', *self.words, '--size', size, *options, '-', '-o', self.output,
                       text=text)

    def pixels(self, text, *options, size='8x4'):
        result = self.draw(text, *options, size=size)
        self.assertEqual(result.returncode, 0, result.stderr)
        return read_png(self.output)

    def test_coordinates_run_up_and_right(self):
        width, height, rows = self.pixels('!!ARBfp1.0\nMOV result.color, fragment.texcoord[3];\nEND',
                                          size='4x2')
        self.assertEqual((width, height), (4, 2))
        # The top row has the larger t: (0.5 + 1) / 2 of 255.
        self.assertEqual([list(row[:2]) for row in rows], [[32, 191], [32, 64]])
        self.assertEqual(rows[0][12], 223)

    def test_parameters(self):
        _, _, rows = self.pixels(
            '!!ARBfp1.0\nADD result.color, program.local[2], program.env[1];\nEND',
            '--local', '2=0.2,0,0.4,0.5', '--env', '1=0.2,0.6')
        self.assertEqual(list(rows[0][:4]), [102, 153, 102, 128])

    def test_a_texture_is_upright(self):
        image = self.path('in.png')
        colours = [b'\xff\0\0\xff', b'\0\xff\0\xff', b'\0\0\xff\xff', b'\xff\xff\xff\xff']
        write_png(image, 2, 2, [colours[0] + colours[1], colours[2] + colours[3]])
        _, _, rows = self.pixels('!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[1], 2D;'
                                 '\nEND', '--texture', f'1={image}', size='2x2')
        self.assertEqual(rows, [colours[0] + colours[1], colours[2] + colours[3]])

    def test_feedback(self):
        # The picture starts black, and each frame adds 10/255 to the last.
        text = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord, texture[0], 2D;\n'
                'ADD result.color, a, {0.0392156862745, 0, 0, 1};\nEND')
        _, _, rows = self.pixels(text, '--feedback', '0', '--frames', '5')
        self.assertEqual(set(rows[0][0::4]), {50})

    def test_invalid_program(self):
        result = self.draw(BAD)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r'^<stdin>:\d+:\d+: error: ')
        self.assertIn('^', result.stderr)
        self.assertFalse(self.output.exists())

    def test_a_vertex_program_moves_a_mesh(self):
        vertex = self.path('half.vp', '!!ARBvp1.0\nMUL result.position, vertex.position, {0.5, 1, 1, 1};\n'
                                      'MOV result.color, program.local[3];\nEND\n')
        for words in ((vertex,), ('--mesh', 'grid', '-', vertex)):
            local = ('--local', ('vp:' if '-' in words else '') + '3=0,1,0,1')
            result = arbiter('draw', *self.words, '--size', '8x4', '--opaque', *local, *words, '-o',
                             self.path('out.png'), text=GOOD)
            self.assertEqual((result.returncode, result.stderr), (0, ''))
            _, _, rows = read_png(self.path('out.png'))
            row = [rows[1][4 * x:4 * x + 3] for x in range(8)]
            self.assertEqual(row, [b'\0\0\0'] * 2 + [b'\0\xff\0'] * 4 + [b'\0\0\0'] * 2)

    def test_attributes(self):
        vertex = self.path('a.vp', '!!ARBvp1.0\nMOV result.position, vertex.attrib[0];\n'
                                   'MAD result.color, vertex.attrib[8], {1, 1, 0, 0}, vertex.attrib[6];\nEND\n')
        result = arbiter('draw', *self.words, '--size', '4x2', '--attrib', '6=0,0,0.2,1', vertex, '-o',
                         self.path('out.png'))
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        _, _, rows = read_png(self.path('out.png'))
        self.assertEqual(list(rows[0][:4]), [32, 191, 51, 255])

    def test_a_sphere_is_round(self):
        _, _, rows = self.pixels(GOOD, '--mesh', 'sphere', size='16x16')
        self.assertEqual(rows[0][:3], b'\0\0\0')
        middle = rows[8][4 * 8:4 * 8 + 3]
        self.assertTrue(abs(middle[0] - 128) < 12 and abs(middle[1] - 128) < 12, list(middle))

    def test_alpha_that_viewers_mix_is_said(self):
        text = '!!ARBfp1.0\nMOV result.color, {1, 0.2, 0, 0.4};\nEND\n'
        said = (f'arbiter draw: {self.path("out.png")}: alpha is not 1 everywhere, and viewers mix such pixels with '
                'a background; --opaque writes 1\n')
        for options, stderr, alpha in (((), said, 102), (('--opaque',), '', 255)):
            result = self.draw(text, *options)
            self.assertEqual((result.returncode, result.stderr), (0, stderr))
            _, _, rows = read_png(self.output)
            self.assertEqual(set(zip(*[iter(rows[0])] * 4)), {(255, 51, 0, alpha)}, options)
        # One step of 255 cannot be seen, and around a mesh a background is expected.
        for quiet, options in ((text.replace('0.4', '1'), ()), (text.replace('0.4', '0.997'), ()),
                               (text.replace('0.4', '1'), ('--mesh', 'sphere'))):
            self.assertEqual(self.draw(quiet, *options, size='16x16').stderr, '', (quiet, options))
        self.assertEqual(self.draw(text, '--mesh', 'sphere', size='16x16').stderr, said)

    def test_images_by_a_word(self):
        sampling = '!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[0], 2D;\nEND\n'
        seen = {word: self.pixels(sampling, '--texture', f'0={word}', size='16x16')[2]
                for word in ('checker', 'clouds', 'landscape', 'bricks')}
        self.assertEqual(len({b''.join(rows) for rows in seen.values()}), len(seen))
        document = self.path('document.fp', sampling.replace('\n', '\n#@ texture 0 = landscape\n', 1))
        result = arbiter('draw', *self.words, '--size', '16x16', document, '-o', self.path('out.png'))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(read_png(self.path('out.png'))[2], seen['landscape'])
        for word, said in (('landscap', 'there is no such file; did you mean landscape?'),
                           ('sky', 'a document alone can have that image: #@ texture N = sky'),
                           ('qqq', 'there is no such file, and no such word; words are constant, checker, ')):
            result = self.draw(sampling, '--texture', f'0={word}')
            self.assertEqual(result.returncode, 1)
            self.assertIn(f'arbiter draw: --texture 0={word}: {said}', result.stderr)

    def test_a_picture_among_the_programs(self):
        program, picture = self.path('a.fp', GOOD), self.path('b.png')
        for there in (False, True):
            if there:
                picture.write_bytes(b'old')
            result = arbiter('draw', *self.words, program, picture)
            self.assertEqual((result.returncode, result.stderr),
                             (1, f'arbiter draw: {picture} is no program: -o {picture} writes the picture there, '
                                 f'--texture N={picture} reads it\n'))
        self.assertEqual(picture.read_bytes(), b'old')

    def test_what_has_no_effect_is_an_error(self):
        sampling = '!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[0], {};\nEND\n'
        for text, options, said in (
                (GOOD, ('--texture', '3=checker'),
                 '--texture 3=checker has no effect: no program samples a texture'),
                (sampling.format('2D'), ('--texture', '1=noise'),
                 '--texture 1=noise has no effect: <stdin> samples texture[0] as 2D'),
                (sampling.format('CUBE'), ('--texture', '0=checker'),
                 '--texture 0=checker: <stdin> samples texture[0] as CUBE, and this is a 2D image'),
                (sampling.format('RECT'), ('--feedback', '0', '--frames', '2'),
                 '--feedback 0: <stdin> samples texture[0] as RECT, and this is a 2D image'),
                (sampling.format('2D'), ('--feedback', '0'), '--feedback 0 has no effect on one frame'),
                (GOOD, ('--local', '0=1'), '--local 0=1 has no effect: no program reads program.local[0]'),
                (GOOD, ('--env', 'vp:2=1'),
                 '--env vp:2=1 has no effect: no vertex program reads program.env[2]'),
                (GOOD, ('--attrib', '1=1'), 'no program reads vertex.attrib[1]'),
                (GOOD, ('--mesh', 'grid'), '--mesh grid has no effect without a vertex program'),
                (sampling.format('2D'), ('--texture', '0=noise', '--texture', '0=checker'),
                 '--texture 0 is given twice')):
            result = self.draw(text, *options)
            self.assertEqual(result.returncode, 1, (options, result.stderr))
            self.assertIn(said, result.stderr)
            self.assertFalse(self.output.exists())

    def test_a_sample_without_an_image_is_said(self):
        result = self.draw('!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[2], CUBE;\nEND\n')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, 'arbiter draw: <stdin>: texture[2] (CUBE) has no image, so a '
                                        'checker with its number stands in for one\n')

    def test_the_number_of_a_unit_without_an_image_is_drawn(self):
        """The checker shows the number at one texel per pixel: 7 is a bar with a stroke down from its right end."""
        white, purple, grey = b'\xff' * 4, bytes((128, 26, 128, 255)), bytes((51, 51, 51, 255))
        for target, coordinate in (('2D', 'texcoord[0]'), ('RECT', 'position'), ('3D', 'texcoord[0]')):
            result = self.draw(f'!!ARBfp1.0\nTEX result.color, fragment.{coordinate}, texture[7], '
                               f'{target};\nEND\n', size='64x64')
            self.assertEqual(result.returncode, 0, result.stderr)
            rows = read_png(self.output)[2][::-1]
            pixels = [[row[at:at + 4] for at in range(0, 256, 4)] for row in rows]  # from the bottom
            self.assertEqual({each for row in pixels for each in row}, {white, purple, grey}, target)
            # A dot has five texels, and the digit has five by seven dots about the middle.
            self.assertEqual([x for x in range(64) if pixels[46][x] == white], list(range(19, 44)), target)
            self.assertEqual([x for x in range(64) if pixels[31][x] == white], list(range(29, 34)), target)
            self.assertNotIn(white, pixels[12] + pixels[50], target)

    def test_two_programs_of_one_stage(self):
        first, second = self.path('a.fp', GOOD), self.path('b.fp', GOOD)
        result = arbiter('draw', *self.words, first, second, '-o', self.path('out.png'))
        self.assertEqual(result.returncode, 1)
        self.assertIn('are both programs of fragments', result.stderr)
        result = arbiter('draw', *self.words, first, '-o', first)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(first.read_text(), GOOD)

    def test_a_file_that_is_not_there_is_named(self):
        sampling = '!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n'
        seen = self.draw(sampling, '--texture', '0=/none.png')
        self.assertEqual((seen.returncode, seen.stderr),
                         (1, 'arbiter draw: --texture 0: /none.png: No such file or directory\n'))
        for name, text, why in (('a.fp', GOOD, 'is no PNG, JPEG or DDS file'), ('b.png', '', 'is no whole PNG file'),
                                ('c.png', 'junk', 'is no whole PNG file')):
            image = self.path(name, text)
            self.assertEqual(self.draw(sampling, '--texture', f'0={image}').stderr,
                             f'arbiter draw: --texture 0: {image}: {why}\n')
        mesh = self.path('empty.obj', 'v 1\n')
        seen = self.draw(GOOD, '--mesh', mesh)
        self.assertEqual((seen.returncode, seen.stderr), (1, f'arbiter draw: {mesh}: it has no face\n'))
        seen = self.draw(GOOD, '--texture', '99=checker')
        self.assertRegex(seen.stderr, '^arbiter draw: --texture 99')

    def test_usage_errors(self):
        for options in (('--texture', '0'), ('--texture', 'x=checker'), ('--texture', '0=/none.png'),
                        ('--local', '0=1,2,3,4,5'), ('--local', '0=a'), ('--env', '0:1'),
                        ('--frames', '0'), ('--texture', '99=checker'), ('--local', '99999=1'),
                        ('--feedback', '0', '--texture', '0=checker')):
            result = self.draw(GOOD, *options)
            self.assertEqual(result.returncode, 1, (options, result.stderr))
        for size in ('8', '0x8', '8x99999', '-1x2', 'axb'):
            self.assertEqual(self.draw(GOOD, size=size).returncode, 1, size)
        self.assertEqual(arbiter('draw', *self.words, '-o', '/nowhere/x.png', '-',
                                 text=GOOD).returncode, 1)
        for name in (self.path('x.jpg'), '-'):
            result = arbiter('draw', *self.words, '-o', name, self.path('a.fp', GOOD))
            self.assertEqual((result.returncode, result.stderr),
                             (1, f'arbiter draw: {name}: a picture is a PNG, in a file with the ending .png\n'))
            self.assertFalse(pathlib.Path(name).exists())


class Layered(Draw):
    words = ()

    def test_invalid_program_names_the_byte(self):
        self.assertTrue(self.draw(BAD).stderr.startswith('<stdin>:3:19: error: '))

    def test_limits_are_the_profiles(self):
        self.assertEqual(self.draw(alu(65)).returncode, 2)
        self.assertEqual(self.draw(alu(65), '--limits', 'report').returncode, 0)
        self.assertEqual(self.draw(GOOD, '--texture', '16=checker').returncode, 1)

    def test_a_card_without_fragment_programs_is_said_once(self):
        said = 'nv25: the card has no fragment programs'
        result = self.draw(GOOD, '--profile', 'geforce4')
        self.assertEqual((result.returncode, result.stderr.count(said)), (0, 1), result.stderr)
        self.assertNotIn(said, self.draw(GOOD).stderr)

    def test_the_statistics_agree_with_check(self):
        stats = self.path('stats.json')
        for program in ('life_naive.fp', 'life_packed.fp', 'lighting.fp'):
            text = (PROGRAMS / program).read_text()
            self.assertEqual(self.draw(text, '--stats', stats).returncode, 0)
            seen = json.loads(stats.read_text())
            header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
            self.assertIn(f'ARBITER_STATS_SCHEMA {seen["schema"]}\n', header)
            drawn = [seen['draws'][path] for path in ('host_glsl', 'host_assembly', 'rasterizer')]
            self.assertEqual(sum(drawn), 1)
            checked = json.loads(arbiter('check', '--json', '-', text=text).stdout)['files'][0]
            loaded = seen['programs'][0]
            self.assertEqual(loaded['hash'], checked['hash'])
            counts = dict(loaded['counts'])
            # The statistics have one row for all languages; a fragment program has no such register.
            self.assertEqual(counts.pop('address_registers'), 0)
            self.assertEqual(list(counts.values()),
                             [row['used'] for row in checked['counts'].values()], program)

    def test_an_ati_shader(self):
        image = self.path('in.png')
        write_png(image, 1, 1, [b'\x10\x20\x30\xff'])
        text = '!!ATIfs1.0\nStartOutputPass;\nSampleMap r0, t0.str;\nMOV r0, r0;\nEndPass;\n'
        _, _, rows = self.pixels(text, '--texture', f'0={image}', size='2x2')
        self.assertEqual(rows[0][:4], b'\x10\x20\x30\xff')

    def test_a_refused_vertex_program_is_named(self):
        vertex = self.path('bad.vp', '!!ARBvp1.0\nMOV result.position, q;\nEND\n')
        result = arbiter('draw', *self.words, '-', vertex, '-o', self.path('out.png'), text=GOOD)
        self.assertEqual(result.returncode, 2)
        self.assertTrue(result.stderr.startswith(f'{vertex}:2:22: error: '), result.stderr)

    def test_never_the_bare_hosts_picture(self):
        result = arbiter('draw', '--in-layer', '-', '-o', self.path('x.png'), text=GOOD)
        self.assertEqual(result.returncode, 6)
        self.assertIn('not loaded', result.stderr)


if __name__ == '__main__':
    command_session.main()
