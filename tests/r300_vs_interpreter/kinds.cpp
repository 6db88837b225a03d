#include "kinds.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::r300 {

namespace {
fp::ir::Program fragment(std::uint64_t seed) { return fp::testing::randomProgram(seed); }

fp::ir::Program longFragment(std::uint64_t seed) {
  fp::testing::RandomOptions options;
  options.minInstructions = 30;
  options.maxInstructions = 70;
  options.kills = false;
  return fp::testing::randomProgram(seed, options);
}

/// Adds half of the results to a visible sum, so that little of the program is dead.
fp::ir::Program live(std::uint64_t seed) {
  using namespace fp::ir;
  fp::testing::RandomOptions options;
  options.maxInstructions = 24;
  Program program = fp::testing::randomProgram(seed, options);
  fp::testing::Random random(seed ^ 0x11FE);
  const auto sum = std::uint16_t(program.temporaries.size());
  program.temporaries.push_back({"sum"});
  const auto half = std::uint16_t(program.parameters.size());
  program.parameters.push_back({.kind = ParameterKind::Constant, .constant = {.5f, .5f, .5f, .5f}});
  std::vector<Instruction> code;
  for (const Instruction &instruction : program.code) {
    Instruction add;
    add.op = Opcode::Mad;
    add.dst = {File::Temporary, sum, instruction.dst.mask, false, {}};
    add.src[0].index = sum;
    add.src[1].file = File::Parameter;
    add.src[1].index = half;
    add.src[2].index = instruction.dst.index;
    // The sum is written to each color last.
    if (!info(instruction.op).has(Kills) && instruction.dst.file == File::Output &&
        program.outputs[instruction.dst.index].kind == OutputKind::Color) {
      add.dst = instruction.dst;
      add.src[2] = instruction.src[0];
      code.push_back(add);
      continue;
    }
    code.push_back(instruction);
    if (!info(instruction.op).has(Kills) && instruction.dst.file == File::Temporary &&
        random.chance(50))
      code.push_back(add);
  }
  program.code = std::move(code);
  return program;
}

fp::ir::Program wild(std::uint64_t seed) {
  fp::testing::RandomOptions options;
  options.wild = true;
  options.maxInstructions = 40;
  return fp::testing::randomProgram(seed, options);
}

/// Returns a random program with random fixed-function state.
fp::ir::Program ati(std::uint64_t seed) {
  fp::testing::RandomAtiOptions options;
  options.defined = options.tameDivisors = true;
  options.separateDots = true;
  fp::testing::Random random(seed ^ 0xA71);
  fp::FixedFunction state;
  for (fp::ir::TexTarget &target : state.targets)
    target = fp::testing::kUnitTargets[std::size_t(random.below(8))];
  state.disabledUnits = std::uint8_t(random.chance(30) ? random.below(64) : 0);
  state.fog = random.chance(30) ? fp::ir::FogMode(1 + random.below(3)) : fp::ir::FogMode::None;
  state.colorSum = random.chance(30);
  fp::ati::LowerOptions lowering;
  lowering.registerRange = random.chance(50) ? 8 : 0;
  return fp::withFixedFunction(
      fp::ati::lower(fp::testing::randomAtiShader(seed, options), lowering), state);
}

/// Returns the programs of files, in their order.
std::vector<fp::ir::Program> &texts() {
  static std::vector<fp::ir::Program> programs;
  return programs;
}
fp::ir::Program text(std::uint64_t seed) { return texts()[seed]; }

constexpr Kind kKinds[] = {
    {"fragment", fragment, true}, {"long", longFragment, true}, {"live", live, true},
    {"ati", ati, true},           {"wild", wild, false},
};
constexpr Kind kText = {"text", text, true};
} // namespace

std::span<const Kind> generatedKinds() { return kKinds; }
const Kind &textKind() { return kText; }
std::uint64_t textCount() { return texts().size(); }

bool addTexts(const char *folder) {
  fp::CompileOptions options;
  options.limits.api = {4096, 4096, 4096, 4096, 256, 256, 32, 0};
  options.limits.localParameters = options.limits.envParameters = 256;
  options.limits.textureCoords = options.limits.textureUnits = 8;
  options.limits.textureImageUnits = options.limits.programMatrices = 16;
  options.limits.drawBuffers = 4;
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (const auto &entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".fp")
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const std::filesystem::path &path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string source((std::istreambuf_iterator<char>(file)), {});
    const auto language = fp::languageOfText(source);
    if (!language || *language == fp::ir::Language::ArbVertex)
      continue;
    const fp::CheckResult checked = fp::checkProgram(*language, source, options);
    if (!checked.ok())
      return std::printf("%s: %s", path.c_str(), checked.errorString(source).c_str()), false;
    texts().push_back(*language == fp::ir::Language::AtiFragment
                          ? fp::withFixedFunction(*checked.program, {})
                          : *checked.program);
  }
  return !error && !paths.empty();
}

} // namespace arbiter::r300
