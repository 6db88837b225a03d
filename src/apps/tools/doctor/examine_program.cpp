#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <elf.h>
#include <filesystem>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "apps/tools/doctor/finding.h"
#include "apps/tools/doctor/libraries.h"
#include "apps/tools/launch/shell_text.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

/// Prefixes of the names of libraries and imports that indicate GL.
constexpr std::string_view kGlLibraries[] = {"libGL.so",  "libGLX.so", "libOpenGL.so",
                                             "libEGL.so", "libGLESv",  "libOSMesa.so"};
constexpr std::string_view kToolkits[] = {"libSDL",  "libglfw", "libepoxy", "libGLEW",   "libQt",
                                          "libgtk-", "libsfml", "libglut",  "libclutter"};
constexpr std::string_view kGlImports[] = {"glX", "egl", "SDL_GL_", "OSMesa",
                                           "glfwMakeContextCurrent"};
constexpr std::string_view kVulkanImports[] = {"SDL_Vulkan_", "glfwCreateWindowSurface",
                                               "vkCreateInstance", "vkGetInstanceProcAddr"};

/// True for functions of GL itself: glBegin, glGetString.
bool isGlCommand(const std::string &name) {
  return name.size() > 3 && name.starts_with("gl") &&
         std::isupper(static_cast<unsigned char>(name[2])) != 0;
}

struct Program {
  Program(Examination &to, const std::string &file, const ElfFile &parsed,
          const Surroundings &around)
      : examination(to), path(file), elf(parsed), surroundings(around),
        folder(fs::path(file).parent_path()),
        libraries(around.root,
                  [&](const char *name) -> const char * {
                    return around.libraryPath.empty() ? std::getenv(name)
                                                      : around.libraryPath.c_str();
                  }),
        loaded(libraries.closure(file, parsed)),
        names(libraryNames(file, {std::begin(kGlLibraries), std::end(kGlLibraries)})) {}

  void add(const char *id, Level level, std::string what, std::string remedy) {
    examination.add({id, level, path, std::move(what), std::move(remedy)});
  }
  [[nodiscard]] bool imports(bool (*wanted)(const std::string &)) const {
    return std::any_of(elf.imports.begin(), elf.imports.end(), wanted);
  }

  Examination &examination;
  const std::string &path;
  const ElfFile &elf;
  const Surroundings &surroundings;
  std::string folder;
  Libraries libraries;
  std::vector<Libraries::Loaded> loaded; ///< the libraries loaded with it
  std::vector<std::string> names;        ///< names of GL libraries in its strings
};

void examineRights(Examination &examination, const std::string &path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0)
    return;
  // Set-user-ID has no effect if the owner is the same user.
  const bool user = (status.st_mode & S_ISUID) != 0 && status.st_uid != ::geteuid();
  const bool group = (status.st_mode & S_ISGID) != 0 && (status.st_mode & S_IXGRP) != 0 &&
                     status.st_gid != ::getegid();
  if (user || group)
    examination.add(
        {"set_user_id", Level::Obstacle, path,
         std::string("It is a set-") + (user ? "user" : "group") +
             "-ID program: for safety nothing is preloaded into it, and the layer reads "
             "no variable there.",
         "Run a copy without that right, if it does without: cp, then arbiter run."});
  if (::getxattr(path.c_str(), "security.capability", nullptr, 0) > 0)
    examination.add({"capabilities", Level::Obstacle, path,
                     "The file has capabilities: for safety nothing is preloaded into it.",
                     "Run a copy (cp leaves them out), or take them away: setcap -r."});
}

} // namespace

bool layerServes(const std::string &layers, int bits, int machine) {
  const std::size_t at = layers.find("$LIB");
  std::vector<std::string> paths;
  if (at == std::string::npos)
    paths.push_back(layers);
  else
    for (const char *const folder : {"lib/x86_64-linux-gnu", "lib/i386-linux-gnu",
                                     "lib/aarch64-linux-gnu", "lib64", "lib32", "lib"})
      paths.push_back(layers.substr(0, at) + folder + layers.substr(at + 4));
  return std::any_of(paths.begin(), paths.end(), [&](const std::string &path) {
    const std::optional<ElfFile> library = readElf(path);
    return library && library->bits == bits && library->machine == machine;
  });
}

