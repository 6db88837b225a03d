#include "fp_compiler/back/llvm/sample/sample_parts.h"

namespace arbiter::fp::llvm_back {
namespace {

llvm::BasicBlock *block(Code &code, const char *name) {
  return llvm::BasicBlock::Create(code.context(), name, code.ir.GetInsertBlock()->getParent());
}

/// Returns all values of a texel.
Values valuesOfTexel(const Texel &texel) {
  return {texel.rgba[0], texel.rgba[1], texel.rgba[2], texel.rgba[3], texel.packed};
}
Texel texelOf(const Values &values) {
  return {{values[0], values[1], values[2], values[3]}, values[4]};
}

} // namespace

Values eitherOf(Code &code, Value *condition, const std::function<Values()> &yes,
                const std::function<Values()> &no) {
  llvm::IRBuilder<> &ir = code.ir;
  llvm::BasicBlock *const yesBlock = block(code, "yes"), *const noBlock = block(code, "no"),
                          *const join = block(code, "join");
  ir.CreateCondBr(condition, yesBlock, noBlock);
  const auto branch = [&](llvm::BasicBlock *start, const std::function<Values()> &written) {
    ir.SetInsertPoint(start);
    const Values values = written();
    llvm::BasicBlock *const end = ir.GetInsertBlock();
    ir.CreateBr(join);
    return std::make_pair(values, end);
  };
  const auto [ofYes, yesEnd] = branch(yesBlock, yes);
  const auto [ofNo, noEnd] = branch(noBlock, no);
  ir.SetInsertPoint(join);
  Values values(ofYes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!ofYes[i] || !ofNo[i])
      continue;
    llvm::PHINode *const phi = ir.CreatePHI(ofYes[i]->getType(), 2);
    phi->addIncoming(ofYes[i], yesEnd);
    phi->addIncoming(ofNo[i], noEnd);
    values[i] = phi;
  }
  return values;
}

Texel either(Code &code, Value *condition, const Sampled &yes, const Sampled &no) {
  return texelOf(eitherOf(
      code, condition, [&] { return valuesOfTexel(yes()); }, [&] { return valuesOfTexel(no()); }));
}

Texel forEachImage(Code &code, Value *image, Value *mask,
                   const std::function<Texel(Value *)> &sampled) {
  llvm::IRBuilder<> &ir = code.ir;
  llvm::Type *const bits = ir.getIntNTy(unsigned(code.lanes));
  llvm::BasicBlock *const before = ir.GetInsertBlock(), *const loop = block(code, "image"),
                          *const next = block(code, "image.next"),
                          *const done = block(code, "image.done");
  Value *const all = mask ? mask : llvm::Constant::getAllOnesValue(code.i1);
  Value *const first = ir.CreateExtractElement(image, std::uint64_t(0));
  ir.CreateBr(loop);

  ir.SetInsertPoint(loop);
  llvm::PHINode *const pending = ir.CreatePHI(code.i1, 2);
  llvm::PHINode *const scalar = ir.CreatePHI(ir.getInt32Ty(), 2);
  // These hold the merged values so far. Which values exist is known only after sampling.
  std::array<llvm::PHINode *, 5> soFar = {};
  for (llvm::PHINode *&phi : soFar)
    phi = ir.CreatePHI(&phi == &soFar.back() ? code.i32 : code.f32, 2);
  const Values values = valuesOfTexel(sampled(scalar));
  Value *const mine = ir.CreateICmpEQ(image, code.splat(scalar));
  Values merged(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i])
      merged[i] = code.select(mine, values[i], soFar[i]);
  Value *const rest = ir.CreateAnd(pending, ir.CreateNot(mine));
  Value *const left = ir.CreateBitCast(rest, bits);
  ir.CreateCondBr(ir.CreateIsNotNull(left), next, done);

  ir.SetInsertPoint(next);
  Value *const lane = ir.CreateBinaryIntrinsic(llvm::Intrinsic::cttz, left, ir.getTrue());
  Value *const following = ir.CreateExtractElement(image, ir.CreateZExt(lane, ir.getInt32Ty()));
  ir.CreateBr(loop);

  pending->addIncoming(all, before);
  pending->addIncoming(rest, next);
  scalar->addIncoming(first, before);
  scalar->addIncoming(following, next);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!merged[i]) {
      soFar[i]->eraseFromParent();
      continue;
    }
    soFar[i]->addIncoming(llvm::Constant::getNullValue(soFar[i]->getType()), before);
    soFar[i]->addIncoming(merged[i], next);
  }
  ir.SetInsertPoint(done);
  return texelOf(merged);
}

Texel meanOf(Code &code, Value *count, Value *mask, const std::function<Texel(Value *)> &sampled) {
  llvm::IRBuilder<> &ir = code.ir;
  llvm::BasicBlock *const before = ir.GetInsertBlock(), *const loop = block(code, "sample"),
                          *const done = block(code, "sample.done");
  Value *const one = code.splat(1.0f);
  Value *const share = ir.CreateFDiv(one, count);
  Value *const counted = code.toInt(mask ? code.select(mask, count, one) : count);
  Value *const most = ir.CreateIntMaxReduce(counted, true);
  ir.CreateBr(loop);

  ir.SetInsertPoint(loop);
  llvm::PHINode *const number = ir.CreatePHI(ir.getInt32Ty(), 2);
  std::array<llvm::PHINode *, 4> soFar = {};
  for (llvm::PHINode *&phi : soFar)
    phi = ir.CreatePHI(code.f32, 2);
  Value *const lane = code.splat(ir.CreateSIToFP(number, ir.getFloatTy()));
  Value *const half = code.splat(0.5f);
  // A single sample is exactly at 0.
  Value *const place = ir.CreateFSub(ir.CreateFMul(ir.CreateFAdd(lane, half), share), half);
  const Texel texel = sampled(place);
  Value *const wanted = ir.CreateFCmpOLT(lane, count);
  Value *const next = ir.CreateAdd(number, ir.getInt32(1));
  llvm::BasicBlock *const end = ir.GetInsertBlock();
  Texel mean;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!texel.rgba[i]) {
      soFar[i]->eraseFromParent();
      continue;
    }
    Value *const sum =
        ir.CreateFAdd(soFar[i], code.select(wanted, texel.rgba[i], code.splat(0.0f)));
    soFar[i]->addIncoming(code.splat(0.0f), before);
    soFar[i]->addIncoming(sum, end);
    mean.rgba[i] = sum;
  }
  number->addIncoming(ir.getInt32(0), before);
  number->addIncoming(next, end);
  ir.CreateCondBr(ir.CreateICmpSLT(next, most), loop, done);
  ir.SetInsertPoint(done);
  for (Value *&component : mean.rgba)
    if (component)
      component = ir.CreateFMul(component, share);
  return mean;
}

} // namespace arbiter::fp::llvm_back
