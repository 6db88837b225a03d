#include "fp_compiler/front/c_like/names.h"

#include <algorithm>
#include <iterator>

namespace arbiter::fp::c_like {

namespace {

struct NameRow {
  std::string_view name, of;
  std::string_view forms[kDialectCount];
};
constexpr NameRow kNames[] = {
#define C_NAME(name, of, ...) {name, of, {__VA_ARGS__}},
#define C_FORM(Kind, ...)
#include "fp_compiler/front/c_like/names.def"
};
constexpr std::string_view kForms[][kDialectCount] = {
#define C_NAME(name, of, ...)
#define C_FORM(Kind, ...) {__VA_ARGS__},
#include "fp_compiler/front/c_like/names.def"
};

constexpr std::string_view kDigits = "0123456789";

std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
  std::string result(text);
  for (std::size_t at = result.find(what); at != std::string::npos;
       at = result.find(what, at + by.size()))
    result.replace(at, what.size(), by);
  return result;
}

/// A row, and the number that '#' stands for.
struct Found {
  const NameRow *row = nullptr;
  std::string_view number;
};

Found find(std::string_view name) {
  const std::size_t last = name.find_last_not_of(kDigits);
  const std::size_t stem = last == std::string_view::npos ? 0 : last + 1;
  const std::string numbered = std::string(name.substr(0, stem)) + "#";
  for (const NameRow &row : kNames)
    if (row.name == name || (stem < name.size() && row.name == numbered))
      return {&row, name.substr(stem)};
  return {};
}

std::string formOf(const Found &found, Dialect dialect) {
  return replaced(found.row->forms[int(dialect)], "#", found.number);
}

} // namespace

std::string nameHint(std::string_view name, Dialect dialect) {
  const Found found = find(name);
  if (!found.row)
    return {};
  const std::string form = formOf(found, dialect);
  const std::string whose = std::string(name) + " is " + std::string(found.row->of);
  return form.empty() ? whose + ", and there is nothing like it here"
                      : whose + "; the assembly " + form;
}

std::string registerOf(std::string_view name, Dialect dialect) {
  const Found found = find(name);
  if (!found.row)
    return {};
  const std::string form = formOf(found, dialect);
  if (!form.starts_with("reads ") && !form.starts_with("writes "))
    return {};
  const std::size_t begin = form.find(' ') + 1;
  return form.substr(begin, form.find_first_of(" ,", begin) - begin);
}

std::string fourComponents(std::string_view suffix) {
  constexpr std::string_view kTheirs = "stpq", kOurs = "xyzw";
  if (suffix.empty() || suffix.size() > 4 ||
      suffix.find_first_not_of("xyzwrgbastpq") != std::string_view::npos)
    return {};
  std::string result;
  for (const char c : suffix) {
    const std::size_t their = kTheirs.find(c);
    result += their == std::string_view::npos ? c : kOurs[their];
  }
  while (result.size() > 1 && result.size() < 4)
    result += result.back();
  return result;
}

std::string formHint(Form form, Dialect dialect, std::string_view name, std::string_view value) {
  return replaced(replaced(kForms[int(form)][int(dialect)], "$n", name), "$v", value);
}

} // namespace arbiter::fp::c_like
