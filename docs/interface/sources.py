"""Collects the parts of the interface that the tree itself states: variables, keys of TOML, words of panels, IDs,
arbiter.h.

Each function returns entries: dictionaries with a key that no other entry of its kind has.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'docs'), str(ROOT / 'src' / 'fp_compiler' / 'hw')]
import generate  # noqa: E402
import generate_profiles  # noqa: E402

# Variables that the layer's table does not have, with the source that reads each.
OTHER_VARIABLES = {'ARBITER_GALLERY': ('FOLDER', 'src/apps/tools/draw/gallery.cpp'),
                   'ARBITER_COMMAND': ('FILE', 'src/apps/builder/model/workbench.cpp')}
# Variables that Arbiter's processes pass to each other, and one of a benchmark.
OWN_VARIABLES = {'ARBITER_SAVED_GLX_VENDOR', 'ARBITER_SAVED_EGL_VENDORS', 'ARBITER_JIT_CPU'}
# Functions that return the words of a member.
NAMERS = (('severity', 'src/fp_compiler/diagnostic.cpp', 'severityName(Severity'),
          ('status of check', 'src/apps/tools/check/checked_file.cpp', 'name(FileStatus'),
          ('level of doctor', 'src/apps/tools/doctor/command.cpp', 'nameOf(Level'),
          ('provider of statistics', 'src/state/statistics/statistics_text.cpp', 'providerName(Provider'),
          ('kind of control', 'src/state/control/parameter_methods.cpp', 'kindWord(ParameterKind'))
GETENV = re.compile(r'(?:getenv|qEnvironmentVariable)\(\s*"(ARBITER_\w+)"|= "(ARBITER_[A-Z_]+)=?";')
TOML_TYPES = {'text': 'text', 'list': 'text or list of text', 'number': 'number'}
PATTERN_KEYS = ('name', 'path', 'windows', 'xxh128')


class Broken(Exception):
    """A source that does not say what it should, or two that differ."""


def text_of(name):
    """Returns a file of the tree."""
    return (ROOT / name).read_text()


def array_of(name, array):
    """Returns the strings of a C++ array's initializer."""
    match = re.search(r'\b%s(?:\[[^\]]*\])?\s*=\s*\{(.*?)\};' % array, text_of(name), re.S)
    if not match:
        raise Broken(f'{name}: no array {array}')
    return re.findall(r'"([^"]*)"', match.group(1))


def version():
    """Returns major.minor of the version that the tree has."""
    found = re.search(r'(\d+)\.(\d+)', text_of('VERSION'))
    if not found:
        raise Broken('VERSION: no version')
    return f'{found.group(1)}.{found.group(2)}'


def values_of(form):
    """Returns what an entry says of a form: that "host|legacy" is a choice, and the form of what else there is."""
    parts = form.split('|') if '[' not in form else [form]
    words = [part for part in parts if re.fullmatch(r'[a-z0-9][a-z0-9.-]*', part)]
    rest = '|'.join(part for part in parts if part not in words)
    return {**({'choices': words} if words else {}), **({'form': rest} if rest else {}),
            **({'other values': True} if words and rest else {})}


def variables():
    """Returns the environment variables."""
    entries = []
    for _, name, form, default, _ in generate.rows_of(ROOT / 'src/util/flags.def', 'ARBITER_ENV'):
        entries.append({'key': name, 'default': default, **values_of(form)})
    for name, (form, source) in OTHER_VARIABLES.items():
        if f'"{name}"' not in text_of(source):
            raise Broken(f'{source}: does not read {name}')
        entries.append({'key': name, 'form': form, 'default': ''})
    hud = 'src/util/hud/hud_options.cpp'
    words = [word for array in ('kPartNames', 'kOtherWords', 'kCorners') for word in array_of(hud, array)]
    levels = re.findall(r'\{"(\w+)", LogLevel::', text_of('src/util/flags.cpp'))
    entries += [{'key': 'ARBITER_HUD: words', 'choices': sorted(words)},
                {'key': 'ARBITER_LOG: levels', 'choices': levels}, {'key': 'ARBITER_DEBUG: words', 'choices': ['help']}]
    known = {entry['key'] for entry in entries} | OWN_VARIABLES
    for path in sorted((ROOT / 'src').rglob('*.cpp')):
        if not path.name.endswith('_test.cpp'):
            for pair in GETENV.findall(path.read_text()):
                if not known & set(pair):
                    raise Broken(f'{path}: reads {"".join(pair)}, which the interface does not list')
    return entries


