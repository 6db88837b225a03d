#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/interface.h"

/// A shader of EXT_vertex_shader as data: its symbols, and its operations in order. Section 2.14 of
/// the extension defines it. lower.h turns it into IR, and evaluate.h executes it by the letter of
/// the specification. Nothing here checks the rules of the API; the code that builds a shader does.
namespace arbiter::fp::vertex_shader {

enum class DataType : std::uint8_t { Scalar, Vector, Matrix };

/// The source of a symbol's value.
enum class From : std::uint8_t {
  Local,     ///< written by the shader; initially zero
  Constant,  ///< Symbol::constant
  Invariant, ///< set by the application: env parameters of the program
  Attribute, ///< vertex attribute
  State,     ///< rows of GL state
};

/// A symbol from GenSymbolsEXT or from one of the Bind...ParameterEXT.
struct Symbol {
  DataType type = DataType::Vector;
  From from = From::Local;
  /// Attribute: one for a scalar or a vector. A matrix has four, which are its columns. A scalar is
  /// the x component.
  std::array<ir::Attribute, 4> attributes = {};
  bool clampsAttributes = false; ///< NORMALIZED_RANGE: a vertex array may exceed [-1, 1]
  bool isDirection = false;      ///< Attribute, State: the fourth component is 0 (2.14)
  ir::StateRef state;            ///< State: for a matrix, the first row
  std::uint8_t component = 0;    ///< State: component of a scalar
  /// Constant: a scalar in x, a vector, or the rows of a matrix.
  std::array<ir::Vec4, 4> constant = {};
  /// The block of symbols that GenSymbolsEXT made it with, in Shader::symbols.
  std::uint32_t blockFirst = 0, blockCount = 1;
};

/// Returns the number of rows in a type's value: one for scalars and vectors, four for matrices.
[[nodiscard]] constexpr int rowCount(DataType type) { return type == DataType::Matrix ? 4 : 1; }

enum class Op : std::uint8_t {
  // These follow the order of the enumerants from OP_INDEX_EXT on.
  Index,
  Negate,
  Dot3,
  Dot4,
  Mul,
  Add,
  Madd,
  Frac,
  Max,
  Min,
  SetGe,
  SetLt,
  Clamp,
  Floor,
  Round,
  ExpBase2,
  LogBase2,
  Power,
  Recip,
  RecipSqrt,
  Sub,
  CrossProduct,
  MultiplyMatrix,
  Mov,
  // These have commands of their own.
  Swizzle,
  WriteMask,
  InsertComponent,
  ExtractComponent,
};
inline constexpr int kShaderOps = int(Op::Mov) + 1; ///< number of operations of ShaderOp commands

/// Returns the number of arguments of a ShaderOp operation.
[[nodiscard]] int argumentCount(Op op);

/// True if the table of operations allows these result and argument types.
/// \param arguments argumentCount(op) types
[[nodiscard]] bool isInTable(Op op, DataType result, const DataType *arguments);

/// The kind of register that an operation writes.
enum class Place : std::uint8_t { Local, Position, Color, TexCoord, Fog };
struct Result {
  Place place = Place::Local;
  std::uint32_t index = 0; ///< Local: symbol; Color: 0 or 1; TexCoord: coordinate set
};
/// Returns the type of a result. Fog is a scalar; the other outputs are vectors.
[[nodiscard]] DataType typeOf(const Result &result, const std::vector<Symbol> &symbols);

/// Component selectors of Swizzle: the enumerants from X_EXT on.
enum class Take : std::uint8_t { X, Y, Z, W, NegX, NegY, NegZ, NegW, Zero, One, NegOne };

struct Operation {
  Op op = Op::Mov;
  Result result;
  std::array<std::uint32_t, 3> arguments = {}; ///< indices into Shader::symbols
  std::array<Take, 4> takes = {};              ///< Swizzle
  std::uint8_t mask = 0xF;                     ///< WriteMask: bit 0 = x
  std::uint8_t component =
      0; ///< InsertComponent, ExtractComponent: of a vector, or a row of a matrix
};

struct Shader {
  std::vector<Symbol> symbols;
  std::vector<Operation> code;
};

} // namespace arbiter::fp::vertex_shader
