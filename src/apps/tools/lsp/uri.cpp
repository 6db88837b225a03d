#include "apps/tools/lsp/uri.h"

namespace arbiter::tools::lsp {

namespace {

int hexDigit(char digit) {
  return digit >= '0' && digit <= '9'   ? digit - '0'
         : digit >= 'a' && digit <= 'f' ? digit - 'a' + 10
         : digit >= 'A' && digit <= 'F' ? digit - 'A' + 10
                                        : -1;
}

} // namespace

std::string pathOf(std::string_view uri) {
  constexpr std::string_view kScheme = "file://";
  std::string path;
  if (!uri.starts_with(kScheme) || uri.size() == kScheme.size() || uri[kScheme.size()] != '/')
    return path;
  uri.remove_prefix(kScheme.size());
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = high < 0 ? -1 : hexDigit(uri[i + 2]);
    path += low < 0 ? uri[i] : char(16 * high + low);
    i += low < 0 ? 0 : 2;
  }
  return path;
}

} // namespace arbiter::tools::lsp
