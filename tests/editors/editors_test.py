#!/usr/bin/env python3
"""Tests of editors/: the syntax files and plugins in a real vim, Neovim and Emacs, the extension in node and as
a package, the JSON files.

usage: editors_test.py ARBITER SOURCE_ROOT [unittest arguments]
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from xml.etree import ElementTree

ARBITER, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
VIM, VSCODE = ROOT / 'editors' / 'vim', ROOT / 'editors' / 'vscode'

FRAGMENT = """!!ARBfp1.0
# a MOV in a comment
OPTION ARB_fog_exp2;
TEMP MOVE, a;
PARAM p = state.light[0].spot.direction;
TEX a.rgb, fragment.texcoord[1], texture[0], 2D;
MAD_SAT a.xyz, -p.wzyx, 1.5e3, MOVE;
ARL a.x, a.x;
END
"""
VERTEX = """!!ARBvp1.0
ADDRESS A0;
ARL A0.x, vertex.attrib[3].y;
SIN a, a;
MOV result.color.back.secondary, a;
END
"""
ATI = """!!ATIfs1.0
StartOutputPass;
SampleMap r1, t0.stq_dq;
DOT2ADD r0.rgb.2x, r1.comp, c3, 1;
EndPass;
"""


class Vim(unittest.TestCase):
    def setUp(self):
        if not shutil.which('vim'):
            self.skipTest('not installed: vim')
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_vim(self, file, script):
        """Returns the lines that the script appends to g:out, in a vim that has the file open."""
        out, source = self.folder / 'out', self.folder / 'script.vim'
        source.write_text(f"let g:out = []\n{script}\ncall writefile(g:out, '{out}')\nqall!\n")
        done = subprocess.run(
            ['vim', '-es', '-u', 'NONE', '-i', 'NONE', '-N',
             '--cmd', f'set runtimepath^={VIM}', '-c', 'filetype plugin on', '-c', 'syntax on',
             '-c', f'edit {file}', '-S', str(source)],
            capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL,
            env={**os.environ, 'TERM': 'dumb',
                 'PATH': f'{os.path.dirname(ARBITER)}:{os.environ["PATH"]}'})
        self.assertTrue(out.exists(), done.stdout + done.stderr)
        return out.read_text().splitlines()

    def groups(self, text, marks, name='a.arbfp'):
        """Returns the syntax group at each mark: a piece of text that occurs once, and an offset in it."""
        file = self.folder / name
        file.write_text(text)
        script = ''
        for mark, after in marks:
            self.assertEqual(text.count(mark), 1, mark)
            before = text[:text.index(mark) + after]
            line, column = before.count('\n') + 1, len(before.rpartition('\n')[2]) + 1
            script += f"call add(g:out, synIDattr(synID({line}, {column}, 1), 'name'))\n"
        return self.run_vim(file, script)

    def test_fragment_programs(self):
        wanted = {('!!ARBfp', 3): 'arbHeader', ('MOV in', 0): 'arbComment',
                  ('OPTION', 0): 'arbStatement', ('ARB_fog_exp2', 5): 'arbOption',
                  ('TEMP', 0): 'arbStatement', ('MOVE, a;', 0): '', ('state', 0): 'arbBinding',
                  ('light', 0): 'arbMember', ('direction', 2): 'arbMember',
                  ('TEX ', 0): 'arbOpcode', ('.rgb', 1): 'arbSuffix', ('fragment', 1): 'arbBinding',
                  ('texcoord', 1): 'arbMember', ('2D', 0): 'arbTarget', ('2D', 1): 'arbTarget',
                  ('MAD_SAT', 5): 'arbOpcode', ('wzyx', 3): 'arbSuffix', ('1.5e3', 0): 'arbNumber',
                  ('1.5e3', 4): 'arbNumber', ('[1]', 1): 'arbNumber', ('ARL', 0): '',
                  ('END', 0): 'arbStatement', ('texture[', 0): 'arbBinding'}
        self.assertEqual(self.groups(FRAGMENT, wanted), list(wanted.values()))

    def test_vertex_programs(self):
        wanted = {('ADDRESS', 0): 'arbStatement', ('ARL', 0): 'arbOpcode',
                  ('vertex', 0): 'arbBinding', ('attrib', 0): 'arbMember', ('SIN', 0): '',
                  ('back', 0): 'arbMember', ('secondary', 0): 'arbMember', ('y;', 0): 'arbSuffix'}
        self.assertEqual(self.groups(VERTEX, wanted, 'b.arbvp'), list(wanted.values()))

    def test_ati(self):
        wanted = {('StartOutputPass', 0): 'arbStatement', ('SampleMap', 0): 'arbStatement',
                  ('r1,', 0): 'arbBinding', ('stq_dq', 5): 'arbMember', ('DOT2ADD', 5): 'arbOpcode',
                  ('rgb', 0): 'arbSuffix', ('2x', 0): 'arbMember', ('comp', 0): 'arbMember',
                  ('c3', 0): 'arbBinding', (' 1;', 1): 'arbNumber'}
        self.assertEqual(self.groups(ATI, wanted, 'c.atifs'), list(wanted.values()))

    def test_file_types(self):
        for name, text in (('x', FRAGMENT), ('x.vp', VERTEX), ('x.glsl', FRAGMENT),
                           ('x.atifs', ''), ('x.arbvp', 'TEMP'), ('x.vfp', '# a pair\n\n' + VERTEX)):
            file = self.folder / name
            file.write_text(text)
            self.assertEqual(self.run_vim(file, 'call add(g:out, &filetype)'), ['arbprogram'], name)
        (self.folder / 'y').write_text('int main;')
        self.assertNotEqual(self.run_vim(self.folder / 'y', 'call add(g:out, &filetype)'),
                            ['arbprogram'])

    def test_quickfix(self):
        file = self.folder / 'bad.arbfp'
        file.write_text('!!ARBfp1.0\nMOV result.color, q;\nEND\n\0')
        lines = subprocess.run([ARBITER, 'check', '--brief', str(file)], capture_output=True,
                               text=True, timeout=60).stdout
        self.assertEqual(lines.count('\n'), 2, lines)
        show = "for e in getqflist()\n call add(g:out, join([bufname(e.bufnr) =~# 'bad', " \
               "e.lnum, e.col, e.type, e.text], '|'))\nendfor"
        # :cgetexpr uses the global value, :make the buffer's.
        found = self.run_vim(file, 'let &g:errorformat = &l:errorformat\n'
                                   f'cgetexpr {json.dumps(lines)}\n{show}')
        self.assertEqual([entry.split('|')[:4] for entry in found],
                         [['1', '2', '19', 'e'], ['1', '4', '1', 'w']])
        self.assertIn('[undeclared_name]', found[0])
        # This runs :make itself, with a name that a shell would split.
        awkward = self.folder / "a 'b.arbfp"
        shutil.copy(file, awkward)
        found = self.run_vim(str(awkward).replace(' ', '\\ ').replace("'", "\\'"),
                             f'set shellredir=>%s\\ 2>&1\nsilent make! --profile=nv30\n{show}')
        self.assertEqual([entry.split('|')[1:4] for entry in found if '|19|' in entry],
                         [['2', '19', 'e']], found)


class VsCode(unittest.TestCase):
    def read(self, name):
        return json.loads((VSCODE / name).read_text())

    def test_manifest(self):
        manifest = self.read('package.json')
        self.assertTrue((VSCODE / manifest['main']).exists())
        self.assertNotIn('dependencies', manifest)
        language, = manifest['contributes']['languages']
        grammar, = manifest['contributes']['grammars']
        self.assertEqual(grammar['language'], language['id'])
        self.assertIn(f'onLanguage:{language["id"]}', manifest['activationEvents'])
        self.assertTrue((VSCODE / language['configuration']).exists())
        self.assertEqual(self.read(grammar['path'])['scopeName'], grammar['scopeName'])
        for header in ('!!ARBfp1.0', '!!ARBvp1.0', '!!ATIfs1.0'):
            self.assertRegex(header, language['firstLine'])
        self.read(language['configuration'])

    def patterns(self, node, found):
        if isinstance(node, dict):
            for key, value in node.items():
                if key in ('match', 'begin', 'end'):
                    found.append(value)
                else:
                    self.patterns(value, found)
        elif isinstance(node, list):
            for value in node:
                self.patterns(value, found)
        return found

    def test_grammar(self):
        grammar = self.read('syntaxes/arbprogram.tmLanguage.json')
        found = self.patterns(grammar, [])
        self.assertGreater(len(found), 20)
        for pattern in found:
            re.compile(pattern)
        for node in json.dumps(grammar).split('"include": "')[1:]:
            self.assertIn(node.split('"')[0].lstrip('#'), grammar['repository'])

    def scope(self, part, text, mark, after=0):
        """Returns the first rule that matches at the place, in TextMate's order."""
        grammar = self.read('syntaxes/arbprogram.tmLanguage.json')
        at = text.index(mark) + after
        for rule in grammar['repository'][part]['patterns']:
            if 'include' in rule:
                rule = grammar['repository'][rule['include'].lstrip('#')]
            for match in re.finditer(rule['match'], text):
                if match.start() <= at < match.end():
                    return rule['name'].removesuffix('.arbprogram')
        return ''

    def test_scopes(self):
        for mark, after, wanted in (
                ('MAD_SAT a', 0, 'support.function'), ('MAD_SAT a', 5, 'support.function'),
                ('MOVE,', 0, ''), ('texcoord', 0, 'variable.other.property'),
                ('fragment', 0, 'variable.language'), ('wzyx', 0, 'variable.other.swizzle'),
                ('2D', 0, 'support.type.target'), ('1.5e3', 2, 'constant.numeric'),
                ('# a MOV', 4, 'comment.line.number-sign'), ('TEMP', 0, 'storage.type'),
                ('ARB_fog_exp2', 0, 'support.constant.option'), ('ARL', 0, '')):
            text = '\n'.join(line for line in FRAGMENT.split('\n') if mark in line)
            self.assertEqual(self.scope('fragment', text, mark, after), wanted, mark)
        self.assertEqual(self.scope('vertex', 'ARL A0.x, a.x;', 'ARL'), 'support.function')
        self.assertEqual(self.scope('vertex', 'SIN a, a;', 'SIN'), '')
        self.assertEqual(self.scope('ati', 'DOT2ADD r0.2x, r1', '2x'), 'variable.other.property')

    def test_package(self):
        """The manifest names the files of the archive, and packing twice gives the same archive."""
        with tempfile.TemporaryDirectory() as name:
            first, second = pathlib.Path(name, 'a.vsix'), pathlib.Path(name, 'b.vsix')
            for output in (first, second):
                subprocess.run([sys.executable, ROOT / 'editors' / 'vsix.py', output], check=True, timeout=60)
            self.assertEqual(first.read_bytes(), second.read_bytes())
            archive = zipfile.ZipFile(first)
            names = set(archive.namelist())
            for path in VSCODE.rglob('*'):
                if path.is_file():
                    packed = f'extension/{path.relative_to(VSCODE)}'
                    self.assertEqual(archive.read(packed), path.read_bytes())
            space = '{http://schemas.microsoft.com/developer/vsx-schema/2011}'
            manifest = ElementTree.fromstring(archive.read('extension.vsixmanifest'))
            identity = manifest.find(f'{space}Metadata/{space}Identity').attrib
            package = self.read('package.json')
            self.assertEqual((identity['Id'], identity['Version'], identity['Publisher']),
                             (package['name'], package['version'], package['publisher']))
            assets = [asset.attrib['Path'] for asset in manifest.iter(f'{space}Asset')]
            self.assertIn('extension/package.json', assets)
            self.assertLessEqual(set(assets), names)
            types = ElementTree.fromstring(archive.read('[Content_Types].xml'))
            endings = {each.attrib['Extension'] for each in types}
            self.assertLessEqual({pathlib.PurePath(each).suffix for each in names - {'[Content_Types].xml'}}, endings)

    def test_extension(self):
        if not shutil.which('node'):
            self.skipTest('not installed: node')
        for name in ('extension.js', 'client.js'):
            subprocess.run(['node', '--check', VSCODE / name], check=True, timeout=60)
        done = subprocess.run(['node', pathlib.Path(__file__).with_name('vscode_test.js'), VSCODE,
                               ARBITER], capture_output=True, text=True, timeout=90)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class Emacs(unittest.TestCase):
    def test_mode(self):
        """The test checks the faces of words, the mode of files, and the language server's command."""
        if not shutil.which('emacs'):
            self.skipTest('not installed: Emacs')
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name, 'a.fp')
            file.write_text(FRAGMENT)
            show = ''.join(f'(goto-char (point-min)) (search-forward "{mark}") '
                           '(princ (get-text-property (match-beginning 0) (quote face))) (princ "\\n")'
                           for mark in ('!!ARBfp', 'MOV in', 'OPTION', 'ARB_fog', 'TEX ', 'rgb', 'fragment', 'MOVE,'))
            done = subprocess.run(
                ['emacs', '--batch', '-Q', '-l', ROOT / 'editors' / 'emacs' / 'arbprogram-mode.el', '--eval',
                 f'(progn (find-file "{file}") (princ major-mode) (princ "\\n") '
                 f'(font-lock-ensure) {show} (princ comment-start))'],
                capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout.splitlines(), [
            'arbprogram-mode', 'font-lock-preprocessor-face', 'font-lock-comment-face', 'font-lock-keyword-face',
            'font-lock-type-face', 'font-lock-function-name-face', 'font-lock-constant-face',
            'font-lock-variable-name-face', 'nil', '# '], done.stderr)


