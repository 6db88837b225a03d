// Headers that every unit test includes; standard_headers.h says how they are used. The tests of a
// room are compiled as one library, and each program links its own objects of it, so that these
// headers are read once for each room.

#include "precompiled/standard_headers.h"

#include <gtest/gtest.h>
#include <map>
#include <set>
