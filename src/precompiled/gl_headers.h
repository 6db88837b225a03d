// What nearly every source that speaks GL reads; standard_headers.h says how it is used.

#include "precompiled/standard_headers.h"

#include <GL/gl.h>
#include <GL/glext.h>
