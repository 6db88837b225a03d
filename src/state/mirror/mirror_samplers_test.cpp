// Compares the mirror's samplers and vertex arrays with a real host.
#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/mirror/mirror.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "state/raster_draw/vertices/array_source.h"
#include "state/raster_draw/vertices/vertex_fetch.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
namespace {

using testing::Numbers;
using testing::RealHost;

struct Filter {
  GLenum name;
  abi::Filter filter;
  abi::MipFilter mip;
};
constexpr Filter kFilters[] = {
    {GL_NEAREST, abi::Filter::Nearest, abi::MipFilter::None},
    {GL_LINEAR, abi::Filter::Linear, abi::MipFilter::None},
    {GL_NEAREST_MIPMAP_NEAREST, abi::Filter::Nearest, abi::MipFilter::Nearest},
    {GL_LINEAR_MIPMAP_NEAREST, abi::Filter::Linear, abi::MipFilter::Nearest},
    {GL_NEAREST_MIPMAP_LINEAR, abi::Filter::Nearest, abi::MipFilter::Linear},
    {GL_LINEAR_MIPMAP_LINEAR, abi::Filter::Linear, abi::MipFilter::Linear},
};
struct WrapRow {
  GLenum name;
  abi::Wrap wrap;
};
constexpr WrapRow kWraps[] = {
    {GL_REPEAT, abi::Wrap::Repeat},
    {GL_MIRRORED_REPEAT, abi::Wrap::MirroredRepeat},
    {GL_CLAMP, abi::Wrap::Clamp},
    {GL_CLAMP_TO_EDGE, abi::Wrap::ClampToEdge},
    {GL_CLAMP_TO_BORDER, abi::Wrap::ClampToBorder},
    {GL_MIRROR_CLAMP_EXT, abi::Wrap::MirrorClamp},
    {GL_MIRROR_CLAMP_TO_EDGE, abi::Wrap::MirrorClampToEdge},
    {GL_MIRROR_CLAMP_TO_BORDER_EXT, abi::Wrap::MirrorClampToBorder},
};

/// Sets random parameters with the given functions. Returns what the mirror should report.
template <typename SetI, typename SetF, typename SetV>
SamplerState randomParameters(Numbers &n, int coordinates, SetI seti, SetF setf, SetV setv) {
  SamplerState wanted;
  constexpr GLenum kNames[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
  for (int i = 0; i < 3; ++i) {
    const WrapRow wrap = n.of(kWraps);
    seti(kNames[i], GLint(wrap.name));
    if (i < coordinates)
      wanted.key.wrap[std::size_t(i)] = wrap.wrap;
  }
  const Filter filter = n.of(kFilters);
  seti(GL_TEXTURE_MIN_FILTER, GLint(filter.name));
  wanted.key.minify = filter.filter;
  wanted.key.mip = filter.mip;
  const bool linear = n.chance(50), compares = n.chance(40);
  seti(GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
  wanted.key.magnify = linear ? abi::Filter::Linear : abi::Filter::Nearest;
  seti(GL_TEXTURE_COMPARE_MODE, compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
  const int function = n.below(8);
  seti(GL_TEXTURE_COMPARE_FUNC, GL_NEVER + function);
  wanted.compares = compares;
  wanted.key.compare = compares ? abi::Compare(function) : abi::Compare::LessEqual;
  wanted.minLod = n.chance(50) ? -1000 : n.real(0, 3);
  wanted.maxLod = n.chance(50) ? 1000 : n.real(3, 6);
  wanted.lodBias = n.chance(50) ? 0 : n.real(-2, 2);
  setf(GL_TEXTURE_MIN_LOD, wanted.minLod);
  setf(GL_TEXTURE_MAX_LOD, wanted.maxLod);
  setf(GL_TEXTURE_LOD_BIAS, wanted.lodBias);
  for (float &c : wanted.borderColor)
    c = n.real(0, 1);
  setv(GL_TEXTURE_BORDER_COLOR, wanted.borderColor);
  return wanted;
}

void expectSame(const SamplerState &got, const SamplerState &wanted) {
  EXPECT_EQ(got.texture, wanted.texture);
  EXPECT_TRUE(got.key == wanted.key);
  EXPECT_EQ(got.compares, wanted.compares);
  EXPECT_EQ(got.lodBias, wanted.lodBias);
  EXPECT_EQ(got.minLod, wanted.minLod);
  EXPECT_EQ(got.maxLod, wanted.maxLod);
  EXPECT_EQ(got.baseLevel, wanted.baseLevel);
  EXPECT_EQ(got.maxLevel, wanted.maxLevel);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(got.borderColor[i], wanted.borderColor[i]);
  EXPECT_EQ(got.obstacle, nullptr);
}

TEST(MirrorSamplers, OfTexturesAndOfObjects) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  GLuint textures[4], samplers[1];
  glGenTextures(4, textures);
  glGenSamplers(1, samplers);
  struct Kind {
    GLenum target;
    abi::Dimension dimension;
    int coordinates;
  };
  constexpr Kind kKinds[] = {{GL_TEXTURE_1D, abi::Dimension::Tex1D, 1},
                             {GL_TEXTURE_2D, abi::Dimension::Tex2D, 2},
                             {GL_TEXTURE_3D, abi::Dimension::Tex3D, 3},
                             {GL_TEXTURE_CUBE_MAP, abi::Dimension::Cube, 3}};
  glActiveTexture(GL_TEXTURE1);
  for (int round = 0; round < 400; ++round) {
    Numbers n{std::uint64_t(round)};
    const int at = n.below(4), unit = n.below(8);
    const Kind &kind = kKinds[at];
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(kind.target, textures[at]);
    SamplerState wanted = randomParameters(
        n, kind.coordinates, [&](GLenum pname, GLint v) { glTexParameteri(kind.target, pname, v); },
        [&](GLenum pname, GLfloat v) { glTexParameterf(kind.target, pname, v); },
        [&](GLenum pname, const GLfloat *v) { glTexParameterfv(kind.target, pname, v); });
    const bool object = n.chance(40);
    glBindSampler(GLuint(unit), object ? samplers[0] : 0);
    if (object)
      wanted = randomParameters(
          n, kind.coordinates,
          [&](GLenum pname, GLint v) { glSamplerParameteri(samplers[0], pname, v); },
          [&](GLenum pname, GLfloat v) { glSamplerParameterf(samplers[0], pname, v); },
          [&](GLenum pname, const GLfloat *v) { glSamplerParameterfv(samplers[0], pname, v); });
    const float bias = n.chance(50) ? 0 : n.real(-1, 1);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
    wanted.baseLevel = n.below(3);
    wanted.maxLevel = 3 + n.below(9);
    glTexParameteri(kind.target, GL_TEXTURE_BASE_LEVEL, wanted.baseLevel);
    glTexParameteri(kind.target, GL_TEXTURE_MAX_LEVEL, wanted.maxLevel);
    glActiveTexture(GLenum(GL_TEXTURE0 + n.below(8)));
    GLint active = 0, after = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    wanted.texture = textures[at];
    wanted.key.dimension = kind.dimension;
    wanted.lodBias += bias;
    wanted.key.hasBias = wanted.lodBias != 0 || wanted.minLod != -1000 || wanted.maxLod != 1000;
    context.dirty |= dirty::kTextureBindings | dirty::kTextureParameters;
    mirror.refresh(context.dirty);
    const SamplerUse uses[] = {{std::uint8_t(unit), kind.dimension}};
    mirror.refreshSamplers(uses);
    SCOPED_TRACE("round " + std::to_string(round));
    expectSame(mirror.samplers[std::size_t(unit)][std::size_t(kind.dimension)], wanted);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &after);
    EXPECT_EQ(after, active);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    if (HasFailure())
      return;
  }
}

TEST(MirrorSamplers, WhatWeLackIsNamed) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  const SamplerUse uses[] = {{0, abi::Dimension::Tex2D}};
  const auto obstacle = [&] {
    context.dirty |= dirty::kTextureParameters;
    mirror.refresh(context.dirty);
    mirror.refreshSamplers(uses);
    const char *const name = mirror.samplers[0][std::size_t(abi::Dimension::Tex2D)].obstacle;
    return std::string(name ? name : "");
  };
  EXPECT_EQ(obstacle(), "");
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ZERO);
  EXPECT_EQ(obstacle(), "");
  const auto &swizzle = mirror.samplers[0][std::size_t(abi::Dimension::Tex2D)].swizzle;
  EXPECT_EQ(swizzle, (std::array<GLenum, 4>{GL_ZERO, GL_GREEN, GL_BLUE, GL_ALPHA}));
  const SamplerState &sampler = mirror.samplers[0][std::size_t(abi::Dimension::Tex2D)];
  EXPECT_TRUE(sampler.decodes);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  EXPECT_EQ(obstacle(), "");
  EXPECT_FALSE(sampler.decodes);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(MirrorSamplers, AnisotropyIsAFilterOfMipmaps) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  const auto most = [&](GLenum target, abi::Dimension dimension, float limit, GLint filter) {
    glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, limit);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    const SamplerUse use{0, dimension};
    context.dirty |= dirty::kTextureParameters;
    mirror.refresh(context.dirty);
    mirror.refreshSamplers({&use, 1});
    const SamplerState &state = mirror.samplers[0][std::size_t(dimension)];
    return state.key.anisotropic != 0 ? state.maxAnisotropy : 0;
  };
  constexpr auto k2D = abi::Dimension::Tex2D;
  constexpr GLint kMipmaps = GL_LINEAR_MIPMAP_NEAREST;
  EXPECT_EQ(most(GL_TEXTURE_2D, k2D, 1.5f, kMipmaps), 16) << "llvmpipe knows no other";
  context.caps.limitsAnisotropy = true;
  EXPECT_EQ(most(GL_TEXTURE_2D, k2D, 1.5f, kMipmaps), 1.5f);
  EXPECT_EQ(most(GL_TEXTURE_2D, k2D, 100, kMipmaps), 16);
  EXPECT_EQ(most(GL_TEXTURE_2D, k2D, 1, kMipmaps), 0);
  EXPECT_EQ(most(GL_TEXTURE_2D, k2D, 8, GL_LINEAR), 0);
  EXPECT_EQ(most(GL_TEXTURE_1D, abi::Dimension::Tex1D, 8, kMipmaps), 0) << "a line is not wide";
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// Returns x of the first three vertices of a slot, from the mirror to the fetch.
std::array<float, 3> fetched(RasterContext &context, Mirror &mirror, int slot,
                             const DrawCommand &command = {.count = 3}) {
  context.dirty |= dirty::kArrays | dirty::kCurrent;
  mirror.refresh(context.dirty);
  mirror.refreshArrays();
  mirror.refreshCurrent(context.dirty, ~0u);
  const std::uint32_t slots = 1u | 1u << slot;
  ArraySource source;
  VertexFetcher fetcher;
  IndexRange range;
  const bool valid = source.open(context, mirror, slots, command);
  EXPECT_TRUE(valid);
  // A buffer that stays mapped would make later commands fail.
  const struct Closing {
    ArraySource &source;
    RasterContext &context;
    ~Closing() { source.close(context); }
  } closing{source, context};
  if (!valid)
    return {};
  if (command.indexType != 0) {
    EXPECT_TRUE(
        fetcher.decodeIndices(command.indexType, source.indices(), 3, command.baseVertex, range));
    EXPECT_TRUE(fetcher.fetch(source.source(), mirror.current, slots, range.minimum,
                              range.maximum - range.minimum + 1));
    const float *const x = fetcher.component(slot, 0);
    return {x[range.indices[0]], x[range.indices[1]], x[range.indices[2]]};
  }
  EXPECT_TRUE(fetcher.fetch(source.source(), mirror.current, slots, 0, 3));
  const float *const x = fetcher.component(slot, 0);
  return {x[0], x[1], x[2]};
}

