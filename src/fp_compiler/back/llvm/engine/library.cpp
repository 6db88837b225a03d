// The library's side of jit_boundary.h. Handles own the engine's objects, and results are plain
// data. No exception reaches the caller.

#include <algorithm>
#include <cstring>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/jit_boundary.h"
#include "fp_compiler/jit_fields.h"
#include "fp_compiler/jit_version.h"
#include "util/unwinder.h"

namespace arbiter::fp::jit::boundary {

struct EngineHandle {
  std::unique_ptr<Engine> engine;
};
struct FragmentHandle {
  std::unique_ptr<FragmentProgram> program;
};
struct VertexHandle {
  std::unique_ptr<VertexProgram> program;
};
struct CodeHandle {
  std::unique_ptr<FragmentCode> fragment;
  std::unique_ptr<VertexCode> vertex;
};
struct BytesHandle {
  std::string bytes;
};

namespace {

template <std::size_t N> void copyText(char (&to)[N], std::string_view text) {
  const std::size_t length = std::min(text.size(), N - 1);
  std::memcpy(to, text.data(), length);
  to[length] = '\0';
}

std::string stringOf(Bytes bytes) {
  return bytes.size ? std::string(bytes.data, bytes.size) : std::string();
}

/// Returns the result of `make`, or null if it throws. `reason` may be null.
template <typename F> auto guarded(Reason *reason, F make) noexcept -> decltype(make()) {
  try {
    return make();
  } catch (const std::exception &error) {
    if (reason)
      copyText(reason->text, error.what());
  } catch (...) {
    if (reason)
      copyText(reason->text, "an unknown exception");
  }
  return nullptr;
}

EngineHandle *makeEngine(const Options *options, Reason *reason) {
  return guarded(reason, [&]() -> EngineHandle * {
    EngineOptions own;
    own.cpu = stringOf(options->cpu);
    own.cacheFolder = stringOf(options->cacheFolder);
    own.cacheMaxBytes = options->cacheMaxBytes;
    auto engine = llvm_back::makeEngine(own);
    if (!engine) {
      copyText(reason->text, own.cpu.empty()
                                 ? "the processor is of no family that there is code for"
                                 : "the processor does not run code for " + own.cpu);
      return nullptr;
    }
    return new EngineHandle{std::move(engine)};
  });
}

void describe(const EngineHandle *engine, Description *description) {
  (void)guarded(nullptr, [&]() -> void * {
    description->lanes = engine->engine->lanes();
    description->blockWidth = engine->engine->blockWidth();
    description->blockHeight = engine->engine->blockHeight();
    copyText(description->target, engine->engine->target());
    return nullptr;
  });
}

template <typename Handle, typename Prepare>
Handle *prepared(Bytes bytes, std::uint8_t numerics, Prepare prepare) {
  return guarded(nullptr, [&]() -> Handle * {
    ir::Program program;
    ArchiveReader archive({bytes.data, bytes.size});
    archive(program);
    if (!archive.complete())
      return nullptr;
    auto made = prepare(program, Numerics(numerics));
    return made ? new Handle{std::move(made)} : nullptr;
  });
}
FragmentHandle *prepareFragment(EngineHandle *engine, Bytes program, std::uint8_t numerics) {
  return prepared<FragmentHandle>(program, numerics, [&](const ir::Program &p, Numerics mode) {
    return engine->engine->prepareFragment(p, mode);
  });
}
VertexHandle *prepareVertex(EngineHandle *engine, Bytes program, std::uint8_t numerics) {
  return prepared<VertexHandle>(program, numerics, [&](const ir::Program &p, Numerics mode) {
    return engine->engine->prepareVertex(p, mode);
  });
}

/// Returns shape and program as bytes, as the client reads them.
template <typename Handle> BytesHandle *bytesOf(const Handle *handle) {
  return guarded(nullptr, [&]() -> BytesHandle * {
    ArchiveWriter archive;
    archive(handle->program->shape(), handle->program->program());
    return new BytesHandle{archive.take()};
  });
}

/// Compiles, and stores the result in `code`: a handle that owns it, and its entry point.
template <typename Kept, typename Compile>
void compiled(Kept CodeHandle::*kept, Code *code, Reason *reason, Compile compile) {
  code->handle = guarded(reason, [&]() -> CodeHandle * {
    auto handle = std::make_unique<CodeHandle>();
    std::string why;
    handle.get()->*kept = compile(why);
    if (!(handle.get()->*kept)) {
      copyText(reason->text, why);
      return nullptr;
    }
    code->function = reinterpret_cast<void (*)()>((handle.get()->*kept)->function);
    code->bytes = (handle.get()->*kept)->bytes;
    return handle.release();
  });
}
void compileFragment(EngineHandle *engine, const FragmentHandle *fragment,
                     const abi::FragmentKey *key, Code *code, Reason *reason) {
  compiled(&CodeHandle::fragment, code, reason, [&](std::string &why) {
    return engine->engine->compile(*fragment->program, *key, why);
  });
}
void compileVertex(EngineHandle *engine, const VertexHandle *vertex, const abi::VertexKey *key,
                   Code *code, Reason *reason) {
  compiled(&CodeHandle::vertex, code, reason,
           [&](std::string &why) { return engine->engine->compile(*vertex->program, *key, why); });
}

template <typename List> BytesHandle *listed(Reason *reason, List list) {
  return guarded(reason, [&]() -> BytesHandle * {
    std::string why;
    std::string text = list(why);
    if (!text.empty())
      return new BytesHandle{std::move(text)};
    copyText(reason->text, why);
    return nullptr;
  });
}
BytesHandle *listFragment(EngineHandle *engine, const FragmentHandle *fragment,
                          const abi::FragmentKey *key, std::uint8_t listing, Reason *reason) {
  return listed(reason, [&](std::string &why) {
    return engine->engine->listing(*fragment->program, *key, Listing(listing), why);
  });
}
BytesHandle *listVertex(EngineHandle *engine, const VertexHandle *vertex, const abi::VertexKey *key,
                        std::uint8_t listing, Reason *reason) {
  return listed(reason, [&](std::string &why) {
    return engine->engine->listing(*vertex->program, *key, Listing(listing), why);
  });
}

template <typename Handle> void destroy(Handle *handle) { delete handle; }
Bytes view(const BytesHandle *bytes) { return {bytes->bytes.data(), bytes->bytes.size()}; }

constexpr Interface kInterface = {
    kVersion,
    makeEngine,
    destroy<EngineHandle>,
    describe,
    prepareFragment,
    destroy<FragmentHandle>,
    bytesOf<FragmentHandle>,
    compileFragment,
    listFragment,
    prepareVertex,
    destroy<VertexHandle>,
    bytesOf<VertexHandle>,
    compileVertex,
    listVertex,
    destroy<CodeHandle>,
    view,
    destroy<BytesHandle>,
};

} // namespace

} // namespace arbiter::fp::jit::boundary

extern "C" __attribute__((visibility("default"))) const arbiter::fp::jit::boundary::Interface *
arbiter_jit_interface() {
  arbiter::prepareUnwinder();
  return &arbiter::fp::jit::boundary::kInterface;
}
