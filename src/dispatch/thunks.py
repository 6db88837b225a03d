"""Writes the entry points and the table of their names."""
import fnmatch
import sys

from gl_commands import HEADING


# The function that hides the layer's own names, by the class of a parameter.
GUARDS = {"program": "guardName", "shader": "guardName", "handle": "guardName", "program pipeline": "guardPipeline"}


# The number of values of a parameter.
VALUES = 4


def handlers_header(table):
    out = [HEADING, "#pragma once\n", "#include <GL/gl.h>\n#include <GL/glext.h>\n\n",
           '#include "host/parameter_values.h"\n\n',
           "namespace arbiter::state {\nclass Context;\n}\n\n",
           "/// What the state tracker gives the entry points. The generated thunks call these with "
           "the\n/// thread's context; a missing one fails the link.\n",
           "namespace arbiter::state::handlers {\n\n",
           "/// Makes the application's own program the host's current one again.\n"
           "void restoreApplicationProgram(Context &context);\n\n"
           "/// `name` if the application may know it; for a program, shader or pipeline of the layer's "
           "a name that\n/// the host does not have, so that the host raises the error it should.\n"
           "GLuint guardName(Context &context, GLuint name);\n"
           "GLuint guardPipeline(Context &context, GLuint name);\n\n"]
    for name in sorted(n for n, a in table.action.items() if a in ("own", "handled") and n not in table.converted):
        command = table.commands[name]
        out.append(f"{command.result} {name}({command.declare(['Context &context'])});\n")
    out.append("\n/// The forms whose values lie in the application's memory.\n")
    for floats in sorted(set(table.converted.values())):
        same = [f"{kind} {name}" for kind, name, _ in table.commands[floats].params[:-VALUES]]
        out.append(f"void {floats}(Context &context, {', '.join(same)}, host::ParameterValues values);\n")
    out.append("\n} // namespace arbiter::state::handlers\n")
    return "".join(out)


def handler_call(table, command):
    """Returns the call of the command's handler, or of the handler of floats with the arguments converted. A pointer
    is passed on unread."""
    context = "static_cast<Context &>(*t)"
    if command.name not in table.converted:
        return f"handlers::{command.name}({command.arguments([context])})"
    floats = table.commands[table.converted[command.name]]
    leading = len(floats.params) - VALUES
    same = [name for _, name, _ in command.params[:leading]]
    values = [name for _, name, _ in command.params[leading:]]
    if same != [name for _, name, _ in floats.params[:leading]] or len(values) not in (1, VALUES):
        sys.exit(f"entry_points.toml: [own.converted] {command.name} has other values than {floats.name}")
    if len(values) == 1:
        arguments = [context, *same, f"arbiter::host::ParameterValues({values[0]})"]
    else:
        arguments = [context, *same, *(f"GLfloat({value})" for value in values)]
    return f"handlers::{floats.name}({', '.join(arguments)})"


def guarded(command, statements):
    """Returns the statements, guarded against running out of memory.

    No exception of the layer reaches the application. An application's own exception, thrown in a callback of the
    host, passes. Costs nothing while none is thrown, except that a tail call becomes a call."""
    give = "return;" if command.result == "void" else "return {};"
    return (f"  try {{\n{statements}"
            f'  }} catch (const std::exception &error) {{\n    arbiter::passOn(error);\n'
            f'    arbiter::state::outOfMemory(here(), "gl{command.name}");\n'
            f"    {give}\n  }}\n")


def draws_itself(table, name):
    """Returns the line with which a draw's slow path tries the rasterizer before the host is prepared; "" for none."""
    if name not in table.draw_commands:
        return ""
    return f"  if (state::mayDraw(here()) && state::{table.draw_commands[name]})\n    return;\n"


def aliases_itself(table, name):
    """Returns the line that keeps a draw with aliasing arrays from the host, "" if there is none."""
    draw = table.draw_commands.get(name, "")
    if not draw.startswith(("tryDraw", "tryMultiDraw")):
        return ""
    return (f"  if (here().attributesAlias && state::{draw.replace('try', 'aliased', 1)})\n"
            "    return;\n")


