#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fp_compiler/abi.h"

/// What crosses the boundary of libarbiter_jit.so, and nothing else does: numbers, pointers to
/// plain structures that the caller owns, bytes that are borrowed for a call, and handles of
/// objects that the library made and alone frees. No C++ type that allocates, no virtual function,
/// no exception: the layer and the library need not have the same operator new, delete or C++
/// library, and an application that replaces any of them is not met by what the other side made.
///
/// Every function may be called from any thread. None throws: where memory or anything else is
/// missing the result is null, and a Reason is filled where one is taken.
///
/// Both sides know more of each other than that: how keys and draws lie in memory (abi.h), how
/// programs are written as archives. So the version that they compare, kVersion of the generated
/// fp_compiler/jit_version.h, is a hash of this header, of jit_fields.h and of all that they
/// include.
namespace arbiter::fp::jit::boundary {

/// Of the library, freed by it.
struct EngineHandle;
struct FragmentHandle;
struct VertexHandle;
struct CodeHandle;
struct BytesHandle;

/// Borrowed: the callee reads it before returning. `data` may be null where `size` is 0.
struct Bytes {
  const char *data;
  std::size_t size;
};

/// Why a result is null; NUL-terminated, cut where it is longer.
struct Reason {
  char text[512];
};

struct Options {
  Bytes cpu;         ///< EngineOptions::cpu
  Bytes cacheFolder; ///< of object code; empty: none
  std::uint64_t cacheMaxBytes;
};

/// What does not change during an engine's life.
struct Description {
  std::int32_t lanes, blockWidth, blockHeight;
  char target[128]; ///< NUL-terminated
};

/// Machine code as the rasterizer calls it. `function` is an abi::ShadeFunction or an
/// abi::VertexFunction and lives as long as `handle`, which is null where there is none.
struct Code {
  CodeHandle *handle;
  void (*function)();
  std::size_t bytes;
};

/// Programs cross as archives of ir::Program (ir/fields.h); what a prepared one needs of a draw and
/// what it is after the passes come back as an archive of its shape and its program.
struct Interface {
  std::uint64_t version; ///< boundary::kVersion; compared before anything else is looked at

  EngineHandle *(*makeEngine)(const Options *options, Reason *reason);
  void (*freeEngine)(EngineHandle *engine);
  void (*describe)(const EngineHandle *engine, Description *description);

  FragmentHandle *(*prepareFragment)(EngineHandle *engine, Bytes program, std::uint8_t numerics);
  void (*freeFragment)(FragmentHandle *fragment);
  BytesHandle *(*fragmentBytes)(const FragmentHandle *fragment);
  void (*compileFragment)(EngineHandle *engine, const FragmentHandle *fragment,
                          const abi::FragmentKey *key, Code *code, Reason *reason);
  BytesHandle *(*listFragment)(EngineHandle *engine, const FragmentHandle *fragment,
                               const abi::FragmentKey *key, std::uint8_t listing, Reason *reason);

  VertexHandle *(*prepareVertex)(EngineHandle *engine, Bytes program, std::uint8_t numerics);
  void (*freeVertex)(VertexHandle *vertex);
  BytesHandle *(*vertexBytes)(const VertexHandle *vertex);
  void (*compileVertex)(EngineHandle *engine, const VertexHandle *vertex, const abi::VertexKey *key,
                        Code *code, Reason *reason);
  BytesHandle *(*listVertex)(EngineHandle *engine, const VertexHandle *vertex,
                             const abi::VertexKey *key, std::uint8_t listing, Reason *reason);

  void (*freeCode)(CodeHandle *code);
  Bytes (*view)(const BytesHandle *bytes); ///< valid until freeBytes()
  void (*freeBytes)(BytesHandle *bytes);
};

/// What the library exports, under this name.
using GetInterface = const Interface *(*)();
inline constexpr const char *kSymbol = "arbiter_jit_interface";

// --- The rule above, as the compiler reads it: a new function or member that breaks it does not
// build.
namespace detail {
template <typename T> constexpr bool mayCross() {
  if constexpr (std::is_pointer_v<T>)
    return true; // to what: see PlainFunction and the structures' own checks
  else if constexpr (std::is_class_v<T>)
    return std::is_trivial_v<T> && std::is_standard_layout_v<T>;
  else
    return std::is_arithmetic_v<T> || std::is_void_v<T>;
}
/// A pointer's target is a handle, which only its maker can look into, or plain itself.
template <typename T> constexpr bool targetMayCross() {
  using Target = std::remove_cv_t<std::remove_pointer_t<T>>;
  if constexpr (!std::is_pointer_v<T>)
    return true;
  else if constexpr (std::is_same_v<Target, EngineHandle> ||
                     std::is_same_v<Target, FragmentHandle> ||
                     std::is_same_v<Target, VertexHandle> || std::is_same_v<Target, CodeHandle> ||
                     std::is_same_v<Target, BytesHandle>)
    return true;
  else
    return std::is_trivially_copyable_v<Target> && std::is_standard_layout_v<Target>;
}
template <typename Function> struct IsPlain : std::false_type {};
template <typename R, typename... As>
struct IsPlain<R (*)(As...)>
    : std::bool_constant<mayCross<R>() && targetMayCross<R>() &&
                         ((mayCross<As>() && targetMayCross<As>()) && ...)> {};
template <typename... Functions> constexpr bool allPlain(Functions Interface::*...) {
  return (IsPlain<Functions>::value && ...);
}
using I = Interface;
static_assert(allPlain(&I::makeEngine, &I::freeEngine, &I::describe, &I::prepareFragment,
                       &I::freeFragment, &I::fragmentBytes, &I::compileFragment, &I::listFragment,
                       &I::prepareVertex, &I::freeVertex, &I::vertexBytes, &I::compileVertex,
                       &I::listVertex, &I::freeCode, &I::view, &I::freeBytes));
static_assert(std::is_trivial_v<Interface> && std::is_standard_layout_v<Interface>);
static_assert(sizeof(Interface) == sizeof(std::uint64_t) + 16 * sizeof(void *),
              "every function is in the list above");
} // namespace detail

} // namespace arbiter::fp::jit::boundary
