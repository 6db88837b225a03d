#!/usr/bin/env python3
"""Writes the editors' syntax files, or the lists of words in them, from the tables that the compiler is made of, or
checks them.

usage: editors/generate.py            write the files
       editors/generate.py --check    compare; 1 if one is stale, and say which
"""
import json
import pathlib
import re
import sys
import textwrap

EDITORS = pathlib.Path(__file__).resolve().parent
ROOT = EDITORS.parent
sys.path.insert(0, str(ROOT / 'docs'))
from generate import Broken, rows_of  # noqa: E402

FRONT = ROOT / 'src' / 'fp_compiler' / 'front'


class Words:
    """The words of one ARB language."""

    def __init__(self, vertex):
        mine = {'Both', 'Vertex' if vertex else 'Fragment'}
        foreign = 'FragmentOnly' if vertex else 'VertexOnly'
        self.opcodes = []
        for _, mnemonic, _, traits, *_ in rows_of(ROOT / 'src/fp_compiler/ir/ops.def', 'FP_OP'):
            if foreign in traits:
                continue
            self.opcodes.append(mnemonic)
            if not vertex and 'Kills' not in traits:
                self.opcodes.append(mnemonic + '_SAT')
        keywords = [(word, languages) for _, word, languages, *_ in
                    rows_of(FRONT / 'words' / 'words.def', 'FP_KEYWORD') if languages in mine]
        self.statements = [word for word, _ in keywords if word.isupper()]
        self.roots = [word for word, _ in keywords if not word.isupper()]
        self.options = [word for word, language, *_ in rows_of(FRONT / 'words' / 'words.def', 'FP_OPTION')
                        if (language == 'ArbVertex') == vertex]
        self.targets = [] if vertex else [
            word for word, *_ in rows_of(FRONT / 'words' / 'words.def', 'FP_TARGET')]
        self.members = []
        for path, languages, *_ in rows_of(FRONT / 'words' / 'bindings.def', 'FP_BINDING'):
            if languages in mine:
                self.members += [word for word in re.findall(r'[a-z]+', path.replace('[n]', ''))
                                 if word not in self.members]
        self.members = [word for word in self.members if word not in self.roots or word == 'program']
        self.letters = 'xyzw' if vertex else 'xyzwrgba'


class Ati:
    """The words of ATI's texts."""

    def __init__(self):
        tables = FRONT / 'ati' / 'words.def'
        self.opcodes = [word for _, word, _ in rows_of(tables, 'ATI_OP')]
        self.statements = [word for word, _ in rows_of(tables, 'ATI_STATEMENT')]
        self.registers = []
        for word, count, _ in rows_of(tables, 'ATI_SOURCE'):
            self.registers += [f'{word}{i}' for i in range(int(count))] or [word]
        self.members = []
        for macro in ('ATI_COORDINATES', 'ATI_SCALE', 'ATI_MODIFIER'):
            self.members += [row[-2] for row in rows_of(tables, macro)
                             if row[-2] and row[-2] not in self.members]
        self.members.append('sat')


class Nvparse:
    """The words of nvparse's texts."""

    def __init__(self):
        tables = FRONT / 'nvparse' / 'words.def'
        self.functions = [row[0] for macro in ('RC_FUNCTION', 'TS_OPERATION')
                          for row in rows_of(tables, macro)]
        self.statements = [word for word, _ in rows_of(tables, 'RC_WORD') if word != 'one']
        self.options = [word for word, _ in rows_of(tables, 'TS_WORD')]
        self.registers = ['one']
        for _, word, count, _ in rows_of(tables, 'RC_REGISTER'):
            self.registers += [f'{word}{i}' for i in range(int(count))] or [word]


