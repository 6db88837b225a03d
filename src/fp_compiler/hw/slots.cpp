#include "fp_compiler/hw/slots.h"

#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/reasons.h"

namespace arbiter::fp::hw {

namespace {

constexpr auto kAlu = &ResourceCounts::aluInstructions;
constexpr auto kTex = &ResourceCounts::texInstructions;

std::uint32_t placeOf(const Slot &slot) {
  return slot.origin == kWholeProgram ? kNoInstruction : slot.origin;
}

/// Returns the reason for an ALU slot.
std::string aluText(const ir::Program &program, const Slot &slot, std::uint32_t slotsOfOrigin,
                    const SlotWords &words) {
  const std::string mnemonic =
      slot.origin == kWholeProgram ? "" : info(program.code[slot.origin].op).mnemonic;
  switch (slot.cause) {
  case SlotCause::Instruction:
    break;
  case SlotCause::Constant:
    return "one constant an instruction: another is moved to a register";
  case SlotCause::Attribute:
    return "one attribute an instruction: another is moved to a register";
  case SlotCause::Swizzle:
    return "constants and signs of a swizzle are a multiplication and an addition";
  case SlotCause::Coordinate:
    return "coordinate of " + mnemonic + " is not a plain register: a move";
  case SlotCause::Result:
    return "result of " + mnemonic + " is under a write mask: a move";
  case SlotCause::FogCoordinate:
    return "the w of fragment.fogcoord is made 1";
  case SlotCause::Depth:
    return "the depth is moved to where the chip takes it";
  case SlotCause::Fog:
    return "the fog option is blended in by instructions";
  case SlotCause::ColorSum:
    return "the secondary colour is added";
  }
  const char *expansion =
      slot.origin == kWholeProgram ? nullptr : words.expansion(program.code[slot.origin].op);
  return slotsOfOrigin > 1 && expansion != nullptr ? expansion : "instructions of one slot";
}

void slotReasons(Reasons &reasons, const ir::Program &program, const SlotProgram &code,
                 const SlotWords &words) {
  std::vector<std::uint32_t> slotsOf(program.code.size(), 0);
  for (const Slot &slot : code.slots)
    if (slot.origin != kWholeProgram && slot.cause == SlotCause::Instruction)
      ++slotsOf[slot.origin]; // both kinds: KIL may be an ALU and a texture slot
  for (const Slot &slot : code.slots) {
    if (slot.texture)
      reasons.add(kTex, 1,
                  info(program.code[slot.origin].op).has(ir::Kills) ? "KIL is a texture instruction"
                                                                    : "texture samples",
                  slot.origin);
    else
      reasons.add(
          kAlu, 1,
          aluText(program, slot, slot.origin == kWholeProgram ? 0 : slotsOf[slot.origin], words),
          placeOf(slot));
  }
}

std::string startText(const ir::Program &program, const PhaseStart &start, std::uint32_t phase,
                      const SlotWords &words) {
  const std::string mnemonic = info(program.code[start.sample].op).mnemonic;
  if (start.writer == kWholeProgram)
    return mnemonic + " samples into a result register";
  if (start.writer == start.sample)
    return mnemonic + " reads its coordinate, moved in " + words.phase + " " +
           std::to_string(phase);
  return dependencyText(program, start.sample, start.writer, words.phase, phase);
}

void resourceReasons(Reasons &reasons, const ir::Program &program, const SlotProgram &code,
                     const SlotWords &words) {
  const auto whole = [&](std::uint32_t ResourceCounts::*resource, std::uint32_t amount,
                         const char *text) {
    if (amount != 0)
      reasons.add(resource, amount, text, kNoInstruction);
  };
  if (code.phases != 0)
    whole(&ResourceCounts::texIndirections, 1, "every program has one");
  for (std::size_t i = 0; i < code.starts.size(); ++i)
    reasons.add(&ResourceCounts::texIndirections, 1,
                startText(program, code.starts[i], std::uint32_t(i + 1), words),
                code.starts[i].sample);
  whole(&ResourceCounts::temporaries, code.temporaries - code.scratch,
        code.halves ? "registers in use, two 16-bit ones in each" : "registers in use");
  whole(&ResourceCounts::temporaries, code.scratch, "a register for coordinates");
  whole(&ResourceCounts::parameters, code.parameters - code.ownConstants,
        "the program's own parameters and constants");
  whole(&ResourceCounts::parameters, code.ownConstants, "constants of the driver's own");
  whole(&ResourceCounts::attribs, code.attribs, "interpolated attributes");
}

void costs(NativeReport &report, const SlotProgram &code) {
  report.costs.assign(code.gone.size(), {});
  for (std::size_t i = 0; i < code.gone.size(); ++i)
    report.costs[i].gone = code.gone[i];
  for (const Slot &slot : code.slots) {
    if (slot.origin == kWholeProgram)
      continue;
    InstructionCost &cost = report.costs[slot.origin];
    if (slot.texture)
      ++cost.textures;
    else
      cost.slots += 1;
    cost.node = std::max(cost.node, slot.phase);
  }
}

} // namespace

ResourceCounts countSlots(const SlotProgram &code, std::uint32_t indirections) {
  ResourceCounts counts;
  for (const Slot &slot : code.slots)
    ++(slot.texture ? counts.texInstructions : counts.aluInstructions);
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = code.phases != 0 ? code.phases : indirections;
  counts.temporaries = code.temporaries;
  counts.parameters = code.parameters;
  counts.attribs = code.attribs;
  return counts;
}

void reportSlots(NativeReport &report, const ir::Program &program, const SlotProgram &code,
                 const SlotWords &words) {
  Reasons reasons;
  slotReasons(reasons, program, code, words);
  resourceReasons(reasons, program, code, words);
  report.reasons = reasons.take();
  costs(report, code);
  report.nodes.resize(code.phases);
  for (const Slot &slot : code.slots) {
    if (code.phases == 0)
      break;
    NodeReport &node = report.nodes[slot.phase];
    if (slot.texture)
      node.textures.push_back(slot.origin);
    else
      ++node.pairs;
  }
  for (std::size_t i = 0; i < code.starts.size(); ++i)
    report.nodes[i + 1].reason = startText(program, code.starts[i], std::uint32_t(i + 1), words);
  report.chain = longestChain(program, dataflowOf(program));
}

} // namespace arbiter::fp::hw
