// usage: spell_programs SEED COUNT
// Prints generated fragment programs as documents, in a JSON array of texts: a mesh, values for the
// parameters that the program reads, and images for the units whose kind documents support.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "fp_compiler/testing/random.h"

namespace {

using namespace arbiter::fp;
using testing::InputRanges;
using testing::Random;

std::string parameterLine(const ir::Parameter &parameter, Random &random) {
  const bool local = parameter.kind == ir::ParameterKind::Local;
  std::string line = std::string("#@ ") + (local ? "local" : "env") + "[" +
                     std::to_string(parameter.index) + "] =";
  for (int i = 0; i < 4; ++i)
    line +=
        " " + std::to_string(random.real(InputRanges::kParameterLow, InputRanges::kParameterHigh));
  return line + "\n";
}

/// The units of testing::kUnitTargets: 0 is 2D, 1 1D, 3 CUBE, 4 RECT.
constexpr const char *kTextures =
    "#@ texture 0 = clouds 32 32, linear\n#@ texture 1 = gradient 32 1 power 2, linear\n"
    "#@ texture 3 = normalize 16\n#@ texture 4 = noise 16 16, nearest, edge\n";

std::string panelOf(const ir::Program &program, std::uint64_t seed) {
  Random random(seed);
  std::string panel = "\n#@ profile host, size 16 16\n";
  panel +=
      seed % 2 ? "#@ mesh torus parts 12, camera orbit pitch 40 distance 2\n" : "#@ mesh quad\n";
  std::set<std::pair<ir::ParameterKind, unsigned>> seen; // a row may have several entries
  for (const ir::Parameter &parameter : program.parameters) {
    const bool named =
        parameter.kind == ir::ParameterKind::Local || parameter.kind == ir::ParameterKind::Env;
    if (named && seen.insert({parameter.kind, parameter.index}).second)
      panel += parameterLine(parameter, random);
  }
  return panel + kTextures;
}

/// True if a program writes the first color, which the verdict is about.
bool writesFirstColor(const ir::Program &program) {
  return std::any_of(program.outputs.begin(), program.outputs.end(), [](const ir::Output &output) {
    return output.kind == ir::OutputKind::Color && output.index == 0;
  });
}

std::string documentOf(std::uint64_t seed) {
  testing::RandomOptions options;
  options.minInstructions = 4;
  options.maxInstructions = 40;
  options.unwritten = seed % 4 == 2;
  ir::Program program = testing::randomProgram(seed, options);
  for (std::uint64_t other = seed; !writesFirstColor(program);)
    program = testing::randomProgram(other += 1000003, options);
  std::string text = testing::spell(program, seed);
  text.insert(std::string("!!ARBfp1.0").size(), panelOf(program, seed));
  return text;
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SEED COUNT\n", argv[0]);
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  nlohmann::json texts = nlohmann::json::array();
  for (std::uint64_t i = 0; i < count; ++i)
    texts.push_back(documentOf(first + i));
  std::printf("%s\n", texts.dump().c_str());
  return 0;
}
