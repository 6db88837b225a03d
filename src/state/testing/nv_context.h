#pragma once
#include <string_view>

#include "state/testing/current_context.h"

/// Contexts with NVIDIA's languages. The profile of the test's environment has them, and the host
/// supports what their programs need.
namespace arbiter::state::testing {

/// A fake host whose GLSL can draw programs in NVIDIA's languages.
class NvHost : public FakeHost {
public:
  NvHost() {
    for (const char *name :
         {"GL_EXT_gpu_shader4", "GL_ARB_shader_bit_encoding", "GL_ARB_shader_texture_lod"})
      extensions.emplace_back(name);
  }
};

inline constexpr GLenum kNvFragment = GL_FRAGMENT_PROGRAM_NV;
inline constexpr GLenum kNvVertex = GL_VERTEX_PROGRAM_NV;
inline constexpr GLenum kNvState = GL_VERTEX_STATE_PROGRAM_NV;

inline constexpr std::string_view kVp = "!!VP1.0\nMOV o[HPOS], v[OPOS];\nEND";
inline constexpr std::string_view kFp =
    "!!FP1.0\nDECLARE blue = {1,2,3,4};\nMOV o[COLR], blue;\nEND";
inline constexpr std::string_view kVsp = "!!VSP1.0\nMOV c[90], v[0];\nEND";

inline void loadNv(Context &context, GLenum target, GLuint id, std::string_view text) {
  handlers::LoadProgramNV(context, target, id, GLsizei(text.size()),
                          reinterpret_cast<const GLubyte *>(text.data()));
}

/// Returns the error since the last call.
inline GLenum error(Context &context) { return handlers::GetError(context); }
inline constexpr GLenum kNoError = GL_NO_ERROR, kEnum = GL_INVALID_ENUM, kValue = GL_INVALID_VALUE,
                        kOperation = GL_INVALID_OPERATION;

/// Returns the error of a command between Begin and End.
template <typename Function> GLenum errorInsideBegin(Context &context, Function &&command) {
  context.insideBeginEnd = true;
  command();
  context.insideBeginEnd = false;
  return error(context);
}

inline Vec4 parameter(Context &context, GLuint index) {
  Vec4 value{};
  handlers::GetProgramParameterfvNV(context, kNvVertex, index, GL_PROGRAM_PARAMETER_NV,
                                    value.data());
  return value;
}

} // namespace arbiter::state::testing
