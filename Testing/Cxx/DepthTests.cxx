// SPDX-License-Identifier: BSD-3-Clause
// The depth mappings as drawn: one picture, three depth buffers, and what each resolves.
#include "WideFoVTestScene.h"

#include "Projections/Projection.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWideFoVDataPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace
{
const int Mappings[] = { vtkWideFoVCamera::LINEAR, vtkWideFoVCamera::LOGARITHMIC,
  vtkWideFoVCamera::REVERSED };
const char* const Names[] = { "linear", "logarithmic", "reversed" };
const char* const Wide[] = { "equirectangular", "hammer", "azimuthal-equidistant" };

// A room, cones, a ball without a geometry stage, lines and points.
void Furnish(vtkRenderer* renderer)
{
  renderer->AddActor(MakeTestRoom());
  AddTestCones(renderer);
  for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.4 * representation - 0.3, 0.7, -1);
    ball->SetRadius(0.15);
    auto actor = MakeTestActor(ball, 1, 1, 1);
    actor->GetProperty()->SetRepresentation(representation);
    renderer->AddActor(actor);
  }
}

std::vector<float> Values(vtkImageData* image, const char* name)
{
  auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
  return std::vector<float>(array->GetPointer(0), array->GetPointer(array->GetNumberOfValues()));
}
}

TEST(Depth, ThePictureIsTheSameInEveryMapping)
{
  for (const char* projection : Wide)
  {
    for (int technique : { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT, vtkWideFoVPass::VERTEX })
    {
      WideFoVTestWindow test(projection, 256, 128);
      Furnish(test.Renderer);
      test.Pass()->SetTechnique(technique);
      vtkNew<vtkWideFoVDataPass> data;
      data->SetDelegatePass(test.Pass());
      for (int i = 0; i < test.Renderer->GetActors()->GetNumberOfItems(); i++)
      {
        data->SetPropIndex(
          vtkProp::SafeDownCast(test.Renderer->GetActors()->GetItemAsObject(i)), i);
      }
      test.Renderer->SetPass(data);
      std::vector<float> first[2];
      for (int mapping : Mappings)
      {
        test.Camera->SetDepthMapping(mapping);
        test.Window->Render();
        const std::vector<float> now[2] = { Values(data->GetOutput(), "prop"),
          Values(data->GetOutput(), "cell") };
        for (int i = 0; i < 2; i++)
        {
          first[i] = first[i].empty() ? now[i] : first[i];
          EXPECT_EQ(now[i], first[i]) << projection << " " << technique << " " << Names[mapping];
        }
      }
      EXPECT_GT(*std::max_element(first[0].begin(), first[0].end()), 8) << projection;
    }
  }
}

// What the buffer holds is the mapping of the distance that the data pass shows.
TEST(Depth, TheBufferHoldsTheMappingOfTheDistance)
{
  // of float32 depth and of the distance that it comes from, by a float32 logarithm
  constexpr double Rounding = 2e-6;
  for (const char* projection : Wide)
  {
    for (int mapping : { vtkWideFoVCamera::LOGARITHMIC, vtkWideFoVCamera::REVERSED })
    {
      WideFoVTestWindow test(projection, 256, 128);
      Furnish(test.Renderer);
      test.Camera->SetClipRadii(0.1, 10);
      test.Camera->SetDepthMapping(mapping);
      test.Window->Render();
      vtkNew<vtkFloatArray> z;
      test.Window->GetZbufferData(0, 0, 255, 127, z);
      vtkNew<vtkWideFoVDataPass> data;
      data->SetDelegatePass(test.Pass());
      test.Renderer->SetPass(data);
      test.Window->Render();
      const std::vector<float> distance = Values(data->GetOutput(), "distance");
      const wfv::WfvView view = test.Camera->GetView(2).GetParameters();
      int seen = 0;
      double worst = 0;
      for (size_t i = 0; i < distance.size(); i++)
      {
        if (std::isfinite(distance[i]))
        {
          seen++;
          worst = std::max(worst, std::abs(z->GetValue(i) - wfv::wfvDepthOf(distance[i], view)));
        }
      }
      EXPECT_GT(seen, 128 * 100) << projection;
      EXPECT_LT(worst, Rounding) << projection << " " << Names[mapping];
    }
  }
}

