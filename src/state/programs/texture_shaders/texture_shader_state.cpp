#include "state/programs/texture_shaders/texture_shader_state.h"

#include <algorithm>

#include "state/era/era_state.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/state_text.h"
#include "state/share/share_group.h"

namespace arbiter::state {

using fp::texture_shader::Key;
using fp::texture_shader::Row;

namespace {

void setEnv(ProgramContext &context, int index, const Vec4 &value) {
  ProgramTarget &row = context.row(Target::TextureShaders);
  row.env[std::size_t(index)] = value;
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

} // namespace

TextureShaderSettings &TextureShaderState::writable() {
  if (m_settings.use_count() > 1)
    m_settings = std::make_shared<TextureShaderSettings>(*m_settings);
  return *m_settings;
}

void TextureShaderState::changed(ProgramContext &context) {
  if (effective || m_settings->environmentNone != 0 || m_settings->bumps != 0 ||
      context.row(Target::TextureShaders).enabled)
    invalidateProgram(context);
}

void TextureShaderState::setRow(ProgramContext &context, int unit, Row row, const Vec4 &value) {
  const auto at = std::size_t(row);
  if (m_settings->rows[std::size_t(unit)][at] == value)
    return;
  writable().rows[std::size_t(unit)][at] = value;
  setEnv(context, fp::texture_shader::parameter(unit, row), value);
}

void TextureShaderState::restore(ProgramContext &context,
                                 const std::shared_ptr<const TextureShaderSettings> &settings) {
  if (settings == m_settings)
    return;
  changed(context);
  // valid, because this class made them
  m_settings = std::const_pointer_cast<TextureShaderSettings>(settings);
  setParameters(context);
  changed(context);
}

void TextureShaderState::setParameters(ProgramContext &context) {
  if (context.combiners)
    for (int index = 0; index < fp::combiners::kConstants; ++index)
      setEnv(context, index, context.combiners->constant(index));
  for (int unit = 0; unit < fp::texture_shader::kUnits; ++unit)
    for (const Row row : {Row::Matrix, Row::ScaleBias, Row::Eye, Row::Bump})
      setEnv(context, fp::texture_shader::parameter(unit, row),
             m_settings->rows[std::size_t(unit)][std::size_t(row)]);
}

std::shared_ptr<const CompiledProgram> TextureShaderState::programUnder(ProgramContext &context,
                                                                        const Key &key,
                                                                        const fp::GlslHost &host,
                                                                        const StateText *text) {
  StatePrograms<Key> &programs = text ? m_named.of(context, text->key()) : m_programs;
  return programs.of(context, Target::TextureShaders, key, host, text, [&](const Key &of) {
    fp::ir::Program program = fp::texture_shader::lower(of);
    if (text && text->replaced)
      fp::texture_shader::bindValues(program, text->replaced->values);
    return program;
  });
}

bool mayKeepTextures(const ProgramContext &context) {
  return context.textureShaders || hasBumpMaps(context) ||
         (context.era && context.era->offered.pointSprite);
}

TextureShaderState &keepTextures(ProgramContext &context) {
  if (!context.textureShaders) {
    context.row(Target::TextureShaders).env.assign(fp::texture_shader::kParameters, Vec4{});
    context.textureShaders =
        std::make_unique<TextureShaderState>(0, std::min(context.caps.maxTextureUnits, 8));
    context.textureShaders->setParameters(context);
  }
  return *context.textureShaders;
}

bool hasTextureShaders(const ProgramContext &context) {
  return context.textureShaders && context.textureShaders->extensions() != 0;
}

bool hasBumpMaps(const ProgramContext &context) {
  return context.era && context.era->offered.bumpMap;
}

bool followsTextures(const ProgramContext &context) {
  const TextureShaderState *const shaders = context.textureShaders.get();
  return shaders && (shaders->effective || shaders->now().environmentNone != 0 ||
                     shaders->now().bumps != 0 || context.group->textureFormats.any());
}

bool textureShaderValue(const ProgramContext &context, GLint &value) {
  value = context.row(Target::TextureShaders).enabled ? 1 : 0;
  return hasTextureShaders(context);
}

} // namespace arbiter::state
