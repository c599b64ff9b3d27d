// SPDX-License-Identifier: BSD-3-Clause
#include "StockEditScenes.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkContourValues.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkImageCanvasSource2D.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTexture.h"
#include "vtkTextureMapToSphere.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWideFoVDataPass.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVScreenCamera.h"

namespace stockScenes
{
using Window = WideFoVTestWindow;

vtkSmartPointer<vtkPolyData> Ball(bool normals = true)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(12);
  ball->SetPhiResolution(8);
  ball->SetCenter(0.1, 0.2, 2); // across the seam
  ball->SetRadius(0.8);
  ball->Update();
  if (!normals)
  {
    ball->GetOutput()->GetPointData()->SetNormals(nullptr);
  }
  return ball->GetOutput();
}

vtkActor* Add(Window& test, vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  test.Renderer->AddActor(actor);
  return actor;
}

vtkActor* Add(Window& test, vtkPolyData* data)
{
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return Add(test, mapper);
}

void AddLights(Window& test, bool positional)
{
  for (double x : { -1.0, 1.0 })
  {
    vtkNew<vtkLight> light;
    if (positional)
    {
      light->SetLightTypeToSceneLight();
      light->SetPositional(1);
      light->SetConeAngle(180);
    }
    else
    {
      light->SetLightTypeToCameraLight();
    }
    light->SetPosition(x, 1, 0.5);
    test.Renderer->AddLight(light);
  }
}

// Points behind the eye, with all that a sphere, stick, gaussian or glyph mapper asks for.
vtkSmartPointer<vtkPolyData> Points()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkFloatArray> sizes, stickSizes, axes;
  sizes->SetName("size");
  stickSizes->SetName("stick size");
  stickSizes->SetNumberOfComponents(3);
  axes->SetName("axis");
  axes->SetNumberOfComponents(3);
  for (int i = 0; i < 3; i++)
  {
    const vtkIdType id = points->InsertNextPoint(i - 0.9, 0.2, 2);
    verts->InsertNextCell(1, &id);
    sizes->InsertNextValue(0.3f);
    stickSizes->InsertNextTuple3(0.7, 0.2, 0.2);
    axes->InsertNextTuple3(0.1, 0.7, 0.2);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(verts);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->AddArray(stickSizes);
  data->GetPointData()->AddArray(axes);
  return data;
}

vtkSmartPointer<vtkPolyData> Line()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const vtkIdType ids[] = { points->InsertNextPoint(-1, 0, 2), points->InsertNextPoint(1, 0.3, 2) };
  lines->InsertNextCell(2, ids);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkProperty* Look(Window& test, vtkPolyData* data)
{
  return Add(test, data)->GetProperty();
}

void FillTexture(Window& test)
{
  vtkNew<vtkTextureMapToSphere> coordinates;
  coordinates->SetInputData(Ball());
  coordinates->Update();
  vtkNew<vtkImageCanvasSource2D> image;
  image->SetScalarTypeToUnsignedChar();
  image->SetNumberOfScalarComponents(3);
  image->SetExtent(0, 7, 0, 7, 0, 0);
  image->SetDrawColor(200, 100, 50);
  image->FillBox(0, 7, 0, 7);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(image->GetOutputPort());
  Add(test, vtkPolyData::SafeDownCast(coordinates->GetOutput()))->SetTexture(texture);
}

void FillClipped(Window& test)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0.2, 2);
  plane->SetNormal(1, 0, 0.2);
  Add(test, Ball())->GetMapper()->AddClippingPlane(plane);
}

// Of many triangles, or these would not be classified.
void FillCellColors(Window& test)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(80);
  ball->SetPhiResolution(80);
  ball->SetCenter(0.1, 0.2, 2);
  ball->Update();
  vtkPolyData* const data = ball->GetOutput();
  vtkNew<vtkFloatArray> colors;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); i++)
  {
    colors->InsertNextValue(static_cast<float>(i % 7));
  }
  data->GetCellData()->SetScalars(colors);
  Add(test, data);
}

void FillStrips(Window& test)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(Ball());
  stripper->Update();
  Add(test, stripper->GetOutput());
}

void FillComposite(Window& test)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Ball(false));
  blocks->SetBlock(1, Ball(false));
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  Add(test, mapper);
}

void FillGlyphs(Window& test)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(Points());
  vtkNew<vtkCubeSource> cube;
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.3);
  Add(test, mapper);
}

void FillBalls(Window& test)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(Points());
  mapper->SetScaleArray("size");
  Add(test, mapper);
}

