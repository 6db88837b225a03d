#pragma once
#include <epoxy/gl.h>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

namespace demos {

/// A file of demos/programs that is built in.
struct ProgramText {
  std::string_view name;
  std::string_view text;
};
extern const ProgramText kProgramTexts[];
extern const unsigned kProgramTextCount;

/// A fragment program object of the current context. The destructor deletes it.
class Program {
public:
  Program() = default;
  ~Program();
  Program(const Program &) = delete;
  Program &operator=(const Program &) = delete;

  /// Loads a built-in text, or the file at \p overridePath if that is not empty. If GL rejects it,
  /// prints GL's message and the line at GL_PROGRAM_ERROR_POSITION_ARB, and returns false.
  [[nodiscard]] bool load(std::string_view name, const std::string &overridePath = {});

  /// Binds and enables the program.
  void use() const;
  static void disable();
  /// Sets a local parameter. The program need not be in use, but is bound afterwards.
  void local(GLuint index, const glm::vec4 &value) const;
  /// Returns glGetProgramivARB's counts as a JSON object.
  [[nodiscard]] std::string countsAsJson() const;

private:
  GLuint m_name = 0;
  std::string m_label;
};

} // namespace demos
