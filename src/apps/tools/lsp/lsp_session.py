"""The texts and the initialized server that tests of the language server share."""
import unittest

from lsp_client import Client, place

arbiter = ''  # the command under test, set before tests run
URI = 'file:///tmp/a.fp'

PROGRAM = """!!ARBfp1.0
# a comment with \U0001d11e and \u00e4 before what follows
TEMP r0, colour;
PARAM tint = { 0.5, 1, 0.25, 1 };
PARAM rows[] = { state.matrix.texture[1] };
ATTRIB uv = fragment.texcoord[0];
OUTPUT out = result.color;
ALIAS second = colour;
TEX colour, uv, texture[0], 2D;
MUL_SAT r0.xyz, second, tint;
DP4 r0.w, colour, rows[2];
MOV out, r0;
END
"""

ATI = """!!ATIfs1.0
StartConstants;
CONSTANT c1 = program.env[3];
EndConstants;
StartOutputPass;
SampleMap r1, t0.str;
MAD r0.rgb.2x, r1, c1, color0.r;
EndPass;
"""

VERTEX = """!!ARBvp1.0
OPTION ARB_position_invariant;
ADDRESS A0;
PARAM bones[] = { program.env[0..7] };
ARL A0.x, vertex.attrib[1].x;
MOV result.color, bones[A0.x + 1];
END
"""


def serve(*options):
    return Client([arbiter, 'lsp', *options])


def labels(items):
    return [item['label'] for item in items]


class Session(unittest.TestCase):
    capabilities = {}
    options = None

    def setUp(self):
        self.client = serve('--profile', 'r300')
        self.addCleanup(self.client.drop)
        self.initialized = self.client.initialize(self.capabilities, self.options)

    def at(self, text, mark, after=0, uri=URI):
        return {'textDocument': {'uri': uri}, 'position': place(text, mark, after)}

    def hover(self, text, mark, after=0, uri=URI):
        result = self.client.request('textDocument/hover', self.at(text, mark, after, uri))
        return result['contents']['value'] if result else ''

    def complete(self, text, uri=URI):
        """Returns the labels that are offered at the mark | of a text."""
        cut = text.index('|')
        whole = text[:cut] + text[cut + 1:]
        self.client.open(uri, whole)
        position = place(text, '|')
        return labels(self.client.request('textDocument/completion', {
            'textDocument': {'uri': uri}, 'position': position}))

    def words(self, text, locations):
        """Returns the texts at the locations' ranges."""
        lines = text.split('\n')
        found = []
        for location in locations:
            spot = location.get('range', location)
            line = lines[spot['start']['line']].encode('utf-16-le')
            found.append(line[2 * spot['start']['character']:2 * spot['end']['character']]
                         .decode('utf-16-le'))
        return found
