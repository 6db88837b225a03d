#!/usr/bin/env python3
"""Tests `arbiter report` from outside: the page as html.parser reads it and as Chromium shows it, and its JSON twin.

usage: report_test.py ARBITER SOURCE_ROOT LIGHTING [unittest arguments]
LIGHTING is the demonstration of that name, or - to skip its capture.
"""
import concurrent.futures
import contextlib
import http.server
import json
import os
import pathlib
import pty
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import zlib

from html_page import Page
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402

ARBITER, ROOT, LIGHTING = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
CHROMIUM = shutil.which('chromium') or shutil.which('chromium-browser')
HOSTILE = (b'!!ARBfp1.0\r\n# \xe9 \x01 </td></table><script>document.title = "owned"</script>'
           b'<img src=x onerror=alert(1)> &amp;\nMOV result.color, \tnothing;\nEND\n')


def run(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=120,
                          env=plain(), errors='replace', **more)


def alu(count):
    return ('!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n' + 'MUL a, a, a.wxyz;\n' * (count - 2) +
            'MOV result.color, a;\nEND\n').encode()


class Folder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='arbiter-report-')
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)
        self.page = self.scratch / 'page.html'

    def put(self, name, text):
        path = self.scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)
        return path

    def put_set(self):
        """Writes a set with one program of each verdict and language, in folders."""
        shutil.copytree(ROOT / 'demos' / 'programs', self.scratch / 'set' / 'demos')
        self.put('set/deep/er/wide.fp', alu(70))
        self.put('set/hostile <b>&.fp', HOSTILE)
        self.put('set/header only', b'!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n')
        self.put('set/readme.txt', b'no program')
        return self.scratch / 'set'

    def report(self, *words, code=0):
        result = run(ARBITER, 'report', '-o', self.page, '--json', *words)
        self.assertEqual(result.returncode, code, result.stderr)
        return Page(self.page.read_text(encoding='utf-8')), json.loads(result.stdout)


