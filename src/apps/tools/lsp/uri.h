#pragma once
#include <string>
#include <string_view>

namespace arbiter::tools::lsp {

/// Returns the path of a file URI (RFC 3986, RFC 8089), or "" for other URIs.
[[nodiscard]] std::string pathOf(std::string_view uri);

} // namespace arbiter::tools::lsp
