#!/usr/bin/env python3
"""Tests that `arbiter check --profile all` reports the same about each card as --profile with that card.

usage: cards_test.py ARBITER SOURCE_ROOT
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ARBITER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
CARDS = ['r300', 'r300-catalyst-2004', 'r350', 'r360', 'r420', 'nv10', 'nv20', 'nv25', 'nv30',
         'nv35', 'nv40', 'i915']
PROGRAMLESS = ('nv10', 'nv20', 'nv25')  # cards without fragment programs
SIMPLE = '!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
FOURTH_BUFFER = '!!ARBfp1.0\nOPTION ARB_draw_buffers;\nMOV result.color[3], 1;\nEND\n'
FIFTH_BUFFER = FOURTH_BUFFER.replace('[3]', '[4]')
WRONG = '!!ARBfp1.0\nMOV result.colour, 1;\nEND\n'
# Five reads, each dependent on the previous one: one more than the R300 supports.
DEEP = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord, texture[0], 2D;\n' +
        'TEX a, a, texture[0], 2D;\n' * 4 + 'MOV result.color, a;\nEND\n')


def run(*words, text=None):
    return subprocess.run([ARBITER, 'check', *map(str, words)], input=text, capture_output=True,
                          text=True, timeout=60, check=False)


class Cards(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='arbiter-cards-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def statuses(self, *files, code, text=None):
        result = run('--profile', 'all', '--json', *files, text=text)
        self.assertEqual(result.returncode, code, result.stderr)
        document = json.loads(result.stdout)
        self.assertEqual([profile['name'] for profile in document['profiles']], CARDS)
        return {row['file']: {card['profile']: card for card in row['cards']}
                for row in document['files']}, document

    def test_each_card_is_as_it_is_alone(self):
        """Checks all programs of the compiler's tests for every card; the worst program decides the exit code."""
        data = ROOT / 'src' / 'fp_compiler' / 'testdata'
        files = [path for sub in ('valid', 'invalid') for ending in ('fp', 'vp', 'atifs')
                 for path in sorted((data / sub).glob('*.' + ending))]
        self.assertGreater(len(files), 50)
        answers, document = self.statuses(*files, code=2)
        for card in CARDS:
            alone = json.loads(run('--profile', card, '--json', *files).stdout)
            for entry in alone['files']:
                cell = answers[entry['file']][card]
                self.assertEqual(cell['status'], entry['status'], f'{card}: {entry["file"]}')
                over = {row['resource']: [row['native_used'], row['native_limit']]
                        for row in cell['over']}
                counts = entry.get('counts', {})
                if entry['status'] == 'over_native':
                    self.assertEqual(over, {name: [count['native_used'], count['native_limit']]
                                            for name, count in counts.items()
                                            if count['native_used'] > count['native_limit']})
            fit = sum(entry['status'] == 'valid' for entry in alone['files'])
            self.assertEqual(document['summary']['valid_by_profile'][card], fit)
        self.assertEqual(document['summary']['files'], len(files))

    def test_a_card_with_four_draw_buffers_refuses_the_fifth(self):
        fourth, fifth = self.write('4.fp', FOURTH_BUFFER), self.write('5.fp', FIFTH_BUFFER)
        answers, _ = self.statuses(fourth, fifth, code=2)
        for card in CARDS:
            has_four = card.startswith('r') or card == 'nv40'
            self.assertEqual(answers[str(fourth)][card]['status'], 'valid' if has_four else 'invalid')
            self.assertEqual(answers[str(fifth)][card]['status'], 'invalid')
            if has_four:
                self.assertIn('draw buffer', answers[str(fifth)][card]['why'])

    def test_the_text_is_a_matrix_with_reasons(self):
        deep = self.write('deep.fp', DEEP)
        result = run('--profile', 'all', deep, self.write('simple.fp', SIMPLE))
        self.assertEqual(result.returncode, 0, result.stderr)
        _, _, head, first, second, total, legend, outcome, *reasons = result.stdout.splitlines()
        self.assertEqual(head.split(), CARDS)
        self.assertEqual(first.split(), [str(deep)] + ['over', 'over', 'over', 'over', 'over', 'no', 'no', 'no',
                                                       'fits', 'fits', 'fits', 'over'])
        # These cards run no fragment programs.
        self.assertEqual(second.split()[1:], ['fits'] * 5 + ['no'] * 3 + ['fits'] * 4)
        self.assertNotIn(' of 0', result.stdout)
        self.assertEqual(total.split(), 'fit, of 2 1 1 1 1 1 0 0 0 2 2 2 1'.split())
        self.assertTrue(legend.startswith('fits:'))
        self.assertEqual(outcome, 'fit at least one card: 2 of 2 programs')
        # What a card lacks comes before what the program does wrong by limits that say nothing. Cards with the same
        # reason share a line.
        lacks = ', '.join(PROGRAMLESS) + ': the card has no fragment programs'
        over = 'over the native limits: TEX indirections 5 of 4'
        self.assertEqual(len(reasons), 4, reasons)
        self.assertTrue(reasons[0].startswith(f'{deep}: r300, r300-catalyst-2004, r350, r360, r420: {over} (TEX reads'))
        self.assertEqual(reasons[1], f'{deep}: {lacks}')
        self.assertTrue(reasons[2].startswith(f'{deep}: i915: {over}'))
        self.assertEqual(reasons[3], f'{self.folder / "simple.fp"}: {lacks}')
        brief = run('--profile', 'all', '--brief', deep)
        self.assertEqual(len(brief.stdout.splitlines()), 6)

    def test_why_gives_every_reason_with_its_instructions(self):
        deep, wrong = self.write('deep.fp', DEEP), self.write('wrong.fp', WRONG.replace('END', 'MOV q, 1;\nEND'))
        short = run('--profile', 'all', deep, wrong).stdout
        self.assertNotIn('7 | TEX a, a, texture[0], 2D', short)
        self.assertNotIn("3:5: 'q'", short)
        long = run('--profile', 'all', '--why', deep, wrong).stdout
        self.assertRegex(long, r'(?m)^ +7 \| TEX a, a, texture\[0\], 2D$')
        self.assertIn('the longest chain of dependent reads (4 reads)', long)
        self.assertRegex(long, r"(?m)^  3:5: 'q'")
        self.assertEqual(run('--profile', 'all', '--why', self.write('a.fp', SIMPLE)).stdout,
                         run('--profile', 'all', self.folder / 'a.fp').stdout)

    def test_columns_stand_below_their_cards(self):
        brand, model, profile, cells = run('--profile', 'all', self.write('a.fp', SIMPLE)).stdout.splitlines()[:4]
        for card in CARDS:
            at = (profile + ' ').index(' ' + card + ' ') + 1
            self.assertEqual(cells[at:at + 4].rstrip(), 'no' if card in PROGRAMLESS else 'fits')
        # People know a card by the name on its box.
        for card, name in (('r300', 'Radeon 9700'), ('r360', 'Radeon 9800 XT'), ('nv10', 'GeForce 256'),
                           ('nv25', 'GeForce4 Ti'), ('nv35', 'GeForce FX 5900'), ('i915', '915G')):
            at = (profile + ' ').index(' ' + card + ' ') + 1
            said = [line[at:at + 10].split('  ')[0].strip() for line in (brand, model)]
            self.assertEqual(' '.join(said).strip(), name)

    def test_exit_codes(self):
        """A program's best card decides for it, and the worst program for all."""
        self.statuses(self.write('a.fp', SIMPLE), code=0)
        self.statuses(self.write('b.fp', WRONG), code=2)
        self.assertIn('fit at least one card: 1 of 2 programs, refused by all: 1\n',
                      run('--profile', 'all', self.folder / 'a.fp', self.folder / 'b.fp').stdout)
        self.assertEqual(run('--profile', 'all', self.folder / 'none.fp').returncode, 1)
        self.assertEqual(run('--profile', 'all', self.folder / 'a.fp', self.folder / 'none.fp')
                         .returncode, 1)
        # The program exceeds every card's native instructions, while the API's limits are ignored.
        long = '!!ARBfp1.0\nTEMP a;\n' + 'ADD a, a, fragment.color;\n' * 5000 + \
               'MOV result.color, a;\nEND\n'
        answers, _ = self.statuses('--limits', 'report', self.write('c.fp', long), code=3)
        self.assertEqual({cell['status'] for row in answers.values() for cell in row.values()},
                         {'over_native'})
        self.assertIn('fit at least one card: 0 of 1 program, load and fit none: 1\n',
                      run('--profile', 'all', '--limits', 'report', self.folder / 'c.fp').stdout)

    def test_standard_input_is_read_once(self):
        answers, _ = self.statuses('-', code=0, text=SIMPLE)
        for card, cell in answers['<stdin>'].items():
            self.assertEqual(cell['status'], 'over_native' if card in PROGRAMLESS else 'valid')

    def test_what_it_does_not_go_with(self):
        path = self.write('a.fp', SIMPLE)
        for words in (['--profile', 'r300'], ['--compare'], ['--gauges', 'always'],
                      ['--why', '--json'], ['--why', '--brief'], ['--brief', '--json']):
            result = run('--profile', 'all', *words, path)
            self.assertEqual(result.returncode, 1, words)
            self.assertTrue(result.stderr, words)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]])
