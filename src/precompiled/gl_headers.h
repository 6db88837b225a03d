// Headers that nearly every source with GL includes; standard_headers.h says how they are used.

#include "precompiled/standard_headers.h"

#include <GL/gl.h>
#include <GL/glext.h>
