#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// The words of `#@` lines, as tables (words.def).
namespace arbiter::scene {

enum class Setting : std::uint8_t {
#define PANEL_SETTING(name, ...) name,
#include "apps/scene/words.def"
};
enum class Generator : std::uint8_t {
#define PANEL_GENERATOR(name, ...) name,
#include "apps/scene/words.def"
};
enum class Shape : std::uint8_t {
#define PANEL_SHAPE(name, ...) name,
#include "apps/scene/words.def"
};
enum class CameraKind : std::uint8_t {
#define PANEL_CAMERA(name, ...) name,
#include "apps/scene/words.def"
};
enum class AnimationKind : std::uint8_t {
#define PANEL_ANIMATION(name, ...) name,
#include "apps/scene/words.def"
};
enum class ValueKind : std::uint8_t {
#define PANEL_VALUE(name, ...) name,
#include "apps/scene/words.def"
};
enum class Blend : std::uint8_t {
#define PANEL_BLEND(name, ...) name,
#include "apps/scene/words.def"
};
enum class Depth : std::uint8_t {
#define PANEL_DEPTH(name, ...) name,
#include "apps/scene/words.def"
};
enum class Cull : std::uint8_t {
#define PANEL_CULL(name, ...) name,
#include "apps/scene/words.def"
};
enum class Stencil : std::uint8_t {
#define PANEL_STENCIL(name, ...) name,
#include "apps/scene/words.def"
};
enum class Filter : std::uint8_t {
#define PANEL_FILTER(name, ...) name,
#include "apps/scene/words.def"
};
enum class Wrap : std::uint8_t {
#define PANEL_WRAP(name, ...) name,
#include "apps/scene/words.def"
};
enum class Coordinate : std::uint8_t {
#define PANEL_COORDINATE(name, ...) name,
#include "apps/scene/words.def"
};

/// True if the source is a cube map of six images.
[[nodiscard]] constexpr bool isCube(Generator generator) {
  return generator == Generator::Normalize || generator == Generator::Sky ||
         generator == Generator::Cube;
}

/// An argument of a word: a number that is written with its name.
struct ArgumentRow {
  std::string_view word;
  double fallback = 0, low = 0, high = 0;
};
inline constexpr std::size_t kMaxArguments = 9;

struct WordRow {
  std::string_view word; ///< empty: the value (a file's name, numbers) stands without a word
  std::string_view meaning;
  std::array<ArgumentRow, kMaxArguments> rows = {};
  std::string_view form = {}; ///< of a setting: what follows it

  [[nodiscard]] std::span<const ArgumentRow> arguments() const {
    std::size_t count = 0;
    while (count < rows.size() && !rows[count].word.empty())
      ++count;
    return std::span(rows).first(count);
  }
};

/// Returns the rows of one kind of word, in the order of its enumerators.
template <typename Enum> [[nodiscard]] std::span<const WordRow> wordsOf();
template <> std::span<const WordRow> wordsOf<Setting>();
template <> std::span<const WordRow> wordsOf<Generator>();
template <> std::span<const WordRow> wordsOf<Shape>();
template <> std::span<const WordRow> wordsOf<CameraKind>();
template <> std::span<const WordRow> wordsOf<AnimationKind>();
template <> std::span<const WordRow> wordsOf<ValueKind>();
template <> std::span<const WordRow> wordsOf<Blend>();
template <> std::span<const WordRow> wordsOf<Depth>();
template <> std::span<const WordRow> wordsOf<Cull>();
template <> std::span<const WordRow> wordsOf<Stencil>();
template <> std::span<const WordRow> wordsOf<Filter>();
template <> std::span<const WordRow> wordsOf<Wrap>();
template <> std::span<const WordRow> wordsOf<Coordinate>();

template <typename Enum> [[nodiscard]] const WordRow &rowOf(Enum value) {
  return wordsOf<Enum>()[std::size_t(value)];
}

/// Returns the word's place in a table, if it is there.
[[nodiscard]] std::optional<std::size_t> findWord(std::span<const WordRow> rows,
                                                  std::string_view word);
template <typename Enum> [[nodiscard]] std::optional<Enum> findWord(std::string_view word) {
  const auto found = findWord(wordsOf<Enum>(), word);
  return found ? std::optional(Enum(*found)) : std::nullopt;
}

} // namespace arbiter::scene
