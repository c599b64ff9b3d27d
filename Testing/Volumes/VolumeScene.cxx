// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeScene.h"

#include "RayCaster.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRTAnalyticSource.h>
#include <vtkResampleToImage.h>
#include <vtkStructuredGridReader.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace wfv
{
namespace test
{
namespace
{
using reference::Blend;

// Of 255: more than these are a pixel of its own.
constexpr double ManyLevels = 10;

vec3 Place(const std::array<double, 16>& m, const vec3& p, double w)
{
  const double in[4] = { p.x, p.y, p.z, w };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(m.data(), in, out);
  return vec3(out[0], out[1], out[2]);
}

int VtkBlend(Blend mode)
{
  const int modes[] = { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
    vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
    vtkVolumeMapper::ADDITIVE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND,
    vtkVolumeMapper::SLICE_BLEND };
  return modes[static_cast<int>(mode)];
}

// The nearest distance at which a ray meets a ball from outside.
double MeetBall(const OpaqueBall& ball, const vec3& origin, const vec3& direction)
{
  const vec3 c = ball.Center - origin;
  const double b = glm::dot(c, direction);
  const double q = glm::length(c - b * direction);
  const double s = std::sqrt(std::max(0.0, ball.Radius * ball.Radius - q * q));
  return q < ball.Radius && b - s > 0 ? b - s : std::numeric_limits<double>::infinity();
}
}

vtkSmartPointer<vtkImageData> Wavelet()
{
  vtkNew<vtkRTAnalyticSource> source;
  source->Update();
  vtkSmartPointer<vtkImageData> image = source->GetOutput();
  return image;
}

vtkSmartPointer<vtkImageData> Office()
{
  const char* const folder = std::getenv("WIDEFOV_DATA_FOLDER");
  const std::string name =
    std::string(folder ? folder : WIDEFOV_DATA_FOLDER) + "/office.binary.vtk";
  if (!std::filesystem::exists(name))
  {
    return nullptr;
  }
  vtkNew<vtkStructuredGridReader> reader;
  reader->SetFileName(name.c_str());
  vtkNew<vtkResampleToImage> grid;
  grid->SetInputConnection(reader->GetOutputPort());
  grid->SetSamplingDimensions(41, 39, 31);
  grid->Update();
  vtkSmartPointer<vtkImageData> image = grid->GetOutput();
  // at the border rounding says outside, and VTK would leave cells out
  image->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  image->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  image->GetPointData()->SetActiveScalars("scalars");
  return image;
}

reference::Field FieldOf(vtkImageData* image)
{
  reference::Field field;
  double bounds[6];
  image->GetBounds(bounds);
  image->GetDimensions(field.Size.data());
  for (int a = 0; a < 3; a++)
  {
    field.Origin[a] = bounds[2 * a];
    field.Spacing[a] = image->GetSpacing()[a];
  }
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i++)
  {
    field.Values.push_back(scalars->GetComponent(i, 0));
  }
  return field;
}

VolumeScene::VolumeScene(vtkImageData* image)
  : Mapper(vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->SetPass(this->Pass);
  this->Renderer->SetBackground(this->Background.x, this->Background.y, this->Background.z);
  this->Renderer->AddVolume(this->Volume);
  this->Mapper->SetInputData(image);
  this->Mapper->SetAutoAdjustSampleDistances(0);
  this->Mapper->SetLockSampleDistanceToInputSpacing(0);
  this->Volume->SetMapper(this->Mapper);
  this->March.Data = FieldOf(image);
  image->GetPointData()->GetScalars()->GetRange(this->March.Range.data());
  this->March.Step = 0.5 * image->GetSpacing()[0];
  const int running = 100 * vtkVersion::GetVTKMajorVersion() + vtkVersion::GetVTKMinorVersion();
  this->March.Mirrors = running >= 902;
  this->March.ClipsAsCells = running < 906;
  this->Mapper->SetSampleDistance(static_cast<float>(this->March.Step));
  this->SetFunctions(this->March.Range[0], this->March.Range[1], 0.2);
}

void VolumeScene::SetFunctions(double low, double high, double opacity)
{
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(low, 0);
  opacities->AddPoint(high, opacity);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(low, 0, 0.2, 1);
  colors->AddRGBPoint(0.5 * (low + high), 1, 0.9, 0.2);
  colors->AddRGBPoint(high, 1, 0.1, 0);
  this->Volume->GetProperty()->SetScalarOpacity(opacities);
  this->Volume->GetProperty()->SetColor(colors);
  this->Volume->GetProperty()->SetInterpolationTypeToLinear();
  const vtkSmartPointer<vtkPiecewiseFunction> o = opacities.Get();
  const vtkSmartPointer<vtkColorTransferFunction> c = colors.Get();
  this->March.Opacity = [o](double value) { return o->GetValue(value); };
  this->March.Color = [c](double value) {
    double rgb[3];
    c->GetColor(value, rgb);
    return vec3(rgb[0], rgb[1], rgb[2]);
  };
}

void VolumeScene::SetBlend(Blend mode)
{
  this->Mapper->SetBlendMode(VtkBlend(mode));
  this->March.Mode = mode;
}

void VolumeScene::SetBall(const OpaqueBall& ball)
{
  this->Ball = ball;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  const vtkIdType id = points->InsertNextPoint(ball.Center.x, ball.Center.y, ball.Center.z);
  vertices->InsertNextCell(1, &id);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadius(static_cast<float>(ball.Radius));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(ball.Color.x, ball.Color.y, ball.Color.z);
  this->Renderer->AddActor(actor);
}

void VolumeScene::AddClip(const reference::Plane& plane)
{
  vtkNew<vtkPlane> clip;
  clip->SetOrigin(plane.Origin.x, plane.Origin.y, plane.Origin.z);
  clip->SetNormal(plane.Normal.x, plane.Normal.y, plane.Normal.z);
  this->Mapper->AddClippingPlane(clip);
  this->March.Clips.push_back(plane);
}

void VolumeScene::Crop(const std::array<double, 6>& box)
{
  this->Mapper->SetCropping(1);
  this->Mapper->SetCroppingRegionPlanes(box.data());
  this->Mapper->SetCroppingRegionFlagsToSubVolume();
  this->March.Crops = true;
  this->March.Cropped = box;
}

void VolumeScene::Shade()
{
  this->Volume->GetProperty()->ShadeOn();
  this->March.Shades = true;
}

void VolumeScene::SetGradientOpacity()
{
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, 0);
  opacities->AddPoint(0.25 * (this->March.Range[1] - this->March.Range[0]), 1);
  this->Volume->GetProperty()->SetGradientOpacity(opacities);
  this->March.GradientOpacity = [](double share) { return share; };
}

