#!/usr/bin/env python3
"""Tests that under ARBITER_IDENTITY=profile GL returns every row of a profile that has a GL name.

Runs itself as the client, with EGL (surfaceless) and with OSMesa, under each built-in profile, and queries each row by
every function that returns it. If a row exceeds the host's limit, the host's counts; the same holds for rows of the
profile `host`. Programs must agree with the answers: the last draw buffer and the last clip plane load, the next does
not. Without the identity only the limits of programs and texture units are the card's.
"""
import ctypes
import json
import os
import pathlib
import sys
import xml.etree.ElementTree as ET

import self_client
from self_client import GL_XML, egl_context, expect, osmesa_context

HW = pathlib.Path(__file__).resolve().parents[2] / 'src' / 'fp_compiler' / 'hw'
sys.path.insert(0, str(HW))
import generate_profiles  # noqa: E402

FRAGMENT, VERTEX, ASCII = 0x8804, 0x8620, 0x8875
INVALID_ENUM = 0x500
PROGRAM_TABLES = {'api': FRAGMENT, 'native': FRAGMENT, 'vertex_api': VERTEX, 'vertex_native': VERTEX}
PARAMETERS = ('local_parameters', 'env_parameters')
# GL's query functions, and how each returns a number.
GETTERS = {'glGetIntegerv': (ctypes.c_int, int), 'glGetFloatv': (ctypes.c_float, float),
           'glGetDoublev': (ctypes.c_double, float), 'glGetInteger64v': (ctypes.c_int64, int),
           'glGetBooleanv': (ctypes.c_ubyte, lambda value: int(value != 0))}


def queries():
    """Returns {row: (enum, program target or None)} of the rows that have a GL name."""
    numbers = {node.get('name'): int(node.get('value'), 0)
               for node in ET.parse(GL_XML).getroot().iter('enum') if node.get('value')}
    rows, _ = generate_profiles.read_all()
    asked = {}
    for row in rows:
        if row['gl'].startswith('none'):
            continue
        target = PROGRAM_TABLES.get(row['table'])
        if row['key'] in PARAMETERS:
            target = VERTEX if row['table'] == 'vertex_state' else FRAGMENT
        asked[f'{row["table"]}.{row["key"]}'] = (numbers['GL_' + row['gl']], target)
    return asked


# --- The client ---

def client(kind):
    find = {'egl': egl_context, 'osmesa': osmesa_context}[kind](False)
    if find is None:
        return 77
    uint, pointer = ctypes.c_uint, ctypes.c_void_p

    def function(name, result, *arguments):
        return ctypes.CFUNCTYPE(result, *arguments)(find(name.encode()))

    get_error = function('glGetError', uint)
    get_program = function('glGetProgramivARB', None, uint, uint, pointer)
    program_string = function('glProgramStringARB', None, uint, uint, ctypes.c_int, ctypes.c_char_p)
    bind = function('glBindProgramARB', None, uint, uint)
    delete = function('glDeleteProgramsARB', None, ctypes.c_int, pointer)
    getters = {name: (function(name, None, uint, pointer), kind_of)
               for name, (kind_of, _) in GETTERS.items()}

    def answer(call, kind_of):
        value = kind_of(77)
        call(ctypes.byref(value))
        error = get_error()
        return {'error': error} if error else {'value': value.value}

    answers = {}
    for row, (enum, target) in queries().items():
        if target:
            answers[row] = {'glGetProgramivARB': answer(
                lambda place, t=target, e=enum: get_program(t, e, place), ctypes.c_int)}
            continue
        answers[row] = {name: answer(lambda place, c=call, e=enum: c(e, place), kind_of)
                        for name, (call, kind_of) in getters.items()}

    def loads(target, text):
        # It uses a program of its own, as Mesa 25 frees memory twice if one vertex program is loaded three times.
        name = uint(1)
        bind(target, name)
        program_string(target, ASCII, len(text), text.encode())
        error = get_error()
        delete(1, ctypes.byref(name))
        return error == 0

    def count(holds):
        """Returns how many of 0, 1, 2 ... hold."""
        return next((i for i in range(64) if not holds(i)), 64)

    programs = {
        'state.draw_buffers': count(lambda i: loads(
            FRAGMENT, f'!!ARBfp1.0\nOPTION ARB_draw_buffers;\nMOV result.color[{i}], 1;\nEND')),
        'state.clip_planes': count(lambda i: loads(
            VERTEX, f'!!ARBvp1.0\nMOV result.position, state.clip[{i}].plane;\nEND')),
        'state.lights': count(lambda i: loads(
            VERTEX, f'!!ARBvp1.0\nMOV result.position, state.light[{i}].position;\nEND')),
        'state.program_matrices': count(lambda i: loads(
            VERTEX, f'!!ARBvp1.0\nMOV result.position, state.matrix.program[{i}].row[0];\nEND')),
        'state.texture_image_units': count(lambda i: loads(
            FRAGMENT, f'!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[{i}], 2D;\nEND')),
        'state.texture_coords': count(lambda i: loads(
            FRAGMENT, f'!!ARBfp1.0\nMOV result.color, fragment.texcoord[{i}];\nEND')),
        'vertex_state.generic_attribs': count(lambda i: loads(
            VERTEX, f'!!ARBvp1.0\nMOV result.position, vertex.attrib[{i}];\nEND')),
    }
    print(json.dumps({'answers': answers, 'programs': programs}))
    return 0


