#!/usr/bin/env python3
"""Turns profiles/*.toml into the table of built-in profiles and into docs/reference/profiles.md.

A row that is missing, has no source, or is out of range stops the build: a limit is a number with
its source, or it is not a limit.
"""
import argparse
import pathlib
import re
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
# The order of every listing. The first profile is the default.
ORDER = ['r300', 'r300-catalyst-2004', 'r350', 'r360', 'r420', 'nv10', 'nv20', 'nv25', 'nv30', 'nv35',
         'nv40', 'i915', 'host']
ROW = re.compile(r'^PROFILE_ROW\((\w+), (\w+), (\w+), ([\w.]+), "([\w: ]+)", (\d+), (\d+)\)$')
CHOICE = re.compile(r'^PROFILE_CHOICE\((\w+), (\w+), ([\w.]+), (\w+), "([\w|]+)", "(.+)"\)$')
MODEL = 'model'  # the table that has choices

# Who answers a query of a row in the state tables. glGet answers from the profile always, only under
# ARBITER_IDENTITY=profile, or never. glGetProgramiv answers the other rows. tests/clients/card_limits.py
# checks this.
ALWAYS = {'texture_coords', 'texture_image_units', 'texture_units'}
WITH_IDENTITY = {'program_matrices', 'program_matrix_stack_depth', 'lights', 'draw_buffers',
                 'clip_planes', 'generic_attribs'}
NOT_OFFERED = {'palette_matrices', 'vertex_units'}

# The keys of [identity], in the order of profile.cpp.
IDENTITY = ['vendor', 'renderer', 'version', 'shading_language_version', 'extensions', 'year']


class Broken(Exception):
    """A profile that cannot be built in."""


def read_rows():
    rows = []
    for line in (HERE / 'rows.def').read_text().splitlines():
        if line.startswith('PROFILE_ROW'):
            match = ROW.match(line)
            if not match:
                raise Broken(f'rows.def: cannot read: {line}')
            name, table, key, member, gl_name, least, most = match.groups()
            rows.append({'name': name, 'table': table, 'key': key, 'gl': gl_name,
                         'least': int(least), 'most': int(most)})
    return rows


def read_choices():
    choices = []
    for line in (HERE / 'choices.def').read_text().splitlines():
        if line.startswith('PROFILE_CHOICE'):
            match = CHOICE.match(line)
            if not match:
                raise Broken(f'choices.def: cannot read: {line}')
            name, key, member, kind, names, doc = match.groups()
            choices.append({'name': name, 'key': key, 'names': names.split('|'), 'doc': doc})
    return choices


def check_choice(where, choice, entry):
    if set(entry) != {'value', 'source'}:
        raise Broken(f'{where}: needs a value and a source, and nothing else')
    value, source = entry['value'], entry['source']
    if value not in choice['names']:
        raise Broken(f'{where}: not one of {", ".join(choice["names"])}')
    if not isinstance(source, str) or not source.strip():
        raise Broken(f'{where}: empty source')
    return value, source


def check_row(where, row, entry):
    if set(entry) != {'value', 'source'}:
        raise Broken(f'{where}: needs a value and a source, and nothing else')
    value, source = entry['value'], entry['source']
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= row['most']:
        raise Broken(f'{where}: value out of range 0 to {row["most"]}')
    if not isinstance(source, str) or not source.strip():
        raise Broken(f'{where}: empty source')
    return value, source


def check_identity(where, key, entry):
    if set(entry) != {'value', 'source'}:
        raise Broken(f'{where}: needs a value and a source, and nothing else')
    value, source = entry['value'], entry['source']
    if key == 'year':
        if not isinstance(value, int) or not 1992 <= value <= 9999:
            raise Broken(f'{where}: not a year')
        value = str(value)
    elif key == 'extensions':
        value = ' '.join(value.split())
        for name in value.split():
            if not re.fullmatch(r'GL_\w+', name):
                raise Broken(f'{where}: no name of an extension: {name}')
    elif not re.fullmatch(r'[ -~]+', value):
        raise Broken(f'{where}: must be plain ASCII')
    if 'version' in key and not re.match(r'\d\.\d', value):
        raise Broken(f'{where}: must begin with a version number')
    if not isinstance(source, str) or not source.strip():
        raise Broken(f'{where}: empty source')
    return value, source


