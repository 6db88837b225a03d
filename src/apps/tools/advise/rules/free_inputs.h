#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "apps/tools/advise/subject.h"

/// Finds inputs that the profile has and a program does not use, to which advice can move work.
namespace arbiter::tools::advise {

[[nodiscard]] std::optional<std::uint8_t> freeLocal(const Subject &subject);
[[nodiscard]] std::vector<std::uint8_t> freeTexCoords(const Subject &subject);
[[nodiscard]] std::optional<std::uint8_t> freeUnit(const Subject &subject);

/// Returns "program.local[3]".
[[nodiscard]] std::string localText(std::uint8_t index);
/// Returns "fragment.texcoord[3]".
[[nodiscard]] std::string texCoordText(std::uint8_t index);

} // namespace arbiter::tools::advise