void VolumeScene::SetIsovalues(const std::vector<double>& values)
{
  this->March.Isovalues = values;
  for (std::size_t i = 0; i < values.size(); i++)
  {
    this->Volume->GetProperty()->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), values[i]);
  }
}

void VolumeScene::SetCut(const reference::Plane& plane)
{
  vtkNew<vtkPlane> cut;
  cut->SetOrigin(plane.Origin.x, plane.Origin.y, plane.Origin.z);
  cut->SetNormal(plane.Normal.x, plane.Normal.y, plane.Normal.z);
  this->Volume->GetProperty()->SetSliceFunction(cut);
  this->March.Cut = plane;
}

void VolumeScene::Draw(const Shot& shot, const std::string& picture)
{
  this->LastShot = shot;
  this->Window->SetSize(shot.Width, shot.Height);
  PlaceCamera(this->Camera, shot);
  this->Camera->SetExactPerspective(shot.Projection == "perspective" && !this->Stock);
  const Eye eye = shot.Options.Stereo.Eye;
  this->Window->SetStereoType(eye == Eye::Left ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
  this->Window->SetStereoRender(eye != Eye::Middle);
  this->Window->Render();
  vtkMatrix4x4::Invert(
    this->Camera->GetModelViewTransformMatrix()->GetData(), this->ToWorld.data());
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetRGBACharPixelData(0, 0, shot.Width - 1, shot.Height - 1, 1, pixels);
  this->Drawn.clear();
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); i++)
  {
    this->Drawn.push_back(
      vec3(pixels->GetComponent(i, 0), pixels->GetComponent(i, 1), pixels->GetComponent(i, 2)) /
      255.0);
  }
  if (!picture.empty())
  {
    this->WritePicture(picture);
  }
}

void VolumeScene::WritePicture(const std::string& name) const
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(const_cast<vtkRenderWindow*>(this->Window.Get()));
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

void VolumeScene::SetTranslucent(const OpaqueBall& ball, double opacity)
{
  this->Glass = ball;
  this->GlassOpacity = opacity;
}

// The volume in three parts, with both sides of the ball between them.
vec3 VolumeScene::ExpectedThroughGlass(const vec3& origin, const vec3& direction, bool& seen) const
{
  const std::array<double, 2>& radii = this->LastShot.Options.Radii;
  const double first = MeetBall(this->Glass, origin, direction);
  const double b = glm::dot(this->Glass.Center - origin, direction);
  const double ends[] = { std::min(first, radii[1]), std::min(2 * b - first, radii[1]), radii[1] };
  const bool met = first < radii[1];
  double from = radii[0];
  vec3 color(0);
  double left = 1;
  for (int i = met ? 0 : 2; i < 3; i++)
  {
    const reference::Rgba part = this->March.March(origin, direction, from, ends[i]);
    seen = seen || part.Alpha > 0;
    color += left * part.Color;
    left *= 1 - part.Alpha;
    color += i < 2 ? left * this->GlassOpacity * this->Glass.Color : vec3(0);
    left *= i < 2 ? 1 - this->GlassOpacity : 1;
    from = ends[i];
  }
  return color + left * this->Background;
}

