// SPDX-License-Identifier: BSD-3-Clause
// Views in which the tests refine triangles, the triangles, and where their pieces are drawn.
#ifndef WideFoVRefinedView_h
#define WideFoVRefinedView_h

#include "Refine/Refiner.h"

#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace wfv
{
namespace test
{
using Triangle = std::array<vec3, 3>;

// A view, and the refiner that splits triangles for it.
class RefinedView
{
public:
  RefinedView(const Projection& projection, const ViewOptions& options, double tolerance);

  const RefineView& GetRefineView() const { return this->V; }
  const View& GetView() const { return this->TheView; }
  const Refiner& GetRefiner() const { return *this->R; }
  double GetTolerance() const { return this->V.Tolerance; }
  const std::string& GetName() const { return this->Name; }

  // Where the eye sees a place, as if the eye were the origin; a length of 0 where it does not.
  vec3 See(const vec3& place) const;

  // The picture of a place, pixels, as the vertex stage makes it. aside: PieceVertex::Aside.
  vec2 At(const vec3& place, float aside) const;

  // True where a place is in the picture and between the clip spheres.
  bool IsSeen(const vec3& place) const;

  // The angle, in pixels as large as those in the middle, between the direction in which a place is
  // seen and the nearest pole, antipode, rim, seam or border of a face.
  double PixelsFromTear(const vec3& place) const;

  // What is nearer to a tear may be left out: a quarter of the tolerance, so that both sides of a
  // pole are within half of it; at a rim, which chords stand for as well, the tolerance.
  double GetTornPixels() const;

  // The pieces of a triangle, as MeshDraw takes them: itself where it is fine.
  Pieces Refine(const Triangle& t) const;

  // Between what is seen at a place of the picture, pixels, and a place of the scene: the angle, in
  // pixels of the middle of the picture.
  double TurnOf(const vec2& pixel, const vec3& place) const;

  // True where the triangle is drawn as it is.
  bool IsFine(const Triangle& t) const;

private:
  std::string Name;
  View TheView;
  RefineView V;
  std::unique_ptr<Refiner> R;
};

// The place of a vertex of a piece, as PieceBuffers mixes it.
vec3 PlaceOf(const Triangle& t, const PieceVertex& vertex);

// Random triangles and clusters of all sizes: many where the view looks, some beside a pole or a
// seam.
class Shapes
{
public:
  explicit Shapes(const View& view, unsigned int seed = 21)
    : TheView(view)
    , Engine(seed)
  {
  }

  double Unit() { return this->Distribution(this->Engine); } // -1 to 1
  vec3 Vector() { return vec3(this->Unit(), this->Unit(), this->Unit()); }

  // Weights of a random place of a triangle.
  vec3 Weights();

  Triangle Make(int number);
  std::vector<Triangle> MakeCluster(int number);

private:
  vec3 Direction(int number);
  double Distance();
  Triangle MakeAt(const vec3& at, double distance, double size, double width);

  const View& TheView;
  std::mt19937_64 Engine;
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
};

// Views of every projection that is a formula: narrow and wide, at two tolerances, without stereo;
// and wide ones of each eye of the stereo models.
std::vector<std::unique_ptr<RefinedView>> MonoViews(const Projection& projection);
std::vector<std::unique_ptr<RefinedView>> StereoViews(const Projection& projection);

// Names of projections: those that have a shape of discontinuity of their own, and all others.
std::vector<std::string> NamesOfFamilies();
std::vector<std::string> NamesOfOthers();

// A name that GoogleTest takes for a parameter.
std::string NameOfProjection(const std::string& name);
}
}

#endif
