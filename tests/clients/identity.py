#!/usr/bin/env python3
"""Tests the identity that a context under the layer reports to an application on the host.

Runs itself as the client, with EGL (surfaceless) and with OSMesa, under `arbiter run` with the
identity options: strings, glGetStringi, GL_NUM_EXTENSIONS and GetProcAddress must agree.
"""
import ctypes
import json
import os
import shutil
import sys
import xml.etree.ElementTree as ET

import extensions_table
import self_client
from self_client import GL_XML, egl_context, expect, osmesa_context
from x_server import XServer

GL_NAMES = {'vendor': 0x1F00, 'renderer': 0x1F01, 'version': 0x1F02, 'extensions': 0x1F03,
            'shading': 0x8B8C}
GL_NUM_EXTENSIONS, GL_MAJOR_VERSION, GL_MINOR_VERSION = 0x821D, 0x821B, 0x821C


# --- The client ---

def glx_client():
    """Prints GLX's strings without making a context."""
    x11, gl = ctypes.CDLL('libX11.so.6'), ctypes.CDLL('libGL.so.1')
    x11.XOpenDisplay.restype = ctypes.c_void_p
    gl.glXQueryExtensionsString.restype = ctypes.c_char_p
    display = x11.XOpenDisplay(None)
    if not display:
        return 77
    print(json.dumps(gl.glXQueryExtensionsString(ctypes.c_void_p(display), 0).decode().split()))
    return 0


def client(kind):
    if kind == 'glx':
        return glx_client()
    find = {'egl': egl_context, 'core': egl_context, 'osmesa': osmesa_context}[kind](kind == 'core')
    if find is None:
        return 77
    text, uint = ctypes.c_char_p, ctypes.c_uint
    get_string = ctypes.CFUNCTYPE(text, uint)(find(b'glGetString'))
    get_stringi = ctypes.CFUNCTYPE(text, uint, uint)(find(b'glGetStringi'))
    get_error = ctypes.CFUNCTYPE(uint)(find(b'glGetError'))
    get_integer = ctypes.CFUNCTYPE(None, uint, ctypes.c_void_p)(find(b'glGetIntegerv'))

    def integer(name):
        value = ctypes.c_int(-1)
        get_integer(name, ctypes.byref(value))
        return value.value

    answers = {}
    for name, enum in GL_NAMES.items():
        value = get_string(enum)
        answers[name] = None if value is None else value.decode()
        answers[name + '_error'] = get_error()
    answers['count'] = integer(GL_NUM_EXTENSIONS)
    answers['number'] = [integer(GL_MAJOR_VERSION), integer(GL_MINOR_VERSION)]
    answers['names'] = [get_stringi(0x1F03, i).decode() for i in range(answers['count'])]
    answers['behind'] = get_stringi(0x1F03, answers['count']) is not None
    answers['last_error'] = get_error()
    answers['missing'] = missing_functions(answers['names'], find)
    print(json.dumps(answers))
    return 0


def missing_functions(names, find):
    """Returns commands of announced extensions that GetProcAddress does not know."""
    if not os.path.exists(GL_XML):
        return []
    missing = []
    for node in ET.parse(GL_XML).getroot().find('extensions'):
        if node.get('name') not in names:
            continue
        for require in node.findall('require'):
            if require.get('api', 'gl') != 'gl' or require.get('profile') == 'core':
                continue
            missing += [f'{node.get("name")}: {command.get("name")}'
                        for command in require.findall('command')
                        if not find(command.get('name').encode())]
    return missing


# --- The harness ---

def ask(options, kind, arguments, **variables):
    """Returns the client's answers; without arguments (None) the bare host's."""
    return self_client.ask(__file__, options, kind, arguments, **variables)


def offered_by(profile):
    """Returns the extensions that the layer offers under a profile, by docs/driver/extensions.md."""
    rows = extensions_table.table(extensions_table.TABLE.read_text())
    return {name for name, (whose, profiles) in rows.items()
            if whose in extensions_table.OURS and profile in profiles}


def check_agreement(answers, bare):
    """Checks that the answers agree with each other. Functions that the bare host lacks of its own extensions, such as
    those that need a second extension, are ignored."""
    joined = (answers['extensions'] or '').split()
    expect(answers['count'] == len(answers['names']), 'GL_NUM_EXTENSIONS is not the count')
    left_out = set(answers['names']) - set(joined)
    expect(not joined or joined == [name for name in answers['names'] if name not in left_out],
           'the string and glGetStringi differ')
    if joined:
        length, host = len(answers['extensions']), len(bare['extensions'])
        expect(length <= host, f'the string has {length} bytes, and the host\'s {host}')
        expect(left_out <= set(bare['names']), f'of the layer\'s own names the string lacks {left_out}')
    expect(not answers['behind'] and answers['last_error'] == 0x501,
           'an index after the last is not GL_INVALID_VALUE')
    missing = [name for name in answers['missing'] if name not in bare['missing']]
    expect(not missing, f'announced, and GetProcAddress has no function: {missing}')


