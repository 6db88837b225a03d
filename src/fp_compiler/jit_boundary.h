#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fp_compiler/abi.h"

/// Everything that crosses the boundary of libarbiter_jit.so: numbers, pointers to plain structures
/// of the caller, bytes borrowed for a call, and handles of objects that the library makes and
/// frees. C++ types that allocate, virtual functions and exceptions do not cross. So the layer and
/// the library may have different operators new and delete, and different C++ libraries. An
/// application that replaces them never gets an object of the other side.
///
/// Any thread may call any function. No function throws. If memory or anything else is missing, the
/// result is null, and the Reason, if the function takes one, is filled.
///
/// Both sides also share the memory layout of keys and draws (abi.h) and the archive format of
/// programs. So they compare a version: kVersion of the generated fp_compiler/jit_version.h. It is
/// a hash of this header, of jit_fields.h and of all headers that they include.
namespace arbiter::fp::jit::boundary {

/// Handles of the library's objects. The library frees them.
struct EngineHandle;
struct FragmentHandle;
struct VertexHandle;
struct CodeHandle;
struct BytesHandle;

/// Bytes that the callee reads before it returns. `data` may be null if `size` is 0.
struct Bytes {
  const char *data;
  std::size_t size;
};

/// The reason for a null result; NUL-terminated, and cut if it is too long.
struct Reason {
  char text[512];
};

struct Options {
  Bytes cpu;         ///< EngineOptions::cpu
  Bytes cacheFolder; ///< for object code; empty: none
  std::uint64_t cacheMaxBytes;
};

/// Properties that stay the same during an engine's life.
struct Description {
  std::int32_t lanes, blockWidth, blockHeight;
  char target[128]; ///< NUL-terminated
};

/// Machine code for the rasterizer. `function` is an abi::ShadeFunction or an abi::VertexFunction.
/// It is valid as long as `handle`, which is null if there is no code.
struct Code {
  CodeHandle *handle;
  void (*function)();
  std::size_t bytes;
};

/// The functions of the library. Programs are passed as archives of ir::Program (ir/fields.h). A
/// prepared program is returned as an archive of its shape and of its IR after the passes.
struct Interface {
  std::uint64_t version; ///< boundary::kVersion; compared before anything else is read

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

/// The function that the library exports under this name.
using GetInterface = const Interface *(*)();
inline constexpr const char *kSymbol = "arbiter_jit_interface";

// --- Compile-time checks of the rule above: a function or member that breaks it does not build.
namespace detail {
template <typename T> constexpr bool mayCross() {
  if constexpr (std::is_pointer_v<T>)
    return true; // PlainFunction and the structures' own checks cover the target
  else if constexpr (std::is_class_v<T>)
    return std::is_trivial_v<T> && std::is_standard_layout_v<T>;
  else
    return std::is_arithmetic_v<T> || std::is_void_v<T>;
}
/// True if the pointer's target is a plain type, or a handle that only its maker can read.
template <typename T> constexpr bool targetMayCross() {
  using Target = std::remove_cv_t<std::remove_pointer_t<T>>;
  if constexpr (!std::is_pointer_v<T> || std::is_same_v<Target, EngineHandle> ||
                std::is_same_v<Target, FragmentHandle> || std::is_same_v<Target, VertexHandle> ||
                std::is_same_v<Target, CodeHandle> || std::is_same_v<Target, BytesHandle>)
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
