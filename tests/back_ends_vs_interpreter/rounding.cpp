// rounding: compares the rounding functions of Fp24's GLSL, on this host, with
// fp_compiler/numerics.h, for every single with a mantissa of 16 bits, its ties and their
// neighbors.
//
// usage: rounding [LOW...]   selects the 7 bits below those 16; without one, all that matter
// Exit status: 0 all agree, 1 some differ, 77 no GL context, or none with the needed features.
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fp_compiler/back/glsl/helpers.h"
#include "gl_host.h"

namespace {
using namespace arbiter;
using namespace arbiter::differential;

constexpr int kWidth = 2048, kHeight = 2048;
constexpr std::size_t kValues = std::size_t(kWidth) * kHeight * 4;
/// The 7 bits below the 16: zero, half a unit, and its neighbors.
constexpr std::uint32_t kLow[] = {0, 1, 63, 64, 65, 127};

struct Function {
  const char *name;
  float (*reference)(float);
};
constexpr Function kFunctions[] = {{"arb_round", fp::fp24::rounded},
                                   {"arb_truncate", fp::fp24::truncated},
                                   {"arb_colour", fp::fp24::color}};

bool hasExtension(const char *name) {
  const auto *const all = reinterpret_cast<const char *>(glGetString(GL_EXTENSIONS));
  return all && std::strstr(all, name);
}

GLuint floatTexture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_RECTANGLE, name);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA32F, kWidth, kHeight, 0, GL_RGBA, GL_FLOAT, nullptr);
  return name;
}

/// Makes a program that applies the function to each texel; 0, with the host's message, if it
/// cannot.
GLuint programOf(const char *function) {
  const std::string call = std::string(function) + "(";
  const std::string text =
      "#version 120\n#extension GL_EXT_gpu_shader4 : require\n"
      "#extension GL_ARB_shader_bit_encoding : require\n"
      "#extension GL_ARB_texture_rectangle : enable\nuniform sampler2DRect texels;\n" +
      fp::glsl::helpers({}, fp::Numerics::Fp24, call) + "void main() {\n  gl_FragColor = " + call +
      "texture2DRect(texels, gl_FragCoord.xy));\n}\n";
  const char *const source = text.c_str();
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER), program = glCreateProgram();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked)
    return program;
  char log[4096] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  std::printf("%s: not compiled: %s\n%s", function, log, text.c_str());
  return 0;
}

bool same(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

class Rounding {
public:
  Rounding() : m_values(kValues), m_seen(kValues), m_texels(floatTexture()) {
    GLuint framebuffer = 0;
    const GLuint target = floatTexture();
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_RECTANGLE, target, 0);
    glBindTexture(GL_TEXTURE_RECTANGLE, m_texels);
    glViewport(0, 0, kWidth, kHeight);
    glClampColorARB(GL_CLAMP_FRAGMENT_COLOR_ARB, GL_FALSE);
    glClampColorARB(GL_CLAMP_READ_COLOR_ARB, GL_FALSE);
  }

  [[nodiscard]] std::uint64_t differences() const { return m_different; }
  [[nodiscard]] std::uint64_t compared() const { return m_compared; }

  /// Tests every sign, exponent and 16 bits of mantissa, with the same bits below them.
  void all(std::uint32_t low) {
    for (std::uint64_t first = 0; first < 1u << 25; first += kValues) {
      for (std::size_t i = 0; i < kValues; ++i)
        m_values[i] = std::bit_cast<float>(std::uint32_t(first + i) << 7 | low);
      glTexSubImage2D(GL_TEXTURE_RECTANGLE, 0, 0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT,
                      m_values.data());
      for (const Function &function : kFunctions)
        compare(function);
    }
  }

private:
  void compare(const Function &function) {
    const GLuint program = programOf(function.name);
    if (!program) {
      ++m_different;
      return;
    }
    glUseProgram(program);
    glRectf(-1, -1, 1, 1);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT, m_seen.data());
    glUseProgram(0);
    glDeleteProgram(program);
    m_compared += kValues;
    for (std::size_t i = 0; i < kValues; ++i) {
      const float expected = function.reference(m_values[i]);
      if (same(m_seen[i], expected))
        continue;
      if (m_different++ < 10)
        std::printf("%s(%a) is %a, expected %a\n", function.name, double(m_values[i]),
                    double(m_seen[i]), double(expected));
    }
  }

  std::vector<float> m_values, m_seen;
  GLuint m_texels;
  std::uint64_t m_compared = 0, m_different = 0;
};
} // namespace

int main(int argc, char **argv) {
  std::string why;
  const auto host = GlHost::create(why);
  if (!host || !hasExtension("GL_EXT_gpu_shader4") || !hasExtension("GL_ARB_shader_bit_encoding")) {
    std::printf("rounding: skipped: %s%s\n", host ? "the host lacks it: " : "no GL context: ",
                host ? "bits of floats" : why.c_str());
    return 77;
  }
  Rounding rounding;
  if (argc == 1)
    for (const std::uint32_t low : kLow)
      rounding.all(low);
  for (int i = 1; i < argc; ++i)
    rounding.all(std::uint32_t(std::atoi(argv[i])) & 127u);
  const std::string errors = takeErrors();
  std::printf("%" PRIu64 " values compared, %" PRIu64 " differ%s%s\n", rounding.compared(),
              rounding.differences(), errors.empty() ? "" : ", GL errors: ", errors.c_str());
  return rounding.differences() == 0 && errors.empty() ? 0 : 1;
}
