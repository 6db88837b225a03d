#include "apps/tools/draw/uses.h"

#include <algorithm>

#include "apps/tools/draw/options.h"
#include "apps/tools/language.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/print.h"

namespace arbiter::tools {

namespace {

using Kind = GivenOption::Kind;

/// The inputs that one program reads; bound parameters count as read.
struct Uses {
  const scene::ProgramFile *program = nullptr;
  std::vector<Sampled> samples;
  std::vector<unsigned> locals, envs, attribs;
};

fp::CheckResult check(const scene::ProgramFile &file) {
  const fp::hw::Profile *const widest = fp::hw::findBuiltin("host");
  return fp::checkProgramIn(file.text, file.program(),
                            {limitsOf(*widest, file.language), fp::LimitPolicy::Report});
}

std::vector<Sampled> samplesOf(const fp::ir::Program &program) {
  std::vector<Sampled> samples;
  for (const fp::ir::Instruction &instruction : program.code) {
    if (!fp::ir::info(instruction.op).has(fp::ir::Texture))
      continue;
    const auto known = [&](const Sampled &each) { return each.unit == instruction.unit; };
    if (std::none_of(samples.begin(), samples.end(), known))
      samples.push_back({instruction.unit, instruction.target});
  }
  return samples;
}

/// Adds a program's uses. False if the compiler rejects the program, so that its uses are unknown.
bool findUses(const scene::ProgramFile &file, std::vector<Uses> &all) {
  const fp::CheckResult result = check(file);
  if (!result.ok())
    return false;
  Uses &uses = all.emplace_back();
  uses.program = &file;
  uses.samples = samplesOf(*result.program);
  for (const fp::ir::Parameter &parameter : result.program->parameters)
    if (parameter.kind == fp::ir::ParameterKind::Local)
      uses.locals.push_back(parameter.index);
    else if (parameter.kind == fp::ir::ParameterKind::Env)
      uses.envs.push_back(parameter.index);
  for (const fp::ir::Attribute &attribute : result.program->attributes)
    if (attribute.kind == fp::ir::AttributeKind::Generic)
      uses.attribs.push_back(attribute.index);
  return true;
}

/// Adds the uses of one pass's programs.
bool findUses(const scene::Document &document, const scene::Pass &pass, std::vector<Uses> &all) {
  for (const int file : {pass.vertex, pass.fragment})
    if (file >= 0 && !findUses(document.files[std::size_t(file)], all))
      return false;
  return true;
}

/// Returns a list such as "life.fp samples texture[0] as 2D and texture[1] as CUBE".
std::string sampling(const std::vector<Uses> &all) {
  std::string text;
  for (const Uses &uses : all)
    for (const Sampled &sampled : uses.samples)
      text += (text.empty() ? uses.program->name + " samples " : " and ") + "texture[" +
              std::to_string(sampled.unit) + "] as " + fp::ir::targetText(sampled.target);
  return text.empty() ? "no program samples a texture" : text;
}

std::string faultOfImage(const GivenOption &given, const std::vector<Uses> &all) {
  for (const Uses &uses : all)
    for (const Sampled &sampled : uses.samples)
      if (sampled.unit == given.index)
        return sampled.target == fp::ir::TexTarget::Tex2D ||
                       sampled.target == fp::ir::TexTarget::Tex3D
                   ? ""
                   : given.option + ": " + uses.program->name + " samples texture[" +
                         std::to_string(sampled.unit) + "] as " +
                         fp::ir::targetText(sampled.target) + ", and this is a 2D image";
  return given.option + " has no effect: " + sampling(all);
}

std::string faultOfValue(const GivenOption &given, const std::vector<Uses> &all,
                         std::vector<unsigned> Uses::*rows, const char *row) {
  for (const Uses &uses : all) {
    if (given.language && *given.language != uses.program->language)
      continue;
    const std::vector<unsigned> &read = uses.*rows;
    if (std::find(read.begin(), read.end(), given.index) != read.end())
      return {};
  }
  return given.option + " has no effect: no " +
         (!given.language                                  ? ""
          : *given.language == fp::ir::Language::ArbVertex ? "vertex "
                                                           : "fragment ") +
         "program reads " + row + "[" + std::to_string(given.index) + "]";
}

std::string faultOf(const GivenOption &given, const std::vector<Uses> &all) {
  switch (given.kind) {
  case Kind::Texture:
  case Kind::Feedback:
    return faultOfImage(given, all);
  case Kind::Local:
    return faultOfValue(given, all, &Uses::locals, "program.local");
  case Kind::Env:
    return faultOfValue(given, all, &Uses::envs, "program.env");
  case Kind::Attrib:
    return faultOfValue(given, all, &Uses::attribs, "vertex.attrib");
  }
  return {};
}

} // namespace

std::vector<Sampled> samplesOf(const scene::ProgramFile &file) {
  const fp::CheckResult result = check(file);
  return result.ok() ? samplesOf(*result.program) : std::vector<Sampled>{};
}

std::string faultOfUses(const Drawing &drawing) {
  std::vector<Uses> all;
  if (drawing.given.empty() || !findUses(drawing.document, drawing.document.passes.front(), all))
    return {};
  for (const GivenOption &given : drawing.given)
    if (std::string fault = faultOf(given, all); !fault.empty())
      return fault;
  return {};
}

std::string giveTextures(const std::vector<std::string> &textures, scene::Document &document) {
  Drawing drawing;
  drawing.document = std::move(document);
  std::string fault = applyTextures(textures, drawing);
  if (fault.empty())
    fault = faultOfUses(drawing);
  document = std::move(drawing.document);
  return fault;
}

std::vector<std::string> unfedSamples(const scene::Document &document) {
  std::vector<std::string> lines;
  for (const scene::Pass &pass : document.passes) {
    std::vector<Uses> all;
    if (!findUses(document, pass, all))
      continue;
    const auto &textures = document.panelOf(pass).textures;
    for (const Uses &uses : all)
      for (const Sampled &sampled : uses.samples) {
        const auto feeds = [&](const auto &each) { return each.unit == sampled.unit; };
        if (std::none_of(textures.begin(), textures.end(), feeds))
          lines.push_back(uses.program->name + ": texture[" + std::to_string(sampled.unit) + "] (" +
                          fp::ir::targetText(sampled.target) +
                          ") has no image, so a checker with its number stands in for one");
      }
  }
  return lines;
}

} // namespace arbiter::tools
