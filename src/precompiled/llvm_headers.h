// Headers that nearly every source of the JIT back end includes; standard_headers.h says how they
// are used.

#include "precompiled/standard_headers.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/Module.h>
