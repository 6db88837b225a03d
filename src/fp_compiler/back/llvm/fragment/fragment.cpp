#include "fp_compiler/back/llvm/fragment/fragment.h"

#include "fp_compiler/back/llvm/fragment/fragment_bytes.h"
#include "fp_compiler/back/llvm/fragment/fragment_coverage.h"
#include "fp_compiler/back/llvm/fragment/fragment_discards.h"
#include "fp_compiler/back/llvm/fragment/fragment_hooks.h"
#include "fp_compiler/back/llvm/fragment/fragment_items.h"
#include "fp_compiler/back/llvm/pixel/pixel_depth.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Writes one fragment function. Block `entry` runs once for each call, `group` once for each group
/// of spans. `item` runs once for each span, block or vector of packed pixels. The loop over an
/// item's vectors comes after it.
class Writer {
public:
  Writer(Code &code, llvm::Function *function, const jit::FragmentProgram &program,
         const abi::FragmentKey &key)
      : m_code(code), m_ir(code.ir), m_function(function), m_program(program), m_key(key),
        m_interpolator(code, key, m_places, function->getArg(1), function->getArg(0)),
        m_pixels(code, key, m_places, function->getArg(0)),
        m_depth(code, key, m_places, function->getArg(0), m_interpolator) {}

