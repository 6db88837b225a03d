// Headers that nearly every source of reports or of the language server includes;
// standard_headers.h says how they are used.

#include "precompiled/standard_headers.h"

#include <nlohmann/json.hpp>
