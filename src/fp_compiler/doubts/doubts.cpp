#include "fp_compiler/doubts/doubts.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/front/diagnostic_ids.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

namespace {

using ir::File;
using ir::Instruction;
using ir::Opcode;

constexpr std::uint8_t kWhole = 0xF; ///< all four components

/// "xz" for 5
std::string componentsOf(std::uint8_t mask) {
  std::string text;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      text += "xyzw"[i];
  return text;
}

/// A register of one file as the passes see it, going backward.
struct Fate {
  std::uint8_t wanted = 0; ///< the components that later code reads
  /// By component: the later instruction that writes it, if none reads it before.
  std::array<const Instruction *, 4> overwriter = {};
};

class Doubts {
public:
  Doubts(std::string_view file, const FileProgram &place, const ir::Program &program)
      : m_file(file), m_place(place), m_program(program), m_loops(ir::hasLoops(program)) {}

  std::vector<Diagnostic> take() {
    // NVIDIA's own languages begin with zeros, and have errors where a result is missing.
    if (m_program.options.native == ir::NativeLanguage::None) {
      findUnwritten();
      if (!findResult())
        return std::move(m_found); // then everything is unused
    }
    findUnused();
    return std::move(m_found);
  }

private:
  void findUnwritten();
  [[nodiscard]] bool mayBePartial(const Instruction &instruction) const;
  void report(const ir::Operand &operand, std::uint8_t missing, std::uint8_t written);
  bool findResult();
  void findUnused();
  void forget(std::vector<Fate> &fates, std::size_t index, std::uint8_t mask);
  void look(const Instruction &instruction, Fate &fate);
  void reportUnused(const Instruction &instruction, const Fate &fate);
  [[nodiscard]] bool isCounted(const Instruction &instruction) const;

  [[nodiscard]] std::string_view text(Span span) const {
    return m_file.substr(span.begin, span.end - span.begin);
  }
  [[nodiscard]] std::string lineOf(const Instruction &instruction) const {
    return "line " + std::to_string(locate(m_file, instruction.span.begin).line);
  }
  /// True if no further warning would be kept.
  [[nodiscard]] bool full() const { return m_found.size() >= kMaxDiagnostics; }
  void warn(DiagnosticId id, Span span, std::string message, std::string hint) {
    m_found.push_back({Severity::Warning, info(id).id, span, std::move(message), std::move(hint)});
  }