class Native:
    """The words of NVIDIA's own languages of one stage."""

    TRAITS = {True: {'OfVp1', 'OfVp11', 'OfVp2'}, False: {'OfFp1'}}

    def __init__(self, vertex):
        self.opcodes = []
        for macro in ('FP_OP', 'FP_NV_OP', 'FP_NV_WORD'):
            for _, mnemonic, _, traits, *_ in rows_of(ROOT / 'src/fp_compiler/ir/ops.def', macro):
                names = {name.strip() for name in traits.split('|')}
                if names & self.TRAITS[vertex]:
                    self.opcodes += self.spellings(mnemonic, names, vertex)
        tables = FRONT / 'native' / 'words.def'
        self.statements = [word for word, *_ in rows_of(tables, 'NATIVE_KEYWORD')
                           if word == 'END' or (word == 'OPTION') == vertex]
        stage = 'Vertex' if vertex else 'Fragment'
        self.roots = []
        for macro in ('NATIVE_ATTRIBUTE', 'NATIVE_RESULT'):
            self.roots += [name for of, name, *_ in rows_of(tables, macro)
                           if of == stage and name not in self.roots]
        self.roots += [f'TEX{i}' for i in range(8 if vertex else 16)]
        self.options = ['NV_position_invariant'] if vertex else []
        self.targets = [] if vertex else ['1D', '2D', '3D', 'CUBE', 'RECT']
        self.conditions = ['EQ', 'GE', 'GT', 'LE', 'LT', 'NE', 'TR', 'FL']

    @staticmethod
    def spellings(mnemonic, traits, vertex):
        precisions = [''] if vertex or 'NoPrecision' in traits else \
            ['', 'R', 'H'] if 'NoFixed' in traits else ['', 'R', 'H', 'X']
        conditions = [''] if 'NoCondition' in traits else ['', 'C']
        ends = [''] if vertex or 'NoSaturate' in traits else ['', '_SAT']
        return [mnemonic + p + c + e for p in precisions for c in conditions for e in ends]


# --- vim ---

def vim_keywords(group, words):
    lines, line = [], f'syn keyword {group}'
    for word in words:
        if len(line) + len(word) > 98:
            lines.append(line)
            line = '  \\'
        line += ' ' + word
    return lines + [line]


def vim_arb(words):
    out = vim_keywords('arbOpcode', words.opcodes)
    out += vim_keywords('arbStatement', words.statements)
    out += vim_keywords('arbBinding', words.roots)
    out += vim_keywords('arbOption', words.options)
    if words.targets:
        out += vim_keywords('arbTarget', words.targets)
    members = '\\|'.join(sorted(words.members, key=lambda word: (-len(word), word)))
    out.append("syn match arbSuffix '\\.\\s*\\zs[%s]\\{1,4}\\>'" % words.letters)
    out.append("syn match arbMember '\\.\\s*\\zs\\%%(%s\\)\\>'" % members)
    return ['  ' + line for line in out]


def vim_native(words):
    out = vim_keywords('arbOpcode', words.opcodes)
    out += vim_keywords('arbStatement', words.statements)
    out += vim_keywords('arbBinding', words.roots)
    if words.options:
        out += vim_keywords('arbOption', words.options)
    if words.targets:
        out += vim_keywords('arbTarget', words.targets)
    out += vim_keywords('arbOption', words.conditions)
    out.append("syn match arbSuffix '\\.\\s*\\zs[xyzw]\\{1,4}\\>'")
    return ['  ' + line for line in out]


def vim_ati(words):
    out = vim_keywords('arbOpcode', words.opcodes)
    out += vim_keywords('arbStatement', words.statements)
    out += vim_keywords('arbBinding', words.registers + ['program', 'env', 'local'])
    members = '\\|'.join(sorted(words.members, key=lambda word: (-len(word), word)))
    out.append("syn match arbSuffix '\\.\\s*\\zs[rgba]\\{1,4}\\>'")
    out.append("syn match arbMember '\\.\\s*\\zs\\%%(%s\\)\\>'" % members)
    return ['  ' + line for line in out]


def vim_nvparse(words):
    out = vim_keywords('arbOpcode', words.functions)
    out += vim_keywords('arbStatement', words.statements)
    out += vim_keywords('arbBinding', words.registers)
    out += vim_keywords('arbOption', words.options)
    out.append("syn match arbSuffix '\\.\\zs\\%(rgb\\|a\\|b\\)\\>'")
    out.append("syn match arbComment '//.*$' contains=@Spell")
    out.append("syn region arbComment start='/\\*' end='\\*/' contains=@Spell")
    return ['  ' + line for line in out]


