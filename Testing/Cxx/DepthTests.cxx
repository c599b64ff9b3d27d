// SPDX-License-Identifier: BSD-3-Clause
// The depth mappings as drawn: one picture, three depth buffers, and what each resolves.
#include "WideFoVTestScene.h"

#include "Projections/Projection.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"
#include "vtkTranslucentPass.h"
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
const int DepthMappings[] = { vtkWideFoVCamera::LINEAR, vtkWideFoVCamera::LOGARITHMIC,
  vtkWideFoVCamera::REVERSED };
const char* const Names[] = { "linear", "logarithmic", "reversed" };
const char* const WideProjections[] = { "equirectangular", "hammer", "azimuthal-equidistant" };

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

namespace
{
// Draws by a data pass that knows the props by their order.
void UseDataPass(WideFoVTestWindow& test, vtkWideFoVDataPass* data)
{
  data->SetDelegatePass(test.Pass());
  vtkActorCollection* actors = test.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); i++)
  {
    data->SetPropIndex(vtkProp::SafeDownCast(actors->GetItemAsObject(i)), i);
  }
  test.Renderer->SetPass(data);
}

// The cells; none for lines and points, which conflict where they meet: a pixel on a shared
// vertex is at one distance in several of them.
std::vector<float> SurfaceCells(vtkImageData* image)
{
  constexpr int Surfaces = 10; // the room, eight cones, a ball
  std::vector<float> cells = Values(image, "cell");
  const std::vector<float> props = Values(image, "prop");
  for (size_t i = 0; i < cells.size(); i++)
  {
    cells[i] = props[i] <= Surfaces ? cells[i] : 0;
  }
  return cells;
}

long Different(const std::vector<float>& a, const std::vector<float>& b)
{
  long n = 0;
  for (size_t i = 0; i < a.size(); i++)
  {
    n += a[i] != b[i];
  }
  return n;
}

vtkSmartPointer<vtkRenderPass> MakePassesThatBlend()
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}
}

// By these passes alone they are blended as they come, the nearer one first. Behind them something
// opaque, for which the nearest is kept.
TEST(Depth, TranslucentSheetsHideNothing)
{
  std::vector<unsigned char> middles;
  for (int technique : { vtkWideFoVPass::PRECLIP, vtkWideFoVPass::EXACT })
  {
    WideFoVTestWindow test("hammer", 64, 32);
    test.Pass()->SetTechnique(technique);
    test.Pass()->SetDelegatePass(MakePassesThatBlend());
    test.Renderer->AddActor(MakeTestRoom());
    for (double distance : { 0.25, 0.5 })
    {
      vtkNew<vtkPlaneSource> sheet;
      sheet->SetResolution(20, 20);
      sheet->SetCenter(0, 0, -distance);
      auto actor = MakeTestActor(sheet, 4 * distance - 1, 0.5, 2 - 4 * distance);
      actor->GetProperty()->SetOpacity(0.5);
      test.Renderer->AddActor(actor);
    }
    test.Window->Render();
    const TestPixels pixels(test.Window);
    middles.insert(middles.end(), pixels.At(32, 16), pixels.At(32, 16) + 3);
  }
  for (int i = 0; i < 3; i++)
  {
    EXPECT_NEAR(middles[i], middles[3 + i], 1); // of 255: colours are rounded
    EXPECT_GT(middles[i], 20);
  }
}

