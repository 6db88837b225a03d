#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/hw/native.h"
#include "fp_compiler/ir/ir.h"

/// A program for a card that runs one instruction after the other, as the models nv30/ and i915/
/// produce it. The R300's form is in r300/machine.h.
namespace arbiter::fp::hw {

inline constexpr std::uint16_t kWholeProgram = 0xFFFF;

/// The reason why a slot is in the program.
enum class SlotCause : std::uint8_t {
  Instruction,   ///< the IR instruction itself, or its part of a longer expansion
  Constant,      ///< a second constant of one instruction, moved to a register
  Attribute,     ///< a second attribute of one instruction, moved to a register
  Swizzle,       ///< constants 0 and 1, or differing signs, which an operand cannot have
  Coordinate,    ///< a coordinate moved to a plain register
  Result,        ///< a move that applies a sample's write mask
  FogCoordinate, ///< sets w of fragment.fogcoord, which the chip gets wrong
  Depth,         ///< moves the depth to where the chip reads it
  Fog,           ///< the fog option's blend
  ColorSum,      ///< the secondary colour added to the result
};

/// One instruction of the card.
struct Slot {
  bool texture = false;
  std::uint16_t origin = kWholeProgram; ///< index into ir::Program::code
  SlotCause cause = SlotCause::Instruction;
  std::uint8_t passes = 1;   ///< through the unit
  bool interpolated = false; ///< texture: the rasterizer supplies its coordinate
  std::uint32_t phase = 0;   ///< from 0; always 0 if the card has no phases
};

/// Describes the start of a phase other than the first: the sample that begins it, and what that
/// sample waited for.
struct PhaseStart {
  std::uint16_t sample = 0;
  /// The instruction that wrote the coordinate in the phase before. If it is the sample itself, the
  /// coordinate is moved first. If it is kWholeProgram, the sample writes a result register.
  std::uint16_t writer = kWholeProgram;
};

struct SlotProgram {
  std::vector<Slot> slots;
  std::vector<bool> gone; ///< by IR instruction: dropped as dead
  std::vector<PhaseStart> starts;
  std::uint32_t phases = 0; ///< 0 if the card has none
  std::uint32_t temporaries = 0;
  std::uint32_t scratch = 0;    ///< the registers for coordinates, which are part of temporaries
  std::uint32_t parameters = 0; ///< all, the driver's own constants included
  std::uint32_t ownConstants = 0;
  std::uint32_t attribs = 0;
  std::uint32_t interpolators = 0; ///< texture coordinate sets
  bool halves = false;             ///< registers have 16 bits a component, and two fit in one
};

/// Returns the counts of GL_PROGRAM_NATIVE_*_ARB.
/// \param indirections used if the card has no phases
[[nodiscard]] ResourceCounts countSlots(const SlotProgram &code, std::uint32_t indirections);

/// A card's terms, for reportSlots().
struct SlotWords {
  const char *phase; ///< "phase"
  /// Returns why an opcode takes more than one slot: "SIN is a polynomial"; nullptr if it takes
  /// one.
  const char *(*expansion)(ir::Opcode op);
};

/// Sets reasons, costs, nodes and the chain of dependent reads. The caller sets counts and cycles.
void reportSlots(NativeReport &report, const ir::Program &program, const SlotProgram &code,
                 const SlotWords &words);

/// Returns a line for each slot, with the instruction that it comes from. With a source text it
/// gives the instruction's line, otherwise its number, from 1.
[[nodiscard]] std::string listSlots(const ir::Program &program, const SlotProgram &code,
                                    const SlotWords &words, std::string_view text);

} // namespace arbiter::fp::hw
