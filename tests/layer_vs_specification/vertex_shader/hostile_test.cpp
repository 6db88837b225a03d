// EXT_vertex_shader: random commands, most of them errors, with draws between them. Nothing may
// crash, and later draws are unaffected.
#include <array>
#include <random>

#include "vertex_shaders.h"

namespace api::vertex_shaders {
namespace {

/// Returns valid and invalid names and enumerants.
class Commands {
public:
  explicit Commands(unsigned seed) : m_engine(seed) {}

  void one() {
    switch (below(18)) {
    case 0:
      return keep(glGenSymbolsEXT(GL_SCALAR_EXT + below(4), GL_VARIANT_EXT + below(5),
                                  GL_NORMALIZED_RANGE_EXT + below(3), below(6)));
    case 1:
      return below(2) ? glBeginVertexShaderEXT() : glEndVertexShaderEXT();
    case 2:
      return glBindVertexShaderEXT(below(4));
    case 3:
      return glDeleteVertexShaderEXT(below(4));
    case 4:
      return keep(glBindParameterEXT(kParameters[below(kParameters.size())]));
    case 5:
      return keep(glBindLightParameterEXT(GL_LIGHT0 + below(10), GL_AMBIENT + below(12)));
    case 6:
      return glSetInvariantEXT(name(), type(), m_numbers.data());
    case 7:
      return glSetLocalConstantEXT(name(), type(), m_numbers.data());
    case 8:
      return glVariantfvEXT(name(), m_numbers.data());
    case 9:
      return glVariantPointerEXT(name(), type(), below(3) * 32, m_numbers.data());
    case 10:
      return below(3) ? glDisableVariantClientStateEXT(name())
                      : glEnableVariantClientStateEXT(name());
    case 11:
      return glSwizzleEXT(result(), name(), take(), take(), take(), take());
    case 12:
      return glWriteMaskEXT(result(), name(), below(2), below(2), below(2), below(3));
    case 13:
      return glInsertComponentEXT(result(), name(), below(5));
    case 14:
      return glExtractComponentEXT(result(), name(), below(5));
    case 15:
      return glGetVariantFloatvEXT(name(), GL_VARIANT_VALUE_EXT + below(5), m_answers.data());
    default:
      return operation();
    }
  }

private:
  static constexpr std::array<GLenum, 6> kParameters = {GL_CURRENT_VERTEX_EXT, GL_MVP_MATRIX_EXT,
                                                        GL_CURRENT_COLOR,      GL_FOG_START,
                                                        GL_CLIP_PLANE0,        GL_FOG_MODE};

  GLuint below(std::size_t count) { return GLuint(m_engine() % count); }
  void keep(GLuint name) { m_names[m_next++ % m_names.size()] = name; }
  /// Returns the name of one of the last symbols, or a following one in its block, which may not
  /// exist.
  GLuint name() { return m_names[below(m_names.size())] + below(3); }
  GLuint result() { return below(3) ? name() : GL_OUTPUT_VERTEX_EXT + below(36); }
  GLenum type() { return GL_BYTE + below(12); }
  GLenum take() { return GL_X_EXT + below(12); }
  void operation() {
    const GLenum op = GL_OP_INDEX_EXT + below(25);
    switch (below(3)) {
    case 0:
      return glShaderOp1EXT(op, result(), name());
    case 1:
      return glShaderOp2EXT(op, result(), name(), name());
    default:
      return glShaderOp3EXT(op, result(), name(), name(), name());
    }
  }

  std::mt19937 m_engine;
  std::array<GLuint, 12> m_names{};
  std::size_t m_next = 0;
  std::array<GLfloat, 1024> m_numbers{};
  std::array<GLfloat, 16> m_answers{};
};

TEST_F(EraVertexShaders, CommandsAtRandom) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const GlContext other;
    Commands commands(seed);
    glEnable(GL_VERTEX_SHADER_EXT);
    for (int i = 0; i < 500; ++i) {
      commands.one();
      if (i % 50 == 49)
        drawQuad();
      while (glGetError() != GL_NO_ERROR) {
      }
    }
    glDisable(GL_VERTEX_SHADER_EXT);
    EXPECT_EQ(drawn(), kBluePixel) << seed;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
  m_context.makeCurrent();
}

} // namespace
} // namespace api::vertex_shaders
