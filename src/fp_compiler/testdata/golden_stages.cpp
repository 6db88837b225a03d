// The stages of every program in a folder, compared with the files beside it: its IR as checked
// (.ir), as optimised (.opt.ir), and its GLSL (.glsl). With --modes its GLSL in the modes of
// arithmetic (.legacy.glsl, .fp24.glsl) instead; with --validate every GLSL golden goes through
// glslangValidator.
//
// usage: golden-stages [--modes] [--regenerate | --validate] FOLDER...
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/inputs.h"

namespace {

using namespace arbiter::fp;
namespace fs = std::filesystem;

std::string readFile(const fs::path &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> filesOf(const fs::path &folder, const char *extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Goldens {
public:
  Goldens(bool regenerate, bool modes) : m_regenerate(regenerate), m_modes(modes) {}

  void program(const fs::path &path) {
    ++m_programs;
    const CheckResult checked =
        testing_support::check(readFile(path), testing_support::smallFor(path));
    if (!checked.ok())
      return fail(path, "does not load");
    if (m_modes) {
      for (const Numerics mode : {Numerics::Legacy, Numerics::Fp24})
        compare(path, "." + std::string(kNumericsNames[std::size_t(mode)]) + ".glsl",
                emitGlsl(*checked.program, {}, mode).text);
      return;
    }
    ir::Program optimised = *checked.program;
    optimise(optimised);
    for (const std::string &problem : ir::validate(optimised))
      fail(path, problem);
    for (std::uint64_t pixel = 0; pixel < 16; ++pixel)
      if (!testing::same(testing::outcome(*checked.program, pixel),
                         testing::outcome(optimised, pixel)))
        return fail(path, "the passes changed its meaning");
    compare(path, ".ir", ir::print(*checked.program));
    compare(path, ".opt.ir", ir::print(optimised));
    if (checked.native.language != ir::NativeLanguage::Vsp1) // which the layer executes itself
      compare(path, ".glsl", emitGlsl(*checked.program).text);
  }

  int finish(const char *name) const {
    std::cout << m_programs << " programs, " << m_failures << " failures\n";
    if (m_failures != 0)
      std::cout << "if the new output is right: " << name << " --regenerate FOLDER\n";
    return m_programs == 0 || m_failures != 0 ? 1 : 0;
  }

private:
  void fail(const fs::path &path, const std::string &what) {
    ++m_failures;
    std::cout << path.string() << ": " << what << "\n";
  }

  void compare(const fs::path &path, const std::string &extension, const std::string &actual) {
    const fs::path golden = fs::path(path).replace_extension(extension);
    if (m_regenerate)
      std::ofstream(golden, std::ios::binary) << actual;
    const std::string expected = readFile(golden);
    if (expected == actual)
      return;
    const auto at =
        std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end()).second;
    const auto line = 1 + std::count(actual.begin(), at, '\n');
    fail(golden, fs::exists(golden) ? "differs from line " + std::to_string(line) : "is missing");
  }

  bool m_regenerate, m_modes;
  int m_programs = 0, m_failures = 0;
};

/// 77 is a skipped test's status.
int validateGlsl(const std::vector<fs::path> &folders) {
  if (std::system("glslangValidator -v >/dev/null 2>&1") != 0) {
    std::cout << "skipped: not installed: glslangValidator (glslang-tools)\n";
    return 77;
  }
  int files = 0, failures = 0;
  for (const fs::path &folder : folders)
    for (const fs::path &path : filesOf(folder, ".glsl")) {
      const std::string text = readFile(path);
      bool known = true;
      for (const char *extension :
           {"GL_ARB_fragment_coord_conventions", "GL_EXT_gpu_shader4", "GL_ARB_shader_texture_lod"})
        if (text.find(extension) != std::string::npos) {
          std::cout << path.filename().string() << ": skipped, the validator does not know "
                    << extension << "\n";
          known = false;
        }
      if (!known)
        continue;
      ++files;
      const std::string name = path.filename().string();
      const bool vertex = fs::exists(path.parent_path() / (name.substr(0, name.find('.')) + ".vp"));
      const std::string command = std::string("glslangValidator -S ") + (vertex ? "vert" : "frag") +
                                  " '" + path.string() + "'";
      failures += std::system(command.c_str()) != 0;
    }
  std::cout << files << " shaders, " << failures << " failures\n";
  return files == 0 || failures != 0 ? 1 : 0;
}

} // namespace

int main(int argc, char **argv) {
  bool regenerate = false, validate = false, modes = false;
  std::vector<fs::path> folders;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--regenerate") {
      regenerate = true;
    } else if (argument == "--validate") {
      validate = true;
    } else if (argument == "--modes") {
      modes = true;
    } else if (argument.starts_with("-") || !fs::is_directory(argument)) {
      std::cerr << "usage: golden-stages [--modes] [--regenerate | --validate] FOLDER...; not "
                << argument << "\n";
      return 1;
    } else {
      folders.emplace_back(argument);
    }
  }
  if (validate)
    return validateGlsl(folders);
  Goldens goldens(regenerate, modes);
  for (const fs::path &folder : folders)
    for (const char *extension : {".fp", ".vp"})
      for (const fs::path &path : filesOf(folder, extension))
        goldens.program(path);
  return goldens.finish(argv[0]);
}
