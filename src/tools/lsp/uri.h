#pragma once
#include <string>
#include <string_view>

namespace arbiter::tools::lsp {

/// The path of a file's URI (RFC 3986, RFC 8089); empty for any other URI.
[[nodiscard]] std::string pathOf(std::string_view uri);

} // namespace arbiter::tools::lsp
