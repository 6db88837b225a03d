"""The cases that are not kinds of clients; each is a function of the Setting."""
import json
import os
import re
import shutil
import stat
import subprocess

from plain_environment import PYTHON
from setting import R300_INDIRECTIONS, Skip, execute, need, need_statistics, need_success, width, write_icd


def run_early(setting):
    """Tests a library's constructor that draws before the layer's. It draws through the layer if that was selected from
    outside (as by arbiter run), and by the host if it is only preloaded; the pixels are right in both cases."""
    client = setting.clients / "client_early"
    outcome = execute([client], setting.environment(True))
    need_success(outcome, "preloaded only")
    need(len(outcome.reports()) == 1, "preloaded only: no report")
    selected = {"__EGL_VENDOR_LIBRARY_FILENAMES": str(setting.icd), "__GLX_VENDOR_LIBRARY_NAME": "arbiter"}
    outcome = execute([client], setting.environment(True, selected))
    need_success(outcome, "selected")
    need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, "selected: not through the layer")
    need_statistics(setting.stats)


def run_chosen(setting):
    """Tests that a vendor in __GLX_VENDOR_LIBRARY_NAME becomes the preloaded layer's host, although libGLX would
    start it in its own constructor. A missing vendor is skipped."""
    for vendor in ("mesa", "no_such_vendor"):
        setting.stats.unlink(missing_ok=True)
        chosen = {"__GLX_VENDOR_LIBRARY_NAME": vendor}
        outcome = execute([setting.clients / "client_libgl"], setting.environment(True, chosen))
        need_success(outcome, vendor)
        need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, f"{vendor}: not through the layer")
        need_statistics(setting.stats)
    script = "import os; print(*map(os.environ.get, ('__GLX_VENDOR_LIBRARY_NAME', 'ARBITER_SAVED_GLX_VENDOR')))"
    outcome = execute([PYTHON, "-c", script], setting.environment(True, {"__GLX_VENDOR_LIBRARY_NAME": "mesa"}))
    need(outcome.out.split() == ["arbiter", "mesa"], "children find " + outcome.out)


def run_close(setting):
    """Tests that closing a display destroys its contexts."""
    for way in ("glx", "egl"):
        setting.stats.unlink(missing_ok=True)
        command = [setting.clients / "client_close", way]
        need_success(execute(command, setting.environment(False)), f"bare host, {way}")
        need_success(execute(command, setting.environment(True)), way)
        contexts = need_statistics(setting.stats, 2)["contexts"]
        need(len(contexts) == 4, f"{way}: {len(contexts)} contexts, not 4")
        alive = [c["id"] for c in contexts if not c["destroyed"]]
        need(not alive, f"{way}: contexts {alive} outlived their display")


def run_array_memory(setting):
    """Tests that glXAllocateMemoryNV returns memory under the layer; a bare host may have the function and return
    none."""
    outcome = execute([setting.clients / "client_array_memory"], setting.environment(True))
    need(outcome.out.strip() == "allocated", f"layer: {outcome.out}")


def run_cycles(setting):
    """Tests 1,000 contexts with programs of both targets. The layer's memory may grow only by the host's own growth,
    plus about a page for each cycle. The back end is fixed, as auto may change late and load the other one's
    compiler."""
    cycles, slack = 1000, 2048  # kilobytes
    grown = {}
    for where in ("bare host", "host", "swrast"):
        layer = where != "bare host"
        # With one arena it does not depend on the load how many the host's threads fill.
        outcome = execute([setting.clients / "client_cycles", cycles],
                          setting.environment(layer, {"MALLOC_ARENA_MAX": "1"} |
                                              ({"ARBITER_BACKEND": where} if layer else {})))
        need_success(outcome, where)
        grown[where] = outcome.reports()[0]["kilobytes"]
    for backend in ("host", "swrast"):
        need(grown[backend] <= max(grown["bare host"], 0) + slack, f"grown by kilobytes: {grown}")
    return f"grown by kilobytes: {grown}"


def run_spawn(setting):
    """Tests that each of the two processes writes statistics of its own."""
    outcome = execute([setting.clients / "client_spawn"],
                      setting.environment(True, {"ARBITER_STATS": str(setting.scratch / "s.%p.json")}))
    need_success(outcome, "layer")
    need([r["indirections"] for r in outcome.reports()] == [R300_INDIRECTIONS] * 2, outcome.out)
    files = list(setting.scratch.glob("s.*.json"))
    need(len(files) == 2, f"{len(files)} statistics files, not 2")
    for file in files:
        need_statistics(file)


def run_vendor_only(setting):
    """Tests the layer as a vendor without LD_PRELOAD: libglvnd finds it by itself."""
    glx = setting.environment(False, {"__GLX_VENDOR_LIBRARY_NAME": "arbiter",
                                      "LD_LIBRARY_PATH": str(setting.layer.parent),
                                      "ARBITER_STATS": str(setting.stats)})
    egl = setting.environment(False, {"__EGL_VENDOR_LIBRARY_FILENAMES": str(setting.icd),
                                      "ARBITER_STATS": str(setting.stats)})
    for client, env in (("client_glx_dynamic", glx), ("client_egl_dynamic", egl)):
        setting.stats.unlink(missing_ok=True)
        outcome = execute([setting.clients / client, "libGL"], env)
        need_success(outcome, client)
        need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, f"{client}: by the host")
        need_statistics(setting.stats)


