#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "expectation.h"
#include "fp_compiler/ati/lower.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/disassemble.h"
#include "fp_compiler/hw/r300/execute.h"
#include "fp_compiler/hw/r300/legality.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"
#include "surroundings.h"

/// Random programs through the R300's compiler: every code is legal, and run on the chip's
/// interpreter it gives what the program says.
///   r300-programs [--count N] [--from SEED] [--kind NAME]
/// Exit status 1 if any fails; the first of a kind are printed with their listings.
namespace arbiter::r300 {
namespace {

using fp::hw::r300::Code;

constexpr std::uint64_t kFragments = 4;
constexpr int kShown = 3;
/// More than this share of values that say nothing would make the comparison one in name only.
constexpr double kSkippedShare = 0.08;

/// A way to make programs.
struct Kind {
  const char *name;
  fp::ir::Program (*make)(std::uint64_t seed);
  bool compared; ///< false: the values are undefined, only the rules are looked at
};

fp::ir::Program fragment(std::uint64_t seed) { return fp::testing::randomProgram(seed); }

fp::ir::Program longFragment(std::uint64_t seed) {
  fp::testing::RandomOptions options;
  options.minInstructions = 30;
  options.maxInstructions = 70;
  options.kills = false;
  return fp::testing::randomProgram(seed, options);
}

fp::ir::Program wild(std::uint64_t seed) {
  fp::testing::RandomOptions options;
  options.wild = true;
  options.maxInstructions = 40;
  return fp::testing::randomProgram(seed, options);
}

/// Under fixed-function state of its own.
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

constexpr Kind kKinds[] = {
    {"fragment", fragment, true},
    {"long", longFragment, true},
    {"ati", ati, true},
    {"wild", wild, false},
};

struct Totals {
  int programs = 0, illegal = 0, wrong = 0, fitting = 0;
  long compared = 0, skipped = 0;
  float worst = 0;
};

class Run {
public:
  explicit Run(const Kind &kind) : m_kind(kind) {}

  void program(std::uint64_t seed) {
    const fp::ir::Program program = m_kind.make(seed);
    fp::hw::r300::CompileOptions options;
    options.scaleRectangles = (seed & 1) != 0;
    const Code code = fp::hw::r300::compile(program, options);
    ++m_totals.programs;
    m_totals.fitting += fp::hw::r300::overflows(code).empty();
    const auto faults = fp::hw::r300::faults(code, program);
    if (!faults.empty()) {
      std::string text;
      for (const auto &fault : faults)
        text += fault.text + "\n";
      show(m_totals.illegal++, seed, program, code, text);
      return;
    }
    for (std::uint64_t at = 0; m_kind.compared && at < kFragments; ++at)
      if (!compare(seed, at, program, code))
        return;
  }

  [[nodiscard]] bool report() const {
    const Totals &t = m_totals;
    const long values = t.compared + t.skipped;
    const double skipped = values ? double(t.skipped) / double(values) : 0;
    std::printf("%-9s %5d programs, %5d fit; illegal %d, wrong %d; %ld values compared, %.2f %% "
                "ill-conditioned; worst %.2f of its slack\n",
                m_kind.name, t.programs, t.fitting, t.illegal, t.wrong, t.compared, 100 * skipped,
                double(t.worst));
    if (skipped > kSkippedShare)
      std::printf("%s: too many values say nothing\n", m_kind.name);
    return t.illegal == 0 && t.wrong == 0 && skipped <= kSkippedShare;
  }

private:
  bool compare(std::uint64_t seed, std::uint64_t at, const fp::ir::Program &program,
               const Code &code) {
    const Surroundings surroundings(program, seed * kFragments + at);
    const Expectation expected = expect(program, surroundings.inputs(), seed);
    const Verdict verdict =
        judge(program, expected, fp::hw::r300::execute(code, program, surroundings.inputs()));
    m_totals.compared += verdict.compared;
    m_totals.skipped += verdict.skipped;
    m_totals.worst = std::max(m_totals.worst, verdict.error);
    if (verdict.error <= 1)
      return true;
    show(m_totals.wrong++, seed, program, code,
         "fragment " + std::to_string(at) + ", " + verdict.what + "\n");
    return false;
  }

  void show(int before, std::uint64_t seed, const fp::ir::Program &program, const Code &code,
            const std::string &what) const {
    if (before < kShown)
      std::printf("%s, seed %llu:\n%s\n%s\n%s\n", m_kind.name,
                  static_cast<unsigned long long>(seed), what.c_str(),
                  fp::ir::print(program).c_str(),
                  fp::hw::r300::disassemble(code, program, "").c_str());
    else
      std::printf("%s, seed %llu: %s", m_kind.name, static_cast<unsigned long long>(seed),
                  what.c_str());
  }

  const Kind &m_kind;
  Totals m_totals;
};
} // namespace
} // namespace arbiter::r300

int main(int argc, char **argv) {
  std::uint64_t count = 500, from = 0;
  const char *only = nullptr;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--count"))
      count = std::strtoull(argv[i + 1], nullptr, 10);
    else if (!std::strcmp(argv[i], "--from"))
      from = std::strtoull(argv[i + 1], nullptr, 10);
    else if (!std::strcmp(argv[i], "--kind"))
      only = argv[i + 1];
    else
      return std::fprintf(stderr, "usage: %s [--count N] [--from SEED] [--kind NAME]\n", argv[0]),
             2;
  }
  bool good = true;
  for (const auto &kind : arbiter::r300::kKinds) {
    if (only && std::strcmp(only, kind.name) != 0)
      continue;
    arbiter::r300::Run run(kind);
    for (std::uint64_t seed = from; seed < from + count; ++seed)
      run.program(seed);
    good &= run.report();
  }
  return good ? 0 : 1;
}
