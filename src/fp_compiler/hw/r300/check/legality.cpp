#include "fp_compiler/hw/r300/check/legality.h"

#include <algorithm>

#include "fp_compiler/hw/r300/check/reads.h"
#include "fp_compiler/hw/r300/check/references.h"

namespace arbiter::fp::hw::r300 {

namespace {
constexpr std::uint8_t kColorTargets = 4, kImageUnits = 16;
constexpr std::uint8_t kRgbMask = 7, kAlphaMask = 8;

/// Checks the program in its order, and tracks which components have been written.
class Checker {
public:
  explicit Checker(const Code &code) : m_code(code), m_written(code.temporaries, 0) {}

  std::vector<Fault> run() {
    interpolants();
    if (m_code.nodes.empty())
      add(Rule::NoNode, "no node");
    for (std::size_t i = 0; i < m_code.nodes.size(); ++i)
      node(i);
    if (m_nextTexture != m_code.textures.size() || m_nextPair != m_code.pairs.size())
      add(Rule::NodeBlocks,
          say("the nodes end after TEX ", m_nextTexture, " and pair ", m_nextPair,
              ", the code after ", m_code.textures.size(), " and ", m_code.pairs.size()));
    m_where.clear();
    if (m_highest != m_code.temporaries)
      add(Rule::Registers,
          say(m_code.temporaries, " registers are claimed, ", m_highest, " are used"));
    return std::move(m_faults);
  }

private:
  void add(Rule rule, const std::string &what) {
    m_faults.push_back({rule, m_where.empty() ? what : m_where + ": " + what});
  }

  /// Returns false if there is no such register.
  bool use(std::uint16_t reg) {
    m_highest = std::max(m_highest, std::uint32_t(reg) + 1);
    return reg < m_code.temporaries;
  }

  void interpolants() {
    std::vector<std::uint16_t> attributes;
    for (const Interpolant &interpolant : m_code.interpolants) {
      m_where = say("interpolant ", interpolant.attribute);
      if (std::count(attributes.begin(), attributes.end(), interpolant.attribute))
        add(Rule::Interpolants, "twice");
      attributes.push_back(interpolant.attribute);
      if (!use(interpolant.temporary)) {
        add(Rule::Destination, say("no register r", interpolant.temporary));
        continue;
      }
      if (m_written[interpolant.temporary])
        add(Rule::Interpolants, say("r", interpolant.temporary, " holds another one"));
      m_written[interpolant.temporary] = 0xF;
    }
    m_where.clear();
  }

  void node(std::size_t index) {
    const Node &node = m_code.nodes[index];
    m_where = say("node ", index);
    if (node.pairs == 0)
      add(Rule::EmptyNode, "no pair");
    if (index > 0 && node.textures == 0)
      add(Rule::NodeWithoutTexture, "no TEX, and it is not the first");
    const bool inside =
        std::uint64_t(node.firstTexture) + node.textures <= m_code.textures.size() &&
        std::uint64_t(node.firstPair) + node.pairs <= m_code.pairs.size();
    if (!inside || node.firstTexture != m_nextTexture || node.firstPair != m_nextPair)
      add(Rule::NodeBlocks, say("starts at TEX ", node.firstTexture, " and pair ", node.firstPair,
                                ", expected ", m_nextTexture, " and ", m_nextPair));
    if (!inside)
      return;
    m_nextTexture = node.firstTexture + node.textures;
    m_nextPair = node.firstPair + node.pairs;
    textures(index);
    for (std::uint32_t i = 0; i < node.pairs; ++i) {
      m_pair = say("node ", index, ", pair ", node.firstPair + i);
      pair(m_code.pairs[node.firstPair + i]);
    }
  }

