#include "fp_compiler/front/nvparse/text.h"

#include "fp_compiler/front/header.h"
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
  Reporter reporter;
  ParseResult result;
  const bool shaders = language == ir::Language::TextureShaders;
  const std::string_view header = shaders ? kShaderHeader : kCombinerHeader;
  const bool good = checkHeader(header, text, reporter);
  if (good || (names && text.size() <= kMaxTextBytes)) {
    const auto begin = good ? std::uint32_t(header.size()) : endOfWrongHeader(text);
    Text made;
    WordTokens tokens(text, begin, Words::Calls);
    std::uint32_t next = begin;
    if (shaders) {
      checkOffered(options.limits.textureShaders, {0, begin}, true, reporter, options.policy);
      ShaderParser(tokens, text, options, reporter, names).run(made.shaders.emplace(), made.values);
      next = tokens.peek().span.begin;
    }
    const std::string_view rest = text.substr(shaders ? next : begin);
    if (shaders && rest.starts_with(kCombinerHeader)) {
      next += std::uint32_t(kCombinerHeader.size());
      tokens = WordTokens(text, next, Words::Calls);
    }
    if (!shaders || rest.starts_with(kCombinerHeader)) {
      checkOffered(options.limits.generalCombiners,
                   {next - std::uint32_t(good || shaders ? kCombinerHeader.size() : 0), next},
                   false, reporter, options.policy);
      CombinerParser(tokens, text, options, reporter, names)
          .run(made.combiners.emplace(), made.values);
    } else if (tokens.peek().kind != TokenKind::EndOfText && !reporter.full()) {
      reporter.error(DiagnosticId::Syntax, tokens.peek().span,
                     "expected a stage or !!RC1.0, found '!'");
    }
    if (!reporter.hasErrors())
      result.text = made;
  }
  result.diagnostics = reporter.take();
  return result;
}

} // namespace arbiter::fp::nvparse
