"""Collects verbs, options and exit codes: from the help of a built command, compared with the sources that define them.

The window's options come from its source alone: not every build has a window.
"""
import re
import subprocess
import sys

from sources import ROOT, Broken, text_of

sys.path.insert(0, str(ROOT / 'docs' / 'man'))
import pages  # noqa: E402

# Verbs that other programs of Arbiter call; no help shows them.
OWN_VERBS = {'complete', 'debug-draws'}
TAKES_COMMAND = {'run', 'capture', 'defaults', 'doctor'}
NUMBERS = r'(-?[\d.]+) to (-?[\d.]+)'
SOURCE, INTERNAL = 'src/util/text/exit_codes.h', 6  # a fault of its own ends any verb, and no help says so
CALL = re.compile(r'(?:\.|\b)(option|flag|flagOrValue|addValues)\(\s*"([^"]+)"(.*?);', re.S)


def range_of(text):
    """Returns the least and the most number that "(1 to 64; by default 1)" allows, None for none."""
    match = re.search(NUMBERS, text)
    if match:
        return [float(number) if '.' in number else int(number) for number in match.groups()]
    return [1, None] if '1 or more' in text else None


def defined():
    """Returns the options and operands that the sources define: their hidden ones, and those whose value may be
    left out."""
    names, hidden, optional, repeated = set(), set(), set(), set()
    for path in sorted((ROOT / 'src/apps/tools/options').glob('*.cpp')):
        for kind, name, rest in CALL.findall(path.read_text()):
            long = max(name.split(','), key=len)
            (hidden if '.hidden()' in rest else names).add(long)
            if kind == 'flagOrValue':
                optional.add(long)
            if '.repeatable()' in rest or kind == 'addValues':
                repeated.add(long)
    return names, hidden, optional, repeated


def option_entry(verb, option, group, sources):
    """Returns what identifies an option, or an operand."""
    _, _, optional, repeated = sources
    name = option.names[-1]
    operand = not name.startswith('-')
    entry = {'key': f'{verb} {name}'.strip()}
    if len(option.names) > 1:
        entry['short'] = option.names[0]
    if operand:
        entry['operand'] = True
        return entry
    entry['takes'] = 'a value' if option.value else 'a value or nothing' if name in optional else 'nothing'
    if option.choices:
        entry['choices'] = option.choices.group(1).split(',')
        if option.value.endswith('FILE'):
            entry['other values'] = True
    elif not re.fullmatch('[A-Z]*', option.value):  # a word in capitals only names the value
        entry['form'] = option.value
    if option.value and name in repeated:
        entry['repeatable'] = True
    if option.default:
        entry['default'] = option.default.group(1)
    if group != 'Options':
        entry['of the layer'] = True
    return entry


def is_needed(help_text, name):
    """True if the usage line has an operand without brackets."""
    return bool(re.search(r'(?<![\[\w])%s\b' % re.escape(name), help_text.usage))


def entries_of(arbiter, verb, sources, found):
    """Returns the entries of a verb; `verb` is empty for the command itself."""
    help_text = pages.Help(arbiter, *([verb] if verb else []))
    entries = []
    for group in ('Positionals', *pages.GROUPS):
        for head, text in help_text.groups.get(group, []):
            option = pages.Option(head, text)
            entry = option_entry(verb, option, group, sources)
            if 'operand' in entry and is_needed(help_text, option.names[-1]):
                entry['required'] = True
            if span := range_of(head):
                entry['range'] = span
            for word, match in (('needs', option.needs), ('not with', option.excludes)):
                if match:
                    entry[word] = sorted(match.group(1).split())
            found.add(option.names[-1])
            entries.append(entry)
    return help_text, entries


def actions(help_text):
    """Returns the actions that the help of `arbiter ctl` lists, with their operands."""
    entries = []
    for line in help_text.part('Actions:')[1:]:
        name, *rest = line.strip().split('  ')[0].split(' ')
        operands = [word for word in rest if re.match(r'[A-Z\[]', word)]
        entries.append({'key': f'{help_text.verb} {name}', 'action': True, 'operands': ' '.join(operands)})
    if entries:
        if 'or list: the processes that listen' not in dict(map(tuple, help_text.groups['Positionals']))['ACTION']:
            raise Broken('arbiter ctl --help: no list')
        entries.append({'key': f'{help_text.verb} list', 'action': True, 'operands': ''})
    return entries


