#!/usr/bin/env python3
"""Tests of the actions that `arbiter lsp` offers: code actions and the adviser's list.

usage: lsp_actions_test.py ARBITER [UNITTEST ARGUMENTS...]
"""
import sys
import unittest

import lsp_session
from lsp_client import place
from lsp_session import ATI, URI, Session

NAIVE = """!!ARBfp1.0
# \U0001d11e the places of what follows count UTF-16
TEMP t, u;
MUL t, fragment.color, 3.0;
MAX t, t, 0.0;
MIN t, t, 1.0;
MUL u, program.local[0], program.local[2];
SGE u, fragment.color, u;
MUL result.color, u, t;
END
"""


class Actions(Session):
    capabilities = {'textDocument': {'codeAction': {'disabledSupport': True}}}

    def actions(self, text, begin, end=None, only=None, uri=URI):
        context = {'diagnostics': []}
        if only is not None:
            context['only'] = only
        return self.client.request('textDocument/codeAction', {
            'textDocument': {'uri': uri}, 'context': context,
            'range': {'start': place(text, begin), 'end': place(text, end or begin)}})

    @staticmethod
    def edited(text, edit, uri=URI):
        """Returns the text after a WorkspaceEdit by LSP's rules: all positions refer to the text before."""
        lines = [line.encode('utf-16-le') for line in text.split('\n')]
        begins = [sum(len(line) + 2 for line in lines[:i]) for i in range(len(lines))]
        data = text.encode('utf-16-le')

        def byte(position):
            return begins[position['line']] + 2 * position['character']
        edits = list(enumerate(edit['changes'][uri]))
        for _, change in sorted(edits, key=lambda e: (byte(e[1]['range']['start']), e[0]),
                                reverse=True):
            spot = change['range']
            data = data[:byte(spot['start'])] + change['newText'].encode('utf-16-le') \
                + data[byte(spot['end']):]
        return data.decode('utf-16-le')

    def advice(self):
        return self.client.request('arbiter/advice', {'textDocument': {'uri': URI}})

    def test_is_announced(self):
        provider = self.initialized['capabilities']['codeActionProvider']
        self.assertEqual(provider, {'codeActionKinds': ['quickfix', 'refactor.rewrite'],
                                    'resolveProvider': True})

    def test_a_fix_can_be_made(self):
        self.client.open(URI, NAIVE)
        found = [a for a in self.actions(NAIVE, 'MAX t') if a['kind'] == 'quickfix']
        self.assertEqual(len(found), 1, found)
        self.assertIn('_SAT', found[0]['title'])
        self.assertRegex(found[0]['title'], r'\(r300: ALU \d+ -> \d+\)')
        text = self.edited(NAIVE, found[0]['edit'])
        self.assertIn('MUL_SAT t, fragment.color, 3.0;', text)
        self.assertNotIn('MAX', text)
        self.assertEqual(self.client.open(URI, text), [])
        self.assertEqual([a for a in self.advice() if a['rule'] == 'clamp_by_sat'], [])

    def test_places(self):
        self.client.open(URI, NAIVE)
        self.assertEqual(self.actions(NAIVE, 'TEMP t, u'), [])
        titles = [a['title'] for a in self.actions(NAIVE, 'MUL t', 'END')]
        self.assertTrue(any('_SAT' in each for each in titles), titles)
        self.assertTrue(any('CMP' in each for each in titles), titles)

    def test_kinds(self):
        self.client.open(URI, NAIVE)
        for only, kinds in ((['quickfix'], {'quickfix'}), (['refactor'], {'refactor.rewrite'}),
                            (['refactor.rewrite'], {'refactor.rewrite'}), (['source'], set()),
                            (['refactor.extract'], set()), ([], {'quickfix', 'refactor.rewrite'})):
            found = self.actions(NAIVE, 'MUL t', 'END', only)
            self.assertEqual({a['kind'] for a in found}, kinds, only)

    def test_advice_is_disabled_with_its_reason(self):
        self.client.open(URI, NAIVE)
        found = [a for a in self.actions(NAIVE, 'MUL u') if 'disabled' in a]
        self.assertEqual(len(found), 1, found)
        self.assertIn('program.local[1]', found[0]['disabled']['reason'])
        self.assertNotIn('edit', found[0])

    def test_every_fix(self):
        self.client.open(URI, NAIVE)
        action = next(a for a in self.actions(NAIVE, 'MAX t') if a['title'].startswith('Make every'))
        self.assertEqual(action['kind'], 'refactor.rewrite')
        self.assertNotIn('edit', action)
        text = self.edited(NAIVE, self.client.request('codeAction/resolve', action)['edit'])
        self.assertIn('MUL_SAT', text)
        self.assertIn('CMP', text)
        self.assertIn('# \U0001d11e the places', text)
        self.assertEqual(self.client.open(URI, text), [])
        self.assertFalse(any(each['fix'] for each in self.advice()))

    def test_list(self):
        self.client.open(URI, NAIVE)
        found = {each['rule']: each for each in self.advice()}
        clamp, work = found['clamp_by_sat'], found['parameter_work']
        self.assertTrue(clamp['fix'] and clamp['exact'])
        self.assertEqual(clamp['range']['start'], place(NAIVE, 'MAX t'))
        self.assertLess(clamp['after']['alu'], clamp['before']['alu'])
        self.assertEqual(set(clamp['before']), {'alu', 'tex', 'nodes', 'fits'})
        self.assertEqual(self.edited(NAIVE, {'changes': {URI: clamp['edits']}}).count('_SAT'), 1)
        self.assertFalse(work['fix'])
        self.assertEqual(work['edits'], [])
        self.assertIn('program.local[1]', self.edited(NAIVE, {'changes': {URI: work['sketch']}}))

    def test_follows_the_profile_and_the_text(self):
        self.client.open(URI, NAIVE)
        self.assertNotIn('dead_work', {each['rule'] for each in self.advice()})
        dead = NAIVE.replace('MUL u', 'MOV u, t;\nMUL u')
        self.client.open(URI, dead)
        self.assertNotIn('needless_copy', {each['rule'] for each in self.advice()})
        self.client.notify('workspace/didChangeConfiguration', {'settings': {'profile': 'host'}})
        self.client.diagnostics(URI)
        self.assertIn('dead_work', {each['rule'] for each in self.advice()})

    def test_a_name_that_was_meant(self):
        text = '!!ARBfp1.0\nTEMP offset;\nMOV offset, fragment.color;\n' \
               'MOV result.color, ofset;\nEND\n'
        published = self.client.open(URI, text)
        found = self.actions(text, 'ofset')
        self.assertEqual([a['title'] for a in found], ["Change to 'offset'"])
        self.assertEqual(found[0]['diagnostics'], published)
        self.assertEqual(self.client.open(URI, self.edited(text, found[0]['edit'])), [])

    def test_of_nothing(self):
        self.client.open('file:///c.atifs', ATI)
        self.assertEqual(self.actions(ATI, 'MAD r0', uri='file:///c.atifs'), [])
        for params in ({}, {'textDocument': {'uri': 'file:///none'}},
                       {'textDocument': {'uri': URI}, 'range': {'start': 7}}):
            self.assertEqual(self.client.failure('textDocument/codeAction', params)['code'], -32602)
            self.client.open(URI, NAIVE)
        self.assertEqual(self.client.failure('arbiter/advice', {})['code'], -32602)
        self.assertEqual(self.client.failure('codeAction/resolve', {'title': 'x'})['code'], -32602)


class Plain(Session):
    def test_a_client_that_shows_no_disabled_actions(self):
        self.client.open(URI, NAIVE)
        found = self.client.request('textDocument/codeAction', {
            'textDocument': {'uri': URI}, 'context': {'diagnostics': []},
            'range': {'start': place(NAIVE, 'MUL t'), 'end': place(NAIVE, 'END')}})
        self.assertTrue(found)
        self.assertFalse(any('disabled' in a for a in found))


if __name__ == '__main__':
    lsp_session.arbiter = sys.argv.pop(1)
    unittest.main()
