#pragma once
#include <array>

#include <epoxy/gl.h>

#include "fp_compiler/testing/random.h"

/// Commands of NV_register_combiners and 2, and a model of their state and errors, from the
/// specifications' sections Errors and New State.
namespace commanded {

using Color = std::array<GLfloat, 4>;

inline constexpr GLuint kStages = 8;

struct Assigned {
  GLenum input, mapping, usage;
  bool operator==(const Assigned &) const = default;
};
struct Half {
  std::array<Assigned, 4> variables{};
  GLenum ab = GL_DISCARD_NV, cd = GL_DISCARD_NV, sum = GL_SPARE0_NV;
  GLenum scale = GL_NONE, bias = GL_NONE;
  bool abDot = false, cdDot = false, mux = false;
  bool operator==(const Half &) const = default;
};

/// All state that can be queried, under GL's names.
struct Model {
  std::array<std::array<Half, 2>, kStages> stages;
  std::array<Assigned, 7> finals{};
  std::array<Color, 2> constants{};
  std::array<std::array<Color, 2>, kStages> stageConstants{};
  GLint count = 1;
  bool sumClamp = true, enabled = false, perStage = false;
  bool operator==(const Model &) const = default;

  Model() {
    for (auto &stage : stages)
      for (std::size_t h = 0; h < 2; ++h) {
        const GLenum usage = h == 0 ? GL_RGB : GL_ALPHA;
        stage[h].variables.fill({GL_ZERO, GL_UNSIGNED_IDENTITY_NV, usage});
        stage[h].variables[0].input = GL_PRIMARY_COLOR_NV;
        stage[h].variables[1].mapping = GL_UNSIGNED_INVERT_NV;
      }
    finals.fill({GL_ZERO, GL_UNSIGNED_IDENTITY_NV, GL_RGB});
    finals[0] = {GL_FOG, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA};
    finals[1].input = GL_SPARE0_PLUS_SECONDARY_COLOR_NV;
    finals[2].input = GL_FOG;
    finals[6] = {GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA};
  }
};

/// A command, for issuing and for the model.
struct Command {
  int kind = 0;
  std::array<GLenum, 7> names{};
  std::array<bool, 3> flags{};
  Color color{};
  GLint number = 0;
};

/// Applies a command; an erroneous one has no effect. \returns its error
/// \param units texture units that have a register
[[nodiscard]] GLenum apply(Model &model, const Command &command, int units);

/// Returns a command whose arguments are mostly the extensions' names, sometimes others.
[[nodiscard]] Command randomCommand(arbiter::fp::testing::Random &random, int units);

} // namespace commanded
