#pragma once

/// Text functions for code that runs before any library is initialised, or without a C library.
/// They call nothing.
namespace arbiter::interposer {

/// Returns the part of `text` after `prefix`; null if it does not begin with it.
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
