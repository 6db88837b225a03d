#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

/// Tells editors what may stand at a place of a panel.
namespace arbiter::scene {

struct Candidate {
  std::string_view word;
  std::string_view meaning; ///< may be empty
};

struct PanelPlace {
  fp::Span replaced; ///< the word being written there, from its first byte
  std::vector<Candidate> candidates;
};

/// Returns the candidates at a place; nothing outside of panel lines.
[[nodiscard]] std::optional<PanelPlace> completePanel(std::string_view text, std::uint32_t offset);

/// Returns the word at the byte as the only candidate, with its meaning in that place.
[[nodiscard]] std::optional<PanelPlace> explainPanel(std::string_view text, std::uint32_t offset);

} // namespace arbiter::scene
