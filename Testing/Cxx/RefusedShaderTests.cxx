// SPDX-License-Identifier: BSD-3-Clause
// Shaders that the graphics driver does not take: one error, and the prop is left out. VTK itself
// crashes there, or draws with another prop's program.
#include "Compat/Reports.h"
#include "Overheard.h"
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
// What VTK says meanwhile, of shaders that nothing was said of before.
struct OverheardAnew : Overheard
{
  OverheardAnew() { wfv::ForgetReports(); }
};

using Adder = std::function<void(vtkShaderProperty*)>;

const char* const Light = "//VTK::Light::Impl";

struct Damage
{
  const char* Name;
  const char* Says; // of the error
  Adder Add;
};

// Of each stage and of the program, before and behind what the pass makes of the text.
const std::vector<Damage>& AllDamage()
{
  static const std::vector<Damage> all{
    { "fragment", "fragment shader of a vtk",
      [](vtkShaderProperty* p) {
        p->AddFragmentShaderReplacement(
          Light, true, std::string(Light) + "\n  fragOutput0 = nowhere;\n", false);
      } },
    { "fragment, afterwards", "fragment shader of a vtk",
      [](vtkShaderProperty* p) {
        p->AddFragmentShaderReplacement("gl_FragData", false, "nowhere", true);
        p->AddFragmentShaderReplacement("fragOutput0 =", false, "nowhere =", true);
      } },
    { "vertex", "vertex shader of a vtk",
      [](vtkShaderProperty* p) {
        p->AddVertexShaderReplacement(
          "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nnowhere\n", false);
      } },
    { "program", "program of a vtk",
      [](vtkShaderProperty* p) {
        p->AddVertexShaderReplacement(
          "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nout vec4 twoKinds;\n", false);
        p->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
          "//VTK::PositionVC::Impl\n  twoKinds = vec4(1.0);\n", false);
        p->AddFragmentShaderReplacement(
          "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nvec4 undefined();\n", false);
        p->AddFragmentShaderReplacement(
          Light, true, std::string(Light) + "\n  fragOutput0 = undefined();\n", false);
      } },
  };
  return all;
}

struct Scene
{
  Scene(int technique, int samples)
    : Test("equirectangular", 64, 32)
  {
    this->Test.Window->SetMultiSamples(samples);
    this->Test.Renderer->SetBackground(0, 0, 0);
    this->Test.Pass()->SetTechnique(technique);
    vtkNew<vtkConeSource> cone;
    cone->SetCenter(-3, 0, 0);
    this->Test.Renderer->AddActor(MakeTestActor(cone, 0.2, 0.5, 0.9));
  }

  std::vector<unsigned char> Draw()
  {
    this->Test.Window->Render();
    return TestPixels(this->Test.Window).Copy();
  }

  WideFoVTestWindow Test;
};

// Of many triangles, so that some are projected and others are not.
vtkSmartPointer<vtkActor> MakeBall()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(2);
  ball->SetCenter(0.5, 1.5, 0);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  return MakeTestActor(ball, 0.9, 0.5, 0.2);
}

vtkSmartPointer<vtkActor> MakeGlyphs()
{
  vtkNew<vtkPlaneSource> places;
  places->SetOrigin(2, -1, -1);
  places->SetPoint1(2, 1, -1);
  places->SetPoint2(2, -1, 1);
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(places->GetOutputPort());
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(0.5);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor;
}

// With the damaged prop: the picture without it, and one error in three frames.
void CheckLeftOut(int technique, int samples, vtkActor* actor, const Damage& damage)
{
  SCOPED_TRACE(std::string(damage.Name) + ", technique " + std::to_string(technique) +
    ", samples " + std::to_string(samples));
  const std::vector<unsigned char> without = Scene(technique, samples).Draw();
  const OverheardAnew vtk;
  Scene scene(technique, samples);
  damage.Add(actor->GetShaderProperty());
  scene.Test.Renderer->AddActor(actor);
  EXPECT_EQ(scene.Draw(), without);
  scene.Test.Camera->Yaw(10);
  scene.Draw();
  scene.Test.Camera->Yaw(-10);
  EXPECT_EQ(scene.Draw(), without);
  EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
  EXPECT_EQ(vtk.Count(damage.Says), 1) << vtk.All();
  EXPECT_EQ(vtk.Count("void main"), 0) << vtk.All();
}
}

TEST(RefusedShaders, AreSaidOnceAndLeaveThePropOut)
{
  for (const Damage& damage : AllDamage())
  {
    for (const int technique :
      { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT, vtkWideFoVPass::VERTEX })
    {
      CheckLeftOut(technique, 0, MakeBall(), damage);
    }
    CheckLeftOut(vtkWideFoVPass::AUTO, 4, MakeBall(), damage);
  }
}

TEST(RefusedShaders, OfGlyphsAreLeftOutToo)
{
  for (const Damage& damage : AllDamage())
  {
    CheckLeftOut(vtkWideFoVPass::AUTO, 0, MakeGlyphs(), damage);
  }
}

// VTK's own pass then has its say behind ours.
TEST(RefusedShaders, OfPeeledPropsAreLeftOutToo)
{
  for (const Damage& damage : AllDamage())
  {
    SCOPED_TRACE(damage.Name);
    const OverheardAnew vtk;
    Scene scene(vtkWideFoVPass::AUTO, 0);
    const std::vector<unsigned char> without = scene.Draw();
    scene.Test.Renderer->UseDepthPeelingOn();
    auto ball = MakeBall();
    ball->GetProperty()->SetOpacity(0.5);
    damage.Add(ball->GetShaderProperty());
    scene.Test.Renderer->AddActor(ball);
    EXPECT_EQ(scene.Draw(), without);
    EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
  }
}

// A mended prop is drawn, as if nothing had been.
TEST(RefusedShaders, AreForgottenWithWhatWasWrong)
{
  Scene whole(vtkWideFoVPass::AUTO, 0);
  whole.Test.Renderer->AddActor(MakeBall());
  const std::vector<unsigned char> wanted = whole.Draw();
  for (const Damage& damage : AllDamage())
  {
    SCOPED_TRACE(damage.Name);
    const OverheardAnew vtk;
    Scene scene(vtkWideFoVPass::AUTO, 0);
    auto ball = MakeBall();
    damage.Add(ball->GetShaderProperty());
    scene.Test.Renderer->AddActor(ball);
    EXPECT_NE(scene.Draw(), wanted);
    ball->GetShaderProperty()->ClearAllShaderReplacements();
    EXPECT_EQ(scene.Draw(), wanted);
    EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
  }
}

// What is tried out is what the mapper draws with: nothing is compiled twice.
TEST(RefusedShaders, CostNoFurtherPrograms)
{
  Scene scene(vtkWideFoVPass::AUTO, 0);
  scene.Test.Renderer->AddActor(MakeBall());
  scene.Draw();
  const int before = scene.Test.Pass()->GetNumberOfMadePrograms();
  auto other = MakeBall();
  other->SetScale(0.5);
  scene.Test.Renderer->AddActor(other);
  scene.Draw();
  EXPECT_EQ(scene.Test.Pass()->GetNumberOfMadePrograms(), before);
}
