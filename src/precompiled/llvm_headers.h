// What nearly every source of the JIT back end reads; standard_headers.h says how it is used.

#include "precompiled/standard_headers.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/Module.h>
