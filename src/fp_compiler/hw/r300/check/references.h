#pragma once
#include <string>
#include <type_traits>
#include <vector>

#include "fp_compiler/hw/r300/check/legality.h"

/// The part of faults() that needs the program.
namespace arbiter::fp::hw::r300 {

/// Adds a fault for each thing that \p code refers to and \p program does not have.
void addReferenceFaults(const Code &code, const ir::Program &program, std::vector<Fault> &faults);

/// Joins the parts, which are text or numbers.
template <typename... Parts> [[nodiscard]] std::string say(const Parts &...parts) {
  std::string text;
  const auto add = [&](const auto &part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>)
      text += std::to_string(part);
    else
      text += part;
  };
  (add(parts), ...);
  return text;
}

} // namespace arbiter::fp::hw::r300
