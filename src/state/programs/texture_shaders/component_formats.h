#pragma once
#include <array>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/texture_shader/state.h"
#include "state/capabilities/host_caps.h"

/// The internal formats of NV_texture_shader and 3 (table 3.16) and of ATI_envmap_bumpmap, with the
/// host's format that stores each.
namespace arbiter::state {

struct ComponentFormat {
  GLenum name = 0;
  fp::texture_shader::Base base = fp::texture_shader::Base::None;
  fp::texture_shader::Signs signs = fp::texture_shader::Signs::Unsigned;
  GLenum host = 0;     ///< the host's internal format, unless hostFormat() says otherwise
  GLenum external = 0; ///< the only format of TexImage that is allowed; 0: colour formats
  int extension = 1;   ///< 1 or 3: NV_texture_shader or 3; 0: ATI_envmap_bumpmap
  /// Bits of its components: red, green, blue, alpha, luminance, intensity, hi, lo, ds, dt,
  /// magnitude.
  std::array<std::uint8_t, 11> bits{};

  /// Returns the number of components of the external format: 2 to 4; 0 for colours.
  [[nodiscard]] int components() const;
};

/// Returns the format of a name. Returns null for other names, or if it belongs to an extension
/// beyond the first `extensions`.
[[nodiscard]] const ComponentFormat *componentFormat(GLenum name, int extensions = 3);
/// Returns the host's internal format that stores it. A host without EXT_texture_snorm has no
/// signed luminance, intensity and alpha but NV_texture_shader's own.
[[nodiscard]] GLenum hostFormat(const ComponentFormat &format, const HostCaps &caps);
/// True for HILO_NV, DSDT_NV, DSDT_MAG_NV, DSDT_MAG_VIB_NV or DUDV_ATI, which are external formats.
[[nodiscard]] bool isComponentFormat(GLenum format);
[[nodiscard]] int componentsOf(GLenum format);
/// True for UNSIGNED_INT_S8_S8_8_8_NV or UNSIGNED_INT_8_8_S8_S8_REV_NV.
[[nodiscard]] bool isSignedPacked(GLenum type);

} // namespace arbiter::state
