// SPDX-License-Identifier: BSD-3-Clause
#include "BenchScenes.h"

#include "System/MessageCatcher.h"
#include "Text/Messages.h"
#include "Scenes/Pipeline.h"
#include "System/Progress.h"
#include "Scenes/Readers.h"
#include "Scenes/Scenes.h"

#include <vtkNew.h>
#include <vtkTriangleFilter.h>

namespace wfv
{
namespace bench
{
namespace
{
const char* const Office = "office";
const char* const BallsApart = "balls-apart";

// As Examples/render-pictures.sh shows it: arrows and stream tubes, seen from between the
// desk and the window; up is +z in these data.
void SetOfficeCamera(widefov::Options& o)
{
  o.Look.StreamLines = "vectors";
  o.Look.Vectors = "vectors";
  o.Look.Surface = false;
  o.Look.Range = std::array<double, 2>{ { 0, 0.25 } };
  o.Look.ColorMap = "rainbow";
  o.Eye = widefov::Vector3{ { 2, 2.2, 1.4 } };
  o.Direction = widefov::Vector3{ { 1, 0, 0 } };
  o.Up = widefov::Vector3{ { 0, 0, 1 } };
}

// Strips and polygons as triangles, so that every triangle has an id of its own and a
// wrong one is seen.
vtkSmartPointer<vtkPolyData> TrianglesOf(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}
}

std::vector<std::string> BenchSceneNames()
{
  return { "cornell", "room", "atrium", Office, "flow-large", "globe", "vector-cloud", "winds" };
}

std::vector<std::string> AllSceneNames()
{
  std::vector<std::string> names = BenchSceneNames();
  names.insert(names.end(), { "balls", BallsApart });
  return names;
}

BenchScene LoadBenchScene(const std::string& name, const std::string& dataFolder)
{
  const widefov::Progress progress("making the scene " + name);
  BenchScene scene;
  scene.Name = name;
  if (name == Office)
  {
    SetOfficeCamera(scene.Camera);
    scene.Scene = widefov::ReadScene({ dataFolder + "/office.binary.vtk" });
  }
  else if (name == BallsApart)
  {
    scene.Scene = widefov::MakeBallsApart();
  }
  else
  {
    scene.Scene = widefov::MakeScene(name);
  }
  widefov::ApplyLook(scene.Scene, scene.Camera.Look);
  for (widefov::SceneProp& prop : scene.Scene.Props)
  {
    prop.Surface = TrianglesOf(prop.Surface);
    scene.FirstCells.push_back(scene.Triangles);
    scene.Triangles += prop.Surface->GetNumberOfCells();
  }
  const std::string error = widefov::MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    widefov::Fail("the scene " + name + " cannot be made: " + error);
  }
  return scene;
}

reference::TriangleSoup SoupOf(const BenchScene& scene, const reference::Pose& worldToView)
{
  reference::TriangleSoup soup;
  for (std::size_t i = 0; i < scene.Scene.Props.size(); ++i)
  {
    reference::Append(soup, scene.Scene.Props[i].Surface, worldToView, scene.FirstCells[i]);
  }
  return soup;
}
}
}
