#pragma once
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "fp_compiler/front/budget.h"
#include "fp_compiler/front/indirections.h"

namespace arbiter::fp {

/// Builds the ir::Program: gives every distinct binding one row, counts it, and appends checked
/// instructions. Cost per call does not grow with the program.
class Binder {
public:
  Binder(ir::Language language, const CompileOptions &options, Reporter &reporter);

  /// Each returns the row's index. `where` is the binding's text, the position of an excess.
  std::uint16_t temporary(std::string_view name, Span where);
  /// \param alone whether the attribute beside it in table X.2.1 may not be bound
  std::uint16_t attribute(ir::Attribute attribute, Span where, bool alone = true);
  std::uint16_t output(ir::Output output);
  std::uint16_t addressRegister(std::string_view name, Span where);
  std::uint16_t constant(const ir::Vec4 &value, Span where);
  std::uint16_t env(std::uint32_t index, Span where);
  std::uint16_t local(std::uint32_t index, Span where);
  std::uint16_t state(const ir::StateRef &ref, Span where);

  /// An array that is indexed by an address register, which counts its constants as they are
  /// (ARB_vertex_program 2.14.3.7) and may hold no state vector twice (2.14.3.2): its number in
  /// Program::arrays. Call once an array.
  std::uint16_t relativeArray(std::string_view name, const std::vector<std::uint16_t> &rows,
                              Span where);

  /// Counts and appends. `opcode` is where an excess is reported.
  void instruction(const ir::Instruction &instruction, Span opcode);

  /// Counts alone: false where the program may come to nothing. The code of a program under one of
  /// NVIDIA's options is made when all of it is read, by append().
  [[nodiscard]] bool count(const ir::Instruction &instruction, Span opcode);
  /// Registers and rows that are not the text's, and are not counted. Each fails, with an error at
  /// \p where, beyond what any program may have.
  std::uint16_t hiddenTemporary(std::string_view name, Span where);
  [[nodiscard]] bool hasTemporaries() const { return !m_program.temporaries.empty(); }
  std::uint16_t hiddenConstant(const ir::Vec4 &value, Span where);
  std::uint16_t hiddenEnv(std::uint32_t index, Span where);
  /// Of four components: four registers of the IR that follow each other.
  std::uint16_t addressVector(std::string_view name, Span where);
  void append(const ir::Instruction &instruction, Span where);

  /// The options are over: their debits hold from here.
  void setOptions(const ir::Options &options);

  /// The program is read.
  void finish() { m_budget.finish(); }
  [[nodiscard]] const ResourceCounts &counts() const { return m_budget.counts(); }
  [[nodiscard]] ir::Program takeProgram() { return std::move(m_program); }

private:
  std::uint16_t constantRow(const ir::Vec4 &value, Span where, bool counts);

  using Bits = std::array<std::uint32_t, 4>;
  /// The components' bits with one zero, so that numerically equal constants are equal.
  static Bits countedBits(const ir::Vec4 &value);
  struct BitsHash {
    std::size_t operator()(const Bits &bits) const;
  };
  std::uint16_t row(std::uint64_t key, const ir::Parameter &parameter, Span where);
  void refuseAlias(ir::Attribute attribute, Span where);
  bool countKinds(const ir::Instruction &instruction, Span opcode);
  std::uint16_t append(const ir::Parameter &parameter);

  Reporter &m_reporter;
  Budget m_budget;
  IndirectionCounter m_indirections;
  ir::Program m_program;
  std::unordered_map<std::uint64_t, std::uint16_t> m_stateRows;
  /// Rows by their bits: -0 and 0 are one parameter by the API's count, but two values.
  std::unordered_map<Bits, std::uint16_t, BitsHash> m_constantRows;
  std::unordered_set<Bits, BitsHash> m_constantsCounted;
  std::unordered_set<Bits, BitsHash> m_relativeConstants;
  std::unordered_set<std::uint16_t> m_relativeState; ///< rows of arrays indexed relatively
};

} // namespace arbiter::fp
