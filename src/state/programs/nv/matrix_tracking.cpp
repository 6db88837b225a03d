#include "state/programs/nv/matrix_tracking.h"
#include "state/core/errors.h"

#include <algorithm>
#include <bit>
#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "host/host_table.h"
#include "state/core/host_state.h"
#include "state/imaging/imaging_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_context.h"

namespace arbiter::state {

namespace {

using fp::ir::MatrixModifier;
using fp::ir::StateItem;
using fp::ir::StateRef;

constexpr GLuint kRows = 4; ///< rows of a matrix

std::optional<MatrixModifier> modifierOf(GLenum transform) {
  switch (transform) {
  case GL_IDENTITY_NV:
    return MatrixModifier::Plain;
  case GL_INVERSE_NV:
    return MatrixModifier::Inverse;
  case GL_TRANSPOSE_NV:
    return MatrixModifier::Transpose;
  case GL_INVERSE_TRANSPOSE_NV:
    return MatrixModifier::InvTrans;
  default:
    return std::nullopt;
  }
}

/// Replaces TEXTURE by the active unit's TEXTUREi, as of the time of the call.
GLenum wholeName(ProgramContext &context, GLenum matrix) {
  if (matrix != GL_TEXTURE)
    return matrix;
  GLint unit = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  return GLenum(unit);
}

/// Returns the matrix as a row of state, or nothing if programs cannot read it.
std::optional<StateRef> stateOf(const ProgramContext &context, GLenum matrix) {
  const auto numbered = [&](GLenum first, GLint count, StateItem item) -> std::optional<StateRef> {
    if (matrix < first || matrix - first >= GLuint(std::max(count, 0)))
      return std::nullopt;
    return StateRef{.item = item, .index = std::uint8_t(matrix - first)};
  };
  switch (matrix) {
  case GL_MODELVIEW:
    return StateRef{.item = StateItem::MatrixModelview};
  case GL_PROJECTION:
    return StateRef{.item = StateItem::MatrixProjection};
  case GL_MODELVIEW_PROJECTION_NV:
    return StateRef{.item = StateItem::MatrixMvp};
  default:
    break;
  }
  const GLint matrices = context.caps.maxProgramMatrices;
  for (const GLenum first : {GL_MATRIX0_NV, GL_MATRIX0_ARB})
    if (const auto state = numbered(first, matrices, StateItem::MatrixProgram))
      return state;
  return numbered(GL_TEXTURE0, context.caps.maxTextureCoords, StateItem::MatrixTexture);
}

bool isMatrix(const ProgramContext &context, GLenum matrix) {
  return matrix == GL_NONE || (matrix == GL_COLOR && hasColorMatrix(context)) ||
         stateOf(context, matrix).has_value();
}

/// Fetches the colour matrix. It is no StateItem, because programs do not read it.
void fetchColorMatrix(ProgramContext &context, MatrixModifier modifier, GLfloat rows[4][4]) {
  glm::mat4 matrix(1.0f);
  if (context.imaging)
    matrix = glm::make_mat4(context.imaging->colorMatrix.top(context).data());
  else
    context.host->GetFloatv(GL_COLOR_MATRIX, glm::value_ptr(matrix));
  if (modifier == MatrixModifier::Inverse || modifier == MatrixModifier::InvTrans)
    matrix = glm::determinant(matrix) != 0.0f ? glm::inverse(matrix) : glm::mat4(0.0f);
  if (modifier == MatrixModifier::Plain || modifier == MatrixModifier::Inverse)
    matrix = glm::transpose(matrix); // columns become rows
  std::copy_n(glm::value_ptr(matrix), 16, &rows[0][0]);
}

void fetch(ProgramContext &context, const TrackedMatrix &tracked, GLfloat rows[4][4]) {
  const MatrixModifier modifier = modifierOf(tracked.transform).value_or(MatrixModifier::Plain);
  if (tracked.matrix == GL_COLOR)
    return fetchColorMatrix(context, modifier, rows);
  StateRef state = stateOf(context, tracked.matrix).value_or(StateRef{});
  state.modifier = modifier;
  fetchMatrix(context, state, rows);
}

/// Stores a row, and returns true if any bit changed. Comparing values would send a NaN every time,
/// and -0 never.
bool store(Vec4 &to, const GLfloat row[4]) {
  const Vec4 value = {row[0], row[1], row[2], row[3]};
  using Bits = std::array<std::uint32_t, 4>;
  if (std::bit_cast<Bits>(to) == std::bit_cast<Bits>(value))
    return false;
  to = value;
  return true;
}

} // namespace

void refreshTrackedMatrices(ProgramContext &context) {
  ProgramTarget &row = context.row(Target::Vertex);
  bool changed = false;
  for (std::uint64_t left = row.tracked; left != 0; left &= left - 1) {
    const auto group = std::size_t(std::countr_zero(left));
    GLfloat rows[4][4];
    fetch(context, context.nv->tracked[group], rows);
    for (std::size_t i = 0; i < kRows; ++i)
      changed |= store(row.env[group * kRows + i], rows[i]);
  }
  if (!changed)
    return;
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

bool mayBeTracked(const ProgramContext &context, GLuint address) {
  const std::size_t size = context.row(Target::Vertex).env.size();
  return address % kRows == 0 && address < NvState::kParameters && address + kRows <= size;
}

void trackMatrix(ProgramContext &context, GLenum target, GLuint address, GLenum matrix,
                 GLenum transform) {
  if (target != GL_VERTEX_PROGRAM_NV)
    return raise(context, GL_INVALID_ENUM, "TrackMatrix: target");
  if (!mayBeTracked(context, address))
    return raise(context, GL_INVALID_VALUE,
                 "TrackMatrix: the address is no multiple of four below the parameters' number");
  if (!isMatrix(context, wholeName(context, matrix)))
    return raise(context, GL_INVALID_ENUM, "TrackMatrix: matrix");
  if (!modifierOf(transform))
    return raise(context, GL_INVALID_ENUM, "TrackMatrix: transform");
  refreshTrackedMatrices(context); // parameters no longer tracked keep their last value
  ProgramTarget &row = context.row(Target::Vertex);
  const std::size_t group = address / kRows;
  context.nv->tracked[group] = {wholeName(context, matrix), transform};
  const std::uint64_t bit = std::uint64_t(1) << group;
  row.tracked = matrix == GL_NONE ? row.tracked & ~bit : row.tracked | bit;
  // This makes the next draw, and each one after it, look.
  context.attention |= attention::kState | row.parameterBits;
}

} // namespace arbiter::state
