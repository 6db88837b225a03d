#include <algorithm>
#include <filesystem>

#include "apps/tools/draw/drawing.h"
#include "apps/tools/draw/options.h"
#include "apps/tools/input.h"

namespace arbiter::tools {

namespace {

using fp::ir::Language;
using scene::Document;

const char *stageOf(bool vertex) { return vertex ? "vertices" : "fragments"; }

/// Reads a document's text from a file, or from standard input for "-".
Result<std::string, scene::DocumentError> readAny(const std::string &path) {
  if (path != "-")
    return scene::readText(path);
  auto text = readInput(path);
  if (!text)
    return scene::DocumentError{text.error().message};
  return std::move(text).value();
}

Result<Document, DrawingError> readDocument(const std::string &path) {
  std::error_code error;
  if (path == "-") {
    auto text = readInput(path);
    if (!text)
      return DrawingError{text.error().message};
    return scene::assemble("<stdin>", std::move(text).value(), scene::readText);
  }
  auto document = scene::loadDocument(path);
  if (!document)
    return DrawingError{document.error().message};
  return std::move(document).value();
}

/// Adds a second file as the other stage of the first pass.
std::string addProgram(const std::string &path, Document &document) {
  auto text = readAny(path);
  if (!text)
    return text.error().message;
  scene::ProgramFile file =
      scene::programFile(path == "-" ? "<stdin>" : path, std::move(text).value());
  const bool vertex = file.language == Language::ArbVertex;
  scene::Pass &pass = document.passes.front();
  int &place = vertex ? pass.vertex : pass.fragment;
  if (place >= 0)
    return document.files[std::size_t(place)].name + " and " + file.name +
           " are both programs of " + stageOf(vertex) + ": one of each can be drawn with";
  place = int(document.files.size());
  document.files.push_back(std::move(file));
  // The fragment program's panel is used, in any order of the files.
  if (!vertex) {
    std::swap(document.files.front(), document.files.back());
    std::swap(pass.vertex, pass.fragment);
  }
  return {};
}

std::string readFiles(const DrawArguments &arguments, Document &document) {
  for (const std::string &file : arguments.files) {
    if (isSameFile(file, arguments.output))
      return arguments.output + ": is the program itself";
    if (file.ends_with(".png"))
      return file + " is no program: -o " + file +
             " writes the picture there, --texture N=" + file + " reads it";
  }
  auto first = readDocument(arguments.files.front());
  if (!first)
    return first.error().message;
  document = std::move(first).value();
  return arguments.files.size() > 1 ? addProgram(arguments.files[1], document) : std::string();
}

/// Sets the range of frames. --frames draws that many from the first. --frame draws one, and with
/// feedback all frames before it.
std::string readFrames(const DrawArguments &arguments, Drawing &drawing) {
  const bool feeds = drawing.document.hasFeedback();
  if (arguments.frame >= 0) {
    drawing.last = arguments.frame;
    drawing.first = feeds ? 0 : arguments.frame;
    return {};
  }
  drawing.last = arguments.frames - 1;
  if (arguments.feedback >= 0 && arguments.frames == 1)
    return "--feedback " + std::to_string(arguments.feedback) +
           " has no effect on one frame; --frames asks for more";
  return {};
}

} // namespace

Result<Drawing, DrawingError> readDrawing(const DrawArguments &arguments) {
  Drawing drawing;
  std::string fault = readFiles(arguments, drawing.document);
  if (fault.empty())
    fault = applyOptions(arguments, drawing);
  if (fault.empty())
    fault = readFrames(arguments, drawing);
  if (!fault.empty())
    return DrawingError{fault};
  return drawing;
}

} // namespace arbiter::tools
