#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "state/control/session.h"
#include "state/objects/program_object.h"

namespace arbiter::state::control {

/// A program text of the application's and the objects that hold it. Or a state that is written as
/// text, which no object holds.
struct KnownProgram {
  std::string id; ///< the file name of the text
  Target target = Target::Fragment;
  std::shared_ptr<const CompiledProgram> compiled;
  std::shared_ptr<ProgramObject> object; ///< a bound object, or any; null for a state
  std::size_t objects = 0;
  bool bound = false;     ///< in the context that answers
  bool effective = false; ///< and enabled there, and not switched off
};

/// Returns the texts of every share group that has drawn, by id, and the states that were drawn
/// with. Shaders without a text are left out.
[[nodiscard]] std::map<std::string, KnownProgram> knownPrograms(Session &session,
                                                                const RasterContext &context);
[[nodiscard]] std::optional<KnownProgram>
findProgram(Session &session, const RasterContext &context, const std::string &id);

} // namespace arbiter::state::control