  std::string_view m_file;
  const FileProgram &m_place;
  const ir::Program &m_program;
  bool m_loops;
  std::vector<Diagnostic> m_found;
  std::vector<std::pair<const Instruction *, Fate>> m_unused;
  std::set<std::uint32_t> m_used; ///< the places of instructions that are used in one of their runs
};

/// True for an operand or a destination that stands in the text. What lowering adds has no place,
/// or that of the whole statement.
bool isPlaced(Span span, const Instruction &instruction) {
  return span.begin != span.end && span != instruction.span;
}

bool writesTo(const Instruction &instruction, File file) {
  return instruction.dst.file == file && ir::writeMask(instruction) != 0;
}

/// True for a write to texture coordinates, of which a sample reads only some components. Under
/// NVIDIA's options every result is written through a register without a name.
bool Doubts::mayBePartial(const Instruction &instruction) const {
  const ir::Destination &dst = instruction.dst;
  if (dst.file == File::Output)
    return m_program.outputs[dst.index].kind == ir::OutputKind::TexCoord;
  return writesTo(instruction, File::Temporary) && m_program.temporaries[dst.index].name.empty();
}

/// Finds components that reach a result or a KIL, and that no instruction before writes. Where
/// NVIDIA's options write under a condition, that counts as a write.
void Doubts::findUnwritten() {
  const analysis::LiveValues live = analysis::liveOf(m_program);
  std::vector<std::uint8_t> written(m_program.temporaries.size(), 0);
  const auto write = [&](const Instruction &instruction) {
    if (writesTo(instruction, File::Temporary))
      written[instruction.dst.index] |= instruction.dst.mask;
  };
  if (m_loops) // an iteration may read what the one before has written
    std::for_each(m_program.code.begin(), m_program.code.end(), write);
  for (std::size_t at = 0; at < m_program.code.size() && !full(); ++at) {
    const Instruction narrow = analysis::narrowed(m_program.code[at], live.written[at]);
    for (int i = 0; live.written[at] != 0 && i < info(narrow.op).operandCount(); ++i) {
      const ir::Operand &operand = narrow.src[std::size_t(i)];
      if (operand.file != File::Temporary || !isPlaced(operand.span, narrow) ||
          m_program.temporaries[operand.index].name.empty())
        continue;
      std::uint8_t &known = written[operand.index];
      if (known != 0 && mayBePartial(narrow))
        continue;
      if (const auto missing = std::uint8_t(ir::registerMask(narrow, i) & ~known)) {
        report(operand, missing, known);
        known = kWhole;
      }
    }
    write(m_program.code[at]);
  }
}

void Doubts::report(const ir::Operand &operand, std::uint8_t missing, std::uint8_t written) {
  const std::string &name = m_program.temporaries[operand.index].name;
  // An instruction writes after it has read.
  const auto writer = std::find_if(
      m_program.code.begin(), m_program.code.end(), [&](const Instruction &instruction) {
        return writesTo(instruction, File::Temporary) && instruction.dst.index == operand.index &&
               (instruction.dst.mask & missing) != 0 && instruction.span.end > operand.span.begin;
      });
  warn(DiagnosticId::UnwrittenTemporary, operand.span,
       quote(written == 0 ? name : name + "." + componentsOf(missing)) +
           " is read before anything writes it",
       writer != m_program.code.end()
           ? "its value is undefined until " + lineOf(*writer) + " has written it"
           : "its value is undefined: no instruction writes it");
}

/// Reports a result that must be written and is not. Returns false if the program has no effect.
bool Doubts::findResult() {
  const bool vertex = m_place.language == ir::Language::ArbVertex;
  std::uint8_t position = m_program.options.positionInvariant ? kWhole : 0;
  bool any = false;
  const Instruction *last = nullptr;
  for (const Instruction &instruction : m_program.code) {
    any |= info(instruction.op).has(ir::Kills);
    if (writesTo(instruction, File::Temporary) &&
        !m_program.temporaries[instruction.dst.index].name.empty())
      last = &instruction;
    if (!writesTo(instruction, File::Output))
      continue;
    any = true;
    if (m_program.outputs[instruction.dst.index].kind == ir::OutputKind::Position)
      position |= instruction.dst.mask;
  }
  const Span header = {m_place.span.begin, m_place.span.begin + 10};
  if (vertex && position == 0)
    warn(DiagnosticId::UnwrittenResult, header, "nothing writes result.position",
         "OPTION ARB_position_invariant; writes it as fixed function does, or four DP4 with the "
         "rows of state.matrix.mvp");
  else if (vertex && position != kWhole)
    warn(DiagnosticId::UnwrittenResult, header,
         "nothing writes result.position." + componentsOf(kWhole & ~position),
         "the components of a result that nothing writes are undefined");
  else if (!vertex && !any)
    warn(DiagnosticId::UnwrittenResult, header,
         "nothing writes result.color, so the fragment's colour is undefined",
         "write it at last: MOV result.color, " +
             (last ? m_program.temporaries[last->dst.index].name : "fragment.color") + ";");
  return any || m_program.options.positionInvariant;
}

/// Finds writes that no instruction reads. What an unused instruction reads counts as read, so that
/// one mistake gives one warning.
void Doubts::findUnused() {
  std::vector<Fate> temporaries(m_program.temporaries.size());
  std::vector<Fate> outputs(m_program.outputs.size());
  std::vector<Fate> addresses(m_program.addresses.size());
  for (std::size_t i = 0; i < outputs.size(); ++i)
    outputs[i].wanted = ir::resultMask(m_program.outputs[i].kind);
  const auto read = [&](const Instruction &instruction) {
    for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      const std::uint8_t mask = ir::registerMask(instruction, i);
      if (operand.relative && mask != 0)
        forget(addresses, operand.address, 1);
      else if (operand.file == File::Temporary)
        forget(temporaries, operand.index, mask);
    }
  };
  if (m_loops) // an earlier instruction of the next iteration may read
    std::for_each(m_program.code.begin(), m_program.code.end(), read);
  for (std::size_t at = m_program.code.size(); at-- > 0;) {
    const Instruction &instruction = m_program.code[at];
    if (info(instruction.op).hasDestination())
      look(instruction,
           (instruction.dst.file == File::Output    ? outputs
            : instruction.dst.file == File::Address ? addresses
                                                    : temporaries)[instruction.dst.index]);
    read(instruction);
  }
  std::set<std::uint32_t> told;
  for (const auto &[instruction, fate] : m_unused)
    if (!full() && !m_used.contains(instruction->span.begin) &&
        told.insert(instruction->span.begin).second)
      reportUnused(*instruction, fate);
}

