#include "fp_compiler/hw/r300/report/report.h"

#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/hw/r300/report/wording.h"
#include "fp_compiler/hw/reasons.h"

namespace arbiter::fp::hw::r300 {

namespace {

constexpr auto kAlu = &ResourceCounts::aluInstructions;
constexpr auto kParameters = &ResourceCounts::parameters;

std::uint32_t placeOf(std::uint16_t origin) { return origin == kNone ? kNoInstruction : origin; }

/// Calls visit(origin, cause, in the RGB half, halves of a slot) for each operation of a pair. A
/// shared slot gives one half to each operation. An empty slot is whole and belongs to no
/// instruction.
template <typename Visit> void forOperations(const Pair &pair, Visit visit) {
  const bool rgb = pair.rgb.op != RgbOp::None, alpha = pair.alpha.op != AlphaOp::None;
  if (rgb)
    visit(pair.rgb.origin, pair.rgb.cause, true, alpha ? 1u : 2u);
  if (alpha)
    visit(pair.alpha.origin, pair.alpha.cause, false, rgb ? 1u : 2u);
  if (!rgb && !alpha)
    visit(pair.rgb.origin, pair.rgb.cause, true, 2u);
}

/// Finds for each instruction which slots are its own.
std::vector<Extent> extentsOf(const ir::Program &program, const Code &code) {
  struct Operations {
    std::uint32_t rgb = 0, alpha = 0, slots = 0, lastSlot = 0;
  };
  std::vector<Operations> operations(program.code.size());
  for (std::uint32_t i = 0; i < code.pairs.size(); ++i) {
    forOperations(code.pairs[i], [&](std::uint16_t origin, Cause cause, bool rgb, std::uint32_t) {
      if (origin == kNone || cause != Cause::Instruction)
        return;
      Operations &own = operations[origin];
      ++(rgb ? own.rgb : own.alpha);
      own.slots += own.lastSlot == i + 1 ? 0 : 1;
      own.lastSlot = i + 1;
    });
  }
  std::vector<Extent> extents(program.code.size(), Extent::OneSlot);
  for (std::size_t i = 0; i < operations.size(); ++i)
    if (operations[i].slots > 1)
      extents[i] = operations[i].rgb <= 1 && operations[i].alpha <= 1 ? Extent::HalvesApart
                                                                      : Extent::Expansion;
  return extents;
}

/// A reason, with its amount in half slots.
struct Share {
  std::string text;
  std::uint32_t halves = 0;
  std::vector<std::uint32_t> places;
};

/// Rounds the reasons to whole slots that add up to the code's. Of the reasons with an odd half,
/// one in two is rounded up. Those of a single half come first.
std::vector<std::uint32_t> wholeSlots(const std::vector<Share> &shares, std::uint32_t total) {
  std::vector<std::uint32_t> slots;
  std::uint32_t given = 0;
  for (const Share &share : shares)
    given += slots.emplace_back(share.halves / 2);
  for (const bool alone : {true, false})
    for (std::size_t i = 0; i < shares.size() && given < total; ++i)
      if (shares[i].halves % 2 == 1 && (shares[i].halves == 1) == alone) {
        ++slots[i];
        ++given;
      }
  return slots;
}

void addAlu(Reasons &reasons, const ir::Program &program, const Code &code) {
  const std::vector<Extent> extents = extentsOf(program, code);
  std::vector<Share> shares;
  for (const Pair &pair : code.pairs) {
    forOperations(pair, [&](std::uint16_t origin, Cause cause, bool, std::uint32_t halves) {
      std::string text =
          aluText(program, origin, cause, origin == kNone ? Extent::OneSlot : extents[origin]);
      auto share = std::find_if(shares.begin(), shares.end(),
                                [&](const Share &other) { return other.text == text; });
      if (share == shares.end())
        share = shares.insert(shares.end(), {std::move(text), 0, {}});
      share->halves += halves;
      if (origin != kNone)
        share->places.push_back(origin);
    });
  }
  const std::vector<std::uint32_t> slots = wholeSlots(shares, std::uint32_t(code.pairs.size()));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (slots[i] == 0)
      continue; // its half slot is counted under another reason
    reasons.add(kAlu, slots[i], shares[i].text, kNoInstruction);
    for (const std::uint32_t place : shares[i].places)
      reasons.add(kAlu, 0, shares[i].text, place);
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

/// Returns the node of the pair or texture at an index of its array.
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
    const std::uint32_t node = nodeOf(code, i, &Node::firstPair, &Node::pairs);
    forOperations(code.pairs[i], [&](std::uint16_t origin, Cause, bool, std::uint32_t halves) {
      charge(origin, node, halves / 2.0, false);
    });
  }
  for (std::uint32_t i = 0; i < code.textures.size(); ++i)
    charge(code.textures[i].origin, nodeOf(code, i, &Node::firstTexture, &Node::textures), 0, true);
  for (std::size_t i = 0; i < seen.size(); ++i)
    report.costs[i].gone = !seen[i];
}

/// The last writer of a register before a node, and the node it is in.
struct Written {
  std::uint16_t origin = kNone;
  Cause cause = Cause::Instruction;
  std::uint32_t node = 0;
  bool found = false;
};

Written lastWrite(const Code &code, std::uint32_t before, std::uint16_t temporary) {
  for (std::uint32_t n = before; n-- > 0;) {
    const Node &node = code.nodes[n];
    for (std::uint32_t i = node.pairs; i-- > 0;) {
      const Pair &pair = code.pairs[node.firstPair + i];
      if (pair.rgb.op != RgbOp::None && pair.rgb.temporary == temporary && pair.rgb.mask != 0)
        return {pair.rgb.origin, pair.rgb.cause, n, true};
      if (pair.alpha.op != AlphaOp::None && pair.alpha.temporary == temporary &&
          pair.alpha.mask != 0)
        return {pair.alpha.origin, pair.alpha.cause, n, true};
    }
    for (std::uint32_t i = node.textures; i-- > 0;)
      if (code.textures[node.firstTexture + i].destination == temporary)
        return {code.textures[node.firstTexture + i].origin, Cause::Instruction, n, true};
  }
  return {};
}

/// Returns why a node cannot be part of the one before it: its sample that waits for the latest
/// node.
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
    return std::string(info(program.code[sample].op).mnemonic) + " reads its coordinate, " +
           (latest.cause == Cause::Rectangle ? "scaled" : "moved") + " in node " +
           std::to_string(latest.node + 1);
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