# ARB_imaging or the rasterizer may execute these commands (state/pixel_commands/pixel_commands.h).
IMAGED = ("CopyPixels", "DrawPixels")


# Hosts may keep this command's pixels for later (state/host_draw/kept_letters.h).
LETTERS = "Bitmap"


def imaged(command):
    """Returns the line with which such a command first tries imaging and the rasterizer."""
    return (f"  if ((here().imagesPixels || state::mayDraw(here())) && "
            f"arbiter::state::imaged{command.name}({command.arguments(['here()'])}))\n    return;\n")


def hides_from_host(table, name):
    """Returns the statement that notes a write of the host, "" for draws that the rasterizer tries first."""
    if name in table.draw_commands:
        return ""
    return f'  if (here().softwareListens)\n    state::hostWrites(here(), "gl{name}");\n'


def straight(command, symbol, dirty, call, handled):
    """Returns the entry point of a command of `straight`: a jump to the host if state/handlers/entry/straight.h says
    so, and the handler in a separate function."""
    result = command.result
    give = "return " if result != "void" else ""
    lead = "  ContextHot *const t = t_current;\n"
    asked = command.arguments(["static_cast<Context &>(*t)"])
    aside = (f"[[gnu::noinline]] static {result} handle_{symbol}({command.declare()}) {{\n"
             f"{lead}{handled}}}\n")
    host_way = call if result != "void" else f"return {call}"
    return aside, (f"{lead}{dirty}"
                   f"  if (t->passThrough || arbiter::state::straight::{command.name}({asked})) [[likely]]\n"
                   f"    {host_way}\n  {give}handle_{symbol}({command.arguments()});\n")


def own(table, command, symbol, dirty, call):
    """Returns the entry point of a command that the layer implements, and its handler if that is a function apart."""
    name, void = command.name, command.result == "void"
    give = "" if void else "return "
    lead = "  ContextHot *const t = t_current;\n"
    handled = f"{give}{handler_call(table, command)};"
    if name in table.config["own"]["straight"]:
        return straight(command, symbol, dirty, call, guarded(command, f"  {handled}\n"))
    handled = dirty + guarded(command, f"  {handled}\n")
    if name in table.config["own"]["everywhere"]:
        return "", lead + handled
    hosts = "t->passThrough"
    if name in table.offered:
        hosts += f" || !state::offered::{table.offered[name]}(here())"
    refusal = ""
    if name in table.refused:
        why = f'"{name}: the profile does not have it"'
        refusal = (f"    if (!t->passThrough && state::offered::refuses(here(), {why}))\n"
                   f"      return{'' if void else ' {}'};\n")
    leave = "    return;\n" if void else ""
    return "", lead + f"  if ({hosts}) [[unlikely]] {{\n{refusal}    {call}\n{leave}  }}\n{handled}"


