#include "fp_compiler/jit_client.h"

#include "fp_compiler/jit_fields.h"

namespace arbiter::fp::jit {

namespace {

using boundary::Bytes;
using boundary::BytesHandle;
using boundary::Interface;
using boundary::Reason;

Bytes bytesOf(const std::string &text) { return {text.data(), text.size()}; }

std::string archived(const ir::Program &program) {
  ArchiveWriter archive;
  archive(program);
  return archive.take();
}

/// Bytes of the library, which are freed with this object.
class Borrowed {
public:
  Borrowed(const Interface &library, BytesHandle *handle) : m_library(library), m_handle(handle) {}
  ~Borrowed() {
    if (m_handle)
      m_library.freeBytes(m_handle);
  }
  Borrowed(const Borrowed &) = delete;
  Borrowed &operator=(const Borrowed &) = delete;
  [[nodiscard]] std::string_view view() const {
    if (!m_handle)
      return {};
    const Bytes bytes = m_library.view(m_handle);
    return {bytes.data, bytes.size};
  }

private:
  const Interface &m_library;
  BytesHandle *const m_handle;
};

template <typename Function> struct ClientCode final : Code<Function> {
  ClientCode(const Interface &from, const boundary::Code &code)
      : library(from), handle(code.handle) {
    this->function = reinterpret_cast<Function>(code.function);
    this->bytes = code.bytes;
  }
  ~ClientCode() override { library.freeCode(handle); }
  const Interface &library;
  boundary::CodeHandle *const handle;
};

template <typename Function>
std::unique_ptr<Code<Function>> received(const Interface &library, const boundary::Code &code,
                                         const Reason &why, std::string &reason) {
  if (code.handle)
    return std::make_unique<ClientCode<Function>>(library, code);
  reason = why.text;
  return nullptr;
}

/// A program that the library has prepared. Its shape and its IR are copied to this side.
template <typename Base, typename Shape, typename Handle> class Prepared final : public Base {
public:
  using Free = void (*)(Handle *);
  Prepared(Handle *handle, Free free) : m_handle(handle), m_free(free) {}
  ~Prepared() override { m_free(m_handle); }
  /// Reads the shape and the IR. Returns false if a library of this build did not write the bytes.
  bool read(std::string_view bytes) {
    ArchiveReader archive(bytes);
    archive(m_shape, m_program);
    return archive.complete();
  }
  [[nodiscard]] const Shape &shape() const override { return m_shape; }
  [[nodiscard]] const ir::Program &program() const override { return m_program; }
  [[nodiscard]] const Handle *handle() const { return m_handle; }

private:
  Handle *const m_handle;
  const Free m_free;
  Shape m_shape;
  ir::Program m_program;
};
using PreparedFragment = Prepared<FragmentProgram, FragmentShape, boundary::FragmentHandle>;
using PreparedVertex = Prepared<VertexProgram, VertexShape, boundary::VertexHandle>;

const boundary::FragmentHandle *handleOf(const FragmentProgram &program) {
  return static_cast<const PreparedFragment &>(program).handle();
}
const boundary::VertexHandle *handleOf(const VertexProgram &program) {
  return static_cast<const PreparedVertex &>(program).handle();
}

class ClientEngine final : public Engine {
public:
  ClientEngine(const Interface &library, boundary::EngineHandle *handle)
      : m_library(library), m_handle(handle) {
    m_library.describe(m_handle, &m_description);
  }
  ~ClientEngine() override { m_library.freeEngine(m_handle); }
  ClientEngine(const ClientEngine &) = delete;
  ClientEngine &operator=(const ClientEngine &) = delete;

  [[nodiscard]] int lanes() const override { return m_description.lanes; }
  [[nodiscard]] int blockWidth() const override { return m_description.blockWidth; }
  [[nodiscard]] int blockHeight() const override { return m_description.blockHeight; }
  [[nodiscard]] std::string target() const override { return m_description.target; }

  std::unique_ptr<FragmentProgram> prepareFragment(const ir::Program &program,
                                                   Numerics numerics) override {
    const std::string bytes = archived(program);
    return prepared<PreparedFragment>(
        m_library.prepareFragment(m_handle, bytesOf(bytes), std::uint8_t(numerics)),
        m_library.freeFragment, m_library.fragmentBytes);
  }
  std::unique_ptr<VertexProgram> prepareVertex(const ir::Program &program,
                                               Numerics numerics) override {
    const std::string bytes = archived(program);
    return prepared<PreparedVertex>(
        m_library.prepareVertex(m_handle, bytesOf(bytes), std::uint8_t(numerics)),
        m_library.freeVertex, m_library.vertexBytes);
  }

  std::unique_ptr<FragmentCode> compile(const FragmentProgram &program, const abi::FragmentKey &key,
                                        std::string &reason) override {
    boundary::Code code{};
    Reason why{};
    m_library.compileFragment(m_handle, handleOf(program), &key, &code, &why);
    return received<abi::ShadeFunction>(m_library, code, why, reason);
  }
  std::unique_ptr<VertexCode> compile(const VertexProgram &program, const abi::VertexKey &key,
                                      std::string &reason) override {
    boundary::Code code{};
    Reason why{};
    m_library.compileVertex(m_handle, handleOf(program), &key, &code, &why);
    return received<abi::VertexFunction>(m_library, code, why, reason);
  }

  std::string listing(const FragmentProgram &program, const abi::FragmentKey &key, Listing what,
                      std::string &reason) override {
    Reason why{};
    return listed(
        m_library.listFragment(m_handle, handleOf(program), &key, std::uint8_t(what), &why), why,
        reason);
  }
  std::string listing(const VertexProgram &program, const abi::VertexKey &key, Listing what,
                      std::string &reason) override {
    Reason why{};
    return listed(m_library.listVertex(m_handle, handleOf(program), &key, std::uint8_t(what), &why),
                  why, reason);
  }

private:
  template <typename Result, typename Handle>
  std::unique_ptr<Result> prepared(Handle *handle, void (*free)(Handle *),
                                   BytesHandle *(*bytesOf)(const Handle *)) const {
    if (!handle)
      return nullptr;
    auto result = std::make_unique<Result>(handle, free);
    const Borrowed bytes(m_library, bytesOf(handle));
    return result->read(bytes.view()) ? std::move(result) : nullptr;
  }
  std::string listed(BytesHandle *handle, const Reason &why, std::string &reason) const {
    const Borrowed bytes(m_library, handle);
    if (!handle)
      reason = why.text;
    return std::string(bytes.view());
  }

  const Interface &m_library;
  boundary::EngineHandle *const m_handle;
  boundary::Description m_description{};
};

} // namespace

std::unique_ptr<Engine> connect(const Interface &library, const EngineOptions &options,
                                std::string &reason) {
  const boundary::Options plain = {bytesOf(options.cpu), bytesOf(options.cacheFolder),
                                   options.cacheMaxBytes};
  Reason why{};
  boundary::EngineHandle *const engine = library.makeEngine(&plain, &why);
  if (engine)
    return std::make_unique<ClientEngine>(library, engine);
  reason = why.text;
  return nullptr;
}

} // namespace arbiter::fp::jit
