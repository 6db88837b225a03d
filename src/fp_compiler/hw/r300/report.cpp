#include "fp_compiler/hw/r300/report.h"

#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/r300/wording.h"
#include "fp_compiler/hw/reasons.h"

namespace arbiter::fp::hw::r300 {

namespace {

constexpr auto kAlu = &ResourceCounts::aluInstructions;
constexpr auto kParameters = &ResourceCounts::parameters;

/// Whose a slot is: an operation's origin and cause. A pair is its RGB half's, or its alpha half's
/// where the RGB half is idle; so that the parts of a count add up to it.
struct Owner {
  std::uint16_t origin = kNone;
  Cause cause = Cause::Instruction;
};

Owner ownerOf(const Pair &pair) {
  if (pair.rgb.op != RgbOp::None)
    return {pair.rgb.origin, pair.rgb.cause};
  return {pair.alpha.origin, pair.alpha.cause};
}

std::uint32_t placeOf(std::uint16_t origin) { return origin == kNone ? kNoInstruction : origin; }

/// Operations that are an instruction's own, by instruction.
struct Operations {
  std::uint32_t rgb = 0, alpha = 0, slots = 0;
};

std::vector<Operations> operationsOf(const ir::Program &program, const Code &code) {
  std::vector<Operations> operations(program.code.size());
  const auto count = [&](bool there, std::uint16_t origin, Cause cause,
                         std::uint32_t Operations::*half) {
    if (there && origin != kNone && cause == Cause::Instruction)
      ++(operations[origin].*half);
  };
  for (const Pair &pair : code.pairs) {
    count(pair.rgb.op != RgbOp::None, pair.rgb.origin, pair.rgb.cause, &Operations::rgb);
    count(pair.alpha.op != AlphaOp::None, pair.alpha.origin, pair.alpha.cause, &Operations::alpha);
    const Owner owner = ownerOf(pair);
    count(true, owner.origin, owner.cause, &Operations::slots);
  }
  return operations;
}

void addAlu(Reasons &reasons, const ir::Program &program, const Code &code) {
  const std::vector<Operations> operations = operationsOf(program, code);
  for (const Pair &pair : code.pairs) {
    const Owner owner = ownerOf(pair);
    Extent extent = Extent::OneSlot;
    if (owner.origin != kNone && operations[owner.origin].slots > 1) {
      const Operations &own = operations[owner.origin];
      extent = own.rgb <= 1 && own.alpha <= 1 ? Extent::HalvesApart : Extent::Expansion;
    }
    reasons.add(kAlu, 1, aluText(program, owner.origin, owner.cause, extent),
                placeOf(owner.origin));
  }
}

void addTextures(Reasons &reasons, const Code &code) {
  for (const Texture &texture : code.textures)
    reasons.add(&ResourceCounts::texInstructions, 1,
                texture.op == TexOp::Kill ? "KIL is a texture instruction" : "texture samples",
                placeOf(texture.origin));
}

void addNodes(Reasons &reasons, const NativeReport &report) {
  reasons.add(&ResourceCounts::texIndirections, 1, "every program has a node", kNoInstruction);
  for (std::size_t i = 1; i < report.nodes.size(); ++i) {
    const NodeReport &node = report.nodes[i];
    reasons.add(&ResourceCounts::texIndirections, 1, node.reason,
                node.textures.empty() ? kNoInstruction : node.textures.front());
  }
}

void addRegisters(Reasons &reasons, const ir::Program &program, const Code &code) {
  const auto preloaded = std::uint32_t(code.interpolants.size());
  for (const Interpolant &interpolant : code.interpolants)
    reasons.add(&ResourceCounts::attribs, 1,
                interpolantName(program, interpolant.attribute) + " is interpolated",
                kNoInstruction);
  if (code.interpolators > kInterpolators)
    reasons.add(&ResourceCounts::attribs, 0,
                "position and fog take a texture coordinate's interpolator each: " +
                    std::to_string(code.interpolators) + " of " + std::to_string(kInterpolators) +
                    " are needed",
                kNoInstruction);
  const std::uint32_t ofInterpolants = std::min(preloaded, code.temporaries);
  if (ofInterpolants != 0)
    reasons.add(&ResourceCounts::temporaries, ofInterpolants, "interpolants arrive in temporaries",
                kNoInstruction);
  if (code.temporaries > ofInterpolants)
    reasons.add(&ResourceCounts::temporaries, code.temporaries - ofInterpolants,
                "values that are live at once", kNoInstruction);
}

void addConstants(Reasons &reasons, const ir::Program &program, const Code &code) {
  for (const Constant &constant : code.constants)
    reasons.add(kParameters, 1, constantText(program, constant),
                constant.kind == Constant::Kind::Parameter ? kNoInstruction
                                                           : placeOf(constant.origin));
}

/// The node of the pair or texture at an index of its array.
std::uint32_t nodeOf(const Code &code, std::uint32_t index, std::uint32_t Node::*first,
                     std::uint32_t Node::*count) {
  for (std::size_t i = 0; i < code.nodes.size(); ++i)
    if (index - code.nodes[i].*first < code.nodes[i].*count)
      return std::uint32_t(i);
  return 0;
}

void costs(NativeReport &report, const ir::Program &program, const Code &code) {
  report.costs.assign(program.code.size(), {});
  std::vector<bool> seen(program.code.size(), false);
  const auto charge = [&](std::uint16_t origin, std::uint32_t node, double slots, bool texture) {
    if (origin == kNone)
      return;
    InstructionCost &cost = report.costs[origin];
    cost.slots += slots;
    cost.textures += texture ? 1 : 0;
    cost.node = std::max(cost.node, node);
    seen[origin] = true;
  };
  for (std::uint32_t i = 0; i < code.pairs.size(); ++i) {
    const Pair &pair = code.pairs[i];
    const std::uint32_t node = nodeOf(code, i, &Node::firstPair, &Node::pairs);
    const bool rgb = pair.rgb.op != RgbOp::None, alpha = pair.alpha.op != AlphaOp::None;
    if (rgb)
      charge(pair.rgb.origin, node, alpha ? 0.5 : 1, false);
    if (alpha)
      charge(pair.alpha.origin, node, rgb ? 0.5 : 1, false);
  }
  for (std::uint32_t i = 0; i < code.textures.size(); ++i)
    charge(code.textures[i].origin, nodeOf(code, i, &Node::firstTexture, &Node::textures), 0, true);
  for (std::size_t i = 0; i < seen.size(); ++i)
    report.costs[i].gone = !seen[i];
}

/// Who writes a register last before a node, and in which node.
struct Written {
  std::uint16_t origin = kNone;
  std::uint32_t node = 0;
  bool found = false;
};

Written lastWrite(const Code &code, std::uint32_t before, std::uint16_t temporary) {
  for (std::uint32_t n = before; n-- > 0;) {
    const Node &node = code.nodes[n];
    for (std::uint32_t i = node.pairs; i-- > 0;) {
      const Pair &pair = code.pairs[node.firstPair + i];
      if (pair.rgb.op != RgbOp::None && pair.rgb.temporary == temporary && pair.rgb.mask != 0)
        return {pair.rgb.origin, n, true};
      if (pair.alpha.op != AlphaOp::None && pair.alpha.temporary == temporary &&
          pair.alpha.mask != 0)
        return {pair.alpha.origin, n, true};
    }
    for (std::uint32_t i = node.textures; i-- > 0;)
      if (code.textures[node.firstTexture + i].destination == temporary)
        return {code.textures[node.firstTexture + i].origin, n, true};
  }
  return {};
}

/// Why a node is one of its own: the sample that waits for the latest node.
std::string nodeReason(const ir::Program &program, const Code &code, std::uint32_t index) {
  const Node &node = code.nodes[index];
  std::uint16_t sample = kNone;
  Written latest;
  for (std::uint32_t i = 0; i < node.textures; ++i) {
    const Texture &texture = code.textures[node.firstTexture + i];
    const Written written = lastWrite(code, index, texture.source);
    if (texture.origin == kNone || !written.found || written.origin == kNone)
      continue;
    if (sample == kNone || written.node > latest.node) {
      latest = written;
      sample = texture.origin;
    }
  }
  if (sample == kNone)
    return "its samples read what the nodes before it made";
  if (sample == latest.origin)
    return std::string(info(program.code[sample].op).mnemonic) +
           " reads a move of its coordinate in node " + std::to_string(latest.node + 1);
  return dependencyText(program, sample, latest.origin, "node", latest.node + 1);
}

void nodes(NativeReport &report, const ir::Program &program, const Code &code) {
  report.nodes.resize(code.nodes.size());
  for (std::uint32_t n = 0; n < code.nodes.size(); ++n) {
    NodeReport &node = report.nodes[n];
    node.pairs = code.nodes[n].pairs;
    for (std::uint32_t i = 0; i < code.nodes[n].textures; ++i) {
      const std::uint16_t origin = code.textures[code.nodes[n].firstTexture + i].origin;
      if (origin != kNone)
        node.textures.push_back(origin);
    }
    std::sort(node.textures.begin(), node.textures.end());
    if (n > 0)
      node.reason = nodeReason(program, code, n);
  }
}

} // namespace

ResourceCounts counts(const Code &code) {
  ResourceCounts counts;
  counts.aluInstructions = std::uint32_t(code.pairs.size());
  counts.texInstructions = std::uint32_t(code.textures.size());
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = std::max(1u, std::uint32_t(code.nodes.size()));
  counts.temporaries = code.temporaries;
  counts.parameters = std::uint32_t(code.constants.size());
  counts.attribs = std::uint32_t(code.interpolants.size());
  return counts;
}

void report(NativeReport &report, const ir::Program &program, const Code &code) {
  nodes(report, program, code);
  costs(report, program, code);
  Reasons reasons;
  addAlu(reasons, program, code);
  addTextures(reasons, code);
  addNodes(reasons, report);
  addRegisters(reasons, program, code);
  addConstants(reasons, program, code);
  report.reasons = reasons.take();
  report.chain = longestChain(program, dataflowOf(program));
}

} // namespace arbiter::fp::hw::r300