VIM = '''" Vim syntax file of ARB assembly programs and ATI fragment shaders.
" Generated by editors/generate.py from the compiler's tables; do not edit.
if exists('b:current_syntax')
  finish
endif

syn case match
syn iskeyword @,48-57,_,$

" Numbers first: what follows may begin with a digit.
syn match arbNumber '\\<\\d\\+\\>'
syn match arbNumber '\\<\\d\\+\\.\\d*\\%([eE][+-]\\=\\d\\+\\)\\='
syn match arbNumber '\\%([A-Za-z0-9_$\\]]\\)\\@1<!\\.\\d\\+\\%([eE][+-]\\=\\d\\+\\)\\='
syn match arbNumber '\\<\\d\\+[eE][+-]\\=\\d\\+\\>'

" The header decides which words there are.
if getline(1) =~# '^!!ARBvp'
@VERTEX@
elseif getline(1) =~# '^!!\\%(VP\\|VSP\\)'
@NATIVE_VERTEX@
elseif getline(1) =~# '^!!FP'
@NATIVE_FRAGMENT@
elseif getline(1) =~# '^!!ATIfs'
@ATI@
elseif getline(1) =~# '^!!\\%(RC\\|TS\\)'
@NVPARSE@
else
@FRAGMENT@
endif

syn match arbComment '#.*$' contains=@Spell
syn match arbHeader '\\%^!!\\%(\\%(ARBfp\\|ARBvp\\|ATIfs\\|FP\\|VP\\|VSP\\|RC\\|TS\\)1\\.0\\|VP1\\.1\\|VP2\\.0\\)'

hi def link arbComment Comment
hi def link arbHeader PreProc
hi def link arbOpcode Function
hi def link arbStatement Statement
hi def link arbBinding Identifier
hi def link arbMember Identifier
hi def link arbSuffix Special
hi def link arbOption PreProc
hi def link arbTarget Type
hi def link arbNumber Number

let b:current_syntax = 'arbprogram'
'''


def vim():
    return (VIM.replace('@VERTEX@', '\n'.join(vim_arb(Words(True))))
            .replace('@FRAGMENT@', '\n'.join(vim_arb(Words(False))))
            .replace('@NATIVE_VERTEX@', '\n'.join(vim_native(Native(True))))
            .replace('@NATIVE_FRAGMENT@', '\n'.join(vim_native(Native(False))))
            .replace('@ATI@', '\n'.join(vim_ati(Ati())))
            .replace('@NVPARSE@', '\n'.join(vim_nvparse(Nvparse()))))


# --- VS Code ---

def scope(name):
    return f'{name}.arbprogram'


def any_of(words):
    # The longest first: an alternative that is the beginning of another must come behind it.
    return '(?:' + '|'.join(sorted(map(re.escape, words), key=lambda w: (-len(w), w))) + ')'


def rule(name, pattern):
    return {'name': scope(name), 'match': pattern}


WORD = r'(?<![\w$.])%s(?![\w$])'
BEHIND_DOT = r'(?<=\.)\s*%s(?![\w$])'


def textmate_arb(words):
    rules = [{'include': '#comment'},
             rule('support.function', WORD % any_of(words.opcodes)),
             rule('storage.type', WORD % any_of(words.statements)),
             rule('support.constant.option', WORD % any_of(words.options))]
    if words.targets:
        rules.append(rule('support.type.target', WORD % any_of(words.targets)))
    return rules + [rule('variable.language', WORD % any_of(words.roots)),
                    rule('variable.other.property', BEHIND_DOT % any_of(words.members)),
                    rule('variable.other.swizzle', BEHIND_DOT % f'[{words.letters}]{{1,4}}'),
                    {'include': '#number'}]


def textmate_native(words):
    rules = [{'include': '#comment'},
             rule('support.function', WORD % any_of(words.opcodes)),
             rule('storage.type', WORD % any_of(words.statements)),
             rule('support.constant.option', WORD % any_of(words.options + words.conditions))]
    if words.targets:
        rules.append(rule('support.type.target', WORD % any_of(words.targets)))
    return rules + [rule('variable.language', WORD % any_of(words.roots)),
                    rule('variable.other.swizzle', BEHIND_DOT % '[xyzw]{1,4}'),
                    {'include': '#number'}]


def textmate_ati(words):
    return [{'include': '#comment'},
            rule('support.function', WORD % any_of(words.opcodes)),
            rule('storage.type', WORD % any_of(words.statements)),
            rule('variable.language', WORD % any_of(words.registers + ['program'])),
            rule('variable.other.property', BEHIND_DOT % any_of(words.members + ['env', 'local'])),
            rule('variable.other.swizzle', BEHIND_DOT % '[rgba]{1,4}'),
            {'include': '#number'}]


def textmate_nvparse(words):
    return [{'include': '#comment'},
            rule('comment.line.double-slash', '//.*$'),
            {'name': scope('comment.block'), 'begin': r'/\*', 'end': r'\*/'},
            rule('support.function', WORD % any_of(words.functions)),
            rule('storage.type', WORD % any_of(words.statements)),
            rule('support.constant.option', WORD % any_of(words.options)),
            rule('variable.language', r'(?<![\w$])%s(?![\w$])' % any_of(words.registers)),
            rule('variable.other.swizzle', BEHIND_DOT % '(?:rgb|a|b)'),
            {'include': '#number'}]


