#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "tools/advise/subject.h"

/// Inputs that a program does not use and the profile has: where advice could move work to.
namespace arbiter::tools::advise {

[[nodiscard]] std::optional<std::uint8_t> freeLocal(const Subject &subject);
[[nodiscard]] std::vector<std::uint8_t> freeTexCoords(const Subject &subject);
[[nodiscard]] std::optional<std::uint8_t> freeUnit(const Subject &subject);

/// "program.local[3]"
[[nodiscard]] std::string localText(std::uint8_t index);
/// "fragment.texcoord[3]"
[[nodiscard]] std::string texCoordText(std::uint8_t index);

} // namespace arbiter::tools::advise
