#!/usr/bin/env python3
"""Writes the manual page of each verb, and the list of verbs in arbiter.1, or checks them.

usage: docs/man/pages.py ARBITER            write the pages
       docs/man/pages.py ARBITER --check    compare; 1 if one is stale, and say which

A page has what `arbiter VERB --help` says, and the text of verbs/VERB.in, which is written by hand.
Where that text describes an option, its words take the place of the help's.
"""
import pathlib
import re
import subprocess
import sys
import textwrap

MAN = pathlib.Path(__file__).resolve().parent
COLUMN = 30  # where CLI11 begins its descriptions
WITHOUT_PAGE = ('help', 'builder')  # arbiter-builder(1) is the page of the window, by hand
GROUPS = {'Options': 'OPTIONS', 'Options of the layer': 'LAYER OPTIONS'}


def roff(text):
    text = text.replace('\\', '\\e').replace('-', '\\-').replace("'", '\\(aq')
    return '\n'.join('\\&' + line if line.startswith(('.', "'")) else line
                     for line in textwrap.wrap(text, 98, break_long_words=False, break_on_hyphens=False))


class Option:
    """An option or an operand, as a line of help has it."""

    def __init__(self, head, text):
        names, _, rest = head.partition(' ')
        self.names, self.text = names.split(','), text
        self.value, _, parts = rest.partition('(')
        self.value = self.value.strip()
        self.choices = re.fullmatch(r'\{([^}]*)\}(?: or FILE)?', self.value)
        self.default = re.search(r'by default ([^;)]+)', parts)
        self.needs = re.search(r'needs ([^;)]+)', parts)
        self.excludes = re.search(r'not with ([^;)]+)', parts)

    def placeholder(self):
        if self.choices:
            words = '|'.join(f'\\fB{roff(word)}\\fP' for word in self.choices.group(1).split(','))
            return words + ('|\\fIFILE\\fP' if self.value.endswith('FILE') else '')
        return f'\\fI{self.value}\\fP'

    def page(self):
        head = ', '.join(f'\\fB{roff(name)}\\fP' for name in self.names)
        if self.value and self.names[0].startswith('-'):
            head += ' ' + self.placeholder()
        text = self.text
        for what, match in (('by default {}', self.default), ('needs {}', self.needs),
                            ('cannot be given with {}', self.excludes)):
            text += '; ' + what.format(', '.join(match.group(1).split())) if match else ''
        return f'.TP\n{head}\n{roff(text)}\n'


class Help:
    """What `arbiter VERB --help` says."""

    def __init__(self, arbiter, *verb):
        self.verb = ' '.join(verb)
        text = subprocess.run([arbiter, *verb, '--help'], capture_output=True, text=True, check=True).stdout
        self.title, _, rest = text.partition('Usage: ')
        self.title = self.title.strip()
        self.usage, _, rest = rest.partition('\n')
        self.groups, self.footer, group = {}, [], None
        for line in rest.splitlines():
            heading = re.fullmatch(r'([A-Z][A-Za-z ]+):', line)
            if heading and heading.group(1) in ('Positionals', 'Subcommands', *GROUPS) and not self.footer:
                group = self.groups.setdefault(heading.group(1), [])
            elif group is not None and line.startswith('  ') and not self.footer:
                self.take(group, line)
            elif line or self.footer:
                self.footer.append(line)

    @staticmethod
    def take(group, line):
        match = re.match(r'  (\S.*?)(?: {2,}(.*))?$', line)
        if match and not line.startswith(' ' * COLUMN):
            group.append([match.group(1), match.group(2) or ''])
        else:
            group[-1][1] = (group[-1][1] + ' ' + line.strip()).strip()

    def options(self, group):
        return [Option(*pair) for pair in self.groups.get(group, [])]

    def part(self, start):
        """The lines of the footer that begin with that, to the next that is not indented."""
        lines, taken = [], False
        for line in self.footer:
            if not line.startswith(' ') and line:
                taken = line.startswith(start)
            if taken:
                lines.append(line)
        return lines

    def rest(self):
        known = ('Exit code:', 'Example', 'Actions:')
        return [line for line in self.footer if line and not line.startswith(' ') and
                not line.startswith(known)]


