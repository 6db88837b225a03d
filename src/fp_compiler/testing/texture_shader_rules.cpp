#include "fp_compiler/testing/texture_shader_rules.h"

namespace arbiter::fp::texture_shader {

namespace {

using Type = ResultType;

Type typeOf(Base base) {
  if (base == Base::Hilo)
    return Type::Hilo;
  return base >= Base::Dsdt ? Type::Offsets : Type::Colors;
}

class Rules {
public:
  explicit Rules(const State &state) : m_state(state) {}

  using O = Operation;

  static bool accesses(O operation) {
    switch (operation) {
    case O::None:
    case O::PassThrough:
    case O::CullFragment:
    case O::DotProduct:
    case O::DotProductDepthReplace:
    case O::DotProductPassThrough:
    case O::DotProductAffineDepthReplace:
      return false;
    default:
      return true;
    }
  }

  /// Returns type, base and signedness of a stage's result if the stage is consistent.
  [[nodiscard]] Result kindOf(int i) const {
    Result kind;
    if (accesses(operation(i))) {
      kind.base = texture(i).base;
      kind.signs = texture(i).signs;
      kind.type = typeOf(kind.base);
    } else if (operation(i) == O::PassThrough || operation(i) == O::DotProductPassThrough) {
      kind.type = Type::Colors;
      kind.base = Base::Rgba;
    } else if (operation(i) == O::DotProduct) {
      kind.type = Type::Float;
    }
    return kind;
  }

  [[nodiscard]] bool previousIs(int i, bool (*fits)(const Result &)) const {
    const int p = previousOf(i);
    if (p >= i || operation(p) == O::DotProduct || !consistent(p))
      return false;
    const Result kind = kindOf(p);
    return kind.type != Type::Invalid && fits(kind);
  }
  [[nodiscard]] bool previousHasOffsets(int i) const {
    return previousIs(i, [](const Result &r) { return r.type == Type::Offsets; });
  }
  [[nodiscard]] bool previousHasMagnitude(int i) const {
    return previousIs(
        i, [](const Result &r) { return r.type == Type::Offsets && r.base != Base::Dsdt; });
  }
  [[nodiscard]] bool previousIsUnsignedColor(int i) const {
    return previousIs(
        i, [](const Result &r) { return r.type == Type::Colors && r.signs == Signs::Unsigned; });
  }
  [[nodiscard]] bool previousIsVector(int i) const {
    return previousIs(i, [](const Result &r) {
      return (r.type == Type::Colors || r.type == Type::Hilo) && r.signs != Signs::SignedRgb;
    });
  }
  [[nodiscard]] bool unsignedColorTexture(int i) const {
    return typeOf(texture(i).base) == Type::Colors && texture(i).signs == Signs::Unsigned;
  }
  /// True if the stage is a consistent DOT_PRODUCT_NV.
  [[nodiscard]] bool dotStage(int i) const {
    return operation(i) == O::DotProduct && consistent(i);
  }
  [[nodiscard]] static bool reflects(O operation) {
    return operation == O::DotProductReflectCubeMap ||
           operation == O::DotProductConstEyeReflectCubeMap;
  }
  [[nodiscard]] bool reflectConsistent(int i) const {
    if (previousOf(i) == i - 1 || previousOf(i) == i - 2 || !previousIsVector(i) ||
        !dotStage(i - 2))
      return false;
    // For a diffuse stage before this one, all its rules apply except those that depend on this
    // stage.
    return dotStage(i - 1) ||
           (operation(i - 1) == O::DotProductDiffuseCubeMap && diffuseItself(i - 1));
  }
  [[nodiscard]] bool diffuseItself(int i) const {
    return texture(i).base != Base::None && previousIsVector(i) && dotStage(i - 1);
  }
  [[nodiscard]] bool anyDepthBefore(int i) const {
    for (int before = 0; before < i; ++before)
      if ((operation(before) == O::DotProductDepthReplace ||
           operation(before) == O::DotProductAffineDepthReplace) &&
          consistent(before))
        return true;
    return false;
  }

  [[nodiscard]] bool consistent(int i) const {
    const O op = operation(i);
    if (accesses(op) && texture(i).base == Base::None)
      return false;
    switch (op) {
    case O::None:
    case O::PassThrough:
    case O::CullFragment:
    case O::Texture1D:
    case O::Texture2D:
    case O::TextureRectangle:
    case O::TextureCubeMap:
    case O::Texture3D:
      return true;
    case O::Offset2D:
    case O::OffsetRectangle:
    case O::OffsetProjective2D:
    case O::OffsetProjectiveRectangle:
      return previousHasOffsets(i);
    case O::Offset2DScale:
    case O::OffsetRectangleScale:
    case O::OffsetProjective2DScale:
    case O::OffsetProjectiveRectangleScale:
      return previousHasMagnitude(i) && unsignedColorTexture(i);
    case O::OffsetHilo2D:
    case O::OffsetHiloRectangle:
    case O::OffsetHiloProjective2D:
    case O::OffsetHiloProjectiveRectangle:
      return previousIs(
          i, [](const Result &r) { return r.type == Type::Hilo && r.signs == Signs::Signed; });
    case O::DependentAR2D:
    case O::DependentGB2D:
    case O::DependentRgb3D:
      return previousIsUnsignedColor(i);
    case O::DependentRgbCubeMap:
      return previousIs(i, [](const Result &r) { return r.type == Type::Colors; });
    case O::DependentHilo2D:
      return previousIs(
          i, [](const Result &r) { return r.type == Type::Hilo && r.signs == Signs::Unsigned; });
    case O::DotProduct:
    case O::DotProduct1D:
    case O::DotProductPassThrough:
      return previousIsVector(i);
    case O::DotProduct2D:
    case O::DotProductRectangle:
      return previousIsVector(i) && dotStage(i - 1);
    case O::DotProduct3D:
    case O::DotProductCubeMap:
      return previousIsVector(i) && dotStage(i - 1) && dotStage(i - 2);
    case O::DotProductReflectCubeMap:
    case O::DotProductConstEyeReflectCubeMap:
      return reflectConsistent(i);
    case O::DotProductDiffuseCubeMap:
      return diffuseItself(i) && reflects(operation(i + 1)) && texture(i + 1).base != Base::None &&
             reflectConsistent(i + 1);
    case O::DotProductDepthReplace:
      return previousIsVector(i) && dotStage(i - 1) && !anyDepthBefore(i);
    case O::DotProductAffineDepthReplace:
      return previousIsVector(i) && !anyDepthBefore(i);
    }
    return false;
  }

private:
  [[nodiscard]] O operation(int i) const {
    return i >= 0 && i < m_state.units ? m_state.stages[std::size_t(i)].operation : O::None;
  }
  [[nodiscard]] int previousOf(int i) const { return m_state.stages[std::size_t(i)].previous; }
  [[nodiscard]] const Texture &texture(int i) const { return m_state.textures[std::size_t(i)]; }

  const State &m_state;
};

} // namespace

bool isConsistent(const State &state, int unit) { return Rules(state).consistent(unit); }
Result kindOfResult(const State &state, int unit) { return Rules(state).kindOf(unit); }

} // namespace arbiter::fp::texture_shader
