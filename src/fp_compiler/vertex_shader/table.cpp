// The table of operations of section 2.14.
#include <algorithm>
#include <iterator>
#include <string_view>

#include "fp_compiler/vertex_shader/shader.h"

namespace arbiter::fp::vertex_shader {

namespace {

/// A row of the table: the result's type letter, then those of the arguments.
struct Row {
  Op first, last; ///< range of operations with these types
  std::string_view types;
};

constexpr Row kRows[] = {
    {Op::Index, Op::Index, "SSS"},
    {Op::Index, Op::Index, "VSV"},
    {Op::Index, Op::Index, "MSM"},
    {Op::Negate, Op::Negate, "SS"},
    {Op::Negate, Op::Negate, "VS"},
    {Op::Negate, Op::Negate, "VV"},
    {Op::Dot3, Op::Dot4, "SVV"},
    {Op::Dot3, Op::Dot4, "VVV"},
    {Op::Mul, Op::Add, "SSS"},
    {Op::Mul, Op::Add, "VSS"},
    {Op::Mul, Op::Add, "VSV"},
    {Op::Mul, Op::Add, "VVS"},
    {Op::Mul, Op::Add, "VVV"},
    {Op::Madd, Op::Madd, "SSSS"},
    {Op::Madd, Op::Madd, "VSSS"},
    {Op::Madd, Op::Madd, "VSVV"},
    {Op::Madd, Op::Madd, "VVSV"},
    {Op::Madd, Op::Madd, "VSSV"},
    {Op::Madd, Op::Madd, "VVVS"},
    {Op::Madd, Op::Madd, "VVSS"},
    {Op::Madd, Op::Madd, "VSVS"},
    {Op::Madd, Op::Madd, "VVVV"},
    {Op::Frac, Op::Frac, "SS"},
    {Op::Frac, Op::Frac, "VS"},
    {Op::Frac, Op::Frac, "VV"},
    {Op::Max, Op::SetLt, "SSS"},
    {Op::Max, Op::SetLt, "VSS"},
    {Op::Max, Op::SetLt, "VSV"},
    {Op::Max, Op::SetLt, "VVS"},
    {Op::Max, Op::SetLt, "VVV"},
    {Op::Clamp, Op::Clamp, "SSSS"},
    {Op::Clamp, Op::Clamp, "VSSS"},
    {Op::Clamp, Op::Clamp, "VVSS"},
    {Op::Clamp, Op::Clamp, "VVVS"},
    {Op::Clamp, Op::Clamp, "VVSV"},
    {Op::Clamp, Op::Clamp, "VVVV"},
    {Op::Floor, Op::Round, "SS"},
    {Op::Floor, Op::Round, "VS"},
    {Op::Floor, Op::Round, "VV"},
    {Op::ExpBase2, Op::LogBase2, "SS"},
    {Op::Power, Op::Power, "SSS"},
    {Op::Recip, Op::RecipSqrt, "SS"},
    {Op::Sub, Op::Sub, "SSS"},
    {Op::Sub, Op::Sub, "VSS"},
    {Op::Sub, Op::Sub, "VSV"},
    {Op::Sub, Op::Sub, "VVS"},
    {Op::Sub, Op::Sub, "VVV"},
    {Op::CrossProduct, Op::CrossProduct, "VVV"},
    {Op::MultiplyMatrix, Op::MultiplyMatrix, "VMV"},
    {Op::Mov, Op::Mov, "SS"},
    {Op::Mov, Op::Mov, "VS"},
    {Op::Mov, Op::Mov, "VV"},
};

bool concerns(const Row &row, Op op) { return row.first <= op && op <= row.last; }

constexpr char letter(DataType type) { return "SVM"[std::size_t(type)]; }

} // namespace

int argumentCount(Op op) {
  const auto *const row = std::find_if(std::begin(kRows), std::end(kRows),
                                       [&](const Row &each) { return concerns(each, op); });
  return row == std::end(kRows) ? 1 : int(row->types.size()) - 1;
}

bool isInTable(Op op, DataType result, const DataType *arguments) {
  return std::any_of(std::begin(kRows), std::end(kRows), [&](const Row &row) {
    return concerns(row, op) && row.types[0] == letter(result) &&
           std::equal(row.types.begin() + 1, row.types.end(), arguments,
                      [](char wanted, DataType type) { return wanted == letter(type); });
  });
}

DataType typeOf(const Result &result, const std::vector<Symbol> &symbols) {
  if (result.place == Place::Local)
    return symbols[result.index].type;
  return result.place == Place::Fog ? DataType::Scalar : DataType::Vector;
}

} // namespace arbiter::fp::vertex_shader
