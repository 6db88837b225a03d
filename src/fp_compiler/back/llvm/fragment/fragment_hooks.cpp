#include "fp_compiler/back/llvm/fragment/fragment_hooks.h"

#include "fp_compiler/back/llvm/code/quads.h"

#include <algorithm>

namespace arbiter::fp::llvm_back {

Vec FragmentHooks::input(ir::Attribute attribute, unsigned needed) {
  if (attribute.kind == ir::AttributeKind::FogCoord && (needed & ~1u) != 0) { // (f, 0, 0, 1)
    Vec fog = needed & 1 ? input(attribute, 1) : Vec{};
    for (std::size_t c = 1; c < 4; ++c)
      fog[c] = needed >> c & 1 ? m_code.splat(c == 3 ? 1.0f : 0.0f) : nullptr;
    return fog;
  }
  const std::vector<jit::FragmentInput> &inputs = m_program.shape().inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const jit::FragmentInput &in) {
    return in.attribute == attribute;
  });
  return found == inputs.end() ? Vec{} : m_interpolator.input(int(found - inputs.begin()), needed);
}

Vec FragmentHooks::attribute(int index, unsigned needed) {
  const ir::Program &program = m_program.program();
  // Only the coordinate of the given sample is read here.
  if (m_path == SamplePath::Given)
    return {m_code.splat(0.0f), m_code.splat(0.0f), m_code.splat(0.0f), m_code.splat(0.0f)};
  const ir::Attribute attribute = program.attributes[std::size_t(index)];
  if (attribute.kind == ir::AttributeKind::Position)
    return m_interpolator.position(program.options, needed);
  if (attribute.kind == ir::AttributeKind::Facing)
    return facing(needed);
  return input(attribute, needed);
}

/// Returns (1, 0, 0, 1) for a front-facing primitive, (-1, 0, 0, 1) for others.
Vec FragmentHooks::facing(unsigned needed) {
  Value *const x =
      m_code.select(m_interpolator.backFacing(), m_code.splat(-1.0f), m_code.splat(1.0f));
  const Vec all = {x, m_code.splat(0.0f), m_code.splat(0.0f), m_code.splat(1.0f)};
  Vec value = {};
  for (std::size_t i = 0; i < 4; ++i)
    value[i] = needed >> i & 1 ? all[i] : nullptr;
  return value;
}

Vec FragmentHooks::parameter(int index, unsigned needed) {
  return writeIn(m_code, m_places.entry, [&] {
    Value *const rows =
        m_code.field(m_code.ir.getPtrTy(), m_data, offsetof(abi::FragmentData, parameters));
    Vec row = {};
    for (unsigned c = 0; c < 4; ++c)
      if (needed >> c & 1)
        row[c] = m_code.splat(
            m_code.field(m_code.ir.getFloatTy(), rows, sizeof(float) * (4u * unsigned(index) + c)));
    return row;
  });
}

std::size_t FragmentHooks::nextTexture() {
  const std::vector<ir::Instruction> &instructions = m_program.program().code;
  while (m_live.written[m_next] == 0 || !ir::info(instructions[m_next].op).has(ir::Texture))
    ++m_next;
  return m_next++;
}

namespace {

/// Returns the number of coordinates that determine the level of detail.
int coordinatesOf(abi::Dimension dimension) {
  if (dimension == abi::Dimension::Tex1D)
    return 1;
  return dimension == abi::Dimension::Tex3D || dimension == abi::Dimension::Cube ? 3 : 2;
}

/// True if quads take the derivative along x from their upper row. Hosts use the quad's first row
/// in memory. Computed coordinates may differ between rows. If rows go downwards, as in windows,
/// the upper row comes first.
Value *takesUpperRow(Code &code, const Places &places, Value *data) {
  return writeIn(code, places.entry, [&] {
    Value *const stride =
        code.field(code.ir.getInt64Ty(), data,
                   offsetof(abi::FragmentData, targets) + offsetof(abi::Target, rowStride));
    return code.ir.CreateICmpSLT(stride, code.ir.getInt64(0));
  });
}

} // namespace

void FragmentHooks::addRowDerivatives(SampleAt &at, std::size_t index, const abi::SamplerKey &key) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const int dimensions = coordinatesOf(key.dimension);
  const AffineFlow::Axes *const axes = m_flow ? m_flow->coordinate(index) : nullptr;
  const bool projected = m_program.program().code[index].op == ir::Opcode::Txp;
  m_refused |= !axes || projected || key.dimension == abi::Dimension::Cube;
  for (std::size_t c = 0; c < std::size_t(dimensions) && !m_refused; ++c) {
    const std::optional<Affine> &axis = (*axes)[c];
    if (!axis) {
      m_refused = true;
      return;
    }
    const auto inLanes = [&](Value *slope) {
      return writeIn(m_code, m_places.item, [&] {
        return slope ? m_code.splat(ir.CreateFPTrunc(slope, ir.getFloatTy())) : m_code.splat(0.0f);
      });
    };
    at.dx[c] = inLanes(axis->slope);
    at.dy[c] = inLanes(axis->slopeY);
  }
}

