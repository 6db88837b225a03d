#include "fp_compiler/back/glsl/state.h"

namespace arbiter::fp::glsl {

using ir::MatrixModifier;
using ir::StateItem;
using ir::StateRef;

namespace {
StateText stateVariable(std::string text) { return {std::move(text), true}; }
StateText expression(std::string text) { return {std::move(text), false}; }

/// Returns a matrix row. ARB has rows, but GLSL columns: row r of M is column r of its transpose.
StateText matrixRow(const std::string &name, const StateRef &ref, const std::string &index) {
  const char *suffix = "";
  switch (ref.modifier) {
  case MatrixModifier::Plain:
    suffix = "Transpose";
    break;
  case MatrixModifier::Inverse:
    suffix = "InverseTranspose";
    break;
  case MatrixModifier::Transpose:
    suffix = "";
    break;
  case MatrixModifier::InvTrans:
    suffix = "Inverse";
    break;
  }
  return stateVariable(name + suffix + index + "[" + std::to_string(ref.row) + "]");
}

/// Returns a light product (table X.2.3): the product's rgb, the material's alpha.
StateText lightProduct(const std::string &light, const std::string &material, const char *field) {
  const std::string color = material + "." + field;
  return expression("vec4(" + light + "." + field + ".rgb * " + color + ".rgb, " + color + ".a)");
}
} // namespace

std::optional<StateText> stateText(const StateRef &ref) {
  const std::string material = ref.back ? "gl_BackMaterial" : "gl_FrontMaterial";
  const std::string bracket = "[" + std::to_string(ref.index) + "]";
  const std::string light = "gl_LightSource" + bracket;
  switch (ref.item) {
  case StateItem::MaterialAmbient:
    return stateVariable(material + ".ambient");
  case StateItem::MaterialDiffuse:
    return stateVariable(material + ".diffuse");
  case StateItem::MaterialSpecular:
    return stateVariable(material + ".specular");
  case StateItem::MaterialEmission:
    return stateVariable(material + ".emission");
  case StateItem::MaterialShininess:
    return expression("vec4(" + material + ".shininess, 0.0, 0.0, 1.0)");
  case StateItem::LightAmbient:
    return stateVariable(light + ".ambient");
  case StateItem::LightDiffuse:
    return stateVariable(light + ".diffuse");
  case StateItem::LightSpecular:
    return stateVariable(light + ".specular");
  case StateItem::LightPosition:
    return stateVariable(light + ".position");
  case StateItem::LightAttenuation:
    return expression("vec4(" + light + ".constantAttenuation, " + light + ".linearAttenuation, " +
                      light + ".quadraticAttenuation, " + light + ".spotExponent)");
  case StateItem::LightSpotDirection:
    return expression("vec4(" + light + ".spotDirection, " + light + ".spotCosCutoff)");
  case StateItem::LightHalf:
    return expression("vec4(normalize(normalize(" + light +
                      ".position.xyz) + vec3(0.0, 0.0, 1.0)), 1.0)");
  case StateItem::LightModelAmbient:
    return stateVariable("gl_LightModel.ambient");
  case StateItem::LightModelSceneColor:
    return expression("vec4(gl_LightModel.ambient.rgb * " + material + ".ambient.rgb + " +
                      material + ".emission.rgb, " + material + ".diffuse.a)");
  case StateItem::LightProdAmbient:
    return lightProduct(light, material, "ambient");
  case StateItem::LightProdDiffuse:
    return lightProduct(light, material, "diffuse");
  case StateItem::LightProdSpecular:
    return lightProduct(light, material, "specular");
  case StateItem::FogColor:
    return stateVariable("gl_Fog.color");
  case StateItem::FogParams:
    return expression("vec4(gl_Fog.density, gl_Fog.start, gl_Fog.end, "
                      "1.0 / (gl_Fog.end - gl_Fog.start))");
  case StateItem::FogFactors:
    return expression("vec4(-gl_Fog.scale, gl_Fog.end * gl_Fog.scale, "
                      "gl_Fog.density * -1.442695041, gl_Fog.density * 1.201122409)");
  case StateItem::DepthRange:
    return expression("vec4(gl_DepthRange.near, gl_DepthRange.far, gl_DepthRange.diff, 1.0)");
  case StateItem::MatrixModelview:
    // No built-in holds modelview[n > 0], which comes from ARB_vertex_blend.
    if (ref.index != 0)
      return std::nullopt;
    return matrixRow("gl_ModelViewMatrix", ref, "");
  case StateItem::MatrixProjection:
    return matrixRow("gl_ProjectionMatrix", ref, "");
  case StateItem::MatrixMvp:
    return matrixRow("gl_ModelViewProjectionMatrix", ref, "");
  case StateItem::MatrixTexture:
    return matrixRow("gl_TextureMatrix", ref, bracket);
  case StateItem::TexGenEye:
    return stateVariable(std::string("gl_EyePlane") + "STRQ"[ref.row & 3] + bracket);
  case StateItem::TexGenObject:
    return stateVariable(std::string("gl_ObjectPlane") + "STRQ"[ref.row & 3] + bracket);
  case StateItem::ClipPlane:
    return stateVariable("gl_ClipPlane" + bracket);
  case StateItem::PointSize:
    return expression("vec4(gl_Point.size, gl_Point.sizeMin, gl_Point.sizeMax, "
                      "gl_Point.fadeThresholdSize)");
  case StateItem::PointAttenuation:
    return expression("vec4(gl_Point.distanceConstantAttenuation, "
                      "gl_Point.distanceLinearAttenuation, "
                      "gl_Point.distanceQuadraticAttenuation, 1.0)");
  case StateItem::TexEnvColor:
  case StateItem::MatrixPalette:
  case StateItem::MatrixProgram:
    return std::nullopt;
  }
  return std::nullopt;
}

} // namespace arbiter::fp::glsl
