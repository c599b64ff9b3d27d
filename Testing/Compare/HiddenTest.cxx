// SPDX-License-Identifier: BSD-3-Clause
// Triangles that stand behind others are left out of views that stand: no picture changes for it.
#include "CullCrowd.h"
#include "Meshes.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPropPicker.h>
#include <vtkProperty.h>
#include <vtkWideFoVPolyDataMapper.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int HiddenWidth = 256;
constexpr int HiddenHeight = 128;
constexpr int HiddenShots = 2; // a projection and technique

// Balls of triangles of several sizes among each other, in a room.
class Heap : public CullCrowd
{
public:
  explicit Heap(int samples = 0)
    : CullCrowd(29, HiddenWidth, HiddenHeight, samples)
  {
    this->AddMesh(MakeRoom(24), vec3(0), 8);
    for (int i = 0; i < Balls; ++i)
    {
      const vec3 at = 4.0 * this->Place();
      Placement placement;
      placement.Double = i % 2 == 0; // which the vertex buffer rounds
      this->AddMesh(MakeGlobe(i % 3 ? 8 : 20, placement), at, 0.4 + std::abs(this->Unit()));
    }
  }

  // A large ball before the eye that hides a small one, in a room.
  struct Hiding
  {
  };
  explicit Heap(Hiding)
    : CullCrowd(1, HiddenWidth, HiddenHeight, 0)
  {
    this->AddMesh(MakeRoom(24), vec3(0), 8);
    this->AddMesh(MakeGlobe(16), vec3(0, 0, -3), 1);
    this->AddMesh(MakeGlobe(16), vec3(0, 0, -5), 0.5);
  }

  // Balls above and below the eyes, nearly as near to the axis as their circle: each behind the
  // next, and their triangles seen under large angles.
  struct Stack
  {
  };
  explicit Heap(Stack)
    : CullCrowd(3, HiddenWidth, HiddenHeight, 0)
  {
    this->AddMesh(MakeRoom(24), vec3(0), 8);
    for (int i = 0; i < Balls; ++i)
    {
      const double up = (i % 2 ? 1 : -1) * (0.6 + 0.2 * i);
      const vec3 at = 0.25 * this->Place();
      this->AddMesh(MakeGlobe(i % 3 ? 8 : 20), vec3(at.x, up, at.z), 0.3);
    }
  }

  vtkActor* GetActor(int i) const { return this->Actors[i]; }

private:
  static constexpr int Balls = 20;

  void AddMesh(vtkPolyData* mesh, const vec3& at, double scale)
  {
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(at.x, at.y, at.z);
    actor->SetScale(scale);
    const vec3 colour = 0.6 + 0.4 * this->Place();
    actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
    this->Add(actor);
    this->Actors.emplace_back(actor);
  }

  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

vtkIdType CompareAll(Heap& heap, const std::vector<const char*>& names)
{
  vtkIdType hidden = 0;
  for (const Projection& p : Projections())
  {
    const auto is = [&p](const char* name) { return p.Name == std::string(name); };
    if (names.empty() || std::any_of(names.begin(), names.end(), is))
    {
      const vtkIdType before = hidden;
      hidden += heap.CompareHidden(p, vtkWideFoVPass::AUTO, HiddenShots);
      hidden += heap.CompareHidden(p, vtkWideFoVPass::EXACT, HiddenShots);
      EXPECT_TRUE(hidden > before || p.Axis == Family::Planar) << p.Name;
    }
  }
  return hidden;
}
}

TEST(Occlusion, ChangesNoPicture)
{
  Heap heap;
  std::cout << "hidden triangles " << CompareAll(heap, {}) << std::endl;
}

TEST(Occlusion, ChangesNoPictureOfTwoEyes)
{
  Heap heap;
  heap.SetStereo("omnidirectional");
  CompareAll(
    heap, { "equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap" });
}

TEST(Occlusion, ChangesNoPictureOfTwoEyesBesideTheirCircle)
{
  Heap heap{ Heap::Stack() };
  heap.SetStereo("omnidirectional");
  heap.Pass->SetTechnique(vtkWideFoVPass::AUTO);
  for (const char* name : { "equirectangular", "hammer", "azimuthal-equidistant", "panini" })
  {
    heap.Point(*FindProjection(name), vec3(0), vec3(0, 0, -1));
    EXPECT_GT(heap.CompareHidden(), 0) << name;
  }
}