  void textures(std::size_t index) {
    const Node &node = m_code.nodes[index];
    std::vector<std::uint16_t> written;
    for (std::uint32_t i = 0; i < node.textures; ++i) {
      const Texture &texture = m_code.textures[node.firstTexture + i];
      m_where = say("node ", index, ", TEX ", node.firstTexture + i);
      const auto overwritten = [&](std::uint16_t reg) {
        return std::count(written.begin(), written.end(), reg) != 0;
      };
      if (texture.unit >= kImageUnits)
        add(Rule::TextureUnit, say("no image unit ", texture.unit));
      if (overwritten(texture.source))
        add(Rule::TextureHazard, say("reads r", texture.source, ", which a TEX before it writes"));
      coordinate(texture);
      if (texture.op == TexOp::Kill) {
        if (texture.destination != kNone)
          add(Rule::TextureRegister, "a kill with a destination");
        continue;
      }
      if (texture.destination == kNone || !use(texture.destination)) {
        add(Rule::TextureRegister, "no destination");
        continue;
      }
      if (overwritten(texture.destination))
        add(Rule::TextureHazard, say("writes r", texture.destination, ", as a TEX before it does"));
      written.push_back(texture.destination);
    }
    for (const std::uint16_t reg : written)
      m_written[reg] = 0xF;
  }

  void coordinate(const Texture &texture) {
    if (!use(texture.source)) {
      add(Rule::TextureRegister, say("no register r", texture.source));
      return;
    }
    if (const auto missing = std::uint8_t(componentsRead(texture) & ~m_written[texture.source]))
      unwritten(texture.source, missing);
  }

  void unwritten(std::uint16_t reg, std::uint8_t components) {
    std::string letters;
    for (std::size_t c = 0; c < 4; ++c)
      if (components >> c & 1)
        letters += "xyzw"[c];
    add(Rule::Unwritten, say("reads r", reg, ".", letters, ", which nothing has written"));
  }

  void pair(const Pair &pair) {
    addresses(pair.rgb, "RGB");
    addresses(pair.alpha, "alpha");
    arguments(pair);
    reads(pair);
    together(pair);
    m_where = m_pair + ", RGB";
    writes(pair.rgb, kRgbMask);
    if (pair.rgb.depth)
      add(Rule::Depth, "writes depth");
    m_where = m_pair + ", alpha";
    writes(pair.alpha, kAlphaMask);
  }

  /// Checks every address of a half, even one that nothing reads: the register file still fetches
  /// it.
  template <typename Half> void addresses(const Half &half, const char *name) {
    m_where = m_pair + ", " + name;
    for (std::size_t i = 0; i < half.sources.size(); ++i) {
      const Source &source = half.sources[i];
      if (source.bank == Source::Bank::Temporary && !use(source.index))
        add(Rule::SourceIndex, say("source ", i, ": no register r", source.index));
      if (source.bank == Source::Bank::Constant && source.index >= m_code.constants.size())
        add(Rule::SourceIndex, say("source ", i, ": no constant c", source.index));
    }
  }

  /// Checks the rules that hold for an argument whichever of its components matter.
  template <typename Argument>
  void argument(const Pair &pair, const Argument &argument, std::uint8_t components) {
    bool rgb = false, alpha = false;
    for (std::size_t c = 0; c < 3; ++c) {
      Tap tap;
      if constexpr (std::is_same_v<Argument, RgbArgument>)
        tap = tapOf(argument.select, c);
      else
        tap = tapOf(argument.select);
      rgb |= (components >> c & 1) && tap.from == Tap::From::Rgb;
      alpha |= (components >> c & 1) && tap.from == Tap::From::Alpha;
    }
    if (!rgb && !alpha)
      return;
    if (argument.source > kPresubtracted) {
      add(Rule::SourceNumber, say("source ", argument.source));
      return;
    }
    if (argument.source == kPresubtracted) {
      if constexpr (std::is_same_v<Argument, RgbArgument>)
        if (argument.select == RgbSelect::Yzx || argument.select == RgbSelect::Zxy ||
            argument.select == RgbSelect::Wzy)
          add(Rule::PresubtractSelect, "a swizzle that presubtract results do not have");
      if (rgb)
        presubtract(pair.rgb, "RGB");
      if (alpha)
        presubtract(pair.alpha, "alpha");
      return;
    }
    if (rgb && pair.rgb.sources[argument.source].bank == Source::Bank::None)
      add(Rule::SourceAddress, say("RGB source ", argument.source, " has no address"));
    if (alpha && pair.alpha.sources[argument.source].bank == Source::Bank::None)
      add(Rule::SourceAddress, say("alpha source ", argument.source, " has no address"));
  }

  template <typename Half> void presubtract(const Half &half, const char *name) {
    const bool two =
        half.presubtract == Presubtract::S1MinusS0 || half.presubtract == Presubtract::S1PlusS0;
    if (half.presubtract == Presubtract::None)
      add(Rule::Presubtract, say("the ", name, " half makes no presubtract result"));
    else if (half.sources[0].bank == Source::Bank::None ||
             (two && half.sources[1].bank == Source::Bank::None))
      add(Rule::Presubtract, say("the ", name, " presubtract lacks an address"));
  }

