"""Writes the entry points that exist for the rasterizer (software.toml)."""
import re
import sys

from gl_commands import HEADING
from thunks import draws_held

SLOTS = {"Vertex": "kPosition", "Color": "kColor", "SecondaryColor": "kSecondary",
         "Normal": "kNormal", "TexCoord": "kTexCoord0", "FogCoord": "kFogCoord"}
NORMALIZED = ("Color", "SecondaryColor", "Normal")
ATTRIBUTE = re.compile(r"(Vertex|Color|SecondaryColor|Normal|TexCoord|MultiTexCoord|FogCoord|"
                       r"VertexAttrib)([1234]?)(N?)(b|s|i|f|d|ub|us|ui)(v?)")


# The command is legal between Begin and End (OpenGL 2.1, 2.6.3), but is no vertex attribute.
SPLITS = re.compile(r"Material[fi]v?")
# Materials that a display list may record: the condition, and the values as an array.
LISTED_MATERIALS = {"Materialf": ("pname == GL_SHININESS && ", "&param"), "Materialfv": ("", "params")}


def leads(table):
    return sorted(lead for lead, way in table.software.items() if way != "harmless")


def given(command):
    """Returns which attribute a [record] command sets, the parameter that selects it, its four components as C++, and
    how many of them it has."""
    match = ATTRIBUTE.fullmatch(command.name)
    if not match:
        sys.exit(f"software.toml: [record] does not know {command.name}")
    what, count, n, kind, v = match.groups()
    count = int(count or 1)
    names = [name for _, name, _ in command.params]
    lead = names.pop(0) if what in ("MultiTexCoord", "VertexAttrib") else None
    values = [f"{names[0]}[{i}]" for i in range(count)] if v else names
    if len(values) != count:
        sys.exit(f"software.toml: [record] {command.name} has other parameters than its name says")
    # Table 2.9 of OpenGL 2.1. The names of `4Nub` and its kin say so.
    normalized = kind not in "fd" and (what in NORMALIZED or n)
    values = [f"{'normalized' if normalized else 'GLfloat'}({value})" for value in values]
    return what, lead, values + ["0.0f", "0.0f", "1.0f"][count - 1:], count


def recorded(command):
    """Returns C++ statements that add the command to the deferred primitive, and the condition under which they can.
    Otherwise the host gets the command, after the primitive."""
    if command.name in ("EdgeFlag", "EdgeFlagv"):
        flag = ("*" if command.name[-1] == "v" else "") + command.params[0][1]
        return "true", f"hot->recorder->set(kEdgeFlag, {flag} ? 1.0f : 0.0f, 0.0f, 0.0f, 1.0f)"
    what, lead, values, count = given(command)
    values = ", ".join(values + [str(count)])
    if what == "Vertex":
        return "true", f"hot->recorder->vertex({values})"
    if what == "MultiTexCoord":
        return (f"{lead} - GL_TEXTURE0 < 8u",
                f"hot->recorder->set(kTexCoord0 + int({lead} - GL_TEXTURE0), {values})")
    if what == "VertexAttrib":
        # Outside of Begin and End, attribute 0 is an ordinary value and makes no vertex.
        return f"{lead} < 16u && ({lead} != 0 || !isHeld(*hot))", f"generic(*hot, {lead}, {values})"
    return "true", f"hot->recorder->set({SLOTS[what]}, {values})"


def aliased(command):
    """Returns the lines of an [aliased] command that ask whether generic attributes are the conventional ones."""
    if re.fullmatch(r"(Enable|Disable)VertexAttribArray", command.name):
        enabled = "true" if command.name.startswith("Enable") else "false"
        return ("  if (hot->attributesAlias) [[unlikely]]\n"
                f"    arbiter::state::noteGenericArray(here(), index, {enabled});\n")
    if command.name.startswith("GetVertexAttrib"):
        return ("  if (hot->attributesAlias && pname == GL_CURRENT_VERTEX_ATTRIB && "
                "arbiter::state::isAliasedRegister(index) &&\n"
                "      arbiter::state::getAliasedAttribute(*hot, *answeringHost(*hot), index, params))\n    return;\n")
    what, lead, values, count = given(command)
    if what != "VertexAttrib":
        sys.exit(f"software.toml: [aliased] does not know {command.name}")
    return (f"  if (hot->attributesAlias && arbiter::state::isAliasedRegister({lead})) [[unlikely]] {{\n"
            "    hot->dirty |= dirty::kCurrent;\n"
            f"    return arbiter::state::setAliasedAttribute(*hot, {lead}, {{{', '.join(values)}}}, {count});\n  }}\n")