namespace
{
using Change = std::pair<const char*, std::function<void(Heap&)>>;

// What takes away something that hides, in ways that a scene may change.
std::vector<Change> Changes()
{
  const auto ball = [](Heap& heap) { return heap.GetActor(1); };
  return {
    { "out of sight", [=](Heap& h) { ball(h)->VisibilityOff(); } },
    { "back", [=](Heap& h) { ball(h)->VisibilityOn(); } },
    { "moved", [=](Heap& h) { ball(h)->SetPosition(2, 0, -3); } },
    { "moved back", [=](Heap& h) { ball(h)->SetPosition(0, 0, -3); } },
    { "translucent", [=](Heap& h) { ball(h)->GetProperty()->SetOpacity(0.5); } },
    { "opaque", [=](Heap& h) { ball(h)->GetProperty()->SetOpacity(1); } },
    { "lines", [=](Heap& h) { ball(h)->GetProperty()->SetRepresentationToWireframe(); } },
    { "surface", [=](Heap& h) { ball(h)->GetProperty()->SetRepresentationToSurface(); } },
    { "cut",
      [=](Heap& h) {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0, 0, -3);
        plane->SetNormal(1, 0, 0);
        ball(h)->GetMapper()->AddClippingPlane(plane);
      } },
    { "whole", [=](Heap& h) { ball(h)->GetMapper()->RemoveAllClippingPlanes(); } },
    { "shrunk",
      [=](Heap& h) {
        auto* mesh = vtkPolyData::SafeDownCast(ball(h)->GetMapper()->GetInputDataObject(0, 0));
        vtkPoints* const points = mesh->GetPoints();
        for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
        {
          double p[3];
          points->GetPoint(i, p);
          points->SetPoint(i, 0.3 * p[0], 0.3 * p[1], 0.3 * p[2]);
        }
        points->Modified();
        mesh->Modified();
      } },
    { "gone", [=](Heap& h) { h.Renderer->RemoveActor(ball(h)); } },
  };
}
}

// The very next frame shows what was hidden.
TEST(Occlusion, EndsWithAnyChange)
{
  Heap heap{ Heap::Hiding() };
  heap.Point(*FindProjection("equirectangular"), vec3(0), vec3(0, 0, -1));
  EXPECT_GT(heap.CompareHidden(), 0);
  for (const Change& change : Changes())
  {
    SCOPED_TRACE(change.first);
    heap.Draw(true);
    heap.Draw(true);
    ASSERT_GT(heap.Pass->GetNumberOfHiddenTriangles(), 0);
    change.second(heap);
    const auto now = heap.Draw(true);
    EXPECT_EQ(heap.Pass->GetNumberOfHiddenTriangles(), 0);
    heap.Pass->OcclusionCullingOff();
    const auto whole = heap.Draw(true);
    EXPECT_EQ(std::memcmp(now->GetPointer(0), whole->GetPointer(0),
                static_cast<std::size_t>(whole->GetNumberOfValues())),
      0);
    heap.Pass->OcclusionCullingOn();
    EXPECT_GT(heap.CompareHidden(), 0);
  }
}

// Of what a picker asks for nothing is left out, and it is hidden again after.
TEST(Occlusion, LeavesSelectionsAlone)
{
  Heap heap{ Heap::Hiding() };
  heap.Point(*FindProjection("equirectangular"), vec3(0), vec3(0, 0, -1));
  const vtkIdType hidden = heap.CompareHidden();
  ASSERT_GT(hidden, 0);
  vtkNew<vtkPropPicker> picker;
  EXPECT_EQ(picker->Pick(HiddenWidth / 2.0, HiddenHeight / 2.0, 0, heap.Renderer), 1);
  EXPECT_EQ(picker->GetActor(), heap.GetActor(1));
  picker->PickFromListOn();
  picker->AddPickList(heap.GetActor(2));
  EXPECT_EQ(picker->Pick(HiddenWidth / 2.0, HiddenHeight / 2.0, 0, heap.Renderer), 1);
  EXPECT_EQ(picker->GetActor(), heap.GetActor(2));
  heap.Draw(true);
  EXPECT_EQ(heap.Pass->GetNumberOfHiddenTriangles(), hidden);
}

// Nothing is hidden behind what shines through.
TEST(Occlusion, LooksThroughWhatShinesThrough)
{
  Heap heap{ Heap::Hiding() };
  heap.Point(*FindProjection("equirectangular"), vec3(0), vec3(0, 0, -1));
  const vtkIdType behind = heap.CompareHidden();
  heap.GetActor(1)->GetProperty()->SetOpacity(0.5);
  const vtkIdType through = heap.CompareHidden();
  EXPECT_LT(through, behind);
}

// Without SortWhileMoving: not before a view has stood.
TEST(Occlusion, WaitsUntilAViewStands)
{
  Heap heap{ Heap::Hiding() };
  heap.Pass->SortWhileMovingOff();
  heap.Point(*FindProjection("equirectangular"), vec3(0), vec3(0, 0, -1));
  int first = 0;
  for (; first < 20 && heap.Pass->GetNumberOfHiddenTriangles() == 0; ++first)
  {
    heap.Draw(true);
  }
  EXPECT_GT(first, 10);
  EXPECT_LT(first, 16);
}
