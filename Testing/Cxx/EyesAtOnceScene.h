// SPDX-License-Identifier: BSD-3-Clause
// A window that looks at what each eye is shown.
#ifndef EyesAtOnceScene_h
#define EyesAtOnceScene_h

#include "WideFoVTestScene.h"

#include "vtkWideFoVPolyDataMapper.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace eyes
{
// What a renderer had drawn for one eye, and how.
struct Seen
{
  std::vector<unsigned char> Colors;
  std::vector<float> Depths;
  int Eye = 0;
  int Shared = 0;
  int Far = 0;
  int Draws = 0;
  int PlainDraws = 0;
  vtkIdType LeftOut = 0; // triangles
  int Culled = 0;
};

// A window that looks at each eye's picture when it is drawn.
struct EyesScene : WideFoVTestWindow
{
  explicit EyesScene(const char* projection, const char* model, int samples = 0)
    : WideFoVTestWindow(projection, 200, 100)
  {
    this->Window->SetMultiSamples(samples);
    this->Window->StereoRenderOn();
    this->Window->SetStereoType(VTK_STEREO_RED_BLUE);
    this->Camera->SetStereoModel(model);
    this->Camera->SetInterpupillaryDistance(0.2);
    this->Pass()->SetTechnique(vtkWideFoVPass::EXACT);
    this->Pass()->SetEyesAtOnce(vtkWideFoVPass::ALWAYS);
    vtkNew<vtkCallbackCommand> look;
    look->SetClientData(this);
    look->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<EyesScene*>(self)->Look(); });
    this->Renderer->AddObserver(vtkCommand::EndEvent, look);
  }

  // A room and cones; nothing there is sorted.
  void AddRoom()
  {
    this->Renderer->AddActor(MakeTestRoom());
    AddTestCones(this->Renderer);
  }

  // Coloured by height, of a mapper that sorts; the renderer keeps it.
  vtkActor* AddSorted(vtkAlgorithm* source)
  {
    vtkNew<vtkElevationFilter> colors;
    colors->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputConnection(colors->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  // A ring of so many times 10,000 triangles round the eye, of a mapper that sorts them.
  vtkActor* AddRing(int fineness = 1)
  {
    vtkNew<vtkRegularPolygonSource> circle;
    circle->SetNumberOfSides(160 * fineness);
    circle->SetRadius(1.2);
    circle->GeneratePolygonOff();
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputConnection(circle->GetOutputPort());
    tube->SetRadius(0.25);
    tube->SetNumberOfSides(32);
    vtkNew<vtkTriangleFilter> source;
    source->SetInputConnection(tube->GetOutputPort());
    vtkActor* const ring = this->AddSorted(source);
    ring->RotateX(70);
    return ring;
  }

  // A ball ahead whose nearest point is so far from the eye.
  vtkActor* AddBall(double nearest, double radius)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(radius);
    ball->SetThetaResolution(60);
    ball->SetPhiResolution(60);
    vtkActor* const actor = this->AddSorted(ball);
    this->PlaceBall(actor, nearest, radius);
    return actor;
  }

  void PlaceBall(vtkActor* ball, double nearest, double radius)
  {
    double eye[3];
    this->Camera->GetPosition(eye);
    ball->SetPosition(eye[0], eye[1], eye[2] - nearest - radius);
  }

  // The room again, in 768 triangles that are sorted, some of them cut in pieces for each eye.
  void AddSortedRoom()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(4.1);
    cube->SetYLength(3.1);
    cube->SetZLength(5.1);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkLinearSubdivisionFilter> finer;
    finer->SetInputConnection(triangles->GetOutputPort());
    finer->SetNumberOfSubdivisions(3);
    this->AddSorted(finer);
  }

  // What is drawn in each eye's turn: lines, what shines through, text.
  void AddOthers()
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeGraticule(1.4, 30, false));
    vtkNew<vtkActor> lines;
    lines->SetMapper(mapper);
    this->Renderer->AddActor(lines);
    vtkNew<vtkConeSource> cone;
    cone->SetCenter(0.2, 0, -0.8);
    vtkSmartPointer<vtkActor> glass = MakeTestActor(cone, 0.2, 1, 0.3);
    glass->GetProperty()->SetOpacity(0.5);
    this->Renderer->AddActor(glass);
    vtkNew<vtkTextActor> text;
    text->SetInput("both");
    this->Renderer->AddActor(text);
  }

  void Look()
  {
    // its own part of the window, beside which there is anything
    int size[2];
    int from[2];
    this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &from[0], &from[1]);
    const int to[2] = { from[0] + size[0] - 1, from[1] + size[1] - 1 };
    vtkNew<vtkUnsignedCharArray> colors;
    vtkNew<vtkFloatArray> depths;
    this->Window->GetRGBACharPixelData(from[0], from[1], to[0], to[1], 0, colors);
    this->Window->GetZbufferData(from[0], from[1], to[0], to[1], depths);
    Seen seen;
    seen.Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
    seen.Depths.assign(depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
    seen.Eye = this->Camera->GetCurrentEye();
    vtkWideFoVPass* const pass = this->Pass();
    seen.Shared = pass->GetNumberOfSharedProps();
    seen.Far = pass->GetNumberOfFarProps();
    seen.Draws = pass->GetNumberOfExactDraws() + pass->GetNumberOfPlainDraws() +
      pass->GetNumberOfPreClipDraws();
    seen.LeftOut = pass->GetNumberOfCulledTriangles();
    seen.PlainDraws = pass->GetNumberOfPlainDraws();
    seen.Culled = pass->GetNumberOfCulledProps();
    this->Eyes.push_back(seen);
  }

  // The eyes of the next frame.
  std::vector<Seen> Draw()
  {
    this->Eyes.clear();
    this->Window->Render();
    return this->Eyes;
  }

  // The same in two traversals.
  std::vector<Seen> DrawTwice()
  {
    vtkWideFoVPass* const pass = this->Pass();
    const int before = pass->GetEyesAtOnce();
    pass->SetEyesAtOnce(vtkWideFoVPass::NEVER);
    std::vector<Seen> seen = this->Draw();
    pass->SetEyesAtOnce(before);
    return seen;
  }

  std::vector<Seen> Eyes;
};
}

#endif
