#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <GL/gl.h>

#include "state/objects/symbol_table.h"

/// Converts values of symbols as the application passes them: one number for a scalar, four for a
/// vector, sixteen for a matrix in column order.
namespace arbiter::state {

/// Converts a number. With NORMALIZED_RANGE, integers are mapped by table 2.6 (OpenGL 1.2), and
/// floats are clamped.
template <typename T> [[nodiscard]] GLfloat givenNumber(T value, bool normalized) {
  if (!normalized)
    return GLfloat(value);
  if constexpr (std::is_floating_point_v<T>) {
    return GLfloat(std::clamp(value, T(-1), T(1)));
  } else {
    constexpr double kSteps = double(std::numeric_limits<std::make_unsigned_t<T>>::max());
    return GLfloat((std::is_signed_v<T> ? 2.0 * double(value) + 1.0 : double(value)) / kSteps);
  }
}

/// Returns the columns of a matrix. A vector is one column, and a scalar is its first number.
template <typename T>
[[nodiscard]] std::vector<Vec4> givenColumns(const VertexSymbol &symbol, const T *numbers) {
  std::vector<Vec4> columns(std::size_t(symbol.rows()));
  const std::size_t each = symbol.type() == VertexSymbol::DataType::Scalar ? 1 : 4;
  for (std::size_t column = 0; column < columns.size(); ++column)
    for (std::size_t i = 0; i < each; ++i)
      columns[column][i] = givenNumber(numbers[column * each + i], symbol.normalized);
  return columns;
}

/// Transposes a matrix; anything else is returned unchanged.
[[nodiscard]] inline std::vector<Vec4> transposed(const std::vector<Vec4> &lines) {
  if (lines.size() != 4)
    return lines;
  std::vector<Vec4> turned(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      turned[i][j] = lines[j][i];
  return turned;
}

/// Returns the rows of a value passed to SetInvariantEXT or SetLocalConstantEXT, or nothing for an
/// invalid type.
[[nodiscard]] inline std::optional<std::vector<Vec4>> givenRows(const VertexSymbol &symbol,
                                                                GLenum type, const void *numbers) {
  const auto rows = [&](auto example) {
    return transposed(givenColumns(symbol, static_cast<const decltype(example) *>(numbers)));
  };
  switch (type) {
  case GL_BYTE:
    return rows(GLbyte());
  case GL_UNSIGNED_BYTE:
    return rows(GLubyte());
  case GL_SHORT:
    return rows(GLshort());
  case GL_UNSIGNED_SHORT:
    return rows(GLushort());
  case GL_INT:
    return rows(GLint());
  case GL_UNSIGNED_INT:
    return rows(GLuint());
  case GL_FLOAT:
    return rows(GLfloat());
  case GL_DOUBLE:
    return rows(GLdouble());
  default:
    return std::nullopt;
  }
}

} // namespace arbiter::state
