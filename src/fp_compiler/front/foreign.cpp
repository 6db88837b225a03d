#include "fp_compiler/front/foreign.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "util/text/letters.h"

namespace arbiter::fp {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kCompile =
    "Arbiter reads OpenGL's assembly programs; a compiler makes one of it: cgc -profile arbfp1, or "
    "arbvp1 of a vertex shader";
constexpr std::string_view kCompileGlsl =
    "Arbiter reads OpenGL's assembly programs; a compiler makes one of it: cgc -oglsl -profile "
    "arbfp1, or arbvp1 of a vertex shader";
constexpr std::string_view kCapture =
    "Arbiter reads OpenGL's assembly programs; Wine makes them of it where its shader_backend is "
    "arb, and arbiter capture writes what a game loads";
constexpr std::string_view kSpirv =
    "Arbiter reads OpenGL's assembly programs; SPIR-V is of later cards";
constexpr std::string_view kPicture = "arbiter draw --texture 0=FILE draws a program with it";
constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kSave = "save the file as ASCII or UTF-8, without a byte order mark";

struct Magic {
  std::string_view begin;
  std::string_view kind;
  std::string_view advice;
};
constexpr Magic kMagics[] = {
    {"\x7F"
     "ELF"sv,
     "an ELF file", "arbiter run -- FILE runs an application"},
    {"\x03\x02\x23\x07"sv, "a SPIR-V module", kSpirv},
    {"\x07\x23\x02\x03"sv, "a SPIR-V module", kSpirv},
    {"DXBC"sv, "compiled HLSL (DXBC)", kCapture},
    {"\x89PNG"sv, "a PNG picture", kPicture},
    {"\xFF\xD8\xFF"sv, "a JPEG picture", kPicture},
    {"DDS "sv, "a DDS picture", kPicture},
    {"GIF8"sv, "a GIF picture", "arbiter draw takes PNG, JPEG and DDS files as textures"},
    {"PK\x03\x04"sv, "a ZIP archive", kUnpack},
    {"\x1F\x8B"sv, "a file of gzip", kUnpack},
    {"\xFF\xFE"sv, "text in UTF-16", kSave},
    {"\xFE\xFF"sv, "text in UTF-16", kSave},
    {"[require]"sv, "a shader_test of piglit",
     "the program is what stands below [fragment program] or [vertex program], to END"},
    {"; SPIR-V"sv, "SPIR-V assembly", kSpirv},
};

/// The number of bytes that are examined. They are enough to recognise a text.
constexpr std::size_t kLooked = 64u << 10;
/// The longest name of a shader version that is shown, in bytes: "ps_2_x" has 6.
constexpr std::size_t kMaxVersion = 8;

/// Words that begin a statement of an assembly program and do not occur in the languages below.
constexpr std::string_view kStatements[] = {
    "ABS",
    "ADD",
    "ADDRESS",
    "ALIAS",
    "ARL",
    "ATTRIB",
    "CMP",
    "COS",
    "DP3",
    "DP4",
    "DPH",
    "DST",
    "END",
    "EX2",
    "EXP",
    "FLR",
    "FRC",
    "KIL",
    "LG2",
    "LIT",
    "LOG",
    "LRP",
    "MAD",
    "MAX",
    "MIN",
    "MOV",
    "MUL",
    "OPTION",
    "OUTPUT",
    "PARAM",
    "POW",
    "RCP",
    "RSQ",
    "SCS",
    "SGE",
    "SIN",
    "SLT",
    "SUB",
    "SWZ",
    "TEMP",
    "TEX",
    "TXB",
    "TXP",
    "XPD",
    "StartConstants",
    "StartPrelimPass",
    "StartOutputPass",
};

bool isOneOf(std::string_view word, std::span<const std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isOfWord(char c) { return isLetterOrDigit(c) || c == '_'; }

/// The signs of each language among a text's words.
struct Seen {
  bool assembly = false; ///< a statement of a program
  /// The first word, if it is a version of Direct3D's shader assembly: "ps_2_0".
  std::string_view direct3d;
  bool glsl = false; ///< a word that GLSL alone has
  bool hlsl = false;
  bool cg = false;
  bool cgOrHlsl = false;
  bool vectors = false; ///< vec4 and the like, which GLSL has
  bool main = false;    ///< void main
};

constexpr std::string_view kGlslVectors[] = {"vec2", "vec3", "vec4", "mat3", "mat4", "ivec2"};
constexpr std::string_view kVectors[] = {"float2", "float3", "float4",   "half2",    "half3",
                                         "half4",  "int4",   "float3x3", "float4x4", "float4x3"};
constexpr std::string_view kCgWords[] = {"samplerRECT", "texRECT",   "fixed2",  "fixed3",
                                         "fixed4",      "tex2Dproj", "f4tex2D", "half4x4"};
constexpr std::string_view kHlslWords[] = {
    "cbuffer",   "SV_Target",    "SV_POSITION", "SV_Position",   "SV_TARGET", "SV_Target0",
    "Texture2D", "SamplerState", "technique",   "sampler_state", "register"};

/// True for a version such as "ps_2_0" or "vs.1.1".
bool isVersion(std::string_view word, std::string_view behind) {
  const bool stage = word.starts_with("ps") || word.starts_with("vs");
  if (!stage)
    return false;
  if (word.size() == 2)
    return behind.size() > 1 && behind[0] == '.' && isDigit(behind[1]);
  return word.size() >= 6 && word[2] == '_' && isDigit(word[3]) && word[4] == '_';
}

void look(Seen &seen, std::string_view word, bool statement, std::string_view before) {
  seen.assembly = seen.assembly || (statement && isOneOf(word, kStatements));
  seen.glsl = seen.glsl || word.starts_with("gl_Frag") || word.starts_with("gl_Pos") ||
              word.starts_with("gl_Tex") || word.starts_with("gl_Vert") ||
              word.starts_with("gl_Mod");
  seen.vectors = seen.vectors || isOneOf(word, kGlslVectors);
  seen.cgOrHlsl = seen.cgOrHlsl || isOneOf(word, kVectors);
  seen.cg = seen.cg || isOneOf(word, kCgWords);
  seen.hlsl = seen.hlsl || isOneOf(word, kHlslWords);
  seen.main = seen.main || (word == "main" && before == "void");
}

/// Finds the signs in the text's words, outside of comments. A `#` begins a comment of an assembly
/// program, or a directive of the other languages. Of such lines only `#version` counts.
Seen wordsOf(std::string_view text) {
  Seen seen;
  bool statement = true; // may begin here
  bool first = true;
  std::string_view before;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const std::size_t line = std::min(rest.find_first_of("\r\n"), rest.size());
    if (rest[0] == '#' || rest.starts_with("//")) {
      seen.glsl = seen.glsl || rest.starts_with("#version ");
      at += line;
    } else if (rest.starts_with("/*")) {
      at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
    } else if (isOfWord(rest[0])) {
      const auto *const end = std::find_if_not(rest.begin(), rest.end(), isOfWord);
      const std::string_view word = rest.substr(0, std::size_t(end - rest.begin()));
      if (first && isVersion(word, rest.substr(word.size())))
        seen.direct3d = rest.substr(0, rest.find_first_of(" \t\r\n;/"));
      look(seen, word, statement, before);
      before = word;
      first = statement = false;
      at += word.size();
    } else {
      // A program's header may lack the semicolon, and may be wrong.
      statement = rest[0] == ';' || rest[0] == '\n' || rest[0] == '\r' ||
                  (statement && (rest[0] == ' ' || rest[0] == '\t'));
      ++at;
    }
  }
  return seen;
}

} // namespace

Foreign foreignText(std::string_view text) {
  for (const Magic &magic : kMagics)
    if (text.starts_with(magic.begin))
      return {std::string(magic.kind), magic.advice};
  text = text.substr(0, kLooked);
  if (text.substr(0, 512).find('\0') != std::string_view::npos)
    return {"a binary file", "Arbiter reads programs as text"};
  if (text.find("!!") != std::string_view::npos)
    return {};
  const Seen seen = wordsOf(text);
  if (seen.assembly)
    return {};
  if (!seen.direct3d.empty())
    return {"Direct3D's shader assembly (" + std::string(seen.direct3d.substr(0, kMaxVersion)) +
                ")",
            kCapture};
  if (seen.glsl || (seen.vectors && seen.main))
    return {"GLSL", kCompileGlsl};
  if (seen.hlsl && (seen.cgOrHlsl || seen.main))
    return {"HLSL", kCompile};
  if (seen.cg)
    return {"Cg", kCompile};
  return seen.cgOrHlsl ? Foreign{"Cg or HLSL", kCompile} : Foreign{};
}

} // namespace arbiter::fp