  /// Writes the function. Returns false if the program needs a derivative or a level of detail that
  /// a row cannot give.
  bool write() {
    m_places.entry = block("entry");
    m_places.item = block("item");
    auto *const next = block("next");
    auto *const done = block("done");
    llvm::BasicBlock *const item = m_places.item;
    llvm::BasicBlock *const entry = m_places.entry;
    // Small triangles have only a block or two. Values common to all blocks are cheaper as memory
    // operands than hoisted into registers.
    if (m_key.lanes != abi::Lanes::Row)
      m_places.entry = item;
    m_ir.SetInsertPoint(entry);
    auto *const first = block("first");
    m_ir.CreateCondBr(m_ir.CreateICmpEQ(m_function->getArg(3), m_ir.getInt32(0)), done, first);
    m_ir.SetInsertPoint(first);
    if (const auto bytes = byteProgramOf(m_code.cpu, m_program, m_key))
      makeTables(*bytes);
    llvm::BasicBlock *before = m_ir.GetInsertBlock();
    Value *begin = m_ir.getInt32(0);
    if (m_key.lanes == abi::Lanes::Row) {
      beginGroup();
      before = m_places.group;
      begin = m_group;
    } else {
      m_ir.CreateBr(item);
    }
    m_ir.SetInsertPoint(item);
    llvm::PHINode *const number = m_ir.CreatePHI(m_ir.getInt32Ty(), 2);
    number->addIncoming(begin, before);
    const bool packed = m_key.lanes == abi::Lanes::Packed;
    const Item at = packed ? packedItem(m_code, m_function, number, m_interpolator)
                           : itemAt(m_code, m_function, number);

    // Code that belongs to the item goes before this branch.
    auto *const start = block("start");
    m_ir.CreateBr(start);
    m_interpolator.setPixel(at.x, at.y);
    m_pixels.setPixel(at.x, at.y);
    m_depth.setPixel(at.x, at.y);
    m_ir.SetInsertPoint(start);
    if (packed)
      writePacked(at, next);
    else if (m_key.lanes == abi::Lanes::Row)
      writeSpan(at.extent, number, next);
    else
      writeBlock(at.extent, next);

    m_ir.SetInsertPoint(next);
    Value *const following =
        m_ir.CreateAdd(number, m_ir.getInt32(packed ? unsigned(m_code.lanes) : 1u));
    Value *const isLast = m_ir.CreateICmpUGE(following, m_function->getArg(3));
    if (m_spans) {
      auto *const more = block("more");
      m_ir.CreateCondBr(isLast, done, more);
      m_ir.SetInsertPoint(more);
      Value *const inGroup =
          m_ir.CreateICmpULT(m_ir.CreateSub(following, m_group), m_ir.getInt32(m_spans->size()));
      m_ir.CreateCondBr(inGroup, item, m_places.group);
      number->addIncoming(following, more);
      m_group->addIncoming(following, more);
    } else {
      number->addIncoming(following, next);
      m_ir.CreateCondBr(isLast, done, item);
    }
    m_ir.SetInsertPoint(done);
    m_ir.CreateRetVoid();
    return !m_refused;
  }

private:
  llvm::BasicBlock *block(const char *name) {
    return llvm::BasicBlock::Create(m_code.context(), name, m_function);
  }
  /// Begins the loop over groups of spans, which encloses the loop over spans.
  void beginGroup() {
    llvm::BasicBlock *const before = m_ir.GetInsertBlock();
    m_places.group = block("group");
    m_ir.CreateBr(m_places.group);
    m_ir.SetInsertPoint(m_places.group);
    m_group = m_ir.CreatePHI(m_ir.getInt32Ty(), 2);
    m_group->addIncoming(m_ir.getInt32(0), before);
    m_ir.CreateBr(m_places.item);
    m_spans.emplace(m_code, m_places, m_function->getArg(2), m_group, m_function->getArg(3));
  }
  /// Writes the loops over a span. If all affine samples read consecutive texels, one loop does the
  /// pixels [begin, end) that do not wrap, and another the edges. Otherwise a general loop does all
  /// pixels.
  void writeSpan(Value *count, Value *number, llvm::BasicBlock *next) {
    m_flow.emplace(m_code, m_program, m_key, m_places, m_interpolator, m_function->getArg(0),
                   *m_spans);
    Value *const inGroup =
        writeIn(m_code, m_places.item, [&] { return m_ir.CreateSub(number, m_group); });
    const ConsecutiveSamples samples(m_code, m_program, m_key, m_places, *m_flow, *m_spans,
                                     m_function->getArg(0), inGroup);
    if (!samples.any()) {
      writeLoop(SamplePath::General, nullptr, m_ir.getInt32(0), count, count);
      m_ir.CreateBr(next);
      return;
    }
    auto *const general = block("general");
    auto *const some = block("some");
    m_ir.CreateCondBr(samples.good(), some, general);
    m_ir.SetInsertPoint(general);
    writeLoop(SamplePath::General, nullptr, m_ir.getInt32(0), count, count);
    m_ir.CreateBr(next);

    auto *const edge = block("edge");
    auto *const fast = block("fast");
    m_ir.SetInsertPoint(some);
    m_ir.CreateBr(edge);
    m_ir.SetInsertPoint(edge);
    llvm::PHINode *const begin = m_ir.CreatePHI(m_ir.getInt32Ty(), 2);
    llvm::PHINode *const end = m_ir.CreatePHI(m_ir.getInt32Ty(), 2);
    begin->addIncoming(m_ir.getInt32(0), some);
    end->addIncoming(samples.begin(), some);
    writeLoop(SamplePath::Edge, &samples, begin, end, count);
    m_ir.CreateCondBr(m_ir.CreateICmpEQ(end, count), next, fast);
    m_ir.SetInsertPoint(fast);
    const auto writeFast = [&](SamplePath path) {
      writeLoop(path, &samples, samples.begin(), samples.end(), count);
      begin->addIncoming(samples.end(), m_ir.GetInsertBlock());
      end->addIncoming(count, m_ir.GetInsertBlock());
      m_ir.CreateBr(edge);
    };
    if (m_tables && samples.has(m_bytes.sample)) {
      auto *const bytes = block("bytes");
      auto *const program = block("program");
      m_ir.CreateCondBr(m_tables->ready(), bytes, program);
      m_ir.SetInsertPoint(bytes);
      m_tables->load();
      writeFast(SamplePath::Given);
      m_ir.SetInsertPoint(program);
    }
    writeFast(SamplePath::Consecutive);
  }

  void makeTables(const ByteProgram &bytes) {
    m_bytes = bytes;
    m_tables.emplace(m_code, bytes, m_function->getArg(2), m_function->getArg(3), m_places,
                     [&](Value *texels) {
                       const FragmentColors fragment =
                           colorsOf(m_program, SamplePath::Given, nullptr, PixelPlace{}, texels);
                       return m_pixels.pixelsOf(fragment, m_bytes.target);
                     });
  }

  /// Writes pixels by the byte tables.
  void writeBytes(const ConsecutiveSamples &samples, const PixelPlace &place) {
    m_pixels.storePixels(place, m_tables->pixels(samples.texels(m_bytes.sample, place.column)),
                         m_bytes.target, nullptr);
  }

