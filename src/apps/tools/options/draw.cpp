// The verbs that draw: draw, debug.
#include "apps/tools/options/verbs.h"

namespace arbiter::tools {

namespace {

/// The last frame of an animation that can be asked for.
constexpr int kLastFrame = 1000000;

void addTextures(Verb &verb, std::vector<std::string> &textures) {
  verb.option(
          "--texture", textures,
          "N=IMG: the 2D texture of unit N: a PNG, JPEG or DDS file, or a word that a document's "
          "#@ texture takes: checker, noise, clouds, landscape (repeatable)")
      .repeatable();
}

void addDebugComparison(Verb &verb, DebugArguments &debug) {
  verb.option("--against", debug.against,
              "whose picture the interpreter is compared with: swrast (the rasterizer), host "
              "(GLSL on the host), bare (the host's own implementation); fp24 (the other "
              "arithmetic alone); or another program's file")
      .oneOfOrFile({"swrast", "host", "bare", "fp24"})
      .showDefault();
  verb.option("--break", debug.breakOn,
              "stop at the first row with nan, inf, unwritten, over1, below0, kil, differs, "
              "or where a value is so: 'REG.x>0.5'");
  verb.option("--line", debug.line, "run to this line, or to the last instruction before it")
      .positive();
  const Option watch =
      verb.option("--watch", debug.watch,
                  "REG@LINE: any register after any line, over the whole picture, in place of the "
                  "trace of one pixel");
  const Option output =
      verb.option("-o,--output", debug.output, "a PNG of what --watch watches, to write")
          .needs(watch);
  verb.option("--range", debug.range, "LOW,HIGH: values that become 0 and 255 in the PNG")
      .needs(output)
      .showDefault();
}

} // namespace

void addDraw(CLI::App &app, DrawArguments &draw) {
  Verb verb(
      app, "draw",
      "Draw a document, or programs on a mesh, through the layer, with no display, into a PNG");
  addLayer(verb, draw.layer);
  verb.option("--size", draw.size, "WxH: pixels, in place of the document's or of 512x512");
  addTextures(verb, draw.textures);
  verb.option(
          "--mesh", draw.mesh,
          "what carries the programs, in place of the document's or of a quad: a shape, or an OBJ "
          "file; a grid is 64x64 quads, for vertex programs to bend")
      .oneOfOrFile(
          {"quad", "grid", "plane", "cube", "sphere", "torus", "cylinder", "knot", "billboards"});
  const auto addValues = [&](const char *name, std::vector<std::string> &values, const char *help) {
    verb.option(name, values, help).repeatable();
  };
  addValues("--local", draw.locals,
            "[vp:|fp:]N=x,y,z,w: program.local[N], of one program or of both (repeatable)");
  addValues("--env", draw.envs, "[vp:|fp:]N=x,y,z,w: program.env[N], likewise (repeatable)");
  addValues("--attrib", draw.attribs, "N=x,y,z,w: vertex.attrib[N] of every vertex (repeatable)");
  verb.option("--frames", draw.frames, "draw this many times; the last picture is kept")
      .range(1, kLastFrame)
      .showDefault();
  verb.option("--frame", draw.frame,
              "draw the frame of this number, from 0, of an animation; with feedback those "
              "before it too")
      .range(0, kLastFrame)
      .excludes("--frames");
  verb.option("--feedback", draw.feedback,
              "copy each frame into the texture of this unit (glCopyTexSubImage2D)")
      .range(0, 31);
  verb.option("-o,--output", draw.output,
              "the PNG to write; without it the document's name with the ending .png, here");
  verb.flag("--opaque", draw.opaque,
            "write alpha 1 everywhere; without it the picture has the alpha that was drawn, and "
            "viewers mix what is below 1 with a background");
  verb.flag("--json", draw.json, "say what was drawn as JSON");
  verb.flag("--bare", draw.bare, "without the layer: the host's own implementation");
  verb.flag("--in-layer", draw.inLayer).hidden(); // draw passes it to its own second process
  verb.option(
          "FILE", draw.files,
          "a document: a program text (!!ARBfp1.0, !!ARBvp1.0, !!ATIfs1.0, !!RC1.0, !!TS1.0) whose "
          "lines that begin "
          "with #@ say what it is drawn with, or a folder of one; or a program of vertices and "
          "one of fragments; gallery:NAME is a document of the gallery; - is standard input")
      .required()
      .documents()
      .count(1, 2);
  verb.footer("The mesh fills the picture; every texture coordinate set runs from 0 to 1 with "
              "y up, the primary colour is (s, t, 0, 1). A stage without a program is fixed "
              "function's.\n"
              "An image or a value that no program reads is an error; a unit without an image "
              "samples a checker with its number, and is said.\n"
              "Exit code: " +
              meaningsOf({kExitOk, kExitUsage, kExitInvalid, kExitNoGl}) +
              ".\n"
              "Examples:\n"
              "  arbiter draw gallery:twirl --frame 30 -o out.png\n"
              "  arbiter draw shader.fp -o out.png\n"
              "  arbiter draw --mesh grid waves.vp water.fp --local vp:0=0.5 -o out.png\n"
              "  arbiter draw --texture 0=photo.png --local 0=0.5,1,0,0 shader.fp -o out.png\n"
              "  arbiter draw --size 256x256 --texture 0=noise --feedback 0 --frames 100 "
              "life.fp -o life.png");
}

void addDebug(CLI::App &app, DebugArguments &debug) {
  Verb verb(app, "debug",
            "Show what a program does for one pixel: each instruction, its operands and result");
  const Option pixel = verb.option(
      "--pixel", debug.pixel,
      "X,Y: the pixel; 0,0 is the lower left one; without it the middle of the picture");
  verb.flag("--from-top", debug.fromTop, "Y counts from the picture's upper edge").needs(pixel);
  addTextures(verb, debug.textures);
  verb.option("--stage", debug.stage,
              "whose instructions: fragment; or vertex, those of "
              "the pixel's triangle")
      .oneOf({"fragment", "vertex"})
      .showDefault();
  verb.option("--pass", debug.pass, "which of the document's passes, from 1")
      .range(1, 16)
      .showDefault();
  verb.option("--frame", debug.frame, "which frame, from 0").range(0, kLastFrame).showDefault();
  addDebugComparison(verb, debug);
  verb.flag("--json", debug.json, "the whole trace as one JSON document");
  verb.option("--profile", debug.profile, kProfileHelp);
  verb.option("--numerics", debug.numerics,
              "the arithmetic to show; fp24 and host beside each other")
      .oneOf({"host", "legacy", "fp24", "fx9"});
  verb.option("--library", debug.library, "the layer's library, where it is not beside us");
  verb.option("FILE", debug.document,
              "a document: a program text, or a folder with one; gallery:NAME; - is standard input")
      .required()
      .documents();
  verb.footer(
      "Exit code: " +
      meaningsOf({kExitOk, kExitUsage, kExitInvalid, kExitNoGl, kExitDiffers, kExitStopped}) +
      ".\n"
      "Examples:\n"
      "  arbiter debug twirl.fp --pixel 100,200\n"
      "  arbiter debug twirl.fp --pixel 100,200 --against host\n"
      "  arbiter debug wrong.fp --pixel 8,8 --against right.fp\n"
      "  arbiter debug twirl.fp --pixel 8,8 --break nan\n"
      "  arbiter debug twirl.fp --watch offset@10\n"
      "  arbiter debug twirl.fp --watch offset@10 --range -1,1 -o offset.png\n"
      "  arbiter debug shader.fp --texture 0=photo.png");
}

} // namespace arbiter::tools
