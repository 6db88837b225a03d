#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/hw/native.h"
#include "fp_compiler/ir/ir.h"

/// A program as a card holds it that runs one instruction after the other: the form that the models
/// of such cards (nv30/, i915/) share. The R300's is in r300/machine.h.
namespace arbiter::fp::hw {

inline constexpr std::uint16_t kWholeProgram = 0xFFFF;

/// Why a slot stands in the program.
enum class SlotCause : std::uint8_t {
  Instruction,   ///< the IR instruction itself, or its part of a longer expansion
  Constant,      ///< a second constant of one instruction, moved to a register
  Attribute,     ///< likewise a second attribute
  Swizzle,       ///< constants 0 and 1, or signs that differ, that an operand cannot have
  Coordinate,    ///< a coordinate brought into a plain register
  Result,        ///< a sample under a write mask
  FogCoordinate, ///< the w of fragment.fogcoord, which the chip has wrong
  Depth,         ///< the depth moved to where the chip takes it
  Fog,           ///< the fog option's blend
  ColorSum,      ///< the secondary colour added to the result
};

/// One instruction of the card.
struct Slot {
  bool texture = false;
  std::uint16_t origin = kWholeProgram; ///< index into ir::Program::code
  SlotCause cause = SlotCause::Instruction;
  std::uint8_t passes = 1;   ///< of the unit
  bool interpolated = false; ///< texture: its coordinate comes straight from the rasterizer
  std::uint32_t phase = 0;   ///< from 0; always 0 where the card has no phases
};

/// A phase other than the first: the sample that begins it, and what it waited for.
struct PhaseStart {
  std::uint16_t sample = 0;
  /// Who wrote the coordinate in the phase before. The sample itself: a move that it needs. None:
  /// it samples into a result register.
  std::uint16_t writer = kWholeProgram;
};

struct SlotProgram {
  std::vector<Slot> slots;
  std::vector<bool> gone; ///< by IR instruction: dropped as dead
  std::vector<PhaseStart> starts;
  std::uint32_t phases = 0; ///< 0: the card has none
  std::uint32_t temporaries = 0;
  std::uint32_t scratch = 0;    ///< part of temporaries: registers for coordinates
  std::uint32_t parameters = 0; ///< all, the driver's own included
  std::uint32_t ownConstants = 0;
  std::uint32_t attribs = 0;
  std::uint32_t interpolators = 0; ///< texture coordinate sets
  bool halves = false;             ///< registers are 16 bits a component, two in one
};

/// The counts of GL_PROGRAM_NATIVE_*_ARB. `indirections` where the card has no phases.
[[nodiscard]] ResourceCounts countSlots(const SlotProgram &code, std::uint32_t indirections);

/// Words of a card for reportSlots().
struct SlotWords {
  const char *phase; ///< "phase"
  /// Why an opcode takes more than one slot: "SIN is a polynomial"; nullptr if it does not.
  const char *(*expansion)(ir::Opcode op);
};

/// Reasons, costs, nodes and the chain of dependent reads. Counts and cycles are the caller's.
void reportSlots(NativeReport &report, const ir::Program &program, const SlotProgram &code,
                 const SlotWords &words);

/// A line for each slot, with the instruction that it comes from: by its line in `text`, or by its
/// number, from 1, without.
[[nodiscard]] std::string listSlots(const ir::Program &program, const SlotProgram &code,
                                    const SlotWords &words, std::string_view text);

} // namespace arbiter::fp::hw
