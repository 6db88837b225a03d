#include "fp_compiler/front/budget.h"

#include <algorithm>

namespace arbiter::fp {

namespace {

struct ResourceRow {
  std::uint32_t ResourceCounts::*count;
  DiagnosticId id;
  const char *plural;
  const char *hint;
  std::uint32_t ceiling = Budget::kCeiling;
};

constexpr ResourceRow kRows[kResourceCount] = {
    {&ResourceCounts::instructions, DiagnosticId::LimitInstructions, "instructions", ""},
    {&ResourceCounts::aluInstructions, DiagnosticId::LimitAlu, "ALU instructions", ""},
    {&ResourceCounts::texInstructions, DiagnosticId::LimitTex, "texture instructions",
     "TEX, TXP, TXB and KIL count"},
    {&ResourceCounts::texIndirections, DiagnosticId::LimitIndirections, "texture indirections",
     "this sample needs what was computed since the last one that began a node; sample earlier, or "
     "from coordinates that are attributes"},
    {&ResourceCounts::temporaries, DiagnosticId::LimitTemporaries, "temporaries",
     "declared temporaries count even if they are unused"},
    {&ResourceCounts::parameters, DiagnosticId::LimitParameters, "parameters",
     "every distinct constant and state vector that is bound counts, used or not"},
    {&ResourceCounts::attribs, DiagnosticId::LimitAttribs, "attributes",
     "every distinct attribute that is bound counts, used or not"},
    {&ResourceCounts::addressRegisters, DiagnosticId::LimitAddressRegisters, "address registers",
     "load one again with ARL instead", 256},
};

} // namespace

Budget::Budget(const CompileOptions &options, Reporter &reporter)
    : m_reporter(reporter), m_policy(options.policy), m_limits(options.limits.api),
      m_refuseIndirections(options.limits.refuseIndirections != 0) {}

void Budget::debit(const ir::Options &options) {
  if (options.positionInvariant) {
    m_debitor = options.native == ir::NativeLanguage::None ? "OPTION ARB_position_invariant"
                                                           : "OPTION NV_position_invariant";
    m_debits.instructions = 4;
  }
  if (options.fog == ir::FogMode::None)
    return;
  m_debitor = "the fog option";
  m_debits.temporaries = 1;
  m_debits.attribs = 1;
  m_debits.parameters = 2;
  m_debits.instructions = options.fog == ir::FogMode::Exp    ? 3
                          : options.fog == ir::FogMode::Exp2 ? 4
                                                             : 2;
  m_debits.aluInstructions = m_debits.instructions;
}

bool Budget::spend(Resource resource, Span where) {
  const ResourceRow &row = kRows[std::size_t(resource)];
  const std::uint32_t count = ++(m_counts.*row.count);
  const std::uint32_t whole = m_limits.*row.count;
  const std::uint32_t limit = whole - std::min(whole, m_debits.*row.count);
  if (count > limit && !m_reported[std::size_t(resource)]) {
    m_reported[std::size_t(resource)] = true;
    report(resource, where, limit, false);
  }
  if (count <= row.ceiling)
    return true;
  if (!m_ceilingReported[std::size_t(resource)]) {
    m_ceilingReported[std::size_t(resource)] = true;
    report(resource, where, row.ceiling, true);
  }
  return false;
}

void Budget::report(Resource resource, Span where, std::uint32_t limit, bool ceiling) {
  const ResourceRow &row = kRows[std::size_t(resource)];
  std::string message =
      "more than " + std::to_string(limit) + " " + row.plural + (ceiling ? " in any program" : "");
  if (const std::uint32_t debit = m_debits.*row.count; debit != 0 && !ceiling)
    message += " (" + std::to_string(m_limits.*row.count) + " less " + std::to_string(debit) +
               " for " + m_debitor + ")";
  const bool loads = m_policy == LimitPolicy::Report ||
                     (resource == Resource::TexIndirections && !m_refuseIndirections);
  if (loads && !ceiling)
    m_reporter.warning(row.id, where, std::move(message), row.hint);
  else if (!ceiling || loads || limit < m_limits.*row.count)
    m_reporter.error(row.id, where, std::move(message), row.hint);
}

} // namespace arbiter::fp
