#!/usr/bin/env python3
"""Tests of requests to `arbiter lsp` about a position in a text: hover, completion, navigation, hints.

usage: lsp_requests_test.py ARBITER [UNITTEST ARGUMENTS...]
"""
import sys
import unittest

import lsp_session
from lsp_client import place
from lsp_session import ATI, PROGRAM, URI, VERTEX, Session, labels


class Hover(Session):
    def test_opcodes(self):
        self.client.open(URI, PROGRAM)
        text = self.hover(PROGRAM, 'MUL_SAT', 2)
        for piece in ('MUL[_SAT] result, a, b', 'product', 'result = a*b',
                      'ARB_fragment_program 3.11.5.19'):
            self.assertIn(piece, text)
        self.assertRegex(text, 'alone on r300: 1 slot\n')
        text = self.hover(PROGRAM, 'TEX ')
        self.assertIn('TEX[_SAT] result, a, texture[n], target', text)
        self.assertRegex(text, 'alone on r300: 1 TEX\n')

    def test_bindings(self):
        self.client.open(URI, PROGRAM)
        for mark, after in (('fragment.texcoord', 3), ('fragment.texcoord', 12)):
            text = self.hover(PROGRAM, mark, after)
            self.assertIn('fragment.texcoord[n]', text)
            self.assertIn('3.11.3.1', text)
        self.assertIn('draw buffer', self.hover(PROGRAM, 'result.color', 9))
        self.client.open('file:///b.vp', VERTEX)
        self.assertIn('glProgramEnvParameter',
                      self.hover(VERTEX, 'program.env', 9, 'file:///b.vp'))
        self.assertIn('fixed function', self.hover(VERTEX, 'ARB_position', 4, 'file:///b.vp'))

    def test_names(self):
        self.client.open(URI, PROGRAM)
        text = self.hover(PROGRAM, 'second, tint', 9)
        self.assertIn('parameter', text)
        self.assertIn('PARAM tint = { 0.5, 1, 0.25, 1 };', text)
        self.assertIn('read in line 10', text)
        text = self.hover(PROGRAM, 'uv, texture')
        self.assertIn('texture coordinate set n', text)

    def test_of_ati(self):
        self.client.open(URI, ATI)
        for mark, after, piece in (('MAD', 1, 'a*b + c'), ('.str', 1, '(s, t, r)'),
                                   ('SampleMap', 2, 'fills a register'), ('.2x', 2, 'twice'),
                                   ('color0', 1, 'primary colour'), ('c1,', 0, 'program.env[3]'),
                                   ('t0', 0, 'texture coordinate set')):
            self.assertIn(piece, self.hover(ATI, mark, after), mark)

    def test_of_nothing(self):
        self.client.open(URI, PROGRAM)
        self.assertEqual(self.hover(PROGRAM, '# a comment', 5), '')


class Panels(Session):
    def test_words_are_completed_and_explained(self):
        found = self.complete('!!ARBfp1.0\n#@ texture 0 = noise, |')
        self.assertIn('nearest', found)
        self.assertNotIn('MOV', found)
        text = '!!ARBfp1.0\n#@ cull back\nEND\n'
        self.client.open(URI, text)
        self.assertIn('turns away', self.hover(text, 'back'))


class Report(Session):
    def report(self, uri=URI):
        return self.client.request('arbiter/report', {'textDocument': {'uri': uri}})

    def test_is_that_of_check(self):
        self.client.open(URI, PROGRAM)
        report = self.report()
        self.assertEqual(report['status'], 'valid')
        self.assertEqual(report['profile'], 'r300')
        self.assertEqual(report['bytes'], len(PROGRAM.encode()))
        self.assertGreater(report['counts']['alu_instructions']['native_limit'], 0)
        self.assertEqual(len(report['native']['instructions']),
                         report['counts']['instructions']['used'])

    def test_of_a_wrong_text_has_no_counts(self):
        self.client.open(URI, PROGRAM.replace('END', 'ENDE'))
        report = self.report()
        self.assertEqual(report['status'], 'invalid')
        self.assertNotIn('counts', report)
        self.assertTrue(report['diagnostics'])


