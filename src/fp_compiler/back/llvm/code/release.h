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

/// Hides the API differences between LLVM releases, from 15 on. No other file of the back end
/// depends on the release.
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

/// The type of a section's alignment in the linker's memory manager.
#if LLVM_VERSION_MAJOR >= 16
using SectionAlignment = llvm::Align;
#else
using SectionAlignment = std::uint32_t;
#endif

/// Returns the form of a target triple that modules and targets take.
#if LLVM_VERSION_MAJOR >= 21
inline const llvm::Triple &nameOf(const llvm::Triple &triple) { return triple; }
#else
inline const std::string &nameOf(const llvm::Triple &triple) { return triple.str(); }
#endif

/// Returns this processor's features by name, and whether programs may use each. Empty if unknown.
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

/// Tells the code generator to treat denormals as zeros. The functions' attribute says the same,
/// and from LLVM 22 on it is enough.
inline void flushDenormals([[maybe_unused]] llvm::TargetOptions &options) {
#if LLVM_VERSION_MAJOR < 22
  options.setFPDenormalMode(llvm::DenormalMode::getPreserveSign());
#endif
}

} // namespace arbiter::fp::llvm_back::release