class Content(Folder):
    def test_a_folder(self):
        page, twin = self.report(self.put_set())
        self.assertEqual(page.problems(), [])
        self.assertEqual(twin['schema'], 2)
        self.assertEqual(twin['summary'], {'programs': 11, 'valid': 9, 'over_native': 1,
                                           'invalid': 1, 'unreadable': 0})
        names = [program['name'] for program in twin['programs']]
        self.assertEqual(names[-3:], ['demos/twirl.fp', 'header only', 'hostile <b>&.fp'])
        for name in names:
            self.assertEqual(len(page.find('a', text=name)) + len(page.find('h3', text=name)),
                             3 if name.endswith('wide.fp') else 2, name)
        self.assertNotIn('readme.txt', self.page.read_text())
        section, = [s for s in page.find('details', **{'class': 'program'}) if 'hostile' in s['text']]
        self.assertIn('# \\xE9 \\x01 </td></table><script>document.title', section['text'])
        self.assertIn("error: 'nothing' is not declared", section['text'])

    def test_a_programs_section_has_its_source_and_its_counts(self):
        page, twin = self.report(self.put_set())
        text = (ROOT / 'demos' / 'programs' / 'lighting.fp').read_text()
        index = [program['name'] for program in twin['programs']].index('demos/lighting.fp')
        section, = page.find('details', id=f'p{index + 1}')
        for i, line in enumerate(text.splitlines()):
            row, = page.find('tr', id=f'p{index + 1}-{i + 1}')
            self.assertTrue(row['text'].endswith(line), line)
        for row in twin['programs'][index]['check']['counts'].values():
            self.assertIn(f'{row["native_used"]} / {row["native_limit"]}', section['text'])

    def test_what_does_not_fit_is_said_with_its_reasons(self):
        page, twin = self.report('--profile', 'r300-catalyst-2004', self.put('wide.fp', alu(70)))
        list_, = page.find('ul', **{'class': 'misfits'})
        counts = twin['programs'][0]['check']['counts']['alu_instructions']
        self.assertIn(f'ALU instructions {counts["native_used"]} of 64', list_['text'])
        for reason in twin['programs'][0]['check']['native']['reasons']:
            if reason['resource'] == 'alu_instructions':
                self.assertIn(reason['text'], page.find('details', id='p1')[0]['text'])

    def test_lines_cost_what_their_instructions_cost(self):
        _, twin = self.report(self.put_set())
        for program in twin['programs']:
            native = program['check'].get('native', {'instructions': []})
            lines = {line['line']: line for line in program.get('lines', [])}
            self.assertAlmostEqual(sum(line['slots'] for line in lines.values()),
                                   sum(each['slots'] for each in native['instructions']))
            for each in native['instructions']:
                self.assertGreaterEqual(lines[each['line']]['slots'], each['slots'])

    def test_histograms_count_every_valid_program(self):
        _, twin = self.report(self.put_set())
        counted = {each['language']: sum(bin_['programs'] for bin_ in each['bins'])
                   for each in twin['histograms']}
        self.assertEqual(counted, {'ARBfp1.0': 9, 'ARBvp1.0': 1})

    def test_what_cannot_be_read(self):
        page, twin = self.report(self.put('good.fp', alu(3)), self.scratch / 'none.fp', code=1)
        self.assertEqual(page.problems(), [])
        self.assertEqual(twin['summary']['unreadable'], 1)
        self.assertIn('No such file', twin['faults'][0])
        empty = self.scratch / 'empty'
        empty.mkdir()
        result = run(ARBITER, 'report', '-o', self.scratch / 'not.html', empty)
        self.assertEqual(result.returncode, 1)
        self.assertIn('no programs in this folder', result.stderr)
        self.assertFalse((self.scratch / 'not.html').exists())
        for words in (['-o', '/nowhere/x.html', self.page], ['--profile', 'voodoo', self.page],
                      ['-o', '-', '--json', self.page], []):
            self.assertEqual(run(ARBITER, 'report', *words).returncode, 1)

    def test_standard_output(self):
        result = run(ARBITER, 'report', '-o', '-', self.put('good.fp', alu(3)))
        self.assertEqual(Page(result.stdout).problems(), [])
        self.assertIn('programs: 1, fit: 1', result.stderr)

    def test_a_thousand_programs(self):
        for i in range(1000):
            self.put(f'many/{i}.fp', alu(3 + i % 90) + b'# %d\n' % i)
        master, slave = pty.openpty()
        result = subprocess.run([ARBITER, 'report', self.scratch / 'many', '-o', self.page],
                                stderr=slave, timeout=60)
        os.close(slave)
        said = b''
        with contextlib.suppress(OSError):  # the end of a terminal that nobody has open is an error
            while part := os.read(master, 1 << 16):
                said += part
        os.close(master)
        self.assertIn(b'programs: 1000', said)
        self.assertEqual(result.returncode, 0)
        self.assertLess(self.page.stat().st_size, 24 << 20)


@unittest.skipUnless(os.path.exists(LIGHTING), 'there is nothing to capture')
class Captured(Folder):
    def test_draws_and_parameters_of_a_capture(self):
        folder = self.scratch / 'lighting.capture'
        result = run(ARBITER, 'capture', '--profile', 'nv30', '-o', folder, '--', LIGHTING,
                     '--headless', '--size', '32x32', '--frames', '3')
        self.assertEqual(result.returncode, 0, result.stderr)
        page, twin = self.report(folder)
        self.assertEqual(page.problems(), [])
        self.assertTrue(twin['captured'])
        self.assertEqual(twin['profile']['name'], 'nv30')  # the profile of the capture
        program, = twin['programs']
        self.assertEqual((program['capture']['draws'], program['capture']['loads']), (3, 1))
        section, = page.find('details', id='p1')
        self.assertIn('loaded 1 time, 3 draws', section['text'])
        self.assertIn('program.local[0]', section['text'])
        self.assertIn('draws', page.find('thead')[0]['text'])
        row, = [row for row in page.find('tr') if 'data-s' in row]
        self.assertRegex(row['text'], '^' + program['capture']['hash'][:12] + r'\.fp.*3$')
        self.assertEqual(self.report('--profile', 'i915', folder)[1]['profile']['name'], 'i915')


