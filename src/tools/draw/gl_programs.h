#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <vector>

#include "fp_compiler/front/nvparse/text.h"
#include "tools/draw/gl_queries.h"
#include "tools/draw/renderer.h"

namespace arbiter::tools {

/// The program objects of a document's files.
class Programs {
public:
  Programs() = default;
  Programs(const Programs &) = delete;
  Programs &operator=(const Programs &) = delete;
  ~Programs();

  [[nodiscard]] std::optional<RenderError> load(const scene::Document &document);
  /// Enables the programs of a pass with their parameters, and gives its generic attributes.
  void use(const scene::Document &document, const scene::Pass &pass, double seconds) const;
  /// Disables all.
  static void disable(const scene::Document &document);

private:
  std::optional<RenderError> loadFile(const scene::Document &document, std::size_t file);
  std::optional<RenderError> loadState(const scene::Document &document, std::size_t file);
  void useState(std::size_t file, const std::vector<scene::ParameterRow> &rows) const;

  std::vector<GLuint> m_names;                            ///< one for each file; 0 for nvparse's
  std::vector<std::optional<fp::nvparse::Text>> m_states; ///< nvparse's
};

} // namespace arbiter::tools
