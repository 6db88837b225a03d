// What every unit test reads; standard_headers.h says how it is used. Tests of one room are
// compiled as one library, and each program takes its own objects of it, so that this is read once
// a room.

#include "precompiled/standard_headers.h"

#include <gtest/gtest.h>
#include <map>
#include <set>