def read_rows_of(path, data, rows, base):
    known = {(row['table'], row['key']) for row in rows}
    choices = {(MODEL, choice['key']) for choice in read_choices()}
    for table in dict.fromkeys(row['table'] for row in rows):
        for key in data.get(table, {}):
            if (table, key) not in known | choices:
                raise Broken(f'{path.name}: unknown row {table}.{key}')
    values = {}
    for row in rows:
        where = f'{path.name}: {row["table"]}.{row["key"]}'
        entry = data.get(row['table'], {}).get(row['key'])
        if entry is not None:
            values[row['name']] = check_row(where, row, entry)
        elif row['name'] in base:
            values[row['name']] = base[row['name']]
        else:
            raise Broken(f'{where}: missing')
    return values


def read_choices_of(path, data, base):
    values = dict(base)
    for choice in read_choices():
        where = f'{path.name}: {MODEL}.{choice["key"]}'
        entry = data.get(MODEL, {}).get(choice['key'])
        if entry is not None:
            values[choice['name']] = check_choice(where, choice, entry)
        elif choice['name'] not in base:
            raise Broken(f'{where}: missing')
    return values


def read_identity_of(path, data, base):
    if data.get('identity') is False:
        return {}
    identity = dict(base)
    for key, entry in data.get('identity', {}).items():
        where = f'{path.name}: identity.{key}'
        if key not in IDENTITY:
            raise Broken(f'{where}: unknown row')
        identity[key] = check_identity(where, key, entry)
    if identity and not {'vendor', 'renderer', 'version', 'extensions'} <= set(identity):
        raise Broken(f'{path.name}: an identity is vendor, renderer, version and extensions')
    return identity


def read_aliases(path, data, earlier):
    """Returns the other names of the card, in lower case and without spaces and dashes."""
    taken = {name for profile in earlier.values() for name in [profile['name'], *profile['aliases']]}
    aliases = data.get('aliases', [])
    for alias in aliases:
        if not re.fullmatch(r'[a-z0-9]+', alias) or alias in taken or alias in ORDER:
            raise Broken(f'{path.name}: aliases: not of small letters and digits, or taken: {alias}')
    return aliases


def read_profile(path, rows, earlier):
    data = tomllib.loads(path.read_text())
    if data.get('name') != path.stem:
        raise Broken(f'{path.name}: name must be "{path.stem}"')
    if not data.get('description'):
        raise Broken(f'{path.name}: no description')
    tables = {row['table'] for row in rows}
    unknown = set(data) - {'name', 'description', 'aliases', 'inherits', 'from_host', 'identity', *tables}
    if unknown:
        raise Broken(f'{path.name}: unknown keys {sorted(unknown)}')
    base = {'rows': {}, 'choices': {}, 'identity': {}}
    if 'inherits' in data:
        if data['inherits'] not in earlier:
            raise Broken(f'{path.name}: inherits from an unknown or later profile')
        base = earlier[data['inherits']]
    return {'name': data['name'], 'description': data['description'],
            'aliases': read_aliases(path, data, earlier),
            'from_host': bool(data.get('from_host', False)),
            'rows': read_rows_of(path, data, rows, base['rows']),
            'choices': read_choices_of(path, data, base['choices']),
            'identity': read_identity_of(path, data, base['identity'])}


def read_all():
    rows = read_rows()
    present = {path.stem for path in (HERE / 'profiles').glob('*.toml')}
    if present != set(ORDER):
        raise Broken(f'profiles/ and ORDER differ: {sorted(present ^ set(ORDER))}')
    profiles = {}
    for name in ORDER:
        profiles[name] = read_profile(HERE / 'profiles' / f'{name}.toml', rows, profiles)
    return rows, list(profiles.values())


