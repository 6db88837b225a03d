#!/usr/bin/env python3
"""Tests of `arbiter doctor`: its findings in situations where the layer does not reach a program.

usage: doctor_test.py ARBITER LAYER SOURCE_ROOT CXX [unittest arguments]
"""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from command_session import FAKE as LAYER, arbiter, plain  # noqa: E402
from doctor_clients import CLIENT, GLX_CALL, GLX_CLIENT, GL_CALL, LONG, OPENS  # noqa: E402
from doctor_session import CXX, Examined, loader_of, of_32_bits  # noqa: E402
from x_server import XServer  # noqa: E402


class Doctor(Examined):
    def test_nothing_is_in_the_way(self):
        game = self.compile('game', GL_CALL, '-lGL')
        self.assertEqual(self.obstacles(self.ask(game)), set())

    def test_each_finding_is_on_the_page(self):
        ids = set()
        for path in pathlib.Path(__file__).parent.glob('*.[ch]*'):
            ids |= set(re.findall(r'(?:\{|\()"([a-z_]+)",\s*(?:Level::|opens)|\*k\w+ = "([a-z_]+)";', path.read_text()))
        page = (pathlib.Path(__file__).parents[4] / 'docs/use/doctor.md').read_text()
        names = {first or second for first, second in ids}
        self.assertGreater(len(names), 30)
        self.assertEqual([name for name in sorted(names) if f'`{name}`' not in page], [])

    def test_a_missing_file(self):
        found = self.ask(self.root / 'none')
        self.assertEqual(self.obstacles(found), {'missing'})
        found = self.ask('no-such-command')
        self.assertIn('not found in PATH', found['missing']['what'])

    def test_a_file_without_the_right(self):
        self.assertEqual(self.obstacles(self.ask(self.path('game', '#!/bin/sh\n'))), {'not_executable'})

    def test_statically_linked(self):
        game = self.compile('game', 'int main() {}\n', '-static')
        self.assertEqual(self.obstacles(self.ask(game)), {'static'})

    def test_statically_linked_at_any_address(self):
        game = self.compile('game', 'int main() {}\n', '-static-pie')
        self.assertEqual(self.obstacles(self.ask(game)), {'static'})

    def test_a_program_that_the_loader_is_given(self):
        game = self.compile('game', GL_CALL, '-lGL')
        loader = loader_of(game)
        self.assertEqual(self.obstacles(self.ask(loader, game)), set())
        self.libgl('own')
        found = self.ask(loader, '--library-path', self.root / 'own', game, '-window')
        self.assertEqual(self.obstacles(found), {'own_libgl'})
        self.assertIn("by the loader's --library-path", found['own_libgl']['what'])
        self.assertEqual(self.obstacles(self.ask(loader, self.compile('alone', 'int main() {}\n', '-static'))),
                         {'static'})
        self.assertEqual(self.obstacles(self.ask(loader, '--list')), set())

    def test_a_loader_that_is_missing(self):
        game = self.compile('game', GL_CALL, '-lGL', '-Wl,--dynamic-linker=/none/ld-linux-x86-64.so.2')
        found = self.ask(game, options=('--run',))
        self.assertEqual(self.obstacles(found), {'missing_interpreter'})
        self.assertIn('its loader /none/ld-linux-x86-64.so.2 is not', found['missing_interpreter']['what'])
        game = self.compile('lsb', GL_CALL, '-lGL', '-Wl,--dynamic-linker=/none/ld-lsb-x86-64.so.3')
        self.assertIn('.so.2 /none/ld-lsb-x86-64.so.3`', self.ask(game)['missing_interpreter']['remedy'])

    def test_an_interpreter_that_is_missing(self):
        for line in ('#!/none/python2', '#!/usr/bin/env no-such-python'):
            found = self.ask(self.script('game.py', line + '\n'))
            self.assertEqual(self.obstacles(found), {'missing_interpreter'})
            self.assertIn(f'names {line.split()[-1].strip("#!")},', found['missing_interpreter']['what'])

    def test_commands_are_whole(self):
        game = self.script('game.py', '#!/usr/bin/env python3\n')
        look = f"`arbiter doctor --run --library {LAYER} -- {game} 'two words' -x=1`"
        self.assertEqual(self.ask(game, 'two words', '-x=1')['interpreter']['remedy'], f'Run it: {look}.')
        done = arbiter('doctor', '--library', LAYER, '--', game, 'two words', '-x=1')
        self.assertEqual(done.stdout.splitlines()[-1],
                         f'Nothing that a look at the files can tell is in the way. To look at a run of it: {look}')

    def test_no_display(self):
        none = {'DISPLAY': '', 'WAYLAND_DISPLAY': ''}
        game = self.compile('game', GL_CALL, '-lGL')
        found = self.ask(game, '-window', **none)
        self.assertEqual((self.obstacles(found), found['no_display']['level']), (set(), 'possible'))
        self.assertIn(f'`xvfb-run -a -s -noreset arbiter run -- {game} -window`', found['no_display']['remedy'])
        for name in none:
            self.assertNotIn('no_display', self.ask(game, **none | {name: ':97'}))
        self.assertNotIn('no_display', self.ask(self.compile('other', 'int main() {}\n'), **none))
        found = self.ask(self.compile('egl', CLIENT, '-lEGL'), options=('--run',), **none)
        if 'host_unknown' not in found:
            self.assertNotIn('no_display', found, 'it drew without one')

    def test_set_user_id(self):
        game = self.compile('game', GL_CALL, '-lGL')
        if os.geteuid() == 0:
            os.chown(game, 65533, 65533)
            game.chmod(0o4755)
            self.assertEqual(self.obstacles(self.ask(game)), {'set_user_id'})
        else:
            self.assertIn('set_user_id', self.ask(shutil.which('su') or '/bin/su'))
        game = self.compile('mine', GL_CALL, '-lGL')
        game.chmod(0o4755)
        self.assertEqual(self.obstacles(self.ask(game)), set(), 'the same user is no obstacle')

    def test_capabilities(self):
        game = self.compile('game', GL_CALL, '-lGL')
        # Version 2 of the attribute with CAP_NET_RAW permitted: capabilities(7).
        try:
            os.setxattr(game, 'security.capability', struct.pack('<5I', 0x02000001, 1 << 13, 0, 0, 0))
        except OSError as error:
            self.skipTest(f'no capabilities of files here: {error}')
        self.assertEqual(self.obstacles(self.ask(game)), {'capabilities'})

    def test_another_width(self):
        game = self.compile('game', GL_CALL, '-lGL')
        of_32_bits(game)
        found = self.ask(game)
        self.assertIn('other_width', self.obstacles(found))
        self.assertIn('32-bit (i386)', found['other_width']['what'])
        for command in ('sudo dpkg --add-architecture i386', './dev package i386',
                        'sudo apt install ./libglx-arbiter0_*_i386.deb ./libarbiter-jit0_*_i386.deb'):
            self.assertIn(command, found['other_width']['remedy'])

    def test_vulkan_alone(self):
        game = self.compile('game', OPENS.format('libvulkan.so.1', 'vkGetInstanceProcAddr'))
        self.assertEqual(self.obstacles(self.ask(game)), {'vulkan_only'})

    def test_vulkan_beside_gl(self):
        game = self.compile('game', OPENS.format('libvulkan.so.1', 'vkGetInstanceProcAddr'), '-Wl,--no-as-needed',
                            '-lGL')
        self.assertEqual(self.obstacles(self.ask(game)), set())

    def test_no_gl(self):
        game = self.compile('game', 'int main() {}\n')
        self.assertEqual(self.obstacles(self.ask(game)), {'no_gl'})

    def test_a_libgl_of_its_own_by_rpath(self):
        self.libgl('own')
        for tags in ('--enable-new-dtags', '--disable-new-dtags'):
            game = self.compile('game', GL_CALL, f'-L{self.root}/own', '-l:libGL.so.1',
                                f'-Wl,{tags},-rpath,$ORIGIN/own')
            found = self.ask(game)
            self.assertEqual(self.obstacles(found), {'own_libgl'})
            self.assertIn('DT_RUNPATH' if 'enable-new' in tags else 'DT_RPATH', found['own_libgl']['what'])
            self.assertIn(f'{self.root}/own/libGL.so.1', found['own_libgl']['what'])

    def test_a_libgl_of_its_own_by_path(self):
        library = self.libgl('gl')
        for name in (library, './gl/libGL.so.1'):
            game = self.compile('game', OPENS.format(name, 'glFinish'))
            self.assertEqual(self.obstacles(self.ask(game)), {'own_libgl'}, name)

    def test_a_libgl_that_lies_beside_it(self):
        self.libgl('lib')
        game = self.compile('game', GL_CALL, '-lGL')
        found = self.ask(game)
        self.assertEqual(found['bundled_libgl']['level'], 'possible')

    def test_glvnds_libgl_by_path_is_reached(self):
        real = subprocess.run([CXX, '-print-file-name=libGL.so.1'], capture_output=True, text=True,
                              check=True).stdout.strip()
        if not os.path.isabs(real):
            self.skipTest('the compiler does not know where libGL is')
        game = self.compile('game', OPENS.format(os.path.realpath(real), 'glFinish'))
        self.assertEqual(self.obstacles(self.ask(game)), set())

    def test_a_gl_that_is_linked_in(self):
        game = self.compile('game', 'extern "C" void glXSwapBuffers() {} int main() { glXSwapBuffers(); }\n',
                            '-rdynamic')
        self.assertEqual(self.obstacles(self.ask(game)), {'own_libgl'})

    def test_flatpak(self):
        export = self.script('org.example.Game',
                             '#!/bin/sh\nexec /usr/bin/flatpak run --branch=stable --command=game '
                             'org.example.Game "$@"\n')
        found = self.ask(export)
        self.assertEqual(self.obstacles(found), {'flatpak'})
        self.assertIn('org.example.Game', found['flatpak']['what'])
        remedy = found['flatpak']['remedy']
        self.assertIn('--command=/usr/lib/extensions/vulkan/Arbiter/bin/arbiter org.example.Game run -- ', remedy)
        self.assertIn(f'--filesystem={os.path.dirname(LAYER)}:ro --env=LD_PRELOAD={LAYER} org.example.Game.', remedy)
        # Flatpak refuses to share files below /usr.
        installed = arbiter('doctor', '--library', '/usr/bin/env', '--json', '--', export)
        remedy, = (each['remedy'] for each in json.loads(installed.stdout)['findings'] if each['id'] == 'flatpak')
        self.assertIn('--command=/usr/lib/extensions/vulkan/Arbiter/bin/arbiter', remedy)
        self.assertNotIn('--filesystem=', remedy)
        flatpak = self.script('flatpak', '#!/bin/sh\n')
        self.assertEqual(self.obstacles(self.ask(flatpak, 'run', 'org.example.Game')), {'flatpak'})

    def test_snap(self):
        self.script('snap', '#!/bin/sh\n')
        (self.root / 'game').symlink_to('snap')
        found = self.ask(self.root / 'game')
        self.assertEqual(self.obstacles(found), {'snap'})
        self.assertIn('Snap runs game ', found['snap']['what'])

    def test_a_script_that_starts_a_program(self):
        (self.root / 'bin').mkdir()
        game = self.compile('bin/game', 'int main() {}\n', '-static')
        for line in ('exec "$(dirname "$0")/bin/game" "$@"', '"${HERE}/bin/game" $*', './bin/game',
                     f'nohup {game} &'):
            launcher = self.script('start.sh', f'#!/bin/sh\n# a launcher\nHERE=$(pwd)\ncd "$HERE"\n{line}\n')
            found = self.ask(launcher)
            self.assertIn(f'starts {game};', found['launcher']['what'], line)
            self.assertEqual(self.obstacles(found), {'static'}, line)

    def test_what_a_script_starts_by_its_variables(self):
        for folder in ('lib', 'other'):
            (self.root / folder).mkdir()
        game = self.compile('lib/game', 'int main() {}\n', '-static')
        shutil.copy(game, self.root / 'other/helper')
        head = f'#!/bin/sh\nNAME=game\nDIR={self.root}/lib\nfind . -name x -exec rm {{}} \\;\n'
        for lines in ('exec $DIR/$NAME "$@"', 'export BIN="${DIR}/${NAME}"\n./other/helper\nexec "$BIN"',
                      'HERE=`dirname "$0"`\n./other/helper\n$HERE/lib/game\nexit 0',
                      'if true; then\n  cd "${0%/*}"; ./lib/game\nfi', 'exec env A=b nice -n 5 lib/game'):
            found = self.ask(self.script('start.sh', f'{head}{lines}\n'))
            self.assertIn(f'starts {game};', found['launcher']['what'], lines)
        found = self.ask(self.script('start.sh', f'{head}./other/helper\nexec $(choose a game) "$@"\n'))
        self.assertEqual(found['launcher']['level'], 'possible', 'a name that was made up')

    def test_a_script_that_takes_the_layer_away(self):
        self.compile('game', GL_CALL, '-lGL')
        for line in ('unset LD_PRELOAD', 'export LD_PRELOAD=/opt/other.so', 'LD_PRELOAD= exec ./game'):
            launcher = self.script('start.sh', f'#!/bin/bash\n{line}\nexec ./game\n')
            self.assertEqual(self.obstacles(self.ask(launcher)), {'preload_cleared'}, line)
        launcher = self.script('start.sh', '#!/bin/sh\nLD_PRELOAD="x.so:$LD_PRELOAD" exec ./game\n')
        self.assertEqual(self.obstacles(self.ask(launcher)), set())

    def test_a_script_of_another_language(self):
        found = self.ask(self.script('game.py', '#!/usr/bin/env python3\n'))
        self.assertEqual((self.obstacles(found), found['interpreter']['level']), (set(), 'possible'))

    def test_no_libglvnd(self):
        game = self.compile('game', GL_CALL, '-lGL')
        system = self.root / 'system'
        folder = system / 'usr/lib' / (os.uname().machine + '-linux-gnu')
        folder.mkdir(parents=True)
        options = ('--root', system)
        for name in ('libc.so.6', 'libm.so.6', 'libstdc++.so.6', 'libgcc_s.so.1'):
            real = subprocess.run([CXX, f'-print-file-name={name}'], capture_output=True, text=True,
                                  check=True).stdout.strip()
            shutil.copy(real, folder / name)
        found = self.ask(game, options=options)
        self.assertEqual(self.obstacles(found), {'missing_interpreter', 'missing_library', 'no_libglvnd'})
        loader = pathlib.Path(str(system) + loader_of(game))
        loader.parent.mkdir(exist_ok=True)
        loader.symlink_to('/lib/elsewhere')  # a link of that system
        self.assertIn('There is no libGL.so.1', found['no_libglvnd']['what'])
        shutil.copy(self.libgl('own'), folder / 'libGL.so.1')
        found = self.ask(game, options=options)
        self.assertEqual(self.obstacles(found), {'no_libglvnd'})
        self.assertIn("a driver's own", found['no_libglvnd']['what'])

    def test_a_library_that_is_missing(self):
        self.compile('own/libgone.so', 'extern "C" void gone() {}\n', '-shared', '-fPIC',
                     '-Wl,-soname,libgone.so')
        game = self.compile('game', 'extern "C" void gone(); int main() { gone(); }\n',
                            f'-L{self.root}/own', '-lgone', '-Wl,--no-as-needed', '-lGL')
        found = self.ask(game)
        self.assertEqual(self.obstacles(found), {'missing_library'})
        self.assertIn('libgone.so', found['missing_library']['what'])

    def test_a_program_for_windows(self):
        game = self.path('game.exe')
        game.write_bytes(b'MZ' + bytes(200))
        game.chmod(0o755)
        self.assertEqual(self.obstacles(self.ask(game)), {'windows_program'})

    def windows_program(self, machine):
        """Makes a file with only a PE header, which names the machine."""
        game = self.path('GAME.EXE')
        game.write_bytes(b'MZ' + bytes(0x3A) + struct.pack('<I', 0x80) + bytes(0x40) + b'PE\0\0' +
                         struct.pack('<H', machine) + bytes(100))
        return game

    def test_programs_under_wine(self):
        wine = self.script('wine', '#!/bin/sh\n')
        found = self.ask(wine, self.windows_program(0x8664), '-fullscreen')
        self.assertEqual((self.obstacles(found), found['wine']['level']), (set(), 'note'))
        self.assertIn('64-bit', found['wine']['what'])
        found = self.ask(wine, self.windows_program(0x14C))
        self.assertEqual((self.obstacles(found), found['wine']['level']), (set(), 'possible'))
        self.assertIn('libglx-arbiter0_*_i386.deb', found['wine']['remedy'])
        for words in (('explorer',), (self.path('none.exe'),), (self.windows_program(0x200),)):
            found = self.ask(wine, *words)
            self.assertIn('width its command line does not tell', found['wine']['what'])

    def test_a_program_on_a_drive_of_wine(self):
        self.windows_program(0x8664)
        drives = self.path('dosdevices')
        drives.mkdir()
        (drives / 'c:').symlink_to('..')
        found = self.ask(self.script('wine', '#!/bin/sh\n'), 'C:\\game.exe', WINEPREFIX=str(drives.parent))
        self.assertIn('64-bit', found['wine']['what'])

    def test_tools_of_wine_are_not_wine(self):
        self.assertNotIn('wine', self.ask(self.script('winetricks', '#!/bin/sh\nexec true\n')))

    def test_managers_of_games(self):
        steam = self.script('steam', '#!/bin/sh\nexec steam.sh\n')
        found = self.ask(steam)
        self.assertEqual((self.obstacles(found), found['game_launcher']['level']), (set(), 'possible'))
        self.assertIn('`arbiter run -- %command%`.', found['game_launcher']['remedy'])

    def test_files_that_are_no_programs(self):
        for content in (b'', b'\x7fELF', b'\x7fELF\x02\x01\x01' + bytes(40), os.urandom(5000)):
            game = self.path('game')
            game.write_bytes(content)
            game.chmod(0o755)
            self.assertEqual(self.obstacles(self.ask(game)), {'unknown_format'})

    def test_an_old_driver(self):
        game = self.compile('game', CLIENT, '-lEGL')
        found = self.ask(game, MESA_GL_VERSION_OVERRIDE='1.5')
        if 'host_unknown' in found:
            self.skipTest('no context without a window')
        self.assertEqual(self.obstacles(found), {'old_driver'})
        self.assertIn('1.5', found['old_driver']['what'])

    def test_a_driver_that_hangs_and_blocks_signals(self):
        """The doctor gives up after 20 s."""
        driver = self.compile('hangs.so', '#include <csignal>\n#include <unistd.h>\n'
                              'extern "C" int __egl_Main() { sigset_t all; sigfillset(&all);\n'
                              'sigprocmask(SIG_BLOCK, &all, nullptr); for (;;) sleep(1000); }\n', '-shared', '-fPIC')
        vendor = self.path('hangs.json', json.dumps({'file_format_version': '1.0.0',
                                                     'ICD': {'library_path': str(driver)}}))
        done = arbiter('doctor', '--library', LAYER, '--', self.compile('gl', GL_CALL, '-lGL'),
                       EGL_PLATFORM='surfaceless', __EGL_VENDOR_LIBRARY_FILENAMES=str(vendor))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('its version is not known here', done.stdout)

    def test_a_run_that_is_reached(self):
        game = self.compile('game', CLIENT, '-lEGL')
        found = self.ask(game, options=('--run',))
        if 'host_unknown' in found:
            self.skipTest('no context without a window')
        self.assertEqual(self.obstacles(found), set())
        self.assertIn('game made 1 context through the layer, 1 of them', found['reached']['what'])

    def test_a_run_of_the_core_profile(self):
        game = self.compile('game', CLIENT, '-lEGL')
        found = self.ask(game, 'core', options=('--run',))
        if 'host_unknown' in found:
            self.skipTest('no context without a window')
        self.assertEqual(self.obstacles(found), {'core_profile'})

    def test_a_run_that_is_refused_a_program(self):
        """Programs that only the profile refuses are reported, with a way to load them."""
        game = self.compile('game', LONG, '-lEGL', '-lGL')
        found = self.ask(game, options=('--run',))
        if 'host_unknown' in found:
            self.skipTest('no context without a window')
        self.assertEqual(self.obstacles(found), set())
        for part in ('The profile r300 refuses 1 program ', 'line 66: more than 64 ALU instructions'):
            self.assertIn(part, found['refused']['what'])
        self.assertIn('--limits report or --profile host', found['refused']['remedy'])
        self.assertIn(f'`arbiter run --limits report -- {game}`', found['refused']['remedy'])
        self.assertNotIn('refused', self.ask(game, options=('--run',), ARBITER_LIMITS='report'))

    def test_a_refused_program_is_named_once_and_in_the_statistics(self):
        game, stats = self.compile('game', LONG, '-lEGL', '-lGL'), self.root / 'stats.json'
        for limits, log in (('enforce', 'warn'), ('enforce', 'error'), ('report', 'warn')):
            done = arbiter('run', '--library', LAYER, '--stats', stats, '--limits', limits, '--log', log, '--', game,
                           EGL_PLATFORM='surfaceless')
            if done.returncode == 1:
                self.skipTest('no context without a window')
            said = [line for line in done.stderr.splitlines() if 'refused by the profile' in line]
            self.assertEqual(len(said), int((limits, log) == ('enforce', 'warn')), done.stderr)
            programs = json.loads(stats.read_text())['programs']
            # The header ends after its version, even without a separator.
            self.assertEqual({program['language'] for program in programs}, {'ARBfp1.0'})
            refused = [program['error']['refused_by_profile'] for program in programs if program['error']]
            self.assertEqual(len(refused), 0 if limits == 'report' else 2)
            for each in refused:
                self.assertIn('64 ALU instructions', each['reason'])
                self.assertEqual(each['remedy'], '--limits report or --profile host')

    def test_indirect_contexts(self):
        """The X server would draw in spite of the layer; programs without GLX are not affected."""
        game = self.compile('game', GLX_CALL, '-lGL')
        self.assertEqual(self.obstacles(self.ask(game, LIBGL_ALWAYS_INDIRECT='1')), {'indirect'})
        for value in ('', '0', 'false'):
            self.assertNotIn('indirect', self.ask(game, LIBGL_ALWAYS_INDIRECT=value))
        found = self.ask(self.compile('other', GL_CALL, '-lGL'), LIBGL_ALWAYS_INDIRECT='1')
        self.assertEqual((self.obstacles(found), found['indirect']['level']), (set(), 'possible'))

    def test_a_run_of_indirect_contexts(self):
        """Runs on the test's own X server."""
        if not shutil.which('Xvfb'):
            self.skipTest('not installed: Xvfb')
        game = self.compile('game', GLX_CLIENT, '-lGL', '-lX11')
        with XServer(options=('+iglx',)) as display:
            # Debian 13's server aborts.
            bare = subprocess.run([game], env=plain(DISPLAY=display, LIBGL_ALWAYS_INDIRECT='1'), timeout=60)
            if bare.returncode != 0:
                self.skipTest('the bare host does not stand it')
            found = self.ask(game, options=('--run',), DISPLAY=display, LIBGL_ALWAYS_INDIRECT='1')
            self.assertEqual(self.obstacles(found), {'indirect'}, found)
            self.assertIn('the X server draws', found['indirect']['what'])
            self.assertNotIn('indirect', self.ask(game, options=('--run',), DISPLAY=display))

    def test_a_run_names_what_a_launcher_starts(self):
        """The launcher's file does not name the program, but the run does."""
        self.compile('real-game', CLIENT, '-lEGL')
        launcher = self.compile('launcher', '#include <cstdlib>\nint main() { const char part[] = "/real-game";'
                                f' char line[999] = "{self.root}"; char *to = line; while (*to) ++to;'
                                ' for (char c : part) *to++ = c; return std::system(line); }\n')
        found = self.ask(launcher)
        self.assertIn('no_gl', found)
        found = self.ask(launcher, options=('--run',))
        if 'host_unknown' in found:
            self.skipTest('no context without a window')
        self.assertEqual(self.obstacles(found), set())
        self.assertIn('real-game made 1 context', found['reached']['what'])

    def test_a_run_without_gl_and_one_that_goes_on(self):
        found = self.ask('sleep', '60', options=('--run', '--for', '0.5'))
        self.assertIn('was ended when its time was over', found['no_context']['what'])
        self.assertEqual(self.obstacles(found), {'no_gl', 'no_context'})

    def test_a_run_without_a_display_says_so_once(self):
        game = self.compile('game', GL_CALL, '-lGL')
        for display, words in (({'DISPLAY': '', 'WAYLAND_DISPLAY': ''}, 'Neither DISPLAY nor WAYLAND_DISPLAY is set'),
                               ({'DISPLAY': ':97'}, 'Give it longer')):
            found = self.ask(game, options=('--run',), **display)
            self.assertIn(words, found['no_context']['remedy'])
            self.assertNotIn('no_display', found)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]] + sys.argv[4:], verbosity=2)
