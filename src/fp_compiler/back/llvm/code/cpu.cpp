#include "fp_compiler/back/llvm/code/cpu.h"

#include <span>

#include <llvm/ADT/StringMap.h>

#include "fp_compiler/back/llvm/code/release.h"

namespace arbiter::fp::llvm_back {

namespace {
struct Row {
  Cpu::Family family;
  const char *name;
  /// An LLVM processor model with the family's features and few others. It is used to generate code
  /// for a lesser machine.
  const char *model;
  std::initializer_list<const char *> features;
};

#if defined(__x86_64__) || defined(__i386__)
const Row kFamilies[] = {
    {Cpu::Family::Avx512,
     "avx512",
     "skylake-avx512",
     {"avx512f", "avx512bw", "avx512dq", "avx512vl", "avx2", "fma", "f16c", "bmi2"}},
    {Cpu::Family::Avx2, "avx2", "haswell", {"avx2", "fma", "f16c", "bmi2"}},
    {Cpu::Family::Sse41, "sse4.1", "nehalem", {"sse4.1", "ssse3", "popcnt"}},
};
#elif defined(__aarch64__)
const Row kFamilies[] = {{Cpu::Family::Neon, "neon", "generic", {"neon"}}};
#else
const std::span<const Row> kFamilies;
#endif

/// Returns the features that the operating system lets programs use.
llvm::StringMap<bool> hostFeatures() {
  llvm::StringMap<bool> features = release::hostFeatures();
#if defined(__aarch64__)
  features["neon"] = true; // every processor of the architecture with an FPU has it
#endif
  return features;
}

/// Returns the processor name, on which instruction costs depend. Virtual machines invent one, so
/// that LLVM may mistake a Sapphire Rapids for a desktop processor. The features are correct.
std::string hostName(const llvm::StringMap<bool> &features) {
  return features.lookup("avx512fp16") ? "sapphirerapids" : llvm::sys::getHostCPUName().str();
}

bool hasAll(const llvm::StringMap<bool> &features, const Row &row) {
  for (const char *const name : row.features)
    if (!features.lookup(name))
      return false;
  return true;
}

std::string everyFeature(const llvm::StringMap<bool> &features) {
  std::vector<std::string> names;
  for (const auto &feature : features)
    names.push_back((feature.second ? "+" : "-") + feature.first().str());
  std::sort(names.begin(), names.end());
  std::string joined;
  for (const std::string &name : names)
    joined += (joined.empty() ? "" : ",") + name;
  return joined;
}
} // namespace

std::optional<Cpu> chooseCpu(const std::string &name) {
  const llvm::StringMap<bool> features = hostFeatures();
  for (const Row &row : kFamilies) {
    if ((!name.empty() && name != row.name) || !hasAll(features, row))
      continue;
    Cpu cpu;
    cpu.family = row.family;
    // For a lesser machine, the model's own features apply.
    cpu.name = name.empty() ? hostName(features) : row.model;
    if (name.empty())
      cpu.features = everyFeature(features);
    return cpu;
  }
  return std::nullopt;
}

const char *familyName(Cpu::Family family) {
  for (const Row &row : kFamilies)
    if (row.family == family)
      return row.name;
  return "";
}

} // namespace arbiter::fp::llvm_back
