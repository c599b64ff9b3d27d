// SPDX-License-Identifier: BSD-3-Clause
// What is interpolated over triangles (colours of points, normals, texture coordinates) against
// the ray caster's barycentric coordinates, by the techniques exact and auto.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Of colours from 0 to 1, of components of unit normals, and of texture coordinates.
constexpr double AttributeTolerance = 1e-4;

// Pixels: at this tolerance auto is as near to the truth as exact.
constexpr double FineTolerance = 0.02;

// Of the domain's pixels: as many as that are compared at least.
constexpr double LeastShare = 0.5;

// Random attributes of every point.
vtkSmartPointer<vtkPolyData> WithAttributes(vtkPolyData* mesh)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i++)
  {
    const vec3 c = vec3(unit(engine), unit(engine), unit(engine)) * 127.0 + 128.0;
    colors->InsertNextTuple3(std::floor(c.x), std::floor(c.y), std::floor(c.z));
    // about one side of the mesh: no interpolated one is short
    double p[3];
    mesh->GetPoint(i, p);
    const vec3 n = glm::normalize(glm::normalize(vec3(p[0], p[1], p[2])) +
      0.3 * vec3(unit(engine), unit(engine), unit(engine)));
    normals->InsertNextTuple3(n.x, n.y, n.z);
    // where the texture is a ramp
    places->InsertNextTuple2(0.5 + 0.25 * unit(engine), 0.5 + 0.25 * unit(engine));
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  copy->GetPointData()->SetScalars(colors);
  copy->GetPointData()->SetNormals(normals);
  copy->GetPointData()->SetTCoords(places);
  return copy;
}

// Red and green are 0 to 1 over the middle half of the texture. Graphics hardware tells apart 256
// places between the centres of two texels, which are this many.
constexpr int RampTexels = 128;

vtkSmartPointer<vtkTexture> Ramp()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(RampTexels, RampTexels, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  const auto valueOf = [](int i) { return float(2 * (i + 0.5) / RampTexels - 0.5); };
  for (int i = 0; i < RampTexels * RampTexels; i++)
  {
    auto* texel = static_cast<float*>(image->GetScalarPointer(i % RampTexels, i / RampTexels, 0));
    texel[0] = valueOf(i % RampTexels);
    texel[1] = valueOf(i / RampTexels);
    texel[2] = 0;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->RepeatOff();
  return texture;
}

enum class What
{
  Colors,
  Normals,
  Places
};

// What a hit should show, in view coordinates.
vec3 Expected(What what, const reference::RayCaster& caster, vtkPolyData* mesh,
  const reference::Pose& pose, const reference::Hit& hit, const vec3& direction)
{
  const reference::TriangleSoup& soup = caster.GetTriangles();
  const auto& t = soup.Triangles[std::size_t(hit.Triangle)];
  vtkPointData* const data = mesh->GetPointData();
  vtkDataArray* const array = what == What::Colors ? data->GetScalars()
    : what == What::Normals                        ? data->GetNormals()
                                                   : data->GetTCoords();
  vec3 sum(0);
  for (int i = 0; i < 3; i++)
  {
    double value[3] = { 0, 0, 0 };
    array->GetTuple(t[i], value);
    sum = sum + vec3(value[0], value[1], value[2]) * hit.Barycentrics[i];
  }
  if (what != What::Normals)
  {
    return what == What::Colors ? sum / 255.0 : vec3(2 * sum.x - 0.5, 2 * sum.y - 0.5, 0);
  }
  const vec3 turned(glm::dot(vec3(pose[0], pose[1], pose[2]), sum),
    glm::dot(vec3(pose[4], pose[5], pose[6]), sum),
    glm::dot(vec3(pose[8], pose[9], pose[10]), sum));
  const std::vector<vec3>& p = soup.Points;
  const vec3 face = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  return glm::normalize(turned) * (glm::dot(face, direction) < 0 ? 1.0 : -1.0);
}

struct Difference
{
  double Largest = 0;
  vec3 Drawn{ 0 };
  vec3 Wanted{ 0 };
  int I = 0;
  int J = 0;
  long Compared = 0;
  long Domain = 0;
};
}

