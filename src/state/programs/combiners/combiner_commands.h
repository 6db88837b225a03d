#pragma once
#include <array>
#include <cstdint>
#include <string>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// The commands of NV_register_combiners and 2 that display lists can hold, called by the entry
/// points.
namespace arbiter::state {

struct ProgramContext;

/// One command with the application's arguments. It consists of plain bytes, which a list stores.
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
  bool scalar = false; ///< true for CombinerParameterf and -i, which set no colours
  std::uint8_t flags = 0;
  std::uint8_t unused = 0;
  std::array<GLenum, 7> names{};
  Vec4 values{};
};

/// Executes a command, or raises its error. Requires that the context offers the extension.
void executeCombinerCommand(ProgramContext &context, const CombinerCommand &command);

/// Converts a command to a list's bytes, and executes the bytes of one or several commands.
[[nodiscard]] std::string bytesOf(const CombinerCommand &command);
void executeCombinerCommands(ProgramContext &context, const std::string &bytes);

} // namespace arbiter::state
