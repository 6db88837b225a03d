#pragma once
#include "util/defaults/choice.h"
#include "util/json.h"

/// Writes a program's defaults as JSON, for the statistics and for `arbiter defaults --json`.
namespace arbiter::defaults {

/// Writes an entry: title, file, line, match, set, source, note.
void writeEntry(JsonWriter &json, const Entry &entry);

/// Writes {"program": {...}, "entries": [{title, file, line, why}], "settings": {key: {value, file,
/// line, title, used}}, "errors": [...]}, or null if there is no choice. "used" is false if the
/// environment sets the variable and wins.
void writeChoice(JsonWriter &json, const Choice *choice);

} // namespace arbiter::defaults
