#include "apps/tools/debug/pixel/reader.h"

#include <algorithm>
#include <cmath>

#include "apps/tools/debug/pixel/cut.h"
#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::debug {

namespace {

/// An operand to read, and the destination of its value.
struct Wanted {
  fp::ir::Operand operand;
  Vec4 *to = nullptr;
};

fp::ir::Operand operandOf(fp::ir::File file, std::size_t index) {
  fp::ir::Operand operand;
  operand.file = file;
  operand.index = std::uint16_t(index);
  return operand;
}

/// Returns an attribute's index in the table; adds it if it is missing.
std::size_t attributeIn(Program &program, AttributeKind kind) {
  const fp::ir::Attribute wanted{kind, 0};
  const auto found = std::find(program.attributes.begin(), program.attributes.end(), wanted);
  if (found != program.attributes.end())
    return std::size_t(found - program.attributes.begin());
  program.attributes.push_back(wanted);
  return program.attributes.size() - 1;
}

std::size_t stateIn(Program &program, StateItem item) {
  fp::ir::Parameter wanted;
  wanted.kind = fp::ir::ParameterKind::State;
  wanted.state.item = item;
  program.parameters.push_back(wanted);
  return program.parameters.size() - 1;
}

Vec4 divided(Vec4 coordinate) {
  for (std::size_t c = 0; c < 3; ++c)
    coordinate[c] /= coordinate[3];
  return coordinate;
}

} // namespace

PixelReader::PixelReader(Drawer &drawer, const Program &program, int x, int y, fp::Numerics drawn)
    : m_drawer(drawer), m_program(program), m_x(x & ~1), m_y(y & ~1),
      m_lane(std::size_t((y & 1) * 2 + (x & 1))), m_drawn(drawn) {}

std::optional<DebugError> outside(const Drawer &drawer, int x, int y) {
  const auto [width, height] = drawer.size();
  if (x >= 0 && y >= 0 && x < width && y < height)
    return {};
  return DebugError{"--pixel " + std::to_string(x) + "," + std::to_string(y) + ": the picture is " +
                    std::to_string(width) + "x" + std::to_string(height) +
                    ", its pixels are 0,0 (lower left) to " + std::to_string(width - 1) + "," +
                    std::to_string(height - 1)};
}

std::optional<DebugError> PixelReader::read() {
  if (auto error = outside(m_drawer, m_x + int(m_lane & 1), m_y + int(m_lane >> 1)))
    return error;
  if (auto error = chooseFragments())
    return error;
  if (auto error = readOperands())
    return error;
  if (auto error = readAccesses())
    return error;
  m_inputs.texture = [this](std::size_t index, const fp::ir::Sample &sample, fp::Numerics mode) {
    return texel(index, sample, mode);
  };
  m_inputs.lod = [this](std::size_t index) { return m_accesses[index].lod; };
  return {};
}

/// Chooses the fragment to read. If fragments overlap, and the program discards some or sets their
/// depths, the visible one is a surviving fragment.
std::optional<DebugError> PixelReader::chooseFragments() {
  if (!decidesFragments(m_program))
    return {};
  m_fragments = Fragments::Surviving;
  fp::ir::Operand zero;
  zero.swizzle.fill(fp::ir::Select::Zero);
  zero.file = fp::ir::File::Attribute;
  Program tables = m_program;
  zero.index = std::uint16_t(attributeIn(tables, AttributeKind::Position));
  const auto quads = drawQuads(showOperands(tables, {zero}, m_fragments), 1);
  if (!quads)
    return quads.error();
  if (own(quads.value()[0]) == uncovered())
    m_fragments = Fragments::Covered;
  return {};
}