  void arguments(const Pair &pair) {
    const std::uint8_t components = componentsRead(pair.rgb);
    for (std::size_t i = 0; i < argumentCount(pair.rgb.op); ++i) {
      m_where = say(m_pair, ", RGB, argument ", std::string(1, "ABC"[i]));
      argument(pair, pair.rgb.arguments[i], components);
    }
    for (std::size_t i = 0; i < argumentCount(pair.alpha.op, pair.rgb.op); ++i) {
      m_where = say(m_pair, ", alpha, argument ", std::string(1, "ABC"[i]));
      argument(pair, pair.alpha.arguments[i], 1);
    }
  }

  void reads(const Pair &pair) {
    for (const Read &read : readsOf(pair)) {
      if (read.number > 2)
        continue;
      const Source &source =
          read.alphaAddress ? pair.alpha.sources[read.number] : pair.rgb.sources[read.number];
      if (source.bank != Source::Bank::Temporary || source.index >= m_code.temporaries ||
          (m_written[source.index] >> read.component & 1))
        continue;
      m_where = say(m_pair, read.alphaHalf ? ", alpha" : ", RGB", ", argument ",
                    std::string(1, "ABC"[read.argument]));
      unwritten(source.index, std::uint8_t(1 << read.component));
    }
  }

  void together(const Pair &pair) {
    m_where = m_pair;
    const bool dot = pair.rgb.op == RgbOp::Dp3 || pair.rgb.op == RgbOp::Dp4;
    if (pair.alpha.op == AlphaOp::Dp && !dot)
      add(Rule::DotProduct, "Dp beside no dot product");
    if (pair.rgb.op == RgbOp::Dp4 && pair.alpha.op != AlphaOp::Dp)
      add(Rule::DotProduct, "Dp4 without Dp: its fourth component is the alpha half's");
    if (pair.rgb.op == RgbOp::ReplAlpha && pair.alpha.op == AlphaOp::None)
      add(Rule::ReplicatedAlpha, "ReplAlpha beside an idle alpha half");
  }

  template <typename Half> void writes(const Half &half, std::uint8_t allowed) {
    using Op = decltype(half.op);
    if (half.op == Op::None && (half.mask || half.outputMask || half.depth))
      add(Rule::IdleWrite, "writes without an operation");
    if ((half.mask | half.outputMask) & ~allowed)
      add(Rule::Mask, "writes components of the other half");
    if (half.outputMask && half.output >= kColorTargets)
      add(Rule::Target, say("no colour target ", half.output));
    if (half.temporary != kNone && !use(half.temporary))
      add(Rule::Destination, say("no register r", half.temporary));
    else if (half.mask && half.temporary == kNone)
      add(Rule::Destination, "writes no register under a mask");
    else if (half.temporary != kNone)
      m_written[half.temporary] |= half.mask & allowed;
  }

  const Code &m_code;
  std::vector<Fault> m_faults;
  std::vector<std::uint8_t> m_written; ///< components of each register that have been written
  std::string m_where, m_pair;
  std::uint32_t m_nextTexture = 0, m_nextPair = 0, m_highest = 0;
};
} // namespace

std::vector<Fault> faults(const Code &code) { return Checker(code).run(); }

std::vector<Fault> faults(const Code &code, const ir::Program &program) {
  std::vector<Fault> found = faults(code);
  addReferenceFaults(code, program, found);
  return found;
}

std::vector<std::string> overflows(const Code &code, const Chip &chip) {
  std::vector<std::string> lines;
  const auto line = [&](std::size_t used, std::uint32_t limit, const char *what) {
    if (used > limit)
      lines.push_back(say(used, " ", what, " of ", limit));
  };
  line(code.pairs.size(), chip.pairs, "pairs");
  line(code.textures.size(), chip.textures, "TEX");
  line(code.nodes.size(), chip.nodes, "nodes");
  line(code.temporaries, chip.temporaries, "registers");
  line(code.constants.size(), chip.constants, "constants");
  line(code.interpolators, chip.interpolators, "interpolators");
  return lines;
}

} // namespace arbiter::fp::hw::r300
