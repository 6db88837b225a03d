#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/scene/words.h"
#include "fp_compiler/diagnostic.h"

/// Parses the panel of a program text: its comment lines that begin with `#@`. Every number and
/// word has its place in the text, in bytes, so that it can be replaced without changing the rest.
namespace arbiter::scene {

struct Number {
  double value = 0;
  fp::Span span; ///< empty: a default that is not written

  [[nodiscard]] bool written() const { return span.end > span.begin; }
};

struct Name {
  std::string text;
  fp::Span span; ///< including quotes

  [[nodiscard]] bool written() const { return span.end > span.begin; }
};

/// A word of a table and its place.
template <typename Enum> struct Chosen {
  Enum value = {};
  fp::Span span;
};

/// The values of rowOf(word).arguments(), in that order.
struct Arguments {
  std::array<Number, kMaxArguments> numbers = {};

  /// Returns a value. Requires that the row has an argument of that name.
  [[nodiscard]] double get(const WordRow &row, std::string_view name) const;
};

struct ShapeSpec {
  Chosen<Shape> shape;
  Arguments arguments;
  std::array<Number, 3> at = {}; ///< the position of its middle, after scaling
  Number scale{1, {}};
  Name file;                 ///< of File
  std::vector<ShapeSpec> of; ///< one for shells and volume, else none

  [[nodiscard]] double argument(std::string_view name) const {
    return arguments.get(rowOf(shape.value), name);
  }
};

struct CameraSpec {
  Chosen<CameraKind> kind;
  Arguments arguments;

  [[nodiscard]] double argument(std::string_view name) const {
    return arguments.get(rowOf(kind.value), name);
  }
};

struct State {
  std::optional<Chosen<Blend>> blend;
  std::optional<Chosen<Depth>> depth;
  bool depthWrite = true;
  std::optional<Chosen<Cull>> cull;
  std::optional<Chosen<Stencil>> stencil;
  bool colorWrite = true;
  std::array<Number, 4> clear = {};
  bool keep = false;
};

struct Target {
  Name name;
  Number width, height;
};

/// The source of one texture coordinate set.
struct CoordinateSpec {
  unsigned set = 0;
  Chosen<Coordinate> source;
  std::array<Number, 2> offset = {}; ///< of St
};

struct Animation {
  Chosen<AnimationKind> kind;
  Number period{1, {}}; ///< seconds, > 0
};

/// One line of local, env or attrib.
struct Parameter {
  Setting space = Setting::Local; ///< or Env, Attrib
  unsigned first = 0;             ///< index
  unsigned count = 1;             ///< more than one: the rows of a matrix
  std::array<bool, 4> mask = {true, true, true, true};
  Name label; ///< without quotes; may be empty
  Chosen<ValueKind> kind;
  std::vector<Number> values; ///< one for each component of the mask; of Rotate: degrees
  Arguments arguments;        ///< of Rotate
  Name target;                ///< of Camera: the pass whose camera it is
  bool hasRange = false;
  Number low{0, {}}, high{1, {}};
  bool color = false; ///< edited as a color
  std::optional<Animation> animation;
  fp::Span span; ///< the whole clause
};

/// The source of texels.
struct TextureSource {
  Chosen<Generator> generator;
  Arguments arguments;
  Number width{256, {}}, height{256, {}}; ///< texels; the width of a cube map
  std::vector<Name> files;                ///< File: one; Cube: six, or one DDS
  Name target;                            ///< of Picture and DepthOf
  std::vector<TextureSource> of;          ///< of Normals and Feedback; may be empty

  [[nodiscard]] double argument(std::string_view name) const {
    return arguments.get(rowOf(generator.value), name);
  }
};

struct TextureSpec {
  unsigned unit = 0;
  fp::Span unitSpan;
  TextureSource source;
  Chosen<Filter> filter{Filter::Linear, {}};
  Chosen<Wrap> wrap{Wrap::Repeat, {}};
  bool compare = false; ///< a shadow texture: the comparison with r yields 1 if r is not farther
  fp::Span span;
};

struct Panel {
  Name title, profile, numerics;
  Number width{512, {}}, height{512, {}};
  Number rate{60, {}};
  std::vector<ShapeSpec> mesh; ///< drawn as one; empty: not set
  fp::Span meshSpan;
  std::optional<CameraSpec> camera;
  State state;
  std::optional<Target> target;
  std::vector<CoordinateSpec> coordinates;
  std::vector<Parameter> parameters;
  std::vector<TextureSpec> textures;
  Name vertex;
  std::vector<Name> then;
  bool written = false; ///< true if the text has any `#@` line
  /// The diagnostics. An error is a line that cannot be obeyed. A warning is about words that have
  /// no meaning here; they are ignored and kept in the text.
  std::vector<fp::Diagnostic> diagnostics;

  [[nodiscard]] bool ok() const;
};

/// The largest values in a text; more is an error.
inline constexpr int kMaxTextureSide = 4096;
inline constexpr unsigned kMaxUnits = 32;
inline constexpr unsigned kMaxParameters = 1024;
inline constexpr std::size_t kMaxPanelDiagnostics = 64;

/// Parses the `#@` lines of a text in any language.
[[nodiscard]] Panel parsePanel(std::string_view text);

} // namespace arbiter::scene