def options(arbiter):
    """Returns the verbs and options of `arbiter`, and the help of each verb."""
    sources, found, entries, helps = defined(), set(), [], {}
    main, own = entries_of(arbiter, '', sources, found)
    entries += own
    for verb in [name for name, _ in main.groups['Subcommands']]:
        helps[verb], own = entries_of(arbiter, verb, sources, found)
        entry = {'key': verb, 'verb': True}
        if verb in TAKES_COMMAND:
            entry['command'] = True
        entries += [entry, *own]
        entries += actions(helps[verb])
    missing = sources[0] ^ {name for name in found if name not in ('--help', '--help-all', '--version')}
    if missing:
        raise Broken(f'src/apps/tools/options: help and source differ in {sorted(missing)}')
    return entries, helps


def window():
    """Returns the options of `arbiter-builder`."""
    source = text_of('src/apps/builder/view/main.cpp')
    entries = [{'key': 'arbiter-builder', 'verb': True}]
    rows = re.findall(r'QCommandLineOption (\w+)\{(.*?)\};', source, re.S)
    for member, body in rows:
        literals = re.findall(r'QStringLiteral\("([^"]*)"\)', body)
        entry = {'key': f'arbiter-builder --{next(each for each in literals if len(each) > 1)}'}
        if len(literals[0]) == 1:
            entry['short'] = f'-{literals.pop(0)}'
        last = re.search(r'QStringLiteral\("([^"]*)"\)\s*$', body)
        takes = last and len(literals) > 1
        entry['takes'] = 'a value' if takes else 'nothing'
        if takes and not re.fullmatch('[A-Z]*', last.group(1)):
            entry['form'] = last.group(1)
        entries.append(entry)
        if not re.search(r'addOptions\(\{[^}]*\b%s\b' % member, source):
            raise Broken(f'src/apps/builder/view/main.cpp: {member} is not added')
    if source.count('QCommandLineOption ') != len(rows):
        raise Broken('src/apps/builder/view/main.cpp: an option that cannot be read')
    schemes = [word for word in re.search(r'"colors"\), QObject::tr\("([^"]*)"', source).group(1)
               .replace(' or ', ', ').split(', ') if word]
    panels = re.search(r'MainWindow::panelNames\(\) \{(.*?)\}', text_of('src/apps/builder/view/window/main_window.cpp'),
                       re.S).group(1)
    for entry in entries:
        if entry['key'].endswith('--colors'):
            entry['choices'] = schemes
        if entry['key'].endswith('--panel'):
            entry['choices'] = re.findall(r'tr\("(\w+)"\)', panels)
    entries += [{'key': 'arbiter-builder --help', 'takes': 'nothing', 'short': '-h'},
                {'key': 'arbiter-builder FILE', 'operand': True}]
    return entries


def codes_of(text):
    """Returns the codes and meanings of "Exit code: 0 valid; 1 usage; 126, ..."."""
    found = {}
    for part in re.split(r'[;.] (?=\d)', text.strip().rstrip('.')):
        match = re.match(r'(\d+)\s*(.*)', part)
        if match:
            found[int(match.group(1))] = match.group(2).split('. ')[0].rstrip('.;') or 'it was done'
    return found


def exit_codes(helps):
    """Returns the exit codes, each with its one meaning and the verbs that end with it."""
    meanings = pages.exit_codes()
    verbs = {code: set() for code in meanings}
    said = {}
    for verb, help_text in helps.items():
        text = ' '.join(help_text.part('Exit code:'))[len('Exit code:'):].strip()
        said[verb] = codes_of(text)
        if text and not text[0].isdigit():
            verbs.setdefault('other', set()).add(verb)
            meanings['other'] = re.split(r'; ', text)[0].rstrip('.')
    page = text_of('docs/man/arbiter-builder.1')
    window_text = ' '.join(re.search(r'\.SH EXIT STATUS\n(.*?)\n\.SH', page, re.S).group(1).split())
    said['arbiter-builder'] = codes_of(re.sub(r'\\\(aq', "'", window_text))
    for verb, codes in said.items():
        for code, meaning in codes.items():
            if meaning != meanings.get(code):
                raise Broken(f'exit codes: {verb} says that {code} is "{meaning}", and {SOURCE} that it is '
                             f'"{meanings.get(code)}"')
            verbs[code].add(verb)
    verbs[INTERNAL] = set(said)
    if none := [code for code in meanings if not verbs[code]]:
        raise Broken(f'exit codes: no verb ends with {none}')
    return [{'key': str(code), 'meaning': meaning, 'choices': sorted(verbs[code])}
            for code, meaning in meanings.items()]


def version_of(arbiter):
    """Returns what `arbiter --version` says."""
    return subprocess.run([arbiter, '--version'], capture_output=True, text=True, check=True).stdout.strip()
