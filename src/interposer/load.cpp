/// What must be so before any entry point can run.
#include "host/null_host.h"
#include "state/lifecycle.h"

namespace arbiter::interposer {

namespace {

// Before the selection in process.cpp and before any other library of the process can call us.
[[gnu::constructor(101)]] void giveNullContextItsTable() { state::setNullTable(&host::kNullHost); }

} // namespace

} // namespace arbiter::interposer
