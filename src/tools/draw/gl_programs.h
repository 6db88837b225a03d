#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <vector>

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

  std::vector<GLuint> m_names; ///< one for each file
};

} // namespace arbiter::tools
