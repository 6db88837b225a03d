#pragma once
#include <array>
#include <vector>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_combiners.h"
#include "textures.h"

/// The scene for random states of register combiners: textures of one texel, and an 8x8 grid of
/// rectangles. Each has one color, one fog coordinate, and one texture coordinate for each unit, so
/// that interpolation does not affect the comparison with the equations.
namespace combined {

inline constexpr int kCells = 8;    ///< on a side
inline constexpr int kCellSize = 4; ///< in pixels
inline constexpr int kSize = kCells * kCellSize;

class Scene {
public:
  /// Makes the scene. \param negativeTexels some texels are below zero
  /// \param fx9 avoids colors that Numerics::Fx9 could round either way
  Scene(int units, bool negativeTexels, bool fx9);
  /// Chooses a new state and new values for everything around it, and sets GL to it.
  void arrange(arbiter::fp::testing::Random &random,
               arbiter::fp::testing::RandomCombinersOptions options);
  void draw() const;

  [[nodiscard]] const arbiter::fp::combiners::State &state() const { return m_state; }
  [[nodiscard]] arbiter::fp::combiners::Evaluated evaluate(int cell) const;

private:
  struct Cell {
    arbiter::fp::combiners::Color primary{}, secondary{};
    std::array<float, arbiter::fp::combiners::kTextures> r{}; ///< depths are compared with these
    float fog = 0.0f;
  };

  /// Binds the textures. \returns the units that have a texture, one bit each
  std::uint8_t bind(arbiter::fp::testing::Random &random);
  void arrangeFog(arbiter::fp::testing::Random &random);
  void arrangeCells(arbiter::fp::testing::Random &random);
  [[nodiscard]] double fogFactor(double distance) const;

  int m_units;
  bool m_fx9;
  std::vector<Texture> m_textures;
  std::array<const Texture *, arbiter::fp::combiners::kTextures> m_bound{};
  arbiter::fp::combiners::State m_state;
  arbiter::fp::combiners::Inputs m_inputs; ///< the constants and the fog color
  GLenum m_fogMode = GL_NONE;
  double m_density = 1.0, m_start = 0.0, m_end = 1.0;
  std::vector<Cell> m_cells;
};

} // namespace combined
