// SPDX-License-Identifier: BSD-3-Clause
#include "FileKinds.h"

#include "CloudFile.h"
#include "System/MessageCatcher.h"
#include "Text/Messages.h"

#include <nlohmann/json.hpp>
#include <vtkBYUReader.h>
#include <vtkExodusIIReader.h>
#include <vtkGLTFReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkHDFReader.h>
#include <vtkInformation.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNetCDFCFReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPDBReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace widefov
{
namespace
{
using ReaderPointer = vtkSmartPointer<vtkAlgorithm>;

template <class Reader>
ReaderPointer MakePlain(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

// Legacy files may hold several arrays of each kind; VTK reads one where nothing is said.
ReaderPointer MakeLegacy(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

ReaderPointer MakeByu(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkBYUReader>::New();
  reader->SetGeometryFileName(path.c_str());
  return reader;
}

ReaderPointer MakeExodus(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkExodusIIReader>::New();
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  return reader;
}

// Longitude and latitude become a unit globe.
ReaderPointer MakeNetCdf(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkNetCDFCFReader>::New();
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOn();
  reader->ReplaceFillValueWithNanOn();
  return reader;
}

ReaderPointer MakeEnSight(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
  reader->SetCaseFileName(path.c_str());
  reader->ReadAllVariablesOn();
  return reader;
}

ReaderPointer MakeCloud(const std::string& path)
{
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(ReadCloud(path));
  return producer;
}

// Endings that are not read, and what a file is to be converted to.
struct Unread
{
  const char* Ending;
  const char* Advice;
};

const Unread UnreadKinds[] = {
  { ".xdmf", "ParaView or meshio saves it as .vtu or .vtkhdf" },
  { ".xmf", "ParaView or meshio saves it as .vtu or .vtkhdf" },
  { ".foam", "foamToVTK or ParaView saves it as .vtm" },
  // VTK reads the first axis of these as components
  { ".nrrd", "3D Slicer or SimpleITK saves it as .mha" },
  { ".nhdr", "3D Slicer or SimpleITK saves it as .mha" },
  { ".dcm", "dcm2niix saves a folder of DICOM as .nii" },
  { ".gz", "unpack it with gunzip" },
  { ".las", "PDAL saves it as .ply or .csv" },
  { ".laz", "PDAL saves it as .ply or .csv" },
  { ".fbx", "Blender or assimp saves it as .glb" },
  { ".dae", "Blender or assimp saves it as .glb" },
  { ".3ds", "Blender or assimp saves it as .glb" },
  { ".cgns", "ParaView saves it as .vtm" },
  { ".msh", "meshio saves it as .vtu" },
  { ".h5", "data of VTK in HDF5 end in .vtkhdf; ParaView saves others as .vtu" },
};
}

const std::vector<FileKind>& FileKinds()
{
  static const std::vector<FileKind> all{
    { ".vtk", "VTK, legacy", MakeLegacy },
    { ".vtp", "VTK, surface", MakePlain<vtkXMLPolyDataReader> },
    { ".vtu", "VTK, unstructured grid", MakePlain<vtkXMLUnstructuredGridReader> },
    { ".vti", "VTK, image", MakePlain<vtkXMLImageDataReader> },
    { ".vts", "VTK, structured grid", MakePlain<vtkXMLStructuredGridReader> },
    { ".vtr", "VTK, rectilinear grid", MakePlain<vtkXMLRectilinearGridReader> },
    { ".vtm", "VTK, blocks in several files", MakePlain<vtkXMLMultiBlockDataReader> },
    { ".pvtp", "VTK, parts of a surface", MakePlain<vtkXMLPPolyDataReader> },
    { ".pvtu", "VTK, parts of an unstructured grid", MakePlain<vtkXMLPUnstructuredGridReader> },
    { ".pvti", "VTK, parts of an image", MakePlain<vtkXMLPImageDataReader> },
    { ".pvts", "VTK, parts of a structured grid", MakePlain<vtkXMLPStructuredGridReader> },
    { ".pvtr", "VTK, parts of a rectilinear grid", MakePlain<vtkXMLPRectilinearGridReader> },
    { ".vtkhdf", "VTK in HDF5", MakePlain<vtkHDFReader> },
    { ".stl", "triangles of CAD", MakePlain<vtkSTLReader> },
    { ".ply", "meshes and clouds of scanners", MakePlain<vtkPLYReader> },
    { ".obj", "Wavefront", MakePlain<vtkOBJReader> },
    { ".g", "Movie.BYU", MakeByu },
    { ".pdb", "molecules of the Protein Data Bank", MakePlain<vtkPDBReader> },
    { ".ex2", "Exodus II", MakeExodus, true },
    { ".case", "EnSight", MakeEnSight, true },
    { ".nc", "NetCDF", MakeNetCdf },
    { ".cdf", "NetCDF", MakeNetCdf },
    { ".mha", "MetaImage", MakePlain<vtkMetaImageReader> },
    { ".mhd", "MetaImage, data in another file", MakePlain<vtkMetaImageReader> },
    { ".nii", "NIfTI images of medicine", MakePlain<vtkNIFTIImageReader> },
    { ".xyz", "points as text, a line each", MakeCloud },
    { ".pts", "points of scanners as text", MakeCloud },
    { ".csv", "points as text, with names of columns", MakeCloud },
    { ".glb", "glTF, binary", MakePlain<vtkGLTFReader> },
    { ".gltf", "glTF", MakePlain<vtkGLTFReader> },
  };
  return all;
}

std::string EndingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const FileKind& KindOf(const std::string& path)
{
  const std::string ending = EndingOf(path);
  std::string known;
  for (const FileKind& kind : FileKinds())
  {
    if (ending == kind.Ending)
    {
      return kind;
    }
    known += (known.empty() ? "" : " ") + std::string(kind.Ending);
  }
  for (const Unread& unread : UnreadKinds)
  {
    if (ending == unread.Ending)
    {
      Fail(path + ": there is no reader for '" + ending + "'; " + unread.Advice);
    }
  }
  Fail(path + ": there is no reader for '" + ending + "'; convert it to one of " + known);
}

std::string FormatList(bool json)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text;
  for (const FileKind& kind : FileKinds())
  {
    list.push_back({ { "ending", kind.Ending }, { "name", kind.Name } });
    const std::string ending = kind.Ending;
    text += ending + std::string(ending.size() < 9 ? 9 - ending.size() : 1, ' ') + kind.Name + "\n";
  }
  return json ? list.dump(2) + "\n" : text;
}

std::vector<double> TimesOfFile(const std::string& path)
{
  const FileKind& kind = KindOf(path);
  std::error_code error;
  if (!kind.HasSteps || !std::filesystem::is_regular_file(path, error))
  {
    return {}; // its reader will say so
  }
  const QuietStandardError quiet;
  const ReaderPointer reader = kind.MakeReader(path);
  reader->UpdateInformation();
  MessageCatcher::TakeFirstError(); // who reads the file says so
  vtkInformation* const about = reader->GetOutputInformation(0);
  const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const double* const times = about->Has(key) ? about->Get(key) : nullptr;
  return times ? std::vector<double>(times, times + about->Length(key)) : std::vector<double>();
}
}
