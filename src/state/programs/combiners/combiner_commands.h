#pragma once
#include <array>
#include <cstdint>
#include <string>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// The commands of NV_register_combiners and 2 that display lists hold, below the entry points.
namespace arbiter::state {

class Context;

/// One command with its arguments, as the application gave them. Plain bytes, in which a list keeps
/// it.
struct CombinerCommand {
  enum class Kind : std::uint8_t {
    Parameter,         ///< CombinerParameter: names[0] the pname; values, colours in [0,1]
    StageParameter,    ///< CombinerStageParameter: names the stage and pname; values
    Input,             ///< CombinerInput: names in the order of its arguments
    Output,            ///< CombinerOutput: names up to the bias; flags
    FinalInput,        ///< FinalCombinerInput: names in the order of its arguments
    PerStageConstants, ///< Enable and Disable of PER_STAGE_CONSTANTS_NV: flags
  };
  enum Flags : std::uint8_t { kAbDot = 1, kCdDot = 2, kMux = 4, kOn = 8 };
  Kind kind = Kind::Parameter;
  bool scalar = false; ///< CombinerParameterf and -i, which take no colours
  std::uint8_t flags = 0;
  std::uint8_t unused = 0;
  std::array<GLenum, 7> names{};
  Vec4 values{};
};

/// Executes it, or raises its error. The context offers the extension.
void executeCombinerCommand(Context &context, const CombinerCommand &command);

/// The command as a list's bytes, and back: of one command or of several that follow each other.
[[nodiscard]] std::string bytesOf(const CombinerCommand &command);
void executeCombinerCommands(Context &context, const std::string &bytes);

} // namespace arbiter::state
