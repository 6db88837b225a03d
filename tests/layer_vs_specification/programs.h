#pragma once
#include <array>
#include <string>
#include <vector>

#include <epoxy/gl.h>

/// Shared parts of the program API's tests: they load programs, draw a quad and read a pixel in the
/// current context, by libepoxy.
namespace api {

using Pixel = std::array<int, 4>;
using Picture = std::vector<GLubyte>;

inline constexpr GLenum kFragment = GL_FRAGMENT_PROGRAM_ARB;
inline constexpr GLenum kVertex = GL_VERTEX_PROGRAM_ARB;
inline constexpr char kRed[] = "!!ARBfp1.0\nMOV result.color, {1,0,0,1};\nEND";
inline constexpr char kGreen[] = "!!ARBfp1.0\nMOV result.color, {0,1,0,1};\nEND";
inline constexpr char kEnv0[] = "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND";
inline constexpr char kLocal0[] = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND";
inline constexpr char kBad[] = "!!ARBfp1.0\nMOV result.color, nothing;\nEND";
inline constexpr Pixel kBlack = {0, 0, 0, 0};
inline constexpr Pixel kRedPixel = {255, 0, 0, 255};
inline constexpr Pixel kGreenPixel = {0, 255, 0, 255};
inline constexpr Pixel kBluePixel = {0, 0, 255, 255};

void load(const std::string &text, GLenum target = kFragment);
/// Makes and binds a program object with that text.
GLuint makeProgram(const std::string &text, GLenum target = kFragment);
GLint programiv(GLenum pname, GLenum target = kFragment);
GLint integer(GLenum pname);
/// Clears to zero, then draws a quad over everything in blue (if nothing else shades it).
void drawQuad();
void clear();
Pixel readPixel(int x = 16, int y = 16);
/// Returns the bytes of `size` rows of as many RGBA pixels.
Picture readPicture(int size);
/// Calls clear(), drawQuad() and readPixel().
Pixel drawn();
/// Links a GLSL program of the stages whose text is given.
GLuint makeGlsl(const char *vertex, const char *fragment);

} // namespace api
