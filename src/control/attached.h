#pragma once
#include <cstdint>
#include <span>

#include "control/address.h"

/// Bytes that are too many for a line. They travel beside it, as the descriptor of memory.
namespace arbiter::control {

/// Returns memory with these bytes, which a reader reads from its begin; an empty descriptor if
/// there is none.
[[nodiscard]] Descriptor memoryOf(std::span<const std::uint8_t> bytes);
/// Reads the bytes of memory. Returns false unless it has exactly as many.
[[nodiscard]] bool readMemory(const Descriptor &memory, std::span<std::uint8_t> bytes);

} // namespace arbiter::control
