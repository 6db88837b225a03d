#include "fp_compiler/front/nvparse/text.h"

#include "fp_compiler/front/nvparse/combiner_parser.h"
#include "fp_compiler/front/nvparse/shader_parser.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::nvparse {

namespace {

using texture_shader::Base;
using texture_shader::Family;
using texture_shader::Signs;

void checkOffered(std::uint32_t offered, Span header, bool shaders, Reporter &reporter,
                  LimitPolicy policy) {
  if (offered != 0)
    return;
  std::string message = shaders ? "NV_texture_shader is not offered under this profile"
                                : "NV_register_combiners is not offered under this profile";
  std::string hint = shaders ? "the profiles from nv20 to nv40 and host have it"
                             : "the profiles from nv10 to nv40 and host have it";
  if (policy == LimitPolicy::Enforce)
    reporter.error(DiagnosticId::NvparseNotOffered, header, std::move(message), std::move(hint));
  else
    reporter.warning(DiagnosticId::NvparseNotOffered, header, std::move(message), std::move(hint));
}

} // namespace

std::array<texture_shader::Texture, texture_shader::kUnits>
assumedTextures(const texture_shader::State &state) {
  std::array<texture_shader::Texture, texture_shader::kUnits> textures;
  textures.fill({Base::Rgba, Signs::Unsigned, false});
  for (int unit = 0; unit < state.units; ++unit) {
    const texture_shader::Stage &stage = state.stages[std::size_t(unit)];
    const texture_shader::OperationInfo &info = texture_shader::infoOf(stage.operation);
    if ((info.family != Family::Offset && info.family != Family::Dependent) ||
        stage.previous >= unit)
      continue;
    texture_shader::Texture &read = textures[stage.previous];
    if (info.hilo)
      read = {Base::Hilo, Signs::Signed, false};
    else if (info.family == Family::Offset && (info.scale || read.base != Base::DsdtMag))
      read = {info.scale ? Base::DsdtMag : Base::Dsdt, Signs::Signed, false};
  }
  return textures;
}

ParseResult parse(ir::Language language, std::string_view text, const CompileOptions &options,
                  NameTable *names) {
  const bool shaders = language == ir::Language::TextureShaders;
  const std::string_view header = shaders ? kShaderHeader : kCombinerHeader;
  const auto read = [&](const SourceText &source, ParseResult &result) {
    Reporter &reporter = source.reporter;
    Text made;
    SourceText rest = source;
    Token end;
    if (shaders) {
      checkOffered(options.limits.textureShaders, {0, source.begin}, true, reporter,
                   options.policy);
      end = ShaderParser(source, options).run(made.shaders.emplace(), made.values);
      rest.begin = end.span.begin;
    }
    if (!shaders || text.substr(rest.begin).starts_with(kCombinerHeader)) {
      const auto headerBytes =
          std::uint32_t(shaders || text.starts_with(kCombinerHeader) ? kCombinerHeader.size() : 0);
      rest.begin += shaders ? headerBytes : 0;
      checkOffered(options.limits.generalCombiners, {rest.begin - headerBytes, rest.begin}, false,
                   reporter, options.policy);
      CombinerParser(rest, options).run(made.combiners.emplace(), made.values);
    } else if (end.kind != TokenKind::EndOfText && !reporter.full()) {
      reporter.error(DiagnosticId::Syntax, end.span, "expected a stage or !!RC1.0, found '!'");
    }
    if (!reporter.hasErrors())
      result.text = made;
  };
  return readText<ParseResult>(header, text, names, read);
}

} // namespace arbiter::fp::nvparse
