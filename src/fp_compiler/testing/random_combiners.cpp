#include "fp_compiler/testing/random_combiners.h"

#include <array>
#include <vector>

namespace arbiter::fp::testing {

using namespace combiners;

namespace {

/// Makes the stages in order, and tracks which registers are defined.
class Maker {
public:
  Maker(Random &random, const RandomCombinersOptions &options)
      : m_random(random), m_options(options) {
    for (const Register name : {Register::Zero, Register::Constant0, Register::Constant1,
                                Register::Fog, Register::Primary, Register::Secondary})
      m_rgb[std::size_t(name)] = m_alpha[std::size_t(name)] = true;
    for (int unit = 0; unit < m_options.units; ++unit)
      if ((m_options.textures >> unit & 1) != 0)
        m_rgb[std::size_t(textureRegister(unit))] = m_alpha[std::size_t(textureRegister(unit))] =
            true;
    m_alpha[std::size_t(Register::Spare0)] = (m_options.textures & 1) != 0;
  }

  State make() {
    State state;
    state.count = std::uint8_t(1 + m_random.below(m_options.stages));
    state.perStageConstants = m_random.chance(50);
    state.sumClamp = m_random.chance(70);
    for (std::size_t i = 0; i < state.count; ++i) {
      const Stage stage = {portion(false), portion(true)};
      note(stage.rgb, m_rgb);
      note(stage.alpha, m_alpha);
      state.stages[i] = stage;
    }
    finals(state);
    return state;
  }

private:
  using Defined = std::array<bool, kRegisters>;

  Register named(const Defined &defined, bool withFog) {
    std::vector<Register> names;
    for (int i = 0; i < kRegisters; ++i)
      if (defined[std::size_t(i)] && (withFog || Register(i) != Register::Fog))
        names.push_back(Register(i));
    return names[std::size_t(m_random.below(int(names.size())))];
  }

  /// Returns an input. Only the final combiner can read the alpha of fog.
  Input input(bool alpha, bool final) {
    Input input;
    const bool own = m_random.chance(70);
    input.usage = alpha ? (own ? Usage::Alpha : Usage::Blue) : (own ? Usage::Rgb : Usage::Alpha);
    const bool ofAlpha = input.usage == Usage::Alpha;
    input.source = named(ofAlpha ? m_alpha : m_rgb, final || !ofAlpha);
    input.mapping = Mapping(m_random.below(final ? 2 : kMappings));
    return input;
  }

  Portion portion(bool alpha) {
    Portion portion;
    for (Input &variable : portion.inputs)
      variable = input(alpha, false);
    std::vector<Register> free = {Register::Primary, Register::Secondary, Register::Spare0,
                                  Register::Spare1};
    for (int unit = 0; unit < m_options.units; ++unit)
      free.push_back(textureRegister(unit));
    const auto output = [&](int percent) {
      if (!m_random.chance(percent))
        return Register::Discard;
      const auto at = free.begin() + m_random.below(int(free.size()));
      const Register name = *at;
      free.erase(at);
      return name;
    };
    portion.sum = m_random.chance(50) ? Register::Spare0 : Register::Discard;
    if (portion.sum == Register::Spare0)
      free.erase(free.begin() + 2);
    else
      portion.sum = output(50);
    portion.ab = output(40);
    portion.cd = output(40);
    portion.abDot = !alpha && m_random.chance(30);
    portion.cdDot = !alpha && m_random.chance(30);
    portion.mux = m_random.chance(25);
    portion.scale = Scale(m_random.below(4));
    portion.bias =
        (portion.scale == Scale::None || portion.scale == Scale::ByTwo) && m_random.chance(30);
    return portion;
  }

  static void note(const Portion &portion, Defined &defined) {
    for (const Register to : {portion.ab, portion.cd, portion.sum})
      if (to != Register::Discard)
        defined[std::size_t(to)] = true;
  }

  void finals(State &state) {
    for (std::size_t v = 0; v < state.finals.size(); ++v) {
      Input &variable = state.finals[v];
      variable = input(v == 6, true);
      const bool mayBePseudo = v < 4 && variable.usage == Usage::Rgb;
      const bool sumDefined = m_rgb[std::size_t(Register::Spare0)];
      if (mayBePseudo && m_random.chance(20))
        variable.source = Register::ETimesF;
      else if (mayBePseudo && v != 0 && sumDefined && m_random.chance(20))
        variable.source = Register::Spare0PlusSecondary;
    }
  }

  Random &m_random;
  const RandomCombinersOptions &m_options;
  Defined m_rgb{}, m_alpha{};
};

} // namespace

State randomCombiners(Random &random, const RandomCombinersOptions &options) {
  return Maker(random, options).make();
}

} // namespace arbiter::fp::testing
