#!/usr/bin/env python3
"""Tests of `arbiter debug` from outside, through the layer: traces, verdicts, planted mistakes.

usage: command_debug_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import random

import command_session
from command_draw_test import read_png, write_png
from command_session import BAD, ROOT, VERTEX, Temporary, arbiter, on_terminal

GALLERY = ROOT / 'demos' / 'gallery'
PANEL = '#@ size 16 8, mesh quad, camera none\n#@ texture 0 = clouds 64 64, linear, repeat\n'
SIMPLE = ('!!ARBfp1.0\n' + PANEL + '#@ local[0] = 0.5 0.25 0.125 1\n'
          'TEMP a;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n'
          'MUL a, a, program.local[0];\nADD result.color, a, fragment.color;\nEND\n')


def sixty(seed, wrong=None):
    """Returns a program of 60 instructions, each with its own constant; instruction n is on line n + 5."""
    numbers = random.Random(seed)
    lines = ['MOV a, fragment.color;']
    for n in range(1, 59):
        constant = f'{numbers.uniform(0.1, 0.9):.6f}'
        if n == wrong:
            constant = f'{float(constant) + 0.03125:.6f}'
        form = numbers.choice(('ADD b, a, {0};', 'MAD a, a, {0}, b;', 'MUL a.xyw, b, {0};',
                               'LRP b, {0}, a, b;', 'MAX b.xz, a, {0};', 'POW b.w, a.x, {0}.x;'))
        lines.append(form.format('{' + ', '.join([constant] * 4) + '}' if 'POW' in form or 'LRP' in form
                                 else constant))
    return ('!!ARBfp1.0\n' + PANEL.replace('#@ texture 0 = clouds 64 64, linear, repeat\n', '#\n') +
            'TEMP a, b;\n' + '\n'.join(lines) + '\nADD result.color, a, b;\nEND\n')


# (seed of a program, its instruction with a changed constant). Each change alters the result; a changed constant of a
# MAX might not.
PLANTED = ((1, 4), (2, 34), (3, 32), (4, 27), (5, 31), (6, 23), (7, 55), (8, 34), (9, 32), (10, 43), (11, 24),
           (12, 22), (13, 58), (14, 33), (15, 7), (16, 24), (17, 41), (18, 26), (19, 22), (20, 8))


class Debug(Temporary):
    def debug(self, document, *options, pixel='5,3', status=0):
        result = arbiter('debug', document, '--pixel', pixel, *options)
        self.assertEqual(result.returncode, status, result.stderr + result.stdout[-2000:])
        return result.stdout if status in (0, 5, 8) else result.stderr

    def trace(self, document, *options, pixel='5,3', status=0):
        return json.loads(self.debug(document, '--json', *options, pixel=pixel, status=status))

    def test_inputs_are_those_of_the_pixel(self):
        trace = self.trace(self.path('simple.fp', SIMPLE))
        self.assertEqual((trace['schema'], trace['pixel'], trace['size']), (2, [5, 3], [16, 8]))
        values = {each['name']: each['value'] for each in trace['attributes']}
        self.assertEqual(values['fragment.texcoord[0]'], [5.5 / 16, 3.5 / 8, 0, 1])
        self.assertEqual(trace['parameters'][0]['value'], [0.5, 0.25, 0.125, 1])
        texel = trace['rows'][0]['texel']
        self.assertEqual(texel['coordinate'][:2], [5.5 / 16, 3.5 / 8])
        self.assertAlmostEqual(texel['lod'], 3, places=4)  # 8 texels per pixel upwards
        self.assertEqual(trace['rows'][1]['operands'][0]['value'], texel['value'])
        self.assertTrue(trace['verdict']['equal'])
        self.assertTrue(trace['verdict']['bits_equal'])
        self.assertEqual(trace['verdict']['picture'], trace['rows'][2]['color'])

    def test_the_pixel_of_the_picture(self):
        document = self.path('simple.fp', SIMPLE)
        picture = self.path('out.png')
        self.assertEqual(arbiter('draw', document, '-o', picture).returncode, 0)
        _, height, rows = read_png(picture)
        for x, y in ((0, 0), (15, 7), (5, 3), (15, 0)):
            drawn = rows[height - 1 - y][4 * x:4 * x + 4].hex()
            self.assertEqual(self.trace(document, pixel=f'{x},{y}')['verdict']['picture'], drawn)
        self.assertEqual(self.trace(document, '--from-top', pixel='5,4')['pixel'], [5, 3])

    def test_planted_constants_are_found(self):
        host = ('--profile', 'host')  # the r300 profile allows only 32 parameters
        for seed, wrong in PLANTED:
            right = self.path('right.fp', sixty(seed))
            mistaken = self.path('wrong.fp', sixty(seed, wrong))
            trace = self.trace(mistaken, *host, '--against', right, status=5)
            self.assertEqual(len(trace['rows']), 60)
            first = trace['against']['first']
            self.assertEqual(first['line'], wrong + 5, trace['summary'])
            self.assertIn('operand', first['cause'])
        text = self.debug(mistaken, *host, '--against', right, status=5)
        self.assertIn(f'first at line {wrong + 5}: ', text)
        self.assertIn('equal', self.debug(right, *host, '--against', right))

    def test_verdicts_of_everyone_who_draws(self):
        document = self.path('simple.fp', SIMPLE)
        for against, name in (('swrast', 'swrast'), ('host', 'host'), ('bare', 'bare host')):
            text = self.debug(document, '--against', against)
            self.assertRegex(text.splitlines()[-1], f'^{name} drew [0-9a-f]{{8}}: equal')
        # At another pixel a component may lie halfway between two byte values.
        self.assertIn('fp24: equal in 8 bits', self.debug(document, '--against', 'fp24', pixel='6,3'))

    def test_fp24_beside_host(self):
        document = self.path('coarse.fp', '!!ARBfp1.0\n' + PANEL + 'TEMP a;\n'
                             'ADD a, fragment.color, 1000.3;\nSUB a, a, 1000.0;\n'
                             'MAD result.color, a, 4.0, -2.0;\nEND\n')
        text = self.debug(document, '--against', 'fp24', status=5)
        self.assertIn('first error that 8 bits could show is at line 5', text)
        trace = self.trace(document, '--numerics', 'fp24')
        self.assertEqual((trace['numerics'], trace['second_numerics']), ('fp24', 'host'))
        self.assertTrue(trace['verdict']['equal'], trace['summary'])

    def test_combiners_of_nine_bits(self):
        document = self.path('nine.nvrc', '!!RC1.0\nconst0 = (0.21, 0.21, 0.21, 1);\n'
                             '{ rgb { spare0 = const0 * const0; scale_by_four(); } }\nout.rgb = spare0;\n')
        for numerics, picture in (('host', '2d2d2d00'), ('fx9', '2e2e2e00')):  # 44.98; 54 * 54 * 4 / 255 = 45.7
            trace = self.trace(document, '--profile', 'host', '--numerics', numerics)
            self.assertEqual((trace['numerics'], trace['verdict']['picture']), (numerics, picture))
            self.assertTrue(trace['verdict']['equal'], trace['summary'])

    def test_breaks(self):
        document = self.path('nan.fp', '!!ARBfp1.0\n' + PANEL + 'TEMP a, b;\n'
                             'RCP a.x, fragment.texcoord[0].z;\nMUL a.y, a.x, 0.0;\n'
                             'MOV b, a;\nMOV result.color, b.x;\nEND\n')
        for condition, line in (('inf', 5), ('nan', 6), ('unwritten', 7), ('over1', 5), ('b.x>1', 7)):
            text = self.debug(document, '--break', condition, status=8)
            self.assertIn(f'stopped by {condition} at line {line}', text)
            self.assertIn(f'>{line:5}  ', text)
        self.assertIn('--break kil: no instruction', self.debug(document, '--break', 'kil'))
        self.assertEqual(self.trace(document, '--break', 'nan', status=8)['stopped'], 1)
        self.assertNotIn('result.color', self.debug(document, '--line', '6'))

    def test_kil(self):
        document = self.path('kil.fp', '!!ARBfp1.0\n' + PANEL + 'TEMP a;\n'
                             'SUB a, fragment.texcoord[0], 0.5;\nKIL a.x;\n'
                             'MOV result.color, a;\nEND\n')
        left, right = self.trace(document, pixel='2,2'), self.trace(document, pixel='12,2')
        self.assertTrue(left['discarded'] and left['rows'][1]['discards'])
        self.assertIn('swrast discarded the fragment: equal', left['summary'])
        self.assertFalse(right['discarded'])
        self.assertTrue(right['verdict']['bits_equal'])

    def test_watch(self):
        document = self.path('simple.fp', SIMPLE)
        picture = self.path('watch.png')
        result = arbiter('debug', document, '--watch', 'fragment.texcoord[0]@6', '-o', picture)
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertEqual(result.stdout.splitlines(), [
            f'{document}, fragment.texcoord[0]@6 in the 128 pixels that are covered of 16x8',
            '  pixel 8,4           (0.53125, 0.5625, 0, 1)',
            '  least               (0.03125, 0.0625, 0, 1)',
            '  greatest            (0.96875, 0.9375, 0, 1)',
            f'{picture}: fragment.texcoord[0]@6, written'])
        values = arbiter('debug', document, '--watch', 'fragment.texcoord[0]@6')
        self.assertEqual((values.returncode, values.stderr, values.stdout.splitlines()),
                         (0, '', result.stdout.splitlines()[:-1]))
        self.assertIsNone(self.trace(document, '--watch', 'a@7')['watch']['file'])
        width, height, rows = read_png(picture)
        self.assertEqual((width, height), (16, 8))
        self.assertEqual(list(rows[0][:4]), [round(255 * 0.5 / 16), round(255 * 7.5 / 8), 0, 255])
        self.debug(document, '--watch', 'a@7', '--range', '0,0.5', '-o', picture)
        trace = self.trace(document, '--watch', 'a@7', '-o', self.path('other.png'))
        value = trace['rows'][1]['value']
        watch = trace['watch']
        self.assertEqual([watch[name] for name in ('value', 'file', 'pixel', 'covered')],
                         ['a@7', str(self.path('other.png')), value, 128])
        self.assertTrue(all(low <= here <= high
                            for low, here, high in zip(watch['least'], value, watch['greatest'])), watch)
        _, _, rows = read_png(picture)
        for drawn, wanted in zip(rows[8 - 1 - 3][20:23], value):
            self.assertAlmostEqual(drawn, min(255, max(0, wanted * 2 * 255)), delta=0.51)

    def test_what_is_watched_needs_no_covered_pixel(self):
        small = self.path('small.fp', SIMPLE.replace('mesh quad', 'mesh quad scale 0.25'))
        text = self.debug(small, '--watch', 'a@7', '-o', self.path('watch.png'), pixel='0,0')
        self.assertRegex(text, r'a@7 in the \d+ pixels that are covered of 16x8\n  pixel 0,0 +not covered\n')
        empty = self.path('empty.fp', SIMPLE.replace('mesh quad', 'mesh quad at 9 9 0'))
        text = self.debug(empty, '--watch', 'a@7', '-o', self.path('watch.png'), pixel='0,0')
        self.assertIn('in the 0 pixels that are covered', text)
        self.assertNotIn('least', text)

    def test_the_middle_is_looked_into_by_itself(self):
        document = self.path('simple.fp', SIMPLE)
        trace = json.loads(arbiter('debug', document, '--json').stdout)
        self.assertEqual((trace['pixel'], trace['verdict']['equal']), ([8, 4], True))
        result = arbiter('debug', self.path('empty.fp', SIMPLE.replace('mesh quad', 'mesh quad at 9 9 0')))
        self.assertEqual((result.returncode, result.stderr),
                         (1, 'arbiter debug: nothing that the document draws covers this pixel (8,4, the middle; '
                             '--pixel X,Y names another)\n'))

    def test_a_line_without_an_instruction(self):
        document = self.path('simple.fp', SIMPLE.replace('MUL', '# a comment\nMUL'))
        for line, said in ((6, 'at line 6: TEX a, fragment.texcoord[0], texture[0], 2D'),
                           (7, 'at line 6: TEX a, fragment.texcoord[0], texture[0], 2D, the last instruction before '
                               'that line'),
                           (2, 'at line 6: TEX a, fragment.texcoord[0], texture[0], 2D, the first instruction')):
            text = self.debug(document, '--line', line)
            self.assertIn(f'--line {line}: stopped {said}\n', text)
            self.assertNotIn('MUL', text)

    def test_textures_are_those_of_draw(self):
        document, picture = self.path('simple.fp', SIMPLE), self.path('out.png')
        image = self.path('image.png')
        write_png(image, 1, 1, [b'\xff\x80\x40\xff'])
        seen = set()
        for option in ('0=checker', f'0={image}'):
            self.assertEqual(arbiter('draw', document, '--texture', option, '-o', picture).returncode, 0)
            verdict = self.trace(document, '--texture', option)['verdict']
            self.assertEqual(verdict['picture'], read_png(picture)[2][8 - 1 - 3][20:24].hex())
            self.assertTrue(verdict['bits_equal'])
            seen.add(verdict['picture'])
        self.assertEqual(len(seen), 2)
        for option in ('1=noise', '0=qqq', '0', '0=/none.png'):
            drawn = arbiter('draw', document, '--texture', option, '-o', picture)
            debugged = arbiter('debug', document, '--texture', option)
            self.assertEqual((debugged.returncode, debugged.stderr.replace('arbiter debug', 'arbiter draw')),
                             (1, drawn.stderr))

    def test_a_file_that_the_document_lacks(self):
        document = self.path('lacks.fp', SIMPLE.replace('clouds 64 64, linear, repeat', 'none.png'))
        self.assertEqual(self.debug(document, status=1),
                         f'arbiter debug: {document}:3:16: {self.path("none.png")}: No such file or directory\n')

    def test_an_equal_black_says_little(self):
        said = 'equal, to the bit; it is black, so that little of the program was compared'
        black = SIMPLE.replace('ADD result.color, a', 'MUL result.color, 0.0')
        self.assertIn(said, self.debug(self.path('black.fp', black)))
        self.assertNotIn('black', self.debug(self.path('simple.fp', SIMPLE)))

    def test_the_gallery(self):
        for name, pixel, more in (('twirl.fp', '100,200', ()), ('life.fp', '33,40', ('--frame', '3')),
                                  ('lighting_4_all.fp', '256,200', ()), ('fur.fp', '256,200', ())):
            trace = self.trace(GALLERY / name, *more, pixel=pixel)
            self.assertTrue(trace['verdict']['equal'], trace['summary'])

    def covered(self, document, *options, watch, pixel):
        """Returns the pixels that a pass covers, as (x, y) from the top."""
        picture = self.path('watch.png')
        self.debug(document, '--watch', watch, '-o', picture, *options, pixel=pixel)
        width, height, rows = read_png(picture)
        return {(x, y) for x in range(width) for y in range(height) if rows[y][4 * x + 3]}

    def test_depths_that_must_be_equal(self):
        """Passes before one that compares depths are drawn into the same kind of framebuffer."""
        scene = '#@ mesh torus parts 24 at 0.1 0.2 0 and plane at 0 -0.3 0 scale 2\n'
        document = self.path('first.fp', '!!ARBfp1.0\n#@ size 97 83, clear 0 0 0 1, camera orbit yaw 25 pitch 35 '
                             'distance 3, then second.fp\n' + scene + 'MOV result.color, {1, 0, 0, 1};\nEND\n')
        self.path('second.fp', '!!ARBfp1.0\n#@ keep, depth equal write off\n' + scene +
                  'MOV result.color, {1, 1, 0, 1};\nEND\n')
        picture = self.path('out.png')
        self.assertEqual(arbiter('draw', document, '-o', picture).returncode, 0)
        width, height, rows = read_png(picture)
        drawn = {(x, y) for x in range(width) for y in range(height) if rows[y][4 * x + 1]}
        self.assertGreater(len(drawn), width * height / 4)
        for against in ('swrast', 'host', 'bare'):
            found = self.covered(document, '--pass', '2', '--against', against, watch='result.color@4',
                                 pixel='48,40')
            self.assertEqual(found, drawn, against)

    def test_a_shadow_volume(self):
        """Each pixel lit by the third pass has a fragment of it; no pixel shut out by the stencil has one."""
        document, picture = GALLERY / 'shadow_volume.fp', self.path('out.png')
        self.assertEqual(arbiter('draw', document, '-o', picture).returncode, 0)
        width, height, rows = read_png(picture)
        places = [(x, y, tuple(rows[y][4 * x:4 * x + 3])) for x in range(width) for y in range(height)]
        unlit, sky = (51, 51, 64), (102, 115, 128)
        for against in ('swrast', 'host'):
            found = self.covered(document, '--pass', '3', '--against', against, watch='result.color@17',
                                 pixel='400,111')
            lost = [place for place in places if place[2] not in (unlit, sky) and place[:2] not in found]
            # `arbiter draw` draws into a window, whose y axis is flipped against a framebuffer object's. Their depths
            # can differ in the last bit, which decides where the volume touches a surface.
            self.assertLessEqual(len(lost), 4, (against, lost))
            self.assertEqual([place for place in places if place[2] == sky and place[:2] in found], [], against)
        self.assertIn('covers this pixel', self.debug(document, '--pass', '3', pixel='90,181', status=1))

    def test_vertices(self):
        trace = self.trace(GALLERY / 'skinning.fp', '--stage', 'vertex', pixel='256,256')
        self.assertEqual(len(trace['vertices']), 3)
        for vertex in trace['vertices']:
            names = [result['name'] for result in vertex['results']]
            self.assertIn('result.position', names)
            self.assertTrue(vertex['rows'])
        self.assertIn('no vertex program', self.debug(self.path('a.fp', SIMPLE), '--stage', 'vertex',
                                                      status=1))

    def test_state_that_vertex_programs_alone_have(self):
        rows = ('state.texgen[0].eye.s', 'state.texgen[1].object.t', 'state.texgen[0].object.q',
                'state.point.size', 'state.point.attenuation', 'state.clip[0].plane')
        self.path('rows.vp', '!!ARBvp1.0\nMOV result.position, vertex.position;\n' + ''.join(
            f'MOV result.texcoord[{i}], {row};\n' for i, row in enumerate(rows)) + 'END\n')
        document = self.path('rows.fp', '!!ARBfp1.0\n#@ size 8 8, vertex rows.vp\nTEMP a;\n'
                             'MOV a, fragment.texcoord[0];\n' + ''.join(
                                 f'ADD a, a, fragment.texcoord[{i}];\n' for i in range(1, len(rows))) +
                             'MOV result.color, a;\nEND\n')
        drawn = {each['name']: each['value'] for each in self.trace(document)['attributes']}
        self.assertEqual(drawn['fragment.texcoord[0]'], [1, 0, 0, 0], 'the plane of GL')
        self.assertEqual(drawn['fragment.texcoord[3]'][:2], [1, 0])
        for vertex in self.trace(document, '--stage', 'vertex')['vertices']:
            traced = {each['name']: each['value'] for each in vertex['results']}
            for i in range(len(rows)):
                self.assertEqual(traced[f'result.texcoord[{i}]'], drawn[f'fragment.texcoord[{i}]'], rows[i])

    def test_an_ati_shader(self):
        trace = self.trace(GALLERY / 'ati_bumps.fp', pixel='256,330')
        self.assertTrue(trace['verdict']['equal'], trace['summary'])
        self.assertEqual([row['texel']['unit'] for row in trace['rows'] if 'texel' in row], [1, 2, 3])
        self.assertGreater(max(trace['rows'][-1]['value']), 0.1)
        self.assertIn('host drew', self.debug(GALLERY / 'ati_bumps.fp', '--against', 'host', pixel='256,330'))

    def test_what_cannot_be(self):
        document = self.path('simple.fp', SIMPLE)
        png = self.path('x.png')
        for options, status, words in (
                (('--pixel', '16,0'), 1, 'the picture is 16x8'),
                (('--pixel', '-1,0'), 1, 'the picture is 16x8'),
                (('--pixel', '5'), 1, 'expected X,Y'),
                (('--pixel', '5,3,1'), 1, 'expected X,Y'),
                (('--pixel', '99999999999,3'), 1, 'expected X,Y'),
                (('--pixel', '1,1', '--pass', '2'), 1, 'has one pass'),
                (('--pixel', '1,1', '--break', 'soon'), 1, 'expected nan'),
                (('--pixel', '1,1', '--watch', 'q@6', '-o', png), 1, "'q'"),
                (('--pixel', '1,1', '--watch', 'a@2', '-o', png), 1, 'no instruction'),
                (('--watch', 'a@6', '--range', '0,2'), 1, '--range needs --output'),
                (('--pixel', '16,0', '--watch', 'a@6', '-o', png), 1, 'the picture is 16x8'),
                (('--watch', 'a@6', '-o', png, '--line', '6'), 1, '--line has no effect with --watch'),
                (('--from-top',), 1, '--from-top needs --pixel'),
                (('--pixel', '1,1', '--watch', 'a@6', '-o', '/nowhere/x.png'), 1, '/nowhere'),
                (('--pixel', '1,1', '--range', '1,0', '--watch', 'a@6', '-o', png), 1, 'LOW,HIGH'),
                (('--pixel', '1,1', '--line', '170'), 1, f'--line 170: {document} has 9 lines'),
                (('--pixel', '1,1', '--line', '10'), 1, 'has 9 lines'),
                (('--pixel', '1,1', '--against', 'none.fp'), 1,
                 '--against none.fp: No such file or directory'),
                (('--pixel', '1,1', '--against', 'hots'), 1,
                 '--against hots: expected swrast, host, bare, fp24 or a file; did you mean host?'),
                (('--pixel', '1,1', '--library', 'none.so'), 1, 'none.so'),
                (('--stage', 'vertex'), 1, 'fixed function transforms\n'),
                (('--pixel', '1,1', '--profile', 'none'), 1, 'none')):
            result = arbiter('debug', document, *options)
            self.assertEqual(result.returncode, status, (options, result.stderr))
            self.assertIn(words, result.stderr, options)
        self.assertEqual(arbiter('debug', document, '--pixel', '1,1', '--line', '9').returncode, 0)
        bad = self.path('bad.fp', BAD)
        self.assertIn('bad.fp:3:', self.debug(bad, status=2))
        seen = on_terminal('debug', bad, '--pixel', '1,1')
        self.assertIn(f'\x1b[1m{bad}:3:19:\x1b[0m \x1b[1;31merror:\x1b[0m', seen)
        self.assertIn('\x1b[1;31m                    ^\x1b[0m\n', seen)
        self.assertIn('no fragment program', self.debug(self.path('v.vp', VERTEX), status=1))
        small = self.path('small.fp', SIMPLE.replace('mesh quad', 'mesh quad scale 0.25'))
        self.assertIn('covers this pixel', self.debug(small, pixel='0,0', status=1))
        self.assertIn('none.fp', self.debug(self.path('none.fp'), status=1))


if __name__ == '__main__':
    command_session.main()