  /// Writes a loop over the vectors of [begin, end). Only at the end of the span may the last one
  /// be incomplete.
  void writeLoop(SamplePath path, const ConsecutiveSamples *samples, Value *begin, Value *end,
                 Value *count) {
    llvm::BasicBlock *const before = m_ir.GetInsertBlock();
    auto *const body = block("pixels");
    auto *const after = block("after");
    m_ir.CreateCondBr(m_ir.CreateICmpSLT(begin, end), body, after);
    m_ir.SetInsertPoint(body);
    llvm::PHINode *const column = m_ir.CreatePHI(m_ir.getInt32Ty(), 2);
    column->addIncoming(begin, before);
    PixelPlace place;
    place.lanes = abi::Lanes::Row;
    place.column = column;
    place.remaining = m_ir.CreateSub(count, column);
    place.covered = m_ir.CreateICmpSLT(m_code.iota(), m_code.splat(place.remaining));
    m_interpolator.setLanes(m_ir.CreateAdd(m_code.splat(column), m_code.iota()), nullptr);
    m_pixels.prefetch(place);
    if (path == SamplePath::Consecutive || path == SamplePath::Given)
      samples->prefetch(column);
    writePixels(path, samples, place);
    Value *const following = m_ir.CreateAdd(column, m_ir.getInt32(unsigned(m_code.lanes)));
    column->addIncoming(following, m_ir.GetInsertBlock());
    m_ir.CreateCondBr(m_ir.CreateICmpSLT(following, end), body, after);
    m_ir.SetInsertPoint(after);
  }

  void writeBlock(Value *mask, llvm::BasicBlock *next) {
    PixelPlace place;
    place.lanes = abi::Lanes::Quad;
    Value *const bits = m_ir.CreateTrunc(mask, m_ir.getIntNTy(unsigned(m_code.lanes)));
    place.covered = m_ir.CreateBitCast(bits, m_code.i1);
    llvm::SmallVector<llvm::Constant *, 16> dx, dy;
    for (int lane = 0; lane < m_code.lanes; ++lane) {
      dx.push_back(m_ir.getInt32(unsigned(lane % m_code.cpu.blockWidth())));
      dy.push_back(m_ir.getInt32(unsigned(lane / m_code.cpu.blockWidth())));
    }
    m_interpolator.setLanes(llvm::ConstantVector::get(dx), llvm::ConstantVector::get(dy));
    writePixels(SamplePath::General, nullptr, place);
    m_ir.CreateBr(next);
  }

  void writePacked(const Item &item, llvm::BasicBlock *next) {
    static_assert(offsetof(abi::Pixel, isHelper) == 3 && abi::Pixel::kHelper == 0x80);
    PixelPlace place;
    place.lanes = abi::Lanes::Packed;
    place.covered = m_ir.CreateICmpSGE(item.extent, m_code.splat(0));
    place.dx = byteOf(m_code, item.extent, offsetof(abi::Pixel, x));
    place.dy = byteOf(m_code, item.extent, offsetof(abi::Pixel, y));
    m_interpolator.setLanes(place.dx, place.dy);
    writePixels(SamplePath::General, nullptr, place);
    m_ir.CreateBr(next);
  }

  void writePixels(SamplePath path, const ConsecutiveSamples *samples, const PixelPlace &place) {
    if (path == SamplePath::Given)
      return writeBytes(*samples, place);
    // If nothing after the depth test can discard the fragment, the test runs before the program.
    const jit::FragmentShape &shape = m_program.shape();
    const bool discards = shape.kills || m_key.coverage == abi::Coverage::Disc ||
                          m_key.alphaTest != abi::Compare::Always;
    const bool early = m_depth.active() && !shape.writesDepth && !discards;
    auto *const rest = block("tested");
    Value *mask = nullptr;
    if (early) {
      mask = m_depth.test(place, m_interpolator.depth(), nullptr);
      leaveIfNone(mask, rest);
    } else if (!shape.writesDepth) {
      leaveWhereDiscarded(path, place, rest);
    }
    const FragmentColors fragment = colorsOf(m_program, path, samples, place, nullptr);
    mask = notDiscarded(place, fragment, mask);
    if (m_depth.active() && !early)
      mask = m_depth.test(place, fragment.depth ? fragment.depth : m_interpolator.depth(), mask);
    m_pixels.write(place, fragment, mask);
    m_ir.CreateBr(rest);
    m_ir.SetInsertPoint(rest);
  }

