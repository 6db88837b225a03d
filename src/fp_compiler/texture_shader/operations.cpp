#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::texture_shader {

namespace {

using ir::TexTarget;

constexpr OperationInfo offset(TexTarget target, bool projective, bool scale, bool hilo = false) {
  return {Family::Offset, target, 0, projective, scale, hilo, 1};
}
constexpr OperationInfo dependent(TexTarget target, bool hilo = false) {
  return {Family::Dependent, target, 0, false, false, hilo, 1};
}
constexpr OperationInfo dots(Family family, std::uint8_t count,
                             std::optional<TexTarget> target = {}) {
  return {family, target, count, false, false, false, count};
}

constexpr OperationInfo kInfos[kOperations] = {
    {},
    {Family::Texture, TexTarget::Tex1D},
    {Family::Texture, TexTarget::Tex2D},
    {Family::Texture, TexTarget::Rect},
    {Family::Texture, TexTarget::Cube},
    {Family::PassThrough},
    {Family::Cull},
    offset(TexTarget::Tex2D, false, false),
    offset(TexTarget::Tex2D, false, true),
    offset(TexTarget::Rect, false, false),
    offset(TexTarget::Rect, false, true),
    dependent(TexTarget::Tex2D),
    dependent(TexTarget::Tex2D),
    dots(Family::Dot, 1),
    dots(Family::DotSample, 2, TexTarget::Tex2D),
    dots(Family::DotSample, 2, TexTarget::Rect),
    dots(Family::DotSample, 3, TexTarget::Cube),
    dots(Family::Reflect, 3, TexTarget::Cube),
    dots(Family::Reflect, 3, TexTarget::Cube),
    dots(Family::Diffuse, 2, TexTarget::Cube),
    dots(Family::DotDepth, 2),
    {Family::Texture, TexTarget::Tex3D},
    dots(Family::DotSample, 3, TexTarget::Tex3D),
    offset(TexTarget::Tex2D, true, false),
    offset(TexTarget::Tex2D, true, true),
    offset(TexTarget::Rect, true, false),
    offset(TexTarget::Rect, true, true),
    offset(TexTarget::Tex2D, false, false, true),
    offset(TexTarget::Rect, false, false, true),
    offset(TexTarget::Tex2D, true, false, true),
    offset(TexTarget::Rect, true, false, true),
    dependent(TexTarget::Tex2D, true),
    dependent(TexTarget::Tex3D),
    dependent(TexTarget::Cube),
    dots(Family::DotColor, 1),
    dots(Family::DotSample, 1, TexTarget::Tex1D),
    dots(Family::DotDepth, 1),
};

/// True if a stage may read `previous` as the result of an earlier consistent stage.
bool accepts(Operation operation, const Texture &previous) {
  const OperationInfo &info = infoOf(operation);
  switch (info.family) {
  case Family::Offset:
    if (info.hilo)
      return previous.base == Base::Hilo && previous.signs == Signs::Signed;
    return previous.base == Base::DsdtMag || previous.base == Base::DsdtMagIntensity ||
           (previous.base == Base::Dsdt && !info.scale);
  case Family::Dependent:
    if (info.hilo)
      return previous.base == Base::Hilo && previous.signs == Signs::Unsigned;
    return isRgba(previous.base) &&
           (previous.signs == Signs::Unsigned || operation == Operation::DependentRgbCubeMap);
  default: // the components of dot products have one signedness
    return (isRgba(previous.base) || previous.base == Base::Hilo) &&
           previous.signs != Signs::SignedRgb;
  }
}

class Rules {
public:
  explicit Rules(const State &state) : m_state(state) {}

