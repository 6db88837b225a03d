#include "apps/scene/words.h"

namespace arbiter::scene {

namespace {

#define ARGUMENT(word, fallback, low, high)                                                        \
  ArgumentRow { word, fallback, low, high }

constexpr WordRow kSettings[] = {
#define PANEL_SETTING(name, word, form, meaning) {word, meaning, {}, form},
#include "apps/scene/words.def"
};
constexpr WordRow kGenerators[] = {
#define PANEL_GENERATOR(name, word, meaning, ...) {word, meaning, {__VA_ARGS__}},
#include "apps/scene/words.def"
};
constexpr WordRow kShapes[] = {
#define PANEL_SHAPE(name, word, meaning, ...) {word, meaning, {__VA_ARGS__}},
#include "apps/scene/words.def"
};
constexpr WordRow kCameras[] = {
#define PANEL_CAMERA(name, word, meaning, ...) {word, meaning, {__VA_ARGS__}},
#include "apps/scene/words.def"
};
constexpr WordRow kValues[] = {
#define PANEL_VALUE(name, word, meaning, ...) {word, meaning, {__VA_ARGS__}},
#include "apps/scene/words.def"
};
constexpr WordRow kAnimations[] = {
#define PANEL_ANIMATION(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kBlends[] = {
#define PANEL_BLEND(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kDepths[] = {
#define PANEL_DEPTH(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kCulls[] = {
#define PANEL_CULL(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kStencils[] = {
#define PANEL_STENCIL(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kFilters[] = {
#define PANEL_FILTER(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kWraps[] = {
#define PANEL_WRAP(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};
constexpr WordRow kCoordinates[] = {
#define PANEL_COORDINATE(name, word, meaning) {word, meaning},
#include "apps/scene/words.def"
};

} // namespace

template <> std::span<const WordRow> wordsOf<Setting>() { return kSettings; }
template <> std::span<const WordRow> wordsOf<Generator>() { return kGenerators; }
template <> std::span<const WordRow> wordsOf<Shape>() { return kShapes; }
template <> std::span<const WordRow> wordsOf<CameraKind>() { return kCameras; }
template <> std::span<const WordRow> wordsOf<AnimationKind>() { return kAnimations; }
template <> std::span<const WordRow> wordsOf<ValueKind>() { return kValues; }
template <> std::span<const WordRow> wordsOf<Blend>() { return kBlends; }
template <> std::span<const WordRow> wordsOf<Depth>() { return kDepths; }
template <> std::span<const WordRow> wordsOf<Cull>() { return kCulls; }
template <> std::span<const WordRow> wordsOf<Stencil>() { return kStencils; }
template <> std::span<const WordRow> wordsOf<Filter>() { return kFilters; }
template <> std::span<const WordRow> wordsOf<Wrap>() { return kWraps; }
template <> std::span<const WordRow> wordsOf<Coordinate>() { return kCoordinates; }

std::optional<std::size_t> findWord(std::span<const WordRow> rows, std::string_view word) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].word == word && !word.empty())
      return i;
  return std::nullopt;
}

} // namespace arbiter::scene
