"""Types of members that the fixed inputs cannot show: what other machines, faults and other programs make of them.

A type here stands in place of the one that was seen. What was seen must be a part of it.
"""
from sources import Broken

TEXT_OR_NULL, NUMBER_OR_NULL = 'text or null', 'number or null'
REPORTS = {
    'debug against.result': TEXT_OR_NULL,
    'debug rows[].second_discards': 'truth',
    'debug stopped': NUMBER_OR_NULL,
    'debug watch.pixel': 'list of number or text or null',
    'check --compare compare.nodes': 'object or null',
    'check --compare compare.nodes.a': NUMBER_OR_NULL,
    'check --compare compare.nodes.b': NUMBER_OR_NULL,
    'check --compare compare.nodes.delta': NUMBER_OR_NULL,
    'report faults': 'list of text',
    'report histograms[].bins[].last': NUMBER_OR_NULL,
    'statistics contexts[].obstacle': 'text',
    'capture process-PID.json why_not_written': 'text',
}
# Maps that may be empty.
for place in ('statistics draws.reasons', 'statistics software.given_to_host', 'statistics feedback.kinds',
              'stats sum.draws', 'stats sum.given_to_host', 'stats files[].reports[].draws',
              'stats files[].reports[].given_to_host', 'capture index.json programs[].draws_by',
              'capture process-PID.json programs[].draws_by'):
    REPORTS[place] = 'map of number'
for file in ('capture index.json', 'capture process-PID.json'):
    REPORTS[f'{file} programs[].options'] = REPORTS[f'{file} programs[].textures[].enabled'] = 'list of text'
PROTOCOL = {
    'layer ping > idle': NUMBER_OR_NULL,
    'layer program.get > edit': TEXT_OR_NULL,
    'layer program.get > text_base64': 'text',
    'layer pixel.hold > text_base64': 'text',
    'layer pixel.hold > fragment': TEXT_OR_NULL,
    'layer pixel.hold > vertex': TEXT_OR_NULL,
    'layer pixel.pick > draws[].color': 'list of number or null',
    'layer frame.measure > draws[].pixels': NUMBER_OR_NULL,
    'layer frame.measure > programs{}.pixels': NUMBER_OR_NULL,
    'renderer ping > idle': NUMBER_OR_NULL,
    'renderer ping > busy': NUMBER_OR_NULL,
    'renderer frame > steps': 'number',
    'layer stats > draws': 'map of number',
    'layer stats > software.given_to_host': 'map of number',
}
for request in ('pixel.pick', 'frame.measure'):
    PROTOCOL[f'layer {request} > trouble'] = TEXT_OR_NULL
    for stage in ('fragment', 'vertex'):
        PROTOCOL[f'layer {request} > draws[].{stage}'] = TEXT_OR_NULL


def fits(seen, known):
    """True if every kind of the first type is in the second: "list" is in "list of text or null"."""
    words = {word for word in seen.replace(' of ', ' or ').split(' or ')}
    return words <= {word for word in known.replace(' of ', ' or ').split(' or ')}


def complete(entries, types):
    """Returns the entries with the types of the table."""
    by_key = {entry['key']: entry for entry in entries}
    for key, kind in types.items():
        entry = by_key.get(key)
        if entry is None:
            entries.append({'key': key, 'type': kind})
        elif not fits(entry['type'], kind):
            raise Broken(f'docs/interface/known.py: {key} is {entry["type"]}, not {kind}')
        else:
            entry['type'] = kind
    return entries
