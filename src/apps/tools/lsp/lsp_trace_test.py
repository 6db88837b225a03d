#!/usr/bin/env python3
"""Tests of `arbiter lsp`'s own request arbiter/trace, through the layer.

usage: lsp_trace_test.py ARBITER [UNITTEST ARGUMENTS...]
"""
import sys
import unittest

import lsp_session
from lsp_client import place
from lsp_session import URI, Session

TEXT = """!!ARBfp1.0
#@ size 16 8, mesh quad, camera none
#@ local[0] = 0.5 0.25 0.125 1
TEMP a;
MUL a, fragment.texcoord[0], program.local[0];
KIL -a.z;
MOV result.color, a;
END
"""
DOCUMENT = {'textDocument': {'uri': URI}}


class Trace(Session):
    def hints(self):
        everything = {'start': {'line': 0, 'character': 0}, 'end': {'line': 99, 'character': 0}}
        hints = self.client.request('textDocument/inlayHint', {**DOCUMENT, 'range': everything})
        return [hint['label'] for hint in hints
                if hint['label'].startswith('= ') or hint['label'] == 'passed']

    def trace(self, *pixel, **more):
        return self.client.request('arbiter/trace', {**DOCUMENT, 'pixel': pixel, **more})

    def test_the_text_as_the_editor_has_it(self):
        self.client.open(URI, TEXT)
        self.assertEqual(self.hints(), [])
        trace = self.trace(5, 3)
        self.assertEqual(trace['rows'][0]['value'], [5.5 / 16 * 0.5, 3.5 / 8 * 0.25, 0, 1])
        self.assertTrue(trace['verdict']['equal'], trace['summary'])
        self.assertEqual(self.hints(), ['= (0.1719, 0.1094, 0, 1)', 'passed',
                                        '= (0.1719, 0.1094, 0, 1)'])
        self.assertIn('(0.34375, 0.4375, 0, 1)', self.hover(TEXT, 'MUL a', 1))
        self.assertEqual(self.trace(6, 3)['rows'][0]['value'][0], 6.5 / 16 * 0.5)
        at = place(TEXT, '0.25')
        self.client.change(URI, 2, {'range': {'start': at, 'end': {**at, 'character': at['character'] + 4}},
                                    'text': '0.5'})
        self.assertEqual(self.hints(), [], 'those were of another text')
        self.assertEqual(self.trace(5, 3)['rows'][0]['value'][1], 3.5 / 8 * 0.5)
        self.assertIn('16x8', self.client.failure('arbiter/trace', {**DOCUMENT, 'pixel': [16, 0]})['message'])
        self.assertEqual(self.hints(), [], 'those were of another pixel')
        self.assertEqual(self.trace(5, 3)['rows'][0]['value'][1], 3.5 / 8 * 0.5)
        self.assertIsNone(self.client.request('arbiter/trace', {**DOCUMENT, 'pixel': None}))
        self.assertEqual(self.hints(), [])

    def test_what_cannot_be(self):
        self.assertIn('no open document', self.client.failure('arbiter/trace', DOCUMENT)['message'])
        self.client.open(URI, TEXT)
        for params in ({}, {'pixel': [1]}, {'pixel': [1, 2, 3]}, {'pixel': ['a', 1]}, {'pixel': [-1, 1]},
                       {'pixel': [1, 1], 'against': 'nothing'}, {'pixel': 7}, {'pixel': [1e99, 1]}):
            self.assertEqual(self.client.failure('arbiter/trace', {**DOCUMENT, **params})['code'], -32602)
        self.assertIn('16x8', self.client.failure('arbiter/trace',
                                                  {**DOCUMENT, 'pixel': [16, 0]})['message'])
        self.assertIn('one pass', self.client.failure(
            'arbiter/trace', {**DOCUMENT, 'pixel': [1, 1], 'pass': 9})['message'])
        self.client.change(URI, 2, {'text': TEXT.replace('MUL', 'MULL')})
        self.assertIn('MULL', self.client.failure('arbiter/trace',
                                                  {**DOCUMENT, 'pixel': [1, 1]})['message'])
        self.client.change(URI, 3, {'text': TEXT})
        self.assertTrue(self.trace(1, 1, against='host')['verdict']['equal'])


if __name__ == '__main__':
    lsp_session.arbiter = sys.argv.pop(1)
    unittest.main()
