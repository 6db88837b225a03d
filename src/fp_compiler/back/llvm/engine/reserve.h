#pragma once
#include <cstddef>

/// Memory for when there is none: LLVM is written for a process that ends then. Much of it may not
/// be left by an exception (destructors, moves, functions of C), so it must rather be let finish.
/// What this library allocates and cannot get from the process comes from here: 16 MiB that are
/// mapped with the library and take no memory until they are written to. Only when they run out too
/// is an allocation of LLVM's refused (failures.h).
///
/// Safe on several threads. Blocks are of powers of two, kept by size when they are given back, and
/// all is as at first when the last one is.
namespace arbiter::fp::llvm_back::reserve {

/// \param alignment in bytes, a power of two \return null where too little is left
[[nodiscard]] void *allocate(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t));
[[nodiscard]] bool has(const void *block);
void release(void *block);
/// How many bytes can be read from where `block` begins, at least as many as were asked for.
[[nodiscard]] std::size_t sizeOf(const void *block);

/// So much of it is in use that a compilation should not be begun.
[[nodiscard]] bool isLow();

} // namespace arbiter::fp::llvm_back::reserve