def described(hand):
    """The options that the text by hand has a paragraph of."""
    heads = re.findall(r'^\.TP\n(.*)$', hand, re.M)
    return set(re.findall(r'(?<![\w-])--[a-z][a-z-]*', '\n'.join(heads).replace('\\-', '-').replace('\\fP', ' ')))


def options_of(help_text, hand):
    have, out = described(hand), ''
    for group, title in GROUPS.items():
        rows = [option for option in help_text.options(group)
                if not set(option.names) & have and not {'--help', '--help-all'} & set(option.names)]
        if rows and not (title == 'OPTIONS' and '.SH OPTIONS' in hand):
            out += f'.SH {title}\n'
            if title == 'LAYER OPTIONS':
                out += 'Each sets the variable of\n.BR arbiter (7)\nthat has its name.\n'
        out += ''.join(option.page() for option in rows)
    return out


def page(arbiter, verb):
    help_text = Help(arbiter, verb)
    hand = (MAN / 'verbs' / f'{verb}.in').read_text()
    title, _, usage = help_text.title.partition(':\n')
    usage = usage or help_text.usage
    title = re.sub(r'\s+', ' ', title)
    out = f'.\\" Made by docs/man/pages.py from the help of the verb and verbs/{verb}.in; do not edit.\n'
    out += f'.TH ARBITER\\-{verb.upper()} 1 "" "Arbiter" "User Commands"\n'
    out += f'.SH NAME\narbiter\\-{verb} \\- {roff(title[0].lower() + title[1:])}\n'
    out += f'.SH SYNOPSIS\n\\fB{roff("arbiter " + verb)}\\fP {roff(usage.split(verb, 1)[1].strip())}\n'
    out += hand + options_of(help_text, hand)
    status = ' '.join(help_text.part('Exit code:'))[len('Exit code:'):].strip()
    if status:
        out += f'.SH EXIT STATUS\n{roff(status)}\n'
    examples = [line.strip() for line in help_text.part('Example')[1:]]
    if examples:
        out += '.SH EXAMPLES\n.EX\n' + '\n'.join(line.replace('\\', '\\e').replace('-', '\\-')
                                                 for line in examples) + '\n.EE\n'
    return out + '.SH SEE ALSO\n.BR arbiter (1),\n.BR arbiter (7)\n'


def exit_codes():
    """Returns the meanings of exit codes by number, as src/util/text/exit_codes.h has them."""
    source = (MAN.parents[1] / 'src' / 'util' / 'text' / 'exit_codes.h').read_text()
    numbers = {name: int(code) for name, code in re.findall(r'(kExit\w+) = (\d+)', source)}
    rows = re.findall(r'\{(kExit\w+), ((?:"[^"]*"\s*)+)\}', source)
    found = {numbers[name]: ''.join(re.findall(r'"([^"]*)"', text)) for name, text in rows}
    if len(found) != len(numbers):
        sys.exit('src/util/text/exit_codes.h: a code without a meaning')
    return found


def overview(arbiter):
    codes = ''.join(f'.TP\n.B {code}\n{roff(meaning)}\n' for code, meaning in exit_codes().items())
    text = (MAN / 'arbiter.1.in').read_text().replace('@EXIT_CODES@\n', codes)
    rows = ''
    for name, title in Help(arbiter).groups['Subcommands']:
        title = title.split(':')[0] if ': arbiter' in title else title
        link = f'.BR arbiter\\-{name} (1)' if name != 'help' else f'.B arbiter {name}'
        rows += f'.TP\n{link}\n{roff(title)}\n'
    return text.replace('@VERBS@\n', rows)


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ['--check']):
        print(__doc__, file=sys.stderr)
        return 2
    arbiter, check = sys.argv[1], len(sys.argv) == 3
    verbs = [name for name, _ in Help(arbiter).groups['Subcommands'] if name not in WITHOUT_PAGE]
    pages = {f'arbiter-{verb}.1': page(arbiter, verb) for verb in verbs}
    pages['arbiter.1'] = overview(arbiter)
    stale = [name for name, text in pages.items()
             if not (MAN / name).exists() or (MAN / name).read_text() != text]
    for name in stale:
        if not check:
            (MAN / name).write_text(pages[name])
        print(f'docs/man/{name}: ' + ('stale; run docs/man/pages.py' if check else 'written'))
    return 1 if check and stale else 0


if __name__ == '__main__':
    sys.exit(main())
