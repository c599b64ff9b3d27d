// SPDX-License-Identifier: BSD-3-Clause
// Are the primitives what their cases say?
#include "Cases.h"
#include "Sphere.h"
#include "Views.h"

#include "RayCaster.h"

#include <vtkPolyData.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

using namespace wfv;
using namespace wfv::stress;

namespace
{
std::vector<vec3> PointsOf(vtkPolyData* mesh)
{
  std::vector<vec3> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points.push_back(vec3(p[0], p[1], p[2]));
  }
  return points;
}

bool SameBits(double a, double b)
{
  return a == b && std::signbit(a) == std::signbit(b);
}

// How many triangles a ray from the eye passes through the inside of.
int CountCrossed(const SphereMesh& mesh, const vec3& d)
{
  int count = 0;
  for (const auto& t : mesh.GetTriangles())
  {
    bool inside = true;
    for (int k = 0; k < 3 && inside; ++k)
    {
      inside =
        glm::dot(d, glm::cross(mesh.GetPoints()[t[k]], mesh.GetPoints()[t[(k + 1) % 3]])) > 0;
    }
    count += inside;
  }
  return count;
}
}

RC_GTEST_PROP(SphereMesh, EveryDirectionMeetsOneTriangle, ())
{
  Random random(std::uint64_t(*rc::gen::inRange(0, 1 << 30)), "sphere");
  const double thinnest = random.Choose(std::vector<double>{ 1e-7, 1e-4 });
  SphereMesh mesh(random, random.Choose(std::vector<double>{ 1, 5, 100 }), thinnest);
  const int steps = random.Below(200);
  for (int i = 0; i < steps; ++i)
  {
    mesh.Refine(random);
  }
  for (int i = 0; i < 50; ++i)
  {
    RC_ASSERT(CountCrossed(mesh, random.Direction()) == 1);
  }
  for (const auto& t : mesh.GetTriangles())
  {
    RC_ASSERT(mesh.Thickness(t) > thinnest);
  }
  // Euler: closed, of one piece, without a handle
  RC_ASSERT(mesh.GetCount() == 2 * int(mesh.GetPoints().size()) - 4);
}

TEST(SphereMesh, VerticesOfTheOctahedronStayOnTheAxes)
{
  Random random(3, "axes");
  const SphereMesh mesh(random, 5, 1e-4);
  ASSERT_EQ(mesh.GetPoints().size(), 6u);
  for (const vec3& p : mesh.GetPoints())
  {
    EXPECT_EQ((p.x != 0) + (p.y != 0) + (p.z != 0), 1);
    EXPECT_GE(glm::length(p), 1);
  }
}

TEST(StressCases, SameSeedSameNumbers)
{
  for (const Case& c : Cases())
  {
    const Batch a = MakeBatch({ "hammer", c.Name, 3 }, 17);
    const Batch b = MakeBatch({ "hammer", c.Name, 3 }, 17);
    const Batch other = MakeBatch({ "hammer", c.Name, 3 }, 18);
    const std::vector<vec3> pa = PointsOf(a.What.Mesh);
    const std::vector<vec3> pb = PointsOf(b.What.Mesh);
    ASSERT_EQ(pa.size(), pb.size()) << c.Name;
    EXPECT_EQ(test::Describe(a.Shot), test::Describe(b.Shot)) << c.Name;
    for (std::size_t i = 0; i < pa.size(); ++i)
    {
      ASSERT_TRUE(
        SameBits(pa[i].x, pb[i].x) && SameBits(pa[i].y, pb[i].y) && SameBits(pa[i].z, pb[i].z))
        << c.Name;
    }
    EXPECT_NE(PointsOf(other.What.Mesh), pa) << c.Name;
  }
}

TEST(StressCases, EveryViewIsOneOfItsProjection)
{
  for (const Projection& p : Projections())
  {
    for (const Case& c : Cases())
    {
      for (int number = 0; number < 30; ++number)
      {
        const Batch batch = MakeBatch({ p.Name, c.Name, number }, 5);
        EXPECT_EQ(CheckOptions(p, batch.Shot.Options), "") << p.Name << " " << c.Name;
        EXPECT_LT(batch.What.Near, batch.What.Far);
      }
    }
  }
}

// Of all primitives of a case. Some cases are made of what cannot be seen.
constexpr double LeastSeen = 0.05;

// A test of primitives that nobody sees is none.
TEST(StressCases, ManyPrimitivesAreSeen)
{
  ViewOptions all;
  for (const Case& c : Cases())
  {
    const Subject what = MakeBatch({ "equirectangular", c.Name, 0 }, 11).What;
    all.Radii = { { what.Near, what.Far } };
    reference::Pose pose = reference::IdentityPose();
    pose[3] = -what.Eye.x;
    pose[7] = -what.Eye.y;
    pose[11] = -what.Eye.z;
    const View view(*FindProjection("equirectangular"), all);
    const reference::HitPicture picture =
      reference::RayCaster(what.Mesh, view, pose).Render(256, 128);
    std::set<vtkIdType> seen;
    for (const reference::Hit& hit : picture.Hits)
    {
      seen.insert(hit.Cell);
    }
    const double share = double(seen.size()) / double(what.Mesh->GetNumberOfCells());
    EXPECT_GT(share, LeastSeen) << c.Name << " " << seen.size();
  }
}

TEST(StressCases, NumbersAreWhatTheyAreSaidToBe)
{
  Random random(1, "numbers");
  int denormal = 0;
  for (const vec3& p : PointsOf(MakeDenormals(random, 300).Mesh))
  {
    denormal += p.x != 0 && std::abs(p.x) < 1.17e-38;
  }
  EXPECT_GT(denormal, 200);
  int negative = 0;
  int positive = 0;
  for (const vec3& p : PointsOf(MakeSignedZeros(random, 300).Mesh))
  {
    negative += p.y == 0 && std::signbit(p.y);
    positive += p.y == 0 && !std::signbit(p.y);
  }
  EXPECT_GT(negative, 50);
  EXPECT_GT(positive, 50);
  int atSeam = 0;
  for (const vec3& p : PointsOf(MakeSeams(random, 300).Mesh))
  {
    atSeam += p.x == 0 && p.z > 0;
  }
  EXPECT_GT(atSeam, 50);
}

TEST(StressPlan, HasAsManyPrimitivesAsAskedFor)
{
  for (const long wanted : { 1L, 60000L })
  {
    long count = 0;
    std::set<std::string> cases;
    for (const BatchId& id : PlanBatches("hammer", CaseNames(), wanted))
    {
      count += MakeBatch(id, 1).What.Mesh->GetNumberOfCells();
      cases.insert(id.Case);
    }
    EXPECT_GE(count, wanted);
    EXPECT_EQ(cases.size(), Cases().size());
  }
}

TEST(StressPlan, ABatchDoesNotDependOnTheRun)
{
  const std::vector<BatchId> small = PlanBatches("hammer", { "needles", "closed" }, 100);
  const std::vector<BatchId> large = PlanBatches("hammer", { "needles", "closed" }, 100000);
  ASSERT_LT(small.size(), large.size());
  for (std::size_t i = 0; i < small.size(); ++i)
  {
    EXPECT_EQ(small[i].Case, large[i].Case);
    EXPECT_EQ(small[i].Number, large[i].Number);
  }
}
