// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVDataPass.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVRenderer.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>

#include <cstdio>

namespace wfv
{
namespace test
{
struct Drawing::Internals
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkWideFoVDataPass> Data;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkWideFoVPolyDataMapper> WideMapper; // refines triangles
  vtkNew<vtkActor> Actor;
  std::unique_ptr<View> LastView;
  bool DrawsPerspective = false;
};

Drawing::Drawing()
  : Internal(new Internals)
{
  Internals& in = *this->Internal;
  in.Window->SetOffScreenRendering(1);
  in.Window->SetMultiSamples(0);
  in.Window->AddRenderer(in.Renderer);
  in.Renderer->SetActiveCamera(in.Camera);
  in.Actor->SetMapper(in.Mapper);
  in.Renderer->AddActor(in.Actor);
  in.Pass->SetTechniqueToPreClip();
  in.Data->SetPropIndex(in.Actor, 0);
  in.Data->SetDelegatePass(in.Pass);
  in.Renderer->SetPass(in.Data);
}

Drawing::~Drawing() = default;

void Drawing::SetMesh(vtkPolyData* mesh)
{
  this->Internal->Mapper->SetInputData(mesh);
  this->Internal->WideMapper->SetInputData(mesh);
}

vtkPolyData* Drawing::GetMesh() const
{
  return this->Internal->Mapper->GetInput();
}

void Drawing::SetActor(vtkActor* actor)
{
  this->Internal->Renderer->RemoveAllViewProps();
  this->AddActor(actor, 0);
}

void Drawing::AddActor(vtkActor* actor, int index)
{
  this->Internal->Renderer->AddActor(actor);
  this->Internal->Data->SetPropIndex(actor, index);
}

vtkImageData* Drawing::GetData() const
{
  return this->Internal->Data->GetOutput();
}

void Drawing::SetTolerance(double pixels)
{
  this->Internal->Pass->SetTolerance(pixels);
}

void Drawing::SetActorPosition(const vec3& p)
{
  this->Internal->Actor->SetPosition(p.x, p.y, p.z);
}

void Drawing::SetTechnique(int technique)
{
  Internals& in = *this->Internal;
  in.Pass->SetTechnique(technique);
  const bool wide = technique == vtkWideFoVPass::AUTO;
  in.Actor->SetMapper(wide ? in.WideMapper.Get() : in.Mapper.Get());
}

void Drawing::SetPassTechnique(int technique)
{
  this->Internal->Pass->SetTechnique(technique);
}

void Drawing::SetCulling(bool culling)
{
  this->Internal->Pass->SetCulling(culling);
}

void Drawing::SetDrawsPerspective(bool draws)
{
  this->Internal->DrawsPerspective = draws;
}

int Drawing::GetNumberOfProjectedDraws() const
{
  return this->Internal->Pass->GetNumberOfProjectedDraws();
}

bool Drawing::WasMixed() const
{
  vtkWideFoVPass* const pass = this->Internal->Pass;
  const vtkIdType projected = pass->GetNumberOfProjectedTriangles();
  return projected > 0 &&
    projected < pass->GetNumberOfTriangles() - pass->GetNumberOfCulledTriangles();
}

void Drawing::SetLineWidth(double pixels)
{
  this->Internal->Actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

void Drawing::SetPointSize(double pixels)
{
  this->Internal->Actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
}

namespace
{
void SetLens(vtkWideFoVCamera* camera, const ViewOptions& o)
{
  camera->ClearLens();
  camera->ClearMeasuredPicture();
  if (o.Lens[0] != 0)
  {
    camera->SetLensCoefficients(o.Lens.data());
  }
  if (o.Measured.IsSet())
  {
    camera->SetMeasuredPicture(&o.Measured.Size.x, &o.Measured.Axis.x, &o.Measured.Focal.x);
  }
}
}

void PlaceCamera(vtkWideFoVCamera* camera, const Shot& s)
{
  // from one within the range of every projection, which others would be clamped to
  camera->SetFieldOfView(1);
  camera->SetVerticalFieldOfView(1);
  camera->SetProjection(s.Projection.c_str());
  camera->SetDirectionMap(s.Options.Map);
  camera->SetHorizontalFieldOfView(s.Options.HorizontalFov);
  camera->SetVerticalFieldOfView(s.Options.VerticalFov);
  camera->SetTilt(s.Options.Tilt);
  SetLens(camera, s.Options);
  const StereoOptions& stereo = s.Options.Stereo;
  camera->SetStereoModel(stereo.Model ? stereo.Model->Name.c_str() : "mono");
  camera->SetInterpupillaryDistance(stereo.InterpupillaryDistance);
  camera->SetPoleFade(stereo.PoleFade[0], stereo.PoleFade[1]);
  camera->SetWarpedStereo(stereo.Iod, stereo.Distance, stereo.Offset);
  camera->SetWarpedViewer(stereo.Viewer[0], stereo.Viewer[1]);
  camera->SetSeparation(stereo.Separation);
  camera->SetConvergence(stereo.Convergence);
  camera->SetClipRadii(s.Options.Radii[0], s.Options.Radii[1]);
  camera->SetPosition(s.Eye.x, s.Eye.y, s.Eye.z);
  // as far as the scene is large: a focal point one unit away vanishes beside 1e8
  const vec3 focus = s.Eye + s.Direction * s.Options.Radii[1];
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(s.Up.x, s.Up.y, s.Up.z);
}

namespace
{
void SetEye(vtkRenderWindow* window, Eye eye)
{
  window->SetStereoType(eye == Eye::Left ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
  window->SetStereoRender(eye != Eye::Middle);
}
}

reference::DrawnPicture Drawing::Draw(const Shot& s)
{
  Internals& in = *this->Internal;
  in.Window->SetSize(s.Width, s.Height);
  PlaceCamera(in.Camera, s);
  in.Camera->SetExactPerspective(in.DrawsPerspective || in.Pass->IsExact());
  SetEye(in.Window, s.Options.Stereo.Eye);
  in.Window->Render();
  in.LastView.reset(new View(in.Camera->GetView(double(s.Width) / s.Height)));
  return reference::ToDrawnPicture(in.Data->GetOutput());
}

vtkImageData* Drawing::GetImage() const
{
  return this->Internal->Data->GetOutput();
}

const View& Drawing::GetView() const
{
  return *this->Internal->LastView;
}

reference::Pose Drawing::GetPose() const
{
  reference::Pose pose;
  vtkMatrix4x4::Multiply4x4(this->Internal->Camera->GetModelViewTransformMatrix()->GetData(),
    this->Internal->Actor->GetMatrix()->GetData(), pose.data());
  return pose;
}

int Drawing::GetNumberOfPreClipDraws() const
{
  return this->Internal->Pass->GetNumberOfPreClipDraws();
}

std::string Describe(const Shot& s)
{
  char text[400];
  std::snprintf(text, sizeof text,
    "%s hfov %g vfov %g %s %d size %dx%d eye %.9g,%.9g,%.9g direction %.9g,%.9g,%.9g up "
    "%.9g,%.9g,%.9g clip %g,%g",
    s.Projection.c_str(), s.Options.HorizontalFov, s.Options.VerticalFov,
    s.Options.Stereo.Model ? s.Options.Stereo.Model->Name.c_str() : "mono",
    static_cast<int>(s.Options.Stereo.Eye), s.Width, s.Height, s.Eye.x, s.Eye.y, s.Eye.z,
    s.Direction.x, s.Direction.y, s.Direction.z, s.Up.x, s.Up.y, s.Up.z, s.Options.Radii[0],
    s.Options.Radii[1]);
  return text;
}

std::string DescribePixel(const View& view, int width, int height, const reference::WorstPixel& p)
{
  const vec2 ndc = reference::PixelToNdc(p.I + 0.5, p.J + 0.5, width, height);
  const ViewRay ray = view.Ray(ndc);
  const vec2 a = wfvMeridianAngles(ray.Direction) * (180 / WFV_PI);
  char text[300];
  std::snprintf(text, sizeof text,
    "pixel (%d, %d) ndc (%.6f, %.6f) lambda %.5f phi %.5f%s drawn cell %lld at %g, reference "
    "%lld at %g, nearest agreement %g px",
    p.I, p.J, ndc.x, ndc.y, a.x, a.y, ray.Inside ? "" : " OUTSIDE THE MAP", (long long)p.Drawn,
    p.DrawnDistance, (long long)p.Reference, p.ReferenceDistance, p.Pixels);
  return text;
}

HoleCount CountHoles(const reference::DrawnPicture& picture, const View& view)
{
  HoleCount count;
  for (int j = 0; j < picture.Height; ++j)
  {
    for (int i = 0; i < picture.Width; ++i)
    {
      const vec2 ndc = reference::PixelToNdc(i + 0.5, j + 0.5, picture.Width, picture.Height);
      const bool inside = view.Ray(ndc).Inside;
      const bool drawn = picture.Cell[std::size_t(j) * picture.Width + i] > 0;
      if (inside != drawn)
      {
        count.Holes += inside;
        count.Outside += drawn;
        reference::WorstPixel p;
        p.I = i;
        p.J = j;
        const bool room = count.Holes + count.Outside <= 8;
        const std::string text = DescribePixel(view, picture.Width, picture.Height, p);
        count.First += room ? "    " + text + "\n" : "";
      }
    }
  }
  return count;
}

std::string Row(const Shot& s, const std::string& scene, const reference::Metrics& m)
{
  char text[300];
  std::snprintf(text, sizeof text,
    "%-22s %3g %-34s mismatched %6ld unexplained %5ld missing %5.0f spurious %5.0f max %7.3g px "
    "p99 %7.3g px depth %.2e",
    s.Projection.c_str(), s.Options.HorizontalFov, scene.c_str(), m.Mismatched, m.UnexplainedPixels,
    m.Missing * s.Width * s.Height, m.Spurious * s.Width * s.Height, m.MaxPx, m.P99Px,
    m.MaxDepthRel);
  return text;
}

std::string Details(const Shot& s, const View& view, const reference::Metrics& m)
{
  std::string text;
  for (const reference::WorstPixel& p : m.Worst)
  {
    text += "    " + DescribePixel(view, s.Width, s.Height, p) + "\n";
  }
  return text;
}
}
}
