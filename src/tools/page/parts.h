#pragma once
#include <string_view>

/// What embed.py makes of page.css and page.js.
namespace arbiter::tools {

extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kPageScriptHash; ///< "sha256-...", for Content-Security-Policy

} // namespace arbiter::tools
