#pragma once
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fixture.h"

/// Draws that show the color as each of its readers sees it, for the tests of attributes that
/// alias.
namespace api::aliases {

using Value = std::array<GLfloat, 4>;

/// True if attributes alias here, as API_TEST_ALIASES says.
inline bool attributesAlias() {
  const char *const said = std::getenv("API_TEST_ALIASES");
  return said && std::string_view(said) == "1";
}

/// Returns a vertex program that outputs the attribute as color.
inline std::string shows(const std::string &attribute) {
  return "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, " + attribute +
         ";\nEND";
}

inline constexpr GLfloat kCorners[] = {-1, -1, 1, -1, 1, 1, -1, 1};

inline void quad() {
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i)
    glVertex2fv(kCorners + 2 * i);
  glEnd();
}

/// Returns the middle pixel of a draw over everything.
template <typename Draw> Pixel pixelOf(Draw &&draw) {
  clear();
  draw();
  return readPixel();
}

/// The reader of a register: a program by its conventional or its generic name, or fixed function.
enum class Reader { Conventional, Generic, FixedFunction };
inline constexpr Reader kReaders[] = {Reader::Conventional, Reader::Generic, Reader::FixedFunction};

class AliasedAttributes : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    if (!attributesAlias())
      GTEST_SKIP() << "attributes are apart here";
    attrib4fNv =
        reinterpret_cast<PFNGLVERTEXATTRIB4FNVPROC>(eglGetProcAddress("glVertexAttrib4fNV"));
    hasNv = epoxy_has_gl_extension("GL_NV_vertex_program");
    m_conventional = makeProgram(shows("vertex.color"), kVertex);
    m_generic = makeProgram(shows("vertex.attrib[3]"), kVertex);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
  /// Makes draws show the primary color as this reader sees it.
  void read(Reader reader) const {
    if (reader == Reader::FixedFunction)
      return glDisable(kVertex);
    glBindProgramARB(kVertex, reader == Reader::Generic ? m_generic : m_conventional);
    glEnable(kVertex);
  }
  /// Returns the commands that set the color; all must set the same.
  [[nodiscard]] std::vector<std::function<void(const Value &)>> colorCommands() const {
    std::vector<std::function<void(const Value &)>> commands = {
        [](const Value &v) { glColor4fv(v.data()); },
        [](const Value &v) { glVertexAttrib4fv(3, v.data()); },
        [](const Value &v) { glVertexAttrib4fARB(3, v[0], v[1], v[2], v[3]); },
        [](const Value &v) { glVertexAttrib4dARB(3, v[0], v[1], v[2], v[3]); },
        [](const Value &v) {
          glVertexAttrib4NubARB(3, GLubyte(v[0] * 255), GLubyte(v[1] * 255), GLubyte(v[2] * 255),
                                GLubyte(v[3] * 255));
        },
        [](const Value &v) { glVertexAttrib3f(3, v[0], v[1], v[2]); }};
    if (hasNv)
      commands.emplace_back([this](const Value &v) { attrib4fNv(3, v[0], v[1], v[2], v[3]); });
    return commands;
  }

  PFNGLVERTEXATTRIB4FNVPROC attrib4fNv = nullptr;
  bool hasNv = false;

private:
  GLuint m_conventional = 0, m_generic = 0;
};

inline constexpr Value kRed = {1, 0, 0, 1}, kGreen = {0, 1, 0, 1}, kBlue = {0, 0, 1, 1},
                       kCyan = {0, 1, 1, 1};

/// Ways to draw four vertices of arrays.
inline const std::vector<std::pair<const char *, void (*)()>> kDraws = {
    {"DrawArrays", [] { glDrawArrays(GL_QUADS, 0, 4); }},
    {"DrawElements",
     [] {
       const GLushort indices[] = {3, 0, 1, 2};
       glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, indices);
     }},
    {"DrawRangeElements",
     [] {
       const GLubyte indices[] = {0, 1, 2, 3};
       glDrawRangeElements(GL_QUADS, 0, 3, 4, GL_UNSIGNED_BYTE, indices);
     }},
    {"MultiDrawArrays",
     [] {
       const GLint first[] = {0, 1};
       const GLsizei count[] = {3, 3};
       glMultiDrawArrays(GL_TRIANGLES, first, count, 2);
     }},
    {"MultiDrawElements", [] {
       const GLuint halves[][3] = {{0, 1, 2}, {2, 3, 0}};
       const void *const indices[] = {halves[0], halves[1]};
       const GLsizei count[] = {3, 3};
       glMultiDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, indices, 2);
     }}};

struct Vertex {
  GLfloat position[2];
  GLubyte color[4];
};
inline constexpr Vertex kCyanQuad[] = {{{-1, -1}, {0, 255, 255, 255}},
                                       {{1, -1}, {0, 255, 255, 255}},
                                       {{1, 1}, {0, 255, 255, 255}},
                                       {{-1, 1}, {0, 255, 255, 255}}};
inline constexpr Pixel kCyanPixel = {0, 255, 255, 255};

/// Arrays of kCyanQuad, in client memory or in a buffer.
class Arrays {
public:
  explicit Arrays(bool inBuffer) {
    if (!inBuffer)
      return;
    glGenBuffers(1, &m_buffer);
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof kCyanQuad, kCyanQuad, GL_STATIC_DRAW);
  }
  ~Arrays() {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY})
      glDisableClientState(array);
    for (const GLuint array : {0u, 3u})
      glDisableVertexAttribArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteBuffers(1, &m_buffer);
  }
  Arrays(const Arrays &) = delete;
  Arrays &operator=(const Arrays &) = delete;

  void position() const {
    glVertexPointer(2, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, position)));
    glEnableClientState(GL_VERTEX_ARRAY);
  }
  void genericPosition() const {
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(offsetof(Vertex, position)));
    glEnableVertexAttribArray(0);
  }
  void color() const {
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), at(offsetof(Vertex, color)));
    glEnableClientState(GL_COLOR_ARRAY);
  }
  void pointAtGenericColor() const {
    glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex),
                          at(offsetof(Vertex, color)));
  }
  void genericColor() const {
    pointAtGenericColor();
    glEnableVertexAttribArray(3);
  }

private:
  [[nodiscard]] const void *at(std::size_t offset) const {
    return m_buffer != 0 ? reinterpret_cast<const char *>(offset)
                         : reinterpret_cast<const char *>(kCyanQuad) + offset;
  }
  GLuint m_buffer = 0;
};

} // namespace api::aliases