def run_arbiter(setting):
    """Tests that `arbiter run` sets everything."""
    tool = setting.build / "src/apps/tools/arbiter"
    if not tool.exists():
        raise Skip("not built: arbiter")
    for command in (["client_libgl"], ["client_egl_direct"], ["client_osmesa_dynamic", "dlsym"],
                    ["client_early"]):
        setting.stats.unlink(missing_ok=True)
        outcome = execute([tool, "run", "--stats", setting.stats, "--", setting.clients / command[0],
                           *command[1:]], setting.environment(False))
        need_success(outcome, command[0])
        need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, f"{command[0]}: by the host")
        need_statistics(setting.stats)


def run_selected_host(setting):
    """Tests that the environment's previous selection becomes the host, for a preload and for arbiter run."""
    icd = write_icd(setting.scratch / "counting.json",
                    setting.clients / "libclient_counting_vendor.so")
    counts = setting.scratch / "counts.json"
    client = [setting.clients / "client_count", "10", "surfaceless"]
    selected = {"__EGL_VENDOR_LIBRARY_FILENAMES": str(icd), "COUNTING_HOST": "libEGL_mesa.so.0",
                "COUNTING_FILE": str(counts), "ARBITER_STATS": str(setting.stats)}
    tool = [setting.build / "src/apps/tools/arbiter", "run", "--"]
    for command, layer in ((client, True), (tool + client, False), (tool + tool + client, False)):
        counts.unlink(missing_ok=True)
        setting.stats.unlink(missing_ok=True)
        need_success(execute(command, setting.environment(layer, selected)), str(command[0]))
        need(counts.exists() and json.loads(counts.read_text())["clears"] == 10,
             f"{command[0]}: the selected vendor is not the host")
        need(setting.stats.exists(), f"{command[0]}: the layer is not in front")


def run_secure(setting):
    """Tests that the layer is inactive in a set-user-id program, however it is requested."""
    if "LIBGL_DRIVERS_PATH" in os.environ:
        raise Skip("a set-user-ID program takes drivers of the system alone")
    if os.geteuid() != 0:
        raise Skip("needs root: a set-user-ID program is made")
    mount = subprocess.run(["findmnt", "-nro", "OPTIONS", "-T", str(setting.scratch)], text=True,
                           capture_output=True, check=False).stdout
    if "nosuid" in mount:
        raise Skip("the temporary folder is mounted nosuid")
    program = setting.scratch / "secure"
    shutil.copy(setting.clients / "client_egl_direct", program)
    program.chmod(0o755 | stat.S_ISUID)
    os.chmod(setting.scratch, 0o755)
    extra = {"__EGL_VENDOR_LIBRARY_FILENAMES": str(setting.icd), "__GLX_VENDOR_LIBRARY_NAME": "arbiter"}
    outcome = execute([program], setting.environment(True, extra), user=65534)
    need_success(outcome, "set-user-id")
    need(outcome.reports()[0]["indirections"] != R300_INDIRECTIONS, "the layer is in a secure process")
    need(not setting.stats.exists(), "a secure process wrote statistics")


def run_overlay(setting):
    """Tests another preloaded library that wraps GLX, before and after the layer."""
    overlay = setting.clients / "libclient_overlay.so"
    for order in ((setting.layer, overlay), (overlay, setting.layer)):
        setting.stats.unlink(missing_ok=True)
        env = setting.environment(True, {"LD_PRELOAD": ":".join(map(str, order))})
        outcome = execute([setting.clients / "client_libgl"], env)
        need_success(outcome, order[0].name + " first")
        need("overlay: 1 swaps" in outcome.err, "the overlay saw " + outcome.err.strip()[-100:])
        need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, "by the host")
        need_statistics(setting.stats)


def run_apitrace(setting):
    """Tests that apitrace records the application's calls, and that its trace replays with the same picture."""
    tool = shutil.which("apitrace")
    if not tool or width(tool) != width(setting.layer):
        raise Skip("of another width: apitrace" if tool else "not installed: apitrace")
    trace = setting.scratch / "client.trace"
    for program in ("client_libgl", "client_glx_dynamic"):
        trace.unlink(missing_ok=True)
        setting.stats.unlink(missing_ok=True)
        outcome = execute(["apitrace", "trace", "--api", "gl", "-o", trace,
                           setting.clients / program, "libGL"], setting.environment(True))
        need_success(outcome, program)
        need(outcome.reports()[0]["indirections"] == R300_INDIRECTIONS, f"{program}: by the host")
        dump = execute(["apitrace", "dump", trace], setting.environment(False))
        need(dump.out.count("glProgramStringARB(") == 1, f"{program}: the trace has "
             f"{dump.out.count('glProgramStringARB(')} program strings")
        need(dump.out.count("glBegin(") == 1, f"{program}: calls are missing from the trace")


