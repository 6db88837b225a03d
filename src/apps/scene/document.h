#pragma once
#include <functional>
#include <string>
#include <vector>

#include "apps/scene/animate.h"
#include "apps/scene/panel/panel.h"
#include "fp_compiler/file_programs.h"
#include "util/result.h"

/// A document: a program text with its panel, and the files beside it that the panel names. A file
/// may have a vertex program beside its fragment program; both belong to its pass.
namespace arbiter::scene {

/// Returns the profile that a panel names, as hw::loadProfile() takes it; empty: none. A profile
/// file is looked up in the document's folder.
/// \param folder as Document::folder
[[nodiscard]] std::string profileOf(const Panel &panel, const std::string &folder);

struct ProgramFile {
  std::string name; ///< as displayed: the folder and the name, or "<stdin>"
  std::string text; ///< the whole file, including other programs in it
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  /// The panel. Its `diagnostics` include errors that depend on the other files.
  Panel panel;
  fp::Span place; ///< of the program in the text

  [[nodiscard]] fp::FileProgram program() const { return {language, place}; }
  /// Returns the text that is passed to GL.
  [[nodiscard]] std::string_view source() const { return program().in(text); }
};

/// Returns one program of a file, with the lines of its panel.
/// \param language of the program; none: the first fragment program of the file, or else the first
///        program. Lines outside of all programs belong to it.
[[nodiscard]] ProgramFile programFile(std::string name, std::string text,
                                      std::optional<fp::ir::Language> language = {});

/// A pass, which draws one mesh. Its programs are numbers of Document::files, or -1 for GL's fixed
/// function.
struct Pass {
  int fragment = -1;
  int vertex = -1;
  int panel = 0; ///< the file whose panel applies to the pass
};

class Document {
public:
  std::string folder;             ///< ends with a slash; empty: the working folder
  std::vector<ProgramFile> files; ///< the first one is the document's own
  std::vector<Pass> passes;       ///< in drawing order; at least one

  [[nodiscard]] const Panel &panel() const { return files.front().panel; }
  [[nodiscard]] const Panel &panelOf(const Pass &pass) const {
    return files[std::size_t(pass.panel)].panel;
  }
  /// True if no file has an error in its panel.
  [[nodiscard]] bool ok() const;
  [[nodiscard]] int width() const { return int(panel().width.value); }
  [[nodiscard]] int height() const { return int(panel().height.value); }
  [[nodiscard]] double secondsOf(int frame) const { return frame / panel().rate.value; }

  /// These return the first pass's mesh or camera if a later pass sets none.
  [[nodiscard]] const std::vector<ShapeSpec> &meshOf(const Pass &pass) const;
  [[nodiscard]] const std::optional<CameraSpec> &cameraOf(const Pass &pass) const;
  /// Returns the size in pixels of the picture that the pass draws to.
  [[nodiscard]] std::pair<int, int> sizeOf(const Pass &pass) const;
  [[nodiscard]] View viewOf(const Pass &pass) const;
  /// Returns the pass's depth test. The default is less, but off for quads and grids without a
  /// camera.
  [[nodiscard]] Depth depthOf(const Pass &pass) const;
  /// True if the pass clears its target first, unless the panel keeps its content.
  [[nodiscard]] bool clears(std::size_t pass) const;
  /// Returns the parameters of one of the pass's programs.
  [[nodiscard]] std::vector<ParameterRow> rows(const Pass &pass, int file, double seconds) const;
  [[nodiscard]] std::string profile() const { return profileOf(panel(), folder); }
  /// True if a unit of any pass samples the last frame's picture.
  [[nodiscard]] bool hasFeedback() const;
};

struct DocumentError {
  std::string message; ///< "name: reason"
};

/// Reads the text of a file beside the document. An editor supplies texts that are not saved yet.
using ReadText = std::function<Result<std::string, DocumentError>(const std::string &path)>;

/// Loads a document from a path to a program or a folder. A folder's document is the file of the
/// same name, else main.fp, else the only program with the ending .fp. An unreadable file is an
/// error only if it is the document itself; otherwise the line that names it gets a diagnostic.
[[nodiscard]] Result<Document, DocumentError> loadDocument(const std::string &path);

/// Loads a document from a text in memory.
/// \param path where the text would be; "<stdin>" or a name. It determines where files are looked
/// up.
[[nodiscard]] Document assemble(const std::string &path, std::string text, const ReadText &read);

/// Returns the diagnostics of a text's panel, in text order, including those that depend on the
/// files beside it. It reads no file if the text has no panel or the path is empty.
[[nodiscard]] std::vector<fp::Diagnostic> checkPanel(const std::string &path,
                                                     const std::string &text);

/// Reads the bytes of a file of at most 64 MiB.
[[nodiscard]] Result<std::string, DocumentError> readText(const std::string &path);

} // namespace arbiter::scene
