"""Collects the keys and types of the JSON that users get: each report is made of fixed inputs and read.

No source declares these documents as a whole, so the keys are those that examples have. In return each name that the
sources write must have been seen: an example that lacks one stops the collection.
"""
import json
import pathlib
import re
import subprocess
import sys

import known
from sources import ROOT, Broken, generate
from trees import Tree
from style import style_of

sys.path.insert(0, str(ROOT / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

SECONDS = 120
WRONG = '!!ARBfp1.0\nTEMP unused;\nMOV result.color, q;\nEND\n'
LONG = '!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n' + 'ADD a, a, a;\n' * 70 + 'MOV result.color, a;\nEND\n'
NODES = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n' +
         'TEX a, a, texture[0], 2D;\n' * 5 + 'MOV result.color, a;\nEND\n')
VERTEX = ('!!ARBvp1.0\nPARAM c[2] = { program.env[0..1] };\nADDRESS A;\nARL A.x, vertex.attrib[7].x;\n'
          'MOV result.position, c[A.x];\nMOV result.color, vertex.color;\nEND\n')
TWO = VERTEX + '\n!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
ADVISED = ('!!ARBfp1.0\nTEMP a;\nMUL a, fragment.color, 2.0;\nADD a, a, 1.0;\nMAX a, a, 0.0;\nMIN a, a, 1.0;\n'
           'MOV result.color, a;\nEND\n')
KILLS = ('!!ARBfp1.0\n#@ size 32 32\nTEMP a, b;\nSUB a, fragment.texcoord[0], 0.25;\nKIL a.xxxx;\n'
         'RCP b.x, a.x;\nMUL b.x, b.x, 0.0;\nMUL result.color, a, b.x;\nEND\n')
SEEN = ('!!ARBfp1.0\n#@ size 16 16\n#@ mesh cube\n#@ texture 0 = checker 16 16\n'
        '#@ local[0].x "level" = 0 in 0..1 animate saw 1s\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n'
        'MUL result.color, t, program.local[0].x;\nEND\n')
TEXTS = {'wrong.fp': WRONG, 'long.fp': LONG, 'nodes.fp': NODES, 'vertex.vp': VERTEX, 'two.vfp': TWO,
         'advised.fp': ADVISED, 'kills.fp': KILLS, 'seen.fp': SEEN,
         'unwritten.fp': '!!ARBfp1.0\n#@ size 8 8\nTEMP a;\nADD result.color, a, 1.0;\nEND\n',
         'nan.fp': '!!ARBfp1.0\n#@ size 8 8\nTEMP b;\nPARAM z = {0, 0, 0, 0};\nRCP b, z.x;\nMUL b, b, z;\n'
                   'MOV result.color, b;\nEND\n',
         'over.fp': LONG.replace('TEMP', '#@ profile nv40\nTEMP', 1),
         'fog.fp': '!!ARBfp1.0\nOPTION ARB_fog_exp2;\nMOV result.color, fragment.color;\nEND\n',
         'combiners.nvrc': '!!RC1.0\nout.rgb = col0;\nout.a = col0.a;\n'}
FLOATS = r'(value|second|coordinate|drawn|least|greatest|watch\.pixel)\[\]$|\.(bias|lod|error)$'
CAPTURES = (('kept0', (), 'seen.fp'), ('kept1', (), 'over.fp'), ('kept2', ('--limits', 'report'), 'over.fp'),
            ('kept3', (), 'fog.fp'), ('kept4', (), ROOT / 'demos/gallery/gooch.fp'))
COUNTS = ('counts', 'native_counts')


class Runs:
    """Runs a built command on texts in a folder of its own."""

    def __init__(self, arbiter, folder):
        self.arbiter, self.folder = str(pathlib.Path(arbiter).resolve()), pathlib.Path(folder)
        for name, text in TEXTS.items():
            (self.folder / name).write_text(text)
        for name in ('cache', 'run', 'config'):
            (self.folder / name).mkdir(exist_ok=True)
        (self.folder / 'run').chmod(0o700)

    def environment(self, **more):
        return plain(XDG_CACHE_HOME=str(self.folder / 'cache'), XDG_RUNTIME_DIR=str(self.folder / 'run'),
                     XDG_CONFIG_HOME=str(self.folder / 'config'), **more)

    def run(self, *words, **more):
        plain_words = [word if isinstance(word, bytes) else str(word) for word in words]
        return subprocess.run([self.arbiter, *plain_words], capture_output=True, text=True, cwd=self.folder,
                              env=self.environment(**more), timeout=SECONDS, stdin=subprocess.DEVNULL)

    def document(self, *words, **more):
        """Returns the JSON that a command prints."""
        result = self.run(*words, **more)
        try:
            return json.loads(result.stdout)
        except ValueError as error:
            raise Broken(f'arbiter {" ".join(map(str, words))}: no JSON: {error}: {result.stderr.strip()}') from error

    def read(self, name):
        try:
            return json.loads((self.folder / name).read_text())
        except (OSError, ValueError) as error:
            raise Broken(f'{name}: {error}') from error


def tree(name, **options):
    made = Tree(**options)
    made.name = name
    return made


def checks(runs):
    """Returns the trees of `arbiter check` in its three forms, and of `arbiter report`."""
    named = {f'files[].{counts}' for counts in COUNTS}
    check = tree('check', named=named, maps={'files[].native.cycles.units'})
    names = ['wrong.fp', 'long.fp', 'nodes.fp', 'vertex.vp', 'two.vfp', 'advised.fp', 'missing.fp']
    for card in ('r300', 'nv30', 'i915'):
        check.add(runs.document('check', '--json', '--advise', '--profile', card, *names))
    check.add(runs.document('check', '--json', '--profile', 'nv20', 'combiners.nvrc', 'long.fp'))
    check.add(runs.document('check', '--json', '--advise', ROOT / 'demos/gallery/gooch.fp'))
    check.add(runs.document('check', '--json', '--limits', 'report', 'long.fp'))
    (runs.folder / 'fixed.fp').write_text(ADVISED)
    check.add(runs.document('check', '--json', '--advise', '--fix', 'fixed.fp'))
    with open(bytes(runs.folder) + b'/\xff.fp', 'w') as file:
        file.write(ADVISED)
    check.add(runs.document('check', '--json', b'\xff.fp'))
    cards = tree('check --profile all', maps={'summary.valid_by_profile'})
    cards.add(runs.document('check', '--json', '--profile', 'all', *names, 'seen.fp'))
    compare = tree('check --compare', same={'files[]': (check, 'files[]')}, named={'compare.resources'})
    for pair in (('advised.fp', 'seen.fp'), ('wrong.fp', 'long.fp'), ('nodes.fp', 'kills.fp')):
        compare.add(runs.document('check', '--json', '--compare', *pair))
    compare.add(runs.document('check', '--json', '--compare', '--profile', 'r300', '--profile', 'nv30', 'nodes.fp'))
    report = tree('report', same={'programs[].check': (check, 'files[]')})
    report.add(runs.document('report', '--json', '-o', 'page.html', *names))
    for folder, words, name in CAPTURES:
        runs.run('capture', *words, '-o', folder, '--', runs.arbiter, 'draw', '--bare', '-o', 'drawn.png', name)
        report.add(runs.document('report', '--json', '-o', 'page.html', folder))
    return [check, cards, compare, report]


def compiles(runs):
    made = tree('compile')
    made.add(runs.document('compile', '--json', '--emit', 'ir', 'two.vfp'))
    made.add(runs.document('compile', '--json', 'wrong.fp'))
    made.add(runs.document('compile', '--json', '--emit', 'native', 'nodes.fp'))
    return [made]


def lists(runs):
    """Returns the trees of defaults, profiles, cache and doctor."""
    (runs.folder / 'bad.toml').write_text('[[program]]\ntitle = "x"\nsett = 1\nmatch = { name = "x" }\n')
    listed, chosen = tree('defaults', maps={'entries[].set'}), tree('defaults COMMAND', maps={'choice.settings'})
    listed.add(runs.document('defaults', '--json'))
    listed.add(runs.document('defaults', '--json', '--check', ROOT / 'docs/use/defaults_template.toml'))
    listed.add(runs.document('defaults', '--json', '--check', 'bad.toml'))
    (runs.folder / 'glquake.exe').write_bytes(b'MZ' + bytes(64))
    chosen.add(runs.document('defaults', '--json', '--', 'wine', './glquake.exe'))
    chosen.add(runs.document('defaults', '--json', '--check', 'bad.toml', '--', '/bin/true'))
    tables = ('api', 'native', 'state', 'model', 'vertex_api', 'vertex_native', 'vertex_state', 'identity')
    names, one = tree('profiles'), tree('profiles NAME', maps=tables)
    names.add(runs.document('profiles', '--json'))
    for card in ('r300', 'nv40', 'host'):
        one.add(runs.document('profiles', '--json', card))
    cache = tree('cache')
    cache.add(runs.document('cache', '--json'))
    doctor = tree('doctor')
    doctor.add(runs.document('doctor', '--json', '--', '/bin/true'))
    doctor.add(runs.document('doctor', '--json', '--', './missing'))
    return [listed, chosen, names, one, cache, doctor]


def pictures(runs):
    """Returns the trees of draw and debug."""
    draw = tree('draw')
    for words in (('seen.fp',), ('--frames', '3', 'seen.fp'), ('--bare', 'kills.fp'),
                  ('--feedback', '0', '--frames', '2', 'nodes.fp')):
        draw.add(runs.document('draw', '--json', '-o', 'drawn.png', *words))
    debug = tree('debug')
    debug.same['against.trace'] = (debug, '')
    for words in (('seen.fp', '--frame', '7'), ('kills.fp', '--pixel', '2,2'), ('kills.fp', '--pixel', '20,20'),
                  ('kills.fp', '--pixel', '20,20', '--break', 'unwritten'), ('kills.fp', '--watch', 'b@6'),
                  ('nan.fp', '--break', 'nan', '--numerics', 'host'), ('kills.fp', '--numerics', 'fp24'),
                  ('kills.fp', '--pixel', '20,20', '--against', 'fp24'),
                  ('kills.fp', '--pixel', '20,20', '--against', 'seen.fp'),
                  ('kills.fp', '--watch', 'b@6', '-o', 'watched.png'),
                  ('unwritten.fp',), ('seen.fp', '--against', 'host', '--numerics', 'fp24'),
                  (ROOT / 'demos/gallery/twirl.fp',)):
        debug.add(runs.document('debug', '--json', *words))
    for place in list(debug.kinds):  # where a number can be "nan"
        if debug.kinds[place] & {'number'} and re.search(FLOATS, place):
            debug.kinds[place].add('text')
    vertices = tree('debug --stage vertex', same={'vertices[]': (debug, '')})
    vertices.add(runs.document('debug', '--json', '--stage', 'vertex', '--pixel', '256,380',
                               ROOT / 'demos/gallery/gooch.fp'))
    return [draw, debug, vertices]


def processes(runs, trees):
    """Returns the trees of statistics and captures, which a process under the layer leaves."""
    one = tree('statistics', maps={'draws.reasons', 'software.given_to_host', 'feedback.kinds'},
               named={f'programs[].{counts}' for counts in COUNTS},
               same={'defaults': (trees['defaults COMMAND'], 'choice')})
    drawn = ('draw', '-o', 'drawn.png')
    for name, words in (('a', ('seen.fp',)), ('b', ('long.fp',)), ('c', ('--limits', 'report', 'long.fp')),
                        ('d', ('--bare', 'seen.fp'))):
        runs.run(*drawn, '--stats', f'{name}.json', *words)
        if (runs.folder / f'{name}.json').exists():
            one.add(runs.read(f'{name}.json'))
    summed = tree('stats', maps={f'{part}.{name}' for part in ('files[].reports[]', 'sum')
                                 for name in ('draws', 'given_to_host')})
    summed.add(runs.document('stats', '--json', 'a.json', 'b.json'))
    named = {f'programs[].{counts}' for counts in COUNTS}
    draws = {'programs[].draws_by'}
    index = tree('capture index.json', named=named, maps=draws)
    record = tree('capture process-PID.json', named=named, maps=draws)
    for folder, _, _ in CAPTURES:
        index.add(runs.read(f'{folder}/index.json'))
        for path in sorted((runs.folder / folder).glob('process-*.json')):
            record.add(json.loads(path.read_text()))
    return [one, summed, index, record]


def report_of_editor(runs, check):
    """Adds what the language server answers to arbiter/report, which is a file of `arbiter check`."""
    uri = (runs.folder / 'nodes.fp').as_uri()
    document = {'uri': uri, 'languageId': 'arbprogram', 'version': 1, 'text': NODES}
    asked = (('initialize', {'capabilities': {}}), ('arbiter/report', {'textDocument': {'uri': uri}}), ('shutdown', {}))
    messages = [{'id': number, 'method': method, 'params': params} for number, (method, params) in enumerate(asked)]
    messages[1:1] = [{'method': 'textDocument/didOpen', 'params': {'textDocument': document}}]
    messages.append({'method': 'exit'})
    bodies = [json.dumps({'jsonrpc': '2.0', **message}).encode() for message in messages]
    sent = b''.join(b'Content-Length: %d\r\n\r\n%s' % (len(body), body) for body in bodies)
    result = subprocess.run([runs.arbiter, 'lsp'], input=sent, capture_output=True, env=runs.environment(),
                            timeout=SECONDS)
    answers = [json.loads(part) for part in re.split(rb'Content-Length: \d+\r\n\r\n', result.stdout) if part]
    check.add(next(answer for answer in answers if answer.get('id') == 1)['result'], 'files[]')


COMMANDS = {'check': 'arbiter check --json FILE...', 'report': 'arbiter report --json FILE...',
            'check --profile all': 'arbiter check --profile all --json FILE...',
            'check --compare': 'arbiter check --compare --json FILE FILE',
            'compile': 'arbiter compile --json FILE', 'defaults': 'arbiter defaults --json',
            'defaults COMMAND': 'arbiter defaults --json -- COMMAND', 'profiles': 'arbiter profiles --json',
            'profiles NAME': 'arbiter profiles --json NAME', 'cache': 'arbiter cache --json',
            'doctor': 'arbiter doctor --json -- COMMAND', 'draw': 'arbiter draw --json FILE',
            'debug': 'arbiter debug --json FILE, and arbiter/trace', 'statistics': 'arbiter run --stats FILE',
            'debug --stage vertex': 'arbiter debug --stage vertex --json FILE', 'stats': 'arbiter stats --json FILE...',
            'capture index.json': 'arbiter capture -o FOLDER', 'capture process-PID.json': 'arbiter capture -o FOLDER'}


# The sources that write reports. Those of the second row write them by nlohmann's initializers.
WRITERS = ('apps/tools/**/*.cpp', 'state/report/*.cpp', 'state/statistics/*.cpp', 'state/raster_draw/report.cpp',
           'util/defaults/report.cpp', 'fp_compiler/resources.cpp')
INITIALIZERS = ('debug/json.cpp', 'debug/findings.cpp', 'debug/command.cpp', 'draw/command.cpp')


def written():
    """Returns the names of members that the sources write, with a source of each."""
    names = {}
    for pattern in WRITERS:
        for path in sorted((ROOT / 'src').glob(pattern)):
            if path.name.endswith('_test.cpp'):
                continue
            text, found = path.read_text(), set()
            found.update(re.findall(r'\bkey\("([\w -]+)"\)', text))
            if str(path).endswith(INITIALIZERS):
                found.update(re.findall(r'\{"(\w+)",\s|\bjson\["(\w+)"\]', text))
            for name in found:
                names[max(name, key=len) if isinstance(name, tuple) else name] = path
    return names


def check_names(entries):
    """Compares the names in the entries with those in the sources, and the statistics with their table."""
    places = [entry['key'] for entry in entries]
    seen = {part.rstrip('[]{}') for place in places for part in re.split(r'[. ]', place)}
    seen |= {name for entry in entries for name in entry.get('choices', ())}
    for name, path in sorted(written().items()):
        if name not in seen:
            raise Broken(f'{path}: writes "{name}", which no example of docs/interface/reports.py shows')
    for place, _ in generate.rows_of(ROOT / 'src/state/statistics/members.def', 'ARBITER_MEMBER'):
        if f'statistics {place}' not in places:
            raise Broken(f'src/state/statistics/members.def: no example has {place}')


def collect(runs):
    """Returns the entries of every report."""
    trees = [each for part in (checks, compiles, lists, pictures) for each in part(runs)]
    trees += processes(runs, {each.name: each for each in trees})
    report_of_editor(runs, trees[0])
    style_of(trees)
    entries = []
    for each in trees:
        entries.append({'key': each.name, 'command': COMMANDS[each.name]})
        entries += each.entries(each.name)
    entries = known.complete(entries, known.REPORTS)
    check_names(entries)
    return entries