def run_count(setting):
    """Tests that each glClear and glDrawArrays of the application reaches the host once: a host that patches
    libglvnd's stubs must not bypass the layer."""
    calls = 1000
    counts = setting.scratch / "counts.json"
    icd = write_icd(setting.scratch / "counting.json",
                    setting.clients / "libclient_counting_vendor.so")
    platform = "surfaceless" if setting.display else "device"
    # The counting vendor is selected before the layer, which makes it the layer's host.
    extra = {"__EGL_VENDOR_LIBRARY_FILENAMES": str(icd),
             "COUNTING_HOST": setting.egl_vendor or "libEGL_mesa.so.0",
             "COUNTING_FILE": str(counts)}
    outcome = execute([setting.clients / "client_count", str(calls), platform],
                      setting.environment(True, extra))
    need_success(outcome, "layer")
    counted = json.loads(counts.read_text()) if counts.exists() else None
    need(counted == {"clears": calls, "draws": calls}, f"the host counted {counted}")
    stats = json.loads(setting.stats.read_text())
    need(stats["draws"]["host_untouched"] == calls, f"the layer counted {stats['draws']}")


def run_vendor_gpa(setting):
    """Compares GetProcAddress answers with the host's own, function by function."""
    for backend in ("auto", "host"):
        environment = dict(setting.environment(False), ARBITER_BACKEND=backend)
        outcome = execute([setting.clients / "client_vendor_gpa", setting.layer,
                           "libEGL_mesa.so.0"], environment)
        need_success(outcome, f"vendor_gpa, {backend}")


def run_exports(setting):
    """Tests that the library exports exactly what was generated from the allow-list. It depends only on libc and on
    the layer's library that runs first, which exports one name."""
    def exports(library):
        listing = subprocess.run(["nm", "-D", "--defined-only", str(library)], text=True,
                                 capture_output=True, check=True).stdout
        return {line.split()[-1] for line in listing.splitlines()}

    def dynamic(library):
        return subprocess.run(["readelf", "-d", str(library)], text=True, capture_output=True,
                              check=True).stdout

    wanted = set((setting.build / "src/dispatch/exports.txt").read_text().split())
    exported = exports(setting.layer)
    need(exported == wanted, f"missing {sorted(wanted - exported)[:5]}, "
         f"surplus {sorted(exported - wanted)[:5]}")
    first = setting.layer.parent / "libarbiter_first.so"
    need(exports(first) == {"arbiterReplacedVendor"}, f"{first.name} exports {exports(first)}")
    need("INITFIRST" in dynamic(first), f"{first.name} does not run first")
    calls = re.findall(r"^ +U (\S+)", subprocess.run(["nm", "-D", str(first)], text=True, check=True,
                                                     capture_output=True).stdout, re.M)
    need(not calls, f"{first.name} calls {calls} before any other library is ready")
    libraries = set(re.findall(r"NEEDED.*\[(.*)\]", dynamic(setting.layer) + dynamic(first)))
    allowed = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "ld-linux-x86-64.so.2",
               "ld-linux.so.2", first.name}
    need(libraries <= allowed, f"brings {sorted(libraries - allowed)} into applications")


def run_disassembly(setting):
    """Tests the machine code of a passed-on call: its fast path has no thread-local access by function call, no lock
    and no
    call. 32-bit x86 finds its own address by a call, and its arguments are moved on the stack."""
    is_32 = width(setting.layer) == 32
    thread, most = ("%gs:", 30) if is_32 else ("%fs:", 10)
    code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", str(setting.layer)], text=True,
                          capture_output=True, check=True).stdout
    callers, function = set(), ""
    for line in code.splitlines():
        if line.endswith(">:"):
            function = line.split("<")[1][:-2]
        elif "call" in line and "__tls_get_addr" in line:
            callers.add(function)
    # The C++ runtime's own access, for exceptions, is linked in; no GL call reaches it.
    unexpected = callers - {"__cxa_get_globals", "__cxa_get_globals_fast"}
    need(not unexpected, f"__tls_get_addr is called by {sorted(unexpected)}")
    for name in ("glDrawArrays", "glDrawElements", "glUniform4fv", "glBegin", "glEnable"):
        body = re.search(rf"<{name}>:\n(.*?)\n\n", code, re.S)
        need(body, f"{name} is not in the disassembly")
        text = body.group(1)
        need(thread in text, f"{name} does not read the thread's context by initial-exec")
        need("lock " not in text and "pthread_mutex" not in text, f"{name} locks")
        if name.startswith(("glDraw", "glUniform")):
            straight = text.split("jmp ", 1)[0].splitlines()
            more = [line for line in straight
                    if ("call" in line and "get_pc_thunk" not in line) or ("push" in line and not is_32)]
            need(not more, f"{name} does more than pass on: {more}")
            need(len(straight) <= most, f"{name} takes {len(straight)} instructions")