  std::uint32_t run() {
    for (int unit = 0; unit < m_state.units; ++unit) {
      // A diffuse stage is consistent only together with the stage after it.
      const bool behindDiffuse = unit > 0 && familyOf(unit - 1) == Family::Diffuse;
      if (behindDiffuse && familyOf(unit) != Family::Reflect)
        set(unit - 1, false);
      set(unit, ofStage(unit));
      if (behindDiffuse && !has(unit))
        set(unit - 1, false);
    }
    if (m_state.units > 0 && familyOf(m_state.units - 1) == Family::Diffuse)
      set(m_state.units - 1, false);
    return m_consistent;
  }

private:
  [[nodiscard]] Operation operationOf(int unit) const {
    return m_state.stages[std::size_t(unit)].operation;
  }
  [[nodiscard]] Family familyOf(int unit) const { return infoOf(operationOf(unit)).family; }
  [[nodiscard]] bool has(int unit) const { return (m_consistent >> unit & 1u) != 0; }
  void set(int unit, bool consistent) {
    m_consistent = (m_consistent & ~(1u << unit)) | std::uint32_t(consistent) << unit;
  }

  [[nodiscard]] bool ofStage(int unit) const {
    const OperationInfo &info = infoOf(operationOf(unit));
    const Texture &texture = m_state.textures[std::size_t(unit)];
    if (info.target && texture.base == Base::None)
      return false;
    if (info.scale && (!isRgba(texture.base) || texture.signs != Signs::Unsigned))
      return false;
    if (readsPrevious(info.family) && !previousFits(unit))
      return false;
    if (info.dots > 1 && !dotsPrecede(unit, info))
      return false;
    return info.family != Family::DotDepth || !replacesDepthBefore(unit);
  }

  [[nodiscard]] bool previousFits(int unit) const {
    const int previous = m_state.stages[std::size_t(unit)].previous;
    if (previous >= unit || !has(previous))
      return false;
    // The stages whose products a reflection combines have no result for it. The result of a
    // diffuse stage would depend on itself.
    if (familyOf(unit) == Family::Reflect && previous >= unit - 2)
      return false;
    return accepts(operationOf(unit), resultOf(m_state, previous));
  }

  [[nodiscard]] bool dotsPrecede(int unit, const OperationInfo &info) const {
    for (int back = 1; back < info.dots; ++back) {
      const int at = unit - back;
      if (at < 0 || !has(at))
        return false;
      const bool diffuse =
          back == 1 && info.family == Family::Reflect && familyOf(at) == Family::Diffuse;
      if (familyOf(at) != Family::Dot && !diffuse)
        return false;
    }
    return true;
  }

  [[nodiscard]] bool replacesDepthBefore(int unit) const {
    for (int before = 0; before < unit; ++before)
      if (familyOf(before) == Family::DotDepth && has(before))
        return true;
    return false;
  }

  const State &m_state;
  std::uint32_t m_consistent = 0;
};

} // namespace

const OperationInfo &infoOf(Operation operation) { return kInfos[std::size_t(operation)]; }

std::uint32_t consistentStages(const State &state) { return Rules(state).run(); }

Texture resultOf(const State &state, int unit) {
  const OperationInfo &info = infoOf(state.stages[std::size_t(unit)].operation);
  if (info.target)
    return state.textures[std::size_t(unit)];
  if (info.family == Family::PassThrough || info.family == Family::DotColor)
    return {Base::Rgba, Signs::Unsigned, false};
  return {};
}

State essential(const State &state) {
  State key;
  key.units = state.units;
  key.conventional = state.conventional;
  key.bumps = state.bumps;
  const std::uint32_t consistent = consistentStages(state);
  for (std::size_t unit = 0; unit < key.stages.size(); ++unit) {
    if ((consistent >> unit & 1u) == 0)
      continue;
    const Stage &from = state.stages[unit];
    const OperationInfo &info = infoOf(from.operation);
    Stage &to = key.stages[unit];
    to.operation = from.operation;
    if (info.target)
      key.textures[unit] = state.textures[unit];
    if (info.family != Family::Texture)
      key.textures[unit].compares = false; // only own coordinates have a reference value
    if (info.family == Family::Cull)
      to.cullLess = from.cullLess;
    if (readsPrevious(info.family))
      to.previous = from.previous;
    if (!computesDot(info.family))
      continue;
    const Texture read = resultOf(state, from.previous);
    if (read.base != Base::Hilo && read.signs == Signs::Unsigned)
      to.mapping = from.mapping;
  }
  return key;
}

} // namespace arbiter::fp::texture_shader
