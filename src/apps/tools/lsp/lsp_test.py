#!/usr/bin/env python3
"""Tests of `arbiter lsp` with a client that speaks JSON-RPC over pipes, as an editor does. lsp_requests_test.py tests
requests about a position in a text.

usage: lsp_test.py ARBITER [UNITTEST ARGUMENTS...]
"""
import random
import statistics
import sys
import time
import unittest

import lsp_session
from lsp_client import Closed, place
from lsp_session import ATI, PROGRAM, URI, VERTEX, Session, serve

# A program over r300's limits, without its header.
LONG = 'TEMP a;\nMOV a, fragment.color;\n' + 'MUL a, a, a;\n' * 79 + 'MOV result.color, a;\nEND\n'


class Lifecycle(unittest.TestCase):
    def start(self):
        client = serve()
        self.addCleanup(client.drop)
        return client

    def test_shutdown_and_exit(self):
        client = self.start()
        result = client.initialize()
        self.assertEqual(result['serverInfo']['name'], 'arbiter')
        self.assertEqual(result['capabilities']['positionEncoding'], 'utf-16')
        self.assertEqual(client.leave(), 0)

    def test_exit_without_shutdown(self):
        client = self.start()
        client.initialize()
        client.notify('exit')
        self.assertEqual(client.ended(), 1)

    def test_end_of_input(self):
        client = self.start()
        client.initialize()
        self.assertEqual(client.ended(), 1)

    def test_requests_before_and_after(self):
        client = self.start()
        self.assertEqual(client.failure('textDocument/hover')['code'], -32002)
        client.notify('textDocument/didOpen', {'textDocument': {'uri': URI, 'text': 'x'}})
        client.initialize()
        self.assertEqual(client.failure('initialize')['code'], -32600)
        self.assertEqual(client.failure('workspace/nonsense')['code'], -32601)
        client.notify('nonsense/notification')
        client.notify('$/setTrace', {'value': 'off'})
        # The text that was opened too early was ignored.
        self.assertEqual(client.failure('textDocument/hover', {
            'textDocument': {'uri': URI}, 'position': {'line': 0, 'character': 0}})['code'], -32602)
        client.request('shutdown')
        self.assertEqual(client.failure('textDocument/hover')['code'], -32600)
        client.notify('exit')
        self.assertEqual(client.ended(), 0)

    def test_broken_messages(self):
        client = self.start()
        client.initialize()
        for body, code in ((b'{', -32700), (b'\xff\xfe', -32700), (b'', -32700),
                           (b'[]', -32600), (b'17', -32600), (b'{"jsonrpc":"2.0"}', -32600),
                           (b'{"jsonrpc":"2.0","method":"x","id":[[1]]}', -32600),
                           (b'[' * 100000, -32700),
                           (b'{"jsonrpc":"2.0","method":3,"id":4}', -32600)):
            client.send_body(body)
            self.assertEqual(client.receive()['error']['code'], code, body[:60])
        for header in (b'Content-Length: x\r\n\r\n', b'Nonsense\r\n\r\n',
                       b'Content-Length: -4\r\n\r\n', b'\r\n\r\n', b'y' * 9000):
            client.send_bytes(header)
            self.assertEqual(client.receive()['error']['code'], -32700, header[:40])
        # Responses without a request and parameters of any shape must not stop the server.
        client.send({'id': 99, 'result': None})
        for method in ('textDocument/hover', 'textDocument/completion', 'textDocument/rename',
                       'textDocument/inlayHint', 'textDocument/documentSymbol'):
            for params in ([], 3, None, {'textDocument': 7}, {'textDocument': {'uri': []}}):
                client.failure(method, params)
        for params in ([], {'textDocument': {}}, {'textDocument': {'uri': 1, 'text': 2}}):
            client.notify('textDocument/didOpen', params)
            client.notify('textDocument/didChange', params)
            client.notify('workspace/didChangeConfiguration', params)
        self.assertEqual(client.leave(), 0)

    def test_one_byte_at_a_time(self):
        client = self.start()
        body = client.encode({'id': 'a', 'method': 'initialize', 'params': {'capabilities': {}}})
        for byte in b'content-length: %d\r\nContent-Type: x\r\n\r\n%s' % (len(body), body):
            client.send_bytes(bytes([byte]))
        self.assertEqual(client.receive()['id'], 'a')

    def test_cancelled_requests(self):
        client = self.start()
        client.initialize()
        client.open(URI, PROGRAM)
        spot = {'textDocument': {'uri': URI}, 'position': place(PROGRAM, 'MOV')}
        messages = [{'id': 100 + i, 'method': 'textDocument/hover', 'params': spot}
                    for i in range(20)]
        messages.insert(10, {'method': '$/cancelRequest', 'params': {'id': 109}})
        messages.append({'method': '$/cancelRequest', 'params': {'id': 119}})
        messages.append({'method': '$/cancelRequest', 'params': {'id': 5000}})
        # Sent together, so that they wait together.
        client.send_bytes(b''.join(b'Content-Length: %d\r\n\r\n%s' % (len(m), m)
                                   for m in map(client.encode, messages)))
        answers = [client.receive() for _ in range(20)]
        self.assertEqual([a['id'] for a in answers], list(range(100, 120)))
        cancelled = [a['id'] for a in answers if a.get('error', {}).get('code') == -32800]
        self.assertIn(119, cancelled)
        self.assertLessEqual(set(cancelled), {109, 119})

    def test_unknown_profile(self):
        client = serve('--profile', 'nonsense')
        self.addCleanup(client.drop)
        self.assertRaises(Closed, client.receive)
        self.assertEqual(client.ended(), 1)


