#include "apps/tools/draw/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "apps/scene/picture.h"
#include "util/suggest.h"

namespace arbiter::tools {

namespace {

using fp::ir::Language;
using Kind = GivenOption::Kind;
using scene::Document;
using scene::Panel;
using scene::Setting;

template <typename Number> bool readNumber(std::string_view text, Number &number) {
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

Panel &panelOf(Drawing &drawing) {
  Document &document = drawing.document;
  return document.files[std::size_t(document.passes.front().panel)].panel;
}

/// Each function below applies one option.
/// \returns an empty string, or a complaint.
std::string applySize(const std::string &text, Panel &panel) {
  const std::size_t mark = text.find('x');
  int width = 0, height = 0;
  const bool good = mark != std::string::npos &&
                    readNumber(std::string_view(text).substr(0, mark), width) &&
                    readNumber(std::string_view(text).substr(mark + 1), height) && width > 0 &&
                    height > 0 && width <= scene::kMaxSide && height <= scene::kMaxSide;
  panel.width = {double(width), {}};
  panel.height = {double(height), {}};
  return good ? "" : "--size " + text + ": expected WxH, 1 to 8192 pixels a side";
}

std::string applyMesh(const std::string &name, Drawing &drawing) {
  // A file name is relative to the working folder, not to the document's.
  const auto shape = scene::findWord<scene::Shape>(name).value_or(scene::Shape::File);
  if (name == "shells" || name == "fins" || name == "volume")
    return "--mesh " + name + ": is made of another shape; a document says of which";
  if (shape == scene::Shape::Grid && drawing.document.passes.front().vertex < 0)
    return "--mesh grid has no effect without a vertex program: it looks as the quad";
  scene::ShapeSpec spec;
  spec.shape = {shape, {}};
  std::error_code error;
  if (shape == scene::Shape::File)
    spec.file = {std::filesystem::absolute(name, error).string(), {}};
  const auto rows = scene::rowOf(shape).arguments();
  for (std::size_t i = 0; i < rows.size(); ++i)
    spec.arguments.numbers[i] = {rows[i].fallback, {}};
  panelOf(drawing).mesh = {spec};
  return {};
}

/// Reads "x,y,z,w"; missing components are 0.
bool readVector(std::string_view list, std::vector<scene::Number> &values) {
  while (values.size() < 4) {
    const std::size_t comma = std::min(list.find(','), list.size());
    float value = 0;
    if (!readNumber(list.substr(0, comma), value))
      return false;
    values.push_back({value, {}});
    if (comma == list.size())
      return true;
    list.remove_prefix(comma + 1);
  }
  return false; // there is a fifth component
}

/// Replaces the panel's values of the parameter.
void replace(Panel &panel, const scene::Parameter &parameter) {
  std::erase_if(panel.parameters, [&](const scene::Parameter &other) {
    return other.space == parameter.space && other.first <= parameter.first &&
           parameter.first < other.first + other.count;
  });
  panel.parameters.push_back(parameter);
}

/// Applies "N=x,y,z,w". If the parameter is \p staged, "vp:" or "fp:" may come first.
std::string applyParameter(const std::string &name, std::string_view text, Setting space,
                           Drawing &drawing) {
  const bool staged = space != Setting::Attrib;
  GivenOption given{space == Setting::Local ? Kind::Local
                    : space == Setting::Env ? Kind::Env
                                            : Kind::Attrib,
                    name + " " + std::string(text),
                    0,
                    {}};
  if (staged && (text.starts_with("vp:") || text.starts_with("fp:"))) {
    given.language = text[0] == 'v' ? Language::ArbVertex : Language::ArbFragment;
    text.remove_prefix(3);
  }
  scene::Parameter parameter;
  parameter.space = space;
  const std::size_t mark = text.find('=');
  if (mark == std::string_view::npos || !readNumber(text.substr(0, mark), given.index) ||
      !readVector(text.substr(mark + 1), parameter.values))
    return given.option + ": expected " + (staged ? "[vp:|fp:]" : "") + "N=x,y,z,w";
  for (const GivenOption &other : drawing.given)
    if (other.kind == given.kind && other.index == given.index && other.language == given.language)
      return name + " " + std::to_string(given.index) + " is given twice";
  parameter.first = given.index;
  const scene::Pass &pass = drawing.document.passes.front();
  for (const int file : {pass.fragment, pass.vertex}) {
    if (file < 0 || (space == Setting::Attrib && file != pass.panel))
      continue;
    scene::ProgramFile &program = drawing.document.files[std::size_t(file)];
    if (!given.language || *given.language == program.language)
      replace(program.panel, parameter);
  }
  drawing.given.push_back(std::move(given));
  return {};
}

std::string applyParameters(const DrawArguments &arguments, Drawing &drawing) {
  for (const auto &[option, list, space] :
       {std::tuple("--local", &arguments.locals, Setting::Local),
        std::tuple("--env", &arguments.envs, Setting::Env),
        std::tuple("--attrib", &arguments.attribs, Setting::Attrib)})
    for (const std::string &text : *list)
      if (std::string fault = applyParameter(option, text, space, drawing); !fault.empty())
        return fault;
  return {};
}

scene::TextureSource sourceOf(const std::string &name, const Document &document) {
  using scene::Generator;
  scene::TextureSource source;
  source.generator.value = scene::findWord<Generator>(name).value_or(Generator::File);
  // Feedback must begin with an image of the picture's size.
  if (source.generator.value == Generator::Noise || source.generator.value == Generator::Cells) {
    source.width = {double(document.width()), {}};
    source.height = {double(document.height()), {}};
  }
  if (source.generator.value == Generator::File) {
    // The name is relative to the working folder, not to the document's; panels have no absolute
    // names.
    std::error_code error;
    source.files = {{std::filesystem::absolute(name, error).string(), {}}};
  }
  const auto rows = scene::rowOf(source.generator.value).arguments();
  for (std::size_t i = 0; i < rows.size(); ++i)
    source.arguments.numbers[i] = {rows[i].fallback, {}};
  return source;
}

scene::TextureSpec &unitOf(Panel &panel, unsigned unit) {
  for (scene::TextureSpec &texture : panel.textures)
    if (texture.unit == unit)
      return texture;
  panel.textures.emplace_back().unit = unit;
  return panel.textures.back();
}

/// Returns a complaint if an image is named by neither a word nor a file, or "". It lists the
/// possible words.
std::string faultOfImage(const std::string &name) {
  const std::vector<std::string_view> words = generatorWords();
  if (std::find(words.begin(), words.end(), name) != words.end())
    return {};
  if (scene::findWord<scene::Generator>(name))
    return "a document alone can have that image: #@ texture N = " + name;
  std::error_code error;
  if (name.find_first_of("./") != std::string::npos || std::filesystem::exists(name, error))
    return {}; // reading the file gives a better error
  if (const std::string_view near = nearest(name, words); !near.empty())
    return "there is no such file; did you mean " + std::string(near) + "?";
  std::string text = "there is no such file, and no such word; words are ";
  for (const std::string_view word : words)
    text += (word == words.front() ? "" : ", ") + std::string(word);
  return text;
}

std::string applyTexture(const std::string &text, Drawing &drawing) {
  GivenOption given{Kind::Texture, "--texture " + text, 0, {}};
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos || mark + 1 == text.size() ||
      !readNumber(std::string_view(text).substr(0, mark), given.index))
    return given.option + ": expected N=IMG, a PNG, JPEG or DDS file or a word such as checker";
  if (const std::string fault = faultOfImage(text.substr(mark + 1)); !fault.empty())
    return given.option + ": " + fault;
  for (const GivenOption &other : drawing.given)
    if (other.kind == Kind::Texture && other.index == given.index)
      return "--texture " + std::to_string(given.index) + " is given twice";
  scene::TextureSpec &texture = unitOf(panelOf(drawing), given.index);
  texture.unitSpan = {};
  texture.source = sourceOf(text.substr(mark + 1), drawing.document);
  drawing.given.push_back(std::move(given));
  return {};
}

/// Applies --feedback. The unit's texture becomes the first content of the feedback, in the
/// picture's size.
std::string applyFeedback(const DrawArguments &arguments, Drawing &drawing) {
  if (arguments.feedback < 0)
    return {};
  const auto unit = unsigned(arguments.feedback);
  const std::string option = "--feedback " + std::to_string(unit);
  Panel &panel = panelOf(drawing);
  const bool begins = std::any_of(panel.textures.begin(), panel.textures.end(),
                                  [&](const auto &texture) { return texture.unit == unit; });
  scene::TextureSpec &texture = unitOf(panel, unit);
  scene::TextureSource feedback;
  feedback.generator.value = scene::Generator::Feedback;
  if (begins)
    feedback.of = {texture.source};
  const bool ofOption = texture.source.generator.span.end == 0; // an option has no position in a
                                                                // text
  if (begins && ofOption && texture.source.generator.value != scene::Generator::File &&
      (texture.source.width.value != panel.width.value ||
       texture.source.height.value != panel.height.value))
    return option + ": the texture must have the size of the picture, " +
           std::to_string(drawing.document.width()) + "x" +
           std::to_string(drawing.document.height());
  texture.source = std::move(feedback);
  texture.filter.value = scene::Filter::Nearest;
  drawing.given.push_back({Kind::Feedback, option, unit, {}});
  return {};
}

} // namespace

std::vector<std::string_view> generatorWords() {
  using scene::Generator;
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < scene::wordsOf<Generator>().size(); ++i) {
    const auto generator = Generator(i);
    const bool aloneIsWhole = generator != Generator::File && generator != Generator::Normals &&
                              generator != Generator::Feedback && generator != Generator::Picture &&
                              generator != Generator::DepthOf;
    if (aloneIsWhole && !scene::isCube(generator))
      words.push_back(scene::rowOf(generator).word);
  }
  return words;
}

std::string applyTextures(const std::vector<std::string> &textures, Drawing &drawing) {
  for (const std::string &text : textures)
    if (std::string fault = applyTexture(text, drawing); !fault.empty())
      return fault;
  return {};
}

std::string applyOptions(const DrawArguments &arguments, Drawing &drawing) {
  std::string fault;
  if (!arguments.size.empty())
    fault = applySize(arguments.size, drawing.document.files.front().panel);
  if (fault.empty() && !arguments.mesh.empty())
    fault = applyMesh(arguments.mesh, drawing);
  if (fault.empty())
    fault = applyParameters(arguments, drawing);
  if (fault.empty())
    fault = applyTextures(arguments.textures, drawing);
  if (fault.empty())
    fault = applyFeedback(arguments, drawing);
  return fault;
}

} // namespace arbiter::tools
