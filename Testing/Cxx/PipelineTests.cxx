// SPDX-License-Identifier: BSD-3-Clause
// What a change of view costs: no buffer is rebuilt for a projection or a field of
// view, no shader for a field of view; triangles are split where they must be.
#include "Overheard.h"
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
// What the mapper keeps to itself.
class Inside : public vtkOpenGLPolyDataMapper
{
public:
  static vtkMTimeType BuildTime(vtkMapper* mapper)
  {
    auto* self = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
    return (self->*(&Inside::VBOBuildTime)).GetMTime();
  }
};

// The programs that a mapper drew its last frame with.
struct Programs
{
  explicit Programs(vtkMapper* mapper)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* program) {
      static_cast<Programs*>(self)->Used.insert(static_cast<vtkShaderProgram*>(program));
    });
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
  }
  std::set<vtkShaderProgram*> Used;
  vtkNew<vtkCallbackCommand> Command;
};

vtkSmartPointer<vtkActor> Ball(double x, double y, double z)
{
  vtkNew<vtkSphereSource> ball;
  // edges of a few degrees, as seen from two away
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  ball->SetCenter(x, y, z);
  ball->SetRadius(0.3);
  auto actor = MakeTestActor(ball, 1, 1, 1);
  vtkNew<vtkWideFoVPolyDataMapper> mapper; // which splits triangles
  mapper->SetInputConnection(ball->GetOutputPort());
  actor->SetMapper(mapper);
  return actor;
}

// A ball behind the eye, drawn once.
struct Drawn
{
  Drawn()
  {
    this->Test.Renderer->AddActor(this->Actor);
    this->Test.Window->Render();
  }
  WideFoVTestWindow Test{ "equirectangular", 100, 50 };
  vtkSmartPointer<vtkActor> Actor = Ball(0, 0, 2);
  Programs Shaders{ this->Actor->GetMapper() };
};
}

TEST(Pipeline, AFieldOfViewCostsNoShaderAndNoBuffer)
{
  Drawn drawn;
  WideFoVTestWindow& test = drawn.Test;
  const vtkMTimeType built = Inside::BuildTime(drawn.Actor->GetMapper());
  const std::set<vtkShaderProgram*> first = drawn.Shaders.Used;
  ASSERT_EQ(first.size(), 1u);
  const vtkMTimeType compiled = (*first.begin())->GetMTime();
  for (double fov : { 300.0, 200.0, 90.0 })
  {
    test.Camera->SetHorizontalFieldOfView(fov);
    test.Camera->SetVerticalFieldOfView(fov / 2);
    test.Camera->SetTilt(fov / 10);
    test.Window->Render();
  }
  EXPECT_EQ(drawn.Shaders.Used, first);
  EXPECT_EQ((*first.begin())->GetMTime(), compiled);
  EXPECT_EQ(Inside::BuildTime(drawn.Actor->GetMapper()), built);
}

TEST(Pipeline, AProjectionCostsOneShaderOnceAndNoBuffer)
{
  Drawn drawn;
  WideFoVTestWindow& test = drawn.Test;
  const vtkMTimeType built = Inside::BuildTime(drawn.Actor->GetMapper());
  test.Camera->SetProjectionToHammer();
  test.Window->Render();
  EXPECT_EQ(drawn.Shaders.Used.size(), 2u);
  test.Camera->SetProjectionToEquirectangular();
  test.Window->Render();
  test.Camera->SetProjectionToHammer();
  test.Window->Render();
  EXPECT_EQ(drawn.Shaders.Used.size(), 2u); // both came from the cache
  EXPECT_EQ(Inside::BuildTime(drawn.Actor->GetMapper()), built);
}

// Pixels: no edge bends by so much.
constexpr double AnyCurvature = 1000;