def thunks(table, command, action, symbol):
    """Returns the entry point's body, and a separate function for its rare path.

    In one function, the compiler would save registers on the fast path too."""
    name, result = command.name, command.result
    give = "" if result == "void" else "return "
    call = f"{give}t->host->{name}({command.arguments()});"
    lead = "  ContextHot *const t = t_current;\n"
    bits = table.bits_of(name)
    dirty = f"  t->dirty |= {bits};\n" if bits else ""
    count = "  ++*t->drawCounter;\n" if action in ("draw", "pixels") else ""
    if action == "handled":
        handled = f"{give}handlers::{name}({command.arguments(['static_cast<Context &>(*t)'])});"
        host_way = call if result != "void" else f"return {call}"
        return "", (lead + dirty + f"  if (!t->softwareListens) [[likely]]\n    {host_way}\n"
                    + guarded(command, f"  {handled}\n"))
    if action == "own":
        return own(table, command, symbol, dirty, call)
    if action == "guard":
        lines = "".join(f"  {n} = handlers::{GUARDS[kind]}(here(), {n});\n" for t, n, kind in command.params
                        if kind in GUARDS and "*" not in t)
        if not lines:
            sys.exit(f"entry_points.toml: [guard] {name} has no program, shader or pipeline parameter")
        if dirty:
            lines += lead + dirty
        return "", lines + f"  {give}t_current->host->{name}({command.arguments()});\n"
    if action == "observe":
        flag, slow = "t->hostProgramIsOurs", "  handlers::restoreApplicationProgram(here());\n"
    else:
        flag = "t->attention"
        prepare = "prepareDraw"
        if action == "pixels":
            prepare = "preparePixels"
        elif action == "validate":
            flag, prepare = "t->attention || t->stagesAreLinked", "prepareRasterPos"
        mode = ""
        if action == "draw":
            named = any(n == "mode" and t.strip() == "GLenum" for t, n, _ in command.params)
            mode = ", mode" if named else ", ~0u"
        slow = f"  if (!arbiter::state::{prepare}(here(){mode}))\n    return{'' if result == 'void' else ' {}'};\n"
    if name in IMAGED:
        flag += " || t->imagesPixels"
        slow = imaged(command) + slow
    if action in ("draw", "pixels"):
        slow = (draws_itself(table, name) + slow + aliases_itself(table, name)
                + hides_from_host(table, name))
    count_and_call = f"{count}{dirty}  {call}\n"
    if name == LETTERS:
        slow = "  const arbiter::state::LettersStay stay(here());\n" + slow
        count_and_call += "  arbiter::state::noteLetters(here());\n"
    if action in ATTENTIVE:
        slow = "  if (state::isHeld(here()))\n    state::drawHeld(here());\n" + slow
    aside = (f"[[gnu::cold, gnu::noinline]] static {result} slow_{symbol}({command.declare()}) {{\n"
             f"{guarded(command, slow)}{lead}{count_and_call}}}\n")
    turn = f"slow_{symbol}({command.arguments()});"
    if result == "void":
        turn = "{\n    " + turn + "\n    return;\n  }\n"
    else:
        turn = "\n    return " + turn + "\n"
    return aside, lead + f"  if ({flag}) [[unlikely]] {turn}{count_and_call}"


# These commands begin and end a primitive, and handle a held one themselves.
PRIMITIVE = ("Begin", "End")
# These actions test ContextHot::attention anyway.
ATTENTIVE = ("draw", "pixels", "validate")


def draws_held(table, command, symbol, action=""):
    """Returns a function that first draws the held primitive (state/raster_draw/immediate/held.h) and then executes the
    command, and the line of the entry point that calls it.

    It is separate, so that the path without it saves no registers. A command that is an error between Begin and End is
    refused there while a primitive is recorded."""
    if command.name in PRIMITIVE or action in ATTENTIVE:
        return "", ""
    result, arguments = command.result, command.arguments()
    give = "" if result == "void" else "return "
    if command.name in table.outside:
        aside = (f"[[gnu::cold, gnu::noinline]] static void recorded_{symbol}({command.declare()}) {{\n"
                 f"  if (!state::refuses(*t_current, \"{symbol}\"))\n    arbiter_{symbol}({arguments});\n}}\n")
        return aside, ("  if (state::isRecorded(*t_current)) [[unlikely]]\n"
                       f"    return recorded_{symbol}({arguments});\n")
    aside = (f"[[gnu::cold, gnu::noinline]] static {result} held_{symbol}({command.declare()}) {{\n"
             f"  state::drawHeld(*t_current);\n  {give}arbiter_{symbol}({arguments});\n}}\n")
    return aside, f"  if (state::isHeld(*t_current)) [[unlikely]]\n    return held_{symbol}({arguments});\n"


def without_suffix(table, rows):
    """Returns rows for the layer's own functions under names without a vendor suffix that GL does not have.

    Programs of the era ask for glCombinerInput before glCombinerInputNV. libglvnd answers each name with a
    function, and that function does nothing if no vendor has the name.
    """
    known = {"gl" + each for command in table.commands.values() for each in command.group}
    found = {}
    for suffix in ("ARB", "NV", "ATI", "EXT"):
        for entry, root, provided, software in rows:
            name = entry.removesuffix(suffix)
            if provided == "true" and name != entry and name not in known:
                found.setdefault(name, (name, root, provided, software))
    return list(found.values())


