// SPDX-License-Identifier: BSD-3-Clause
#include "Molecule.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVPolyDataMapper.h>

#include <algorithm>
#include <filesystem>

namespace widefov
{
namespace
{
// As vtkMoleculeMapper draws balls and sticks: a share of the van der Waals radius, and
// the radius of a bond in the unit of the atoms' places.
constexpr double RadiusShare = 0.3;
constexpr double BondRadius = 0.075;

const char* const AtomRadius = "radius"; // of vtkPDBReader, van der Waals
const char* const BallRadius = "ball radius";
const char* const StickAxis = "stick axis";
const char* const StickSize = "stick size";

vtkSmartPointer<vtkFloatArray> AddArray(vtkPolyData* data, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  data->GetPointData()->AddArray(array);
  return array;
}

void AddVertices(vtkPolyData* data)
{
  vtkNew<vtkCellArray> verts;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i++)
  {
    verts->InsertNextCell(1, &i);
  }
  data->SetVerts(verts);
}

SceneProp Balls(const SceneProp& molecule)
{
  SceneProp prop = molecule;
  prop.Kind = SceneProp::Shape::Balls;
  prop.Surface = vtkSmartPointer<vtkPolyData>::New();
  prop.Surface->SetPoints(molecule.Surface->GetPoints());
  prop.Surface->GetPointData()->ShallowCopy(molecule.Surface->GetPointData());
  AddVertices(prop.Surface);
  vtkDataArray* const atoms = molecule.Surface->GetPointData()->GetArray(AtomRadius);
  auto radii = AddArray(prop.Surface, BallRadius, 1);
  for (vtkIdType i = 0; i < prop.Surface->GetNumberOfPoints(); i++)
  {
    radii->InsertNextValue(static_cast<float>(RadiusShare * atoms->GetComponent(i, 0)));
    prop.Margin = std::max(prop.Margin, static_cast<double>(radii->GetValue(i)));
  }
  return prop;
}

// Both halves of a bond, each with the arrays of its atom.
class StickMaker
{
public:
  StickMaker(vtkPolyData* molecule, vtkPolyData* sticks)
    : Molecule(molecule)
    , Sticks(sticks)
    , Axes(AddArray(sticks, StickAxis, 3))
    , Sizes(AddArray(sticks, StickSize, 3))
  {
    sticks->SetPoints(this->Points);
    this->Copied->CopyAllOn();
    this->Copied->CopyAllocate(molecule->GetPointData());
  }

  void AddBond(vtkIdType from, vtkIdType to)
  {
    double a[3];
    double b[3];
    this->Molecule->GetPoint(from, a);
    this->Molecule->GetPoint(to, b);
    double axis[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double length = vtkMath::Normalize(axis);
    for (const vtkIdType atom : { from, to })
    {
      const double t = atom == from ? 0.25 : 0.75;
      const vtkIdType id = this->Points->InsertNextPoint(
        a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
      this->Axes->InsertNextTuple(axis);
      this->Sizes->InsertNextTuple3(0.5 * length, BondRadius, 0);
      this->Copied->CopyData(this->Molecule->GetPointData(), atom, id);
    }
  }

  void Finish()
  {
    for (int i = 0; i < this->Copied->GetNumberOfArrays(); i++)
    {
      this->Sticks->GetPointData()->AddArray(this->Copied->GetAbstractArray(i));
    }
    vtkDataArray* const scalars = this->Molecule->GetPointData()->GetScalars();
    this->Sticks->GetPointData()->SetActiveScalars(scalars ? scalars->GetName() : nullptr);
    AddVertices(this->Sticks);
  }

private:
  vtkPolyData* Molecule;
  vtkPolyData* Sticks;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkPointData> Copied;
  vtkSmartPointer<vtkFloatArray> Axes;
  vtkSmartPointer<vtkFloatArray> Sizes;
};

SceneProp Sticks(const SceneProp& molecule)
{
  SceneProp prop = molecule;
  prop.Kind = SceneProp::Shape::Sticks;
  prop.Margin = BondRadius;
  prop.Surface = vtkSmartPointer<vtkPolyData>::New();
  StickMaker maker(molecule.Surface, prop.Surface);
  auto bonds = vtk::TakeSmartPointer(molecule.Surface->GetLines()->NewIterator());
  for (bonds->GoToFirstCell(); !bonds->IsDoneWithTraversal(); bonds->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* atoms;
    bonds->GetCurrentCell(count, atoms);
    for (vtkIdType i = 0; i + 1 < count; i++)
    {
      maker.AddBond(atoms[i], atoms[i + 1]);
    }
  }
  maker.Finish();
  vtkNew<vtkUnsignedCharArray> color;
  color->SetName(StickColor);
  color->SetNumberOfComponents(3);
  color->SetNumberOfTuples(prop.Surface->GetNumberOfPoints());
  for (int c = 0; c < 3; c++)
  {
    color->FillComponent(c, 255 * prop.Color[static_cast<std::size_t>(c)]);
  }
  prop.Surface->GetPointData()->AddArray(color);
  return prop;
}
}

bool IsMolecule(const SceneProp& prop)
{
  vtkDataArray* const radii = prop.Surface->GetPointData()->GetArray(AtomRadius);
  const std::string ending = std::filesystem::path(prop.Label).extension().string();
  const bool pdb = ending == ".pdb" || ending == ".PDB";
  return pdb && radii != nullptr && prop.Surface->GetNumberOfPolys() == 0;
}

std::vector<SceneProp> BallsAndSticks(const SceneProp& molecule)
{
  std::vector<SceneProp> props{ Balls(molecule) };
  if (molecule.Surface->GetNumberOfLines() > 0)
  {
    props.push_back(Sticks(molecule));
  }
  return props;
}

vtkSmartPointer<vtkPolyDataMapper> MakeMapper(const SceneProp& prop)
{
  if (prop.Kind == SceneProp::Shape::Balls)
  {
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetScaleArray(BallRadius);
    return mapper.Get();
  }
  if (prop.Kind == SceneProp::Shape::Sticks)
  {
    vtkNew<vtkOpenGLStickMapper> mapper;
    mapper->SetScaleArray(StickSize);
    mapper->SetOrientationArray(StickAxis);
    return mapper.Get();
  }
  vtkNew<vtkWideFoVPolyDataMapper> mapper; // stock but where the technique is tessellate
  return mapper.Get();
}
}
