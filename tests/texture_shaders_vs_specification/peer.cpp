#include "peer.h"

#include <optional>

#include "fp_compiler/texture_shader/operations.h"

namespace shaded {

using namespace arbiter::fp::texture_shader;

namespace {

/// Returns the corresponding offset operation without scaling.
Operation withoutScale(Operation operation) {
  switch (operation) {
  case Operation::Offset2DScale:
    return Operation::Offset2D;
  case Operation::OffsetRectangleScale:
    return Operation::OffsetRectangle;
  case Operation::OffsetProjective2DScale:
    return Operation::OffsetProjective2D;
  case Operation::OffsetProjectiveRectangleScale:
    return Operation::OffsetProjectiveRectangle;
  default:
    return operation;
  }
}

bool reflects(Operation operation) { return infoOf(operation).family == Family::Reflect; }

/// True if a unit's stage samples but its result is not a color. NVIDIA's driver then reads (1, 1,
/// 1, 1) if an environment names the unit.
bool isOtherwiseNamed(const State &state, std::size_t unit) {
  const Texture &texture = state.textures[unit];
  return infoOf(state.stages[unit].operation).target && texture.base >= Base::Hilo &&
         texture.base != Base::DsdtMagIntensity;
}

/// Returns the unit whose texture color an argument of `unit`'s COMBINE reads; nothing if it reads
/// another color.
std::optional<std::size_t> unitOf(const CombineArgument &argument, std::size_t unit) {
  if (argument.source >= CombineSource::Unit0)
    return std::size_t(argument.source) - std::size_t(CombineSource::Unit0);
  return argument.source == CombineSource::Texture ? std::optional(unit) : std::nullopt;
}

} // namespace

void leaveOut(State &state) {
  if (state.conventional)
    return;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    Stage &stage = state.stages[unit];
    const OperationInfo &info = infoOf(stage.operation);
    Texture &own = state.textures[unit];
    // In other formats the driver treats a scaled one as inconsistent.
    if (info.scale && isRgba(own.base) && own.base != Base::Rgb)
      own.base = Base::Rgba;
    // The driver treats a diffuse stage before an inconsistent reflection as consistent.
    if (unit > 1 && reflects(stage.operation) &&
        state.stages[unit - 1].operation == Operation::DotProductDiffuseCubeMap &&
        stage.previous + 2 >= int(unit))
      stage.previous = 0;
    if (!readsPrevious(info.family))
      continue;
    Stage &previous = state.stages[stage.previous];
    Texture &read = state.textures[stage.previous];
    // The driver scales what is read from a scaled offset.
    previous.operation = withoutScale(previous.operation);
    // The driver reads (0, 0, 0, A) from an ALPHA texture.
    if (read.base == Base::Alpha)
      read.base = Base::Rgba;
    // A signed texture's missing component is 1, and the driver then treats the signedness as
    // mixed.
    if (computesDot(info.family) && (read.base == Base::Luminance || read.base == Base::Rgb))
      read.signs = Signs::Unsigned;
    // The driver gives a signed HILO result of an offset a third component of 1.
    if (computesDot(info.family) && read.base == Base::Hilo &&
        infoOf(previous.operation).family == Family::Offset)
      read.signs = Signs::Unsigned;
    // The driver gives no result for it.
    if (stage.operation == Operation::DependentRgbCubeMap)
      stage.operation = Operation::TextureCubeMap;
  }
}

void leaveOut(const State &state, Environments &environments) {
  if (state.conventional)
    return;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    Environment &environment = environments[unit];
    // The driver's process crashes with it.
    const Family family = infoOf(state.stages[unit].operation).family;
    if ((family == Family::PassThrough || family == Family::DotColor) &&
        environment.mode == EnvironmentMode::Blend)
      environment.mode = EnvironmentMode::Modulate;
    for (CombineHalf *const half : {&environment.color, &environment.alpha})
      for (CombineArgument &argument : half->arguments) {
        const auto of = unitOf(argument, unit);
        if (of && isOtherwiseNamed(state, *of))
          argument.source = CombineSource::Previous;
        // The driver reads black as the color of an ALPHA texture in COMBINE.
        else if (of && state.textures[*of].base == Base::Alpha)
          argument.alpha = true;
      }
  }
}

} // namespace shaded