def check_kind(options, kind):
    bare = ask(options, kind, None)
    if bare is None:
        return False
    plain = ask(options, kind, [])
    check_agreement(plain, bare)
    for name in ('vendor', 'renderer', 'version', 'shading'):
        expect(plain[name] == bare[name], f'{name} without --identity: {plain[name]}')
    works = set(plain['names'])

    card = ask(options, kind, ['--identity', 'profile', '--profile', 'r300'])
    check_agreement(card, bare)
    expect(card['vendor'] == 'ATI Technologies Inc.', card['vendor'])
    expect(card['renderer'] == 'RADEON 9700 Generic', card['renderer'])
    expect(card['version'].startswith('1.3.'), card['version'])
    expect(card['number'] == [1, 3], f'GL_MAJOR_VERSION and its kin: {card["number"]}')
    expect(card['shading'] is None and card['shading_error'] == 0x500, 'a shading language in 1.3')
    names = set(card['names'])
    expect({'GL_ARB_fragment_program', 'GL_ARB_vertex_program', 'GL_EXT_texture3D'} <= names,
           f'the card lost what works: {sorted(names)}')
    expect(names <= works, f'announced and not there: {sorted(names - works)}')
    expect('GL_ARB_direct_state_access' not in names, 'an extension of 2014 on a card of 2002')
    kept = {'GL_EXT_texture_rectangle', 'GL_EXT_texture_mirror_clamp'} & set(bare['names'])
    expect(kept <= names, f'the card\'s driver had {kept - names}')

    for profile, vendor in (('nv30', 'NVIDIA Corporation'), ('i915', 'Tungsten Graphics, Inc')):
        other = ask(options, kind, ['--identity', 'profile', '--profile', profile])
        check_agreement(other, bare)
        # The layer offers these under this card's profile, but not under the host's.
        own = {'GL_NV_fragment_program', 'GL_NV_fragment_program_option', 'GL_NV_vertex_program',
               'GL_NV_vertex_program1_1', 'GL_NV_vertex_program2',
               'GL_NV_vertex_program2_option'} if profile == 'nv30' else set()
        own |= offered_by(profile)
        expect(other['vendor'] == vendor and own <= set(other['names']) <= works | own, f'{profile}: {other}')

    # A profile without a card gives the host's answers, and a warning in the log.
    host = ask(options, kind, ['--identity', 'profile', '--profile', 'host'])
    expect(host['vendor'] == bare['vendor'] and
           set(host['names']) == (works - offered_by('r300')) | offered_by('host'),
           'profile host')

    old = ask(options, kind, ['--extensions-max-year', '2003'])
    check_agreement(old, bare)
    expect(old['version'] == bare['version'], 'a year changed the version')
    expect('GL_ARB_vertex_program' in old['names'] and 'GL_EXT_framebuffer_object' not in
           old['names'], f'up to 2003: {old["names"]}')
    short = ask(options, kind, ['--extensions-max-length', '1024'])
    check_agreement(short, bare)
    expect(900 < len(short['extensions']) <= 1024, f'{len(short["extensions"])} bytes of 1024')
    check_switches(options, kind)
    print(f'{kind}: {len(works)} extensions, {len(names)} as r300, {len(old["names"])} to 2003, '
          f'{len(short["names"])} in 1024 bytes')
    return True


def check_switches(options, kind):
    """Checks single names that are switched on and off, with a profile's identity and without."""
    switched = ask(options, kind, ['--extensions', 'GL_EXT_abgr=off', '--extensions', 'GL_ARB_vertex_program=off'])
    for name in ('GL_EXT_abgr', 'GL_ARB_vertex_program'):
        expect(name not in switched['names'] and f'{name} ' not in switched['extensions'], f'{name} is still there')
    expect('GL_ARB_fragment_program' in switched['names'], 'what was not named went')
    card = ['--identity', 'profile', '--profile', 'r300']
    switched = ask(options, kind, [*card, '--extensions', 'GL_ARB_direct_state_access=on', '--extensions',
                                   'GL_NV_fence=on'])
    for name in ('GL_ARB_direct_state_access', 'GL_NV_fence'):
        expect(name in switched['names'], f'{name} was asked for: {switched["names"]}')
    host = ask(options, kind, ['--profile', 'host', '--extensions', 'GL_NV_vertex_program=on'])
    expect('GL_NV_vertex_program' in host['names'], 'the profile host has it, and was asked for it')


def check_glx(options):
    """Checks that names of GLX can only be hidden: no one can add what the host lacks."""
    if not shutil.which('Xvfb'):
        return False
    with XServer() as display:
        bare = ask(options, 'glx', None, DISPLAY=display)
        expect(set(ask(options, 'glx', [], DISPLAY=display)) == set(bare), 'GLX\'s names without an option')
        asked = ['--extensions', f'{bare[0]}=off', '--extensions', f'{bare[1]}=on', '--extensions', 'GLX_NOT_there=on']
        seen = ask(options, 'glx', asked, DISPLAY=display)
        expect(set(seen) == set(bare[1:]), f'{bare[0]} was to go: {seen}')
    return True


def check_core(options):
    """Checks that core contexts are the host's, whatever the settings."""
    bare = ask(options, 'core', None)
    if bare is None:
        return False
    asked = ask(options, 'core', ['--identity', 'profile', '--extensions-max-year', '2003'])
    for name in ('vendor', 'renderer', 'version', 'shading', 'names', 'number'):
        expect(asked[name] == bare[name], f'a core context\'s {name} changed')
    return True


def check(options):
    return any([check_kind(options, 'egl'), check_kind(options, 'osmesa'), check_core(options),
                check_glx(options)])


if __name__ == '__main__':
    sys.exit(self_client.main('identity', client, check))
