#pragma once
#include <string>

#include <llvm/ADT/StringMap.h>
#include <llvm/Config/llvm-config.h>
#include <llvm/Support/Alignment.h>
#include <llvm/Support/CodeGen.h>
#include <llvm/Target/TargetOptions.h>
#if LLVM_VERSION_MAJOR >= 16
#include <llvm/TargetParser/Host.h>
#include <llvm/TargetParser/Triple.h>
#else
#include <llvm/ADT/Triple.h>
#include <llvm/Support/Host.h>
#endif

/// What the releases of LLVM, 15 and newer, spell differently, in one spelling. Nothing else of the
/// back end asks which release it is compiled for.
namespace arbiter::fp::llvm_back::release {

#if LLVM_VERSION_MAJOR >= 18
inline constexpr auto kUsualOptimisation = llvm::CodeGenOptLevel::Default;
inline constexpr auto kObjectFile = llvm::CodeGenFileType::ObjectFile;
inline constexpr auto kAssemblyFile = llvm::CodeGenFileType::AssemblyFile;
#else
inline constexpr auto kUsualOptimisation = llvm::CodeGenOpt::Default;
inline constexpr auto kObjectFile = llvm::CGFT_ObjectFile;
inline constexpr auto kAssemblyFile = llvm::CGFT_AssemblyFile;
#endif

/// The alignment of sections, as the linker's memory manager is told it.
#if LLVM_VERSION_MAJOR >= 16
using SectionAlignment = llvm::Align;
#else
using SectionAlignment = std::uint32_t;
#endif

/// What modules and targets take to be told of a processor and system.
#if LLVM_VERSION_MAJOR >= 21
inline const llvm::Triple &nameOf(const llvm::Triple &triple) { return triple; }
#else
inline const std::string &nameOf(const llvm::Triple &triple) { return triple.str(); }
#endif

/// This processor's features by name, each with whether programs may use it; none if it is unknown.
inline llvm::StringMap<bool> hostFeatures() {
#if LLVM_VERSION_MAJOR >= 19
  return llvm::sys::getHostCPUFeatures();
#else
  llvm::StringMap<bool> features;
  if (!llvm::sys::getHostCPUFeatures(features))
    features.clear();
  return features;
#endif
}

/// Denormal numbers are zeros to the code generator, as the functions' attribute says too: from 22
/// on the attribute alone.
inline void flushDenormals([[maybe_unused]] llvm::TargetOptions &options) {
#if LLVM_VERSION_MAJOR < 22
  options.setFPDenormalMode(llvm::DenormalMode::getPreserveSign());
#endif
}

} // namespace arbiter::fp::llvm_back::release
