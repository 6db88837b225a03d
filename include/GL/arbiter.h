/* Arbiter: a driver layer for OpenGL that implements the assembly-program extensions.
 *
 * Arbiter has no API of its own to link to: an application calls plain OpenGL and finds
 * GL_ARB_fragment_program in its extension string. This header is for programs that start others
 * under Arbiter, and states what they may rely on. It is C89 and needs no GL header.
 *
 * Starting a program under Arbiter (what `arbiter run` does):
 *   LD_PRELOAD       contains the path of libGLX_arbiter.so.0
 *                    (pkg-config --variable=preload arbiter). Its constructor selects the layer
 *                    for GLX and EGL through libglvnd.
 *   LD_LIBRARY_PATH  begins with the folder of the front libOSMesa.so.8
 *                    (pkg-config --variable=osmesadir arbiter), for programs that load OSMesa.
 * Child processes inherit both. In a set-user-id program neither has any effect.
 *
 * The variables below control the layer; arbiter(7) lists their values. They are read once, when
 * the library is loaded or first used. An invalid value is reported in the log and ignored. If one
 * is not set, a default for the program may apply (arbiter-defaults(5)).
 */
#ifndef GL_ARBITER_H
#define GL_ARBITER_H

#define ARBITER_VERSION_MAJOR 1
#define ARBITER_VERSION_MINOR 0
#define ARBITER_VERSION_PATCH 0

/* major * 10000 + minor * 100 + patch */
#define ARBITER_VERSION                                                                            \
  (ARBITER_VERSION_MAJOR * 10000 + ARBITER_VERSION_MINOR * 100 + ARBITER_VERSION_PATCH)

/* "major.minor.patch" */
#define ARBITER_TEXT_OF(x) #x
#define ARBITER_TEXT(x) ARBITER_TEXT_OF(x)
#define ARBITER_VERSION_TEXT                                                                       \
  ARBITER_TEXT(ARBITER_VERSION_MAJOR)                                                              \
  "." ARBITER_TEXT(ARBITER_VERSION_MINOR) "." ARBITER_TEXT(ARBITER_VERSION_PATCH)

/* The file name of the library to preload, which is also its soname. */
#define ARBITER_PRELOAD_LIBRARY "libGLX_arbiter.so.0"

/* Names of the environment variables. */
#define ARBITER_ENV_PROFILE "ARBITER_PROFILE"
#define ARBITER_ENV_LIMITS "ARBITER_LIMITS"
#define ARBITER_ENV_NUMERICS "ARBITER_NUMERICS"
#define ARBITER_ENV_BACKEND "ARBITER_BACKEND"
#define ARBITER_ENV_FIXED_FUNCTION "ARBITER_FIXED_FUNCTION"
#define ARBITER_ENV_ATTRIBUTES "ARBITER_ATTRIBUTES"
#define ARBITER_ENV_THREADS "ARBITER_THREADS"
#define ARBITER_ENV_CPU "ARBITER_CPU"
#define ARBITER_ENV_JIT_LIBRARY "ARBITER_JIT_LIBRARY"
#define ARBITER_ENV_IDENTITY "ARBITER_IDENTITY"
#define ARBITER_ENV_EXTENSIONS_MAX_YEAR "ARBITER_EXTENSIONS_MAX_YEAR"
#define ARBITER_ENV_EXTENSIONS_MAX_LENGTH "ARBITER_EXTENSIONS_MAX_LENGTH"
#define ARBITER_ENV_EXTENSIONS "ARBITER_EXTENSIONS"
#define ARBITER_ENV_DEFAULTS "ARBITER_DEFAULTS"
#define ARBITER_ENV_CACHE "ARBITER_CACHE"
#define ARBITER_ENV_CACHE_MAX_MB "ARBITER_CACHE_MAX_MB"
#define ARBITER_ENV_STATS "ARBITER_STATS"
#define ARBITER_ENV_LOG "ARBITER_LOG"
#define ARBITER_ENV_CAPTURE "ARBITER_CAPTURE"
#define ARBITER_ENV_REPLACE "ARBITER_REPLACE"
#define ARBITER_ENV_CONTROL "ARBITER_CONTROL"
#define ARBITER_ENV_HUD "ARBITER_HUD"
#define ARBITER_ENV_DEBUG "ARBITER_DEBUG"
#define ARBITER_ENV_HOST_VENDOR "ARBITER_HOST_VENDOR"
#define ARBITER_ENV_HOST_OSMESA "ARBITER_HOST_OSMESA"

/* The "schema" number at the top of each JSON document that Arbiter writes, and the number of the
 * protocol of control. A number grows when a member changes its meaning or is removed; a new member
 * does not change it. All writers take them from here. STATS is of what ARBITER_STATS and
 * `arbiter run --stats` write, STATS_SUM of `arbiter stats`, CAPTURE of index.json and
 * process-*.json. The others have the names of verbs. */
#define ARBITER_STATS_SCHEMA 4
#define ARBITER_STATS_SUM_SCHEMA 2
#define ARBITER_CAPTURE_SCHEMA 2
#define ARBITER_CHECK_SCHEMA 2
#define ARBITER_COMPILE_SCHEMA 2
#define ARBITER_DEBUG_SCHEMA 2
#define ARBITER_REPORT_SCHEMA 2
#define ARBITER_CACHE_SCHEMA 1
#define ARBITER_DEFAULTS_SCHEMA 1
#define ARBITER_DOCTOR_SCHEMA 1
#define ARBITER_DRAW_SCHEMA 1
#define ARBITER_PROFILES_SCHEMA 1
#define ARBITER_CONTROL_PROTOCOL 1

/* GL_ARBITER_feedback is in the extension string of contexts whose programs Arbiter implements. It
 * adds no command: applications use glReadBuffer and glCopyTexSubImage2D as always. If the
 * rasterizer draws, a copy of a whole color buffer shares its pixels instead of moving them. Two
 * values of glGetIntegerv count the context's copies; they never exceed 2^31 - 1. */
#ifndef GL_ARBITER_feedback
#define GL_ARBITER_feedback 1
/* The number of copies to textures so far. */
#define GL_FEEDBACK_COPIES_ARBITER 0x41524200
/* The number of copies in the share group that moved no pixel. */
#define GL_FEEDBACK_COPIES_AVOIDED_ARBITER 0x41524201
#endif

#endif /* GL_ARBITER_H */