class Completion(Session):
    def test_statements(self):
        found = self.complete('!!ARBfp1.0\nTEMP a;\n|')
        for word in ('MOV', 'TEX', 'TEX_SAT', 'TEMP', 'PARAM', 'END'):
            self.assertIn(word, found)
        for word in ('ARL', 'ADDRESS', 'KIL_SAT', 'a', 'fragment'):
            self.assertNotIn(word, found)
        found = self.complete('!!ARBvp1.0\nTEMP a;\nM|', uri='file:///b.vp')
        for word in ('MOV', 'ARL', 'ADDRESS'):
            self.assertIn(word, found)
        for word in ('TEX', 'MOV_SAT', 'SIN'):
            self.assertNotIn(word, found)

    def test_the_word_that_is_written_is_replaced(self):
        text = '!!ARBfp1.0\nMO'
        self.client.open(URI, text)
        items = self.client.request('textDocument/completion', {
            'textDocument': {'uri': URI}, 'position': {'line': 1, 'character': 2}})
        move = next(item for item in items if item['label'] == 'MOV')
        self.assertEqual(move['textEdit'], {'newText': 'MOV', 'range': {
            'start': {'line': 1, 'character': 0}, 'end': {'line': 1, 'character': 2}}})
        self.assertIn('MOV[_SAT] result, a', move['detail'])

    def test_operands(self):
        head = '!!ARBfp1.0\nTEMP t;\nPARAM p = {1};\nATTRIB a = fragment.color;\n' \
               'OUTPUT o = result.color;\n'
        found = self.complete(head + 'MOV |')
        self.assertEqual(set(found), {'t', 'o', 'result'})
        found = self.complete(head + 'MAD t, |\nMOV t, t;\nEND\n')
        self.assertEqual(set(found), {'t', 'p', 'a', 'fragment', 'program', 'state'})
        self.assertEqual(set(self.complete(head + 'KIL -|')),
                         {'t', 'p', 'a', 'fragment', 'program', 'state'})
        # A name is not offered before its declaration.
        self.assertNotIn('late', self.complete(head + 'MOV t, |;\nTEMP late;\nEND\n'))

    def test_textures(self):
        head = '!!ARBfp1.0\nTEMP t;\n'
        self.assertIn('texture[15]', self.complete(head + 'TEX t, t, |'))
        self.assertEqual(self.complete(head + 'TEX t, t, texture[0], |')[:5],
                         ['1D', '2D', '3D', 'CUBE', 'RECT'])
        self.assertIn('2D', self.complete(head + 'TEX t, t, texture[0], 2|'))

    def test_bindings_step_by_step(self):
        for text, wanted in (
                ('ATTRIB a = |', {'fragment'}), ('OUTPUT o = |', {'result'}),
                ('PARAM p = |', {'program', 'state'}), ('PARAM p[] = { |', {'program', 'state'}),
                ('ATTRIB a = fragment.|', {'color', 'texcoord[n]?', 'fogcoord', 'position'}),
                ('ATTRIB a = fragment.c|', {'color', 'texcoord[n]?', 'fogcoord', 'position'}),
                ('PARAM p = state.light[3].|', {'ambient', 'diffuse', 'specular', 'position',
                                                'attenuation', 'spot', 'half'}),
                ('PARAM p = state.light[3].spot.|', {'direction'}),
                ('PARAM p = state.matrix.mvp.inverse.|', {'row[n]'}),
                ('PARAM p = program.|', {'env[n]', 'local[n]'})):
            self.assertEqual(set(self.complete('!!ARBfp1.0\n' + text)), wanted, text)
        self.assertNotIn('texgen[n]?', self.complete('!!ARBfp1.0\nPARAM p = state.|'))
        self.assertIn('texgen[n]?', self.complete('!!ARBvp1.0\nPARAM p = state.|'))

    def test_components(self):
        head = '!!ARBfp1.0\nTEMP t;\n'
        self.assertIn('xyz', self.complete(head + 'MOV t.|'))
        self.assertIn('wzyx', self.complete(head + 'MOV t, t.|'))
        self.assertNotIn('wzyx', self.complete(head + 'RCP t, t.|'))
        found = self.complete(head + 'MOV t, fragment.color.|')
        self.assertIn('secondary', found)
        self.assertIn('x', found)
        vertex = '!!ARBvp1.0\nADDRESS A0;\nPARAM c[] = { program.env[0..3] };\n'
        self.assertEqual(self.complete(vertex + 'MOV result.position, c[|'), ['A0'])
        self.assertEqual(self.complete(vertex + 'ARL |'), ['A0'])
        self.assertNotIn('r', self.complete(vertex + 'MOV result.position, c[0].|'))

    def test_options_and_headers(self):
        self.assertIn('ARB_fog_exp2', self.complete('!!ARBfp1.0\nOPTION |'))
        self.assertEqual(self.complete('!!ARBvp1.0\nOPTION |'), ['ARB_position_invariant'])
        self.assertIn('!!ARBvp1.0', self.complete('|'))
        self.assertEqual(self.complete('!!AR|'), ['!!ARBfp1.0', '!!ARBvp1.0', '!!ATIfs1.0'])

    def test_not_in_comments(self):
        self.assertEqual(self.complete('!!ARBfp1.0\nTEMP a; # MOV |'), [])

    def test_of_ati(self):
        head = '!!ATIfs1.0\nStartOutputPass;\n'
        self.assertIn('DOT2ADD', self.complete(head + '|'))
        self.assertEqual(self.complete(head + 'SampleMap r1, t0.|'),
                         ['str', 'stq', 'str_dr', 'stq_dq'])
        self.assertIn('t5', self.complete(head + 'SampleMap r1, |'))
        self.assertIn('sat', self.complete(head + 'MOV r0.|'))
        self.assertIn('comp', self.complete(head + 'MOV r0, r1.|'))
        self.assertIn('color1', self.complete(head + 'MOV r0, |'))


