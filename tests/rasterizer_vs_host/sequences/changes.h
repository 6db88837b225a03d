#pragma once
#include <vector>

#include "surface.h"

/// One piece of state changed between two draws that are alike otherwise: what a draw keeps of the
/// one before must notice it.
namespace software {

inline constexpr int kSide = 64; ///< edge of the target, in pixels

/// What draws: programs for both, for fragments alone, or for none.
enum class Form : unsigned { Programs = 1, FixedVertices = 2, Fixed = 4 };
inline constexpr unsigned kAllForms = 7;
inline constexpr unsigned kFixedVertexForms = 6;
inline constexpr unsigned kFragmentProgramForms = 3;

/// The objects that changes work on; made anew for each of them.
struct Stage {
  Screen *screen = nullptr;
  GLXDrawable window = 0;
  GLXContext context = nullptr, other = nullptr; ///< that share objects
  Form form = Form::Programs;
  GLuint fragments[2] = {}, vertices[2] = {}; ///< programs
  GLuint textures[2] = {};
  GLuint buffer = 0, otherBuffer = 0, indices = 0;
  GLuint framebuffer = 0, target = 0;
  GLuint query = 0, list = 0;

  void make(Form of);
  /// Six triangles from the arrays as they are.
  void draw() const;
};

/// A vertex of the stage's buffers.
struct StageVertex {
  float position[4], normal[3], color[4], coordinates[2];
};
/// The vertices of Stage::draw(), moved and tinted.
[[nodiscard]] std::vector<StageVertex> stageVertices(float move, float tint);
void pointArrays(GLuint buffer);

/// A change and the way back. `group` is the attribute group of PushAttrib that holds it, 0 where
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
