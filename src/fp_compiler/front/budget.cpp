#include "fp_compiler/front/budget.h"

#include <algorithm>

#include "fp_compiler/front/words/limit_words.h"
#include "fp_compiler/ir/fog.h"

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
      m_refuseIndirections(options.limits.refuseIndirections != 0), m_card(options.limits.card) {}

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
  m_debits.instructions = ir::rowOf(options.fog).instructions + 1;
  m_debits.aluInstructions = m_debits.instructions;
}

/// True if a program over the limit loads all the same.
bool Budget::loads(Resource resource) const {
  return m_policy == LimitPolicy::Report ||
         (resource == Resource::TexIndirections && !m_refuseIndirections);
}

std::uint32_t Budget::limitOf(Resource resource) const {
  const ResourceRow &row = kRows[std::size_t(resource)];
  const std::uint32_t whole = m_limits.*row.count;
  return whole - std::min(whole, m_debits.*row.count);
}

std::string Budget::amount(Resource resource) const {
  const ResourceRow &row = kRows[std::size_t(resource)];
  std::string text = std::to_string(limitOf(resource)) + " " + row.plural;
  if (const std::uint32_t debit = m_debits.*row.count; debit != 0)
    text += " (" + std::to_string(m_limits.*row.count) + " less " + std::to_string(debit) +
            " for " + m_debitor + ")";
  return text;
}

bool Budget::spend(Resource resource, Span where) {
  const ResourceRow &row = kRows[std::size_t(resource)];
  const std::uint32_t count = ++(m_counts.*row.count);
  std::optional<Span> &over = m_over[std::size_t(resource)];
  if (count > limitOf(resource) && !over) {
    over = where;
    if (!loads(resource))
      m_reporter.error(row.id, where,
                       "more than " + amount(resource) +
                           (m_card.empty() ? "" : ", the limit of " + m_card),
                       row.hint);
  }
  if (count <= row.ceiling)
    return true;
  if (!m_ceilingReported[std::size_t(resource)]) {
    m_ceilingReported[std::size_t(resource)] = true;
    reportCeiling(resource, where);
  }
  return false;
}

/// No program has so much. Not said where the limit below has been an error already.
void Budget::reportCeiling(Resource resource, Span where) {
  const ResourceRow &row = kRows[std::size_t(resource)];
  if (loads(resource) || row.ceiling < m_limits.*row.count)
    m_reporter.error(row.id, where,
                     "more than " + std::to_string(row.ceiling) + " " + row.plural +
                         " in any program",
                     row.hint);
}

void Budget::finish() {
  for (std::size_t i = 0; i < m_over.size(); ++i) {
    const auto resource = Resource(i);
    if (!m_over[i] || !loads(resource))
      continue;
    const ResourceRow &row = kRows[i];
    const char *const has = resource == Resource::TexIndirections ? " runs " : " has ";
    const std::string count = std::to_string(m_counts.*row.count);
    // A statement in error is not counted.
    std::string needs = m_reporter.hasErrors() ? "at least " + count : count;
    if (!m_reporter.hasErrors())
      needs += kItLoads;
    if (!m_reporter.hasErrors() && m_policy == LimitPolicy::Report)
      needs += ", as limits are only reported";
    m_reporter.warning(row.id, *m_over[i],
                       (m_card.empty() ? "the limit is " : m_card + has) + amount(resource) +
                           ", and this program needs " + needs,
                       row.hint);
  }
}

} // namespace arbiter::fp
