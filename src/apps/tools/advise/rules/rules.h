#pragma once
#include <span>

#include "apps/tools/advise/draft.h"

/// Lists the rules, one function each. A rule proposes changes without testing them; advise.cpp
/// tests cost and results. So a rule may propose changes that often fail.
namespace arbiter::tools::advise {

struct Rule {
  const char *id;
  const char *title; ///< the pattern that it finds, for lists
  Proposals (*propose)(const Subject &subject);
};

/// Returns the rules in the order in which they are tried.
[[nodiscard]] std::span<const Rule> rules();

// constants.cpp, parameters.cpp
[[nodiscard]] Proposals constantWork(const Subject &subject);
[[nodiscard]] Proposals constantChain(const Subject &subject);
[[nodiscard]] Proposals parameterWork(const Subject &subject);
// interpolation.cpp
[[nodiscard]] Proposals linearWork(const Subject &subject);
[[nodiscard]] Proposals operandOrder(const Subject &subject);
// arrange.cpp
[[nodiscard]] Proposals arrangements(const Subject &subject);
// tables.cpp
[[nodiscard]] Proposals tableOfOne(const Subject &subject);
[[nodiscard]] Proposals cubeMap(const Subject &subject);
// clamp.cpp
[[nodiscard]] Proposals clamps(const Subject &subject);
// angles.cpp
[[nodiscard]] Proposals sineAndCosine(const Subject &subject);
// select.cpp
[[nodiscard]] Proposals selects(const Subject &subject);
[[nodiscard]] Proposals complements(const Subject &subject);
// powers.cpp
[[nodiscard]] Proposals powers(const Subject &subject);
// pairs.cpp
[[nodiscard]] Proposals scalarPairs(const Subject &subject);
// repeats.cpp
[[nodiscard]] Proposals repeats(const Subject &subject);
[[nodiscard]] Proposals copies(const Subject &subject);
[[nodiscard]] Proposals deadWork(const Subject &subject);
// dots.cpp
[[nodiscard]] Proposals dotProducts(const Subject &subject);
// forms.cpp
[[nodiscard]] Proposals multiplyAdd(const Subject &subject);
[[nodiscard]] Proposals homogeneousProducts(const Subject &subject);
[[nodiscard]] Proposals blends(const Subject &subject);
[[nodiscard]] Proposals identities(const Subject &subject);
// samples.cpp
[[nodiscard]] Proposals earlySamples(const Subject &subject);
[[nodiscard]] Proposals killPlaces(const Subject &subject);

} // namespace arbiter::tools::advise