void Doubts::forget(std::vector<Fate> &fates, std::size_t index, std::uint8_t mask) {
  fates[index].wanted |= mask;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      fates[index].overwriter[i] = nullptr;
}

/// Looks at a write, and goes before it.
void Doubts::look(const Instruction &instruction, Fate &fate) {
  if (isCounted(instruction)) {
    if ((instruction.dst.mask & fate.wanted) != 0)
      m_used.insert(instruction.span.begin);
    else
      m_unused.emplace_back(&instruction, fate);
  }
  if (m_loops)
    return;
  fate.wanted = std::uint8_t(fate.wanted & ~instruction.dst.mask);
  for (std::size_t i = 0; i < 4; ++i)
    if (instruction.dst.mask >> i & 1)
      fate.overwriter[i] = &instruction;
}

/// True if the text has the instruction as it is in the code. Programs under NVIDIA's options are
/// lowered: of a statement only an unconditional write to a variable is one.
bool Doubts::isCounted(const Instruction &instruction) const {
  if (m_program.options.nv == ir::NvOption::None)
    return true;
  return instruction.dst.file == File::Temporary &&
         !m_program.temporaries[instruction.dst.index].name.empty() &&
         text(instruction.span).starts_with(info(instruction.op).mnemonic);
}

void Doubts::reportUnused(const Instruction &instruction, const Fate &fate) {
  const ir::Destination &dst = instruction.dst;
  const bool placed = isPlaced(dst.span, instruction);
  const Span span = placed ? dst.span : instruction.span;
  const std::string name =
      quote(placed ? text(dst.span) : std::string_view(m_program.temporaries[dst.index].name));
  if (dst.file == File::Output) {
    const std::uint8_t counts = ir::resultMask(m_program.outputs[dst.index].kind);
    if ((dst.mask & counts) == 0)
      return warn(DiagnosticId::UnusedWrite, span, name + " is no component that counts",
                  "of this result only " + componentsOf(counts) + " counts");
  }
  const Instruction *by = nullptr;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(dst.mask >> i & 1))
      continue;
    if (!fate.overwriter[i])
      return warn(DiagnosticId::UnusedWrite, span, name + " is written, but nothing reads it",
                  "the instruction has no effect; leave it out, or use what it computes");
    by = fate.overwriter[i];
  }
  warn(DiagnosticId::UnusedWrite, span,
       name + " is overwritten in " + lineOf(*by) + " before anything reads it",
       "the instruction has no effect; leave it out, or write something else in " + lineOf(*by));
}

} // namespace

void addDoubts(std::string_view file, const FileProgram &program, CheckResult &result) {
  const bool arb =
      program.language == ir::Language::ArbFragment || program.language == ir::Language::ArbVertex;
  if (!arb || !result.program)
    return;
  auto &all = result.diagnostics;
  std::vector<Diagnostic> found = Doubts(file, program, *result.program).take();
  const std::size_t room = kMaxDiagnostics - std::min<std::size_t>(kMaxDiagnostics, all.size());
  found.resize(std::min(found.size(), room));
  std::move(found.begin(), found.end(), std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic &a, const Diagnostic &b) {
    return a.span.begin < b.span.begin;
  });
}

} // namespace arbiter::fp