def quote(text):
    return '"' + text.replace('\\', '\\\\').replace('"', '\\"') + '"'


def as_cpp(rows, profiles):
    lines = ['// Generated by generate_profiles.py from profiles/*.toml.',
             '#include "fp_compiler/hw/builtin.h"', '', 'namespace arbiter::fp::hw {', '',
             'namespace {', 'constexpr BuiltinProfile kProfiles[] = {']
    for profile in profiles:
        lines.append(f'    {{{quote(profile["name"])}, {quote(profile["description"])}, '
                     f'{quote("|".join(profile["aliases"]))}, '
                     f'{str(profile["from_host"]).lower()},')
        lines.append('     {')
        for row in rows:
            value, source = profile['rows'][row['name']]
            lines.append(f'         {{{value}, {quote(source)}}}, // {row["table"]}.{row["key"]}')
        lines.append('     },')
        lines.append('     {')
        for choice in read_choices():
            value, source = profile['choices'][choice['name']]
            lines.append(f'         {{{choice["names"].index(value)}, {quote(source)}}}, '
                         f'// {MODEL}.{choice["key"]}: {value}')
        lines.append('     },')
        lines.append('     {')
        for key in IDENTITY:
            value, source = profile['identity'].get(key, ('', ''))
            lines.append(f'         {{{quote(value)}, {quote(source)}}}, // identity.{key}')
        lines.append('     }},')
    lines += ['};', '} // namespace', '',
              'std::span<const BuiltinProfile> builtinTable() { return kProfiles; }', '',
              '} // namespace arbiter::fp::hw']
    return '\n'.join(lines) + '\n'


DOC_HEAD = '''# Hardware profiles

Generated by `docs/generate.py` from `src/fp_compiler/hw/profiles/`; do not edit.

A profile is the set of limits that applications and the compiler see. Choose one with
`ARBITER_PROFILE`, `arbiter run --profile` or `arbiter check --profile`: a name from this page, or
the path of a TOML file of your own. The other names of a card, such as `radeon9700`, are taken in any
case, with spaces or dashes, behind the maker's name, and as `gf4` and `r9700` for GeForce4 and Radeon 9700.

```toml
# small.toml: a Radeon 9700 with half its temporaries
name = "small"
description = "to see which programs need more than 16 temporaries"
inherits = "r300"               # any built-in profile; without it every row is needed

[api]                           # GL_MAX_PROGRAM_*_ARB of the fragment target
temporaries = { value = 16, source = "an experiment" }   # or just: temporaries = 16

[vertex_api]                    # likewise of the vertex target
parameters = 96

[model]                         # what no query answers
fragment = "r300"               # how native counts come about (docs/write/native_model.md)
numerics = "fp24"               # the arithmetic, where ARBITER_NUMERICS does not say

[identity]                      # what ARBITER_IDENTITY=profile answers (docs/use/identity.md)
renderer = "RADEON 9700 PRO x86/SSE2"
```

Tables: `api`, `native` and `state` for the fragment target and for what both targets share;
`model` for how a fragment program is counted and computed; `vertex_api`, `vertex_native` and
`vertex_state` for the vertex target, which has documented limits and no model: its native counts
are the API's. A file that inherits nothing gets the rows of `r300` for the vertex target if it says
nothing of it, and `documented` for a model. `identity = false` in place of the table is no identity,
whatever was inherited.

API limits are what `glGetProgramivARB` answers and what a program is refused for, but for that of
texture indirections: where `state.refuse_indirections` is 0, a program over it loads with a warning, as
under the card's driver. Native limits decide `GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB` and never refuse a
program. With `from_host = true` the layer asks the host's driver for every number it can give.

Which rows an application is answered, in a compatibility context:

| answered | rows |
|---|---|
| always | by `glGetProgramivARB`: `api`, `native`, `vertex_api`, `vertex_native`, and the local and env parameters; by `glGet`: @ALWAYS@ |
| with identity | by `glGet` only under `ARBITER_IDENTITY=profile`: @WITH_IDENTITY@. Without it the host answers, for these are limits of all drawing, and a program may use as many as the host says |
| no | @NOT_OFFERED@: no host has the extension or the layer the means, so `glGet` raises `GL_INVALID_ENUM` and no program can name one, whatever the row says |

An answer of `glGet` is never above the host's own: what a row has more could not be drawn with. What
GL calls a limit and has no row (texture sizes, vertex texture units, anisotropy, ...) is the host's.
`arbiter check`, which has no host, goes by the rows alone: a program that uses `result.color[4]` is
not valid under a profile with 4 draw buffers.
'''


