#pragma once
#include <string_view>

/// The contents of page.css and page.js, embedded by embed.py.
namespace arbiter::tools {

extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kPageScriptHash; ///< "sha256-...", for Content-Security-Policy

} // namespace arbiter::tools
