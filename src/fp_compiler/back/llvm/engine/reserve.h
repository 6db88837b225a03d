#pragma once
#include <cstddef>

/// Reserve memory for out-of-memory situations, in which LLVM would end the process. Much of LLVM's
/// code cannot be left by an exception (destructors, moves, C functions), so it must be able to
/// finish. Allocations that the process cannot satisfy come from here. The reserve has 16 MiB,
/// which are mapped with the library and take no memory until used. LLVM's allocations fail only
/// when the reserve is exhausted too (failures.h).
///
/// Thread-safe. Block sizes are powers of two, with a free list for each size. When the last block
/// is freed, the initial state is restored.
namespace arbiter::fp::llvm_back::reserve {

/// \param alignment in bytes, a power of two
/// \return null if too little is left
[[nodiscard]] void *allocate(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t));
[[nodiscard]] bool has(const void *block);
void release(void *block);
/// Returns how many bytes of `block` are readable, at least as many as were requested.
[[nodiscard]] std::size_t sizeOf(const void *block);

/// True if so much is in use that no new compilation should start.
[[nodiscard]] bool isLow();

} // namespace arbiter::fp::llvm_back::reserve
