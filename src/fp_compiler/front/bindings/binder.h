#pragma once
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "fp_compiler/front/budget.h"
#include "fp_compiler/front/indirections.h"

namespace arbiter::fp {

/// Builds the ir::Program: gives every distinct binding one row, counts it, and appends checked
/// instructions. The cost of a call does not grow with the program.
class Binder {
public:
  Binder(ir::Language language, const CompileOptions &options, Reporter &reporter);

  /// Each of these returns the row's index. `where` is the binding's text, at which an excess is
  /// reported.
  std::uint16_t temporary(std::string_view name, Span where);
  /// \param alone true if the other attribute of its row in table X.2.1 may not be bound too
  std::uint16_t attribute(ir::Attribute attribute, Span where, bool alone = true);
  std::uint16_t output(ir::Output output);
  std::uint16_t addressRegister(std::string_view name, Span where);
  std::uint16_t constant(const ir::Vec4 &value, Span where);
  std::uint16_t env(std::uint32_t index, Span where);
  std::uint16_t local(std::uint32_t index, Span where);
  std::uint16_t state(const ir::StateRef &ref, Span where);

  /// Returns the number in Program::arrays of an array that is indexed by an address register. Such
  /// an array counts all its constants (ARB_vertex_program 2.14.3.7), and may not have a state
  /// vector twice (2.14.3.2). Call once for an array.
  std::uint16_t relativeArray(std::string_view name, const std::vector<std::uint16_t> &rows,
                              Span where);

  /// Counts and appends an instruction. An excess is reported at `opcode`.
  void instruction(const ir::Instruction &instruction, Span opcode);

  /// Counts an instruction without appending it. Returns false if the program cannot load. Programs
  /// under NVIDIA's options are lowered after the whole text is read, and then use append().
  [[nodiscard]] bool count(const ir::Instruction &instruction, Span opcode);
  /// Add registers and rows that the text does not declare and that are not counted. They report an
  /// error at \p where beyond the ceiling of every program.
  std::uint16_t hiddenTemporary(std::string_view name, Span where);
  [[nodiscard]] bool hasTemporaries() const { return !m_program.temporaries.empty(); }
  std::uint16_t hiddenConstant(const ir::Vec4 &value, Span where);
  std::uint16_t hiddenEnv(std::uint32_t index, Span where);
  /// Adds an address register of four components: four consecutive registers of the IR.
  std::uint16_t addressVector(std::string_view name, Span where);
  void append(const ir::Instruction &instruction, Span where);

  /// Ends the options. Their debits apply from here.
  void setOptions(const ir::Options &options);

  /// The program is read.
  void finish() { m_budget.finish(); }
  [[nodiscard]] const ResourceCounts &counts() const { return m_budget.counts(); }
  [[nodiscard]] ir::Program takeProgram() { return std::move(m_program); }

private:
  std::uint16_t constantRow(const ir::Vec4 &value, Span where, bool counts);

  using Bits = std::array<std::uint32_t, 4>;
  /// Returns the components' bits with only one zero, so that numerically equal constants are
  /// equal.
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
  /// Rows by their bits. The API counts -0 and 0 as one parameter, but they are two values.
  std::unordered_map<Bits, std::uint16_t, BitsHash> m_constantRows;
  std::unordered_set<Bits, BitsHash> m_constantsCounted;
  std::unordered_set<Bits, BitsHash> m_relativeConstants;
  std::unordered_set<std::uint16_t> m_relativeState; ///< rows of arrays indexed relatively
};

} // namespace arbiter::fp
