#include "state/control/known_programs.h"

#include "state/objects/linked_program.h"
#include "state/programs/program_edits.h"
#include "state/raster_draw/raster_context.h"
#include "state/report/drawn_states.h"
#include "state/share/share_group.h"

namespace arbiter::state::control {

namespace {

/// Returns the text name of the combiner or texture-shader state that the context draws with; empty
/// if it draws with none.
std::string effectiveState(const RasterContext &context) {
  const CompiledProgram *const fragment = context.effective.linkedProgram
                                              ? context.effective.linkedProgram->fragment.compiled
                                              : nullptr;
  return fragment && isOfState(fragment->target) ? textFileName(fragment->target, fragment->hash)
                                                 : std::string();
}

void addStates(const RasterContext &context, std::map<std::string, KnownProgram> &programs) {
  const std::string effective = effectiveState(context);
  for (auto &[id, state] : DrawnStates::instance().all()) {
    KnownProgram &program = programs[id];
    program.id = id;
    program.target = state->target;
    program.compiled = state;
    program.bound = program.effective = id == effective;
  }
}

} // namespace

std::map<std::string, KnownProgram> knownPrograms(Session &session, const RasterContext &context) {
  std::map<std::string, KnownProgram> programs;
  for (const std::shared_ptr<ShareGroup> &group : session.groups())
    for (const std::shared_ptr<ProgramObject> &object : group->objects()) {
      const std::shared_ptr<const CompiledProgram> compiled = group->compiledOf(*object);
      if (!compiled || !hasText(*compiled))
        continue;
      const std::string id = textFileName(object->target, compiled->hash);
      KnownProgram &program = programs[id];
      const ProgramTarget &row = context.row(object->target);
      const bool bound = row.bound == object;
      if (program.objects++ == 0 || bound) {
        program.compiled = compiled;
        program.object = object;
      }
      program.id = id;
      program.target = object->target;
      program.bound |= bound;
      program.effective |= bound && row.enabled && !isSwitchedOff(context, row);
    }
  addStates(context, programs);
  return programs;
}

std::optional<KnownProgram> findProgram(Session &session, const RasterContext &context,
                                        const std::string &id) {
  std::map<std::string, KnownProgram> programs = knownPrograms(session, context);
  const auto found = programs.find(id);
  if (found == programs.end())
    return std::nullopt;
  return std::move(found->second);
}

} // namespace arbiter::state::control
