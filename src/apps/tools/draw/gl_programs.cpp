#include "apps/tools/draw/gl_programs.h"

#include <algorithm>

#include "apps/tools/draw/gl_state_text.h"

namespace arbiter::tools {

namespace {

/// The number of parameters of register combiners and texture shaders that texts can set.
constexpr int kStateParameters = fp::texture_shader::parameter(0, fp::texture_shader::Row::Bump);

using fp::ir::Language;
using scene::Setting;

/// ATI_text_fragment_shader uses the ARB program calls with this target, which Debian's headers
/// lack.
constexpr GLenum kTextFragmentShaderAti = 0x8200;

struct Limit {
  int count;
  const char *option;
  const char *what;
};

Limit limitOf(Setting space, GLenum target) {
  switch (space) {
  case Setting::Local:
    return {programLimit(target, GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB), "local", "local parameters"};
  case Setting::Env:
    return {programLimit(target, GL_MAX_PROGRAM_ENV_PARAMETERS_ARB), "env",
            "environment parameters"};
  default:
    return {query(GL_MAX_VERTEX_ATTRIBS_ARB), "attrib", "generic attributes"};
  }
}

/// Returns an error for a parameter that the program's target does not have; an ATI shader has none
/// at all. GL would report it without naming the parameter.
std::optional<RenderError> parametersBeyond(const scene::ProgramFile &file, std::size_t number) {
  const GLenum target = targetOf(file.language).name;
  const auto fault = [&](const scene::Parameter &parameter, const std::string &message) {
    return RenderError{RenderError::Kind::Panel, message, number, -1, parameter.span};
  };
  for (const scene::Parameter &parameter : file.panel.parameters) {
    const bool attrib = parameter.space == Setting::Attrib;
    if (isNvparse(file.language) && !attrib) {
      const bool beyond = parameter.first + parameter.count > kStateParameters;
      if (parameter.space == Setting::Local && parameter.span.end != 0)
        return fault(parameter, "combiners and texture shaders have no local parameters");
      if (parameter.space == Setting::Env && beyond)
        return fault(parameter, "env " + std::to_string(parameter.first) + ": there are " +
                                    std::to_string(kStateParameters));
      continue;
    }
    if (file.language == Language::AtiFragment && !attrib) {
      if (parameter.span.end != 0)
        return fault(parameter, "an ATI shader has no parameters; its constants are in its text");
      continue;
    }
    const Limit limit = limitOf(parameter.space, target);
    const std::string name = (parameter.span.end == 0 ? "--" : "") + std::string(limit.option) +
                             " " + std::to_string(parameter.first);
    if (int(parameter.first + parameter.count) > limit.count)
      return fault(parameter,
                   name + ": there are " + std::to_string(limit.count) + " " + limit.what);
    if (attrib && parameter.first == 0)
      return fault(parameter, "attribute 0 is the position, which the mesh gives");
  }
  return std::nullopt;
}

void give(GLenum target, const scene::ParameterRow &row) {
  if (row.space == Setting::Local)
    glProgramLocalParameter4fvARB(target, row.index, row.value.data());
  else if (row.space == Setting::Env)
    glProgramEnvParameter4fvARB(target, row.index, row.value.data());
}

} // namespace

int query(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

int programLimit(GLenum target, GLenum name) {
  GLint value = 0;
  glGetProgramivARB(target, name, &value);
  return value;
}

GLenum glTarget(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return GL_TEXTURE_1D;
  case TexTarget::Tex3D:
    return GL_TEXTURE_3D;
  case TexTarget::Cube:
    return GL_TEXTURE_CUBE_MAP;
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return GL_TEXTURE_RECTANGLE;
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    break;
  }
  return GL_TEXTURE_2D;
}

ProgramTarget targetOf(Language language) {
  switch (language) {
  case Language::ArbVertex:
    return {GL_VERTEX_PROGRAM_ARB, "GL_ARB_vertex_program"};
  case Language::AtiFragment:
    return {kTextFragmentShaderAti, "GL_ATI_text_fragment_shader"};
  case Language::Combiners:
    return {GL_REGISTER_COMBINERS_NV, "GL_NV_register_combiners"};
  case Language::TextureShaders:
    return {GL_TEXTURE_SHADER_NV, "GL_NV_texture_shader"};
  case Language::ArbFragment:
    break;
  }
  return {GL_FRAGMENT_PROGRAM_ARB, "GL_ARB_fragment_program"};
}

Programs::~Programs() {
  if (!m_names.empty())
    glDeleteProgramsARB(GLsizei(m_names.size()), m_names.data());
}

std::optional<RenderError> Programs::load(const scene::Document &document) {
  for (std::size_t i = 0; i < document.files.size(); ++i)
    if (auto error = loadFile(document, i))
      return error;
  return std::nullopt;
}

std::optional<RenderError> Programs::loadFile(const scene::Document &document, std::size_t index) {
  const scene::ProgramFile &file = document.files[index];
  const ProgramTarget target = targetOf(file.language);
  if (!epoxy_has_gl_extension(target.extension))
    return RenderError{RenderError::Kind::NoGl, std::string("this GL has no ") + target.extension};
  if (auto error = parametersBeyond(file, index))
    return error;
  GLuint &name = m_names.emplace_back(0);
  m_states.emplace_back();
  if (isNvparse(file.language))
    return loadState(document, index);
  glGenProgramsARB(1, &name);
  glBindProgramARB(target.name, name);
  const std::string_view source = file.source();
  glProgramStringARB(target.name, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(source.size()),
                     source.data());
  if (glGetError() == GL_NO_ERROR)
    return std::nullopt;
  const auto *text = reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
  return RenderError{RenderError::Kind::Program, text == nullptr ? "" : text, index,
                     query(GL_PROGRAM_ERROR_POSITION_ARB)};
}

/// Parses the text by the context's limits, because GL itself has no such texts.
std::optional<RenderError> Programs::loadState(const scene::Document &document, std::size_t index) {
  const scene::ProgramFile &file = document.files[index];
  const fp::nvparse::ParseResult parsed = fp::nvparse::parse(
      file.language, file.source(), {stateTextLimits(), fp::LimitPolicy::Enforce});
  if (!parsed.text) {
    const auto error = std::find_if(
        parsed.diagnostics.begin(), parsed.diagnostics.end(),
        [](const fp::Diagnostic &each) { return each.severity == fp::Severity::Error; });
    return RenderError{RenderError::Kind::Program,
                       fp::renderAll("program", file.source(), parsed.diagnostics), index,
                       error == parsed.diagnostics.end() ? 0 : int(error->span.begin)};
  }
  m_states[index] = parsed.text;
  return std::nullopt;
}

/// Sets the state and its values. Also sets them as parameters of ARB fragment programs, by which
/// the debugger shows a state's values.
void Programs::useState(std::size_t file, const std::vector<scene::ParameterRow> &rows) const {
  issueStateText(*m_states[file]);
  for (const scene::ParameterRow &row : rows)
    if (row.space == Setting::Env && !m_states[file]->values[row.index]) {
      giveStateValue(int(row.index), row.value);
      if (epoxy_has_gl_extension("GL_ARB_fragment_program"))
        give(GL_FRAGMENT_PROGRAM_ARB, row);
    }
}

void Programs::use(const scene::Document &document, const scene::Pass &pass, double seconds) const {
  for (const int file : {pass.vertex, pass.fragment}) {
    if (file < 0)
      continue;
    const Language language = document.files[std::size_t(file)].language;
    if (isNvparse(language)) {
      useState(std::size_t(file), document.rows(pass, file, seconds));
      continue;
    }
    const GLenum target = targetOf(language).name;
    glBindProgramARB(target, m_names[std::size_t(file)]);
    glEnable(target);
    if (language != Language::AtiFragment)
      for (const scene::ParameterRow &row : document.rows(pass, file, seconds))
        give(target, row);
  }
  if (pass.vertex < 0)
    return;
  for (const scene::ParameterRow &row : document.rows(pass, pass.panel, seconds))
    if (row.space == Setting::Attrib)
      glVertexAttrib4fvARB(row.index, row.value.data());
}

void Programs::disable(const scene::Document &document) {
  for (const scene::ProgramFile &file : document.files)
    if (isNvparse(file.language))
      disableStateTexts();
    else
      glDisable(targetOf(file.language).name);
}

} // namespace arbiter::tools
