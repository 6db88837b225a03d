#pragma once
#include <array>
#include <cstdint>
#include <string>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// The commands of NV_texture_shader, 2 and 3 and of ATI_envmap_bumpmap that display lists can
/// hold, called by the entry points.
namespace arbiter::state {

struct ProgramContext;

/// One command with the application's arguments. It consists of plain bytes, which a list stores.
struct TextureShaderCommand {
  enum class Kind : std::uint8_t {
    Environment, ///< TexEnv of TEXTURE_SHADER_NV: pname, values
    Mode,        ///< TEXTURE_ENV_MODE of the active unit: values[0] is 1 for NONE, 0 for another
    Transfer,    ///< PixelTransfer of a component of these formats: pname, values[0]
    BumpMode, ///< COMBINE_RGB of the active unit: values[0] is 1 for BUMP_ENVMAP_ATI, 0 for another
    BumpTarget, ///< BUMP_TARGET_ATI of the active unit: values[0]
    BumpMatrix, ///< TexBumpParameter of BUMP_ROT_MATRIX_ATI: values
    Format,     ///< a new internal format of an image: pname, or 0; values: its target and level
  };
  Kind kind = Kind::Environment;
  bool scalar = false; ///< true for TexEnvf and TexEnvi, which set no vectors
  std::uint16_t unused = 0;
  GLenum pname = 0;
  Vec4 values{};
};

/// Executes a command, or raises its error. Requires that the context offers the extension.
void executeTextureShaderCommand(ProgramContext &context, const TextureShaderCommand &command);

/// Converts a command to a list's bytes, and executes the bytes of one or several commands.
[[nodiscard]] std::string bytesOf(const TextureShaderCommand &command);
void executeTextureShaderCommands(ProgramContext &context, const std::string &bytes);

/// Returns the number of values of a pname of TEXTURE_SHADER_NV: 1, 3 or 4; 0 for an unknown name.
[[nodiscard]] int textureShaderValues(GLenum pname);
/// Returns 0 to 5 for HI_SCALE_NV to VIBRANCE_SCALE_NV, 6 to 11 for HI_BIAS_NV to VIBRANCE_BIAS_NV,
/// and -1 for another name.
[[nodiscard]] int componentTransfer(GLenum pname);
/// Returns the active texture unit, counted from 0.
[[nodiscard]] GLuint activeUnit(const ProgramContext &context);

} // namespace arbiter::state
