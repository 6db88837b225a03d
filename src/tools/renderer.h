#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/picture.h"
#include "util/result.h"

/// What `arbiter draw` draws, with plain GL: it is a client of the layer like any other.
namespace arbiter::tools {

struct Scene {
  struct Texture {
    unsigned unit = 0;
    Picture picture;
  };
  struct Parameter {
    unsigned index = 0;
    std::array<float, 4> value = {};
  };

  std::string program; ///< ARBfp text
  int width = 0;
  int height = 0;
  std::vector<Texture> textures;
  std::vector<Parameter> locals;
  std::vector<Parameter> envs;
  int frames = 1;
  int feedback = -1; ///< unit that gets each frame's picture, or -1
};

struct Rendering {
  Picture picture;
  double millisecondsPerFrame = 0; ///< the first frame, which compiles, is left out if it can be
  std::string renderer;            ///< GL_RENDERER
};

struct RenderError {
  enum class Kind { NoGl, Program, Scene } kind = Kind::NoGl;
  std::string message;
  int position = -1; ///< Program: GL_PROGRAM_ERROR_POSITION_ARB
};

/// Draws on a pbuffer of a display without a window system.
[[nodiscard]] Result<Rendering, RenderError> render(const Scene &scene);

} // namespace arbiter::tools