void FragmentHooks::addDerivatives(SampleAt &at, const abi::SamplerKey &key) {
  const int dimensions = coordinatesOf(key.dimension);
  if (key.dimension == abi::Dimension::Cube)
    addPixelDerivatives(m_code, at, dimensions);
  else
    addQuadDerivatives(m_code, at, dimensions, takesUpperRow(m_code, m_places, m_data));
  if (!running())
    return;
  // If some pixels of a quad have left the loop, no derivative exists. The base level is used.
  Value *const whole = wholeQuads(m_code, running());
  for (std::size_t c = 0; c < std::size_t(dimensions); ++c) {
    at.dx[c] = m_code.select(whole, at.dx[c], m_code.splat(0.0f));
    at.dy[c] = m_code.select(whole, at.dy[c], m_code.splat(0.0f));
  }
}

SampleAt FragmentHooks::sampleAt(const ir::Instruction &instruction,
                                 const std::array<Vec, 3> &operands) {
  const Vec &operand = operands[0];
  SampleAt at;
  at.coordinate = operand;
  at.mask = m_place.covered;
  if (running())
    at.mask = m_code.ir.CreateAnd(at.mask, running());
  if (instruction.op == ir::Opcode::Txp) { // multiplies by the inverse, as hosts do
    Value *const inverse = m_code.ir.CreateFDiv(m_code.splat(1.0f), operand[3]);
    for (std::size_t c = 0; c < 3; ++c)
      if (operand[c])
        at.coordinate[c] = m_code.ir.CreateFMul(operand[c], inverse);
  }
  if (instruction.op == ir::Opcode::Txb)
    at.bias = operand[3];
  if (instruction.op == ir::Opcode::Txl) // a rectangle has one level
    at.lod = operand[3] ? operand[3] : m_code.splat(0.0f);
  if (instruction.op == ir::Opcode::Txd)
    for (std::size_t c = 0; c < 3; ++c) {
      at.dx[c] = operands[1][c];
      at.dy[c] = operands[2][c];
    }
  at.coordinate[3] = nullptr;
  return at;
}

Vec FragmentHooks::texture(const ir::Instruction &instruction, const std::array<Vec, 3> &operands,
                           unsigned needed) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const abi::SamplerKey &key = m_key.samplers[instruction.unit];
  const std::size_t index = nextTexture();
  SampleAt at = sampleAt(instruction, operands);
  const bool edge = m_path == SamplePath::Edge && m_samples->has(index);
  if (edge || m_path == SamplePath::Given) {
    Value *const raw = edge ? m_samples->wrappedTexels(index, m_place) : m_given;
    Value *const packed = abi::isPlainWord(key.format) ? raw : nullptr;
    m_texels.push_back({decode(m_code, key.format, raw, needed), packed, key.format.swizzle});
    return m_texels.back().rgba;
  }
  if (m_path == SamplePath::Consecutive && m_samples->has(index))
    at.texels = m_samples->texels(index, m_place.column);
  const bool hasLevels = key.mip != abi::MipFilter::None || key.magnify != key.minify;
  const bool given = at.lod || at.dx[0];
  if (hasLevels && key.format.layout != abi::Layout::None && !given) {
    if (m_place.lanes == abi::Lanes::Row)
      addRowDerivatives(at, index, key);
    else
      addDerivatives(at, key);
  }
  Value *const view = writeIn(m_code, m_places.entry, [&] {
    return m_code.field(ir.getPtrTy(), m_data,
                        offsetof(abi::FragmentData, textures) + sizeof(void *) * instruction.unit);
  });
  const abi::Lanes lanes = m_place.lanes == abi::Lanes::Row ? abi::Lanes::Row : abi::Lanes::Quad;
  const Texel texel = sample(m_code, key, lanes, view, at, needed);
  if (!running()) // values from a loop are not available after it
    m_texels.push_back({texel.rgba, texel.packed, key.format.swizzle});
  return texel.rgba;
}

bool FragmentHooks::hasQuads() {
  const bool row = m_place.lanes == abi::Lanes::Row;
  m_refused |= row;
  return !row;
}

/// Returns null for quads, because derivatives also need pixels that are not covered.
Value *FragmentHooks::wanted() {
  return m_place.lanes == abi::Lanes::Row ? m_place.covered : nullptr;
}

void FragmentHooks::kill(Value *lanes) {
  Value *const rest = m_code.ir.CreateNot(lanes);
  m_alive = m_alive ? m_code.ir.CreateAnd(m_alive, rest) : rest;
}

Vec FragmentHooks::relative(int, Value *, unsigned) {
  // Only vertex programs have relative operands. A row that does not exist is zero.
  return {m_code.splat(0.0f), m_code.splat(0.0f), m_code.splat(0.0f), m_code.splat(0.0f)};
}

} // namespace arbiter::fp::llvm_back