def toml_keys():
    """Returns the keys of profiles and of files of defaults."""
    entries = [{'key': f'profile: {name}', 'type': kind} for name, kind in
               (('name', 'text'), ('description', 'text'), ('inherits', 'text'), ('from_host', 'truth'))]
    parse = text_of('src/fp_compiler/hw/parse.cpp')
    heads = re.search(r'known = \{(.*?)\};', parse, re.S).group(1)
    if set(re.findall(r'"(\w+)"', heads)) != {entry['key'].split()[-1] for entry in entries}:
        raise Broken('src/fp_compiler/hw/parse.cpp: other keys outside of tables')
    for row in generate_profiles.read_rows():
        entries.append({'key': f'profile: {row["table"]}.{row["key"]}', 'type': 'number', 'range': [0, row['most']]})
    for row in generate_profiles.read_choices():
        entries.append({'key': f'profile: model.{row["key"]}', 'type': 'text', 'choices': row['names']})
    identity = re.search(r'kIdentityKeys.*?\};', text_of('src/fp_compiler/hw/profile.cpp'), re.S).group()
    if re.findall(r'\{"(\w+)"', identity) != generate_profiles.IDENTITY:
        raise Broken('src/fp_compiler/hw/profile.cpp: other keys of [identity]')
    entries.append({'key': 'profile: identity', 'type': 'table or truth'})
    for name in generate_profiles.IDENTITY:
        entries.append({'key': f'profile: identity.{name}', 'type': 'number' if name == 'year' else 'text'})
    entries += [{'key': f'profile: {name} of a value with its source', 'type': kind}
                for name, kind in (('value', 'as the value'), ('source', 'text'))]
    return entries + defaults_keys()


def defaults_keys():
    """Returns the keys of files of defaults (arbiter-defaults(5))."""
    read = 'src/util/defaults/read.cpp'
    if array_of(read, 'kMatchKeys') != list(PATTERN_KEYS):
        raise Broken(f'{read}: other keys of match')
    entries = [{'key': 'defaults: program', 'type': 'list of tables'}]
    kinds = {'title': 'text', 'note': 'text', 'match': 'table', 'set': 'table', 'source': TOML_TYPES['list']}
    for name in array_of(read, 'kEntryKeys'):
        entry = {'key': f'defaults: program.{name}', 'type': kinds[name]}
        if name in ('title', 'match', 'set'):
            entry['required'] = True
        entries.append(entry)
    entries += [{'key': f'defaults: program.match.{name}', 'type': TOML_TYPES['list']} for name in PATTERN_KEYS]
    body = re.search(r'kVariables\[\] = \{(.*?)\};', text_of('src/util/defaults/keys.cpp'), re.S).group(1)
    variable = {row[0]: row[1] for row in generate.rows_of(ROOT / 'src/util/flags.def', 'ARBITER_ENV')}
    for name in re.findall(r'Env::(\w+)', body):
        key = variable[name][len('ARBITER_'):].lower()
        entries.append({'key': f'defaults: program.set.{key}', 'type': 'text or number', 'as': variable[name]})
    return entries


def profile_names():
    """Returns the names of built-in profiles, with the other names of each."""
    _, profiles = generate_profiles.read_all()
    return [{'key': profile['name'], 'choices': profile['aliases']} for profile in profiles]


def panel_words():
    """Returns the words of `#@` lines."""
    source = ROOT / 'src/apps/scene/words.def'
    entries = [{'key': f'setting: {word}', **values_of(form)}
               for _, word, form, _ in generate.rows_of(source, 'PANEL_SETTING')]
    for macro, title, _ in generate.PANEL_TABLES:
        for _, word, _, *rest in generate.rows_of(source, macro):
            if not word:
                continue
            entries.append({'key': f'{title.lower()}: {word}'})
            for row in rest:
                name, default, least, most = re.fullmatch(r'ARGUMENT\("(\w+)", (.+), (.+), (.+)\)', row).groups()
                entries.append({'key': f'{title.lower()}: {word} {name}', 'default': default,
                                'range': [float(least), float(most)]})
    macros = set(re.findall(r'^(PANEL_[A-Z]+)\(', source.read_text(), re.M))
    if left := macros - {'PANEL_SETTING', *(row[0] for row in generate.PANEL_TABLES)}:
        raise Broken(f'{source}: tables that are not collected: {sorted(left)}')
    return entries


def words_of_members():
    """Returns the words that members of reports may have."""
    entries = []
    for what, source, function in NAMERS:
        body = re.search(re.escape(function) + r'.*?\n\}', text_of(source), re.S)
        words = re.findall(r'return "([^"]+)";', body.group() if body else '')
        if not words:
            raise Broken(f'{source}: no words of {function}')
        entries += [{'key': f'{what} {word}'} for word in words]
    flags = array_of('src/apps/tools/debug/trace/trace.h', 'kFlagNames')
    entries += [{'key': f'flag of debug {word}'} for word in flags]
    targets = array_of('src/apps/tools/capture_index.cpp', 'kTargets')
    return entries + [{'key': f'target of capture {word}', 'value': f'HASH{ending}'}
                      for word, ending in zip(targets[::2], targets[1::2])]


