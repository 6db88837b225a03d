#pragma once
#include <array>
#include <cstdint>
#include <string>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// The commands of NV_texture_shader, 2 and 3 and of ATI_envmap_bumpmap that display lists hold,
/// below the entry points.
namespace arbiter::state {

class Context;

/// One command with its arguments, as the application gave them. Plain bytes, in which a list keeps
/// it.
struct TextureShaderCommand {
  enum class Kind : std::uint8_t {
    Environment, ///< TexEnv of TEXTURE_SHADER_NV: pname, values
    Mode,        ///< TEXTURE_ENV_MODE of the active unit: values[0] is 1 for NONE, 0 for another
    Transfer,    ///< PixelTransfer of a component of the extension's: pname, values[0]
    BumpMode, ///< COMBINE_RGB of the active unit: values[0] is 1 for BUMP_ENVMAP_ATI, 0 for another
    BumpTarget, ///< BUMP_TARGET_ATI of the active unit: values[0]
    BumpMatrix, ///< TexBumpParameter of BUMP_ROT_MATRIX_ATI: values
    Format,     ///< an image got an internal format: pname, or 0; values: its target and level
  };
  Kind kind = Kind::Environment;
  bool scalar = false; ///< TexEnvf and TexEnvi, which take no vectors
  std::uint16_t unused = 0;
  GLenum pname = 0;
  Vec4 values{};
};

/// Executes it, or raises its error. The context offers the extension.
void executeTextureShaderCommand(Context &context, const TextureShaderCommand &command);

/// The command as a list's bytes, and back: of one command or of several that follow each other.
[[nodiscard]] std::string bytesOf(const TextureShaderCommand &command);
void executeTextureShaderCommands(Context &context, const std::string &bytes);

/// How many values a pname of TEXTURE_SHADER_NV has: 1, 3 or 4; 0 for a name that TexEnv lacks.
[[nodiscard]] int textureShaderValues(GLenum pname);
/// 0 to 5 for HI_SCALE_NV to VIBRANCE_SCALE_NV, 6 to 11 for HI_BIAS_NV to VIBRANCE_BIAS_NV; -1 for
/// another name.
[[nodiscard]] int componentTransfer(GLenum pname);
/// The active texture unit, counted from 0.
[[nodiscard]] GLuint activeUnit(const Context &context);

} // namespace arbiter::state
