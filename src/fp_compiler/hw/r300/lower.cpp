#include "fp_compiler/hw/r300/lower.h"

#include <cmath>
#include <numbers>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw::r300 {

namespace {
using ir::Opcode;

constexpr float kInverseTurn = float(0.5 / std::numbers::pi);
/// Of the second parabola in s + p*(s|s| - s): the error of the sine stays below 0.00095.
constexpr float kSharpness = 0.2248f;
constexpr float kLitLimit = 128.0f - 0x1p-17f;

class Lowering {
public:
  Lowering(const ir::Program &program, const CompileOptions &options, Flow &flow)
      : m_program(program), m_options(options), m_flow(flow),
        m_emit(program, program.temporaries.size() + program.outputs.size(), flow),
        m_attributes(program.attributes.size()), m_masks(program.code.size(), 0) {}

  void run() {
    liveMasks();
    for (std::size_t i = 0; i < m_program.code.size(); ++i)
      if (m_masks[i] || ir::info(m_program.code[i].op).has(ir::Kills))
        instruction(i);
    epilogue();
    outputs();
  }

private:
  [[nodiscard]] Home homeOf(const ir::Destination &dst) const {
    return dst.file == ir::File::Output ? Home(m_program.temporaries.size()) + dst.index
                                        : dst.index;
  }
  [[nodiscard]] bool isDepth(const ir::Destination &dst) const {
    return dst.file == ir::File::Output &&
           m_program.outputs[dst.index].kind == ir::OutputKind::Depth;
  }

  /// The components of each instruction's result that somebody reads.
  void liveMasks() {
    std::vector<std::uint8_t> live(m_program.temporaries.size() + m_program.outputs.size(), 0);
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      live[m_program.temporaries.size() + i] = ir::resultMask(m_program.outputs[i].kind);
    for (std::size_t at = m_program.code.size(); at-- > 0;) {
      ir::Instruction instruction = m_program.code[at];
      const ir::OpInfo &row = ir::info(instruction.op);
      if (!row.has(ir::Kills)) {
        std::uint8_t &home = live[homeOf(instruction.dst)];
        instruction.dst.mask &= home;
        m_masks[at] = instruction.dst.mask;
        if (instruction.dst.mask == 0)
          continue;
        home &= std::uint8_t(~instruction.dst.mask);
      }
      for (int i = 0; i < row.operandCount(); ++i)
        if (instruction.src[std::size_t(i)].file == ir::File::Temporary)
          live[instruction.src[std::size_t(i)].index] |= ir::registerMask(instruction, i);
    }
  }

  /// fragment.position of the clip position: (x/w, y/w, z/w) * scale + offset, and 1/w.
  Refs position(std::uint16_t attribute) {
    const Value clip = valueOf(m_emit.interpolant(attribute));
    How how;
    how.cause = Cause::Position;
    const Value inverse = m_emit.scalar(AlphaOp::Rcp, 8, clip, how);
    const Value device = m_emit.mad(7, clip, inverse, literals(-0.0f), how);
    const Value window = m_emit.mad(7, device, row(Constant::Kind::ViewportScale, 0),
                                    row(Constant::Kind::ViewportOffset, 0), how);
    Refs refs = window.direct;
    refs[3] = inverse.direct[3];
    return refs;
  }

  Value row(Constant::Kind kind, std::uint16_t index) {
    return rowValue(m_emit.rows().own(kind, index, m_emit.origin()));
  }
  static Value rowValue(std::uint16_t index) {
    Refs refs;
    for (std::uint8_t c = 0; c < 4; ++c)
      refs[c] = {Ref::Kind::Row, c, false, false, index, 0.0f};
    return valueOf(refs);
  }

  const Value &attribute(std::uint16_t index) {
    Attribute &attribute = m_attributes[index];
    if (!attribute.loaded) {
      attribute.loaded = true;
      attribute.value = valueOf(m_program.attributes[index].kind == ir::AttributeKind::Position
                                    ? position(index)
                                    : m_emit.interpolant(index));
    }
    return attribute.value;
  }