Result<std::vector<Quad>, DebugError> PixelReader::drawQuads(const Program &program,
                                                             std::size_t targets,
                                                             const std::vector<Vec4> &locals) {
  // The picture's edge may cut the quad; pixels outside count as uncovered.
  const auto [width, height] = m_drawer.size();
  const Region region{m_x, m_y, std::min(2, width - m_x), std::min(2, height - m_y)};
  auto drawn = m_drawer.draw(fp::emitAssembly(program), targets, region, locals);
  if (!drawn)
    return drawn.error();
  const auto pixels = std::size_t(region.width * region.height);
  if (drawn.value().size() != targets * pixels)
    return DebugError{m_drawer.name() + " drew another number of pixels than was asked for"};
  std::vector<Quad> quads(targets);
  for (std::size_t t = 0; t < targets; ++t) {
    quads[t].fill(uncovered());
    for (int py = 0; py < region.height; ++py)
      for (int px = 0; px < region.width; ++px)
        quads[t][std::size_t(py * 2 + px)] =
            drawn.value()[t * pixels + std::size_t(py * region.width + px)];
  }
  return quads;
}

std::optional<DebugError> PixelReader::readOperands() {
  Program tables = m_program;
  m_inputs.attributes.resize(tables.attributes.size());
  m_inputs.parameters.resize(tables.parameters.size());
  Vec4 fog = {};
  // The position comes first, because it shows which pixels are covered.
  std::vector<Wanted> wanted = {
      {operandOf(fp::ir::File::Attribute, attributeIn(tables, AttributeKind::Position)),
       &m_position}};
  for (std::size_t i = 0; i < m_program.attributes.size(); ++i)
    wanted.push_back({operandOf(fp::ir::File::Attribute, i), &m_inputs.attributes[i]});
  for (std::size_t i = 0; i < m_program.parameters.size(); ++i)
    if (m_program.parameters[i].kind != fp::ir::ParameterKind::Constant)
      wanted.push_back({operandOf(fp::ir::File::Parameter, i), &m_inputs.parameters[i]});
  const auto attribute = [&](AttributeKind kind, Vec4 *to) {
    wanted.push_back({operandOf(fp::ir::File::Attribute, attributeIn(tables, kind)), to});
  };
  const auto state = [&](StateItem item, Vec4 *to) {
    wanted.push_back({operandOf(fp::ir::File::Parameter, stateIn(tables, item)), to});
  };
  if (m_program.options.fog != fp::ir::FogMode::None) {
    attribute(AttributeKind::FogCoord, &fog);
    state(StateItem::FogColor, &m_inputs.fogColor);
    state(StateItem::FogParams, &m_inputs.fogParams);
  }
  if (m_program.options.colorSum)
    attribute(AttributeKind::ColorSecondary, &m_inputs.secondary);
  for (std::size_t from = 0; from < wanted.size(); from += kMaxTargets) {
    const std::size_t count = std::min(kMaxTargets, wanted.size() - from);
    std::vector<fp::ir::Operand> operands;
    for (std::size_t i = 0; i < count; ++i)
      operands.push_back(wanted[from + i].operand);
    const auto quads = drawQuads(showOperands(tables, operands, m_fragments), count);
    if (!quads)
      return quads.error();
    if (from == 0)
      for (std::size_t lane = 0; lane < 4; ++lane)
        m_covered[lane] = quads.value()[0][lane] != uncovered();
    if (!m_covered[m_lane])
      return DebugError{"nothing that the document draws covers this pixel"};
    for (std::size_t i = 0; i < count; ++i)
      *wanted[from + i].to = own(quads.value()[i]);
  }
  m_inputs.fogCoordinate = fog[0];
  return {};
}

std::optional<DebugError> PixelReader::readAccesses() {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < m_program.code.size(); ++i) {
    if (!fp::ir::info(m_program.code[i].op).has(fp::ir::Texture))
      continue;
    rows.push_back(i);
    if (rows.size() * 2 < kMaxTargets)
      continue;
    if (auto error = drawProbes(rows))
      return error;
    rows.clear();
  }
  return rows.empty() ? std::nullopt : drawProbes(rows);
}

