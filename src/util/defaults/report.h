#pragma once
#include "util/defaults/choice.h"
#include "util/json.h"

/// A program's defaults as JSON: of the statistics, and of `arbiter defaults --json`.
namespace arbiter::defaults {

/// An entry: title, file, line, match, set, source, note.
void writeEntry(JsonWriter &json, const Entry &entry);

/// {"program": {...}, "entries": [{title, file, line, why}], "settings": {key: {value, file, line,
/// title, used}}, "errors": [...]}; null for no choice. "used" is false where the environment has
/// the variable, which then wins.
void writeChoice(JsonWriter &json, const Choice *choice);

} // namespace arbiter::defaults
