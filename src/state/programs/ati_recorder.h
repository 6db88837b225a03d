#pragma once
#include <array>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/ati/shader.h"

namespace arbiter::state {

/// Builds a shader from the commands between BeginFragmentShaderATI and EndFragmentShaderATI
/// (ATI_fragment_shader, "AFS", 3.8.11), and detects errors. A command with an error leaves the
/// shader unchanged.
class AtiRecorder {
public:
  /// The result of a command. NO_ERROR: the command is in the shader. `why` tells what is wrong,
  /// for the log.
  struct Verdict {
    GLenum error = GL_NO_ERROR;
    const char *why = "";
  };

  /// An argument of ColorFragmentOp or AlphaFragmentOp, as passed.
  struct RawArgument {
    GLuint source = 0;
    GLuint replicate = 0;
    GLuint modifiers = 0;
  };
  /// The parameters of one of the six operation commands. An alpha operation has no mask.
  struct RawOperation {
    bool alpha = false;
    int argumentCount = 1; ///< the number in the command's name
    GLenum op = 0;
    GLuint destination = 0;
    GLuint mask = 0;
    GLuint modifiers = 0;
    std::array<RawArgument, 3> arguments{};
  };

  /// Registers and texture coordinate sets are limited to the implementation's units (AFS Errors).
  AtiRecorder(GLuint imageUnits, GLuint coordinateSets)
      : m_imageUnits(imageUnits), m_coordinateSets(coordinateSets) {}

  /// Adds PassTexCoordATI or SampleMapATI. The first one after an operation begins the second pass.
  [[nodiscard]] Verdict setup(fp::ati::SetupKind kind, GLuint destination, GLuint source,
                              GLenum swizzle);
  [[nodiscard]] Verdict operation(const RawOperation &raw);
  /// Sets a constant of the shader's own: SetFragmentShaderConstantATI (AFS:632). Requires that
  /// `constant` is valid.
  void setConstant(int constant, const fp::ir::Vec4 &value);
  /// Checks the whole shader at EndFragmentShaderATI. After an error there is no shader.
  [[nodiscard]] Verdict end() const;
  [[nodiscard]] const fp::ati::Shader &shader() const { return m_shader; }

private:
  [[nodiscard]] bool isRegister(GLuint name) const;
  [[nodiscard]] Verdict checkSource(int pass, GLuint source, GLenum swizzle) const;
  [[nodiscard]] Verdict checkPairing(const RawOperation &raw) const;

  GLuint m_imageUnits;
  GLuint m_coordinateSets;
  fp::ati::Shader m_shader;
  /// True if the last command of the pass was a colour operation, so that an alpha operation joins
  /// its pair.
  bool m_afterColor = false;
  /// true if PRIMARY_COLOR or SECONDARY_INTERPOLATOR was read in the first pass
  bool m_colorsInFirstPass = false;
  /// How each coordinate set is used: 0 not, 1 as STR, 2 as STQ.
  std::array<std::uint8_t, fp::ati::kTexCoords> m_families{};
};

/// Returns the number of CON_x_ATI, or -1 for another name.
[[nodiscard]] constexpr int atiConstant(GLuint name) {
  return name >= GL_CON_0_ATI && name <= GL_CON_7_ATI ? int(name - GL_CON_0_ATI) : -1;
}

} // namespace arbiter::state
