#include "common/program.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace demos {
namespace {

/// Prints FILE:LINE:COLUMN, the message, the line and a caret.
void reportError(const std::string &label, std::string_view text, GLint position) {
  const auto *message = reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
  const std::size_t at = std::min(text.size(), std::size_t(std::max(position, 0)));
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(begin), '\n');
  const std::string shown(text.substr(begin, end - begin));
  std::fprintf(stderr, "%s:%td:%zu: error: byte %d: %s\n  %s\n  %*s^\n", label.c_str(), line,
               at - begin + 1, position, message ? message : "(no message)", shown.c_str(),
               int(at - begin), "");
}

bool readText(const std::string &path, std::string &text) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
    return false;
  }
  text.assign(std::istreambuf_iterator<char>(file), {});
  return true;
}

bool findText(std::string_view name, std::string &text) {
  const auto *end = kProgramTexts + kProgramTextCount;
  const auto *row =
      std::find_if(kProgramTexts, end, [&](const ProgramText &t) { return t.name == name; });
  if (row == end) {
    std::fprintf(stderr, "%.*s: no such built-in program\n", int(name.size()), name.data());
    return false;
  }
  text = row->text;
  return true;
}

} // namespace

Program::~Program() {
  if (m_name)
    glDeleteProgramsARB(1, &m_name);
}

bool Program::load(std::string_view name, const std::string &overridePath) {
  std::string text;
  m_label = overridePath.empty() ? std::string(name) : overridePath;
  if (!(overridePath.empty() ? findText(name, text) : readText(overridePath, text)))
    return false;
  if (!m_name)
    glGenProgramsARB(1, &m_name);
  while (glGetError() != GL_NO_ERROR) {
  }
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_name);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                     text.data());
  const GLenum error = glGetError();
  GLint position = -1;
  glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
  if (error == GL_NO_ERROR && position == -1)
    return true;
  reportError(m_label, text, position);
  return false;
}

void Program::use() const {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_name);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
}

void Program::disable() { glDisable(GL_FRAGMENT_PROGRAM_ARB); }

void Program::local(GLuint index, const glm::vec4 &value) const {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_name);
  glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, index, &value.x);
}

std::string Program::countsAsJson() const {
  static constexpr struct {
    const char *key;
    GLenum name;
  } kCounts[] = {{"instructions", GL_PROGRAM_INSTRUCTIONS_ARB},
                 {"alu", GL_PROGRAM_ALU_INSTRUCTIONS_ARB},
                 {"tex", GL_PROGRAM_TEX_INSTRUCTIONS_ARB},
                 {"indirections", GL_PROGRAM_TEX_INDIRECTIONS_ARB},
                 {"temporaries", GL_PROGRAM_TEMPORARIES_ARB},
                 {"parameters", GL_PROGRAM_PARAMETERS_ARB},
                 {"attribs", GL_PROGRAM_ATTRIBS_ARB},
                 {"under_native_limits", GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB}};
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_name);
  std::string json = "{\"name\": \"" + m_label + "\"";
  for (const auto &count : kCounts) {
    GLint value = -1;
    glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, count.name, &value);
    json += std::string(", \"") + count.key + "\": " + std::to_string(value);
  }
  return json + "}";
}

} // namespace demos
