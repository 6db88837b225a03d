#pragma once
#include "swrast/cover/packed.h"

/// Chooses the kernel that tests a draw's depth. Included in the kernels' sources. Its template
/// arguments are types of unnamed namespaces, so that no two instruction sets share a function.
namespace arbiter::swrast {

/// \tparam Kernels has a function `test<layout, compare>` for each test
template <typename Kernels, abi::Layout kLayout> TestBlocks testOf(abi::Compare compare) {
  using abi::Compare;
  static constexpr TestBlocks kAll[] = {Kernels::template test<kLayout, Compare::Never>,
                                        Kernels::template test<kLayout, Compare::Less>,
                                        Kernels::template test<kLayout, Compare::Equal>,
                                        Kernels::template test<kLayout, Compare::LessEqual>,
                                        Kernels::template test<kLayout, Compare::Greater>,
                                        Kernels::template test<kLayout, Compare::NotEqual>,
                                        Kernels::template test<kLayout, Compare::GreaterEqual>,
                                        Kernels::template test<kLayout, Compare::Always>};
  return kAll[int(compare)];
}

template <typename Kernels> TestBlocks chooseTest(const DepthTest &test) {
  using abi::Layout;
  switch (test.layout) {
  case Layout::Depth16:
    return testOf<Kernels, Layout::Depth16>(test.compare);
  case Layout::Depth24Stencil8:
    return testOf<Kernels, Layout::Depth24Stencil8>(test.compare);
  case Layout::Depth32F:
    return testOf<Kernels, Layout::Depth32F>(test.compare);
  case Layout::Depth32:
    return testOf<Kernels, Layout::Depth32>(test.compare);
  default:
    return Kernels::template test<Layout::None, abi::Compare::Always>;
  }
}

} // namespace arbiter::swrast
