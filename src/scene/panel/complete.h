#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

/// What may stand in a place of a panel: for editors.
namespace arbiter::scene {

struct Candidate {
  std::string_view word;
  std::string_view meaning; ///< may be empty
};

struct PanelPlace {
  fp::Span replaced; ///< the word that is being written there, from its first byte on
  std::vector<Candidate> candidates;
};

/// Nothing outside of panel lines.
[[nodiscard]] std::optional<PanelPlace> completePanel(std::string_view text, std::uint32_t offset);

/// The word that the byte is in, with its meaning in that place; the only candidate.
[[nodiscard]] std::optional<PanelPlace> explainPanel(std::string_view text, std::uint32_t offset);

} // namespace arbiter::scene
