#include "apps/tools/advise/rules/rules.h"

namespace arbiter::tools::advise {

namespace {

constexpr Rule kRules[] = {
    {"constant-work", "arithmetic on numbers alone", constantWork},
    {"constant-chain", "numbers that two instructions in a row bring in", constantChain},
    {"parameter-work", "work on parameters alone, the same for every pixel", parameterWork},
    {"linear-work", "work that is linear in texture coordinates", linearWork},
    {"component-order", "swizzles that the card copies for", operandOrder},
    {"swizzles-by-one-copy", "one register in several orders", arrangements},
    {"table-of-one-value", "a function of one value", tableOfOne},
    {"unit-vector-cube-map", "DP3, RSQ, MUL of one vector", cubeMap},
    {"clamp-by-sat", "MAX and MIN that clamp to [0,1]", clamps},
    {"sine-and-cosine", "SIN and COS of one angle", sineAndCosine},
    {"select-by-cmp", "comparisons that something is only chosen by", selects},
    {"opposite-comparison", "1 minus a comparison", complements},
    {"power-by-products", "POW with a small number as exponent", powers},
    {"sum-by-dot-product", "sums of one register's components", dotProducts},
    {"scalars-to-vector", "the same operations twice, each on one component", scalarPairs},
    {"repeated-work", "the same operation on the same operands", repeats},
    {"needless-copy", "MOV whose source could be read, or its destination written", copies},
    {"dead-work", "work that nothing reads", deadWork},
    {"multiply-add", "MUL whose result is added to something", multiplyAdd},
    {"homogeneous-dot-product", "DP3 and a w that is added", homogeneousProducts},
    {"linear-blend", "LRP as differences and products", blends},
    {"operand-without-effect", "operands that change nothing", identities},
    {"sample-earlier", "samples that begin a node without need", earlySamples},
    {"kil-place", "KIL that begins a node without need", killPlaces},
};

} // namespace

std::span<const Rule> rules() { return kRules; }

} // namespace arbiter::tools::advise