# --- The harness ---

def ask(options, kind, arguments):
    """Returns the client's answers; without arguments (None) the bare host's."""
    return self_client.ask(__file__, options, kind, arguments)


def answered(value):
    return {name: {'value': shown(value)} for name, (_, shown) in GETTERS.items()}


# Rows that the layer offers on every host, if they are not 0.
OFFERED = ('model.general_combiners',)


def host_value(bare, row):
    """Returns the host's answer to Get; None if it does not know the name."""
    return bare['answers'][row].get('glGetIntegerv', {}).get('value')


def wanted(row, value, bare, from_host, is_program):
    """Returns the required answers of a row, by function."""
    if row in OFFERED:
        return answered(value) if value else bare['answers'][row]
    if is_program:
        return bare['answers'][row] if from_host else {'glGetProgramivARB': {'value': value}}
    host = host_value(bare, row)
    if host is None:  # a host without the extension has no answer, and no program can use it
        return {name: {'error': INVALID_ENUM} for name in GETTERS}
    return answered(host if from_host else min(value, host))


def check_card(options, kind, bare, profile):
    """Checks a card. \\return how many answers were compared, and the rows that exceed the host"""
    asked = ask(options, kind, ['--identity', 'profile', '--profile', profile['name']])
    compared, lower = 0, []
    for row, (_, target) in queries().items():
        value = profile['rows'][profile['names'][row]][0]
        want = wanted(row, value, bare, profile['from_host'], target is not None)
        expect(asked['answers'][row] == want,
               f'{kind}, {profile["name"]}, {row} is {value}: {asked["answers"][row]}, not {want}')
        compared += len(want)
        host = host_value(bare, row)
        if target is None and host is not None and host < value:
            lower.append(row)
    for row, count in asked['programs'].items():
        want = asked['answers'][row]['glGetIntegerv']['value']
        expect(count == want, f'{kind}, {profile["name"]}: programs may use {count} of {row}, '
                              f'and GL answers {want}')
    return compared, lower


def check_plain(options, kind, bare, r300):
    """Checks that without the identity the limits of programs and units are the card's, all others the host's."""
    asked = ask(options, kind, [])
    for row, (_, target) in queries().items():
        value = r300['rows'][r300['names'][row]][0]
        cards = target is not None or row.split('.')[1] in generate_profiles.ALWAYS
        want = wanted(row, value, bare, False, target is not None) if cards else bare['answers'][row]
        expect(asked['answers'][row] == want,
               f'{kind}, no identity, {row}: {asked["answers"][row]}, not {want}')
    for row, count in asked['programs'].items():
        want = asked['answers'][row]['glGetIntegerv']['value']
        expect(count == want, f'{kind}, no identity: programs may use {count} of {row}, and GL '
                              f'answers {want}')


def profiles():
    rows, read = generate_profiles.read_all()
    names = {f'{row["table"]}.{row["key"]}': row['name'] for row in rows}
    return [{**profile, 'names': names} for profile in read]


def check_kind(options, kind):
    bare = ask(options, kind, None)
    if bare is None:
        return False
    cards = profiles()
    total, lower = 0, {}
    for profile in cards:
        compared, less = check_card(options, kind, bare, profile)
        total += compared
        lower.update({row: profile['name'] for row in less})
    check_plain(options, kind, bare, next(p for p in cards if p['name'] == 'r300'))
    print(f'{kind}: {total} answers of {len(cards)} profiles; the host can do less in: '
          f'{", ".join(sorted(lower)) or "none"}')
    return True


def check(options):
    if not os.path.exists(GL_XML):
        return False
    return any([check_kind(options, 'egl'), check_kind(options, 'osmesa')])


if __name__ == '__main__':
    sys.exit(self_client.main('card_limits', client, check))