namespace
{
// True where the pass has split triangles of the frame before it drew them, which takes one draw.
bool HasSplit(WideFoVTestWindow& test)
{
  vtkWideFoVPass* const pass = test.Pass();
  EXPECT_EQ(pass->GetNumberOfPreClipDraws(), 0);
  EXPECT_EQ(pass->GetNumberOfProjectedDraws(), 1);
  return pass->GetNumberOfProjectedTriangles() <
    pass->GetNumberOfTriangles() - pass->GetNumberOfCulledTriangles();
}
}

TEST(Pipeline, TrianglesAreSplitWhereEdgesBend)
{
  WideFoVTestWindow test("equirectangular", 1600, 800);
  test.Renderer->AddActor(Ball(0, 0.55, -0.55));
  // the tolerance counts, whether the view moves or stands
  for (const double rate : { 15.0, 0.001 })
  {
    test.Window->SetDesiredUpdateRate(rate);
    for (const double tolerance : { AnyCurvature, 0.05, AnyCurvature })
    {
      test.Pass()->SetTolerance(tolerance);
      test.Window->Render();
      EXPECT_EQ(HasSplit(test), tolerance < 1) << rate << " " << tolerance;
    }
  }
  // the technique for comparison looks at discontinuities alone
  test.Pass()->SetTechniqueToPreClip();
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetNumberOfPreClipDraws(), 0);
}

TEST(Pipeline, TrianglesAreSplitWhereADiscontinuityIsMet)
{
  const struct
  {
    double Position[3];
    bool Split;
  } places[] = { { { 0, 0, -2 }, false }, { { 2, 0, 0 }, false }, { { 0, 0, 2 }, true },
    { { 0, 2, 0 }, true }, { { 0.1, 0, 0.1 }, true } };
  for (const auto& place : places)
  {
    WideFoVTestWindow test("equirectangular", 100, 50);
    test.Pass()->SetTolerance(AnyCurvature);
    test.Renderer->AddActor(Ball(place.Position[0], place.Position[1], place.Position[2]));
    test.Window->Render();
    EXPECT_EQ(HasSplit(test), place.Split) << place.Position[2];
  }
}

// Of a round map that is the antipode alone; what is ahead may lie round the axis.
TEST(Pipeline, TheMiddleOfADomeIsNoDiscontinuity)
{
  for (const double z : { -2.0, 2.0 })
  {
    WideFoVTestWindow test("azimuthal-equidistant", 100, 100);
    test.Pass()->SetTolerance(AnyCurvature);
    test.Window->SetDesiredUpdateRate(15);
    test.Renderer->AddActor(Ball(0, 0, z));
    test.Window->Render();
    EXPECT_EQ(HasSplit(test), z > 0) << z;
  }
}

TEST(Pipeline, OneActorInAViewThatTurnsKeepsItsBuffers)
{
  WideFoVTestWindow test("azimuthal-equidistant", 64, 64);
  test.Pass()->SetTolerance(AnyCurvature);
  auto ball = Ball(0, 0, 2);
  test.Renderer->AddActor(ball);
  test.Window->Render();
  const vtkMTimeType built = Inside::BuildTime(ball->GetMapper());
  int split = 0;
  for (int i = 0; i < 12; i++)
  {
    test.Camera->Yaw(30);
    test.Window->Render();
    split += HasSplit(test);
  }
  EXPECT_GT(split, 0);
  EXPECT_LT(split, 12);
  EXPECT_EQ(Inside::BuildTime(ball->GetMapper()), built);
}

// Seen by its edges, whose pixels several triangles share.
TEST(Pipeline, TheFirstFrameReckonsWithItsSamples)
{
  for (const int samples : { 4, 0 })
  {
    WideFoVTestWindow test("equirectangular", 256, 128);
    test.Window->SetMultiSamples(samples);
    test.Renderer->AddActor(Ball(0.2, 0.1, 2));
    test.Window->Render();
    const TestPixels first(test.Window);
    test.Window->Render();
    const TestPixels second(test.Window);
    int different = 0;
    for (vtkIdType i = 0; i < first.Data->GetNumberOfValues(); i++)
    {
      different += first.Data->GetValue(i) != second.Data->GetValue(i);
    }
    EXPECT_GT(first.Data->GetNumberOfValues(), 0);
    EXPECT_EQ(different, 0) << samples << " samples";
  }
}

