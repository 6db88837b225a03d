#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

/// What a program takes of a card, and why. countNative() is the fast way, for the API's queries;
/// explainNative() makes the same counts with every reason, for tools.
namespace arbiter::fp::hw {

struct NativeCounts {
  ResourceCounts counts;
  bool fits = false; ///< GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB
};

/// `api` are the counts of the text by the API's rules: what a profile without a model goes by.
[[nodiscard]] NativeCounts countNative(const ir::Program &program, const ResourceCounts &api,
                                       const Limits &limits);

/// Where a part of a count comes from.
struct Reason {
  std::uint32_t ResourceCounts::*resource = &ResourceCounts::instructions;
  std::uint32_t amount = 0; ///< its part of the count
  /// One line, no full stop, without the amount: "SIN is a polynomial".
  std::string text;
  /// The instructions that made it so, into ir::Program::code, ascending; empty: the program as a
  /// whole.
  std::vector<std::uint32_t> instructions;
};

/// What one instruction of the program takes.
struct InstructionCost {
  double slots = 0; ///< ALU slots; a half of a shared pair counts 1/2
  std::uint32_t textures = 0;
  std::uint32_t node = 0; ///< the node of its last operation, from 0
  bool gone = false;      ///< nothing of it is left: dead, or read through
};

/// A texture node (phase, indirection).
struct NodeReport {
  std::vector<std::uint32_t> textures; ///< instructions that sample in it
  std::uint32_t pairs = 0;
  /// Why it cannot be a part of the node before it: "TEX reads R0, which MUL wrote in node 1";
  /// empty for the first.
  std::string reason;
};

/// An estimate; `limits` says what it leaves out.
struct CycleEstimate {
  struct Unit {
    std::string name; ///< "ALU", "texture"
    double cycles = 0;
  };
  double cycles = 0;       ///< a pixel in one pipe
  std::vector<Unit> units; ///< each alone
  std::string bound;       ///< the name of the unit that decides; empty if there is no estimate
  std::string limits;
};

struct NativeReport {
  NativeModel model = NativeModel::Documented;
  ResourceCounts counts;
  bool fits = false;
  std::vector<Reason> reasons;        ///< by resource, then the largest amount first
  std::vector<InstructionCost> costs; ///< one for each of ir::Program::code; empty: no model
  std::vector<NodeReport> nodes;      ///< empty: no model, or no such notion
  /// The longest chain of samples that depend on each other, with what stands between: the
  /// instructions in order. Empty if no sample depends on another.
  std::vector<std::uint32_t> chain;
  CycleEstimate cycles;
  std::string disassembly; ///< in the hardware's terms; empty: no model
};

/// `text` is the program's source, whose lines the disassembly names; without it, the numbers of
/// the instructions.
[[nodiscard]] NativeReport explainNative(const ir::Program &program, const ResourceCounts &api,
                                         const Limits &limits, std::string_view text = {});

} // namespace arbiter::fp::hw
