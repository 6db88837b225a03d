#include <algorithm>
#include <array>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds a register that is read with several swizzles that the R300 lacks. Proposes a rearranged
/// copy, from which the R300's swizzles reach several of these orders.
namespace arbiter::tools::advise {

namespace {

/// The swizzles of the R300's RGB unit, without w: .xyz, .yzx, .zxy, .wzy and single components
/// (hw/r300).
constexpr std::array<std::array<std::uint8_t, 3>, 8> kSelects = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {3, 2, 1}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}};
constexpr std::size_t kMaxTried = 6; ///< arrangements for one register

/// Component i of the copy is component [i] of the register.
using Arrangement = std::array<std::uint8_t, 4>;
constexpr Arrangement kAsIs = {0, 1, 2, 3};

struct Read {
  std::uint32_t instruction = 0;
  int operand = 0;
  std::uint8_t mask = 0;
};

/// Returns the swizzle by which the copy provides the wanted components, if the card has one.
std::optional<fp::ir::Swizzle> reach(const Operand &wanted, std::uint8_t mask,
                                     const Arrangement &copy) {
  const auto want = [&](std::size_t position) { return std::uint8_t(wanted.swizzle[position]); };
  for (const auto &select : kSelects) {
    fp::ir::Swizzle swizzle = wanted.swizzle;
    bool fits = true;
    for (std::size_t c = 0; c < 3; ++c) {
      fits = fits && (!(mask >> c & 1) || copy[select[c]] == want(c));
      swizzle[c] = fp::ir::Select(select[c]);
    }
    if (mask & 8) { // the alpha unit can read any component
      const auto found = std::find(copy.begin(), copy.end(), want(3));
      fits = fits && found != copy.end();
      swizzle[3] = fp::ir::Select(found == copy.end() ? 0 : found - copy.begin());
    }
    if (fits)
      return swizzle;
  }
  return std::nullopt;
}

bool sameRegister(const Operand &a, const Operand &b) {
  return a.file == b.file && a.index == b.index;
}

/// Returns the reads of a register with swizzles that the card lacks, so that it copies the
/// register.
std::vector<Read> awkwardReads(const Subject &subject, const Operand &of) {
  std::vector<Read> reads;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const fp::ir::OpInfo &row = fp::ir::info(subject.at(i).op);
    if (row.has(fp::ir::Texture) || row.has(fp::ir::Kills) || !subject.flow().live(i) ||
        subject.at(i).op == fp::ir::Opcode::Swz)
      continue;
    for (int o = 0; o < row.operandCount(); ++o) {
      const Operand &operand = subject.at(i).src[std::size_t(o)];
      const std::uint8_t mask = fp::ir::operandMask(subject.at(i), o);
      if (sameRegister(operand, of) && !operand.relative && row.shapes[o] != 'S' &&
          !reach(operand, mask & 7, kAsIs))
        reads.push_back({i, o, mask});
    }
  }
  return reads;
}

std::size_t reached(const Subject &subject, const std::vector<Read> &reads,
                    const Arrangement &copy) {
  return std::size_t(std::count_if(reads.begin(), reads.end(), [&](const Read &read) {
    return reach(subject.at(read.instruction).src[std::size_t(read.operand)], read.mask, copy)
        .has_value();
  }));
}

/// Returns the arrangements that serve most reads, at least two.
std::vector<Arrangement> bestArrangements(const Subject &subject, const std::vector<Read> &reads) {
  std::vector<std::pair<std::size_t, Arrangement>> all;
  for (unsigned number = 0; number < 256; ++number) {
    const Arrangement copy = {std::uint8_t(number & 3), std::uint8_t(number >> 2 & 3),
                              std::uint8_t(number >> 4 & 3), std::uint8_t(number >> 6)};
    if (const std::size_t count = reached(subject, reads, copy); count > 1)
      all.emplace_back(count, copy);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto &a, const auto &b) { return a.first > b.first; });
  std::vector<Arrangement> best;
  for (std::size_t i = 0; i < std::min(all.size(), kMaxTried); ++i)
    best.push_back(all[i].second);
  return best;
}

Proposal proposed(const Subject &subject, const std::vector<Read> &reads, const Arrangement &copy) {
  const std::string name = subject.fresh("arranged");
  const std::string base = subject.base(reads[0].instruction, reads[0].operand);
  std::string letters;
  for (const std::uint8_t component : copy)
    letters += "xyzw"[component];
  Draft draft(subject);
  draft.insert(reads[0].instruction, {"TEMP " + name, "MOV " + name + ", " + base + "." + letters});
  for (const Read &read : reads) {
    Operand operand = subject.at(read.instruction).src[std::size_t(read.operand)];
    const auto swizzle = reach(operand, read.mask, copy);
    if (!swizzle)
      continue;
    operand.swizzle = *swizzle;
    if (const auto text = Subject::spelled(name, operand, read.mask, false))
      draft.replaceOperand(read.instruction, read.operand, *text);
  }
  return draft.about(reads[0].instruction, "swizzles_by_one_copy",
                     "the card has no such swizzles of " + base +
                         " and copies for each: one copy in another order serves several");
}

} // namespace

Proposals arrangements(const Subject &subject) {
  Proposals proposals;
  std::vector<Operand> seen;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (int o = 0; o < fp::ir::info(subject.at(i).op).operandCount(); ++o) {
      const Operand &operand = subject.at(i).src[std::size_t(o)];
      const bool input = operand.file == File::Attribute || operand.file == File::Parameter;
      if (!input || operand.relative ||
          std::any_of(seen.begin(), seen.end(),
                      [&](const Operand &each) { return sameRegister(each, operand); }))
        continue;
      seen.push_back(operand);
      const std::vector<Read> reads = awkwardReads(subject, operand);
      for (const Arrangement &copy : bestArrangements(subject, reads))
        proposals.push_back(proposed(subject, reads, copy));
    }
  return proposals;
}

} // namespace arbiter::tools::advise
