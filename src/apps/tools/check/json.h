#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"
#include "util/json.h"

/// Writes the JSON of `arbiter check`: ARBITER_CHECK_SCHEMA of GL/arbiter.h, described in
/// arbiter(1).
namespace arbiter::tools {

/// Writes "schema" and "profile" into the open object of a document.
void writeHead(JsonWriter &json, const fp::hw::Profile &profile);

/// Writes one element of "files", with the file's `native` if it exists.
/// \param profile to name in the element if files of the document have different ones; else nullptr
void writeFile(JsonWriter &json, const CheckedFile &file, const fp::hw::Profile *profile = nullptr);

/// Writes "diagnostics" of a text into an open object.
void writeDiagnostics(JsonWriter &json, std::string_view text,
                      const std::vector<fp::Diagnostic> &diagnostics);

/// Returns the model's name as in profiles: "documented", "r300".
[[nodiscard]] std::string name(fp::NativeModel model);

} // namespace arbiter::tools
