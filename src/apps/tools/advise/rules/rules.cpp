#include "apps/tools/advise/rules/rules.h"

namespace arbiter::tools::advise {

namespace {

constexpr Rule kRules[] = {
    {"constant_work", "arithmetic on numbers alone", constantWork},
    {"constant_chain", "numbers that two instructions in a row bring in", constantChain},
    {"parameter_work", "work on parameters alone, the same for every pixel", parameterWork},
    {"linear_work", "work that is linear in texture coordinates", linearWork},
    {"component_order", "swizzles that the card copies for", operandOrder},
    {"swizzles_by_one_copy", "one register in several orders", arrangements},
    {"table_of_one_value", "a function of one value", tableOfOne},
    {"unit_vector_cube_map", "DP3, RSQ, MUL of one vector", cubeMap},
    {"clamp_by_sat", "MAX and MIN that clamp to [0,1]", clamps},
    {"sine_and_cosine", "SIN and COS of one angle", sineAndCosine},
    {"select_by_cmp", "comparisons that something is only chosen by", selects},
    {"opposite_comparison", "1 minus a comparison", complements},
    {"power_by_products", "POW with a small number as exponent", powers},
    {"sum_by_dot_product", "sums of one register's components", dotProducts},
    {"scalars_to_vector", "the same operations twice, each on one component", scalarPairs},
    {"repeated_work", "the same operation on the same operands", repeats},
    {"needless_copy", "MOV whose source could be read, or its destination written", copies},
    {"dead_work", "work that nothing reads", deadWork},
    {"multiply_add", "MUL whose result is added to something", multiplyAdd},
    {"homogeneous_dot_product", "DP3 and a w that is added", homogeneousProducts},
    {"linear_blend", "LRP as differences and products", blends},
    {"operand_without_effect", "operands that change nothing", identities},
    {"sample_earlier", "samples that begin a node without need", earlySamples},
    {"kil_place", "KIL that begins a node without need", killPlaces},
};

} // namespace

std::span<const Rule> rules() { return kRules; }

} // namespace arbiter::tools::advise