  Value parameter(std::uint16_t index) {
    const ir::Parameter &parameter = m_program.parameters[index];
    if (parameter.kind != ir::ParameterKind::Constant)
      return rowValue(m_emit.rows().parameter(index, m_emit.origin()));
    Refs refs;
    for (std::uint8_t c = 0; c < 4; ++c)
      refs[c] = {Ref::Kind::Literal, c, false, false, index, parameter.constant[c]};
    return valueOf(refs);
  }

  Value whole(const ir::Operand &operand) {
    switch (operand.file) {
    case ir::File::Attribute:
      return attribute(operand.index);
    case ir::File::Parameter:
      return parameter(operand.index);
    case ir::File::Temporary:
      return m_emit.current(operand.index);
    case ir::File::Output:
    case ir::File::Address:
      break; // validate() reports it
    }
    return literals(0.0f);
  }

  Value read(const ir::Operand &operand) {
    const Value source = whole(operand);
    Value value;
    for (std::size_t c = 0; c < 4; ++c) {
      const ir::Select select = operand.swizzle[c];
      if (select >= ir::Select::Zero) {
        value.direct[c] = value.through[c] = literal(select == ir::Select::One ? 1.0f : 0.0f);
      } else {
        value.direct[c] = source.direct[std::size_t(select)];
        const Ref &behind = source.through[std::size_t(select)];
        value.through[c] = m_emit.readable(behind) ? behind : value.direct[c];
      }
      if (operand.negate >> c & 1) {
        value.direct[c] = negated(value.direct[c]);
        value.through[c] = negated(value.through[c]);
      }
    }
    return value;
  }

  static Ref absoluteOf(Ref ref) {
    if (ref.kind == Ref::Kind::Literal) {
      ref.value = std::fabs(ref.value);
    } else {
      ref.absolute = true;
      ref.negate = false;
    }
    return ref;
  }

  /// A copy: written, and readable behind.
  Value copied(std::uint8_t mask, const Value &value, const How &how) {
    Value result = m_emit.copy(mask, value, how);
    if (!how.clamp)
      result.through = value.through;
    return result;
  }

  void instruction(std::size_t at) {
    const ir::Instruction &instruction = m_program.code[at];
    const ir::OpInfo &row = ir::info(instruction.op);
    const bool kills = row.has(ir::Kills);
    const Home home = kills ? kNoHome : homeOf(instruction.dst);
    m_emit.begin(std::uint16_t(at), home);
    std::array<Value, 3> operands;
    for (int i = 0; i < row.operandCount(); ++i)
      operands[std::size_t(i)] = read(instruction.src[std::size_t(i)]);
    if (kills) {
      (void)m_emit.texture(TexOp::Kill, instruction, 0xF, operands[0], 0, false);
      return;
    }
    How how;
    how.home = true;
    how.clamp = instruction.dst.saturate;
    std::uint8_t mask = m_masks[at];
    if (isDepth(instruction.dst)) {
      depth(instruction, operands, how);
      return;
    }
    const Value result = row.has(ir::Texture) ? sampled(instruction, mask, operands[0], how)
                                              : computed(instruction.op, mask, operands, how);
    m_emit.set(home, mask, result);
  }

  /// The alpha half writes depth: what is computed for z is computed in w.
  void depth(const ir::Instruction &instruction, std::array<Value, 3> &operands, const How &how) {
    const ir::OpInfo &row = ir::info(instruction.op);
    Value result;
    if (row.has(ir::PerComponent) || row.has(ir::Replicates)) {
      if (row.has(ir::PerComponent))
        for (Value &operand : operands)
          operand = broadcast(operand, 2);
      result = computed(instruction.op, 8, operands, how);
    } else {
      How own;
      const Value whole = row.has(ir::Texture) ? sampled(instruction, 4, operands[0], own)
                                               : computed(instruction.op, 4, operands, own);
      result = copied(8, broadcast(whole, 2), how);
    }
    m_emit.set(homeOf(instruction.dst), 8, result);
  }

