// SPDX-License-Identifier: BSD-3-Clause
#include "SkyScene.h"

#include "Poses.h"

#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cstdlib>

namespace wfv
{
namespace test
{
namespace
{
// NDC: so near to its border a map may end for float32, or not.
constexpr double Border = 1e-5;
}

SkyColor SkyPicture::At(int x, int y) const
{
  const unsigned char* const c = this->Colors.data() + 3 * (std::size_t(y) * this->Width + x);
  return SkyColor(c[0], c[1], c[2]);
}

float SkyPicture::DepthAt(int x, int y) const
{
  return this->Depths[std::size_t(y) * this->Width + x];
}

vec2 SkyPicture::NdcOf(int x, int y) const
{
  return vec2((2 * x + 1.0) / this->Width - 1, (2 * y + 1.0) / this->Height - 1);
}

void SkyPicture::ForEach(const std::function<void(int x, int y)>& look) const
{
  for (int i = 0; i < this->Width * this->Height; i++)
  {
    look(i % this->Width, i / this->Width);
  }
}

Shot WideSkyShot(const char* projection)
{
  const NamedPose pose = Turned(NamedPose(), 25, -15, "down");
  Shot shot = MakeShot(projection, WidestDrawn(*FindProjection(projection)), pose);
  shot.Width = 256;
  shot.Height = 128;
  shot.Options.Radii = { { 0.1, 200 } };
  return shot;
}

vtkSmartPointer<vtkTexture> SmoothSky(bool light)
{
  const SkyImage image(256, 128, [](vec2 place) { return SmoothColor(SphereDirection(place)); });
  vtkSmartPointer<vtkTexture> texture = SphereTexture(image, light);
  texture->SetUseSRGBColorSpace(light);
  return texture;
}

vtkSmartPointer<vtkActor> YellowBall(const vec3& place, double radius, double opacity)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(place.x, place.y, place.z);
  source->SetRadius(radius);
  source->SetThetaResolution(48);
  source->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->BackfaceCullingOn();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1, 1, 0);
  return actor;
}

SkyWindow::SkyWindow()
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->SetBackground(NoSky.x / 255, NoSky.y / 255, NoSky.z / 255);
  this->Renderer->AddActor(this->Sky);
}

SkyPicture SkyWindow::Read()
{
  SkyPicture p;
  p.Width = this->Window->GetActualSize()[0]; // of a tile alone
  p.Height = this->Window->GetActualSize()[1];
  vtkNew<vtkUnsignedCharArray> colors;
  this->Window->GetPixelData(0, 0, p.Width - 1, p.Height - 1, 0, colors);
  p.Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
  vtkNew<vtkFloatArray> depths;
  this->Window->GetZbufferData(0, 0, p.Width - 1, p.Height - 1, depths);
  p.Depths.assign(depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
  return p;
}

SkyPicture SkyWindow::Draw(const Shot& s)
{
  this->Window->SetSize(s.Width, s.Height);
  this->Camera->ClearLens();
  PlaceCamera(this->Camera, s);
  const LensCoefficients& lens = s.Options.Lens;
  const bool lensed = lens != ViewOptions().Lens;
  if (lensed && !this->Camera->SetLens(lens[0], lens[1], lens[2], lens[3], lens[4]))
  {
    return SkyPicture();
  }
  this->Camera->SetExactPerspective(1);
  const Eye eye = s.Options.Stereo.Eye;
  this->Window->SetStereoType(eye == Eye::Left ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
  this->Window->SetStereoRender(eye != Eye::Middle);
  this->Window->Render();
  return this->Read();
}

View SkyWindow::GetView()
{
  const int* const size = this->Window->GetSize();
  return this->Camera->GetView(double(size[0]) / size[1]);
}

ViewRay SkyWindow::InWorld(const ViewRay& ray)
{
  double toWorld[16];
  vtkMatrix4x4::Invert(this->Camera->GetModelViewTransformMatrix()->GetData(), toWorld);
  const auto turn = [&toWorld](const vec3& p, double w) {
    const double in[4] = { p.x, p.y, p.z, w };
    double out[4];
    vtkMatrix4x4::MultiplyPoint(toWorld, in, out);
    return vec3(out[0], out[1], out[2]);
  };
  return { turn(ray.Origin, 1), turn(ray.Direction, 0), ray.Inside };
}

void SkyWindow::Keep(const std::string& name)
{
  const char* const folder = std::getenv("WIDEFOV_SKY_PICTURES");
  if (!folder)
  {
    return;
  }
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Window);
  image->ShouldRerenderOff();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

bool IsCertain(const View& view, const vec3& ndc)
{
  const bool inside = view.RayAt(ndc).Inside;
  for (int i = 0; i < 4; i++)
  {
    const double side = i & 1 ? Border : -Border;
    const vec3 beside = ndc + (i & 2 ? vec3(side, 0, 0) : vec3(0, side, 0));
    if (view.RayAt(beside).Inside != inside)
    {
      return false;
    }
  }
  return true;
}

void SkyTally::Look(const SkyPicture& picture, int x, int y, const SkyColor& wanted)
{
  const SkyColor off = glm::abs(wanted - picture.At(x, y));
  const double worst = std::max(off.x, std::max(off.y, off.z));
  if (worst > this->Worst)
  {
    this->Worst = worst;
    this->Where = std::to_string(x) + ", " + std::to_string(y);
  }
}

SkyTally CheckFar(SkyWindow& window, const SkyPicture& picture, const SkyLookup& lookup)
{
  const View view = window.GetView();
  SkyTally t;
  picture.ForEach([&](int x, int y) {
    const vec3 ndc(picture.NdcOf(x, y), 1);
    const ViewRay ray = view.RayAt(ndc);
    t.Near += picture.DepthAt(x, y) < 1;
    if (!IsCertain(view, ndc))
    {
      t.Uncertain++;
      return;
    }
    (ray.Inside ? t.Inside : t.Outside)++;
    t.Look(picture, x, y, ray.Inside ? lookup(window.InWorld(ray)) : NoSky);
  });
  return t;
}
}
}