class Attributes : public DrawingTest
{
protected:
  // Everything that is drawn, as the actor shows one attribute alone.
  void SetScene(vtkPolyData* mesh, What what)
  {
    this->Mesh = WithAttributes(mesh);
    Picture->SetMesh(this->Mesh);
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputData(this->Mesh);
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarVisibility(what == What::Colors);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(1, 1, 1);
    actor->GetProperty()->SetLighting(what == What::Normals);
    actor->GetProperty()->SetAmbient(0);
    actor->SetTexture(what == What::Places ? Ramp() : nullptr);
    Picture->SetActor(actor);
  }

  // Where the cells agree.
  Difference Measure(const Shot& shot, What what)
  {
    Difference d;
    const reference::DrawnPicture picture = Picture->Draw(shot);
    if (picture.Width != shot.Width)
    {
      return d;
    }
    const reference::Pose pose = Picture->GetPose();
    const reference::RayCaster caster(this->Mesh, Picture->GetView(), pose);
    vtkDataArray* const array =
      Picture->GetData()->GetPointData()->GetArray(what == What::Normals ? "normal" : "color");
    for (int n = 0; n < shot.Width * shot.Height; n++)
    {
      const int i = n % shot.Width;
      const int j = n / shot.Width;
      const vec2 ndc = reference::PixelToNdc(i + 0.5, j + 0.5, shot.Width, shot.Height);
      const reference::Hit hit = caster.Cast(ndc);
      d.Domain += hit.InDomain;
      if (hit.Cell < 0 || double(picture.Cell[n]) != double(hit.Cell + 1))
      {
        continue;
      }
      double value[4];
      array->GetTuple(vtkIdType(shot.Height - 1 - j) * shot.Width + i, value);
      const vec3 drawn(value[0], value[1], what == What::Places ? 0 : value[2]);
      const vec3 wanted =
        Expected(what, caster, this->Mesh, pose, hit, Picture->GetView().Ray(ndc).Direction);
      const vec3 off = glm::abs(drawn - wanted);
      const double most = std::max({ off.x, off.y, off.z });
      ++d.Compared;
      if (!(most <= d.Largest)) // not a number too
      {
        d = { most, drawn, wanted, i, j, d.Compared, d.Domain };
      }
    }
    return d;
  }

  void Check(vtkPolyData* mesh, const std::string& name)
  {
    const double fov = WidestDrawn(*FindProjection(this->GetParam()));
    const std::pair<const char*, What> all[] = { { "colors", What::Colors },
      { "normals", What::Normals }, { "texture coordinates", What::Places } };
    for (const auto& [title, what] : all)
    {
      this->SetScene(mesh, what);
      for (const int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::AUTO })
      {
        Picture->SetPassTechnique(technique);
        for (const NamedPose& pose : PlainPoses())
        {
          const Shot shot = MakeShot(this->GetParam(), fov, pose);
          const Difference d = this->Measure(shot, what);
          const std::string text = name + ", " + title + ", " + pose.Name +
            (technique == vtkWideFoVPass::EXACT ? ", exact" : ", auto");
          std::cout << text << ": " << d.Largest << " of " << d.Compared << "\n";
          EXPECT_LE(d.Largest, AttributeTolerance)
            << text << " at pixel (" << d.I << ", " << d.J << "): drawn " << d.Drawn.x << " "
            << d.Drawn.y << " " << d.Drawn.z << ", not " << d.Wanted.x << " " << d.Wanted.y << " "
            << d.Wanted.z << "\n"
            << Describe(shot);
          EXPECT_GE(double(d.Compared), LeastShare * double(d.Domain)) << text;
          EXPECT_GT(d.Compared, 0) << text;
        }
      }
    }
  }

  void SetUp() override { Picture->SetTolerance(FineTolerance); }

  vtkSmartPointer<vtkPolyData> Mesh;
};

TEST_P(Attributes, OfARoomOfTwelve)
{
  this->Check(MakeRoom(1), "room of 12");
}

TEST_P(Attributes, OfAGlobe)
{
  this->Check(MakeGlobe(20), "globe of 20");
}

INSTANTIATE_TEST_SUITE_P(
  All, Attributes, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
