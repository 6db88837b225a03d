#include "fp_compiler/front/header.h"

#include <algorithm>

#include "fp_compiler/front/foreign.h"
#include "fp_compiler/limits.h"

namespace arbiter::fp {

namespace {
/// The hint for a wrong header.
struct HeaderRow {
  std::string_view begin;
  const char *hint;
};

constexpr HeaderRow kHeaders[] = {
    {"!!ARBvp1.0", "this is a vertex program; load it for GL_VERTEX_PROGRAM_ARB"},
    {"!!ARBfp1.0", "this is a fragment program; load it for GL_FRAGMENT_PROGRAM_ARB"},
    {"!!ATIfs1.0", "this is a fragment shader; load it for GL_TEXT_FRAGMENT_SHADER_ATI"},
    {"!!RC1.0", "these are register combiners; no program target takes them"},
    {"!!TS1.0", "these are texture shaders; no program target takes them"},
    {"!!VP", "this is an NV_vertex_program; the profiles from nv10 to nv40, i915 and host have it"},
    {"!!VP2.0", "this is an NV_vertex_program2; the profiles from nv30 to nv40 and host have it"},
    {"!!VP3.0", "NV_vertex_program3 is an option of !!ARBvp1.0, under the profiles nv40 and host"},
    {"!!VSP", "this is NV_vertex_program's state program; the profiles from nv10 to nv40, "
              "i915 and host have it"},
    {"!!FP", "this is an NV_fragment_program; the profiles from nv30 to nv40 and host have it"},
    {"!!FCP", "this is NV_fragment_program's combiner program, which no profile has"},
    {"!!NVfp", "this is an NV_gpu_program4, which no profile has"},
    {"!!NVvp", "this is an NV_gpu_program4, which no profile has"},
    {"\xEF\xBB\xBF", "a byte order mark precedes the header; save the file without one"},
};
} // namespace

bool checkLength(std::string_view text, Reporter &reporter) {
  if (text.size() <= kMaxTextBytes)
    return true;
  reporter.error(DiagnosticId::TextTooLong, {kMaxTextBytes, kMaxTextBytes + 1},
                 "the text is longer than " + std::to_string(kMaxTextBytes) + " bytes",
                 "check the length given; no program needs so much");
  return false;
}

bool checkHeader(std::string_view header, std::string_view text, Reporter &reporter) {
  if (!checkLength(text, reporter))
    return false;
  if (text.starts_with(header))
    return true;
  std::uint32_t wrong = 0;
  while (wrong < text.size() && text[wrong] == header[wrong])
    ++wrong;
  std::string hint = "the first " + std::string(header.size() == 10 ? "ten" : "seven") +
                     " bytes must be " + std::string(header) + ", with nothing before them";
  if (text.empty())
    hint = "the text is empty; the length given was 0";
  else if (text.find(header) < 64)
    hint = "the header is there, but not at the first byte";
  for (const HeaderRow &row : kHeaders)
    if (text.starts_with(row.begin))
      hint = row.hint;
  const Foreign foreign = foreignText(text);
  const bool other = !foreign.kind.empty();
  reporter.error(DiagnosticId::HeaderMissing,
                 {wrong, std::min(wrong + 1, std::uint32_t(text.size()))},
                 other ? "this is " + foreign.kind + ", which Arbiter does not read"
                       : "the header " + std::string(header) + " is missing",
                 other ? std::string(foreign.advice) : std::move(hint));
  return false;
}

std::uint32_t endOfWrongHeader(std::string_view text) {
  if (!text.starts_with("!"))
    return 0;
  return std::uint32_t(std::min(text.find_first_of("\r\n"), text.size()));
}

} // namespace arbiter::fp
