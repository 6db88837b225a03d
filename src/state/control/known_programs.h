#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "state/control/session.h"
#include "state/objects/program_object.h"

namespace arbiter::state::remote {

/// A text of the application's, and the objects that hold it; or a state of it that is a text,
/// which none holds.
struct KnownProgram {
  std::string id; ///< the name of the text's file
  Target target = Target::Fragment;
  std::shared_ptr<const CompiledProgram> compiled;
  std::shared_ptr<ProgramObject> object; ///< one of them, the bound one if one is; null of a state
  std::size_t objects = 0;
  bool bound = false;     ///< in the context that answers
  bool effective = false; ///< and enabled there, and not switched off
};

/// Of every share group that has drawn, by id, and the states that were drawn with. Shaders that
/// have no text are none.
[[nodiscard]] std::map<std::string, KnownProgram> knownPrograms(Session &session,
                                                                const Context &context);
[[nodiscard]] std::optional<KnownProgram> findProgram(Session &session, const Context &context,
                                                      const std::string &id);

} // namespace arbiter::state::remote