namespace {

void examineWidth(Examination &examination, const std::string &path, const ElfFile &elf,
                  const Surroundings &surroundings) {
  if (surroundings.layer.empty() || layerServes(surroundings.layers, elf.bits, elf.machine))
    return;
  const std::string kind = std::to_string(elf.bits) + "-bit (" + machineName(elf.machine) + ")";
  examination.add(
      {"other_width", Level::Obstacle, path,
       "It is a " + kind +
           " program, and the layer that is here is for another kind: " + surroundings.layer + ".",
       elf.machine == EM_386 ? kRemedyOf32Bits
                             : "Install or build the layer for " + machineName(elf.machine) + "."});
}

void examineMissing(Program &program) {
  std::string missing;
  for (const Libraries::Loaded &each : program.loaded)
    if (each.library.path.empty() && !each.library.name.starts_with("ld-"))
      missing += (missing.empty() ? "" : ", ") + each.library.name;
  if (!missing.empty())
    program.add("missing_library", Level::Obstacle,
                "It does not start: " + missing + " for " + std::to_string(program.elf.bits) +
                    "-bit " + machineName(program.elf.machine) + " is not on this system.",
                "Install what has it.");
}

const char *wayOf(const Program &program, FoundBy by) {
  switch (by) {
  case FoundBy::Path:
    return "by its path";
  case FoundBy::Rpath:
    return "by the DT_RPATH of the file";
  case FoundBy::Runpath:
    return "by the DT_RUNPATH of the file";
  case FoundBy::Environment:
    return program.surroundings.libraryPath.empty() ? "by LD_LIBRARY_PATH"
                                                    : "by the loader's --library-path";
  default:
    return "from the system";
  }
}

void addOwn(Program &program, const Library &library, const std::string &way) {
  program.add("own_libgl", Level::Obstacle,
              "It loads a GL of its own " + way + ": " + library.path +
                  " is not libglvnd's, which the layer works through.",
              "Move that file away, so that the system's " + library.name + " is loaded.");
}

/// True for a GL library that the program brings with it, and that does not belong to libglvnd.
bool isOwn(const Library &library) {
  if (library.path.empty() || library.by == FoundBy::System)
    return false;
  const std::optional<ElfFile> elf = readElf(library.path);
  if (!elf || isGlvnd(*elf))
    return false;
  // The layer's libOSMesa is found by LD_LIBRARY_PATH. Only these two rules come before it.
  return !library.name.starts_with("libOSMesa") || library.by == FoundBy::Rpath ||
         library.by == FoundBy::Path;
}

/// Returns the library that dlopen() finds for a name in the file's strings.
Library opened(const Program &program, const std::string &name) {
  if (name.find('/') == std::string::npos)
    return program.libraries.find(name, program.elf, program.folder);
  const fs::path path =
      name[0] == '/' ? fs::path(program.surroundings.root + name) : fs::path(program.folder) / name;
  std::error_code error;
  return fs::is_regular_file(path, error) ? Library{name, path.string(), FoundBy::Path}
                                          : Library{name, {}, FoundBy::Nothing};
}

void examineOwn(Program &program) {
  for (const std::string &name : program.elf.exports)
    if (name == "glXSwapBuffers" || name == "glXMakeCurrent" || name == "eglMakeCurrent") {
      program.add("own_libgl", Level::Obstacle,
                  "It has a GL linked into it (it defines " + name + " itself).",
                  "Use a build of it that links libGL.so.1 of the system.");
      return;
    }
  for (const Libraries::Loaded &each : program.loaded)
    if (beginsWithOne(each.library.name, kGlLibraries) && isOwn(each.library)) {
      addOwn(program, each.library, wayOf(program, each.library.by));
      return;
    }
  for (const std::string &name : program.names)
    if (const Library library = opened(program, name); isOwn(library)) {
      addOwn(program, library,
             std::string(wayOf(program, library.by)) + " (its name is in the file)");
      return;
    }
  for (const char *const beside : {"", "lib", "lib64", "libs"})
    for (const char *const name : {"libGL.so.1", "libGL.so"}) {
      const Library library{name, (fs::path(program.folder) / beside / name).string(),
                            FoundBy::Path};
      if (isOwn(library)) {
        program.add("bundled_libgl", Level::Possible,
                    "A libGL that is not libglvnd's lies beside it (" + library.path +
                        "); if that is loaded the layer is not.",
                    runIt(program.surroundings) + "; move the file away if it is in the way.");
        return;
      }
    }
}

void examineGlvnd(Program &program) {
  if (program.examination.has("own_libgl"))
    return;
  ElfFile plain;
  plain.bits = program.elf.bits;
  plain.machine = program.elf.machine;
  const Library library = program.libraries.find("libGL.so.1", plain, program.folder);
  const Library egl = program.libraries.find("libEGL.so.1", plain, program.folder);
  const std::string kind = std::to_string(plain.bits) + "-bit (" + machineName(plain.machine) + ")";
  const std::string remedy = "Install libglvnd for that kind of program (Debian: libgl1, libegl1), "
                             "and a driver that works with it.";
  if (library.path.empty() && egl.path.empty()) {
    program.add("no_libglvnd", Level::Obstacle,
                "There is no libGL.so.1 and no libEGL.so.1 for " + kind +
                    " programs on this system.",
                remedy);
    return;
  }
  const Library &first = library.path.empty() ? egl : library;
  const std::optional<ElfFile> elf = readElf(first.path);
  if (elf && !isGlvnd(*elf))
    program.add("no_libglvnd", Level::Obstacle,
                "The system's " + first.name + " (" + first.path +
                    ") is a driver's own and not libglvnd's, which the layer works through.",
                remedy);
}

bool hasLibrary(const Program &program, bool (*wanted)(std::string_view)) {
  return std::any_of(program.loaded.begin(), program.loaded.end(),
                     [&](const Libraries::Loaded &each) { return wanted(each.library.name); });
}

/// Examines how the program uses GL. True if it may use GL.
bool examineUse(Program &program) {
  const bool gl = !program.names.empty() || hasLibrary(program, [](std::string_view name) {
    return beginsWithOne(name, kGlLibraries);
  }) || program.imports([](const std::string &name) {
    return isGlCommand(name) || beginsWithOne(name, kGlImports);
  }) || program.examination.has("own_libgl");
  if (gl)
    return true;
  const bool vulkan =
      hasLibrary(program, [](std::string_view name) { return name.starts_with("libvulkan.so"); }) ||
      !libraryNames(program.path, {"libvulkan.so"}).empty() ||
      program.imports([](const std::string &name) { return beginsWithOne(name, kVulkanImports); });
  if (vulkan) {
    program.add("vulkan_only", Level::Obstacle,
                "It draws by Vulkan and has nothing of OpenGL; the layer is one of OpenGL.",
                "If it has an OpenGL renderer in another file or behind an option, choose that.");
    return false;
  }
  if (hasLibrary(program, [](std::string_view name) { return beginsWithOne(name, kToolkits); })) {
    program.add("gl_unsure", Level::Possible,
                "It has nothing of GL itself, and a library that can load it.",
                runIt(program.surroundings) + ".");
    return true;
  }
  const bool opens = program.imports([](const std::string &name) { return name == "dlopen"; });
  program.add(
      "no_gl", opens ? Level::Possible : Level::Obstacle,
      std::string("It uses no GL: neither it nor a library of it links or names one") +
          (opens ? "; it opens others while it runs." : "."),
      opens ? runIt(program.surroundings, "If it should draw, run it, to see which process does") +
                  "."
            : "If something draws, it is another program that this one starts; name that.");
  return false;
}

/// Checks Mesa's LIBGL_ALWAYS_INDIRECT, which makes the X server draw GLX contexts, but no others.
void examineIndirect(Program &program) {
  const char *const value = std::getenv("LIBGL_ALWAYS_INDIRECT");
  constexpr std::string_view kNo[] = {"", "0", "n", "no", "f", "false"};
  if (value == nullptr || std::find(std::begin(kNo), std::end(kNo), value) != std::end(kNo))
    return;
  const bool glx = program.imports([](const std::string &name) { return name.starts_with("glX"); });
  program.add(
      kIndirect, glx ? Level::Obstacle : Level::Possible,
      "LIBGL_ALWAYS_INDIRECT is set: the X server draws for contexts of GLX then, and takes "
      "no GLSL, which the layer draws by.",
      kDirectRemedy);
}

void addNoElf(Examination &examination, const std::string &path) {
  std::string start(2, '\0');
  if (FILE *const file = std::fopen(path.c_str(), "rbe")) {
    start.resize(std::fread(start.data(), 1, 2, file));
    std::fclose(file);
  }
  if (start == "MZ")
    examination.add({"windows_program", Level::Obstacle, path, "It is a program for Windows.",
                     "Run it by Wine: `arbiter run -- " + shellLine({"wine", path}) + "`."});
  else
    examination.add({"unknown_format", Level::Obstacle, path,
                     "It is neither a program for Linux (ELF) nor a script that says what runs it.",
                     "Name the program that runs it."});
}

} // namespace

bool examineHeader(Examination &examination, const std::string &path, const ElfFile &elf,
                   const Surroundings &surroundings) {
  if (elf.interpreter.empty()) {
    examination.add({"static", Level::Obstacle, path,
                     "It is statically linked: nothing can be loaded into it.",
                     "Use a build of it that is linked dynamically."});
    return false;
  }
  examineLoader(examination, path, elf, surroundings);
  if (!surroundings.byLoader) // the kernel then starts the loader, whose rights hold
    examineRights(examination, path);
  examineWidth(examination, path, elf, surroundings);
  return true;
}

void examineProgram(Examination &examination, const std::string &path,
                    const Surroundings &surroundings) {
  const std::optional<ElfFile> elf = readElf(path);
  if (!elf || !elf->executable) {
    addNoElf(examination, path);
    return;
  }
  if (!examineHeader(examination, path, *elf, surroundings))
    return;
  Program program(examination, path, *elf, surroundings);
  examineMissing(program);
  examineOwn(program);
  if (examineUse(program)) {
    examineGlvnd(program);
    examineIndirect(program);
  }
}

} // namespace arbiter::tools::doctor