class Navigation(Session):
    def setUp(self):
        super().setUp()
        self.client.open(URI, PROGRAM)

    def test_definition(self):
        found = self.client.request('textDocument/definition', self.at(PROGRAM, 'second, tint'))
        self.assertEqual(found['range']['start'], place(PROGRAM, 'second = colour'))
        self.assertEqual(found['uri'], URI)
        self.assertIsNone(self.client.request('textDocument/definition',
                                              self.at(PROGRAM, 'texture[0]')))

    def test_references(self):
        spot = {**self.at(PROGRAM, 'TEX colour', 5), 'context': {'includeDeclaration': True}}
        found = self.client.request('textDocument/references', spot)
        self.assertEqual(self.words(PROGRAM, found), ['colour'] * 4)
        self.assertEqual([f['range']['start']['line'] for f in found], [2, 7, 8, 10])
        spot['context'] = {'includeDeclaration': False}
        self.assertEqual(len(self.client.request('textDocument/references', spot)), 3)
        marks = self.client.request('textDocument/documentHighlight', self.at(PROGRAM, 'MOV out', 5))
        self.assertEqual([m['kind'] for m in marks], [3, 3])

    def rename(self, mark, name, after=0):
        return {**self.at(PROGRAM, mark, after), 'newName': name}

    def test_rename(self):
        prepared = self.client.request('textDocument/prepareRename',
                                       self.at(PROGRAM, 'DP4 r0', 5))
        self.assertEqual(prepared['placeholder'], 'r0')
        edit = self.client.request('textDocument/rename', self.rename('DP4 r0', 'sum$1', 5))
        lines = PROGRAM.split('\n')
        for change in reversed(edit['changes'][URI]):
            spot = change['range']
            line = lines[spot['start']['line']]
            lines[spot['start']['line']] = (line[:spot['start']['character']] + change['newText']
                                            + line[spot['end']['character']:])
        self.assertEqual(len(edit['changes'][URI]), 4)
        renamed = '\n'.join(lines)
        self.assertEqual(renamed.count('sum$1'), 4)
        self.assertEqual(self.client.open(URI, renamed), [])

    def test_rename_is_refused(self):
        for name, piece in (('MOV', 'reserved'), ('ADD_SAT', 'reserved'), ('fragment', 'reserved'),
                            ('texture', 'reserved'), ('colour', 'line 3'), ('second', 'line 8'),
                            ('1x', 'no name'), ('', 'no name'), ('a b', 'no name'),
                            ('\u00e4', 'no name'), ('x' * 2000, 'no name')):
            error = self.client.failure('textDocument/rename', self.rename('DP4 r0', name, 5))
            self.assertIn(piece, error['message'], name)
        for mark in ('TEX colour', 'fragment.texcoord', 'END'):
            error = self.client.failure('textDocument/prepareRename', self.at(PROGRAM, mark))
            self.assertIn('no name', error['message'])
        # A keyword of vertex programs is an ordinary name here.
        self.client.request('textDocument/rename', self.rename('DP4 r0', 'ADDRESS', 5))
        self.client.open('file:///c.atifs', ATI)
        error = self.client.failure('textDocument/rename', {
            **self.at(ATI, 'MAD r0', 4, 'file:///c.atifs'), 'newName': 'x'})
        self.assertIn('fixed names', error['message'])

    def test_symbols(self):
        found = self.client.request('textDocument/documentSymbol', {'textDocument': {'uri': URI}})
        self.assertEqual([s['name'] for s in found],
                         ['r0', 'colour', 'tint', 'rows', 'uv', 'out', 'second'])
        self.assertEqual(found[2]['detail'], 'PARAM tint = { 0.5, 1, 0.25, 1 };')
        self.assertEqual(self.words(PROGRAM, [s['selectionRange'] for s in found]),
                         [s['name'] for s in found])
        self.client.open('file:///c.atifs', ATI)
        found = self.client.request('textDocument/documentSymbol',
                                    {'textDocument': {'uri': 'file:///c.atifs'}})
        self.assertEqual([s['name'] for s in found], ['c1', 'output pass'])

    def test_semantic_tokens(self):
        legend = self.initialized['capabilities']['semanticTokensProvider']['legend']['tokenTypes']
        data = self.client.request('textDocument/semanticTokens/full',
                                   {'textDocument': {'uri': URI}})['data']
        self.assertEqual(len(data) % 5, 0)
        line = character = 0
        seen = {}
        lines = PROGRAM.split('\n')
        for at in range(0, len(data), 5):
            down, right, length, kind, _ = data[at:at + 5]
            character = right if down else character + right
            line += down
            seen[lines[line][character:character + length]] = legend[kind]
        self.assertEqual(seen['MUL_SAT'], 'function')
        self.assertEqual(seen['TEMP'], 'keyword')
        self.assertEqual(seen['tint'], 'parameter')
        self.assertEqual(seen['r0'], 'variable')
        self.assertEqual(seen['2D'], 'enumMember')
        self.assertEqual(seen['0.25'], 'number')


