// What nearly every source of a report or of the language server reads; standard_headers.h says how
// it is used.

#include "precompiled/standard_headers.h"

#include <nlohmann/json.hpp>
