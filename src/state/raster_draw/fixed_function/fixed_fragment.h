#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include <GL/gl.h>

#include "fp_compiler/fixed_function.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/fixed_function/fixed_programs.h"
#include "state/raster_draw/outcome.h"

/// Writes fixed-function fragment processing (texture environments, colour sum and fog: OpenGL 1.4,
/// 3.8.13 to 3.10) as programs of Language::ArbFragment. Frames that mix it with the application's
/// programs can then stay on the rasterizer.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// The property of a texture's format that environment functions depend on (table 3.20 and the
/// following ones).
enum class TexelKind : std::uint8_t { Alpha, Opaque, Translucent, Intensity };

/// One half of COMBINE, as plain numbers.
struct Combiner {
  std::uint8_t function = 0; ///< a row of kCombineFunctions
  std::array<std::uint8_t, 3>
      sources{}; ///< 0 texture, 1 constant, 2 primary, 3 previous, 4+n unit n
  std::array<std::uint8_t, 3> operands{}; ///< bit 0: one minus; bit 1: alpha
  std::uint8_t scale = 1;                 ///< 1, 2 or 4
  bool operator==(const Combiner &) const = default;
};

enum class Environment : std::uint8_t { Off, Replace, Modulate, Decal, Blend, Add, Combine };

struct TextureUnitKey {
  Environment environment = Environment::Off;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
  TexelKind kind = TexelKind::Translucent;
  Combiner color, alpha;
  bool operator==(const TextureUnitKey &) const = default;
};

/// All state that the code depends on. It consists of plain bytes, and is compared and hashed as
/// such.
struct FixedFragmentKey {
  std::array<TextureUnitKey, 8> units{};
  fp::ir::FogMode fog = fp::ir::FogMode::None;
  std::uint8_t colorSum = 0;
  bool operator==(const FixedFragmentKey &) const = default;
};

[[nodiscard]] fp::ir::Program makeFixedFragmentProgram(const FixedFragmentKey &key);

/// The programs in use, by key, and the host's state that selects one.
class FixedFragments {
public:
  /// Returns the program for the host's current state. Returns null, with the reason, if an
  /// environment is not supported. Call it after refresh().
  [[nodiscard]] std::shared_ptr<const fp::ir::Program> get(RasterContext &context, Mirror &mirror,
                                                           Outcome &outcome);

private:
  Outcome ask(RasterContext &context);
  Outcome completeUnits(RasterContext &context, Mirror &mirror, FixedFragmentKey &key);

  FixedPrograms<FixedFragmentKey> m_programs;
  FixedFragmentKey m_state; ///< as queried; the units' kinds are not known yet
  Outcome m_outcome;
  std::uint64_t m_seen = 0;
};

} // namespace arbiter::state
