#pragma once
#include <GL/gl.h>
#include <array>

namespace arbiter::host {

/// The four values of a program parameter, where the application keeps them. Nothing is read before
/// read(): a handler asks for the values when target and index are valid, because the pointer of a
/// command that is an error may be anything.
class ParameterValues {
public:
  explicit ParameterValues(const GLfloat *values) : m_values(values) {}
  explicit ParameterValues(const GLdouble *values) : m_values(values), m_areDoubles(true) {}

  /// Returns the values as floats.
  [[nodiscard]] std::array<GLfloat, 4> read() const {
    return m_areDoubles ? read(static_cast<const GLdouble *>(m_values))
                        : read(static_cast<const GLfloat *>(m_values));
  }
  /// Returns the values of a command that is in order, and zeros of one that is an error.
  [[nodiscard]] std::array<GLfloat, 4> readIf(bool isValid) const {
    return isValid ? read() : std::array<GLfloat, 4>{};
  }
  /// Calls \p use with the four values as floats, which stay in registers. Each value is loaded
  /// alone: a processor waits before it loads as one what the application has just stored by parts.
  template <typename Use> void give(Use use) const {
    if (m_areDoubles)
      give(static_cast<const GLdouble *>(m_values), use);
    else
      give(static_cast<const GLfloat *>(m_values), use);
  }
  /// Calls the host's command for values of their type, unread.
  template <typename Floats, typename Doubles, typename... Leading>
  void pass(Floats *floats, Doubles *doubles, Leading... leading) const {
    if (m_areDoubles)
      doubles(leading..., static_cast<const GLdouble *>(m_values));
    else
      floats(leading..., static_cast<const GLfloat *>(m_values));
  }

private:
  template <typename T, typename Use> static void give(const volatile T *values, Use use) {
    use(GLfloat(values[0]), GLfloat(values[1]), GLfloat(values[2]), GLfloat(values[3]));
  }
  template <typename T> static std::array<GLfloat, 4> read(const T *values) {
    return {GLfloat(values[0]), GLfloat(values[1]), GLfloat(values[2]), GLfloat(values[3])};
  }

  const void *m_values;
  bool m_areDoubles = false;
};

} // namespace arbiter::host