namespace
{
constexpr double Near = 1e-4;
constexpr double Far = 1;

// Two parallel walls across the view, the red nearer by a part of the distance.
class Walls
{
public:
  Walls(bool stencil, int technique)
    : Test("equirectangular", 64, 32)
  {
    this->Test.Window->SetStencilCapable(stencil); // its format has 24 bits of depth
    this->Test.Camera->SetPosition(0, 0, 0);
    this->Test.Camera->SetFocalPoint(0, 0, -1);
    this->Test.Camera->SetFieldOfView(20);
    this->Test.Camera->SetClipRadii(Near, Far);
    this->Test.Pass()->SetTechnique(technique);
    for (int i = 0; i < 2; i++)
    {
      auto actor = MakeTestActor(this->Planes[i], i == 0, i, 0);
      actor->GetProperty()->LightingOff();
      this->Test.Renderer->AddActor(actor);
    }
  }

  // True where no pixel shows the farther wall, which is drawn last and wins ties.
  bool Resolves(int mapping, double distance, double step)
  {
    this->Test.Camera->SetDepthMapping(mapping);
    for (int i = 0; i < 2; i++)
    {
      const double d = i == 0 ? distance * (1 - step) : distance;
      this->Planes[i]->SetOrigin(-d, -d, -d);
      this->Planes[i]->SetPoint1(d, -d, -d);
      this->Planes[i]->SetPoint2(-d, d, -d);
    }
    this->Test.Window->Render();
    const TestPixels pixels(this->Test.Window);
    for (int j = 0; j < pixels.Height; j++)
    {
      for (int i = 0; i < pixels.Width; i++)
      {
        if (pixels.At(i, j)[0] < 200)
        {
          return false;
        }
      }
    }
    return true;
  }

  // The smallest power of two, of the distance, from which on every step is resolved.
  double SmallestStep(int mapping, double distance)
  {
    double step = 0.25;
    while (step > 1e-9 && this->Resolves(mapping, distance, step / 2))
    {
      step /= 2;
    }
    return step;
  }

private:
  WideFoVTestWindow Test;
  vtkNew<vtkPlaneSource> Planes[2];
};

// A part of the distance: the larger of what the buffer's step and what float32's (of the
// depth written, and of positions) make of it.
double Expected(int mapping, int bits, double rho)
{
  const double slope = mapping == vtkWideFoVCamera::LINEAR ? 1 / (Far - Near)
    : mapping == vtkWideFoVCamera::LOGARITHMIC             ? 1 / (rho * std::log(Far / Near))
                                                           : 1 / (rho * rho * (1 / Near - 1 / Far));
  const double depth = mapping == vtkWideFoVCamera::LINEAR ? (rho - Near) / (Far - Near)
    : mapping == vtkWideFoVCamera::LOGARITHMIC ? std::log(rho / Near) / std::log(Far / Near)
                                               : (1 / Near - 1 / rho) / (1 / Near - 1 / Far);
  const double step = std::max(std::exp2(-bits), depth * std::exp2(-24));
  return step / slope / rho;
}
}

// The table in Documentation/depth.md.
TEST(Depth, ResolvesWhatItsStepsAllow)
{
  // of the expected step: powers of two, and roundings that add up
  constexpr double Slack = 8;
  // relative: float32 positions and distances
  constexpr double Positions = 1e-6;
  std::cout << "smallest resolved step, part of the distance; near 1e-4, far 1\n"
               "bits stage    mapping      at 2e-4    1e-3     0.01     0.1      0.9\n";
  for (bool stencil : { false, true })
  {
    for (int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::VERTEX })
    {
      Walls walls(stencil, technique);
      for (int mapping : Mappings)
      {
        char text[100];
        std::snprintf(text, sizeof text, "%4d %-8s %-12s", stencil ? 24 : 32,
          technique == vtkWideFoVPass::EXACT ? "exact" : "vertex", Names[mapping]);
        std::string row = text;
        for (double distance : { 2e-4, 1e-3, 0.01, 0.1, 0.9 })
        {
          const double step = walls.SmallestStep(mapping, distance);
          std::snprintf(text, sizeof text, " %8.1e", step);
          row += text;
          const double expected = Expected(mapping, stencil ? 24 : 32, distance);
          EXPECT_LE(step, Slack * std::max(expected, Positions)) << row;
        }
        std::cout << row << std::endl;
      }
    }
  }
}