  Value *notDiscarded(const PixelPlace &place, const FragmentColors &fragment, Value *mask) {
    if (fragment.alive)
      mask = m_ir.CreateAnd(fragment.alive, mask ? mask : place.covered);
    return m_pixels.alphaTested(place, fragment, mask);
  }

  void leaveIfNone(Value *mask, llvm::BasicBlock *rest) {
    auto *const shaded = block("shaded");
    m_ir.CreateCondBr(m_ir.CreateOrReduce(mask), shaded, rest);
    m_ir.SetInsertPoint(shaded);
  }

  /// Leaves early if all fragments of the vector will be discarded. Discarded fragments write no
  /// depth, so the depth test comes last. But if none can pass it, or none survives KIL and the
  /// alpha test, the colours are not needed. This code writes nothing, and later passes reuse the
  /// values it computes.
  void leaveWhereDiscarded(SamplePath path, const PixelPlace &place, llvm::BasicBlock *rest) {
    Value *mask = m_depth.foresees() ? m_depth.mayPass(place, m_interpolator.depth()) : nullptr;
    if (mask)
      leaveIfNone(mask, rest);
    if (path != SamplePath::General)
      return; // the choice of path depends on the samples of the whole program
    const auto part = discardProgramOf(m_program, m_key);
    if (!part)
      return;
    const FragmentColors fragment = colorsOf(*part, path, nullptr, place, nullptr);
    leaveIfNone(notDiscarded(place, fragment, mask), rest);
  }

  /// Writes the program over one vector of pixels.
  /// \param given the texels of SamplePath::Given
  FragmentColors colorsOf(const jit::FragmentProgram &source, SamplePath path,
                          const ConsecutiveSamples *samples, const PixelPlace &place,
                          Value *given) {
    const ir::Program &program = source.program();
    FragmentHooks hooks(m_code, source, m_key, m_places, m_interpolator, m_function->getArg(0),
                        m_flow ? &*m_flow : nullptr, samples, path, place);
    hooks.give(given);
    const ProgramResults results = writeProgram(m_code, program, Numerics(m_key.numerics), hooks);
    FragmentColors fragment;
    const bool several = program.options.drawBuffers;
    for (std::size_t i = 0; i < program.outputs.size(); ++i) {
      const ir::Output output = program.outputs[i];
      if (output.kind == ir::OutputKind::Depth)
        fragment.depth = results.outputs[i][2];
      if (output.kind != ir::OutputKind::Color)
        continue;
      // Without ARB_draw_buffers the one colour goes to all buffers.
      for (std::size_t target = 0; target < fragment.colors.size(); ++target)
        if (several ? target == output.index : output.index == 0)
          fragment.colors[target] = results.outputs[i];
    }
    fragment.alive = hooks.alive();
    m_refused |= hooks.refused();
    fragment.texels = hooks.takeTexels();
    if (m_key.coverage != abi::Coverage::Whole)
      applyCoverage(m_code, m_key.coverage,
                    m_interpolator.input(int(m_program.shape().inputs.size()), 0xF), fragment);
    return fragment;
  }

  Code &m_code;
  llvm::IRBuilder<> &m_ir;
  llvm::Function *m_function;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  Places m_places;
  Interpolator m_interpolator;
  PixelWriter m_pixels;
  DepthStencil m_depth;
  llvm::PHINode *m_group = nullptr; ///< Row: index of the group's first span
  std::optional<SpanGroup> m_spans;
  std::optional<AffineFlow> m_flow;
  bool m_refused = false;
  ByteProgram m_bytes;
  std::optional<ByteTables> m_tables;
};
} // namespace

bool writeFragment(Code &code, llvm::Function *function, const jit::FragmentProgram &program,
                   const abi::FragmentKey &key, std::string &reason) {
  if (!PixelWriter::supports(key, reason))
    return false;
  if (Writer(code, function, program, key).write())
    return true;
  reason = "a derivative or a level of detail that only quads of pixels can tell";
  return false;
}

} // namespace arbiter::fp::llvm_back
