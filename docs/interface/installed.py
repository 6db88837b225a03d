"""Collects the names that others refer to: packages, installed files, types of files, the settings of editors, and the
symbols that the built libraries export.
"""
import json
import pathlib
import re
import subprocess
import xml.etree.ElementTree

from sources import ROOT, Broken, array_of, text_of

# The libraries of a build tree, with the folder below the library folder that they are installed in.
LIBRARIES = {'arbiter/libGLX_arbiter.so.0': 'src/interposer/libGLX_arbiter.so.0',
             'arbiter/libarbiter_first.so': 'src/interposer/libarbiter_first.so',
             'arbiter/libarbiter_jit.so': 'src/fp_compiler/back/llvm/libarbiter_jit.so',
             'arbiter/osmesa/libOSMesa.so.8': 'src/interposer/osmesa/libOSMesa.so.8'}
OF_GL = re.compile(r'(gl|OSMesa)[A-Z]')
# The symbols that only Arbiter's own libraries of the same version call.
OWN_SYMBOLS = {'arbiterReplacedVendor', 'arbiter_jit_interface'}
# Files and names that programs, packagers and scripts write down, with a source and the words in it that make each.
FILES = (
    ('<libdir>/arbiter/arbiter/10_arbiter.json', 'manifest of the EGL vendor, by path',
     'src/interposer/arbiter/meson.build', "rename: '10_arbiter.json'"),
    ('<libdir>/arbiter/arbiter/11_arbiter.json', 'manifest of the EGL vendor, by name',
     'src/interposer/arbiter/meson.build', "output: '11_arbiter.json'"),
    ('<libdir>/arbiter/preload', 'folder with a library for each width', 'src/interposer/preload/meson.build',
     'preload'),
    ('<datadir>/arbiter/defaults.d', 'defaults of programs that come with Arbiter', 'src/interposer/meson.build',
     "'arbiter' / 'defaults.d'"),
    ('/etc/arbiter/defaults.d', 'defaults of programs, the administrator\'s', 'src/util/flags.def',
     '/etc/arbiter/defaults.d'),
    ('$XDG_CONFIG_HOME/arbiter/defaults.d', 'defaults of programs, the user\'s', 'src/util/flags.def',
     '$XDG_CONFIG_HOME/arbiter/defaults.d'),
    ('$XDG_CACHE_HOME/arbiter', 'compiled programs', 'src/util/flags.def', '$XDG_CACHE_HOME/arbiter'),
    ('$XDG_RUNTIME_DIR/arbiter/PID.sock', 'socket of control', 'src/util/flags.def',
     '$XDG_RUNTIME_DIR/arbiter/PID.sock'),
    ('$XDG_RUNTIME_DIR/arbiter/PID.render.sock', 'socket of the renderer', 'docs/write/control.md',
     '$XDG_RUNTIME_DIR/arbiter/PID.render.sock'),
    ('$XDG_STATE_HOME/arbiter-builder', 'unsaved texts of the window', 'docs/man/arbiter-builder.1',
     '$XDG_STATE_HOME/arbiter\\-builder'),
    ('FILE.PID.running', 'statistics of a process that lives', 'src/util/flags.def', 'FILE.PID.running'),
    ('<datadir>/arbiter/defaults_template.toml', 'start of a file of defaults', 'docs/meson.build',
     'use/defaults_template.toml'),
    ('<datadir>/arbiter/gallery', 'the documents of gallery:NAME', 'src/apps/tools/meson.build',
     "'arbiter' / 'gallery'"),
    ('<includedir>/GL/arbiter.h', 'header', 'src/apps/tools/meson.build', "subdir: 'GL'"),
    ('arbiter.pc', 'module of pkg-config', 'src/apps/tools/meson.build', "name: 'arbiter'"),
)
SUFFIXES = ('fp', 'vp', 'vfp', 'arbfp', 'arbvp', 'atifs', 'nvrc', 'nvts', 'vsp')


def packages():
    """Returns the packages of Debian, with what each installs as debian/*.install has it."""
    entries = []
    for paragraph in re.split(r'\n\n', text_of('debian/control')):
        name = re.search(r'^Package: (\S+)', paragraph, re.M)
        if name:
            entries.append({'key': name.group(1), 'section': 'package'})
            for line in text_of(f'debian/{name.group(1)}.install').splitlines():
                source, _, folder = line.partition(' ')
                path = f'{folder}/{pathlib.PurePosixPath(source).name}' if folder else source
                if '/doc/' not in path:  # pages come and go
                    entries.append({'key': f'{name.group(1)} /{path}', 'section': 'installed'})
    return entries


