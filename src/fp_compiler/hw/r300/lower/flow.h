#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/hw/r300/machine.h"

/// The compiler's internal form of a program: a flat list of operations on virtual registers. An
/// operation belongs to one half or to both, and the order is valid to execute. Each value is named
/// by the operation that writes it and a component. Operations whose components are read together
/// share a virtual register. A union-find groups them; a group is a web.
namespace arbiter::fp::hw::r300 {

using ItemId = std::uint32_t;
inline constexpr ItemId kNoItem = 0xFFFFFFFF;
/// Something that items write component by component, giving versions: a temporary or an output of
/// the program, or a fresh variable. They are numbered in that order.
using Variable = std::uint32_t;
inline constexpr Variable kNoVariable = 0xFFFFFFFF;

/// One component of a value that can be read.
struct Ref {
  enum class Kind : std::uint8_t {
    Literal, ///< `value`; `index` is the program's constant that it comes from, or kNone
    Row,     ///< a row of Flow::rows whose value is not known
    Item,
  };
  Kind kind = Kind::Literal;
  std::uint8_t component = 0;
  bool absolute = false; ///< applied before the sign; a literal's value includes both
  bool negate = false;
  std::uint32_t index = kNone;
  float value = 0.0f;
  bool operator==(const Ref &) const = default;
};
using Refs = std::array<Ref, 4>;

/// An argument of a half whose sources are virtual registers.
struct FlowArgument {
  enum class Bank : std::uint8_t { None, Row, Item };
  Bank bank = Bank::None;  ///< None: the select is a constant
  std::uint8_t select = 0; ///< RgbSelect or AlphaSelect
  bool absolute = false;
  bool negate = false;
  bool presubtracted = false;
  /// For a row, [0] is the row. For items, [i] is the item that result component i reads; alpha
  /// arguments use only [0].
  std::array<ItemId, 3> source = {kNoItem, kNoItem, kNoItem};
};

struct Item {
  enum class Kind : std::uint8_t { Interpolant, Texture, Rgb, Alpha, Both };
  Kind kind = Kind::Rgb;
  RgbOp rgb = RgbOp::None;
  AlphaOp alpha = AlphaOp::None;
  bool live = true;        ///< set by prune()
  bool replicated = false; ///< all components have the same value; those outside the mask are free
  std::uint8_t mask = 0;   ///< components of the virtual register that are written
  std::uint8_t outputMask = 0;
  std::uint8_t output = 0;
  bool depth = false, clamp = false;
  Modifier modifier = Modifier::One;
  Presubtract presubtract = Presubtract::None; ///< only for an item of one half
  Cause cause = Cause::Instruction;
  std::uint16_t origin = kNone;
  /// Arguments of the RGB half and of the alpha half. A texture's coordinate has x y z in
  /// rgbArguments[0] and w in alphaArguments[0].
  std::array<FlowArgument, 3> rgbArguments, alphaArguments;
  std::array<FlowArgument, 2> presubtracted; ///< sources 0 and 1 of the presubtract
  TexOp texture = TexOp::Load;
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
  std::uint16_t attribute = 0; ///< for an Interpolant
  /// The variable that each component is a version of. Within a web, all versions of a component
  /// belong to one variable, so the order of the list is valid for the web.
  std::array<Variable, 4> variables = {kNoVariable, kNoVariable, kNoVariable, kNoVariable};

  [[nodiscard]] bool isAlu() const { return kind >= Kind::Rgb; }
  /// Returns the components written. After prune() these are the live ones.
  [[nodiscard]] std::uint8_t written() const {
    return std::uint8_t(mask | outputMask | (depth ? 8 : 0));
  }
};

struct Row {
  Constant constant;
  std::uint8_t filled = 0xF; ///< used components of a Value row
  bool known = false;        ///< the value is constant.value
};

struct Flow {
  std::vector<Item> items;
  std::vector<Row> rows;
  std::vector<ItemId> parent;                     ///< the union-find of the webs, by item
  std::vector<std::array<Variable, 4>> variables; ///< by root of a web
  /// For the root of each web: how many of its items write each component, at most 255.
  std::vector<std::array<std::uint8_t, 4>> versions;

  [[nodiscard]] ItemId web(ItemId item) {
    while (parent[item] != item) {
      parent[item] = parent[parent[item]];
      item = parent[item];
    }
    return item;
  }
};

/// The component that component i of an RGB select reads; 4 for a constant.
inline constexpr std::uint8_t kTaps[11][3] = {{0, 1, 2}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2},
                                              {3, 3, 3}, {1, 2, 0}, {2, 0, 1}, {3, 2, 1},
                                              {4, 4, 4}, {4, 4, 4}, {4, 4, 4}};

[[nodiscard]] inline bool isDot(RgbOp op) { return op == RgbOp::Dp3 || op == RgbOp::Dp4; }

[[nodiscard]] inline int argumentsOf(RgbOp op) { return int(argumentCount(op)); }
[[nodiscard]] inline int argumentsOf(AlphaOp op, RgbOp beside) {
  return int(argumentCount(op, beside));
}

/// Returns the components of the result that an RGB argument is read for.
[[nodiscard]] inline std::uint8_t rgbComponents(const Item &item) {
  return isDot(item.rgb) || item.kind == Item::Kind::Texture ? 7 : std::uint8_t(item.written() & 7);
}

/// Calls visit(item, component) for each component of another item that \p item reads.
template <typename Visit> void forEachRead(const Item &item, Visit visit) {
  if (item.kind == Item::Kind::Interpolant)
    return;
  if (item.kind == Item::Kind::Texture) {
    for (std::uint8_t c = 0; c < 3; ++c)
      if (item.rgbArguments[0].source[c] != kNoItem)
        visit(item.rgbArguments[0].source[c], c);
    if (item.alphaArguments[0].source[0] != kNoItem)
      visit(item.alphaArguments[0].source[0], std::uint8_t(3));
    return;
  }
  const std::uint8_t components = rgbComponents(item);
  const auto rgb = [&](const FlowArgument &argument) {
    if (argument.bank == FlowArgument::Bank::Item)
      for (std::size_t c = 0; c < 3; ++c)
        if (components >> c & 1)
          visit(argument.source[c], kTaps[argument.select][c]);
  };
  const auto alpha = [&](const FlowArgument &argument) {
    if (argument.bank == FlowArgument::Bank::Item)
      visit(argument.source[0], argument.select);
  };
  bool presubtracted = false;
  for (int i = 0; i < argumentsOf(item.rgb); ++i) {
    const FlowArgument &argument = item.rgbArguments[std::size_t(i)];
    presubtracted |= argument.presubtracted;
    if (!argument.presubtracted)
      rgb(argument);
  }
  for (int i = 0; i < argumentsOf(item.alpha, item.rgb); ++i) {
    const FlowArgument &argument = item.alphaArguments[std::size_t(i)];
    presubtracted |= argument.presubtracted;
    if (!argument.presubtracted)
      alpha(argument);
  }
  if (presubtracted)
    for (const FlowArgument &argument : item.presubtracted)
      item.kind == Item::Kind::Alpha ? alpha(argument) : rgb(argument);
}

} // namespace arbiter::fp::hw::r300