def corner(path):
    """Returns the color of a PNG's first pixel, and its size."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack('>IIBB', data[16:26])
    assert depth == 8 and kind in (2, 6), 'not RGB of 8 bits'
    at, packed = 8, b''
    while at < len(data):
        length, name = struct.unpack('>I4s', data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if name == b'IDAT' else b''
        at += 12 + length
    return tuple(zlib.decompress(packed)[1:4]), (width, height)  # a first pixel has no neighbors


# The probe runs in a copy of the page without the policy, and reports what a person would see.
PROBE = '''<script>
const told = {titles: [], gauges: []};
const table = document.getElementById("programs");
const names = () => Array.from(table.tBodies[0].rows).filter(row => !row.hidden)
    .map(row => row.cells[0].textContent);
const head = key => table.tHead.querySelector(`[data-k=${key}]`);
for (const gauge of document.querySelectorAll(".gauges .gauge")) {
  gauge.closest("details").open = true;
  const used = gauge.firstElementChild.getBoundingClientRect().width;
  const colour = getComputedStyle(gauge.firstElementChild);
  told.gauges.push({text: gauge.closest("tr").cells[2].textContent,
                    part: used / gauge.clientWidth, colour: colour.backgroundColor,
                    drawn: gauge.clientWidth > 50 && gauge.clientHeight > 5});
}
const button = head("alu").querySelector("button");
button.focus();
told.focus = document.activeElement === button;
button.click();
told.first = [names()[0], head("alu").ariaSort, location.hash];
button.click();
told.second = [names()[0], head("alu").ariaSort, location.hash];
head("name").querySelector("button").click();
told.third = [names()[0], head("name").ariaSort];
const form = document.getElementById("find");
form.elements.filter.value = "DEMOS life";
form.dispatchEvent(new Event("input"));
told.filtered = names();
told.sections = document.querySelectorAll("details.program:not([hidden])").length;
told.count = form.querySelector("output").textContent;
location.hash = "#p1-2";
setTimeout(() => {
  const section = document.getElementById("p1");
  told.shown = section.open && !section.hidden;
  const pre = document.createElement("pre");
  pre.id = "told";
  pre.textContent = JSON.stringify(told);
  document.body.append(pre);
}, 50);
</script></body>'''


@unittest.skipUnless(CHROMIUM, 'not installed: chromium')
class Browser(Folder):
    def chromium(self, address, *options):
        with tempfile.TemporaryDirectory(prefix='arbiter-chromium-') as profile:
            result = run(CHROMIUM, '--headless=new', '--no-sandbox', '--disable-gpu',
                         '--disable-component-update', '--disable-background-networking',
                         '--hide-scrollbars', f'--user-data-dir={profile}',
                         '--virtual-time-budget=2000', *options, address)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def dom(self, address):
        return Page(self.chromium(address, '--dump-dom'))

    def each(self, function, arguments):
        """Returns the results of calls that run in parallel."""
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            return list(pool.map(function, arguments))

    def test_the_address_sorts_and_filters(self):
        _, report = self.report(self.put_set())
        page = self.dom(f'{self.page.as_uri()}#sort=-alu&status=fits&filter=.fp')
        head, = page.find('th', **{'data-k': 'alu'})
        self.assertEqual(head['aria-sort'], 'ascending')
        rows = [row for row in page.find('tr') if 'data-s' in row]
        self.assertEqual(len(rows), 11)
        shown = [row for row in rows if 'hidden' not in row]
        self.assertEqual({row['data-s'] for row in shown}, {'fits'})
        self.assertEqual(len(shown), 8)
        twin = {program['name']: program['check'] for program in report['programs']}
        counts = [next(check['counts']['alu_instructions']['native_used']
                       for name, check in twin.items() if row['text'].startswith(name))
                  for row in shown]
        self.assertEqual(counts, sorted(counts))
        self.assertGreater(counts[-1], counts[0])
        self.assertEqual(page.find('output')[0]['text'], '8 of 11 shown')

    def test_what_a_person_does(self):
        self.report(self.put_set())
        copy = self.put('copy.html', self.page.read_bytes().replace(b'http-equiv', b'name').replace(
            b'</body>', PROBE.encode()))
        told = json.loads(self.dom(copy.as_uri()).find('pre', id='told')[0]['text'])
        self.assertTrue(told['focus'])
        self.assertEqual(told['first'], ['deep/er/wide.fp', 'descending', '#sort=alu'])
        self.assertEqual(told['second'][1:], ['ascending', '#sort=-alu'])
        self.assertEqual(told['third'], ['deep/er/wide.fp', 'ascending'])
        self.assertEqual(told['filtered'], ['demos/life_naive.fp', 'demos/life_pack.fp',
                                            'demos/life_packed.fp'])
        self.assertEqual((told['sections'], told['count']), (3, '3 of 11 shown'))
        self.assertTrue(told['shown'], 'a link to a line does not open its section')
        self.assertGreater(len(told['gauges']), 50)
        colours = {}
        for gauge in told['gauges']:
            used, limit = (int(word) for word in gauge['text'].split('over')[0].split(' / '))
            self.assertTrue(gauge['drawn'], gauge)
            self.assertAlmostEqual(gauge['part'], min(1, used / limit), delta=0.02)
            colours.setdefault(used > limit, set()).add(gauge['colour'])
        self.assertFalse(colours[True] & colours[False])

    def test_the_policy_holds_off_scripts_and_the_network(self):
        asked = set()

        class Server(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                asked.add(self.path)
                self.send_error(404)

            def log_message(self, *_):
                pass

        with http.server.ThreadingHTTPServer(('127.0.0.1', 0), Server) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            place = f'http://127.0.0.1:{server.server_port}'
            self.report(self.put_set())
            copies = []
            for name, policy in (('held', b'http-equiv'), ('free', b'name')):
                injected = (f'<script>document.title = "owned"</script><img src="{place}/{name}" '
                            f'onerror="document.title = \'owned\'"><style>body {{ background: '
                            f'url({place}/{name}) }}</style><iframe src="{place}/{name}"></iframe></body>')
                text = self.page.read_bytes().replace(b'http-equiv', policy)
                copies.append(self.put(name + '.html', text.replace(b'</body>', injected.encode())).as_uri())
            held, free = (page.find('title')[0]['text'] for page in self.each(self.dom, copies))
            self.assertEqual(asked, {'/free'})  # this proves that the trial is effective
            self.assertTrue(held.startswith('Programs of'))
            self.assertEqual(free, 'owned')
            server.shutdown()

    def test_a_picture_in_light_and_in_dark(self):
        self.report(self.put_set())

        def picture_of(scheme):
            picture = self.scratch / f'{scheme}.png'
            self.chromium(self.page.as_uri(), f'--screenshot={picture}', '--window-size=800,600',
                          f'--blink-settings=preferredColorScheme={scheme}')
            colour, size = corner(picture)
            self.assertEqual(size, (800, 600))
            self.assertGreater(picture.stat().st_size, 20000, 'nothing is drawn')
            return colour

        colours = self.each(picture_of, (1, 0))  # Blink's numbers: light, dark
        self.assertEqual(colours, [(0xFF, 0xFF, 0xFF), (0x16, 0x19, 0x1C)])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
