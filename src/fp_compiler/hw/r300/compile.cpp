#include "fp_compiler/hw/r300/compile.h"

#include <algorithm>

#include "fp_compiler/hw/r300/lower/fold.h"
#include "fp_compiler/hw/r300/lower/lower.h"
#include "fp_compiler/hw/r300/lower/prune.h"
#include "fp_compiler/hw/r300/pair/allocate.h"

namespace arbiter::fp::hw::r300 {

namespace {
/// Encodes the plan with the chip's own register and constant numbers.
class Assembly {
public:
  Assembly(const ir::Program &program, const Flow &flow, Plan plan)
      : m_program(program), m_flow(flow), m_plan(std::move(plan)),
        m_registers(allocate(flow, m_plan)), m_constants(flow.rows.size(), kNone) {}

  Code run() {
    m_code.nodes = std::move(m_plan.nodes);
    interpolants();
    m_code.textures.reserve(m_plan.textures.size());
    for (const ItemId id : m_plan.textures)
      texture(m_flow.items[id]);
    m_code.pairs.resize(m_plan.slots.size());
    for (std::size_t i = 0; i < m_plan.slots.size(); ++i)
      pair(m_plan.slots[i], m_code.pairs[i]);
    for (const std::uint16_t reg : m_registers)
      if (reg != kNone)
        m_code.temporaries = std::max(m_code.temporaries, std::uint32_t(reg) + 1);
    return std::move(m_code);
  }

private:
  [[nodiscard]] std::uint16_t registerOf(ItemId item) const {
    return m_registers[m_flow.parent[item]];
  }

  void interpolants() {
    for (ItemId id = 0; id < m_flow.items.size(); ++id) {
      const Item &item = m_flow.items[id];
      if (!item.live || item.kind != Item::Kind::Interpolant)
        continue;
      m_code.interpolants.push_back({item.attribute, registerOf(id)});
      const bool color =
          item.attribute == kSecondaryColor ||
          (item.attribute != kFogCoordinate &&
           m_program.attributes[item.attribute].kind <= ir::AttributeKind::ColorSecondary);
      m_code.interpolators += color ? 0 : 1;
    }
  }

  void texture(const Item &item) {
    Texture texture;
    texture.op = item.texture;
    texture.unit = item.unit;
    texture.target = item.target;
    texture.origin = item.origin;
    ItemId source = item.alphaArguments[0].source[0];
    for (const ItemId id : item.rgbArguments[0].source)
      source = id != kNoItem ? id : source;
    texture.source = registerOf(source);
    if (item.texture != TexOp::Kill)
      texture.destination = registerOf(ItemId(&item - m_flow.items.data()));
    m_code.textures.push_back(texture);
  }

  Source source(std::uint32_t address) {
    if (address == Packed::kFree)
      return {};
    if (!(address & Packed::kRow))
      return {Source::Bank::Temporary, m_registers[address]};
    std::uint16_t &index = m_constants[address & ~Packed::kRow];
    if (index == kNone) {
      index = std::uint16_t(m_code.constants.size());
      m_code.constants.push_back(m_flow.rows[address & ~Packed::kRow].constant);
    }
    return {Source::Bank::Constant, index};
  }

  template <typename Half> void half(const Item &item, std::uint8_t components, Half &half) {
    half.mask = item.mask & components;
    half.outputMask = item.outputMask & components;
    half.output = half.outputMask ? item.output : std::uint8_t(0);
    half.temporary = half.mask ? registerOf(ItemId(&item - m_flow.items.data())) : kNone;
    half.clamp = item.clamp;
    half.modifier = item.modifier;
    half.origin = item.origin;
    half.cause = item.cause;
    // Only a Dp3 is an operation of both halves and has a presubtract, which belongs to the RGB
    // half.
    if (item.kind != Item::Kind::Both || components == 7)
      half.presubtract = item.presubtract;
  }

  template <typename Argument, typename Select>
  static void arguments(const std::array<FlowArgument, 3> &from,
                        const std::array<std::uint8_t, 3> &sources, int count,
                        std::array<Argument, 3> &to, Select) {
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
      to[i].select = Select(from[i].select);
      to[i].source = sources[i];
      to[i].absolute = from[i].absolute;
      to[i].negate = from[i].negate;
    }
  }

  void pair(const Plan::Slot &slot, Pair &pair) {
    if (slot.rgb == kNoItem && slot.alpha == kNoItem) {
      pair.rgb.cause = pair.alpha.cause = Cause::EmptyNode;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      pair.rgb.sources[i] = source(slot.packed.rgb[i]);
      pair.alpha.sources[i] = source(slot.packed.alpha[i]);
    }
    if (slot.rgb != kNoItem) {
      const Item &item = m_flow.items[slot.rgb];
      half(item, 7, pair.rgb);
      pair.rgb.op = item.rgb;
      arguments(item.rgbArguments, slot.packed.rgbSource, argumentsOf(item.rgb), pair.rgb.arguments,
                RgbSelect::Xyz);
    }
    if (slot.alpha != kNoItem) {
      const Item &item = m_flow.items[slot.alpha];
      half(item, 8, pair.alpha);
      pair.alpha.depth = item.depth;
      pair.alpha.op = item.alpha;
      arguments(item.alphaArguments, slot.packed.alphaSource, argumentsOf(item.alpha, pair.rgb.op),
                pair.alpha.arguments, AlphaSelect::X);
    }
  }

  const ir::Program &m_program;
  const Flow &m_flow;
  Plan m_plan;
  std::vector<std::uint16_t> m_registers, m_constants;
  Code m_code;
};
} // namespace

Code compile(const ir::Program &program, const CompileOptions &options) {
  Flow flow;
  const std::size_t guess = program.code.size() * 3 + 16;
  flow.items.reserve(guess);
  flow.parent.reserve(guess);
  flow.variables.reserve(guess);
  flow.versions.reserve(guess);
  lower(program, options, flow);
  prune(flow);
  fold(flow);
  Plan plan = schedule(flow);
  return Assembly(program, flow, std::move(plan)).run();
}

} // namespace arbiter::fp::hw::r300
