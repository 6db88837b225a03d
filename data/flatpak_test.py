#!/usr/bin/env python3
"""Checks the extension for Flatpak: its manifest against the build files, its store page. Nothing is built.

usage: flatpak_test.py SOURCE [unittest arguments]
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

try:
    import yaml
except ImportError:
    yaml = None

SOURCE = pathlib.Path(sys.argv[1]).resolve()
ID = 'org.freedesktop.Platform.VulkanLayer.Arbiter'
MANIFEST = SOURCE / 'data' / 'flatpak' / f'{ID}.yml'
METAINFO = MANIFEST.with_suffix('.metainfo.xml')

# org.freedesktop.Sdk has these of the dependencies, from its release 23.08 on (freedesktop-sdk's elements/sdk.bst).
IN_SDK = {'threads', 'libpng', 'libjpeg', 'epoxy', 'libelf'}
# Meson's own, as far as the manifest may set them.
OF_MESON = {'buildtype', 'b_pch', 'optimization', 'debug'}
# Left out by options of the manifest.
LEFT_OUT = ('src/apps/builder/', 'demos/', 'tests/', 'bench/')


def needs(*commands):
    missing = [command for command in commands if not shutil.which(command)]
    return unittest.skipIf(missing, f'not installed: {", ".join(missing)}')


def required_dependencies():
    """The names that the build files ask for and cannot do without, in what the extension builds of them."""
    names = set()
    for path in [SOURCE / 'meson.build', *sorted((SOURCE / 'src').rglob('meson.build'))]:
        if path.relative_to(SOURCE).as_posix().startswith(LEFT_OUT):
            continue
        for name, rest in re.findall(r"\bdependency\('([^']+)'([^()]*)", path.read_text()):
            if 'required:' not in rest:
                names.add(name)
    return names


def written_packages(commands):
    """The .pc files that the commands write: lines of a name and a version in a here-document."""
    return set(re.findall(r'^(\w+) [\d.]+(?: -.*)?$', '\n'.join(commands), re.MULTILINE))


@unittest.skipIf(yaml is None, 'not installed: python3-yaml')
class Manifest(unittest.TestCase):
    def setUp(self):
        self.manifest = yaml.safe_load(MANIFEST.read_text())
        self.prefix = self.manifest['build-options']['prefix']
        self.modules = {module['name']: module for module in self.manifest['modules']}
        self.compiled_in, self.arbiter = self.modules['compiled-in'], self.modules['arbiter']

    def options(self):
        for option in self.arbiter['config-opts']:
            name, _, value = re.sub('^-D|^--', '', option).partition('=')
            yield name, value

    def test_names_are_the_same_everywhere(self):
        self.assertEqual(self.manifest['id'], ID)
        self.assertEqual(ElementTree.parse(METAINFO).findtext('id'), ID)
        self.assertEqual(ElementTree.parse(METAINFO).findtext('extends'), self.manifest['runtime'])
        self.assertEqual(ID.rpartition('.')[0], f'{self.manifest["runtime"]}.VulkanLayer')
        self.assertTrue(self.manifest['build-extension'])

    def test_it_lies_where_the_runtime_mounts_it(self):
        self.assertEqual(self.prefix, f'/usr/lib/extensions/vulkan/{ID.rpartition(".")[2]}')
        for machine, options in self.manifest['build-options']['arch'].items():
            self.assertEqual(options['libdir'], f'{self.prefix}/lib/{machine}-linux-gnu')
        # A folder by which a process of either width finds its own.
        self.assertIn("'lib/x86_64-linux-gnu'", (SOURCE / 'meson.build').read_text())

    def test_the_branch_is_the_runtimes(self):
        # The runtime mounts no extension of another branch.
        self.assertIsInstance(self.manifest['branch'], str)
        self.assertEqual(self.manifest['branch'], self.manifest['runtime-version'])
        script = (SOURCE / 'scripts' / 'flatpak.sh').read_text()
        self.assertIn(f'branch=${{1:-{self.manifest["branch"]}}}', script)

    def test_options_are_ours_or_mesons(self):
        ours = set(re.findall(r"^option\('(\w+)'", (SOURCE / 'meson_options.txt').read_text(), re.MULTILINE))
        for name, value in self.options():
            self.assertIn(name, ours | OF_MESON)
            self.assertTrue(value, name)

    def test_each_dependency_is_given(self):
        options = dict(self.options())
        # The parts that required_dependencies() leaves out are not built.
        self.assertEqual((options['tests'], options['demos'], options['builder']), ('false', 'false', 'disabled'))
        given = written_packages(self.compiled_in['build-commands'])
        asked = required_dependencies()
        self.assertGreater(len(asked), 5)
        self.assertEqual(asked - IN_SDK, given)

    def test_llvm_is_debians_for_each_processor(self):
        # Flathub's extensions of LLVM leave the archives out, which the machine code's library is linked with.
        self.assertNotIn('sdk-extensions', self.manifest)
        release = dict(self.options())['llvm']
        folder = f'{self.prefix}/llvm/usr/lib'
        self.assertEqual(self.manifest['build-options']['append-path'], f'{folder}/llvm-{release}/bin')
        self.assertIn(f'/llvm-{release}/bin/llvm-config-{release}"', self.modules['llvm']['build-commands'][-1])
        self.assertIn('/llvm', self.manifest['cleanup'])
        for machine, options in self.manifest['build-options']['arch'].items():
            # The library of llvm-config that is none of the SDK's.
            self.assertEqual(options['prepend-ld-library-path'], f'{folder}/{machine}-linux-gnu')
            debian = {'x86_64': 'amd64', 'aarch64': 'arm64'}[machine]
            files = [source['url'].rpartition('/')[2] for source in self.modules['llvm']['sources']
                     if source['only-arches'] == [machine]]
            self.assertEqual([re.sub(r'_[^_]*_', '_', file) for file in files],
                             [f'{name}_{debian}.deb' for name in (f'llvm-{release}-dev', f'llvm-{release}', 'libz3-4')])

    def test_the_shared_llvm_is_asked_for_by_tests_alone(self):
        # llvm-config fails where the library is missing, as it is in Debian's package of the archives.
        build = (SOURCE / 'src' / 'fp_compiler' / 'back' / 'llvm' / 'meson.build').read_text()
        installed, _, tests = build.partition("\n  if get_option('tests')\n")
        self.assertIn('--link-static', installed)
        self.assertNotIn('--link-shared', installed)
        self.assertIn('--link-shared', tests)

    def test_the_registry_is_where_it_is_looked_for(self):
        path = dict(self.options())['gl_xml']
        self.assertEqual(path, f'{self.prefix}/share/khronos-api/gl.xml')
        self.assertTrue([line for line in self.compiled_in['build-commands']
                         if '"$FLATPAK_DEST/share/khronos-api"' in line and line.endswith('gl.xml')])

    def test_files_that_are_installed_exist(self):
        # Commands after the installation run in Meson's build folder.
        lines = [line.replace('$FLATPAK_ID', ID) for line in self.arbiter['post-install']]
        files = [word.strip('"') for line in lines for word in line.split() if '/data/' in word]
        self.assertTrue(files)
        for file in files:
            self.assertTrue(file.startswith('$FLATPAK_BUILDER_BUILDDIR/'), file)
            self.assertTrue((SOURCE / file.partition('/')[2]).is_file(), file)
        folder, = self.arbiter['sources']
        self.assertEqual((MANIFEST.parent / folder['path']).resolve(), SOURCE)

    def test_sources_are_held_to_their_bytes(self):
        used = ' '.join(self.compiled_in['build-commands'])
        for source in self.compiled_in['sources']:
            self.assertIn(f'{source["dest"]}/', used)
        for source in self.compiled_in['sources'] + self.modules['llvm']['sources']:
            self.assertTrue(source['url'].startswith('https://'), source['url'])
            if source['type'] == 'git':
                self.assertRegex(source['commit'], '^[0-9a-f]{40}$')
            else:
                self.assertRegex(source['sha256'], '^[0-9a-f]{64}$')

    @needs('flatpak-builder')
    def test_flatpak_builder_takes_it(self):
        with tempfile.TemporaryDirectory() as folder:  # it makes one of its own where it is started
            run = subprocess.run(['flatpak-builder', '--show-manifest', MANIFEST], cwd=folder, capture_output=True,
                                 text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ''))
        read = json.loads(run.stdout)
        self.assertEqual([module['name'] for module in read['modules']], list(self.modules))
        for module in read['modules']:
            # A key that it does not know is left out of what it shows.
            self.assertEqual(set(module), set(self.modules[module['name']]))
        self.assertEqual(set(self.manifest) - set(read), set())


class StorePage(unittest.TestCase):
    @needs('appstreamcli')
    def test_it_is_valid(self):
        run = subprocess.run(['appstreamcli', 'validate', '--no-net', METAINFO], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
