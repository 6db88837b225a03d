#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <GL/gl.h>

#include "state/objects/symbol_table.h"

/// Values of symbols as the application gives them: one number of a scalar, four of a vector,
/// sixteen of a matrix, column after column.
namespace arbiter::state {

/// Of NORMALIZED_RANGE whole numbers are mapped by table 2.6 (OpenGL 1.2), others clamped.
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

/// The columns of a matrix; of a vector all, of a scalar the first number.
template <typename T>
[[nodiscard]] std::vector<Vec4> givenColumns(const VertexSymbol &symbol, const T *numbers) {
  std::vector<Vec4> columns(std::size_t(symbol.rows()));
  const std::size_t each = symbol.type() == VertexSymbol::DataType::Scalar ? 1 : 4;
  for (std::size_t column = 0; column < columns.size(); ++column)
    for (std::size_t i = 0; i < each; ++i)
      columns[column][i] = givenNumber(numbers[column * each + i], symbol.normalized);
  return columns;
}

/// Rows of columns, and columns of rows.
[[nodiscard]] inline std::vector<Vec4> transposed(const std::vector<Vec4> &lines) {
  if (lines.size() != 4)
    return lines;
  std::vector<Vec4> turned(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      turned[i][j] = lines[j][i];
  return turned;
}

/// The rows of what SetInvariantEXT and SetLocalConstantEXT are given; none of a type that is none.
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
