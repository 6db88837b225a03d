#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

/// Native resource counts: what a program uses on a card, and why. countNative() is fast, for the
/// API's queries. explainNative() makes the same counts with every reason, for tools.
namespace arbiter::fp::hw {

struct NativeCounts {
  ResourceCounts counts;
  bool fits = false; ///< GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB
};

/// Returns the native counts.
/// \param api the counts of the text by the API's rules; a profile without a model uses them
[[nodiscard]] NativeCounts countNative(const ir::Program &program, const ResourceCounts &api,
                                       const Limits &limits);

/// A reason for a part of a count.
struct Reason {
  std::uint32_t ResourceCounts::*resource = &ResourceCounts::instructions;
  std::uint32_t amount = 0; ///< how much of the count
  /// One line, no full stop, without the amount: "SIN is a polynomial".
  std::string text;
  /// The instructions that cause it, as ascending indices into ir::Program::code. If empty, the
  /// program as a whole causes it.
  std::vector<std::uint32_t> instructions;
};

/// The cost of one instruction of the program.
struct InstructionCost {
  double slots = 0; ///< ALU slots; a half of a shared pair counts 1/2
  std::uint32_t textures = 0;
  std::uint32_t node = 0; ///< the node of its last operation, from 0
  bool gone = false;      ///< no code is left for it: it was dead, or its readers read its source
};

/// A texture node, also called a phase or an indirection.
struct NodeReport {
  std::vector<std::uint32_t> textures; ///< instructions that sample in it
  std::uint32_t pairs = 0;
  /// Why its samples cannot be in the node before it: "TEX reads R0, which MUL wrote in node 1".
  /// Empty for the first node.
  std::string reason;
};

/// An estimate of clock cycles.
struct CycleEstimate {
  struct Unit {
    std::string name; ///< "ALU", "texture"
    double cycles = 0;
  };
  double cycles = 0;       ///< for a pixel in one pipe
  std::vector<Unit> units; ///< each unit on its own
  std::string bound;       ///< the name of the slowest unit; empty if there is no estimate
  std::string limits;
};

struct NativeReport {
  NativeModel model = NativeModel::Documented;
  ResourceCounts counts;
  bool fits = false;
  std::vector<Reason> reasons;        ///< ordered by resource, then by falling amount
  std::vector<InstructionCost> costs; ///< one for each of ir::Program::code; empty: no model
  std::vector<NodeReport> nodes;      ///< empty if there is no model, or if the card has no nodes
  /// The longest chain of samples that depend on each other, with the instructions between them, in
  /// order. Empty if no sample depends on another.
  std::vector<std::uint32_t> chain;
  CycleEstimate cycles;
  std::string disassembly; ///< in the hardware's terms; empty if there is no model
};

/// Returns the native counts with their reasons.
/// \param text the program's source; the disassembly then names its lines, otherwise the numbers of
/// the instructions
[[nodiscard]] NativeReport explainNative(const ir::Program &program, const ResourceCounts &api,
                                         const Limits &limits, std::string_view text = {});

} // namespace arbiter::fp::hw
