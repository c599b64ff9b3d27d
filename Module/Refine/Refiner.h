// SPDX-License-Identifier: BSD-3-Clause
// Refines triangles for a view: splits their edges until the chord of each stands for it, and cuts
// them where the map is discontinuous. The vertex stage then projects them one by one.
#ifndef WideFoVRefiner_h
#define WideFoVRefiner_h

#include "Projections/Bounds/ChordLimits.h"
#include "Projections/Bounds/Visibility.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace wfv
{
// Everything that the refinement of a mesh depends on, except the mesh.
struct RefineView
{
  const Projection* Map = nullptr;
  WfvView View;                              // of the eye that is drawn
  Window Part;                               // of the picture
  std::shared_ptr<const ChordLimits> Limits; // none: nothing is refined, only culled
  vec2 Pixels{ 1 };                          // of the whole picture
  double Tolerance = 0.25;                   // pixels; that of Limits
  bool Culls = true;
  const StereoModel* Stereo = nullptr; // none: the eye is the origin
  double EyeRadius = 0;      // of the circle that rays begin on, scene units; 0: one place
  double BaselineRadius = 0; // of the rays' beginnings from the origin, scene units

  bool operator==(const RefineView& other) const;
};

// A new vertex: a mix of the corners of a triangle or a segment.
struct PieceVertex
{
  std::array<double, 3> Weights; // of the corners; of a segment the third is 0
  float Aside = 0; // the side of a discontinuity that it is on (beside_*.glsl); 0: none
};

// Pieces of triangles, or of segments.
struct Pieces
{
  bool Limited = false; // a triangle would have had too many pieces
  int Corners = 3;      // of a primitive: 3 or 2
  std::vector<PieceVertex> Vertices;
  std::vector<unsigned int> Sources; // of each vertex, the number of its primitive in the mesh
  std::vector<unsigned int> Indices; // of vertices: as many a piece as it has corners
  std::vector<unsigned int> Numbers; // of each piece, the number of its primitive in the mesh

  void Clear();
  void Append(const Pieces& other);
  void AddWhole(unsigned int number); // a triangle as it is
};

struct Affine;
class EndCache;
struct WfvEnd;
class RefineSpace; // refine.glsl, compiled for a view

class WFV_EXPORT Refiner
{
public:
  explicit Refiner(const RefineView& view);
  ~Refiner();

  // How a view draws the triangles of a cluster.
  enum Need
  {
    Unseen,  // outside the window or the clip spheres
    Nothing, // each triangle as it is
    Some     // to be asked one by one
  };

  // box: of the cluster, in the map's own frame; radius: of a sphere round the middle of the box
  // that holds it; edge: the longest of its triangles.
  Need OfCluster(const Box& box, double radius, double edge) const;

  // The same of bounds (x min, x max, ...) and an edge in the frame of a mesh.
  Need OfCluster(const Affine& toMap, const double bounds[6], double edge) const;

  // True where a triangle is drawn as it is. Else its pieces are added, none where nothing of it
  // can be seen. Corners are in the map's own frame. number: of the triangle in its mesh.
  bool Take(const vec3& a, const vec3& b, const vec3& c, unsigned int number, Pieces& pieces) const;

  // The same of a triangle whose corners have these numbers, which they share with other triangles.
  bool Take(const vec3 corners[3], const std::uint64_t points[3], unsigned int number,
    EndCache& cache, Pieces& pieces) const;

  // The same of a segment.
  bool Take(const vec3& a, const vec3& b, unsigned int number, Pieces& pieces) const;

private:
  void Split(
    const vec3 corners[3], const WfvEnd ends[3], unsigned int number, Pieces& pieces) const;

  std::unique_ptr<RefineSpace> Space;
};
}

#endif