def call(table, command, host="hot->host"):
    """Returns the call of `host`'s function, and the separate function for its first call."""
    give = "" if command.result == "void" else "return "
    if command.name in table.members:
        return "", f"  {give}{host}->{command.name}({command.arguments()});\n"
    symbol = "gl" + command.name
    pointer = f"{command.result} (*)({command.types()})"
    index = table.lazy.index(command.name)
    first = (f"[[gnu::cold, gnu::noinline]] static {command.result} first_{symbol}"
             f"({command.declare()}) {{\n  ContextHot *const hot = t_current;\n"
             f"  const host::LazyCall call(*{host}, {index});\n"
             f"  if (call.function())\n    {give}reinterpret_cast<{pointer}>(call.function())"
             f"({command.arguments()});\n"
             + ("" if command.result == "void" else "  return {};\n") + "}\n")
    body = (f"  if (void *const found = host::lazyFunction(*{host}, {index})) "
            f"[[likely]]\n    return reinterpret_cast<{pointer}>(found)({command.arguments()});\n"
            f"  {give}first_{symbol}({command.arguments()});\n")
    return first, body


def thunk(table, command, way):
    """Returns (separate functions, body) of the entry point."""
    first, body = call(table, command, *(["answeringHost(*hot)"] if way == "current" else []))
    held, look = draws_held(table, command, "gl" + command.name)
    lines = "  ContextHot *const hot = t_current;\n"
    if way == "record":
        condition, statement = recorded(command)
        if condition == "true":
            held = look = ""  # a held primitive implies a recorder
        guard = "" if condition == "true" else f" && {condition}"
        lines += f"  if (hot->recorder{guard})\n    return {statement};\n"
    lines += look
    if command.name in table.aliased:
        lines += aliased(command)
    if command.name in LISTED_MATERIALS:
        condition, values = LISTED_MATERIALS[command.name]
        lines += (f"  if (hot->listMode != 0 && {condition}arbiter::state::recordMaterial(here(), face, pname, "
                  f"{values}))\n    return;\n")
        lines += (f"  if (hot->recorder && {condition}state::recordsMaterial(*hot, face, pname, {values})) "
                  f"[[unlikely]]\n    return;\n")
    if SPLITS.fullmatch(command.name):
        lines += "  const state::PrimitiveSplit split(*hot);\n"
    if command.name == "ColorMaterial":
        lines += "  if (hot->softwareListens) [[unlikely]]\n    state::hostTakesColor(here());\n"
    bits = "dirty::kAll" if way == "unknown" else table.bits_of(command.name)
    if bits:
        lines += f"  hot->dirty |= {bits};\n"
    before = {"reads": ("hot->softwareListens", "hostReads"), "waits": ("hot->hostIsBehind", "hostWaits"),
              "draws": ("hot->softwareListens", "hostWrites"),
              "unknown": ("hot->softwareListens", "hostDoesUnknown")}.get(way)
    if before:
        lines += (f"  if ({before[0]}) [[unlikely]]\n"
                  f"    state::{before[1]}(here(), \"gl{command.name}\");\n")
    return first, held, lines + body


def source(table):
    out = [HEADING, """#include "dispatch/entry_points.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "dispatch/function_set.h"
#include "host/lazy_functions.h"
#include "host/host_table.h"
#include "state/lists/state_commands.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/immediate/refused.h"
#include "state/raster_draw/immediate/primitive_materials.h"
#include "state/raster_draw/immediate/split.h"
#include "state/raster_draw/raster_context.h"
#include "state/mirror/dirty_bits.h"

#define ARBITER_ENTRY extern "C" __attribute__((visibility("default")))

namespace host = arbiter::host;
namespace state = arbiter::state;
namespace dirty = arbiter::state::dirty;
using namespace arbiter::state;

namespace {
[[gnu::always_inline]] inline RasterContext &here() { return arbiter::state::rasterStep(*t_current); }
} // namespace

"""]
    rows = []
    for name in leads(table):
        command, way = table.commands[name], table.software[name]
        root, *aliases = table.entry_names(name)
        first, held, body = thunk(table, command, way)
        signature = f"{command.result} arbiter_{root}({command.declare()})"
        out.append(f'// {way}\n{first}ARBITER_ENTRY {signature} __asm__("{root}");\n{held}'
                   f"{signature} {{\n{body}}}\n")
        for alias in aliases:
            out.append(f"ARBITER_ENTRY {command.result} arbiter_{alias}({command.declare()}) "
                       f'__asm__("{alias}") __attribute__((alias("{root}")));\n')
        rows += [(entry, root, "true" if name in table.aliased else "false") for entry in [root] + aliases]
    out.append("\nnamespace arbiter::dispatch {\n\nnamespace {\n\nstruct Row {\n  const char *name;\n"
               "  void *function;\n  bool aliased;\n};\n\n/// Sorted by name.\nconst Row kRows[] = {\n")
    out += [f'  {{"{entry}", reinterpret_cast<void *>(&arbiter_{root}), {of_aliases}}},\n'
            for entry, root, of_aliases in sorted(rows)]
    out.append("""};

} // namespace

EntryPoint findForSoftware(const char *name) {
  const auto *const row =
      std::lower_bound(std::begin(kRows), std::end(kRows), name,
                       [](const Row &r, const char *n) { return std::strcmp(r.name, n) < 0; });
  if (row == std::end(kRows) || std::strcmp(row->name, name) != 0)
    return {};
  return {row->function, false, true, row->aliased};
}

bool isForSoftware(const void *function) {
  static const FunctionSet s_functions(kRows);
  return s_functions.contains(function);
}

} // namespace arbiter::dispatch
""")
    return "".join(out)
