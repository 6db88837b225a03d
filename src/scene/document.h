#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fp_compiler/file_programs.h"
#include "scene/animate.h"
#include "scene/panel/panel.h"
#include "util/result.h"

/// A document: one program text with its panel, and the files beside it that the panel names. A
/// file may have a vertex program beside its fragment program: both are of its pass.
namespace arbiter::scene {

/// The profile that a panel names, as hw::loadProfile() takes it; empty: none. A file of one is
/// looked for in the document's folder.
/// \param folder as Document::folder
[[nodiscard]] std::string profileOf(const Panel &panel, const std::string &folder);

struct ProgramFile {
  std::string name; ///< as it is shown: the folder and the name, or "<stdin>"
  std::string text; ///< all of it, with the other programs that may be in it
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  /// Its `diagnostics` also have what is wrong with a line in the light of the other files.
  Panel panel;
  fp::Span place; ///< of the program in the text

  [[nodiscard]] fp::FileProgram program() const { return {language, place}; }
  /// Returns the text that GL is given.
  [[nodiscard]] std::string_view source() const { return program().in(text); }
};

/// One program of a file, with the lines of its panel.
/// \param language of which it is; none: the first fragment program of the file, or its first one.
///        Lines beside all programs are of that one.
[[nodiscard]] ProgramFile programFile(std::string name, std::string text,
                                      std::optional<fp::ir::Language> language = {});

/// One pass draws one mesh. Numbers of Document::files, or -1 for GL's fixed function.
struct Pass {
  int fragment = -1;
  int vertex = -1;
  int panel = 0; ///< the file whose panel holds for the pass
};

class Document {
public:
  std::string folder;             ///< with a slash behind it; empty: the working folder
  std::vector<ProgramFile> files; ///< the first one is the document's own
  std::vector<Pass> passes;       ///< in the order in which they are drawn; at least one

  [[nodiscard]] const Panel &panel() const { return files.front().panel; }
  [[nodiscard]] const Panel &panelOf(const Pass &pass) const {
    return files[std::size_t(pass.panel)].panel;
  }
  /// No file has an error in its panel.
  [[nodiscard]] bool ok() const;
  [[nodiscard]] int width() const { return int(panel().width.value); }
  [[nodiscard]] int height() const { return int(panel().height.value); }
  [[nodiscard]] double secondsOf(int frame) const { return frame / panel().rate.value; }

  /// What a further pass does not say of mesh and camera it has from the first one.
  [[nodiscard]] const std::vector<ShapeSpec> &meshOf(const Pass &pass) const;
  [[nodiscard]] const std::optional<CameraSpec> &cameraOf(const Pass &pass) const;
  /// Pixels that the pass draws to.
  [[nodiscard]] std::pair<int, int> sizeOf(const Pass &pass) const;
  [[nodiscard]] View viewOf(const Pass &pass) const;
  /// Where its panel says nothing: less, but off for quads and grids without a camera.
  [[nodiscard]] Depth depthOf(const Pass &pass) const;
  /// A pass begins with an empty target, unless it is to keep what is there.
  [[nodiscard]] bool clears(std::size_t pass) const;
  /// The parameters of one of the pass's programs.
  [[nodiscard]] std::vector<ParameterRow> rows(const Pass &pass, int file, double seconds) const;
  [[nodiscard]] std::string profile() const { return profileOf(panel(), folder); }
  /// A unit whose image is the last frame's picture, in any pass.
  [[nodiscard]] bool hasFeedback() const;
};

struct DocumentError {
  std::string message; ///< "name: reason"
};

/// The text of a file beside the document. An editor gives texts that are not saved yet.
using ReadText = std::function<Result<std::string, DocumentError>(const std::string &path)>;

/// Reads a document from its path: a program, or a folder, whose document is the file of the same
/// name, else main.fp, else the only program with the ending .fp. A file that cannot be read is an
/// error only where it is the document itself; any other is a diagnostic of the line that names it.
[[nodiscard]] Result<Document, DocumentError> loadDocument(const std::string &path);

/// The same of a text in memory.
/// \param path where the text would be; "<stdin>" or a name: files beside it are looked for there
[[nodiscard]] Document assemble(const std::string &path, std::string text, const ReadText &read);

/// What is wrong with a text's panel, in text order, also in the light of the files beside it. No
/// file is read for a text without a panel, nor for a path that is empty.
[[nodiscard]] std::vector<fp::Diagnostic> checkPanel(const std::string &path,
                                                     const std::string &text);

/// The bytes of a file, at most 64 MiB.
[[nodiscard]] Result<std::string, DocumentError> readText(const std::string &path);

} // namespace arbiter::scene
