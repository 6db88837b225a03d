#!/usr/bin/env python3
"""Writes docs/reference/interface.json and interface.md, the list of what others may rely on, or checks them.

usage: docs/interface/write.py BUILD              write both, from the tree and from a built tree with tests
       docs/interface/write.py BUILD --check      compare; 1 if one is stale, and say which
       docs/interface/write.py BUILD --release VERSION
           write the list of a version, such as 1.1, into tests/interface too, before that version is released
"""
import pathlib
import sys
import tempfile

import commands
import installed
import interface_page
import lists
import protocol
import reports
import sources
import style

REFERENCE = sources.ROOT / 'docs' / 'reference'


def collected(build):
    """Returns the interface of a built tree, by kinds."""
    build = pathlib.Path(build)
    arbiter = build / 'src' / 'apps' / 'tools' / 'arbiter'
    if not arbiter.exists():
        raise sources.Broken(f'{arbiter}: is not built')
    options, helps = commands.options(str(arbiter))
    header = sources.header()
    sources.check_header(header)
    with tempfile.TemporaryDirectory(prefix='arbiter-interface-') as folder:
        runs = reports.Runs(arbiter, folder)
        documents, control = reports.collect(runs), protocol.collect(runs, build)
    style.schema_numbers()
    kinds = {'options': options + commands.window(), 'exit codes': commands.exit_codes(helps),
             'variables': sources.variables(), 'TOML': sources.toml_keys(), 'profiles': sources.profile_names(),
             'panels': sources.panel_words(), 'identifiers': sources.identifiers(), 'JSON': documents,
             'control': control, 'editors': installed.editors(), 'header': header,
             'libraries': installed.symbols(build), 'files': installed.files(), 'packages': installed.packages()}
    style.style_of_entries(kinds)
    style.one_type(kinds)
    return kinds


def list_of(build, version=None):
    """Returns the list of a built tree."""
    earlier = [each for each in lists.published() if each['version'] != version]
    return lists.with_versions(collected(build), version or sources.version(), earlier)


def files_of(made):
    return {REFERENCE / 'interface.json': lists.text_of_list(made),
            REFERENCE / 'interface.md': interface_page.page(made)}


def stale_files(made):
    """Returns the files that differ from what the list makes."""
    return [path for path, text in files_of(made).items() if not path.exists() or path.read_text() != text]


def write(paths):
    for path, text in paths.items():
        path.write_text(text)
        print(f'{path.relative_to(sources.ROOT)}: written')


def main():
    build, *more = sys.argv[1:] or ['']
    releases = more[:1] == ['--release'] and len(more) == 2
    if not build or not (releases or more in ([], ['--check'])):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        made = list_of(build, more[1] if releases else None)
    except (sources.Broken, ValueError) as error:
        print(f'write.py: {error}', file=sys.stderr)
        return 1
    stale = stale_files(made)
    if more == ['--check']:
        for path in stale:
            print(f'{path.relative_to(sources.ROOT)}: stale; run docs/interface/write.py BUILD')
        return 1 if stale else 0
    if releases:
        write({lists.PUBLISHED / f'{more[1]}.json': lists.text_of_list(made)})
    write({path: text for path, text in files_of(made).items() if path in stale})
    return 0


if __name__ == '__main__':
    sys.exit(main())
