// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies.h"

#include "QuadricCaster.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <random>

namespace wfv
{
namespace test
{
namespace
{
using reference::Body;

// Directions at which maps are torn or stretched: ahead, the poles, the seam and the
// antipode, the seam near the pole, and beside each of them.
std::vector<vec3> Places()
{
  return { { 0, 0, -1 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0.001, 0, 1 }, { -0.08, 0.3, 1 },
    { 0.05, -0.7, 0.7 }, { 0.02, 1, 0.03 }, { -0.1, -1, 0.05 }, { 1, 0, 0 }, { -1, 0.2, 0.1 },
    { 0.6, 0.5, -0.6 } };
}

vec3 RandomDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

vec3 Rounded(const vec3& p)
{
  return vec3(float(p.x), float(p.y), float(p.z));
}

vtkSmartPointer<vtkFloatArray> AddArray(vtkPolyData* data, const char* name, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  data->GetPointData()->AddArray(array);
  return array.Get();
}

// A vertex a body, at its middle.
vtkSmartPointer<vtkPolyData> Middles(const BodyList& bodies)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  for (const Body& b : bodies)
  {
    const vec3 middle = b.Kind == Body::Shape::Ball ? b.P : (b.P + b.Q) * 0.5;
    const vtkIdType id = points->InsertNextPoint(middle.x, middle.y, middle.z);
    verts->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(verts);
  return data;
}

vtkSmartPointer<vtkActor> ActorOf(vtkPolyDataMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
}

Body Ball(const vec3& centre, double radius)
{
  Body b;
  b.P = Rounded(centre);
  b.R = float(radius);
  return b;
}

// The mapper takes the middle, the axis and the length as floats: the ends follow from them.
Body Stick(const vec3& from, const vec3& to, double radius)
{
  const vec3 middle = Rounded((from + to) * 0.5);
  const vec3 half = Rounded(to - from) * 0.5;
  Body b;
  b.Kind = Body::Shape::Stick;
  b.P = middle - half;
  b.Q = middle + half;
  b.R = float(radius);
  return b;
}

Body Segment(const vec3& from, const vec3& to)
{
  Body b;
  b.Kind = Body::Shape::Hull;
  b.P = Rounded(from);
  b.Q = Rounded(to);
  return b;
}

BodyList BallsRoundTheEye(bool outer)
{
  constexpr unsigned Seed = 20;
  std::mt19937 random(Seed);
  BodyList balls;
  const double sizes[] = { 0.0005, 0.01, 0.1, 0.4, 0.7 }; // of the distance
  int i = 0;
  for (const vec3& place : Places())
  {
    for (const double distance : { 0.2, 1.0, 2.5 })
    {
      // no two of a place hide each other wholly: the nearer the smaller
      const double size = sizes[i % 5] * (distance < 0.5 ? 0.1 : 1);
      balls.push_back(Ball(glm::normalize(place) * distance, distance * size));
      i++;
    }
  }
  std::uniform_real_distribution<double> exponent(-3.5, -1);
  for (int k = 0; k < 100; k++)
  {
    const double distance = 0.3 + 0.02 * k;
    balls.push_back(
      Ball(RandomDirection(random) * distance, distance * std::pow(10, exponent(random))));
  }
  balls.push_back(Ball(vec3(0.02, -0.9, 0.4), 0.98)); // its surface beside the eye
  if (outer)
  {
    balls.push_back(Ball(vec3(0.3, 0.2, 0.1), 3.2));
  }
  return balls;
}

BodyList SticksRoundTheEye()
{
  constexpr unsigned Seed = 21;
  std::mt19937 random(Seed);
  BodyList sticks;
  int i = 0;
  for (const vec3& place : Places())
  {
    const vec3 p = glm::normalize(place) * (1.2 + 0.1 * i);
    const vec3 axis = i % 4 == 3 ? p * 0.3 : RandomDirection(random) * (0.2 + 0.1 * i);
    sticks.push_back(Stick(p - axis, p + axis, 0.02 + 0.02 * (i % 5)));
    i++;
  }
  for (int k = 0; k < 60; k++)
  {
    const vec3 p = RandomDirection(random) * (0.5 + 0.03 * k);
    sticks.push_back(Stick(p, p + RandomDirection(random) * 0.4, 0.002 + 0.01 * (k % 4)));
  }
  sticks.push_back(Stick(vec3(-2, 0.15, 0.1), vec3(2, 0.16, -0.2), 0.12)); // past the eye
  return sticks;
}

BodyList SegmentsRoundTheEye()
{
  constexpr unsigned Seed = 22;
  std::mt19937 random(Seed);
  BodyList segments;
  for (int k = 0; k < 60; k++)
  {
    const vec3 p = RandomDirection(random) * (0.5 + 0.03 * k);
    const vec3 q = k % 3 == 0 ? RandomDirection(random) * 2.0 : p + RandomDirection(random) * 0.5;
    segments.push_back(Segment(p, q));
  }
  segments.push_back(Segment(vec3(-2.5, 0.3, 0.4), vec3(2.4, 0.2, 0.5)));    // half a turn, behind
  segments.push_back(Segment(vec3(0.2, 1, -1), vec3(-0.1, 1.2, 1.3)));       // over the pole
  segments.push_back(Segment(vec3(0.3, -0.2, -0.7), vec3(0.9, -0.6, -2.2))); // away from the eye
  segments.push_back(Segment(vec3(0.1, 0.3, 2), vec3(-0.2, -0.5, 1.8)));     // across the seam
  return segments;
}

BodyList PointsRoundTheEye()
{
  constexpr unsigned Seed = 23;
  std::mt19937 random(Seed);
  BodyList points;
  for (int k = 0; k < 150; k++)
  {
    points.push_back(Ball(RandomDirection(random) * (0.3 + 0.02 * k), 0));
  }
  return points;
}

vtkSmartPointer<vtkActor> BallActor(const BodyList& balls)
{
  auto data = Middles(balls);
  auto radii = AddArray(data, "radius", 1);
  for (const Body& b : balls)
  {
    radii->InsertNextValue(float(b.R));
  }
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("radius");
  return ActorOf(mapper);
}

vtkSmartPointer<vtkActor> StickActor(const BodyList& sticks)
{
  auto data = Middles(sticks);
  auto axes = AddArray(data, "axis", 3);
  auto sizes = AddArray(data, "size", 3);
  vtkNew<vtkUnsignedCharArray> colors; // the mapper needs some
  colors->SetNumberOfComponents(3);
  for (const Body& b : sticks)
  {
    const vec3 axis = b.Q - b.P;
    axes->InsertNextTuple3(axis.x, axis.y, axis.z);
    sizes->InsertNextTuple3(1, b.R, 0); // the axis has its length already
    colors->InsertNextTuple3(255, 255, 255);
  }
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetOrientationArray("axis");
  mapper->SetScaleArray("size");
  return ActorOf(mapper);
}

vtkSmartPointer<vtkActor> TubeActor(const BodyList& segments, double pixels)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Body& b : segments)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points->InsertNextPoint(b.P.x, b.P.y, b.P.z));
    lines->InsertCellPoint(points->InsertNextPoint(b.Q.x, b.Q.y, b.Q.z));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = ActorOf(mapper);
  actor->GetProperty()->RenderLinesAsTubesOn();
  actor->GetProperty()->SetLineWidth(float(pixels));
  return actor;
}

vtkSmartPointer<vtkActor> PointActor(const BodyList& points, double pixels)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Middles(points));
  auto actor = ActorOf(mapper);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  actor->GetProperty()->SetPointSize(float(pixels));
  return actor;
}

BodyList InView(const BodyList& bodies, const reference::Pose& m, const View& view, double pixels,
  int width, int height)
{
  const auto transform = [&m](const vec3& p) {
    return vec3(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
      m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7], m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]);
  };
  const auto radius = [&](const vec3& p) {
    const double angle = reference::PixelAngle(view, p, width, height);
    return glm::length(p) * std::sin(0.5 * pixels * angle);
  };
  BodyList result = bodies;
  for (Body& b : result)
  {
    b.P = transform(b.P);
    b.Q = transform(b.Q);
    b.R = pixels > 0 ? radius(b.P) : b.R;
    b.S = pixels > 0 ? radius(b.Q) : b.S;
  }
  return result;
}
}
}
