#pragma once
#include <array>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/ati/shader.h"

namespace arbiter::state {

/// Builds a shader from the commands between BeginFragmentShaderATI and EndFragmentShaderATI
/// (ATI_fragment_shader, "AFS", 3.8.11) and knows when each is an error. A command that is an error
/// leaves the shader as it was.
class AtiRecorder {
public:
  /// NO_ERROR: the command is in the shader. `why` says what is wrong, for the log.
  struct Verdict {
    GLenum error = GL_NO_ERROR;
    const char *why = "";
  };

  /// An argument as ColorFragmentOp and AlphaFragmentOp take it.
  struct RawArgument {
    GLuint source = 0;
    GLuint replicate = 0;
    GLuint modifiers = 0;
  };
  /// The parameters of one of these six commands. An alpha operation has no mask.
  struct RawOperation {
    bool alpha = false;
    int argumentCount = 1; ///< by the command's name
    GLenum op = 0;
    GLuint destination = 0;
    GLuint mask = 0;
    GLuint modifiers = 0;
    std::array<RawArgument, 3> arguments{};
  };

  /// Registers and texture coordinate sets go no further than the implementation's units (AFS
  /// Errors).
  AtiRecorder(GLuint imageUnits, GLuint coordinateSets)
      : m_imageUnits(imageUnits), m_coordinateSets(coordinateSets) {}

  /// PassTexCoordATI or SampleMapATI: the first one after an operation begins the second pass.
  [[nodiscard]] Verdict setup(fp::ati::SetupKind kind, GLuint destination, GLuint source,
                              GLenum swizzle);
  [[nodiscard]] Verdict operation(const RawOperation &raw);
  /// SetFragmentShaderConstantATI: the constant is the shader's own (AFS:632). `constant` is valid.
  void setConstant(int constant, const fp::ir::Vec4 &value);
  /// EndFragmentShaderATI: what only the whole shader tells. After an error there is no shader.
  [[nodiscard]] Verdict end() const;
  [[nodiscard]] const fp::ati::Shader &shader() const { return m_shader; }

private:
  [[nodiscard]] bool isRegister(GLuint name) const;
  [[nodiscard]] Verdict checkSource(int pass, GLuint source, GLenum swizzle) const;
  [[nodiscard]] Verdict checkPairing(const RawOperation &raw) const;

  GLuint m_imageUnits;
  GLuint m_coordinateSets;
  fp::ati::Shader m_shader;
  /// The last command of the pass was a colour operation: an alpha operation joins its pair.
  bool m_afterColor = false;
  bool m_colorsInFirstPass = false; ///< PRIMARY_COLOR or SECONDARY_INTERPOLATOR was read there
  /// By coordinate set: 0 unused, 1 read as STR, 2 as STQ.
  std::array<std::uint8_t, fp::ati::kTexCoords> m_families{};
};

/// The number of CON_x_ATI; -1 if `name` is none.
[[nodiscard]] constexpr int atiConstant(GLuint name) {
  return name >= GL_CON_0_ATI && name <= GL_CON_7_ATI ? int(name - GL_CON_0_ATI) : -1;
}

} // namespace arbiter::state