class Pair(Session):
    """Opens a text with a vertex and a fragment program; each answer must use the one at the position."""
    PAIR = '# A material.\n\n' + VERTEX + '\n# Its other half.\n' + PROGRAM

    def setUp(self):
        super().setUp()
        self.assertEqual(self.client.open('file:///tmp/a.vfp', self.PAIR), [])
        self.uri = 'file:///tmp/a.vfp'

    def ask(self, method, mark, after=0, **more):
        return self.client.request(f'textDocument/{method}',
                                   {**self.at(self.PAIR, mark, after, self.uri), **more})

    def test_diagnostics_of_both(self):
        wrong = self.PAIR.replace('ARL A0.x', 'ARL A1.x').replace('MOV out', 'MOV cut')
        found = self.client.open(self.uri, wrong)
        self.assertEqual([d['range']['start']['line'] for d in found],
                         [wrong[:wrong.index(mark)].count('\n') for mark in ('ARL A1', 'MOV cut')])

    def test_names_are_those_of_the_half(self):
        self.assertIn('address register', self.hover(self.PAIR, 'A0;', 1, self.uri))
        self.assertIn('result', self.hover(self.PAIR, 'MOV out', 5, self.uri))
        found = self.ask('references', 'TEMP r0', 5, context={'includeDeclaration': True})
        self.assertEqual(set(self.words(self.PAIR, found)), {'r0'})
        self.assertEqual(len(found), 4)
        edit = self.ask('rename', 'bones[A0', 1, newName='arms')['changes'][self.uri]
        self.assertEqual(set(self.words(self.PAIR, edit)), {'bones'})
        items = labels(self.ask('completion', 'out, r0', 0))
        self.assertIn('r0', items)
        self.assertNotIn('bones', items)

    def test_what_is_of_the_whole_text(self):
        text = {'textDocument': {'uri': self.uri}}
        symbols = self.client.request('textDocument/documentSymbol', text)
        self.assertEqual([s['name'] for s in symbols][:3], ['A0', 'bones', 'r0'])
        data = self.client.request('textDocument/semanticTokens/full', text)['data']
        lines, line, character, words = self.PAIR.split('\n'), 0, 0, []
        for down, right, length, _, _ in zip(*[iter(data)] * 5):
            character = right if down else character + right
            line += down
            words.append(lines[line][character:character + length])
        self.assertIn('bones', words)
        self.assertIn('MUL_SAT', words)
        hints = self.client.request('textDocument/inlayHint', {**text, 'range': Inlay.WHOLE})
        headers = [hint['position']['line'] for hint in hints if 'r300: ' in hint['label']]
        self.assertEqual(headers, [i for i, each in enumerate(lines) if each.startswith('!!')])

    def test_the_report_is_of_the_half_at_the_position(self):
        for mark, language in (('ARL', 'ARBvp1.0'), ('MUL_SAT', 'ARBfp1.0')):
            report = self.client.request('arbiter/report', self.at(self.PAIR, mark, 0, self.uri))
            self.assertEqual(report['language'], language)
        report = self.client.request('arbiter/report', {'textDocument': {'uri': self.uri}})
        self.assertEqual(report['language'], 'ARBfp1.0')


