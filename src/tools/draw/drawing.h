#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/document.h"
#include "tools/commands.h"
#include "util/result.h"

/// What `arbiter draw` draws: a document, changed by the options of the command line.
namespace arbiter::tools {

/// An option that gives a program something to read.
struct GivenOption {
  enum class Kind { Texture, Feedback, Local, Env, Attrib };
  Kind kind = Kind::Texture;
  std::string option; ///< as it was given: "--texture 0=photo.png"
  unsigned index = 0; ///< of the unit or the parameter
  /// Of one program; without: of every one that reads it.
  std::optional<fp::ir::Language> language;
};

struct Drawing {
  scene::Document document;
  std::vector<GivenOption> given;
  int first = 0; ///< frames that are drawn, in order; the last one's picture is kept
  int last = 0;
};

struct DrawingError {
  std::string message;
};

/// Reads the document, or the two programs, and changes them as the arguments say. An argument that
/// is malformed or given twice is an error that names it; wrong lines of panels are left in the
/// document's diagnostics.
[[nodiscard]] Result<Drawing, DrawingError> readDrawing(const DrawArguments &arguments);

} // namespace arbiter::tools
