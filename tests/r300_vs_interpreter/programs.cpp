#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "expectation.h"
#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/execute/execute.h"
#include "fp_compiler/hw/r300/report/disassemble.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/random.h"
#include "kinds.h"
#include "mutate.h"
#include "naive.h"
#include "surroundings.h"

/// Runs random programs through the R300's compiler. Every code must be legal, give the program's
/// results on the chip's interpreter, and take at most one slot for each operation.
///   r300-programs [--count N] [--from SEED] [--kind NAME] [--mutants 1]
///   r300-programs --texts FOLDER [--texts FOLDER...]
/// With --mutants each code gets one mistake, and most must be noticed. The exit status is 1 if any
/// fails; the first failures of a kind are printed with their listings.
namespace arbiter::r300 {
namespace {

using fp::hw::r300::Code;

constexpr std::uint64_t kFragments = 2;
constexpr int kShown = 3;
/// If more values than this fraction are not judged, the comparison would be meaningless.
constexpr double kSkippedShare = 0.08;

/// If fewer mistakes than this fraction are noticed, the comparison is blind. Most that go
/// unnoticed have no effect: a clamp, a minimum or a comparison hides them.
constexpr double kNoticedShare = 0.65;

struct Totals {
  int programs = 0, illegal = 0, wrong = 0, costly = 0, fitting = 0;
  std::uint64_t pairs = 0, naive = 0;
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
    cost(seed, program, code, options.scaleRectangles);
    for (std::uint64_t at = 0; m_kind.compared && at < kFragments; ++at)
      if (!compare(seed, at, program, code))
        return;
  }

  /// Makes one mistake in a program's code and checks whether it is noticed.
  void mutant(std::uint64_t seed) {
    const fp::ir::Program program = m_kind.make(seed);
    Code code = fp::hw::r300::compile(program, {});
    fp::testing::Random random(seed ^ 0x4D07);
    if (mutate(code, random).empty())
      return;
    ++m_mutants;
    bool noticed = !fp::hw::r300::faults(code, program).empty();
    for (std::uint64_t at = 0; !noticed && at < 4 * kFragments; ++at) {
      const Surroundings surroundings(program, seed * kFragments + at);
      const Expectation expected = expect(program, surroundings.inputs(), seed);
      noticed =
          judge(program, expected, fp::hw::r300::execute(code, program, surroundings.inputs()))
              .error > 1;
    }
    m_noticed += noticed;
  }

  [[nodiscard]] bool reportMutants() const {
    const double share = m_mutants ? double(m_noticed) / double(m_mutants) : 0;
    std::printf("%-9s %d of %d mistakes noticed, %.1f %%\n", m_kind.name, m_noticed, m_mutants,
                100 * share);
    return share >= kNoticedShare;
  }

  [[nodiscard]] bool report() const {
    const Totals &t = m_totals;
    const long values = t.compared + t.skipped;
    const double skipped = values ? double(t.skipped) / double(values) : 0;
    std::printf("%-9s %5d programs, %5d fit; illegal %d, wrong %d, costly %d; %.2f of "
                "naive pairs; %ld values compared, %.2f %% "
                "ill-conditioned; worst %.2f of its slack\n",
                m_kind.name, t.programs, t.fitting, t.illegal, t.wrong, t.costly,
                t.naive ? double(t.pairs) / double(t.naive) : 0, t.compared, 100 * skipped,
                double(t.worst));
    if (skipped > kSkippedShare)
      std::printf("%s: too many values say nothing\n", m_kind.name);
    return t.illegal == 0 && t.wrong == 0 && t.costly == 0 && skipped <= kSkippedShare;
  }

private:
  void cost(std::uint64_t seed, const fp::ir::Program &program, const Code &code,
            bool scaleRectangles) {
    fp::ir::Program alive = program;
    (void)fp::opt::removeDeadCode(alive);
    const NaiveCounts naive = naiveCounts(alive, scaleRectangles);
    m_totals.pairs += code.pairs.size();
    m_totals.naive += naive.pairs;
    if (code.pairs.size() <= naive.pairs && code.textures.size() <= naive.textures &&
        code.nodes.size() <= naive.nodes)
      return;
    show(m_totals.costly++, seed, program, code,
         "above " + std::to_string(naive.pairs) + " pairs, " + std::to_string(naive.textures) +
             " TEX or " + std::to_string(naive.nodes) + " nodes, an operation a slot\n");
  }

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
  int m_mutants = 0, m_noticed = 0;
};
} // namespace
} // namespace arbiter::r300

int main(int argc, char **argv) {
  using namespace arbiter::r300;
  std::uint64_t count = 500, from = 0;
  const char *only = nullptr;
  bool mutants = false, good = true;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--count"))
      count = std::strtoull(argv[i + 1], nullptr, 10);
    else if (!std::strcmp(argv[i], "--from"))
      from = std::strtoull(argv[i + 1], nullptr, 10);
    else if (!std::strcmp(argv[i], "--kind"))
      only = argv[i + 1];
    else if (!std::strcmp(argv[i], "--texts"))
      good &= addTexts(argv[i + 1]);
    else if (!std::strcmp(argv[i], "--mutants"))
      mutants = argv[i + 1][0] == '1';
    else
      return std::fprintf(stderr,
                          "usage: %s [--count N] [--from SEED] [--kind NAME] [--mutants 1] "
                          "[--texts FOLDER]\n",
                          argv[0]),
             2;
  }
  if (textCount() > 0) {
    Run run(textKind());
    for (std::uint64_t i = 0; i < textCount(); ++i)
      run.program(i);
    return good && run.report() ? 0 : 1;
  }
  for (const Kind &kind : generatedKinds()) {
    if (only && std::strcmp(only, kind.name) != 0)
      continue;
    if (mutants && !kind.compared)
      continue;
    Run run(kind);
    for (std::uint64_t seed = from; seed < from + count; ++seed)
      mutants ? run.mutant(seed) : run.program(seed);
    good &= mutants ? run.reportMutants() : run.report();
  }
  return good ? 0 : 1;
}