class Inlay(Session):
    WHOLE = {'start': {'line': 0, 'character': 0}, 'end': {'line': 9999, 'character': 0}}

    def hints(self, spot=None):
        return self.client.request('textDocument/inlayHint', {
            'textDocument': {'uri': URI}, 'range': spot or self.WHOLE})

    def test_totals_at_the_header(self):
        self.client.open(URI, PROGRAM)
        found = self.hints()
        self.assertEqual(found[0]['position'], {'line': 0, 'character': 10})
        self.assertTrue(found[0]['label'].startswith('r300: '), found[0])
        self.assertIn('1/32 TEX instructions', found[0]['label'])
        self.assertIn('1/4 TEX indirections', found[0]['label'])

    def test_lines(self):
        self.client.open(URI, PROGRAM)
        found = {hint['position']['line']: hint['label'] for hint in self.hints()[1:]}
        self.assertEqual(list(found), [8, 9, 10, 11])
        self.assertEqual(found[8], '1 TEX')
        self.assertIn('slot', found[10])
        # A card with known limits but no model has only totals.
        self.client.notify('workspace/didChangeConfiguration', {'settings': {'profile': 'host'}})
        self.client.diagnostics(URI)
        self.assertEqual(len(self.hints()), 1)

    def test_of_a_range(self):
        self.client.open(URI, PROGRAM)
        part = {'start': {'line': 9, 'character': 0}, 'end': {'line': 10, 'character': 0}}
        self.assertEqual([hint['position']['line'] for hint in self.hints(part)], [9, 10])

    def test_none_for_a_text_that_does_not_load(self):
        self.client.open(URI, PROGRAM.replace('END', ''))
        self.assertEqual(self.hints(), [])


if __name__ == '__main__':
    lsp_session.arbiter = sys.argv.pop(1)
    unittest.main()