using Three = std::array<float, 3>;

TEST(MirrorArrays, OfClientMemoryAndOfBuffers) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  const float positions[] = {1, 2, 3, 4, 5, 6};
  const GLubyte colors[] = {255, 0, 0, 9, 51, 0, 0, 9, 0, 0, 0, 9};
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glEnableClientState(GL_VERTEX_ARRAY);
  EXPECT_EQ(fetched(context, mirror, kPosition), (Three{1, 3, 5}));
  glColorPointer(3, GL_UNSIGNED_BYTE, 4, colors);
  glEnableClientState(GL_COLOR_ARRAY);
  EXPECT_EQ(fetched(context, mirror, kColor), (Three{1, 0.2f, 0}));
  glDisableClientState(GL_COLOR_ARRAY);
  glColor4f(0.5f, 0, 0, 0);
  EXPECT_EQ(fetched(context, mirror, kColor), (Three{0.5f, 0.5f, 0.5f}));

  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
  glClientActiveTexture(GL_TEXTURE3);
  glTexCoordPointer(1, GL_FLOAT, 4, reinterpret_cast<const void *>(4));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE1);
  glVertexAttribPointer(6, 1, GL_FLOAT, GL_FALSE, 8, reinterpret_cast<const void *>(4));
  glEnableVertexAttribArray(6);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  EXPECT_EQ(fetched(context, mirror, kTexCoord0 + 3), (Three{2, 3, 4}));
  EXPECT_EQ(fetched(context, mirror, kGeneric0 + 6), (Three{2, 4, 6}));
  const float more[] = {7, 8};
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferSubData(GL_ARRAY_BUFFER, 4, sizeof more, more);
  EXPECT_EQ(fetched(context, mirror, kTexCoord0 + 3), (Three{7, 8, 4})) << "the newest contents";

  const GLushort indices[] = {9, 2, 0, 1};
  const DrawCommand client{.count = 3, .indexType = GL_UNSIGNED_SHORT, .indices = indices + 1};
  EXPECT_EQ(fetched(context, mirror, kPosition, client), (Three{5, 1, 3}));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  const DrawCommand inBuffer{
      .count = 3, .indexType = GL_UNSIGNED_SHORT, .indices = reinterpret_cast<const void *>(2)};
  EXPECT_EQ(fetched(context, mirror, kPosition, inBuffer), (Three{5, 1, 3}));

  glBindVertexBuffer(9, buffers[0], 8, 4); // the binding differs from every pointer
  glVertexAttribFormat(7, 1, GL_FLOAT, GL_FALSE, 4);
  glVertexAttribBinding(7, 9);
  glEnableVertexAttribArray(7);
  EXPECT_EQ(fetched(context, mirror, kGeneric0 + 7), (Three{4, 5, 6}));
  GLint bound = 0, unit = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
  glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &unit);
  EXPECT_EQ(bound, GLint(buffers[0]));
  EXPECT_EQ(unit, GL_TEXTURE1);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(MirrorArrays, WhatWeLackIsRefused) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  const auto valid = [&](int slot, const DrawCommand &command = {.count = 3}) {
    context.dirty |= dirty::kArrays | dirty::kRaster;
    mirror.refresh(context.dirty);
    mirror.refreshArrays();
    ArraySource source;
    const bool opened = source.open(context, mirror, 1u | 1u << slot, command);
    source.close(context);
    return opened;
  };
  EXPECT_FALSE(valid(kPosition)) << "no array of positions";
  const float positions[12] = {};
  glVertexPointer(4, GL_FLOAT, 0, positions);
  glEnableClientState(GL_VERTEX_ARRAY);
  EXPECT_TRUE(valid(kPosition));
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, 16, positions, GL_STATIC_DRAW);
  glVertexAttribIPointer(4, 1, GL_INT, 0, nullptr);
  glEnableVertexAttribArray(4);
  EXPECT_FALSE(valid(kGeneric0 + 4)) << "integers";
  EXPECT_TRUE(valid(kGeneric0 + 5)) << "that the draw does not read";
  glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  EXPECT_TRUE(valid(kGeneric0 + 4));
  glVertexAttribDivisor(4, 1);
  EXPECT_FALSE(valid(kGeneric0 + 4)) << "a divisor";
  glVertexAttribDivisor(4, 0);
  glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  EXPECT_FALSE(valid(kGeneric0 + 4)) << "mapped by the application";
  glUnmapBuffer(GL_ARRAY_BUFFER);
  EXPECT_TRUE(valid(kGeneric0 + 4));
  glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void *>(13));
  EXPECT_FALSE(valid(kGeneric0 + 4)) << "beyond the buffer";
  glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferStorage(GL_ARRAY_BUFFER, 64, nullptr, GL_MAP_WRITE_BIT);
  glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  EXPECT_FALSE(valid(kGeneric0 + 4)) << "not to be read";
  const GLubyte indices[3] = {};
  const DrawCommand indexed{.count = 3, .indexType = GL_UNSIGNED_BYTE, .indices = indices};
  EXPECT_TRUE(valid(kPosition, indexed));
  glEnable(GL_PRIMITIVE_RESTART);
  EXPECT_FALSE(valid(kPosition, indexed));
  EXPECT_TRUE(valid(kPosition)) << "without indices nothing restarts";
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace arbiter::state
