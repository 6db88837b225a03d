#include "state/programs/texture_shaders/component_formats.h"

#include <algorithm>
#include <iterator>

namespace arbiter::state {

namespace {

using fp::texture_shader::Base;
using fp::texture_shader::Signs;
using Bits = std::array<std::uint8_t, 11>;

constexpr Bits kRgba = {8, 8, 8, 8}, kRgb = {8, 8, 8}, kAlpha = {0, 0, 0, 8},
               kLuminance = {0, 0, 0, 0, 8}, kLuminanceAlpha = {0, 0, 0, 8, 8},
               kIntensity = {0, 0, 0, 0, 0, 8}, kHilo16 = {0, 0, 0, 0, 0, 0, 16, 16},
               kHilo8 = {0, 0, 0, 0, 0, 0, 8, 8}, kDsdt = {0, 0, 0, 0, 0, 0, 0, 0, 8, 8},
               kDsdtMag = {0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8},
               kDsdtMagIntensity = {0, 0, 0, 0, 0, 8, 0, 0, 8, 8, 8}, kDudv = {};

// Signed colours use the host's signed normalized formats, so that the host converts pixels.
// Formats with mixed signs have no such format; 16 bits hold both kinds of eight. HILO components
// and offsets reach the host as numbers that the layer has clamped and rounded. Floats are wide
// enough for these, and the rasterizer supports them. Programs sample them as in table X.5 of
// NV_fragment_program: HILO formats have a third component.
constexpr ComponentFormat kFormats[] = {
    {GL_SIGNED_RGBA_NV, Base::Rgba, Signs::Signed, GL_RGBA8_SNORM, 0, 1, kRgba},
    {GL_SIGNED_RGBA8_NV, Base::Rgba, Signs::Signed, GL_RGBA8_SNORM, 0, 1, kRgba},
    {GL_SIGNED_RGB_NV, Base::Rgb, Signs::Signed, GL_RGB8_SNORM, 0, 1, kRgb},
    {GL_SIGNED_RGB8_NV, Base::Rgb, Signs::Signed, GL_RGB8_SNORM, 0, 1, kRgb},
    {GL_SIGNED_LUMINANCE_NV, Base::Luminance, Signs::Signed, GL_LUMINANCE8_SNORM, 0, 1, kLuminance},
    {GL_SIGNED_LUMINANCE8_NV, Base::Luminance, Signs::Signed, GL_LUMINANCE8_SNORM, 0, 1,
     kLuminance},
    {GL_SIGNED_LUMINANCE_ALPHA_NV, Base::LuminanceAlpha, Signs::Signed, GL_LUMINANCE8_ALPHA8_SNORM,
     0, 1, kLuminanceAlpha},
    {GL_SIGNED_LUMINANCE8_ALPHA8_NV, Base::LuminanceAlpha, Signs::Signed,
     GL_LUMINANCE8_ALPHA8_SNORM, 0, 1, kLuminanceAlpha},
    {GL_SIGNED_ALPHA_NV, Base::Alpha, Signs::Signed, GL_ALPHA8_SNORM, 0, 1, kAlpha},
    {GL_SIGNED_ALPHA8_NV, Base::Alpha, Signs::Signed, GL_ALPHA8_SNORM, 0, 1, kAlpha},
    {GL_SIGNED_INTENSITY_NV, Base::Intensity, Signs::Signed, GL_INTENSITY8_SNORM, 0, 1, kIntensity},
    {GL_SIGNED_INTENSITY8_NV, Base::Intensity, Signs::Signed, GL_INTENSITY8_SNORM, 0, 1,
     kIntensity},
    {GL_SIGNED_RGB_UNSIGNED_ALPHA_NV, Base::Rgba, Signs::SignedRgb, GL_RGBA16_SNORM, 0, 1, kRgba},
    {GL_SIGNED_RGB8_UNSIGNED_ALPHA8_NV, Base::Rgba, Signs::SignedRgb, GL_RGBA16_SNORM, 0, 1, kRgba},
    {GL_HILO_NV, Base::Hilo, Signs::Unsigned, GL_RGB16, GL_HILO_NV, 1, kHilo16},
    {GL_HILO16_NV, Base::Hilo, Signs::Unsigned, GL_RGB16, GL_HILO_NV, 1, kHilo16},
    {GL_HILO8_NV, Base::Hilo, Signs::Unsigned, GL_RGB16, GL_HILO_NV, 3, kHilo8},
    {GL_SIGNED_HILO_NV, Base::Hilo, Signs::Signed, GL_RGB32F, GL_HILO_NV, 1, kHilo16},
    {GL_SIGNED_HILO16_NV, Base::Hilo, Signs::Signed, GL_RGB32F, GL_HILO_NV, 1, kHilo16},
    {GL_SIGNED_HILO8_NV, Base::Hilo, Signs::Signed, GL_RGB32F, GL_HILO_NV, 3, kHilo8},
    {GL_DSDT_NV, Base::Dsdt, Signs::Signed, GL_RG32F, GL_DSDT_NV, 1, kDsdt},
    {GL_DSDT8_NV, Base::Dsdt, Signs::Signed, GL_RG32F, GL_DSDT_NV, 1, kDsdt},
    {GL_DSDT_MAG_NV, Base::DsdtMag, Signs::Signed, GL_RGB32F, GL_DSDT_MAG_NV, 1, kDsdtMag},
    {GL_DSDT8_MAG8_NV, Base::DsdtMag, Signs::Signed, GL_RGB32F, GL_DSDT_MAG_NV, 1, kDsdtMag},
    {GL_DSDT_MAG_INTENSITY_NV, Base::DsdtMagIntensity, Signs::Signed, GL_RGBA32F,
     GL_DSDT_MAG_VIB_NV, 1, kDsdtMagIntensity},
    {GL_DSDT8_MAG8_INTENSITY8_NV, Base::DsdtMagIntensity, Signs::Signed, GL_RGBA32F,
     GL_DSDT_MAG_VIB_NV, 1, kDsdtMagIntensity},
    {GL_DUDV_ATI, Base::Dudv, Signs::Signed, GL_RG32F, GL_DUDV_ATI, 0, kDudv},
    {GL_DU8DV8_ATI, Base::Dudv, Signs::Signed, GL_RG32F, GL_DUDV_ATI, 0, kDudv},
};

} // namespace

int ComponentFormat::components() const { return external == 0 ? 0 : componentsOf(external); }

const ComponentFormat *componentFormat(GLenum name, int extensions) {
  const auto *const at = std::find_if(std::begin(kFormats), std::end(kFormats),
                                      [&](const auto &row) { return row.name == name; });
  return at == std::end(kFormats) || at->extension > extensions ? nullptr : at;
}

GLenum hostFormat(const ComponentFormat &format, const HostCaps &caps) {
  switch (format.host) {
  case GL_LUMINANCE8_SNORM:
  case GL_LUMINANCE8_ALPHA8_SNORM:
  case GL_ALPHA8_SNORM:
  case GL_INTENSITY8_SNORM:
    return caps.namedSnorm ? format.host : format.name;
  default:
    return format.host;
  }
}

bool isComponentFormat(GLenum format) { return componentsOf(format) != 0; }

int componentsOf(GLenum format) {
  switch (format) {
  case GL_HILO_NV:
  case GL_DSDT_NV:
  case GL_DUDV_ATI:
    return 2;
  case GL_DSDT_MAG_NV:
    return 3;
  case GL_DSDT_MAG_VIB_NV:
    return 4;
  default:
    return 0;
  }
}

bool isSignedPacked(GLenum type) {
  return type == GL_UNSIGNED_INT_S8_S8_8_8_NV || type == GL_UNSIGNED_INT_8_8_S8_S8_REV_NV;
}

} // namespace arbiter::state