def files():
    """Returns files, types of files and IDs that others name."""
    entries = []
    for path, what, source, words in FILES:
        if words not in text_of(source):
            raise Broken(f'{source}: says no longer {words!r}')
        entries.append({'key': path, 'what': what})
    tools = text_of('src/apps/tools/meson.build')
    for name, value in re.findall(r"'(\w+)=(\$\{libdir\}[^']*)'", tools):
        entries.append({'key': f'arbiter.pc: {name}', 'what': 'variable of pkg-config', 'value': value})
    tree = xml.etree.ElementTree.parse(ROOT / 'data/arbiter-mime.xml').getroot()
    space = {'m': 'http://www.freedesktop.org/standards/shared-mime-info'}
    for kind in tree.findall('m:mime-type', space):
        entries.append({'key': kind.get('type'), 'what': 'MIME type',
                        'choices': sorted({glob.get('pattern') for glob in kind.findall('m:glob', space)} |
                                          {match.get('value') for match in kind.findall('.//m:match', space)})})
    languages = text_of('docs/write/editors.md') + text_of('src/apps/tools/options/services.cpp') + \
        text_of('src/apps/tools/options/layer.cpp') + text_of('editors/vscode/package.json')
    for suffix in SUFFIXES:
        if f'.{suffix}' not in languages:
            raise Broken(f'no page has the ending .{suffix}')
        entries.append({'key': f'.{suffix}', 'what': 'ending of program texts'})
    for path in sorted((ROOT / 'data').iterdir()):
        if path.suffix in ('.desktop', '.thumbnailer', '.svg'):
            entries.append({'key': path.name, 'what': {'.desktop': 'desktop file', '.svg': 'icon',
                                                       '.thumbnailer': 'thumbnailer'}[path.suffix]})
    for file in ('data/arbiter-builder.metainfo.xml.in', *[f'data/flatpak/{path.name}' for path in
                                                          sorted((ROOT / 'data/flatpak').glob('*.xml'))]):
        name = re.search(r'<id>([^<]+)</id>', text_of(file)).group(1)
        entries.append({'key': name, 'what': 'ID of a component'})
    return entries


def editors():
    """Returns the language server's requests and settings, and those of the files for editors."""
    server = 'src/apps/tools/lsp/server.cpp'
    entries = []
    for array, what in (('kRequests', 'request'), ('kNotifications', 'notification')):
        for name in array_of(server, array):
            entries.append({'key': f'lsp {name}', 'what': what})
    trace = ''.join(text_of(f'src/apps/tools/lsp/{name}.cpp') for name in ('requests', 'report', 'actions', 'trace'))
    asked = {'arbiter/trace': ('pixel', 'pass', 'frame', 'against'), 'arbiter/report': ('position',)}
    for request, names in asked.items():
        for name in names:
            if f'"{name}"' not in trace:
                raise Broken(f'src/apps/tools/lsp: {request} reads no {name}')
            entries.append({'key': f'lsp {request} {name}', 'what': 'parameter'})
    life = text_of('src/apps/tools/lsp/lifecycle.cpp')
    if '{"arbiter", "profile"}' not in life or '"initializationOptions"' not in life:
        raise Broken('src/apps/tools/lsp/lifecycle.cpp: reads other settings')
    entries += [{'key': 'lsp setting arbiter.profile', 'what': 'setting', 'type': 'text'},
                {'key': 'lsp initializationOptions.profile', 'what': 'setting', 'type': 'text'}]
    for name in re.findall(r'"(\w+Provider|textDocumentSync|positionEncoding)"', life):
        entries.append({'key': f'lsp capability {name}', 'what': 'capability'})
    has = json.loads(text_of('editors/vscode/package.json'))['contributes']
    for language in has['languages']:
        entries.append({'key': f'VS Code language {language["id"]}', 'what': 'language',
                        'choices': language['extensions']})
    for name, setting in has['configuration']['properties'].items():
        entries.append({'key': f'VS Code setting {name}', 'what': 'setting', 'type': setting['type'],
                        'default': setting['default']})
    entries += [{'key': f'VS Code command {row["command"]}', 'what': 'command'} for row in has['commands']]
    for source, words in (('editors/emacs/arbprogram-mode.el', r"\(provide '([\w-]+)\)"),
                          ('editors/vim/ftdetect/arbprogram.vim', r'set filetype=(\w+)')):
        for name in sorted(set(re.findall(words, text_of(source)))):
            entries.append({'key': f'{source.split("/")[1]} {name}', 'what': 'mode'})
    return entries


def exported(path):
    """Returns the SONAME of a library, and the names that it exports, but for those of GL."""
    dynamic = subprocess.run(['readelf', '-dW', str(path)], capture_output=True, text=True, check=True).stdout
    soname = re.search(r'SONAME\)\s+Library soname: \[(.*?)\]', dynamic)
    listed = subprocess.run(['readelf', '--dyn-syms', '-W', str(path)], capture_output=True, text=True,
                            check=True).stdout
    names = set()
    for line in listed.splitlines():
        cells = line.split()
        if len(cells) >= 8 and cells[6] not in ('UND', 'Ndx') and cells[4] in ('GLOBAL', 'WEAK') and \
                cells[5] in ('DEFAULT', 'PROTECTED') and cells[6] != 'ABS':
            names.add(cells[7].split('@')[0])
    return soname.group(1) if soname else '', sorted(name for name in names if not OF_GL.match(name))


def symbols(build):
    """Returns the libraries with their SONAMEs, and the symbols that are not GL's."""
    entries = []
    for installed, built in LIBRARIES.items():
        path = pathlib.Path(build) / built
        if not path.exists():
            raise Broken(f'{path}: is not built')
        soname, names = exported(path)
        library = pathlib.PurePosixPath(installed).name
        entries.append({'key': f'<libdir>/{installed}', 'what': 'library', 'value': soname})
        for name in names:
            entry = {'key': f'{library}: {name}', 'what': 'symbol'}
            if name in OWN_SYMBOLS:
                entry['own'] = True
            entries.append(entry)
    return entries
