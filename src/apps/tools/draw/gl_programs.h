#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <vector>

#include "apps/tools/draw/gl_queries.h"
#include "apps/tools/draw/renderer.h"
#include "fp_compiler/front/nvparse/text.h"

namespace arbiter::tools {

/// Owns the GL program objects of a document's files.
class Programs {
public:
  Programs() = default;
  Programs(const Programs &) = delete;
  Programs &operator=(const Programs &) = delete;
  ~Programs();

  [[nodiscard]] std::optional<RenderError> load(const scene::Document &document);
  /// Enables the programs of a pass, and sets their parameters and its generic attributes.
  void use(const scene::Document &document, const scene::Pass &pass, double seconds) const;
  /// Disables all programs.
  static void disable(const scene::Document &document);

private:
  std::optional<RenderError> loadFile(const scene::Document &document, std::size_t file);
  std::optional<RenderError> loadState(const scene::Document &document, std::size_t file);
  void useState(std::size_t file, const std::vector<scene::ParameterRow> &rows) const;

  std::vector<GLuint> m_names;                            ///< one per file; 0 for nvparse texts
  std::vector<std::optional<fp::nvparse::Text>> m_states; ///< one per file; set for nvparse texts
};

} // namespace arbiter::tools
