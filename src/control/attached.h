#pragma once
#include <cstdint>
#include <span>

#include "control/address.h"

/// Bytes that are too many for a line. They travel beside it, as the descriptor of memory.
namespace arbiter::control {

/// Returns memory with these bytes, at its begin for readers; an empty descriptor if there is none.
/// \param flags of memfd_create()
[[nodiscard]] Descriptor memoryOf(std::span<const std::uint8_t> bytes, unsigned flags);
/// Reads the bytes of memory. Returns false unless it has exactly as many.
[[nodiscard]] bool readMemory(const Descriptor &memory, std::span<std::uint8_t> bytes);

} // namespace arbiter::control
