"""Reads files of cases: texts with their verdicts by the specification.

A case begins with a line

    === NAME | VERDICT | REASON [| WORD]...

and ends at the next such line; lines that begin with # before the first are comments. VERDICT is
accept or refuse; REASON is the specification's section or rule. A WORD is one of

    undefined            the specification does not define the picture: bare hosts are not compared
    exact                all ways draw the same to the bit, including the bare host's own path
    host-exact           the bare host and the layer's back end host do; the rasterizer may round otherwise
    show RESULT          the result of a vertex program that is shown (texts.cpp); else its color
    bare accept: WHY     the bare host's verdict differs, and why that is no fault of the layer
    bare refuse: WHY
    bare rounds from Mesa N.M: WHY   for `exact`: in Mesa N.M and later the bare host's path agrees only approximately
    bare draws: WHY      the bare host's picture depends on memory that it never wrote: not compared

@{A;B;C} in a text or in the words stands for one case each with A, B and C, in every combination of
several; braces nest.
"""

import dataclasses
import itertools
import pathlib


class Malformed(Exception):
    """A file of cases cannot be read; the message has file and line."""


@dataclasses.dataclass
class Case:
    """One text. `place` is "file:line" of the line that begins it."""
    name: str
    place: str
    text: str
    stage: str
    accepted: bool
    reason: str
    undefined: bool = False
    exact: bool = False
    host_exact: bool = False
    shown: str = 'primary'
    bare_accepted: bool = None
    bare_reason: str = ''
    bare_varies: bool = False
    bare_rounds_from: tuple = None


def pieces(text):
    """Returns the text as an alternating list of strings and lists of alternatives."""
    parts, at = [], 0
    while (begin := text.find('@{', at)) >= 0:
        depth, options, start = 1, [], begin + 2
        end = start
        while depth:
            if end >= len(text):
                raise ValueError('@{ is not closed')
            if text[end] == '{':
                depth += 1
            elif text[end] == '}':
                depth -= 1
            if (text[end] == ';' and depth == 1) or not depth:
                options.append(text[start:end])
                start = end + 1
            end += 1
        parts += [text[at:begin], options]
        at = end
    return parts + [text[at:]]


def expanded(text):
    """Returns (label, text) of every combination; the label is empty for a text without alternatives."""
    parts = pieces(text)
    choices = [part for part in parts if isinstance(part, list)]
    for chosen in itertools.product(*choices):
        rest = iter(chosen)
        whole = ''.join(next(rest) if isinstance(part, list) else part for part in parts)
        yield (' [' + '] ['.join(chosen) + ']' if chosen else ''), whole


def stage_of(path, text):
    for stage in ('fragment', 'vertex'):
        if path.name.startswith(stage):
            return stage
    return 'vertex' if text.startswith('!!ARBvp') else 'fragment'


def with_words(case, words):
    for word in words:
        if word in ('undefined', 'exact', 'host-exact'):
            setattr(case, word.replace('-', '_'), True)
        elif word.startswith('show '):
            case.shown = word[5:]
        elif word.startswith('bare ') and ': ' in word:
            verdict, case.bare_reason = word[5:].split(': ', 1)
            if verdict == 'draws':
                case.bare_varies = True
            elif verdict.startswith('rounds from Mesa '):
                year, number = verdict.split()[-1].split('.')
                case.bare_rounds_from = int(year), int(number)
            else:
                case.bare_accepted = {'accept': True, 'refuse': False}[verdict]
        else:
            raise ValueError(f'what is "{word}"?')
    return case


def cases_of(path, line, head, text):
    fields = [field.strip() for field in head.split(' | ')]
    if len(fields) < 3 or fields[1] not in ('accept', 'refuse'):
        raise ValueError('expected NAME | accept or refuse | REASON')
    for words_label, words in expanded(' | '.join(fields[3:])):
        for label, whole in expanded(text):
            case = Case(fields[0] + words_label + label, f'{path.name}:{line}', whole,
                        stage_of(path, whole), fields[1] == 'accept', fields[2])
            yield with_words(case, words.split(' | ') if words else [])


def read_cases(path):
    """Reads every case of a file. Raises Malformed."""
    path = pathlib.Path(path)
    heads = []
    for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(keepends=True), 1):
        if line.startswith('=== '):
            heads.append([number, line[4:].strip(), ''])
        elif heads:
            heads[-1][2] += line
        elif line.strip() and not line.startswith('#'):
            raise Malformed(f'{path}:{number}: text before the first case')
    cases = []
    for number, head, text in heads:
        try:
            cases += cases_of(path, number, head, text)
        except (ValueError, KeyError) as error:
            raise Malformed(f'{path}:{number}: {error}') from error
    return cases