void FillSticks(Window& test)
{
  // VTK's own mapper wants colours
  auto data = Points();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 3; i++)
  {
    colors->InsertNextTuple3(250, 200, 150);
  }
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("stick size");
  mapper->SetOrientationArray("axis");
  Add(test, mapper);
}

void FillSplats(Window& test)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(Points());
  mapper->SetScaleFactor(0.3);
  Add(test, mapper);
}

// Ranks are selected by the numbers of vertices.
void FillSelectedRanks(Window& test)
{
  vtkSmartPointer<vtkPolyData> ball = Ball();
  vtkNew<vtkUnsignedIntArray> ranks;
  ranks->SetName("ranks");
  ranks->SetNumberOfTuples(ball->GetNumberOfPoints());
  ranks->FillValue(1);
  ball->GetPointData()->AddArray(ranks);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputData(ball);
  mapper->SetProcessIdArrayName("ranks");
  Add(test, mapper);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetUseProcessIdFromData(true);
  selector->SetArea(0, 0, 47, 23);
  selector->CaptureBuffers();
}

void FillUsersPoints(Window& test)
{
  vtkActor* const actor = Add(test, Points());
  actor->GetProperty()->SetPointSize(8);
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
    "//VTK::Color::Impl\n  if (gl_PointCoord.x > 2.0) { discard; }\n", false);
}

void FillPeeled(Window& test)
{
  test.Renderer->UseDepthPeelingOn();
  test.Window->SetAlphaBitPlanes(1);
  Look(test, Ball())->SetOpacity(0.5);
  Look(test, Line())->SetOpacity(0.5);
}

void FillShifted(Window& test)
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  vtkProperty* const look = Look(test, Line());
  look->SetLineWidth(9);
  look->RenderLinesAsTubesOn();
  Add(test, Ball());
}

void FillSky(Window& test, int projection)
{
  vtkNew<vtkImageCanvasSource2D> picture;
  picture->SetScalarTypeToUnsignedChar();
  picture->SetNumberOfScalarComponents(3);
  picture->SetExtent(0, 7, 0, 7, 0, 0);
  picture->SetDrawColor(200, 150, 100);
  picture->FillBox(0, 7, 0, 7);
  picture->Update();
  vtkNew<vtkTexture> texture;
  texture->SetCubeMap(projection == vtkSkybox::Cube);
  for (int i = 0; i < (projection == vtkSkybox::Cube ? 6 : 1); i++)
  {
    texture->SetInputDataObject(i, picture->GetOutput());
  }
  vtkNew<vtkSkybox> sky;
  sky->SetProjection(projection);
  sky->SetFloorPlane(0, 1, 0, 1);
  sky->SetTexture(texture);
  test.Renderer->AddActor(sky);
}

void UseDataPass(Window& test)
{
  vtkNew<vtkWideFoVDataPass> data;
  data->SetDelegatePass(test.Renderer->GetPass());
  test.Renderer->SetPass(data);
}

void FillFlat(Window& test, vtkCamera* camera)
{
  camera->SetPosition(0, 0, 6);
  camera->SetFocalPoint(0, 0, 2);
  test.Renderer->SetActiveCamera(camera);
  Add(test, Ball());
}

// Behind the eye as well, and lit; shade: by the renderer's lights.
vtkGPUVolumeRayCastMapper* AddVolume(Window& test, bool shade)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-4, 4, -4, 4, -4, 4);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetShade(shade);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0.1);
  opacity->AddPoint(300, 0.3);
  volume->GetProperty()->SetScalarOpacity(opacity);
  test.Renderer->AddVolume(volume);
  return mapper;
}

void FillWarpedVolume(Window& test)
{
  test.Camera->SetStereoModelToWarped();
  test.Window->SetStereoTypeToLeft();
  test.Window->StereoRenderOn();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1, 0, 0.2);
  AddVolume(test, true)->AddClippingPlane(plane);
}

void FillVolumeOfDepthPass(Window& test)
{
  vtkGPUVolumeRayCastMapper* const mapper = AddVolume(test, false);
  mapper->UseDepthPassOn();
  // of no surface: those of a depth pass change nothing, and would have edits of their own
  mapper->GetDepthPassContourValues()->SetValue(0, 1e9);
}

// Which is not in the window: a ball is.
void FillImageOfVolume(Window& test)
{
  AddVolume(test, false)->RenderToImageOn();
  Add(test, Ball());
}

std::vector<Scene> VolumesByRays()
{
  return {
    { "volume", [](Window& t) { AddVolume(t, true); } },
    { "volume, light kit", [](Window& t) { AddLights(t, false), AddVolume(t, true); } },
    { "volume, as an image", FillImageOfVolume },
    { "volume, warped", FillWarpedVolume },
    { "volume, depth pass", FillVolumeOfDepthPass },
    { "volume, screen",
      [](Window& t) { AddVolume(t, true), FillFlat(t, vtkNew<vtkWideFoVScreenCamera>()); }, true },
  };
}

