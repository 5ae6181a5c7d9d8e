// A scene: models in a world, seen by a camera under lights. What its geometry and colours are made from; the
// positions that are drawn are those of the case's draws, made from this by harness/scene.
//
// Plain values. The world is right-handed unless the camera says otherwise; angles are degrees, a positive one turns
// counter-clockwise as seen from the axis' tip (in a left-handed world: clockwise).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/texture.h"

namespace fillrule {

using Vector3 = std::array<double, 3>;
using Color = std::array<double, 3>;  // r, g, b as they are written to the picture

// A path in a case file, with its place there for errors.
struct ScenePath {
  std::string text;
  uint32_t line = 0;
  uint32_t column = 0;
};

struct Translate {
  Vector3 by{};
  bool operator==(const Translate&) const = default;
};
struct Rotate {
  Vector3 axis{0, 0, 1};
  double degrees = 0;
  bool operator==(const Rotate&) const = default;
};
struct Scale {
  Vector3 by{1, 1, 1};
  bool operator==(const Scale&) const = default;
};
using TransformStep = std::variant<Translate, Rotate, Scale>;
using Transform = std::vector<TransformStep>;  // the first step is applied first

enum class Handedness : uint8_t { kRight, kLeft };

struct LookAt {
  Vector3 eye{0, 0, 5};
  Vector3 target{0, 0, 0};
  Vector3 up{0, 1, 0};
};

struct Camera {
  // From where to where it looks, or the transform of a camera that stands at the origin and looks down -z (+z in a
  // left-handed world), y up.
  std::variant<LookAt, Transform> placement;
  Handedness handedness = Handedness::kRight;
};

struct PerspectiveProjection {
  double fov_y = 45;             // degrees
  std::optional<double> aspect;  // width / height; absent: the viewport's
};
// The rectangle of the near plane that is seen, in eye space.
struct FrustumProjection {
  double left = -1;
  double right = 1;
  double bottom = -1;
  double top = 1;
};
struct OrthographicProjection {
  double left = -1;
  double right = 1;
  double bottom = -1;
  double top = 1;
};

// Depth goes from 0 to 1, or from -1 to 1 where the draw's state says negative_one_to_one.
struct Projection {
  std::variant<PerspectiveProjection, FrustumProjection, OrthographicProjection> shape;
  double near = 0.1;  // distances from the eye along the view direction
  double far = 100;
};

struct DirectionalLight {
  Vector3 direction{0, -1, 0};  // where it shines to, in the world
  Color color{1, 1, 1};
};
inline constexpr size_t kMaxLights = 4;

struct Lighting {
  Color ambient{0, 0, 0};
  std::vector<DirectionalLight> directional;  // at most kMaxLights
};

struct Material {
  Color color{1, 1, 1};     // times the texel
  Color specular{0, 0, 0};  // Phong
  uint32_t shininess = 32;  // the exponent, 1 to kMaxShininess
  std::optional<ScenePath> texture;
  Sampling2D sampling;
};
inline constexpr uint32_t kMaxShininess = 1024;

// The file's normals, computed ones where it has none; one for each face; or averages over the faces at a vertex.
enum class Normals : uint8_t { kFile, kFlat, kSmooth };

struct SceneObject {
  ScenePath mesh;  // an OBJ file, or the name of one in cases/meshes
  Normals normals = Normals::kFile;
  Transform transform;
  Material material;
};

// How what is in front gets in front.
enum class DrawOrder : uint8_t {
  kDepthBuffer,  // as the state says: the depth test, by default
  kPainter,      // triangles sorted by the distance of their centroid from the eye, the farthest first
};

// Who applies the matrices.
enum class TransformOn : uint8_t {
  kHost,  // the host, once, in double: every party gets the same clip-space positions
  kBoth,  // besides, each party in its vertex stage, in float32
};

struct Scene {
  Camera camera;
  Projection projection;
  std::optional<Lighting> lighting;  // absent: colours as they are
  DrawOrder order = DrawOrder::kDepthBuffer;
  bool affine_texture = false;  // texture coordinates linear in the window: noperspective
  TransformOn transform_on = TransformOn::kHost;
  Color background{0, 0, 0};
  RasterState state;  // of every draw
  std::vector<SceneObject> objects;
  // Of each of the case's draws: which object it is of. Filled in with the draws.
  std::vector<uint32_t> object_of_draw;
};

}  // namespace fillrule