def identifiers():
    """Returns the words that reports name things by: IDs of diagnostics, of findings, of advice, and of draws."""
    rows = generate.rows_of
    entries = words_of_members()
    entries += [{'key': f'diagnostic {row[1]}'}
               for row in rows(ROOT / 'src/fp_compiler/front/diagnostic_ids.def', 'FP_DIAGNOSTIC')]
    entries += [{'key': f'diagnostic {row[0]}'}
                for row in rows(ROOT / 'src/apps/scene/diagnostic_ids.def', 'PANEL_DIAGNOSTIC')]
    state = ROOT / 'src' / 'state'
    entries += [{'key': f'path of draws {row[1]}'} for row in rows(state / 'core/paths.def', 'ARBITER_PATH')]
    entries += [{'key': f'reason of the rasterizer {row[1]}'}
                for row in rows(state / 'raster_draw/reasons.def', 'ARBITER_FALLBACK')]
    table = re.search(r'^\| id \|.*?\n\n', text_of('docs/use/doctor.md'), re.M | re.S).group()
    found = [name for line in table.strip().splitlines()[2:] for name in re.findall(r'`(\w+)`', line.split('|')[1])]
    code = ''.join(path.read_text() for path in sorted((ROOT / 'src/apps/tools/doctor').glob('*.*')))
    named = re.findall(r'(?:add\(|Finding)\{\s*"(\w+)"', code)
    if missing := set(named) - set(found) | {name for name in found if f'"{name}"' not in code}:
        raise Broken(f'docs/use/doctor.md: findings that the page or the code lacks: {sorted(missing)}')
    entries += [{'key': f'finding of doctor {name}'} for name in found]
    rules = re.search(r'kRules\[\] = \{(.*?)\n\};', text_of('src/apps/tools/advise/rules/rules.cpp'), re.S).group(1)
    return entries + [{'key': f'rule of advice {name}'} for name in re.findall(r'^    \{"(\w+)"', rules, re.M)]


DECLARATION = re.compile(r'^(?P<type>[\w\s*]+?[\s*])(?P<name>\w+)\s*\((?P<rest>.*)\)$', re.S)


def header(name='include/GL/arbiter.h', text=None):
    """Returns the constants, functions and types of arbiter.h. A constant's value is what is written."""
    text = text_of(name) if text is None else text
    text = re.sub(r'/\*.*?\*/', ' ', text, flags=re.S).replace('\\\n', ' ')
    entries, rest = [], []
    for line in text.splitlines():
        macro = re.match(r'\s*#\s*define\s+(\w+)(\([^)]*\))?\s*(.*?)\s*$', line)
        if macro:
            word, parameters, value = macro.group(1), macro.group(2) or '', ' '.join(macro.group(3).split())
            if word == 'GL_ARBITER_H':
                continue
            entry = {'key': word, 'what': 'macro' if parameters else 'constant'}
            # These say which version the header is of.
            entry['value'] = 'the version' if re.fullmatch(r'ARBITER_VERSION_(MAJOR|MINOR|PATCH)', word) \
                else (parameters + ' ' + value).strip()
            entries.append(entry)
        elif not line.lstrip().startswith('#'):
            rest.append(line)
    body = re.sub(r'extern\s+"C"\s*\{', ' ', '\n'.join(rest))
    for statement in re.split(r';(?![^{]*\})', body):
        words = ' '.join(statement.split()).strip(' }')
        if not words:
            continue
        function = DECLARATION.match(words)
        if words.startswith(('typedef', 'struct', 'enum', 'union')):
            last = re.search(r'(\w+)$', words) or re.search(r'\(\s*\*\s*(\w+)\s*\)', words)
            entries.append({'key': last.group(1), 'what': 'type', 'signature': words})
        elif function:
            entries.append({'key': function.group('name'), 'what': 'function', 'signature': words})
        else:
            raise Broken(f'{name}: cannot read {words!r}')
    return entries


def check_header(entries, name='include/GL/arbiter.h'):
    """Compares the names of constants with those that a compiler sees."""
    compiler = shutil.which('c++') or shutil.which('cc')
    if not compiler:
        return
    seen = subprocess.run([compiler, '-x', 'c++', '-E', '-dM', str(ROOT / name)], capture_output=True, text=True,
                          check=True).stdout
    none = subprocess.run([compiler, '-x', 'c++', '-E', '-dM', '/dev/null'], capture_output=True, text=True,
                          check=True).stdout
    names = {line.split()[1].split('(')[0] for line in set(seen.splitlines()) - set(none.splitlines())}
    found = {entry['key'] for entry in entries if entry['what'] in ('constant', 'macro')}
    if names - {'GL_ARBITER_H'} != found:
        raise Broken(f'{name}: a compiler sees other constants: {sorted(names ^ found)}')
