#include "util/processor.h"

#include <algorithm>

#include "util/flags.h"

namespace arbiter {

namespace {
Vectors ofProcessor() {
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("popcnt") && __builtin_cpu_supports("avx2") &&
      __builtin_cpu_supports("fma"))
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? Vectors::Avx512
                                                                                   : Vectors::Avx2;
#endif
  return Vectors::Least;
}

Vectors ofSetting() {
  const std::string &cpu = settings().cpu;
  return cpu == "sse4.1" ? Vectors::Least : cpu == "avx2" ? Vectors::Avx2 : Vectors::Avx512;
}
} // namespace

Vectors vectors() {
  static const Vectors s_vectors = std::min(ofProcessor(), ofSetting());
  return s_vectors;
}

} // namespace arbiter