class Neovim(unittest.TestCase):
    def test_the_documented_settings_show_diagnostics(self):
        if not shutil.which('nvim'):
            self.skipTest('not installed: Neovim')
        page = (ROOT / 'docs' / 'write' / 'editors.md').read_text()
        settings = re.search(r'## Neovim\n+```\n(.*?)```', page, re.S).group(1)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / 'init.lua').write_text(settings.replace('/path/to/arbiter/editors/vim', str(VIM)))
            (folder / 'look.lua').write_text(
                'vim.wait(20000, function() return #vim.diagnostic.get(0) > 0 end)\n'
                'for _, each in ipairs(vim.diagnostic.get(0)) do\n'
                "  io.stdout:write(each.lnum .. ':' .. each.col .. ' ' .. each.message .. '\\n')\nend\n")
            (folder / 'bad.arbfp').write_text('!!ARBfp1.0\nMOV result.color, q;\nEND\n')
            done = subprocess.run(
                ['nvim', '--headless', '-u', folder / 'init.lua', folder / 'bad.arbfp',
                 '-c', f'luafile {folder}/look.lua', '-c', 'qall!'],
                capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL,
                env={**os.environ, 'XDG_STATE_HOME': name, 'XDG_DATA_HOME': name, 'XDG_CACHE_HOME': name,
                     'PATH': f'{os.path.dirname(ARBITER)}:{os.environ["PATH"]}'})
        self.assertIn("1:18 'q' is not declared", done.stdout, done.stderr)


class Generated(unittest.TestCase):
    def test_files_are_fresh(self):
        done = subprocess.run([sys.executable, ROOT / 'editors' / 'generate.py', '--check'],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
