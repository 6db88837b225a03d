#include "state/report/capture_row.h"

#include <cstdio>
#include <string_view>

#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/resources.h"
#include "state/report/format_name.h"

namespace arbiter::state {

namespace {

void writeTexture(JsonWriter &json, const TextureUse &use) {
  json.beginObject();
  json.key("unit").value(unsigned(use.unit)).key("target").value(fp::ir::targetText(use.target));
  json.key("name").value(use.name);
  json.key("width").value(use.width).key("height").value(use.height).key("depth").value(use.depth);
  json.key("format").value(formatName(use.format)).key("enabled").beginArray();
  for (std::size_t i = 0; i < std::size(kFixedTargets); ++i)
    if (use.enabled >> i & 1)
      json.value(kFixedTargets[i].name);
  json.endArray().endObject();
}

} // namespace

std::string formatName(GLint format) {
  struct Name {
    GLenum format;
    const char *name;
  };
  static constexpr Name kNames[] = {
      {1, "1"},
      {2, "2"},
      {3, "3"},
      {4, "4"},
      {GL_ALPHA, "ALPHA"},
      {GL_RGB, "RGB"},
      {GL_RGBA, "RGBA"},
      {GL_LUMINANCE, "LUMINANCE"},
      {GL_LUMINANCE_ALPHA, "LUMINANCE_ALPHA"},
      {GL_ALPHA8, "ALPHA8"},
      {GL_LUMINANCE8, "LUMINANCE8"},
      {GL_LUMINANCE16, "LUMINANCE16"},
      {GL_LUMINANCE8_ALPHA8, "LUMINANCE8_ALPHA8"},
      {GL_INTENSITY, "INTENSITY"},
      {GL_INTENSITY8, "INTENSITY8"},
      {GL_RGB5, "RGB5"},
      {GL_RGB8, "RGB8"},
      {GL_RGB16, "RGB16"},
      {GL_RGBA4, "RGBA4"},
      {GL_RGB5_A1, "RGB5_A1"},
      {GL_RGBA8, "RGBA8"},
      {GL_RGB10_A2, "RGB10_A2"},
      {GL_RGBA16, "RGBA16"},
      {GL_RGBA16F, "RGBA16F"},
      {GL_RGBA32F, "RGBA32F"},
      {GL_R8, "R8"},
      {GL_RG8, "RG8"},
      {GL_R16, "R16"},
      {GL_R32F, "R32F"},
      {GL_SRGB8, "SRGB8"},
      {GL_SRGB8_ALPHA8, "SRGB8_ALPHA8"},
      {GL_DEPTH_COMPONENT, "DEPTH_COMPONENT"},
      {GL_DEPTH_COMPONENT16, "DEPTH_COMPONENT16"},
      {GL_DEPTH_COMPONENT24, "DEPTH_COMPONENT24"},
      {GL_DEPTH24_STENCIL8, "DEPTH24_STENCIL8"},
      {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, "COMPRESSED_RGB_S3TC_DXT1"},
      {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, "COMPRESSED_RGBA_S3TC_DXT1"},
      {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, "COMPRESSED_RGBA_S3TC_DXT3"},
      {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, "COMPRESSED_RGBA_S3TC_DXT5"},
  };
  for (const Name &row : kNames)
    if (GLint(row.format) == format)
      return row.name;
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", unsigned(format));
  return text;
}

std::vector<const char *> optionNames(const fp::ir::Options &options, bool vertex) {
  std::vector<const char *> names;
  constexpr const char *kNv[2][3] = {{nullptr, "NV_fragment_program", "NV_fragment_program2"},
                                     {nullptr, "NV_vertex_program2", "NV_vertex_program3"}};
  constexpr const char *kPrecision[] = {nullptr, "ARB_precision_hint_fastest",
                                        "ARB_precision_hint_nicest"};
  const bool own = options.native != fp::ir::NativeLanguage::None; // the header says it
  for (const char *name :
       {own ? nullptr : kNv[vertex ? 1 : 0][std::size_t(options.nv)],
        fp::ir::rowOf(options.fog).option, kPrecision[std::size_t(options.precision)],
        options.shadow ? "ARB_fragment_program_shadow" : nullptr,
        options.drawBuffers ? "ARB_draw_buffers" : nullptr,
        options.originUpperLeft ? "ARB_fragment_coord_origin_upper_left" : nullptr,
        options.pixelCenterInteger ? "ARB_fragment_coord_pixel_center_integer" : nullptr,
        !options.positionInvariant ? nullptr
        : own                      ? "NV_position_invariant"
                                   : "ARB_position_invariant"})
    if (name)
      names.push_back(name);
  return names;
}

void CaptureRow::add(const DrawsBy &added) {
  if (added.count == 0)
    return;
  for (DrawsBy &each : draws)
    if (std::string_view(each.path) == added.path) {
      each.count += added.count;
      return;
    }
  draws.push_back(added);
}

void CaptureRow::write(JsonWriter &json) const {
  json.beginObject();
  json.key("hash").value(hash).key("target").value(infoOf(target).word);
  std::uint64_t all = 0;
  DrawsBy most;
  for (const DrawsBy &each : draws) {
    all += each.count;
    most = each.count > most.count ? each : most;
  }
  json.key("loads").value(loads).key("frames").value(frames).key("draws").value(all);
  json.key("draws_by").beginObject();
  for (const DrawsBy &each : draws)
    json.key(each.path).value(each.count);
  json.endObject();
  json.key("replaced").value(replaced);
  json.key("contexts").beginArray();
  for (const std::uint32_t context : contexts)
    json.value(context);
  json.endArray().key("options").beginArray();
  for (const char *option : options)
    json.value(option);
  json.endArray();
  if (counted) {
    fp::writeCounts(json, "counts", counts);
    fp::writeCounts(json, "native_counts", nativeCounts);
    json.key("under_native_limits").value(underNativeLimits);
  }
  json.key("error");
  if (error.empty())
    json.null();
  else
    json.beginObject().key("position").value(errorPosition).key("text").value(error).endObject();
  if (!warning.empty())
    json.key("warning").value(warning);
  json.key("last_use").value(lastUse).key("path").value(most.path);
  json.key("parameters").beginArray();
  for (std::size_t i = 0; program && i < values.size(); ++i) {
    json.beginObject();
    json.key("name").value(fp::ir::bindingText(program->glsl.uniforms[i].parameter));
    json.key("value").beginArray();
    for (const GLfloat component : values[i])
      json.value(double(component));
    json.endArray().endObject();
  }
  json.endArray().key("textures").beginArray();
  for (const TextureUse &use : textures)
    writeTexture(json, use);
  json.endArray().endObject();
}

} // namespace arbiter::state
