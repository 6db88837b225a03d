#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "fp_compiler/front/words/keywords.h"

/// Classifies the words of NVIDIA's options (NV_fragment_program_option, NV_fragment_program2,
/// NV_vertex_program2_option, NV_vertex_program3), and the opcodes of its own languages.
namespace arbiter::fp::nv {

/// True if programs of \p language under \p option have the opcode.
[[nodiscard]] bool offers(const ArbLanguage &language, ir::NvOption option, ir::Opcode op);

/// Returns the opcode with the longest name that an identifier begins with; nothing if there is
/// none.
[[nodiscard]] std::optional<ir::Opcode> baseOf(std::string_view identifier,
                                               const ArbLanguage &language, ir::NvOption option);

/// Returns the reserved word that an identifier is under \p option, which is not None. Every
/// spelling of an opcode is reserved (ADDR, DDXC_SAT). The longest opcode name wins (DP2A, not
/// DP2).
[[nodiscard]] Word classify(std::string_view identifier, const ArbLanguage &language,
                            ir::NvOption option);

// These functions do the same for NVIDIA's own languages. DEFINE and DECLARE are Keyword::Param,
// and names of registers are free words.
[[nodiscard]] bool offers(ir::NativeLanguage language, ir::Opcode op);
[[nodiscard]] std::optional<ir::Opcode> baseOf(std::string_view identifier,
                                               ir::NativeLanguage language);
[[nodiscard]] Word classify(std::string_view identifier, ir::NativeLanguage language);

/// A rule of a condition code test (section 3.11.3.X).
enum class Rule : std::uint8_t { Eq, Ge, Gt, Le, Lt, Ne, Tr, Fl };
/// Returns the rule of a word such as "EQ"; nothing for any other word.
[[nodiscard]] std::optional<Rule> ruleOf(std::string_view word);

} // namespace arbiter::fp::nv