TEST(Depth, ThePictureIsTheSameInEveryMappingAndInTheDebugView)
{
  for (const char* projection : WideProjections)
  {
    for (int technique : { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT })
    {
      WideFoVTestWindow test(projection, 256, 128);
      Furnish(test.Renderer);
      // the automatic near sphere would leave REVERSED too few steps for the silhouettes
      test.Camera->SetClipRadii(0.1, 10);
      vtkSmartPointer<vtkWideFoVPass> pass = test.Pass();
      pass->SetTechnique(technique);
      vtkNew<vtkWideFoVDataPass> data;
      UseDataPass(test, data);
      test.Window->Render();
      const std::vector<float> props = Values(data->GetOutput(), "prop");
      const std::vector<float> all = Values(data->GetOutput(), "cell");
      const std::vector<float> cells = SurfaceCells(data->GetOutput());
      EXPECT_EQ(*std::max_element(props.begin(), props.end()), 12) << projection;
      for (int mapping : { vtkWideFoVCamera::LOGARITHMIC, vtkWideFoVCamera::REVERSED })
      {
        test.Camera->SetDepthMapping(mapping);
        test.Window->Render();
        const std::string what = std::string(projection) + " " + Names[mapping];
        EXPECT_EQ(Different(Values(data->GetOutput(), "prop"), props), 0) << what << technique;
        EXPECT_EQ(Different(SurfaceCells(data->GetOutput()), cells), 0) << what << technique;
      }
      if (technique != vtkWideFoVPass::AUTO)
      {
        continue; // its debug view is of one colour
      }
      test.Camera->SetDepthMapping(vtkWideFoVCamera::LINEAR);
      pass->DebugViewOn();
      test.Window->Render();
      EXPECT_EQ(Different(Values(data->GetOutput(), "prop"), props), 0) << projection << technique;
      EXPECT_EQ(Different(Values(data->GetOutput(), "cell"), all), 0) << projection << technique;
    }
  }
}

namespace
{
// Of the depth buffer from the mapping of the distances, over the pixels with a surface.
struct DepthErrors
{
  int Seen = 0;
  int Above = 0; // those farther off than `rounding`
  double Worst = 0;
};

DepthErrors Compare(
  const std::vector<float>& distance, vtkFloatArray* z, const wfv::WfvView& view, double rounding)
{
  DepthErrors errors;
  for (size_t i = 0; i < distance.size(); i++)
  {
    if (std::isfinite(distance[i]))
    {
      const double error = std::abs(z->GetValue(i) - wfv::wfvDepthOf(distance[i], view));
      errors.Seen++;
      errors.Above += error >= rounding;
      errors.Worst = std::max(errors.Worst, error);
    }
  }
  return errors;
}
}

// What the buffer holds is the mapping of the distance that the data pass shows.
TEST(Depth, TheBufferHoldsTheMappingOfTheDistance)
{
  // of float32 depth and of the distance that it comes from, by a float32 logarithm
  constexpr double Rounding = 2e-6;
  // where a surface is seen nearly edge-on, its plane and its corners give distances apart
  // by that rounding over the sine of the angle; in a few pixels only
  constexpr double Grazing = 2e-5;
  constexpr int FewPixels = 8;
  for (const char* projection : WideProjections)
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
      const DepthErrors errors = Compare(distance, z, view, Rounding);
      EXPECT_GT(errors.Seen, 128 * 100) << projection;
      EXPECT_LE(errors.Above, FewPixels) << projection << " " << Names[mapping];
      EXPECT_LT(errors.Worst, Grazing) << projection << " " << Names[mapping];
    }
  }
}

namespace
{
constexpr double Near = 1e-4;
constexpr double Far = 1;

// Of its distance: a wall fills a view of 20 degrees and stays inside the far sphere.
constexpr double HalfWall = 0.2;

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
      const double half = HalfWall * d;
      this->Planes[i]->SetOrigin(-half, -half, -d);
      this->Planes[i]->SetPoint1(half, -half, -d);
      this->Planes[i]->SetPoint2(-half, half, -d);
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
      for (int mapping : DepthMappings)
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
          // a rasterizer that interpolates depth has it in [-1, 1]: a bit of float32 less
          const bool rasterized =
            technique == vtkWideFoVPass::VERTEX && mapping == vtkWideFoVCamera::LINEAR;
          const double expected = Expected(mapping, stencil || rasterized ? 24 : 32, distance);
          EXPECT_LE(step, Slack * std::max(expected, Positions)) << row;
        }
        std::cout << row << std::endl;
      }
    }
  }
}
