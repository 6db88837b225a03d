#include <algorithm>
#include <charconv>
#include <tuple>

#include "tools/draw/scene.h"
#include "tools/input.h"
#include "tools/language.h"

namespace arbiter::tools {

namespace {

using fp::ir::Language;

constexpr int kMaxSide = 8192;
constexpr int kCheckerSide = 256;

template <typename Number> bool readNumber(std::string_view text, Number &number) {
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

/// Each function fills its part of the scene. \returns an empty string, or what is wrong.
std::string readSize(const std::string &text, Scene &scene) {
  const std::size_t mark = text.find('x');
  const bool good = mark != std::string::npos &&
                    readNumber(std::string_view(text).substr(0, mark), scene.width) &&
                    readNumber(std::string_view(text).substr(mark + 1), scene.height) &&
                    scene.width > 0 && scene.height > 0 && scene.width <= kMaxSide &&
                    scene.height <= kMaxSide;
  return good ? "" : "--size " + text + ": expected WxH, 1 to 8192 pixels a side";
}

/// "x,y,z,w"; missing components are 0.
bool readVector(std::string_view list, std::array<float, 4> &value) {
  for (float &component : value) {
    const std::size_t comma = std::min(list.find(','), list.size());
    if (!readNumber(list.substr(0, comma), component))
      return false;
    if (comma == list.size())
      return true;
    list.remove_prefix(comma + 1);
  }
  return false; // a fifth component
}

/// "N=x,y,z,w", and before it "vp:" or "fp:" where \p staged.
std::string readParameter(const std::string &option, std::string_view text, bool staged,
                          std::vector<Scene::Parameter> &parameters) {
  Scene::Parameter parameter;
  parameter.option = option + " " + std::string(text);
  if (staged && (text.starts_with("vp:") || text.starts_with("fp:"))) {
    parameter.language = text[0] == 'v' ? Language::ArbVertex : Language::ArbFragment;
    text.remove_prefix(3);
  }
  const std::size_t mark = text.find('=');
  if (mark == std::string_view::npos || !readNumber(text.substr(0, mark), parameter.index) ||
      !readVector(text.substr(mark + 1), parameter.value))
    return parameter.option + ": expected " + (staged ? "[vp:|fp:]" : "") + "N=x,y,z,w";
  for (const Scene::Parameter &other : parameters)
    if (other.index == parameter.index && other.language == parameter.language)
      return option + " " + std::to_string(parameter.index) + " is given twice";
  parameters.push_back(std::move(parameter));
  return {};
}

std::string readParameters(const DrawArguments &arguments, Scene &scene) {
  for (const auto &[option, list, staged, parameters] :
       {std::tuple("--local", &arguments.locals, true, &scene.locals),
        std::tuple("--env", &arguments.envs, true, &scene.envs),
        std::tuple("--attrib", &arguments.attribs, false, &scene.attribs)})
    for (const std::string &text : *list)
      if (std::string fault = readParameter(option, text, staged, *parameters); !fault.empty())
        return fault;
  return {};
}

std::string readTexture(const std::string &text, Scene &scene) {
  Scene::Texture texture;
  texture.option = text;
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos ||
      !readNumber(std::string_view(text).substr(0, mark), texture.unit))
    return "--texture " + text + ": expected N=IMG.png, N=checker or N=noise";
  for (const Scene::Texture &other : scene.textures)
    if (other.unit == texture.unit)
      return "--texture " + std::to_string(texture.unit) + " is given twice";
  const std::string source = text.substr(mark + 1);
  if (source == "checker") {
    texture.picture = checker(kCheckerSide);
  } else if (source == "noise") {
    texture.picture = noise(scene.width, scene.height);
  } else {
    auto picture = readPng(source);
    if (!picture)
      return picture.error().message;
    texture.picture = std::move(picture).value();
  }
  scene.textures.push_back(std::move(texture));
  return {};
}

/// A feedback unit needs a texture of the picture's size, black where none was asked for.
std::string readFeedback(const DrawArguments &arguments, Scene &scene) {
  scene.feedback = arguments.feedback;
  if (scene.feedback < 0)
    return {};
  const std::string option = "--feedback " + std::to_string(scene.feedback);
  if (scene.frames == 1)
    return option + " has no effect on one frame; --frames asks for more";
  for (const Scene::Texture &texture : scene.textures) {
    if (int(texture.unit) != scene.feedback)
      continue;
    if (texture.picture.width != scene.width || texture.picture.height != scene.height)
      return option + ": the texture must have the size of the picture, " + arguments.size;
    return {};
  }
  Picture black{scene.width, scene.height,
                std::vector<std::uint8_t>(std::size_t(4) * scene.width * scene.height)};
  scene.textures.push_back({unsigned(scene.feedback), {}, std::move(black)});
  return {};
}

/// One program for a stage, the vertex program first whatever the order of the files.
std::string readPrograms(const DrawArguments &arguments, Scene &scene) {
  for (const std::string &file : arguments.files) {
    if (isSameFile(file, arguments.output))
      return arguments.output + ": is the program itself";
    auto text = readInput(file);
    if (!text)
      return text.error().message;
    SceneProgram program{file == "-" ? "<stdin>" : file, std::move(text).value(), {}};
    program.language = chooseLanguage("auto", program.text);
    const bool vertex = program.language == Language::ArbVertex;
    for (const SceneProgram &other : scene.programs)
      if ((other.language == Language::ArbVertex) == vertex)
        return program.name + " and " + other.name + " are both programs of " +
               (vertex ? "vertices" : "fragments") + ": one of each can be drawn with";
    scene.programs.insert(vertex ? scene.programs.begin() : scene.programs.end(),
                          std::move(program));
  }
  return {};
}

std::string readMesh(const std::string &name, Scene &scene) {
  scene.mesh = name == "grid" ? Mesh::Grid : name == "sphere" ? Mesh::Sphere : Mesh::Quad;
  return scene.mesh == Mesh::Grid && !scene.hasVertexProgram()
             ? "--mesh grid has no effect without a vertex program: it looks as the quad"
             : "";
}

} // namespace

Result<Scene, SceneError> readScene(const DrawArguments &arguments) {
  Scene scene;
  scene.frames = arguments.frames;
  std::string fault = readSize(arguments.size, scene);
  if (fault.empty())
    fault = readPrograms(arguments, scene);
  if (fault.empty())
    fault = readMesh(arguments.mesh, scene);
  if (fault.empty())
    fault = readParameters(arguments, scene);
  for (const std::string &text : arguments.textures)
    if (fault.empty())
      fault = readTexture(text, scene);
  if (fault.empty())
    fault = readFeedback(arguments, scene);
  if (!fault.empty())
    return SceneError{fault};
  return scene;
}

} // namespace arbiter::tools