// Not even an empty list is left.
TEST(Pipeline, PropsAreLeftAsTheyWere)
{
  WideFoVTestWindow test("hammer", 64, 32);
  auto ball = Ball(0, 0, 2);
  auto named = Ball(0.5, 0, 2);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkDataObject::FIELD_ARRAY_TYPE(), 7);
  named->SetPropertyKeys(keys);
  auto part = Ball(-0.5, 0, 2);
  vtkNew<vtkAssembly> assembly; // hands its keys on
  assembly->AddPart(part);
  vtkNew<vtkTextActor> text;
  text->SetInput("beside");
  for (vtkProp* prop : { static_cast<vtkProp*>(ball), static_cast<vtkProp*>(named),
         static_cast<vtkProp*>(assembly), static_cast<vtkProp*>(text) })
  {
    test.Renderer->AddViewProp(prop);
  }
  for (int i = 0; i < 3; i++)
  {
    test.Window->Render();
    EXPECT_EQ(test.Pass()->GetNumberOfDrawnProps(), 4);
    EXPECT_EQ(ball->GetPropertyKeys(), nullptr);
    EXPECT_EQ(named->GetPropertyKeys(), keys);
    EXPECT_EQ(keys->Get(vtkDataObject::FIELD_ARRAY_TYPE()), 7);
    EXPECT_EQ(keys->GetNumberOfKeys(), 1);
    for (vtkProp* prop :
      { static_cast<vtkProp*>(part), static_cast<vtkProp*>(assembly), static_cast<vtkProp*>(text) })
    {
      vtkInformation* const left = prop->GetPropertyKeys();
      EXPECT_TRUE(!left || !left->Has(vtkOpenGLRenderPass::RenderPasses()));
    }
    test.Camera->Yaw(30);
  }
}

// A pass of somebody else's stays in the list, and is called beside the stage.
TEST(Pipeline, OtherPassesOfAPropStay)
{
  struct Counts : public vtkOpenGLRenderPass
  {
    static Counts* New() { return new Counts; }
    void Render(const vtkRenderState*) override {}
    bool PostReplaceShaderValues(
      std::string&, std::string&, std::string&, vtkAbstractMapper*, vtkProp*) override
    {
      this->Calls++;
      return true;
    }
    int Calls = 0;
  };
  WideFoVTestWindow test("hammer", 64, 32);
  auto ball = Ball(0, 0, 2);
  test.Renderer->AddActor(ball);
  vtkNew<Counts> other;
  vtkNew<vtkInformation> keys;
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), other);
  ball->SetPropertyKeys(keys);
  test.Window->Render();
  EXPECT_GT(other->Calls, 0);
  ASSERT_EQ(keys->Length(vtkOpenGLRenderPass::RenderPasses()), 1);
  EXPECT_EQ(keys->Get(vtkOpenGLRenderPass::RenderPasses(), 0), other);
  EXPECT_TRUE(HasSplit(test));
}

// The old name of a technique, for one release.
TEST(Pipeline, TessellateIsAutoAndSaysSoOnce)
{
  const Overheard said;
  vtkNew<vtkWideFoVPass> pass;
  pass->SetTechniqueToExact();
  for (int i = 0; i < 2; i++)
  {
    pass->SetTechniqueToTessellate();
    EXPECT_EQ(pass->GetTechnique(), vtkWideFoVPass::AUTO);
  }
  EXPECT_EQ(said.Count("The technique tessellate is called auto"), 1);
  EXPECT_EQ(pass->GetNumberOfTessellateDraws(), 0);
}
