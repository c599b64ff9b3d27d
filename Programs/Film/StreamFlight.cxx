// SPDX-License-Identifier: BSD-3-Clause
#include "StreamFlight.h"

#include "Scenes/Datasets.h"
#include "Scenes/MeshBuilder.h"
#include "Scenes/VectorField.h"
#include "Text/Messages.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr int Places = 120;    // along the line
constexpr double Ahead = 0.03; // how far the camera looks, of the line's length
constexpr double SineOfParallel = 1e-3;

using Line = std::vector<Vector3>;

double LengthOf(const Line& line)
{
  double length = 0;
  for (std::size_t i = 1; i < line.size(); i++)
  {
    length += Length(line[i] - line[i - 1]);
  }
  return length;
}

Line LongestLine(vtkPolyData* lines)
{
  Line longest;
  double most = 0;
  vtkCellArray* const cells = lines->GetLines();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i++)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, count, ids);
    Line line(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < line.size(); k++)
    {
      lines->GetPoint(ids[k], line[k].data());
    }
    const double length = LengthOf(line);
    if (length > most)
    {
      most = length;
      longest = line;
    }
  }
  return longest;
}

// Places at equal distances.
Line Even(const Line& line, int count)
{
  const double step = LengthOf(line) / (count - 1);
  Line even{ line.front() };
  double gone = 0; // up to line[i - 1]
  for (std::size_t i = 1; i < line.size(); i++)
  {
    const double here = Length(line[i] - line[i - 1]);
    while (here > 0 && static_cast<int>(even.size()) < count - 1 &&
      static_cast<double>(even.size()) * step <= gone + here)
    {
      const double t = (static_cast<double>(even.size()) * step - gone) / here;
      even.push_back(line[i - 1] + t * (line[i] - line[i - 1]));
    }
    gone += here;
  }
  even.push_back(line.back());
  return even;
}

vtkSmartPointer<vtkDataObject> FieldOf(const Scene& scene, const std::string& array)
{
  for (const SceneProp& prop : scene.Props)
  {
    const std::vector<std::string> names =
      prop.Source ? ArrayNames(prop.Source) : std::vector<std::string>();
    if (std::find(names.begin(), names.end(), array) != names.end())
    {
      return prop.Source;
    }
  }
  Fail("--film fly: the data have no array '" + array + "'; check the name");
}

// Up as it is, or where the line is parallel to it, as it was.
void SetUps(std::vector<Pose>& poses, const Vector3& up)
{
  Vector3 last = up;
  for (Pose& pose : poses)
  {
    const bool clear = Length(Cross(pose.Direction, up)) > SineOfParallel;
    const Vector3 right = Cross(pose.Direction, clear ? up : last);
    pose.Up = Length(right) > SineOfParallel
      ? Cross(Unit(right), pose.Direction)
      : Unit(Cross(Cross(pose.Direction, { { 0.3, 0.5, 0.8 } }), pose.Direction)); // any
    last = pose.Up;
  }
}
}

std::vector<Pose> FlightAlong(
  const Scene& scene, const Look& look, const std::optional<Vector3>& eye, const Vector3& up)
{
  const std::string array = look.Vectors;
  TubeSettings settings;
  if (eye)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(eye->data());
    settings.Seeds = vtkSmartPointer<vtkPolyData>::New();
    settings.Seeds->SetPoints(points);
  }
  const Line line = LongestLine(MakeStreamLines(FieldOf(scene, array), array, settings, true));
  if (line.size() < 2)
  {
    Fail("--film fly: no stream line of '" + array +
      (eye ? "' begins at --eye; choose another place, or leave it out"
           : "' gets anywhere; choose another array"));
  }
  const Line places = Even(line, Places);
  const int ahead = std::max(1, static_cast<int>(std::lround(Ahead * Places)));
  std::vector<Pose> poses;
  for (int i = 0; i < Places; i++)
  {
    const Vector3& from = places[static_cast<std::size_t>(std::max(0, i - ahead))];
    const Vector3& to = places[static_cast<std::size_t>(std::min(Places - 1, i + ahead))];
    poses.push_back({ places[static_cast<std::size_t>(i)], Unit(to - from), up });
  }
  SetUps(poses, up);
  return poses;
}
}
