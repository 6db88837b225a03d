// What the compiler says of every program in a folder, compared with the .check file beside it:
// whole rendered diagnostics, and the counts of a program that loads.
//
// usage: golden-check [--regenerate] FOLDER...
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "fp_compiler/front/testing/test_support.h"

namespace {

using namespace arbiter::fp;
namespace fs = std::filesystem;

std::string readFile(const fs::path &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A .vp file is held to be a vertex program, whatever its header says.
bool isVertex(const fs::path &program) { return program.extension() == ".vp"; }

std::string describe(const fs::path &program) {
  const std::string name = program.filename().string();
  const std::string text = readFile(program);
  const bool vertex = isVertex(program);
  const auto language = vertex                        ? ir::Language::ArbVertex
                        : text.starts_with("!!ATIfs") ? ir::Language::AtiFragment
                                                      : ir::Language::ArbFragment;
  const CheckResult result = checkProgram(language, text, testing_support::smallFor(program));
  std::string out = "position " + std::to_string(result.errorPosition()) + "\n";
  for (const Diagnostic &diagnostic : result.diagnostics)
    out += render(name, text, diagnostic);
  if (!result.ok())
    return out;
  const ResourceCounts &c = result.counts;
  const auto line = [&](const char *what, std::uint32_t n) {
    out += std::string(what) + " " + std::to_string(n) + "\n";
  };
  line("instructions", c.instructions);
  if (!vertex) {
    line("alu", c.aluInstructions);
    line("tex", c.texInstructions);
    line("indirections", c.texIndirections);
  }
  line("temporaries", c.temporaries);
  line("parameters", c.parameters);
  line("attribs", c.attribs);
  if (vertex)
    line("address registers", c.addressRegisters);
  return out;
}

/// The first line that differs, of both.
void printDifference(const std::string &expected, const std::string &actual) {
  const auto [e, a] = std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end());
  const auto line = [](const std::string &text, std::size_t at) {
    const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  std::cout << "  expected: " << line(expected, std::size_t(e - expected.begin()))
            << "\n  actual:   " << line(actual, std::size_t(a - actual.begin())) << "\n";
}

std::vector<fs::path> programsOf(const fs::path &folder) {
  std::vector<fs::path> programs;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".fp" || isVertex(entry.path()))
      programs.push_back(entry.path());
  std::sort(programs.begin(), programs.end());
  return programs;
}

} // namespace

int main(int argc, char **argv) {
  bool regenerate = false;
  std::vector<fs::path> folders;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--regenerate") {
      regenerate = true;
    } else if (argument.starts_with("-") || !fs::is_directory(argument)) {
      std::cerr << "usage: golden-check [--regenerate] FOLDER...; not " << argument << "\n";
      return 1;
    } else {
      folders.emplace_back(argument);
    }
  }
  int programs = 0;
  int failures = 0;
  for (const fs::path &folder : folders) {
    for (const fs::path &program : programsOf(folder)) {
      const fs::path golden = fs::path(program).replace_extension(".check");
      const std::string actual = describe(program);
      ++programs;
      if (regenerate)
        std::ofstream(golden, std::ios::binary) << actual;
      const std::string expected = readFile(golden);
      if (expected == actual)
        continue;
      ++failures;
      std::cout << program.string() << ": " << (fs::exists(golden) ? "differs" : "has no golden")
                << "\n";
      printDifference(expected, actual);
    }
  }
  std::cout << programs << " programs, " << failures << " failures\n";
  if (failures != 0)
    std::cout << "if the new output is right: " << argv[0] << " --regenerate FOLDER\n";
  return programs == 0 || failures != 0 ? 1 : 0;
}
