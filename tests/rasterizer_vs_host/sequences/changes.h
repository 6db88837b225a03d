#pragma once
#include <vector>

#include "surface.h"

/// Changes of one piece of state between two otherwise equal draws: what a draw caches from the
/// previous one must be updated.
namespace software {

inline constexpr int kSide = 64; ///< edge of the target, in pixels

/// The programs of draws: for both stages, for fragments only, or none.
enum class Form : unsigned { Programs = 1, FixedVertices = 2, Fixed = 4 };
inline constexpr unsigned kAllForms = 7;
inline constexpr unsigned kFixedVertexForms = 6;
inline constexpr unsigned kFragmentProgramForms = 3;

/// The objects that changes use; made anew for each of them.
struct Stage {
  Screen *screen = nullptr;
  GLXDrawable window = 0;
  GLXContext context = nullptr, other = nullptr; ///< which share objects
  Form form = Form::Programs;
  GLuint fragments[2] = {}, vertices[2] = {}; ///< programs
  GLuint textures[2] = {};
  GLuint buffer = 0, otherBuffer = 0, indices = 0;
  GLuint framebuffer = 0, target = 0;
  GLuint query = 0, list = 0;

  void make(Form of);
  /// Draws six triangles from the arrays.
  void draw() const;
};

/// A vertex of the stage's buffers.
struct StageVertex {
  float position[4], normal[3], color[4], coordinates[2];
};
/// Returns the vertices of Stage::draw(), moved and tinted.
[[nodiscard]] std::vector<StageVertex> stageVertices(float move, float tint);
void pointArrays(GLuint buffer);

/// A change and its reversal. `group` is the attribute group of PushAttrib that contains it, 0 if
/// none does.
struct Change {
  const char *name;
  unsigned forms;
  GLbitfield group;
  void (*apply)(Stage &stage);
  void (*undo)(Stage &stage);
};
extern const std::vector<Change> kPixelChanges, kVertexChanges, kObjectChanges;

} // namespace software
