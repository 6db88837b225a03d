// Runs programs in NVIDIA's languages through the lowering of blocks and the passes. Besides the
// sanitizers' findings, these are findings: a pass that changes what a program computes or leaves
// it invalid, and an IF whose meaning differs between selects and masks.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/inputs.h"
#include "fp_compiler/testing/random_nv.h"
#include "statements.h"
#include "util/hash.h"

// Defined by libFuzzer.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

namespace {

using namespace arbiter::fp;

/// A run with more steps is not compared, as an input must take milliseconds.
constexpr int kMaxSteps = 20000;
struct TooLong {};

CompileOptions makeOptions() {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.api = {4096, 4096, 4096, 4096, 256, 256, 16, 2};
  options.limits.native = options.limits.api;
  options.limits.localParameters = options.limits.envParameters = 256;
  options.limits.textureCoords = options.limits.textureUnits = 8;
  options.limits.textureImageUnits = 16;
  options.limits.programMatrices = 8;
  options.limits.programMatrixStackDepth = 4;
  options.limits.drawBuffers = 4;
  options.limits.clipPlanes = 6;
  options.limits.nvOptions = 2;
  return options;
}

void require(bool condition) {
  if (!condition)
    std::abort();
}

bool isNvidias(const CheckResult &result) {
  return result.ok() && (result.program->options.nv != ir::NvOption::None ||
                         result.program->options.native != ir::NativeLanguage::None);
}

std::array<testing::Outcome, 4> run(const ir::Program &program, const testing::Made &made) {
  // The observer does not see loops without other instructions.
  int steps = int(program.code.size());
  testing::Made counted = made;
  counted.observer = [&steps](const ir::Step &) {
    if (++steps > kMaxSteps)
      throw TooLong();
  };
  if (program.language == ir::Language::ArbFragment)
    return testing::quadOutcome(program, counted);
  std::array<testing::Outcome, 4> outcomes;
  for (std::size_t i = 0; i < outcomes.size(); ++i, ++counted.pixel)
    outcomes[i] = testing::outcome(program, counted);
  return outcomes;
}

/// How an input is tested: one of several ways, so that each takes a fraction of a millisecond.
struct Look {
  int way = 0; ///< 0 to 3
  Numerics numerics = Numerics::Host;
  bool special = false;
};

Look lookOf(std::string_view text) {
  const std::uint64_t hash = arbiter::hashBytes(text).low;
  return {int(hash & 3), Numerics((hash >> 2) % kNumericsNames.size()), (hash >> 32 & 1) != 0};
}

/// Requires equal results for a few fragments or vertices.
void requireSame(const ir::Program &one, const ir::Program &other, const Look &look) {
  try {
    const testing::Made made = {8, look.numerics, look.special};
    const auto first = run(one, made), second = run(other, made);
    for (std::size_t i = 0; i < first.size(); ++i)
      require(testing::same(first[i], second[i]));
  } catch (const TooLong &) {
  }
}

/// Adds an empty loop to each IF, so that it cannot become a choice between values.
std::string withMasks(std::string_view text) {
  constexpr std::string_view kNothing = " REP 0; ENDREP;";
  std::string made;
  bool word = false, isIf = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (!word && text.substr(at, 2) == "IF" && at + 2 < text.size() &&
        (text[at + 2] == ' ' || text[at + 2] == '('))
      isIf = true;
    word = c == '_' || c == '$' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
    made += c;
    if (c == ';' && isIf) {
      made += kNothing;
      isIf = false;
    }
  }
  return made;
}

/// True if derivatives, or samples that use them, occur in an IF: their neighbors may be the
/// fragments inside it, or all.
bool asksNeighbours(const ir::Program &program) {
  for (const ir::Instruction &instruction : program.code)
    if (instruction.op == ir::Opcode::Ddx || instruction.op == ir::Opcode::Ddy)
      return true;
  return false;
}

void checkSelections(std::string_view text, const CheckResult &result, const Look &look) {
  if (asksNeighbours(*result.program))
    return;
  const std::string masked = withMasks(text);
  if (masked.size() == text.size())
    return;
  const CheckResult other = checkProgram(result.program->language, masked, makeOptions());
  if (other.ok())
    requireSame(*result.program, *other.program, look);
}

template <typename Pass>
void checkPass(const ir::Program &program, const Look &look, const Pass &pass) {
  ir::Program changed = program;
  if (!pass(changed))
    return;
  require(ir::validate(changed).empty());
  requireSame(program, changed, look);
  ir::Program again = changed;
  require(!pass(again));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  const ir::Language language = languageOfText(text).value_or(ir::Language::ArbFragment);
  const CheckResult result = checkProgram(language, text, makeOptions());
  if (!isNvidias(result))
    return 0;
  const ir::Program &program = *result.program;
  require(ir::validate(program).empty());
  const Look look = lookOf(text);
  switch (look.way) {
  case 0:
    checkPass(program, look, opt::unrollLoops);
    break;
  case 1:
    checkPass(program, look,
              [&](ir::Program &changed) { return opt::followLoops(changed, look.numerics); });
    break;
  case 2:
    checkSelections(text, result, look);
    break;
  default: {
    ir::Program optimised = program;
    optimise(optimised, look.numerics);
    require(ir::validate(optimised).empty());
    requireSame(program, optimised, look);
  }
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto kind = random() % 32;
  if (kind < 4)
    return LLVMFuzzerMutate(data, size, maxSize);
  std::string text(reinterpret_cast<const char *>(data), size);
  if (kind == 4 || text.size() < 10)
    text = testing::randomNvProgram(
        random(), {.vertex = random() % 3 == 0,
                   .option = random() % 2 != 0 ? ir::NvOption::Second : ir::NvOption::First,
                   .wild = random() % 2 != 0,
                   .loopDerivatives = random() % 4 == 0,
                   .statements = 4 + int(random() % 16)});
  else
    text = arbiter::fuzz::editStatements(std::move(text), random);
  const std::size_t length = std::min(text.size(), maxSize);
  text.copy(reinterpret_cast<char *>(data), length);
  return length;
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t *first, std::size_t firstSize,
                                                 const std::uint8_t *second, std::size_t secondSize,
                                                 std::uint8_t *out, std::size_t maxSize,
                                                 unsigned seed) {
  std::mt19937_64 random(seed);
  const std::string text = arbiter::fuzz::spliceStatements(
      std::string(reinterpret_cast<const char *>(first), firstSize),
      std::string(reinterpret_cast<const char *>(second), secondSize), random);
  const std::size_t length = std::min(text.size(), maxSize);
  text.copy(reinterpret_cast<char *>(out), length);
  return length;
}