def entry_points_source(table):
    out = [HEADING, '#include "dispatch/entry_points.h"\n\n#include <algorithm>\n'
           '#include <cstring>\n#include <exception>\n#include <iterator>\n\n'
           '#include "dispatch/function_set.h"\n'
           '#include "host/handlers.h"\n#include "host/host_table.h"\n'
           '#include "state/context/context.h"\n#include "state/core/memory.h"\n'
           '#include "state/host_draw/kept_letters.h"\n#include "state/host_draw/prepare_draw.h"\n'
           '#include "state/handlers/entry/offered.h"\n#include "state/handlers/entry/straight.h"\n'
           '#include "state/pixel_commands/pixel_commands.h"\n'
           '#include "state/raster_draw/commands.h"\n'
           '#include "state/mirror/dirty_bits.h"\n'
           '#include "state/raster_draw/immediate/held.h"\n'
           '#include "state/raster_draw/immediate/list_arrays.h"\n'
           '#include "state/raster_draw/immediate/refused.h"\n\n#define ARBITER_ENTRY '
           'extern "C" __attribute__((visibility("default")))\n\n'
           "using arbiter::state::Context;\nusing arbiter::state::ContextHot;\n"
           "using arbiter::state::t_current;\nnamespace state = arbiter::state;\n"
           "namespace dirty = arbiter::state::dirty;\nnamespace handlers = arbiter::state::handlers;\n\n"
           "namespace {\n[[gnu::always_inline]] inline Context &here() {\n"
           "  return static_cast<Context &>(*t_current);\n}\n} // namespace\n\n"]
    rows = []
    for name, action in sorted(table.action.items()):
        command = table.commands[name]
        root, *aliases = table.entry_names(name)
        aside, body = thunks(table, command, action, root)
        held, look = draws_held(table, command, root, action)
        out.append(f"// {action}\n{aside}ARBITER_ENTRY {command.result} arbiter_{root}({command.declare()}) "
                   f'__asm__("{root}");\n{held}')
        out.append(f"{command.result} arbiter_{root}({command.declare()}) {{\n"
                   f"{look}{body}}}\n")
        for alias in aliases:
            out.append(f"ARBITER_ENTRY {command.result} arbiter_{alias}({command.declare()}) "
                       f'__asm__("{alias}") __attribute__((alias("{root}")));\n')
        provided = "true" if action == "own" and any(
            fnmatch.fnmatchcase(name, p) for p in table.config["own"].get("provided", [])) else "false"
        for entry in [root] + aliases:
            rows.append((entry, root, provided, "true" if action == "handled" else "false"))
    rows += without_suffix(table, rows)
    out.append("\nnamespace arbiter::dispatch {\n\nnamespace {\n\n"
               "struct Row {\n  const char *name;\n  void *function;\n  bool provided;\n  bool forSoftware;\n};\n\n"
               "/// Sorted by name, for a binary search.\nconst Row kRows[] = {\n")
    for entry, root, provided, software in sorted(rows):
        out.append(f'  {{"{entry}", reinterpret_cast<void *>(&arbiter_{root}), {provided}, {software}}},\n')
    out.append("""};

} // namespace

EntryPoint find(const char *name) {
  const auto *const row =
      std::lower_bound(std::begin(kRows), std::end(kRows), name,
                       [](const Row &r, const char *n) { return std::strcmp(r.name, n) < 0; });
  if (row == std::end(kRows) || std::strcmp(row->name, name) != 0)
    return {};
  return {row->function, row->provided, row->forSoftware};
}

bool isOurs(const void *function) {
  static const FunctionSet s_functions(kRows);
  return function && (isForSoftware(function) || s_functions.contains(function));
}

} // namespace arbiter::dispatch
""")
    return "".join(out)