class Diagnostics(Session):
    def test_a_good_program_has_none(self):
        self.assertEqual(self.client.open(URI, PROGRAM), [])

    def test_each_has_range_code_and_hint(self):
        found = self.client.open(URI, PROGRAM.replace('MUL_SAT r0.xyz', 'MULL r0.xyz')
                                 .replace('MOV out, r0', 'MOV out, color'))
        self.assertEqual([d['code'] for d in found], ['unknown_instruction', 'undeclared_name'])
        self.assertEqual(found[0]['severity'], 1)
        self.assertEqual(found[0]['range'], {'start': {'line': 9, 'character': 0},
                                             'end': {'line': 9, 'character': 4}})
        self.assertIn("did you mean 'MUL'?", found[0]['message'])
        self.assertIn("hint: did you mean 'colour'?", found[1]['message'])

    def test_wrong_lines_of_a_panel(self):
        found = self.client.open(URI, '!!ARBfp1.0\n#@ blend ad, size 4\n'
                                      'MOV result.color, fragment.color;\nEND\n')
        self.assertEqual([(each['code'], each['severity']) for each in found],
                         [('panel_word', 2), ('panel_syntax', 1)])
        self.assertEqual(found[0]['range'], {'start': {'line': 1, 'character': 9},
                                             'end': {'line': 1, 'character': 11}})
        self.assertIn("did you mean 'add'?", found[0]['message'])

    def test_a_second_declaration_points_at_the_first(self):
        found = self.client.open(URI, '!!ARBfp1.0\nTEMP a;\nPARAM a = {1};\nEND\n')
        self.assertEqual(found[0]['code'], 'redeclared_name')
        related = found[0]['relatedInformation'][0]['location']
        self.assertEqual(related['range']['start'], {'line': 1, 'character': 5})

    def test_edits(self):
        self.client.open(URI, PROGRAM)
        mark = place(PROGRAM, 'MOV out')
        # One notification has two edits; the second refers to the text after the first.
        self.client.change(
            URI, 2,
            {'range': {'start': mark, 'end': mark}, 'text': 'MOV out, nothing;\n'},
            {'range': {'start': mark, 'end': {**mark, 'character': 3}}, 'text': 'ABS'})
        found = self.client.diagnostics(URI)
        self.assertEqual(found['version'], 2)
        self.assertEqual([d['code'] for d in found['diagnostics']], ['undeclared_name'])
        self.assertEqual(found['diagnostics'][0]['range']['start'],
                         {'line': mark['line'], 'character': 9})
        self.client.change(URI, 3, {'text': PROGRAM})
        self.assertEqual(self.client.diagnostics(URI)['diagnostics'], [])

    def test_positions_count_utf16(self):
        text = '!!ARBfp1.0 # \U0001d11e\U0001d11e\u00e4\r\nPARAM a = 1; # \U0001d11e\r\n' \
               'MOV result.color, a; # \U0001d11e\r\nEND # \u20ac\n'
        self.assertEqual(self.client.open(URI, text), [])
        # The edit replaces the clef in line 2 (two units); the "a" after it must stay.
        self.client.change(URI, 2, {'range': {'start': {'line': 2, 'character': 18},
                                              'end': {'line': 2, 'character': 25}},
                                    'text': 'b; #x'})
        found = self.client.diagnostics(URI)['diagnostics']
        self.assertEqual(found[0]['range'], {'start': {'line': 2, 'character': 18},
                                             'end': {'line': 2, 'character': 19}})
        one = '!!ARBfp1.0\nTEMP a; # \U0001d11e\n MOV result.color, b; END'
        self.client.change(URI, 3, {'text': one})
        self.client.diagnostics(URI)
        self.client.change(URI, 4, {'range': {'start': {'line': 1, 'character': 10},
                                              'end': {'line': 1, 'character': 12}}, 'text': ''},
                           {'range': {'start': {'line': 1, 'character': 8},
                                      'end': {'line': 2, 'character': 1}}, 'text': ''})
        found = self.client.diagnostics(URI)['diagnostics']
        self.assertEqual(found[0]['range']['start'], {'line': 1, 'character': 26})

    def test_a_character_is_marked_as_a_whole(self):
        found = self.client.open(URI, '!!ARBfp1.0\nTEMP a;\nMOV a, \U0001d11e;\nEND')
        self.assertEqual(found[0]['range'], {'start': {'line': 2, 'character': 7},
                                             'end': {'line': 2, 'character': 9}})

    def test_edits_beyond_the_text(self):
        self.client.open(URI, '!!ARBfp1.0\nEND')
        self.client.change(URI, 2, {'range': {'start': {'line': 1, 'character': 900},
                                              'end': {'line': 70, 'character': 3}},
                                    'text': '\nx'})
        self.assertEqual(self.client.diagnostics(URI)['diagnostics'][0]['code'], 'text_after_end')

    def test_random_edits_leave_the_same_text(self):
        """After each of many edits, the server must find the same as in the new text opened again."""
        text, other = PROGRAM, 'file:///tmp/other.fp'
        self.client.open(URI, text)
        seed = 12345
        for version in range(2, 80):
            seed = (seed * 1103515245 + 12345) & 0x7fffffff
            start = seed % (len(text) + 1)
            end = min(len(text), start + seed // 1000 % 5)
            piece = ['', 'a', '\n', ';', '\U0001d11e', '\r\n', '# \u00e4', 'MOV r0, r0;'][
                seed // 7 % 8]
            first, last = (text[:start], text[:end])
            spot = [{'line': t.count('\n') + t.count('\r') - t.count('\r\n'),
                     'character': len(t.replace('\r', '\n').rpartition('\n')[2]
                                      .encode('utf-16-le')) // 2} for t in (first, last)]
            if '\r\n' in text[max(start - 1, 0):start + 1] + text[max(end - 1, 0):end + 1]:
                continue  # no position lies between CR and LF
            text = text[:start] + piece + text[end:]
            self.client.change(URI, version, {'range': {'start': spot[0], 'end': spot[1]},
                                              'text': piece})
            edited = self.client.diagnostics(URI)['diagnostics']
            fresh = self.client.open(other, text)
            for found in edited + fresh:
                found.pop('relatedInformation', None)
            self.assertEqual(edited, fresh, repr(text))

    def test_over_the_native_limits(self):
        # Five dependent samples make five indirections, one more than the card has.
        chain = ''.join(f'TEX a, {"fragment.texcoord[0]" if i == 0 else "a"}, texture[0], 2D;\n'
                        'MUL a, a, a;\n' for i in range(5))
        found = self.client.open(URI, f'!!ARBfp1.0\nTEMP a;\n{chain}MOV result.color, a;\nEND\n')
        self.assertTrue(found)
        self.assertTrue(any('indirections' in d['message'] for d in found), found)

    def test_what_a_valid_program_hardly_means(self):
        text = '!!ARBfp1.0\nTEMP a, b;\nMOV b, 1.0;\nMOV result.color, a;\nEND\n'
        found = self.client.open(URI, text)
        self.assertEqual([(d['code'], d['severity'], d['range']['start']) for d in found],
                         [('unused_write', 2, {'line': 2, 'character': 4}),
                          ('unwritten_temporary', 2, {'line': 3, 'character': 18})])
        report = self.client.request('arbiter/report', {'textDocument': {'uri': URI}})
        self.assertEqual([d['id'] for d in report['diagnostics']], ['unused_write', 'unwritten_temporary'])

    def test_a_card_without_fragment_programs(self):
        self.client.notify('workspace/didChangeConfiguration', {'settings': {'arbiter': {'profile': 'nv25'}}})
        chain = 'TEX a, a, texture[0], 2D;\nMUL a, a, a;\n' * 6
        said = 'nv25: the card has no fragment programs'
        for body in ('', chain):  # the second is over limits that say nothing of the card
            uri = f'file:///programless{len(body)}.fp'
            found = self.client.open(uri, f'!!ARBfp1.0\nTEMP a;\nMOV a, 1.0;\n{body}MOV result.color, a;\nEND\n')
            self.assertEqual([(d['code'], d['message']) for d in found], [('over_native', said)])
        whole = {'start': {'line': 0, 'character': 0}, 'end': {'line': 9, 'character': 0}}
        hints = self.client.request('textDocument/inlayHint', {
            'textDocument': {'uri': 'file:///programless0.fp'}, 'range': whole})
        self.assertEqual(hints[0]['label'], said)

    def test_over_the_native_limits_alone(self):
        # The driver's announced limits are above the chip's.
        self.client.notify('workspace/didChangeConfiguration',
                           {'settings': {'arbiter': {'profile': 'r300-catalyst-2004'}}})
        chain = ''.join(f'TEX a, {"fragment.texcoord[0]" if i == 0 else "a"}, texture[0], 2D;\n'
                        'MUL a, a, a;\n' for i in range(5))
        found = self.client.open(URI, f'!!ARBfp1.0\nTEMP a;\n{chain}MOV result.color, a;\nEND\n')
        over = [d for d in found if d['code'] == 'over_native']
        self.assertTrue(over, found)
        self.assertEqual({d['severity'] for d in over}, {2})
        self.assertIn('5 of 4 TEX indirections', over[0]['message'])
        self.assertEqual(over[0]['range']['start']['line'], 0)
        # The last node begins at the fifth sample, and the reason names the register that it waits for.
        last = over[-1]
        self.assertEqual(last['range']['start'], {'line': 10, 'character': 0})
        self.assertRegex(last['message'], 'TEX reads a, which MUL wrote in node 4')

    def test_the_profile_can_change(self):
        long_one = '!!ARBfp1.0\n' + LONG
        self.assertTrue(self.client.open(URI, long_one))
        self.client.notify('workspace/didChangeConfiguration',
                           {'settings': {'arbiter': {'profile': 'nv30'}}})
        self.assertEqual(self.client.diagnostics(URI)['diagnostics'], [])
        self.client.notify('workspace/didChangeConfiguration', {'settings': {'profile': 'r3'}})
        message = self.client.wait(lambda m: m.get('method') == 'window/showMessage')
        self.assertIn('r3', message['params']['message'])

    def test_the_panel_names_the_profile(self):
        client = serve()
        self.addCleanup(client.drop)
        client.initialize()
        self.assertEqual(client.open(URI, '!!ARBfp1.0\n#@ profile nv30\n' + LONG), [])
        report = client.request('arbiter/report', {'textDocument': {'uri': URI}})
        self.assertEqual((report['profile'], report['status']), ('nv30', 'valid'))
        client.change(URI, 2, {'text': '!!ARBfp1.0\n' + LONG})
        self.assertTrue(client.diagnostics(URI)['diagnostics'])
        # An editor's requested profile takes precedence over the panel's.
        client.change(URI, 3, {'text': '!!ARBfp1.0\n#@ profile nv30\n' + LONG})
        self.assertEqual(client.diagnostics(URI)['diagnostics'], [])
        client.notify('workspace/didChangeConfiguration', {'settings': {'profile': 'r300'}})
        self.assertTrue(client.diagnostics(URI)['diagnostics'])
        client.notify('workspace/didChangeConfiguration', {'settings': {'profile': ''}})
        self.assertEqual(client.diagnostics(URI)['diagnostics'], [])

    def test_texts_that_are_not_whole(self):
        found = self.client.open(URI, 'TEMP a;\nMOV a, b;\n')
        self.assertEqual([d['code'] for d in found],
                         ['header_missing', 'undeclared_name', 'end_missing'])
        for text in ('', '!', '!!ARBfp1.0', '!!ARBfp1.', '\n\n', '#', '!!ARBfp1.0\nMOV'):
            self.assertTrue(self.client.open(URI, text), repr(text))
            for end in range(len(text) + 1):
                self.client.request('textDocument/completion', {
                    'textDocument': {'uri': URI}, 'position': {'line': 0, 'character': end}})
                self.client.request('textDocument/hover', {
                    'textDocument': {'uri': URI}, 'position': {'line': 0, 'character': end}})

    def test_a_text_over_the_limit(self):
        found = self.client.open(URI, '!!ARBfp1.0\n' + '#' * (1 << 20))
        self.assertEqual([d['code'] for d in found], ['text_too_long'])
        self.client.request('textDocument/documentSymbol', {'textDocument': {'uri': URI}})

    def test_several_texts(self):
        other = 'file:///tmp/b.vp'
        self.assertEqual(self.client.open(URI, PROGRAM), [])
        self.assertEqual(self.client.open(other, VERTEX), [])
        self.assertEqual(self.client.open('file:///tmp/c.atifs', ATI), [])
        self.client.notify('textDocument/didClose', {'textDocument': {'uri': URI}})
        self.assertEqual(self.client.diagnostics(URI)['diagnostics'], [])
        self.assertIn('address register', self.hover(VERTEX, 'A0;', 1, other))
        self.client.failure('textDocument/hover', self.at(PROGRAM, 'MOV'))

    def test_the_language_without_a_header(self):
        self.assertEqual([d['code'] for d in self.client.open('file:///tmp/x.vp', 'ADDRESS a;\n')],
                         ['header_missing', 'end_missing'])
        self.assertIn('MOV',
                      self.complete('StartOutputPass;\n|', uri='file:///tmp/x.atifs'))


class Utf8(Session):
    capabilities = {'general': {'positionEncodings': ['utf-16', 'utf-8']}}

    def test_positions_count_bytes(self):
        self.assertEqual(self.initialized['capabilities']['positionEncoding'], 'utf-8')
        self.client.open(URI, '!!ARBfp1.0\n# \U0001d11e\nEND')
        self.client.change(URI, 2, {'range': {'start': {'line': 1, 'character': 2},
                                              'end': {'line': 1, 'character': 6}}, 'text': '\nx'})
        found = self.client.diagnostics(URI)['diagnostics']
        self.assertEqual(found[0]['range']['start'], {'line': 2, 'character': 0})


class Profile(Session):
    options = {'profile': 'nv30'}

    def test_of_the_initialization(self):
        text = '!!ARBfp1.0\n' + LONG
        self.assertEqual(self.client.open(URI, text), [])

    def test_languages_of_nvidia(self):
        begin = '!!FP1.0\nDECLARE tint = {1, 0.5};\n'
        text = begin + 'MUL R0, f[COL0], tint;\nMOV o[COLR], R0;\nEND\n'
        self.assertEqual(self.client.open(URI, text), [])
        self.assertIn('MUL', self.hover(text, 'MUL'))
        words = self.complete(begin + '|')
        self.assertIn('X2D', words)
        self.assertIn('DECLARE', words)
        self.assertNotIn('SWZ', words)
        self.assertNotIn('TEMP', words)
        self.assertIn('o[COLH]', self.complete(begin + 'MUL |'))
        self.assertLessEqual({'f[WPOS]', 'f[TEX7]', 'tint'},
                             set(self.complete(begin + 'MUL R0, |')))
        self.assertIn('BRA', self.complete('!!VP2.0\n|'))
        self.assertNotIn('BRA', self.complete('!!VP1.1\n|'))
        self.assertIn('v[WGHT]', self.complete('!!VP1.0\nMOV R0, |'))
        self.assertIn('!!VP2.0', self.complete('!!|'))


class Hostile(Session):
    PIECES = ['', ';', '.', '[', ']', '{', '}', '=', ',', 'MOV ', 'TEX ', 'state.', 'fragment.',
              'c[', 'A0.x', '\n', '\r', '\r\n', '# ', '!!', '!!ATIfs1.0\n', '!!ARBvp1.0\n',
              '!!FP1.0\n', '!!VP2.0\n', '\U0001d11e', '\u00e4', 'SWZ a, b, ', 'OPTION ', 'ALIAS x = ', 'PARAM p[] = { ',
              'SampleMap r1, t0.', '\0', '0', '1.5', '2D', '.2x', '-', 'END']
    METHODS = ['hover', 'completion', 'definition', 'references', 'documentHighlight',
               'prepareRename', 'rename', 'documentSymbol', 'semanticTokens/full', 'inlayHint']

    def test_texts_in_pieces(self):
        """The server must answer each request and go on, whatever the text contains."""
        chance = random.Random(7)
        for at in range(150):
            text = chance.choice([PROGRAM, VERTEX, ATI])
            for _ in range(chance.randrange(1, 6)):
                start = chance.randrange(len(text) + 1)
                end = min(len(text), start + chance.choice([0, 1, 3, 40]))
                text = text[:start] + chance.choice(self.PIECES) + text[end:]
            text = text[:chance.randrange(len(text) + 1)] if at % 3 == 0 else text
            self.client.open(URI, text)
            for _ in range(4):
                spot = {'line': chance.randrange(14), 'character': chance.randrange(30)}
                asked = [self.client.ask('textDocument/' + method, {
                    'textDocument': {'uri': URI}, 'position': spot, 'newName': 'x',
                    'range': {'start': spot, 'end': {'line': 99, 'character': 0}}})
                    for method in self.METHODS]
                for identity in asked:
                    code = self.client.response(identity).get('error', {}).get('code', -32803)
                    self.assertEqual(code, -32803, text)
        self.assertEqual(self.client.leave(), 0)


class Latency(Session):
    def test_of_edits_in_96_instructions(self):
        """Measures from the last byte of didChange to the complete publishDiagnostics."""
        body = ''.join(f'TEX a, uv, texture[{i % 4}], 2D;\n' for i in range(32))
        body += ''.join('MAD b.xyz, a, c[1].wzyx, -b;\n' for i in range(63))
        text = ('!!ARBfp1.0\nTEMP a, b;\nATTRIB uv = fragment.texcoord[0];\n'
                'PARAM c[2] = { program.local[0..1] };\n' + body + 'MOV result.color, b;\nEND\n')
        self.assertEqual([d for d in self.client.open(URI, text) if d['severity'] == 1], [])
        lines = text.split('\n')
        spent = []
        last = 0
        for version in range(2, 102):
            line = 4 + (version * 37) % 95
            # Insert a letter that breaks the line, then restore the line.
            broken = version % 2 == 0
            target = line if broken else last
            spot = {'start': {'line': target, 'character': 0},
                    'end': {'line': target, 'character': 0 if broken else 1}}
            last = line
            begin = time.perf_counter()
            self.client.change(URI, version, {'range': spot, 'text': 'X' if broken else ''})
            found = self.client.diagnostics(URI)
            spent.append((time.perf_counter() - begin) * 1000)
            errors = [d for d in found['diagnostics'] if d['severity'] == 1]
            self.assertEqual(len(errors), 1 if broken else 0, (lines[target], errors))
        print(f'diagnostics after an edit of 96 instructions, 100 edits: median '
              f'{statistics.median(spent):.2f} ms, worst {max(spent):.2f} ms', file=sys.stderr)
        self.assertLess(statistics.median(spent), 50)


if __name__ == '__main__':
    lsp_session.arbiter = sys.argv.pop(1)
    unittest.main()