std::vector<Scene> Surfaces()
{
  return {
    { "lit", [](Window& t) { Add(t, Ball()); } },
    { "flat", [](Window& t) { Add(t, Ball(false)); } },
    { "light kit", [](Window& t) { AddLights(t, false), Add(t, Ball()); } },
    { "lamps", [](Window& t) { AddLights(t, true), Add(t, Ball()); } },
    { "PBR", [](Window& t) { Look(t, Ball())->SetInterpolationToPBR(); } },
    { "PBR, light kit",
      [](Window& t) { AddLights(t, false), Look(t, Ball())->SetInterpolationToPBR(); } },
    { "PBR, lamps",
      [](Window& t) { AddLights(t, true), Look(t, Ball())->SetInterpolationToPBR(); } },
    { "unlit", [](Window& t) { Look(t, Ball())->LightingOff(); } },
    { "by vertices", [](Window& t) { t.Pass()->SetTechniqueToVertex(), Add(t, Ball(false)); } },
    { "exact", [](Window& t) { t.Pass()->SetTechniqueToExact(), Add(t, Ball(false)); } },
    { "debug view", [](Window& t) { t.Pass()->DebugViewOn(), FillTexture(t); } },
    { "edges", [](Window& t) { Look(t, Ball())->EdgeVisibilityOn(); } },
    { "texture", FillTexture },
    { "clipped", FillClipped },
    { "clipped, exact", [](Window& t) { t.Pass()->SetTechniqueToExact(), FillClipped(t); } },
    { "cell colors", FillCellColors },
    { "strips", FillStrips },
  };
}

std::vector<Scene> Lines()
{
  return {
    { "wireframe", [](Window& t) { Look(t, Ball())->SetRepresentationToWireframe(); } },
    { "wireframe, flat", [](Window& t) { Look(t, Ball(false))->SetRepresentationToWireframe(); } },
    { "lines", [](Window& t) { Add(t, Line()); } },
    { "wide lines", [](Window& t) { Look(t, Line())->SetLineWidth(9); } },
    { "lines wider than OpenGL draws", [](Window& t) { Look(t, Line())->SetLineWidth(300); } },
    { "coincident lines",
      [](Window& t) {
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
        Add(t, Line());
      } },
    { "tubes",
      [](Window& t) {
        Look(t, Line())->SetLineWidth(9);
        t.Renderer->GetActors()->GetLastActor()->GetProperty()->RenderLinesAsTubesOn();
      } },
  };
}

std::vector<Scene> Others()
{
  return {
    { "points", [](Window& t) { Look(t, Points())->SetPointSize(8); } },
    { "points of a user's", FillUsersPoints },
    { "selected ranks", FillSelectedRanks },
    { "coincident", FillShifted },
    { "points as spheres",
      [](Window& t) {
        Look(t, Points())->SetPointSize(8);
        t.Renderer->GetActors()->GetLastActor()->GetProperty()->RenderPointsAsSpheresOn();
      } },
    { "balls", FillBalls },
    { "sticks", FillSticks },
    { "splats", FillSplats },
    { "glyphs", FillGlyphs },
    { "composite", FillComposite },
    { "peeled", FillPeeled },
    { "sky, cube", [](Window& t) { FillSky(t, vtkSkybox::Cube); } },
    { "sky, sphere", [](Window& t) { FillSky(t, vtkSkybox::Sphere); } },
    { "sky, a sphere an eye", [](Window& t) { FillSky(t, vtkSkybox::StereoSphere); } },
    { "sky, floor", [](Window& t) { FillSky(t, vtkSkybox::Floor); } },
    { "data", [](Window& t) { Add(t, Ball()), UseDataPass(t); } },
    { "data, flat camera", [](Window& t) { FillFlat(t, vtkNew<vtkCamera>()), UseDataPass(t); },
      true },
    { "screen", [](Window& t) { FillFlat(t, vtkNew<vtkWideFoVScreenCamera>()); }, true },
    { "screen, light kit",
      [](Window& t) { AddLights(t, false), FillFlat(t, vtkNew<vtkWideFoVScreenCamera>()); }, true },
  };
}

const std::vector<Scene>& All()
{
  static const std::vector<Scene> scenes = [] {
    std::vector<Scene> all = Surfaces();
    for (const std::vector<Scene>& more : { Lines(), Others(), VolumesByRays() })
    {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return scenes;
}
}
