// param.*: parameters of programs, and values that a client holds.
#include <charconv>
#include <optional>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/ir/print.h"
#include "state/control/known_programs.h"
#include "state/control/methods.h"
#include "state/host_draw/uniforms.h"
#include "state/programs/program_edits.h"
#include "state/programs/replacement.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

using fp::ir::ParameterKind;
using wire::Json;

const char *kindWord(ParameterKind kind) {
  switch (kind) {
  case ParameterKind::Constant:
    return "constant";
  case ParameterKind::Env:
    return "env";
  case ParameterKind::Local:
    return "local";
  case ParameterKind::State:
    return "state";
  }
  return "";
}

/// Returns the value that the program's draws use; null if only a context that draws with it knows.
Json valueJson(Call &call, const KnownProgram &program, const fp::ir::Parameter &parameter) {
  const ProgramTarget &row = call.context.row(program.target);
  Vec4 value = parameter.constant;
  if (program.bound)
    value = currentValue(call.context, row, parameter);
  else if (parameter.kind == ParameterKind::State)
    return nullptr;
  else if (parameter.kind == ParameterKind::Env)
    value = parameter.index < row.env.size() ? row.env[parameter.index] : Vec4{};
  else if (parameter.kind == ParameterKind::Local)
    value = parameter.index < program.object->locals.size()
                ? program.object->locals[parameter.index].load()
                : Vec4{};
  return Json::array({value[0], value[1], value[2], value[3]});
}

void addParameters(Call &call, const KnownProgram &program, Json &rows) {
  if (!program.compiled->program)
    return;
  const ProgramTarget &row = call.context.row(program.target);
  for (const fp::ir::Parameter &parameter : program.compiled->program->parameters) {
    const bool env = parameter.kind == ParameterKind::Env;
    const bool settable = env || parameter.kind == ParameterKind::Local;
    rows.push_back(
        {{"id", program.id},
         {"name", fp::ir::bindingText(parameter)},
         {"kind", kindWord(parameter.kind)},
         {"index", parameter.index},
         {"value", valueJson(call, program, parameter)},
         {"held", settable && ProgramEdits::instance()
                                  .held(row.target, env, parameter.index, program.compiled->hash)
                                  .has_value()}});
  }
}

struct Name {
  bool env = false;
  std::uint32_t index = 0;
};

/// Parses "program.local[3]" or "program.env[3]".
std::optional<Name> parseName(std::string_view text) {
  Name name;
  constexpr std::string_view kLocal = "program.local[", kEnv = "program.env[";
  name.env = text.starts_with(kEnv);
  if (!name.env && !text.starts_with(kLocal))
    return std::nullopt;
  text.remove_prefix(name.env ? kEnv.size() : kLocal.size());
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), name.index);
  const bool closed = end + 1 == text.data() + text.size() && *end == ']';
  return error == std::errc() && closed ? std::optional(name) : std::nullopt;
}

} // namespace

wire::Answer paramList(Call &call) {
  Json rows = Json::array();
  const std::string id = call.params.text("id", "");
  if (!call.params.ok())
    return call.params.fault();
  bool found = id.empty();
  for (const auto &[name, program] : knownPrograms(call.session, call.context)) {
    if (id.empty() ? !program.effective : name != id)
      continue;
    found = true;
    addParameters(call, program, rows);
  }
  if (!found)
    return wire::Fault{wire::kUnknownName, "there is no program " + id.substr(0, 80), {}};
  return Json::object({{"parameters", std::move(rows)}});
}

wire::Answer paramSet(Call &call) {
  const std::string id = call.params.text("id"), text = call.params.text("name");
  HeldValue held;
  call.params.floats("value", held.value.data(), held.value.size());
  const std::optional<Name> name = parseName(text);
  if (call.params.ok() && !name)
    call.params.refuse("name", "is program.local[N] or program.env[N]");
  if (!call.params.ok())
    return call.params.fault();
  const std::optional<KnownProgram> program = findProgram(call.session, call.context, id);
  if (!program)
    return wire::Fault{wire::kUnknownName, "there is no program " + id.substr(0, 80), {}};
  const fp::Limits &limits = call.context.row(program->target).limits;
  const std::uint32_t count = name->env ? limits.envParameters : limits.localParameters;
  if (name->index >= count) {
    call.params.refuse("name", "is beyond the last parameter, " + std::to_string(count - 1));
    return call.params.fault();
  }
  held.target = program->target;
  held.env = name->env;
  held.index = name->index;
  if (!name->env) {
    held.program = id;
    held.hash = program->compiled->hash;
  }
  ProgramEdits::instance().hold(held);
  refreshReplacements(call.context);
  return Json::object();
}

wire::Answer paramReset(Call &call) {
  const std::string id = call.params.text("id", ""), text = call.params.text("name", "");
  const std::optional<Name> name = parseName(text);
  if (call.params.ok() && !text.empty() && !name)
    call.params.refuse("name", "is program.local[N] or program.env[N]");
  if (!call.params.ok())
    return call.params.fault();
  const std::optional<KnownProgram> program =
      id.empty() ? std::nullopt : findProgram(call.session, call.context, id);
  const std::size_t count = ProgramEdits::instance().letGo([&](const HeldValue &value) {
    const bool sameProgram = id.empty() || (value.env ? program && program->target == value.target
                                                      : value.program == id);
    return sameProgram && (!name || (name->env == value.env && name->index == value.index));
  });
  refreshReplacements(call.context);
  return Json::object({{"count", count}});
}

} // namespace arbiter::state::control
