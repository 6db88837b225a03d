#pragma once
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/front/nv/code.h"
#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/front/nv/statement.h"

namespace arbiter::fp::nv {

/// Implements lower(). lowering.cpp makes the writes, flow.cpp and selection.cpp the control flow.
/// A flag is 1 or 0 in x of a register. A flag without a register holds.
class Lowerer {
public:
  Lowerer(const std::vector<Statement> &statements, const Sequences &sequences, Binder &binder,
          Reporter &reporter, const NativeRules &rules);
  void run(std::optional<std::uint16_t> start);

private:
  using Flag = std::optional<std::uint16_t>;

  /// A register that stands for a result. It can be read, and is moved to the result at the end.
  struct Result {
    std::uint16_t index = 0;
    std::uint8_t mask = 0;
  };

  // native.cpp
  void beginResults();
  void beginResult(std::uint16_t output);
  [[nodiscard]] Operand written(const Operand &operand);
  [[nodiscard]] Operand kept(const Operand &address);
  void signedRoot(const Instruction &instruction);
  [[nodiscard]] bool isSquare(const Statement &statement) const;
  void powerByLogarithm(const Instruction &instruction);
  void compute(const Statement &statement, const Instruction &instruction);

  // lowering.cpp
  void execute(const Statement &statement);
  void kill(const Statement &statement, const Instruction &instruction);
  void write(const Statement &statement, Instruction instruction, std::uint16_t target);
  void writeIndexed(const Statement &statement, const Instruction &instruction);
  void update(const Statement &statement, std::uint8_t mask, const Operand &value,
              const std::optional<Operand> &selects);
  void loadAddress(const Statement &statement, const Instruction &instruction);
  void fillAddress(const Statement &statement, const Instruction &move, std::uint16_t address);
  void push(const Statement &statement);
  void pop(const Statement &statement);
  [[nodiscard]] Operand addressValue(const Instruction &instruction);
  [[nodiscard]] Instruction instructionOf(const Statement &statement);
  [[nodiscard]] Operand indexed(const Indexed &indexed, const Operand &operand);
  [[nodiscard]] Operand indexValue(const Indexed &indexed);
  [[nodiscard]] std::uint16_t conditionCode(std::uint8_t index);
  [[nodiscard]] Operand passes(const Test &test, std::uint8_t mask);
  [[nodiscard]] std::optional<Operand> selector(const Test &test, std::uint8_t mask);
  [[nodiscard]] std::uint16_t shadowOf(std::uint16_t address);
  [[nodiscard]] std::uint16_t registerFor(std::uint16_t output, std::uint8_t mask);

  // selection.cpp
  [[nodiscard]] bool selects(const Statement &statement) const;
  void beginSelection(const Statement &statement);
  void endSelection();
  [[nodiscard]] std::uint16_t current(std::uint16_t index) const;
  [[nodiscard]] std::uint16_t aside(std::uint16_t index, std::uint8_t mask);
  [[nodiscard]] std::optional<Operand> activeInSelections();

  // flow.cpp
  void function(std::size_t entry);
  void straight(std::size_t entry);
  void rounds(std::size_t entry, const std::vector<bool> &reached);
  [[nodiscard]] std::vector<bool> reachedFrom(std::size_t entry, bool &backwards) const;
  void statement(const Statement &statement);
  void flow(const Statement &statement);
  void branch(const Statement &statement);
  void call(const Statement &statement);
  void enter(const Statement &statement);
  void turn();
  void beginLoop(const Statement &statement);
  void endLoop();
  void leaveLoop(const Statement &statement);
  void arrive(std::uint16_t label);
  void leave(const Flag &lanes);
  [[nodiscard]] bool returnsWithin(const Statement &loop) const;
  [[nodiscard]] std::uint16_t flag(const Operand &value);
  [[nodiscard]] Flag passesAny(const Test &test);
  [[nodiscard]] std::optional<Operand> active();
  [[nodiscard]] Operand activeOr1();
  void require(Flag &flag);

  const std::vector<Statement> &m_statements;
  const Sequences &m_sequences;
  const NativeRules &m_rules;
  Reporter &m_reporter;
  Code m_code;
  std::map<std::uint16_t, std::size_t> m_places;    ///< of labels
  std::map<std::uint16_t, Result> m_results;        ///< by row of Program::outputs
  std::map<std::uint16_t, std::uint16_t> m_shadows; ///< address registers as floats
  std::array<Flag, 2> m_conditions;
  /// The stack of PUSHA, and its depth as a float. The specification requires at least 4 places.
  std::array<Flag, 8> m_stack;
  Flag m_depth;

  struct Block {
    Flag outer, inner;
    bool selection = false; ///< the last of m_selections
  };
  /// A register that stands for another one in a part of an IF, with the components written.
  struct Aside {
    std::uint16_t index = 0;
    std::uint8_t mask = 0;
  };
  /// An IF without jumps. Both parts run on all lanes, each with its own registers. At the join
  /// each lane takes the values of its part.
  struct Selection {
    std::uint16_t holds = 0;
    bool turned = false; ///< ELSE has come
    std::array<std::map<std::uint16_t, Aside>, 2> parts;
  };
  struct Loop {
    bool counts = false; ///< LOOP
    std::uint16_t index = 0, step = 0;
  };
  /// State of the subroutine or program that is being lowered.
  struct Function {
    Flag base;          ///< what has called it
    Flag block;         ///< the IFs that are open, of that
    Flag alive;         ///< what has not left by RET or BRA
    bool dead = false;  ///< all has left
    bool turns = false; ///< it is written as rounds
    std::uint32_t loops = 0;
    std::vector<Block> blocks;
    std::map<std::uint16_t, Flag> pending; ///< by label: what arrives there
  };
  Function m_function;
  std::vector<Loop> m_loops;
  std::vector<Selection> m_selections; ///< that are open, inner ones last
  std::vector<std::uint16_t> m_calls;
};

} // namespace arbiter::fp::nv