std::optional<DebugError> PixelReader::drawProbes(const std::vector<std::size_t> &rows) {
  std::vector<Probe> probes;
  for (const std::size_t row : rows) {
    probes.push_back({Probe::Kind::Texel, row});
    probes.push_back({Probe::Kind::Coordinate, row});
  }
  const auto quads = drawQuads(cutProgram(m_program, probes, m_fragments), probes.size());
  if (!quads)
    return quads.error();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Instruction &instruction = m_program.code[rows[i]];
    Access &access = m_accesses[rows[i]];
    access.texel = quads.value()[2 * i];
    access.coordinate = quads.value()[2 * i + 1];
    if (instruction.op == fp::ir::Opcode::Txp)
      for (Vec4 &coordinate : access.coordinate)
        coordinate = divided(coordinate);
    access.lod = levelOf(instruction, access);
  }
  return {};
}

/// Returns the level of detail (OpenGL 2.1, 3.8.8): the greater of the two directions, in texels
/// per pixel.
std::optional<float> PixelReader::levelOf(const Instruction &instruction, const Access &access) {
  using fp::ir::TexTarget;
  if (instruction.target == TexTarget::Cube || instruction.target == TexTarget::Rect ||
      instruction.target == TexTarget::ShadowRect)
    return {};
  const std::size_t beside = m_lane ^ 1, above = m_lane ^ 2;
  const auto size = m_drawer.textureSize(instruction.unit, instruction.target);
  if (!size || size.value()[0] == 0 || !m_covered[beside] || !m_covered[above])
    return {};
  const std::uint8_t used = fp::ir::isShadow(instruction.target)
                                ? std::uint8_t(fp::ir::coordinateMask(instruction.target) & 3)
                                : fp::ir::coordinateMask(instruction.target);
  float greatest = 0;
  for (const std::size_t lane : {beside, above}) {
    float square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float texels = (access.coordinate[lane][c] - own(access.coordinate)[c]) *
                           float(std::max(1, size.value()[c]));
      square += used >> c & 1 ? texels * texels : 0.0f;
    }
    greatest = std::max(greatest, std::sqrt(square));
  }
  const float bias = instruction.op == fp::ir::Opcode::Txb ? own(access.coordinate)[3] : 0.0f;
  return std::log2(greatest) + bias;
}

Vec4 PixelReader::texel(std::size_t index, const fp::ir::Sample &sample, fp::Numerics numerics) {
  const Access &access = m_accesses[index];
  const std::uint8_t used = fp::ir::coordinateMask(sample.target);
  bool same =
      m_program.code[index].op != fp::ir::Opcode::Txb || sample.bias == own(access.coordinate)[3];
  for (std::size_t c = 0; c < 3; ++c)
    same = same && (!(used >> c & 1) || sample.coordinate[c] == own(access.coordinate)[c]);
  if (same || numerics == m_drawn)
    return own(access.texel);
  Vec4 key = sample.coordinate;
  key[3] = sample.bias;
  // The host decides where infinities and NaNs sample, and program texts cannot contain them.
  if (!std::all_of(key.begin(), key.end(), [](float each) { return std::isfinite(each); }))
    return {};
  const auto [at, isNew] = m_sampled.try_emplace({index, key});
  if (isNew)
    at->second = sampleAt(sample, m_program.code[index].op == fp::ir::Opcode::Txb, access);
  return at->second;
}

Vec4 PixelReader::sampleAt(const fp::ir::Sample &sample, bool biased, const Access &access) {
  Quad coordinates;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    coordinates[lane] = sample.coordinate;
    for (std::size_t c = 0; c < 3; ++c) {
      const float apart = access.coordinate[lane][c] - own(access.coordinate)[c];
      if (m_covered[lane] && std::isfinite(apart))
        coordinates[lane][c] += apart;
    }
    coordinates[lane][3] = sample.bias;
  }
  std::vector<Vec4> locals(coordinates.begin(), coordinates.end());
  locals.push_back({float(m_x) + 1, float(m_y) + 1, 0, 0});
  const auto quads =
      drawQuads(sampleQuad(m_program, sample.unit, sample.target, biased), 1, locals);
  if (!quads) {
    m_failure = quads.error();
    return {};
  }
  return own(quads.value()[0]);
}

} // namespace arbiter::tools::debug
