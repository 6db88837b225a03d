#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "state/objects/program_object.h"
#include "state/objects/target.h"
#include "state/objects/texture_use.h"
#include "util/json.h"

/// A row of a capture's record: a program text and its use.
namespace arbiter::state {

/// The fixed-function texture targets, in rising precedence (3.8.15).
struct FixedTarget {
  GLenum cap;
  const char *name;
};
inline constexpr FixedTarget kFixedTargets[] = {
    {GL_TEXTURE_1D, "TEXTURE_1D"},
    {GL_TEXTURE_2D, "TEXTURE_2D"},
    {GL_TEXTURE_RECTANGLE, "TEXTURE_RECTANGLE"},
    {GL_TEXTURE_3D, "TEXTURE_3D"},
    {GL_TEXTURE_CUBE_MAP, "TEXTURE_CUBE_MAP"},
};

/// The number of draws on one path.
struct DrawsBy {
  const char *path = ""; ///< pathName()
  std::uint64_t count = 0;
};

/// Returns the options of a program as its text would spell them.
[[nodiscard]] std::vector<const char *> optionNames(const fp::ir::Options &options, bool vertex);

/// The record of one program text.
struct CaptureRow {
  Target target = Target::Fragment;
  std::string hash;
  std::uint64_t loads = 0, frames = 0;
  std::vector<DrawsBy> draws; ///< each path once, and only those with draws
  std::set<std::uint32_t> contexts;
  std::vector<const char *> options;
  bool counted = false;
  fp::ResourceCounts counts, nativeCounts;
  bool underNativeLimits = false;
  bool replaced = false;
  bool hasGlsl = false; ///< its GLSL file is written
  std::int32_t errorPosition = -1;
  std::string error, warning;
  // These are from the last use.
  std::pair<std::uint32_t, std::uint64_t> lastFrame{0, ~std::uint64_t{0}}; ///< context and frame
  std::int64_t lastUse = -1;                                               ///< ns since the epoch
  std::shared_ptr<const CompiledProgram> program;
  std::vector<Vec4> values; ///< of program->glsl.uniforms
  std::vector<TextureUse> textures;

  void add(const DrawsBy &draws);
  /// Writes an element of the record's "programs".
  void write(JsonWriter &json) const;
};

} // namespace arbiter::state
