// SPDX-License-Identifier: BSD-3-Clause
// Closed meshes round the eye that every direction meets exactly once: random
// triangulations of the sphere with a random distance for every vertex.
#include "Cases.h"
#include "Soup.h"
#include "Sphere.h"

namespace wfv
{
namespace stress
{
namespace
{
// A mesh of that many triangles or a few more; radii from 1 to `most`.
SphereMesh Grow(Random& random, int primitives, double thinnest, double most)
{
  SphereMesh mesh(random, most, thinnest);
  // an attempt may make a triangle that is too thin, and is then taken back
  for (int attempt = 0; attempt < 20 * primitives && mesh.GetCount() < primitives; ++attempt)
  {
    mesh.Refine(random);
  }
  return mesh;
}

Subject ToSubject(const SphereMesh& mesh, bool asDouble, const vec3& centre, double scale)
{
  Soup soup(asDouble);
  for (const vec3& p : mesh.GetPoints())
  {
    soup.AddPoint(centre + p * scale);
  }
  for (const auto& t : mesh.GetTriangles())
  {
    soup.AddTriangle(t[0], t[1], t[2]);
  }
  return { soup.Finish(), centre, 0.1 * scale, 2000 * scale };
}

// From the octahedron to many; about so many on average.
int CountOf(Random& random, int primitives)
{
  return int(random.Log(8, 5.6 * primitives));
}
}

Subject MakeClosed(Random& random, int primitives)
{
  const double most = random.Choose(std::vector<double>{ 1, 1.5, 5, 100 });
  return ToSubject(Grow(random, CountOf(random, primitives), 1e-4, most), false, vec3(0), 1);
}

Subject MakeClosedThin(Random& random, int primitives)
{
  return ToSubject(Grow(random, CountOf(random, primitives), 1e-7, 5), false, vec3(0), 1);
}

Subject MakeClosedScales(Random& random, int primitives)
{
  // a power of two, so that float rounds as it did before
  const double scale = std::exp2(std::round(std::log2(random.Log(1e-6, 1e8))));
  return ToSubject(Grow(random, CountOf(random, primitives), 1e-4, 2), false, vec3(0), scale);
}

Subject MakeClosedOffsets(Random& random, int primitives)
{
  const vec3 centre = vec3(random.Sign(), random.Sign(), random.Sign()) * 1e5;
  return ToSubject(Grow(random, CountOf(random, primitives), 1e-4, 2), true, centre, 1);
}
}
}
