#pragma once
#include <string>

#include "tools/check/checked_file.h"
#include "util/json.h"

/// The JSON of `arbiter check`: ARBITER_CHECK_SCHEMA of GL/arbiter.h, described in arbiter(1).
namespace arbiter::tools {

/// "schema" and "profile" of a document whose object is open.
void writeHead(JsonWriter &json, const fp::hw::Profile &profile);

/// One element of "files". What `native` of the file holds is written, if it is there.
/// \param profile named in the element, where the document has files of several; else nullptr
void writeFile(JsonWriter &json, const CheckedFile &file, const fp::hw::Profile *profile = nullptr);

/// "diagnostics" of a text, whose object is open.
void writeDiagnostics(JsonWriter &json, std::string_view text,
                      const std::vector<fp::Diagnostic> &diagnostics);

/// The model's name, as a profile says it: "documented", "r300".
[[nodiscard]] std::string name(fp::NativeModel model);

} // namespace arbiter::tools
