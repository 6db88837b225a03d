#include "fp_compiler/back/llvm/fragment/fragment_discards.h"

#include "fp_compiler/back/llvm/testing/fragment_window.h"

/// Tests that vectors whose fragments are all discarded or hidden are skipped before their colours
/// are computed, with the same result.
namespace arbiter::fp::testing {
namespace {

using ir::AttributeKind;
using ir::Opcode;
using ir::TexTarget;
using llvm_back::discardProgramOf;

constexpr int kLeast = 100; // greatest alpha, as a byte, that is discarded
// All columns before kGone are discarded, and none from kAll on.
constexpr int kGone = 30, kAll = 52;
constexpr int kHiddenRows = 4;

/// Returns a program with two samples. The alpha of the first decides about discard, by the alpha
/// test or by KIL.
ir::Program twoSamples(bool kills) {
  ir::Builder b;
  auto a = b.temporary(), c = b.temporary(), color = b.temporary();
  const ir::Source place = b.attribute(AttributeKind::TexCoord);
  b.tex(Opcode::Tex, a, place, 0, TexTarget::Tex2D);
  b.tex(Opcode::Tex, c, place, 1, TexTarget::Tex2D);
  b.op(Opcode::Mul, color, {a.read(), c.read()});
  b.op(Opcode::Sub, color.mask("w"), {a.read(), b.local(0)});
  if (kills)
    b.kil(color.read().swz("w"));
  b.op(Opcode::Mov, b.color(), {color.read()});
  return b.take();
}

std::uint8_t *alphaOf(SceneTexture &texture, int x, int y) {
  const auto at = texture.level.base - texture.bytes.data() + y * texture.level.rowStride + 4 * x;
  return texture.bytes.data() + at + 3;
}

/// A scene with a texel for each pixel, and depths that hide the lowest rows.
struct Discarding : Scene {
  explicit Discarding(const std::string &cpu) : Scene(cpu) {
    addTexture(kWidth, kHeight, Wrap::ClampToEdge);
    addTexture(kWidth, kHeight, Wrap::Repeat, abi::Filter::Linear);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (x < kGone || x >= kAll)
          *alphaOf(*textures[0], x, y) = x < kGone ? 7 : 250;
    depth = makeTarget({Layout::Depth32F, abi::kRgba}, kWidth, kHeight, 1);
    data.depthStencil = {depth.pixel(0, 0), depth.rowStride};
    data.depthMaximum = 1;
    primitive.z = {0.5f, 0, 0};
    data.alphaReference = 0;
  }
  void setDepths() {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float there = y < kHiddenRows ? 0.25f : 1.0f;
        std::memcpy(depth.pixel(x, y), &there, sizeof there);
      }
  }
  [[nodiscard]] float depthAt(int x, int y) {
    float there = 0;
    std::memcpy(&there, depth.pixel(x, y), sizeof there);
    return there;
  }
  [[nodiscard]] std::vector<std::uint8_t> drawn(const ir::Program &program, bool inRows) {
    setDepths();
    const std::vector<QuadInput> corners = {{0, 0, 1, 1}};
    const std::vector<std::array<float, 4>> locals = {{0, 0, 0, (kLeast + 0.5f) / 255}};
    return inRows ? draw(program, corners, wholeRows(), locals)
                  : drawBlocks(program, corners, locals);
  }

  SceneTarget depth;
};

TEST_P(FragmentTest, LeavesWhatIsDiscardedAndHidden) {
  for (const bool rows : {true, false})
    for (const bool kills : {false, true})
      for (const bool depths : {false, true}) {
        SCOPED_TRACE("rows " + std::to_string(rows) + " kills " + std::to_string(kills) +
                     " depths " + std::to_string(depths));
        Discarding scene(GetParam());
        const std::vector<std::uint8_t> all = scene.drawn(twoSamples(false), rows);
        const SceneTarget before = makeTarget(scene.target.format, kWidth, kHeight, 1);
        scene.key.alphaTest = kills ? abi::Compare::Always : abi::Compare::Greater;
        if (depths) {
          scene.key.depthStencil.layout = Layout::Depth32F;
          scene.key.depthStencil.depthTest = scene.key.depthStencil.depthWrite = 1;
          scene.key.depthStencil.depthCompare = abi::Compare::Less;
        }
        const std::vector<std::uint8_t> got = scene.drawn(twoSamples(kills), rows);
        ASSERT_TRUE(discardProgramOf(*scene.prepared, scene.key).has_value());
        int kept = 0;
        for (int y = 0; y < kHeight; ++y)
          for (int x = 0; x < kWidth; ++x) {
            const bool passes =
                *alphaOf(*scene.textures[0], x, y) > kLeast && !(depths && y < kHiddenRows);
            kept += passes;
            const auto at = std::size_t(before.first + y * before.rowStride + 4 * x);
            const std::uint8_t *const want = (passes ? all : before.bytes).data() + at;
            ASSERT_EQ(std::memcmp(got.data() + at, want, 4), 0) << x << ", " << y;
            const float old = y < kHiddenRows ? 0.25f : 1.0f;
            ASSERT_EQ(scene.depthAt(x, y), depths && passes ? 0.5f : old) << x << ", " << y;
          }
        EXPECT_GT(kept, 100);
        EXPECT_LT(kept, kWidth * kHeight - 100);
      }
}

TEST_P(FragmentTest, DiscardsAreToldByLessThanTheWholeProgram) {
  Discarding scene(GetParam());
  const auto prepare = [&](const ir::Program &program) {
    return scene.engine->prepareFragment(program, Numerics::Host);
  };
  const auto whole = prepare(twoSamples(false));
  EXPECT_FALSE(discardProgramOf(*whole, scene.key)) << "nothing is discarded";
  scene.key.alphaTest = abi::Compare::Greater;
  const auto part = discardProgramOf(*whole, scene.key);
  ASSERT_TRUE(part);
  for (const ir::Instruction &instruction : part->program().code)
    if (instruction.dst.file == ir::File::Output) {
      EXPECT_EQ(instruction.dst.mask, 8);
    }

  const auto byKil = prepare(twoSamples(true));
  scene.key.alphaTest = abi::Compare::Always;
  EXPECT_TRUE(discardProgramOf(*byKil, scene.key));
  scene.key.coverage = abi::Coverage::Disc;
  EXPECT_FALSE(discardProgramOf(*byKil, scene.key)) << "alpha is what is covered too";
  scene.key.coverage = abi::Coverage::Whole;
  scene.key.samplers[0].mip = abi::MipFilter::Nearest;
  EXPECT_FALSE(discardProgramOf(*byKil, scene.key)) << "its sample would be taken twice";
  scene.key.samplers[0].mip = abi::MipFilter::None;
  scene.key.alphaTest = abi::Compare::Less;
  EXPECT_FALSE(discardProgramOf(*prepare(passThrough()), scene.key)) << "all samples are in it";
}

} // namespace
} // namespace arbiter::fp::testing