def region(header, part):
    """From the header to the end of the text: the end never matches."""
    return {'begin': r'\A' + re.escape(header), 'end': '(?!)',
            'beginCaptures': {'0': {'name': scope('entity.name.section')}},
            'patterns': [{'include': part}]}


def textmate():
    grammar = {
        'information_for_contributors': ['Generated by editors/generate.py; do not edit.'],
        'name': 'ARB assembly program',
        'scopeName': 'source.arbprogram',
        'fileTypes': ['fp', 'vp', 'arbfp', 'arbvp', 'atifs', 'nvrc', 'nvts', 'vsp'],
        'firstLineMatch': '^!!((ARB[fv]p|ATIfs|FP|VP|VSP|RC|TS)1\\.0|VP1\\.1|VP2\\.0)',
        'patterns': [region('!!ARBvp1.0', '#vertex'), region('!!ATIfs1.0', '#ati'),
                     region('!!RC1.0', '#nvparse'), region('!!TS1.0', '#nvparse'),
                     region('!!FP1.0', '#native_fragment'),
                     *[region(header, '#native_vertex')
                       for header in ('!!VP1.0', '!!VP1.1', '!!VP2.0', '!!VSP1.0')],
                     region('!!ARBfp1.0', '#fragment'), {'include': '#fragment'}],
        'repository': {
            'comment': rule('comment.line.number-sign', '#.*$'),
            'number': rule('constant.numeric',
                           r'(?<![\w$])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w$])'),
            'fragment': {'patterns': textmate_arb(Words(False))},
            'vertex': {'patterns': textmate_arb(Words(True))},
            'native_fragment': {'patterns': textmate_native(Native(False))},
            'native_vertex': {'patterns': textmate_native(Native(True))},
            'ati': {'patterns': textmate_ati(Ati())},
            'nvparse': {'patterns': textmate_nvparse(Nvparse())},
        },
    }
    return json.dumps(grammar, indent=2) + '\n'


# --- Emacs ---

# The mode is written by hand but for its lists of words.
EMACS = EDITORS / 'emacs' / 'arbprogram-mode.el'


def emacs():
    of_arb, of_native = [Words(False), Words(True)], [Native(False), Native(True)]
    ati, nvparse = Ati(), Nvparse()
    all_of = {
        'opcodes': [*(word for words in of_arb + of_native for word in words.opcodes), *ati.opcodes,
                    *nvparse.functions],
        'statements': [*(word for words in of_arb + of_native for word in words.statements), *ati.statements,
                       *nvparse.statements],
        'bindings': [*(word for words in of_arb + of_native for word in words.roots),
                     *(word for words in of_arb for word in words.members), *ati.registers, *nvparse.registers],
        'options': [*(word for words in of_arb + of_native for word in words.options + words.targets),
                    *nvparse.options],
    }
    text = EMACS.read_text()
    for name, words in all_of.items():
        quoted = ' '.join(f'"{word}"' for word in dict.fromkeys(words))
        filled = textwrap.fill(quoted, 96, subsequent_indent=' ' * 4, break_on_hyphens=False)
        text, found = re.subn(rf"(\(defconst arbprogram-{name}\n  '\()[^()]*", rf'\g<1>{filled}', text)
        if found != 1:
            raise Broken(f'{EMACS} has no list arbprogram-{name}')
    return text


FILES = {
    'emacs/arbprogram-mode.el': emacs,
    'vim/syntax/arbprogram.vim': vim,
    'vscode/syntaxes/arbprogram.tmLanguage.json': textmate,
}


def main():
    check = sys.argv[1:] == ['--check']
    if sys.argv[1:] and not check:
        print(__doc__, file=sys.stderr)
        return 2
    stale = []
    try:
        for name, make in FILES.items():
            path, text = EDITORS / name, make()
            if path.exists() and path.read_text() == text:
                continue
            stale.append(name)
            if not check:
                path.write_text(text)
    except Broken as error:
        print(f'generate.py: {error}', file=sys.stderr)
        return 1
    for name in stale:
        print(f'editors/{name}: ' + ('stale; run editors/generate.py' if check else 'written'))
    return 1 if check and stale else 0


if __name__ == '__main__':
    sys.exit(main())
