#pragma once

/// Texts before any library is initialised, also where there is no C library: nothing is called.
namespace arbiter::interposer {

/// What follows `prefix` in `text`; null where it does not begin so.
inline const char *after(const char *text, const char *prefix) {
  while (*prefix)
    if (*text++ != *prefix++)
      return nullptr;
  return text;
}

inline bool contains(const char *text, const char *part) {
  for (; *text; ++text)
    if (after(text, part))
      return true;
  return false;
}

} // namespace arbiter::interposer
