#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "tools/commands.h"
#include "tools/picture.h"
#include "util/result.h"

/// What `arbiter draw` draws, as plain values.
namespace arbiter::tools {

struct SceneProgram {
  std::string name; ///< the file, or "<stdin>"
  std::string text;
  fp::ir::Language language = fp::ir::Language::ArbFragment;
};

/// What carries the programs: all fill [-1,1] in x and y, with texture coordinates from 0 to 1.
enum class Mesh {
  Quad,
  Grid,   ///< the quad in 64 x 64 parts, so that a vertex program can bend it
  Sphere, ///< of radius 1, drawn with a depth test
};

struct Scene {
  struct Texture {
    unsigned unit = 0;
    std::string option; ///< as it was given: "0=photo.png"
    Picture picture;
  };
  struct Parameter {
    std::optional<fp::ir::Language>
        language;       ///< of one program; without: of every one that reads it
    std::string option; ///< as it was given: "--local 0=1,2,3,4"
    unsigned index = 0;
    std::array<float, 4> value = {};
  };

  std::vector<SceneProgram> programs; ///< one for a stage: a vertex program first, or none
  int width = 0;
  int height = 0;
  Mesh mesh = Mesh::Quad;
  std::vector<Texture> textures;
  std::vector<Parameter> locals;
  std::vector<Parameter> envs;
  std::vector<Parameter> attribs; ///< generic vertex attributes
  int frames = 1;
  int feedback = -1; ///< a texture unit that gets each frame's picture, or -1

  [[nodiscard]] bool hasVertexProgram() const {
    return programs.front().language == fp::ir::Language::ArbVertex;
  }
};

struct SceneError {
  std::string message;
};

/// Reads every file that the arguments name. An argument that is malformed or given twice is an
/// error that names it.
[[nodiscard]] Result<Scene, SceneError> readScene(const DrawArguments &arguments);

} // namespace arbiter::tools
