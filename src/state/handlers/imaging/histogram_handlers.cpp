// Histograms and minmax tables (ARB_imaging), for hosts without them.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/imaging/count_packing.h"
#include "state/imaging/formats.h"
#include "state/imaging/imaging_state.h"
#include "state/imaging/pixel_types.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/pixel_commands/imaging_queries.h"

namespace arbiter::state {

namespace {

using Kind = ImagingCommand::Kind;

bool histogramAllowed(Context &context) {
  return outsideBeginEnd(context, "a histogram's or minmax table's command between Begin and End");
}

template <typename T>
void getHistogramParameter(Context &context, GLenum target, GLenum pname, T *params) {
  if (!histogramAllowed(context))
    return;
  const ImagingState &state = *context.imaging;
  if (target != GL_HISTOGRAM && target != GL_PROXY_HISTOGRAM)
    return raise(context, GL_INVALID_ENUM, "GetHistogramParameter: target");
  const imaging::Histogram &histogram = state.contents.histogram;
  const ProxyTable about =
      target == GL_PROXY_HISTOGRAM
          ? state.proxyHistogram
          : ProxyTable{histogram.format, GLsizei(histogram.bins.size()), histogram.sink};
  if (pname == GL_HISTOGRAM_WIDTH) {
    *params = T(about.width);
  } else if (pname == GL_HISTOGRAM_FORMAT) {
    *params = T(GLint(about.format));
  } else if (pname == GL_HISTOGRAM_SINK) {
    *params = T(about.sink ? GL_TRUE : GL_FALSE);
  } else if (pname - GL_HISTOGRAM_RED_SIZE < 5u) {
    // The components that the format has get counters of 32 bits.
    const imaging::Format *const format = imaging::findFormat(about.format);
    const GLenum row = pname - GL_HISTOGRAM_RED_SIZE;
    *params = T(format && about.width != 0 && format->bits[row] != 0 ? 32 : 0);
  } else {
    raise(context, GL_INVALID_ENUM, "GetHistogramParameter: pname");
  }
}

template <typename T>
void getMinmaxParameter(Context &context, GLenum target, GLenum pname, T *params) {
  if (!histogramAllowed(context))
    return;
  const imaging::Minmax &minmax = context.imaging->contents.minmax;
  if (target != GL_MINMAX || (pname != GL_MINMAX_FORMAT && pname != GL_MINMAX_SINK))
    return raise(context, GL_INVALID_ENUM, "GetMinmaxParameter: target or pname");
  *params =
      pname == GL_MINMAX_FORMAT ? T(GLint(minmax.format)) : T(minmax.sink ? GL_TRUE : GL_FALSE);
}

/// Runs `function` for each component that a query returns and resets.
template <typename F> void eachReturned(GLenum format, F function) {
  for (const int component : componentsOfQuery(format))
    function(std::size_t(component));
}

} // namespace

namespace handlers {

void Histogram(Context &context, GLenum target, GLsizei width, GLenum internalformat,
               GLboolean sink) {
  if (!histogramAllowed(context))
    return;
  const ImagingCommand command{.kind = Kind::Histogram,
                               .flag = sink != GL_FALSE,
                               .target = target,
                               .pname = internalformat,
                               .width = width};
  if (target == GL_PROXY_HISTOGRAM)
    executeImaging(context, command, {});
  else
    issueImaging(context, command);
}

void Minmax(Context &context, GLenum target, GLenum internalformat, GLboolean sink) {
  if (histogramAllowed(context))
    issueImaging(context, {.kind = Kind::Minmax,
                           .flag = sink != GL_FALSE,
                           .target = target,
                           .pname = internalformat});
}

void ResetHistogram(Context &context, GLenum target) {
  if (!histogramAllowed(context))
    return;
  if (target != GL_HISTOGRAM)
    return raise(context, GL_INVALID_ENUM, "ResetHistogram: target");
  issueImaging(context, {.kind = Kind::Reset, .target = target});
}

void ResetMinmax(Context &context, GLenum target) {
  if (!histogramAllowed(context))
    return;
  if (target != GL_MINMAX)
    return raise(context, GL_INVALID_ENUM, "ResetMinmax: target");
  issueImaging(context, {.kind = Kind::Reset, .target = target});
}

void GetHistogram(Context &context, GLenum target, GLboolean reset, GLenum format, GLenum type,
                  void *values) {
  if (!histogramAllowed(context))
    return;
  if (target != GL_HISTOGRAM)
    return raise(context, GL_INVALID_ENUM, "GetHistogram: target");
  std::vector<imaging::Counts> &bins = context.imaging->contents.histogram.bins;
  if (!packCounts(context, bins, format, type, values) || reset == GL_FALSE)
    return;
  eachReturned(format, [&](std::size_t component) {
    for (imaging::Counts &bin : bins)
      bin[component] = 0;
  });
}

void GetMinmax(Context &context, GLenum target, GLboolean reset, GLenum format, GLenum type,
               void *values) {
  if (!histogramAllowed(context))
    return;
  if (target != GL_MINMAX)
    return raise(context, GL_INVALID_ENUM, "GetMinmax: target");
  imaging::Minmax &minmax = context.imaging->contents.minmax;
  const imaging::Base base = imaging::baseOf(minmax.format);
  const imaging::Pixels both{2, 1, 1, {select(base, minmax.least), select(base, minmax.most)}};
  if (!returnImage(context, minmax.format, both, format, type, values) || reset == GL_FALSE)
    return;
  eachReturned(format, [&](std::size_t component) {
    minmax.least[component] = imaging::Minmax::kMax;
    minmax.most[component] = -imaging::Minmax::kMax;
  });
}

void GetHistogramParameterfv(Context &context, GLenum target, GLenum pname, GLfloat *params) {
  getHistogramParameter(context, target, pname, params);
}

void GetHistogramParameteriv(Context &context, GLenum target, GLenum pname, GLint *params) {
  getHistogramParameter(context, target, pname, params);
}

void GetMinmaxParameterfv(Context &context, GLenum target, GLenum pname, GLfloat *params) {
  getMinmaxParameter(context, target, pname, params);
}

void GetMinmaxParameteriv(Context &context, GLenum target, GLenum pname, GLint *params) {
  getMinmaxParameter(context, target, pname, params);
}

} // namespace handlers
} // namespace arbiter::state