def as_markdown(rows, profiles):
    def listed(keys):
        return ', '.join(f'`{row["key"]}`' for row in rows if row['key'] in keys)

    out = [DOC_HEAD.replace('@ALWAYS@', listed(ALWAYS)).replace('@NOT_OFFERED@', listed(NOT_OFFERED))
           .replace('@WITH_IDENTITY@', listed(WITH_IDENTITY))]
    names = [profile['name'] for profile in profiles]
    out.append('## All profiles\n')
    out.append('| row | GL name | answered | ' + ' | '.join(names) + ' | least | most |')
    out.append('|---|---|---|' + '---:|' * (len(names) + 2))
    for row in rows:
        cells = [str(profile['rows'][row['name']][0]) for profile in profiles]
        gl = row['gl'] if row['gl'].startswith('none') else f'`GL_{row["gl"]}`'
        answered = ('no' if row['gl'].startswith('none') or row['key'] in NOT_OFFERED
                    else 'with identity' if row['key'] in WITH_IDENTITY else 'always')
        out.append(f'| {row["table"]}.{row["key"]} | {gl} | {answered} | ' + ' | '.join(cells) +
                   f' | {row["least"]} | {row["most"]} |')
    for choice in read_choices():
        cells = [profile['choices'][choice['name']][0] for profile in profiles]
        out.append(f'| {MODEL}.{choice["key"]} | none | no | ' + ' | '.join(cells) + ' | | |')
    out.append('\nLeast: what the specification guarantees; a profile may go below it. Most: what '
               'Arbiter can hold.\n')
    for choice in read_choices():
        out.append(f'- `{MODEL}.{choice["key"]}` ({", ".join(choice["names"])}): {choice["doc"]}')
    out.append('')
    for profile in profiles:
        out.append(f'## {profile["name"]}\n\n{profile["description"]}.\n')
        if profile['aliases']:
            out.append('Other names: ' + ', '.join(f'`{alias}`' for alias in profile['aliases']) + '.\n')
        out.append('| row | value | source |')
        out.append('|---|---:|---|')
        for row in rows:
            value, source = profile['rows'][row['name']]
            out.append(f'| {row["table"]}.{row["key"]} | {value} | {source} |')
        for choice in read_choices():
            value, source = profile['choices'][choice['name']]
            out.append(f'| {MODEL}.{choice["key"]} | {value} | {source} |')
        for key in IDENTITY:
            if key in profile['identity']:
                value, source = profile['identity'][key]
                if key == 'extensions':
                    value = f'{len(value.split())} names'
                out.append(f'| identity.{key} | {value} | {source} |')
        out.append('')
    return '\n'.join(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--output', required=True, help='the C++ file to write')
    options = parser.parse_args()
    try:
        rows, profiles = read_all()
    except (Broken, tomllib.TOMLDecodeError) as error:
        print(f'generate_profiles.py: {error}', file=sys.stderr)
        return 1
    pathlib.Path(options.output).write_text(as_cpp(rows, profiles))
    return 0


if __name__ == '__main__':
    sys.exit(main())
