// Draws osgFX effects with vertex and fragment programs: bump mapping, anisotropic lighting and
// cartoon shading, on spheres that rotate by a fixed step a frame.
#include <cmath>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osg/Texture2D>
#include <osgFX/AnisotropicLighting>
#include <osgFX/BumpMapping>
#include <osgFX/Cartoon>
#include <osgViewer/Viewer>

namespace {

constexpr int kFrames = 16;
constexpr int kWidth = 400;
constexpr int kHeight = 200;

/// Makes a sphere of quad strips with normals and texture coordinates.
osg::ref_ptr<osg::Geode> makeSphere() {
  constexpr int kStacks = 16;
  constexpr int kSlices = 24;
  auto *vertices = new osg::Vec3Array;
  auto *normals = new osg::Vec3Array;
  auto *coordinates = new osg::Vec2Array;
  for (int stack = 0; stack <= kStacks; ++stack) {
    const double latitude = osg::PI * stack / kStacks - osg::PI / 2;
    for (int slice = 0; slice <= kSlices; ++slice) {
      const double longitude = 2 * osg::PI * slice / kSlices;
      const osg::Vec3 normal(float(std::cos(latitude) * std::cos(longitude)),
                             float(std::cos(latitude) * std::sin(longitude)),
                             float(std::sin(latitude)));
      vertices->push_back(normal);
      normals->push_back(normal);
      coordinates->push_back(osg::Vec2(3.0F * slice / kSlices, 2.0F * stack / kStacks));
    }
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(vertices);
  geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
  geometry->setTexCoordArray(0, coordinates);
  geometry->setTexCoordArray(1, coordinates);
  for (unsigned stack = 0; stack < kStacks; ++stack) {
    auto *strip = new osg::DrawElementsUInt(GL_TRIANGLE_STRIP);
    for (unsigned slice = 0; slice <= kSlices; ++slice) {
      strip->push_back((stack + 1) * (kSlices + 1) + slice);
      strip->push_back(stack * (kSlices + 1) + slice);
    }
    geometry->addPrimitiveSet(strip);
  }
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  return geode;
}

/// Makes a texture of 64x64 texels; colour(x, y) returns red, green and blue from 0 to 1.
template <typename Color> osg::ref_ptr<osg::Texture2D> makeTexture(Color color) {
  constexpr int kSide = 64;
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(kSide, kSide, 1, GL_RGB, GL_UNSIGNED_BYTE);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const osg::Vec3 value = color(x, y);
      for (int c = 0; c < 3; ++c) {
        image->data(x, y)[c] = static_cast<unsigned char>(255 * value[c] + 0.5F);
      }
    }
  }
  osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
  texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
  texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
  return texture;
}

osg::ref_ptr<osg::Texture2D> makeNormals() {
  return makeTexture([](int x, int y) {
    osg::Vec3 normal(0.6F * std::sin(0.59F * x), 0.6F * std::sin(0.39F * y), 1);
    normal.normalize();
    return normal * 0.5F + osg::Vec3(0.5F, 0.5F, 0.5F);
  });
}

osg::ref_ptr<osg::Texture2D> makeColors() {
  return makeTexture([](int x, int y) {
    return (x / 8 + y / 8) % 2 ? osg::Vec3(0.9F, 0.7F, 0.3F) : osg::Vec3(0.3F, 0.5F, 0.8F);
  });
}

osg::ref_ptr<osgFX::BumpMapping> makeBumps(osg::Node *node) {
  osg::ref_ptr<osgFX::BumpMapping> effect = new osgFX::BumpMapping;
  effect->setOverrideNormalMapTexture(makeNormals());
  effect->setOverrideDiffuseTexture(makeColors());
  effect->setLightNumber(0);
  effect->addChild(node);
  effect->prepareChildren();
  return effect;
}

/// Puts a node at x, where it rotates with its siblings.
osg::ref_ptr<osg::MatrixTransform> place(osg::Node *node, float x) {
  osg::ref_ptr<osg::MatrixTransform> transform =
      new osg::MatrixTransform(osg::Matrix::translate(x, 0, 0));
  transform->addChild(node);
  return transform;
}

} // namespace

int main() {
  osg::ref_ptr<osg::Group> scene = new osg::Group;
  osg::ref_ptr<osgFX::Effect> bright = new osgFX::AnisotropicLighting;
  bright->addChild(makeSphere());
  osg::ref_ptr<osgFX::Effect> cartoon = new osgFX::Cartoon;
  cartoon->addChild(makeSphere());
  osg::ref_ptr<osg::MatrixTransform> bumps = place(makeBumps(makeSphere()), -2.3F);
  scene->addChild(bumps);
  scene->addChild(place(bright, 0));
  scene->addChild(place(cartoon, 2.3F));

  osgViewer::Viewer viewer;
  viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
  viewer.setUpViewInWindow(0, 0, kWidth, kHeight);
  viewer.setLightingMode(osg::View::SKY_LIGHT);
  viewer.setSceneData(scene);
  viewer.getCamera()->setViewMatrixAsLookAt({0, -7, 1}, {0, 0, 0}, {0, 0, 1});
  viewer.realize();
  for (int frame = 0; frame < kFrames; ++frame) {
    const double angle = 0.15 * frame;
    bumps->setMatrix(osg::Matrix::rotate(angle, osg::Z_AXIS) * osg::Matrix::translate(-2.3, 0, 0));
    viewer.frame(angle);
  }
  return 0;
}
