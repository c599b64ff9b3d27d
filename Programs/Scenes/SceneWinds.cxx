// SPDX-License-Identifier: BSD-3-Clause
// The Earth's relief seen from its centre, with the January winds floating inside.
#include "ColorMaps.h"
#include "MeshBuilder.h"
#include "Scenes.h"
#include "Text/Angles.h"
#include "Text/Messages.h"
#include "VectorField.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNetCDFCFReader.h>
#include <vtkPointData.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace widefov
{
namespace
{
const char* const DataVariable = "WIDEFOV_DATA_DIR";
const char* const DebianFolder = "/usr/share/ferret-vis/data";
const char* const ReliefArray = "ROSE"; // metres above the sea
const char* const WindArray = "wind";   // metres a second, towards
constexpr double ArrowRadius = 0.90;    // of the relief's
constexpr double MissingBelow = -1e30;  // the files' mark for no data
constexpr double LowestDirect = 1e-3;   // metres a second: weaker winds are no wind

// The grid of a file over longitude and latitude (degrees), its values at the points.
vtkSmartPointer<vtkImageData> ReadMap(const std::string& name, const char* array)
{
  const char* const folder = std::getenv(DataVariable);
  const std::string path = std::string(folder != nullptr ? folder : DebianFolder) + "/" + name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(path + " is not there; install the package ferret-datasets, or let " + DataVariable +
      " name the folder that has it");
  }
  vtkNew<vtkNetCDFCFReader> reader;
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOff();
  reader->Update();
  vtkSmartPointer<vtkImageData> map = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (map == nullptr || map->GetPointData()->GetArray(array) == nullptr ||
    map->GetDimensions()[0] < 3 || map->GetDimensions()[1] < 3)
  {
    Fail(path + " holds no map of " + array + "; install the package ferret-datasets again");
  }
  return map;
}

// Rows and columns of a map that goes once round: the last column may repeat the first.
class MapGrid
{
public:
  MapGrid(vtkImageData* map, const char* array)
    : Values(map->GetPointData()->GetArray(array))
    , Stored(map->GetDimensions()[0])
    , Rows(map->GetDimensions()[1])
  {
    map->GetOrigin(this->Origin.data());
    map->GetSpacing(this->Spacing.data());
    this->Columns = std::min(this->Stored, static_cast<int>(std::lround(360 / this->Spacing[0])));
  }

  double Longitude(int i) const { return this->Origin[0] + i * this->Spacing[0]; }
  double Latitude(int j) const { return this->Origin[1] + j * this->Spacing[1]; }
  double Value(int i, int j) const
  {
    const int column = (i % this->Columns + this->Columns) % this->Columns;
    const int row = std::max(0, std::min(this->Rows - 1, j));
    return this->Values->GetTuple1(static_cast<vtkIdType>(row) * this->Stored + column);
  }

  vtkDataArray* Values;
  int Stored;
  int Rows;
  int Columns = 0;
  Vector3 Origin;
  Vector3 Spacing;
};

// Towards the eye, tilted by the slope of the relief, much exaggerated.
Vector3 ReliefNormal(const MapGrid& grid, int i, int j)
{
  constexpr double Exaggeration = 25;
  constexpr double EarthRadius = 6.371e6; // metres
  const double degree = EarthRadius * Degree;
  const double lon = grid.Longitude(i);
  const double lat = grid.Latitude(j);
  const double stretch = std::max(0.2, std::cos(lat / 57.29577951308232));
  const double east =
    (grid.Value(i + 1, j) - grid.Value(i - 1, j)) / (2 * grid.Spacing[0] * degree * stretch);
  const double north =
    (grid.Value(i, j + 1) - grid.Value(i, j - 1)) / (2 * grid.Spacing[1] * degree);
  const Vector3 p = DirectionOf(lon, lat);
  const Vector3 toEast = DirectionOf(lon + 90, 0);
  const Vector3 toNorth = lat < 0 ? DirectionOf(lon, lat + 90) : -1 * DirectionOf(lon, lat - 90);
  return Unit(-1 * p + -Exaggeration * east * toEast + -Exaggeration * north * toNorth);
}

// Fills the ring of points first, first + 1, .., first + count - 1: every second point is
// joined to the next but one until a triangle is left. Unlike a fan round the pole it
// has no thousand slivers that all meet where the map is torn.
void CloseRing(MeshBuilder& mesh, vtkIdType first, vtkIdType count)
{
  vtkIdType step = 1;
  for (; 2 * step < count; step *= 2)
  {
    for (vtkIdType i = 0; i + step < count; i += 2 * step)
    {
      const vtkIdType last = i + 2 * step;
      if (last < count || i > 0) // the last ear of a level may end at the first point
      {
        mesh.AddTriangle(first + i, first + i + step, first + (last < count ? last : 0));
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeRelief(vtkImageData* map)
{
  const MapGrid grid(map, ReliefArray);
  MeshBuilder mesh;
  vtkNew<vtkFloatArray> heights;
  heights->SetName(ReliefArray);
  const Vector3 gray{ { 0.5, 0.5, 0.5 } };
  for (int j = 0; j < grid.Rows; j++)
  {
    for (int i = 0; i < grid.Columns; i++)
    {
      mesh.AddPoint(
        DirectionOf(grid.Longitude(i), grid.Latitude(j)), ReliefNormal(grid, i, j), gray);
      heights->InsertNextValue(static_cast<float>(grid.Value(i, j)));
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<vtkIdType>(j) * grid.Columns + i % grid.Columns;
  };
  for (int j = 0; j + 1 < grid.Rows; j++)
  {
    for (int i = 0; i < grid.Columns; i++)
    {
      mesh.AddTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.AddTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  for (const int row : { 0, grid.Rows - 1 })
  {
    CloseRing(mesh, at(0, row), grid.Columns);
  }
  const vtkSmartPointer<vtkPolyData> relief = mesh.Build();
  relief->GetPointData()->SetScalars(heights);
  return relief;
}

// The wind as vectors in the scene, on two shells round ArrowRadius so that stream
// lines have a volume to run in. Zero where there are no data.
vtkSmartPointer<vtkStructuredGrid> MakeWindShell(vtkImageData* map)
{
  const MapGrid east(map, "UWND");
  const MapGrid north(map, "VWND");
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> winds;
  winds->SetName(WindArray);
  winds->SetNumberOfComponents(3);
  constexpr double HalfThickness = 0.02;
  for (const double r : { ArrowRadius - HalfThickness, ArrowRadius, ArrowRadius + HalfThickness })
  {
    for (int j = 0; j < east.Rows; j++)
    {
      for (int i = 0; i <= east.Columns; i++) // closed: the first column again
      {
        const double lon = east.Longitude(i);
        const double lat = east.Latitude(j);
        const double u = east.Value(i, j);
        const double v = north.Value(i, j);
        const bool known = u > MissingBelow && v > MissingBelow && std::hypot(u, v) > LowestDirect;
        const Vector3 toNorth =
          lat < 0 ? DirectionOf(lon, lat + 90) : -1 * DirectionOf(lon, lat - 90);
        const Vector3 wind = u * DirectionOf(lon + 90, 0) + v * toNorth;
        points->InsertNextPoint((r * DirectionOf(lon, lat)).data());
        winds->InsertNextTuple(known ? wind.data() : Vector3{ { 0, 0, 0 } }.data());
      }
    }
  }
  vtkNew<vtkStructuredGrid> shell;
  shell->SetDimensions(east.Columns + 1, east.Rows, 3);
  shell->SetPoints(points);
  shell->GetPointData()->SetVectors(winds);
  return shell;
}

// Places about `step` degrees apart on the middle shell, fewer towards the poles.
vtkSmartPointer<vtkPolyData> ShellPoints(vtkStructuredGrid* shell, int step, int shift)
{
  vtkNew<vtkPolyData> result;
  vtkNew<vtkPoints> points;
  result->GetPointData()->CopyAllocate(shell->GetPointData());
  int size[3];
  shell->GetDimensions(size);
  const double degrees = 360. / (size[0] - 1);
  const int rows = std::max(1, static_cast<int>(std::lround(step / degrees)));
  for (int j = shift % rows; j < size[1]; j += rows)
  {
    const double latitude = (-90 + 180 * (j + 0.5) / size[1]) / 57.29577951308232;
    const int stride =
      std::max(1, static_cast<int>(std::lround(rows / std::max(0.05, std::cos(latitude)))));
    for (int i = shift % stride; i < size[0] - 1; i += stride)
    {
      const vtkIdType id = (static_cast<vtkIdType>(size[1]) + j) * size[0] + i;
      const vtkIdType next = points->InsertNextPoint(shell->GetPoint(id));
      result->GetPointData()->CopyData(shell->GetPointData(), id, next);
    }
  }
  result->SetPoints(points);
  return result;
}

SceneProp WindProp(vtkPolyData* surface, vtkDataObject* source, vtkScalarsToColors* map)
{
  SceneProp prop;
  prop.Surface = surface;
  prop.Source = source;
  prop.Label = "winds";
  prop.Array = WindArray;
  prop.ColorMap = map;
  prop.Ambient = 0.4;
  prop.Diffuse = 0.6;
  return prop;
}
}

Scene MakeWinds()
{
  constexpr double Strongest = 12; // metres a second, the end of the colour map
  const vtkSmartPointer<vtkImageData> heights = ReadMap("etopo20.cdf", ReliefArray);
  const vtkSmartPointer<vtkImageData> climate = ReadMap("coads_climatology.cdf", "UWND");
  if (climate->GetPointData()->GetArray("VWND") == nullptr)
  {
    Fail("coads_climatology.cdf holds no map of VWND; install the package ferret-datasets again");
  }
  const vtkSmartPointer<vtkStructuredGrid> shell = MakeWindShell(climate);
  Scene scene;
  scene.Eye = Vector3{ { 0, 0, 0 } };
  SceneProp relief;
  relief.Surface = MakeRelief(heights);
  relief.Source = relief.Surface;
  relief.Label = "winds";
  relief.Array = ReliefArray;
  relief.ColorMap = MakeReliefColorMap();
  scene.Props.push_back(relief);

  scene.BarMap = MakeColorMap("rainbow", 0, Strongest, -1);
  scene.BarTitle = "wind, m/s";
  ArrowSettings arrows;
  arrows.Length = 0.15;
  arrows.Thickness = 2;
  arrows.Reference = Strongest;
  scene.Props.push_back(
    WindProp(MakeArrows(ShellPoints(shell, 6, 0), WindArray, arrows), shell, scene.BarMap));
  TubeSettings tubes;
  tubes.Seeds = ShellPoints(shell, 14, 3);
  tubes.Radius = 0.0025;
  tubes.Length = 0.5;
  tubes.Sides = 6;
  scene.Props.push_back(WindProp(MakeStreamTubes(shell, WindArray, tubes), shell, scene.BarMap));
  return scene;
}
}