  Value computed(Opcode op, std::uint8_t mask, const std::array<Value, 3> &s, const How &how) {
    const Value one = literals(1.0f), none = literals(-0.0f);
    const std::span<const Value> all(s);
    switch (op) {
    case Opcode::Abs: {
      Value value = s[0];
      for (std::size_t c = 0; c < 4; ++c) {
        value.direct[c] = absoluteOf(value.direct[c]);
        value.through[c] = absoluteOf(value.through[c]);
      }
      return copied(mask, value, how);
    }
    case Opcode::Mov:
    case Opcode::Swz:
      return copied(mask, s[0], how);
    case Opcode::Add:
      return m_emit.mad(mask, s[0], one, s[1], how);
    case Opcode::Sub:
      return m_emit.mad(mask, s[0], one, negated(s[1]), how);
    case Opcode::Mul:
      return m_emit.mad(mask, s[0], s[1], none, how);
    case Opcode::Mad:
      return m_emit.mad(mask, s[0], s[1], s[2], how);
    case Opcode::Lrp:
      return m_emit.lerp(mask, s[0], s[1], s[2], how);
    case Opcode::Cmp: {
      const std::array<Value, 3> operands = {s[2], s[1], s[0]};
      return m_emit.componentwise(RgbOp::Cmp, AlphaOp::Cmp, mask, operands, how);
    }
    case Opcode::Min:
      return m_emit.componentwise(RgbOp::Min, AlphaOp::Min, mask, all.first(2), how);
    case Opcode::Max:
      return m_emit.componentwise(RgbOp::Max, AlphaOp::Max, mask, all.first(2), how);
    case Opcode::Frc:
      return m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, mask, all.first(1), how);
    case Opcode::Flr: {
      const Value rest = m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, mask, all.first(1), {});
      return m_emit.mad(mask, s[0], one, negated(rest), how);
    }
    case Opcode::Sge:
      return m_emit.compare(mask, s[0], s[1], 0.0f, 1.0f, how);
    case Opcode::Slt:
      return m_emit.compare(mask, s[0], s[1], 1.0f, 0.0f, how);
    case Opcode::Dp3:
      return m_emit.dot(RgbOp::Dp3, mask, s[0], s[1], how);
    case Opcode::Dp4:
      return m_emit.dot(RgbOp::Dp4, mask, s[0], s[1], how);
    case Opcode::Dph: {
      Value first = s[0];
      first.direct[3] = first.through[3] = literal(1.0f);
      return m_emit.dot(RgbOp::Dp4, mask, first, s[1], how);
    }
    case Opcode::Ex2:
      return m_emit.scalar(AlphaOp::Ex2, mask, s[0], how);
    case Opcode::Lg2:
      return m_emit.scalar(AlphaOp::Lg2, mask, s[0], how);
    case Opcode::Rcp:
      return m_emit.scalar(AlphaOp::Rcp, mask, s[0], how);
    case Opcode::Rsq:
      return m_emit.scalar(AlphaOp::Rsq, mask, s[0], how);
    case Opcode::Pow: {
      const Value logarithm = m_emit.scalar(AlphaOp::Lg2, 8, s[0], {});
      return m_emit.scalar(AlphaOp::Ex2, mask, m_emit.mad(8, logarithm, s[1], none, {}), how);
    }
    case Opcode::Sin:
      return turned(8, mask, s[0], literals(0.5f), how);
    case Opcode::Cos:
      return turned(8, mask, s[0], literals(0.75f), how);
    case Opcode::Scs: {
      Value phase = literals(0.5f);
      phase.direct[0] = phase.through[0] = literal(0.75f);
      Value result;
      if (mask & 3)
        result = turned(mask & 3, mask & 3, s[0], phase, how);
      return with(result, mask & 12, literals(0.0f), how);
    }
    case Opcode::Xpd: {
      const auto rotated = [](const Value &value, bool left) {
        Value result = value;
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t from = (c + (left ? 1 : 2)) % 3;
          result.direct[c] = value.direct[from];
          result.through[c] = value.through[from];
        }
        return result;
      };
      Value result;
      if (const auto rgb = std::uint8_t(mask & 7)) {
        const Value second = m_emit.mad(rgb, rotated(s[0], false), rotated(s[1], true), none, {});
        result = m_emit.mad(rgb, rotated(s[0], true), rotated(s[1], false), negated(second), how);
      }
      return with(result, mask & 8, literals(0.0f), how);
    }
    case Opcode::Dst: {
      Value result;
      if (mask & 2)
        result = m_emit.mad(2, s[0], s[1], none, how);
      result = with(result, mask & 4, s[0], how);
      result = with(result, mask & 8, s[1], how);
      return with(result, mask & 1, one, how);
    }
    case Opcode::Lit:
      return lit(mask, s[0], how);
    case Opcode::Tex:
    case Opcode::Txp:
    case Opcode::Txb:
    case Opcode::Kil:
    case Opcode::Arl:
    case Opcode::Exp:
    case Opcode::Log:
      break; // not arithmetic, or not of a fragment language
    }
    return literals(0.0f);
  }

  /// \p result with a copy of \p value in \p mask.
  Value with(Value result, int mask, const Value &value, const How &how) {
    if (mask == 0)
      return result;
    const Value copy = copied(std::uint8_t(mask), value, how);
    for (std::size_t c = 0; c < 4; ++c)
      if (mask >> c & 1) {
        result.direct[c] = copy.direct[c];
        result.through[c] = copy.through[c];
      }
    return result;
  }

  /// sin(2 pi (x / 2 pi + phase - 1/2)): FRC brings the angle into one turn, one parabola is within
  /// 0.06 of the sine, a second one mends it. \p work: components that it is computed in.
  Value turned(std::uint8_t work, std::uint8_t mask, const Value &x, const Value &phase,
               const How &how) {
    const Value turn = m_emit.mad(work, x, literals(kInverseTurn), phase, {});
    const Value f =
        m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, work, std::span<const Value>(&turn, 1), {});
    Value s = m_emit.arch(work, f, {});
    Value size = s;
    for (std::size_t c = 0; c < 4; ++c)
      size.direct[c] = size.through[c] = absoluteOf(s.direct[c]);
    Value bend = m_emit.mad(work, s, size, negated(s), {});
    if (work == 8) {
      s = broadcast(s, 3);
      bend = broadcast(bend, 3);
    }
    return m_emit.mad(mask, bend, literals(kSharpness), s, how);
  }

  Value lit(std::uint8_t mask, const Value &s, const How &how) {
    const Value zero = literals(0.0f), x = broadcast(s, 0);
    Value result;
    if (mask & 4) {
      const std::array<Value, 2> high = {broadcast(s, 3), literals(kLitLimit)};
      const std::array<Value, 2> low = {m_emit.componentwise(RgbOp::Min, AlphaOp::Min, 1, high, {}),
                                        literals(-kLitLimit)};
      const Value exponent = m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 1, low, {});
      const std::array<Value, 2> base = {broadcast(s, 1), zero};
      const Value logarithm = m_emit.scalar(
          AlphaOp::Lg2, 8, m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 8, base, {}), {});
      const Value product = m_emit.mad(8, logarithm, broadcast(exponent, 0), literals(-0.0f), {});
      const Value power = m_emit.scalar(AlphaOp::Ex2, 8, product, {});
      const std::array<Value, 3> choice = {zero, broadcast(power, 3), negated(x)};
      const Value z = m_emit.componentwise(RgbOp::Cmp, AlphaOp::Cmp, 4, choice, how);
      result.direct[2] = result.through[2] = z.direct[2];
    }
    if (mask & 2) {
      const std::array<Value, 2> diffuse = {x, zero};
      const Value y = m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 2, diffuse, how);
      result.direct[1] = result.through[1] = y.direct[1];
    }
    return with(result, mask & 9, literals(1.0f), how);
  }

  Value sampled(const ir::Instruction &instruction, std::uint8_t mask, const Value &operand,
                const How &how) {
    ir::Instruction trimmed = instruction;
    trimmed.dst.mask = mask;
    const std::uint8_t coordinates = ir::operandMask(trimmed, 0);
    const bool rectangle = instruction.target == ir::TexTarget::Rect ||
                           instruction.target == ir::TexTarget::ShadowRect;
    How own;
    Value coordinate = operand;
    if (rectangle && m_options.scaleRectangles) {
      own.cause = Cause::Rectangle;
      coordinate =
          m_emit.mad(coordinates, operand, row(Constant::Kind::RectangleScale, instruction.unit),
                     literals(-0.0f), own);
    }
    const TexOp op = instruction.op == Opcode::Txp   ? TexOp::Project
                     : instruction.op == Opcode::Txb ? TexOp::Bias
                                                     : TexOp::Load;
    const bool shadow = ir::isShadow(instruction.target);
    const bool plain =
        !shadow && how.home && !how.clamp && instruction.dst.file == ir::File::Temporary;
    const Refs texel = m_emit.texture(op, instruction, coordinates, coordinate,
                                      std::uint8_t(plain ? mask : 0), plain);
    if (plain)
      return valueOf(texel);
    How last = how;
    last.cause = Cause::TextureResult;
    if (!shadow)
      return copied(mask, valueOf(texel), last);
    last.clamp = false;
    return copied(mask, broadcast(lit(texel, operand, op), 2), last);
  }

  /// Whether the reference is within the depth that was sampled: 1 or 0, in z.
  Value lit(const Refs &texel, const Value &coordinate, TexOp op) {
    How own;
    own.cause = Cause::TextureResult;
    Value reference = coordinate;
    if (op == TexOp::Project)
      reference =
          m_emit.mad(4, coordinate, broadcast(m_emit.scalar(AlphaOp::Rcp, 8, coordinate, own), 3),
                     literals(-0.0f), own);
    return m_emit.compare(4, valueOf(texel), reference, 0.0f, 1.0f, own);
  }

  [[nodiscard]] bool isColour(std::size_t output) const {
    return m_program.outputs[output].kind == ir::OutputKind::Color;
  }
  [[nodiscard]] Home outputHome(std::size_t output) const {
    return Home(m_program.temporaries.size() + output);
  }

  std::uint16_t attributeOf(ir::AttributeKind kind, std::uint16_t otherwise) const {
    for (std::size_t i = 0; i < m_program.attributes.size(); ++i)
      if (m_program.attributes[i].kind == kind)
        return std::uint16_t(i);
    return otherwise;
  }
  Value optional(ir::AttributeKind kind, std::uint16_t otherwise) {
    const std::uint16_t index = attributeOf(kind, otherwise);
    return index == otherwise ? valueOf(m_emit.interpolant(index)) : attribute(index);
  }

  /// A result as it is, clamped: nobody but the options reads it, so that the operations which make
  /// it can clamp.
  Value clamped(Home home, std::uint8_t mask) {
    Value value = m_emit.current(home);
    bool inPlace = true;
    for (std::size_t c = 0; c < 4; ++c) {
      const Ref &ref = value.direct[c];
      if ((mask >> c & 1) && ref.kind == Ref::Kind::Item)
        inPlace &= !m_flow.items[ref.index].replicated || mask == 15;
    }
    value.through = value.direct;
    if (!inPlace) {
      How how;
      how.home = true;
      how.clamp = true;
      how.cause = Cause::Output;
      return m_emit.copy(mask, value, how);
    }
    for (std::size_t c = 0; c < 4; ++c)
      if ((mask >> c & 1) && value.direct[c].kind == Ref::Kind::Item)
        m_flow.items[value.direct[c].index].clamp = true;
    return value;
  }

  void epilogue() {
    const ir::Options &options = m_program.options;
    if (options.colorSum) {
      const Value secondary = optional(ir::AttributeKind::ColorSecondary, kSecondaryColour);
      for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
        if (isColour(i)) {
          How how;
          how.home = true;
          how.cause = Cause::Output;
          m_emit.begin(kNone, outputHome(i));
          const Value colour = clamped(outputHome(i), 7);
          m_emit.begin(kNone, outputHome(i));
          m_emit.set(outputHome(i), 7, m_emit.mad(7, colour, literals(1.0f), secondary, how));
        }
    }
    if (options.fog != ir::FogMode::None)
      fog();
  }

  Value fogFactor() {
    const Value coordinate = broadcast(optional(ir::AttributeKind::FogCoord, kFogCoordinate), 0);
    const Value factors = row(Constant::Kind::FogFactors, 0);
    How how, last;
    how.cause = last.cause = Cause::Fog;
    last.clamp = true;
    const Value none = literals(-0.0f);
    switch (m_program.options.fog) {
    case ir::FogMode::None:
      break;
    case ir::FogMode::Linear:
      return m_emit.mad(8, coordinate, broadcast(factors, 0), broadcast(factors, 1), last);
    case ir::FogMode::Exp:
      return m_emit.scalar(AlphaOp::Ex2, 8,
                           m_emit.mad(8, coordinate, broadcast(factors, 2), none, how), last);
    case ir::FogMode::Exp2: {
      const Value scaled = m_emit.mad(8, coordinate, broadcast(factors, 3), none, how);
      return m_emit.scalar(AlphaOp::Ex2, 8, m_emit.mad(8, scaled, negated(scaled), none, how),
                           last);
    }
    }
    return literals(1.0f);
  }

  void fog() {
    m_emit.begin(kNone, kNoHome);
    const Value factor = broadcast(fogFactor(), 3);
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      if (isColour(i)) {
        How how;
        how.home = true;
        how.cause = Cause::Fog;
        m_emit.begin(kNone, outputHome(i));
        const Value colour = clamped(outputHome(i), 15);
        m_emit.set(outputHome(i), 15, colour);
        m_emit.begin(kNone, outputHome(i));
        m_emit.set(outputHome(i), 7,
                   m_emit.lerp(7, factor, colour, row(Constant::Kind::FogColor, 0), how));
      }
  }

  /// Lets the operations that make results write them.
  void outputs() {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
      const Value &value = m_emit.current(outputHome(i));
      if (!isColour(i)) {
        depthOutput(value);
        continue;
      }
      for (std::uint8_t c = 0; c < 4; ++c)
        if (!write(value.through[c], m_program.outputs[i].index, c))
          (void)write(value.direct[c], m_program.outputs[i].index, c);
    }
  }

  bool write(const Ref &ref, std::uint8_t target, std::uint8_t component) {
    if (ref.kind != Ref::Kind::Item || ref.negate || ref.absolute)
      return false;
    Item &item = m_flow.items[ref.index];
    if (!item.isAlu() || (ref.component != component && !item.replicated) ||
        (item.outputMask && item.output != target))
      return false;
    item.output = target;
    item.outputMask |= std::uint8_t(1 << component);
    return true;
  }

  void depthOutput(const Value &value) {
    for (const Ref &ref : {value.through[3], value.direct[3]}) {
      if (ref.kind != Ref::Kind::Item || ref.negate || ref.absolute)
        continue;
      Item &item = m_flow.items[ref.index];
      if (!item.isAlu() || (ref.component != 3 && !item.replicated))
        continue;
      item.depth = true;
      return;
    }
  }

  struct Attribute {
    bool loaded = false;
    Value value;
  };

  const ir::Program &m_program;
  const CompileOptions &m_options;
  Flow &m_flow;
  Emitter m_emit;
  std::vector<Attribute> m_attributes;
  std::vector<std::uint8_t> m_masks;
};
} // namespace

void lower(const ir::Program &program, const CompileOptions &options, Flow &flow) {
  Lowering(program, options, flow).run();
}

} // namespace arbiter::fp::hw::r300
