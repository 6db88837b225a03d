"""Writes the tables of the host's functions."""
from gl_commands import HEADING


# A host table has a part that is filled later (`lazy`), so the compiler would leave even a constant table writable. The
# constant tables have no lookup and are never written, so that they can be in read-only memory.
CONSTANT = '[[gnu::section(".data.rel.ro.arbiter")]] constinit'


def header(table):
    out = [HEADING, "#pragma once\n", "#include <cstddef>\n\n", "#include <GL/gl.h>\n",
           "#include <GL/glext.h>\n\n", "namespace arbiter::host {\n\nusing GetProc = void *(*)(const char *name);\n\n",
           "/// The host's functions for one provider. A function that the host lacks points at one "
           "that does\n/// nothing and returns 0, so a member is never null once the table is "
           "loaded.\nstruct HostTable {\n"]
    for name in table.members:
        command = table.commands[name]
        out.append(f"  {command.result} (*{name})({command.types()}) = nullptr;\n")
    out.append("  // What follows is no function of the host's.\n"
               "  /// Lazy functions by number (lazy_functions.h), null until first called.\n"
               f"  mutable void *lazy[{len(table.lazy)}] = {{}};\n"
               "  /// Where they come from; null in tables that have none.\n"
               "  GetProc lookup = nullptr;\n"
               "  /// Of a table that only stands in for another: brings the thread to the true one.\n"
               "  const HostTable *(*instead)() = nullptr;\n"
               "};\n\n"
               f"inline constexpr std::size_t kFunctions = {len(table.members)};\n\n"
               "/// Fills every member from `getProc`, each with the first name of its alias group "
               "that it knows.\n/// Returns how many the host has.\n"
               "std::size_t loadHostTable(HostTable &table, GetProc getProc);\n\n"
               "namespace detail {\nvoid *missingFunction();\n}\n\n"
               "/// True if the host has the function; false for the member's stand-in.\n"
               "template <typename Function> [[nodiscard]] bool available(Function *function) {\n"
               "  return function && reinterpret_cast<void *>(function) != "
               "detail::missingFunction();\n}\n\n} // namespace arbiter::host\n")
    return "".join(out)


def source(table):
    out = [HEADING, '#include "host/host_table.h"\n\n#include <cstdint>\n#include <cstring>\n\n',
           "namespace arbiter::host {\n\nnamespace {\n\n",
           "std::uintptr_t missing() { return 0; }\n\n",
           "/// Names parted by NUL, ended by an empty one; each member's group in member order.\n",
           "constexpr const char *kNames[] = {\n"]
    for name in table.members:
        out.append('  "' + "\\0".join(table.entry_names(name)) + '\\0",\n')
    out.append("""};

static_assert(offsetof(HostTable, lazy) == sizeof(kNames) / sizeof(kNames[0]) * sizeof(void *));

} // namespace

void *detail::missingFunction() { return reinterpret_cast<void *>(&missing); }

std::size_t loadHostTable(HostTable &table, GetProc getProc) {
  auto *const bytes = reinterpret_cast<unsigned char *>(&table);
  std::size_t found = 0;
  for (std::size_t i = 0; i < sizeof(kNames) / sizeof(kNames[0]); ++i) {
    void *function = nullptr;
    for (const char *name = kNames[i]; *name && !function; name += std::strlen(name) + 1)
      function = getProc(name);
    if (function)
      ++found;
    else
      function = detail::missingFunction();
    std::memcpy(bytes + i * sizeof(void *), &function, sizeof(void *));
  }
  table.lookup = getProc;
  return found;
}

/// The names of the lazy functions, each group's parted by NUL and ended by an empty one, and
/// where each begins: numbers, so that nothing is relocated when the library is loaded.
constexpr char kLazyNames[] =
""")
    offset, offsets = 0, []
    for name in table.lazy:
        names = table.entry_names(name)
        out.append('    "' + "\\0".join(names) + '\\0\\0"\n')
        offsets.append(offset)
        offset += sum(len(n) + 1 for n in names) + 1
    out.append(";\nconstexpr std::uint32_t kLazyOffsets[] = {"
               + ", ".join(str(o) for o in offsets) + """};

const char *lazyNames(std::size_t index) { return kLazyNames + kLazyOffsets[index]; }

} // namespace arbiter::host
""")
    return "".join(out)


def null_table(table):
    """Returns the null context's table: each function looks up the next definition when called."""
    out = [HEADING, '#include "host/null_host.h"\n\n',
           "namespace arbiter::host {\n\nnamespace {\n\n"]
    for index, name in enumerate(table.members):
        command = table.commands[name]
        root = table.entry_names(name)[0]
        give = "" if command.result == "void" else "return "
        out.append(f"{command.result} null{name}({command.declare()}) {{\n"
                   f'  const NullCall call("{root}", {index});\n'
                   f"  if (call.function())\n"
                   f"    {give}reinterpret_cast<{command.result} (*)({command.types()})>"
                   f"(call.function())({command.arguments()});\n"
                   + ("" if command.result == "void" else "  return {};\n") + "}\n")
    out.append(f"\n}} // namespace\n\n{CONSTANT} const HostTable kNullHost = {{\n")
    out += [f"    .{name} = null{name},\n" for name in table.members]
    out.append("};\n\n} // namespace arbiter::host\n")
    return "".join(out)


def recording_table(table):
    """Returns the effective table while a primitive is deferred. Each of its functions first has the host draw the
    primitive, then calls the host's function."""
    out = [HEADING, '#include "state/raster_draw/immediate/replay.h"\n\n#include "host/host_table.h"\n'
           '#include "state/core/context_hot.h"\n\n'
           "namespace arbiter::state {\n\nnamespace {\n\n"]
    for name in table.members:
        command = table.commands[name]
        give = "" if command.result == "void" else "return "
        out.append(f"{command.result} recording{name}({command.declare()}) {{\n"
                   f"  {give}flushToHost()->{name}({command.arguments()});\n}}\n")
    out.append(f"\n}} // namespace\n\n{CONSTANT} const host::HostTable kRecordingHost = {{\n")
    out += [f"    .{name} = recording{name},\n" for name in table.members]
    out.append("    .instead = flushToHost,\n};\n\n} // namespace arbiter::state\n")
    return "".join(out)
