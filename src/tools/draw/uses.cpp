#include "tools/draw/uses.h"

#include <algorithm>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/print.h"
#include "tools/language.h"

namespace arbiter::tools {

namespace {

using fp::ir::AttributeKind;
using fp::ir::Language;
using fp::ir::ParameterKind;
using fp::ir::TexTarget;

struct Sampled {
  unsigned unit = 0;
  TexTarget target = TexTarget::Tex2D;
};

/// What one program reads; bound is read.
struct Uses {
  const SceneProgram *program = nullptr;
  std::vector<Sampled> samples;
  std::vector<unsigned> locals, envs, attribs;
};

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

/// False: the compiler refuses a program, so nothing can be said of what it reads.
bool findUses(const Scene &scene, std::vector<Uses> &all) {
  const fp::hw::Profile *const widest = fp::hw::findBuiltin("host");
  for (const SceneProgram &source : scene.programs) {
    const fp::CheckResult result =
        fp::checkProgram(source.language, source.text,
                         {limitsOf(*widest, source.language), fp::LimitPolicy::Report});
    if (!result.ok())
      return false;
    Uses &uses = all.emplace_back();
    uses.program = &source;
    uses.samples = samplesOf(*result.program);
    for (const fp::ir::Parameter &parameter : result.program->parameters)
      if (parameter.kind == ParameterKind::Local)
        uses.locals.push_back(parameter.index);
      else if (parameter.kind == ParameterKind::Env)
        uses.envs.push_back(parameter.index);
    for (const fp::ir::Attribute &attribute : result.program->attributes)
      if (attribute.kind == AttributeKind::Generic)
        uses.attribs.push_back(attribute.index);
  }
  return true;
}

/// "life.fp samples texture[0] as 2D and texture[1] as CUBE"
std::string sampling(const std::vector<Uses> &all) {
  std::string text;
  for (const Uses &uses : all)
    for (const Sampled &sampled : uses.samples)
      text += (text.empty() ? uses.program->name + " samples " : " and ") + "texture[" +
              std::to_string(sampled.unit) + "] as " + fp::ir::targetText(sampled.target);
  return text.empty() ? "no program samples a texture" : text;
}

std::string faultOf(const Scene::Texture &texture, const std::vector<Uses> &all) {
  const std::string option = texture.option.empty() ? "--feedback " + std::to_string(texture.unit)
                                                    : "--texture " + texture.option;
  for (const Uses &uses : all)
    for (const Sampled &sampled : uses.samples)
      if (sampled.unit == texture.unit)
        return sampled.target == TexTarget::Tex2D
                   ? ""
                   : option + ": " + uses.program->name + " samples texture[" +
                         std::to_string(sampled.unit) + "] as " +
                         fp::ir::targetText(sampled.target) + ", and this is a 2D image";
  return option + " has no effect: " + sampling(all);
}

std::string faultOf(const Scene::Parameter &parameter, const std::vector<Uses> &all,
                    std::vector<unsigned> Uses::*rows, const char *row) {
  for (const Uses &uses : all) {
    if (parameter.language && *parameter.language != uses.program->language)
      continue;
    const std::vector<unsigned> &read = uses.*rows;
    if (std::find(read.begin(), read.end(), parameter.index) != read.end())
      return {};
  }
  return parameter.option + " has no effect: no " +
         (!parameter.language                          ? ""
          : *parameter.language == Language::ArbVertex ? "vertex "
                                                       : "fragment ") +
         "program reads " + row + "[" + std::to_string(parameter.index) + "]";
}

} // namespace

std::string faultOfUses(const Scene &scene) {
  std::vector<Uses> all;
  if (!findUses(scene, all))
    return {};
  for (const Scene::Texture &texture : scene.textures)
    if (std::string fault = faultOf(texture, all); !fault.empty())
      return fault;
  struct Kind {
    const std::vector<Scene::Parameter> &given;
    std::vector<unsigned> Uses::*rows;
    const char *row;
  };
  for (const Kind &kind : {Kind{scene.locals, &Uses::locals, "program.local"},
                           Kind{scene.envs, &Uses::envs, "program.env"},
                           Kind{scene.attribs, &Uses::attribs, "vertex.attrib"}})
    for (const Scene::Parameter &parameter : kind.given)
      if (std::string fault = faultOf(parameter, all, kind.rows, kind.row); !fault.empty())
        return fault;
  return {};
}

std::vector<std::string> unfedSamples(const Scene &scene) {
  std::vector<Uses> all;
  std::vector<std::string> lines;
  if (!findUses(scene, all))
    return lines;
  for (const Uses &uses : all)
    for (const Sampled &sampled : uses.samples) {
      const auto feeds = [&](const Scene::Texture &each) { return each.unit == sampled.unit; };
      if (std::none_of(scene.textures.begin(), scene.textures.end(), feeds))
        lines.push_back(uses.program->name + ": texture[" + std::to_string(sampled.unit) + "] (" +
                        fp::ir::targetText(sampled.target) +
                        ") has no image, so its samples are black");
    }
  return lines;
}

} // namespace arbiter::tools
