#pragma once
#include <optional>
#include <string>
#include <vector>

#include "apps/scene/document.h"
#include "apps/tools/commands.h"
#include "util/result.h"

/// Prepares a drawing for `arbiter draw`: a document with the changes of the command line.
namespace arbiter::tools {

/// An option that supplies a texture or a value to programs.
struct GivenOption {
  enum class Kind { Texture, Feedback, Local, Env, Attrib };
  Kind kind = Kind::Texture;
  std::string option; ///< as given: "--texture 0=photo.png"
  unsigned index = 0; ///< number of the unit or the parameter
  /// The language of the only program that it applies to; empty: all programs that read the value.
  std::optional<fp::ir::Language> language;
};

struct Drawing {
  scene::Document document;
  std::vector<GivenOption> given;
  int first = 0; ///< first frame; frames are drawn in order, and the last picture is kept
  int last = 0;
};

struct DrawingError {
  std::string message;
};

/// Reads the document, or the two programs, and applies the arguments. A malformed or repeated
/// argument is an error that names it. Wrong lines of panels are kept in the document's
/// diagnostics.
[[nodiscard]] Result<Drawing, DrawingError> readDrawing(const DrawArguments &arguments);

} // namespace arbiter::tools