vec3 VolumeScene::Expected(const ViewRay& ray, bool& seen) const
{
  const vec3 origin = Place(this->ToWorld, ray.Origin, 1);
  const vec3 direction = Place(this->ToWorld, ray.Direction, 0);
  const std::array<double, 2>& radii = this->LastShot.Options.Radii;
  if (this->GlassOpacity > 0)
  {
    return this->ExpectedThroughGlass(origin, direction, seen);
  }
  const double ball = MeetBall(this->Ball, origin, direction);
  const double far = std::min(ball, radii[1]);
  const reference::Rgba front = this->March.March(origin, direction, radii[0], far);
  seen = front.Alpha > 0;
  return front.Color + (1 - front.Alpha) * (ball < radii[1] ? this->Ball.Color : this->Background);
}

// The first distance at which a curve is in the ball.
double VolumeScene::MeetBallAlong(const reference::VolumeMarch::Curve& curve) const
{
  const std::array<double, 2>& radii = this->LastShot.Options.Radii;
  const auto inside = [&](double t) {
    vec3 place;
    return curve(t, place) && glm::length(place - this->Ball.Center) < this->Ball.Radius;
  };
  for (double t = radii[0]; t < radii[1]; t += 0.05)
  {
    if (inside(t))
    {
      double before = t - 0.05;
      for (int i = 0; i < 40; i++)
      {
        const double middle = 0.5 * (before + t);
        (inside(middle) ? t : before) = middle;
      }
      return t;
    }
  }
  return std::numeric_limits<double>::infinity();
}

vec3 VolumeScene::ExpectedOfCurve(const View& view, const vec2& ndc, bool& seen) const
{
  const std::array<double, 2>& radii = this->LastShot.Options.Radii;
  const auto curve = [&](double t, vec3& place) {
    const double depth = 2 * wfvDepthOf(t, view.GetParameters()) - 1;
    const ViewRay ray = view.RayAt(vec3(ndc, std::clamp(depth, -1.0, 1.0)));
    place = Place(this->ToWorld, ray.Origin + t * ray.Direction, 1);
    return ray.Inside;
  };
  const double ball =
    this->Ball.Radius > 0 ? this->MeetBallAlong(curve) : std::numeric_limits<double>::infinity();
  const vec3 eye = Place(this->ToWorld, vec3(0), 1);
  const reference::Rgba front =
    this->March.MarchCurve(eye, curve, radii[0], std::min(ball, radii[1]));
  seen = front.Alpha > 0;
  return front.Color + (1 - front.Alpha) * (ball < radii[1] ? this->Ball.Color : this->Background);
}

VolumeError VolumeScene::Compare()
{
  const Shot& s = this->LastShot;
  const View view(this->Camera->GetView(double(s.Width) / s.Height));
  VolumeError error;
  double pixels = 0, sum = 0, squares = 0;
  for (int j = 0; j < s.Height; j++)
  {
    for (int i = 0; i < s.Width; i++)
    {
      const vec2 ndc = reference::PixelToNdc(i + 0.5, j + 0.5, s.Width, s.Height);
      const ViewRay ray = view.Ray(ndc);
      const bool curved = view.GetStereoModel() && !view.GetStereoModel()->Traits.StraightRays;
      if (!ray.Inside && !curved)
      {
        continue;
      }
      bool seen = false;
      const vec3 wanted =
        curved ? this->ExpectedOfCurve(view, ndc, seen) : this->Expected(ray, seen);
      const vec3& drawn = this->Drawn[std::size_t(s.Height - 1 - j) * s.Width + i];
      const vec3 off = glm::abs(wanted - drawn);
      const double most = std::max({ off.x, off.y, off.z });
      pixels++;
      error.Mean += (off.x + off.y + off.z) / 3;
      error.Max = std::max(error.Max, most);
      error.Share += most > ManyLevels / 255;
      error.Seen += seen;
      sum += seen ? wanted.x : 0;
      squares += seen ? wanted.x * wanted.x : 0;
    }
  }
  const double mean = sum / std::max(1.0, error.Seen);
  error.Contrast = std::sqrt(std::max(0.0, squares / std::max(1.0, error.Seen) - mean * mean));
  error.Mean /= pixels;
  error.Share /= pixels;
  error.Seen /= pixels;
  return error;
}

VolumeError VolumeScene::CompareScreen(
  vtkCamera* camera, const vec3& eye, const std::array<vec3, 3>& corners)
{
  constexpr int width = 96;
  constexpr int height = 64;
  this->Window->SetSize(width, height);
  this->Renderer->SetActiveCamera(camera);
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, pixels);
  VolumeError error;
  for (int i = 0; i < width * height; i++)
  {
    const double x = (i % width + 0.5) / width;
    const double y = (i / width + 0.5) / height;
    const vec3 place = corners[0] + x * (corners[1] - corners[0]) + y * (corners[2] - corners[1]);
    const reference::Rgba front = this->March.March(eye, glm::normalize(place - eye), 0.5, 100);
    const vec3 wanted = front.Color + (1 - front.Alpha) * this->Background;
    for (int c = 0; c < 3; c++)
    {
      error.Mean += std::abs(wanted[c] - pixels->GetComponent(i, c) / 255) / (3 * width * height);
    }
    error.Seen += front.Alpha > 0 ? 1.0 / (width * height) : 0;
  }
  return error;
}
}
}
