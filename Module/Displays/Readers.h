// SPDX-License-Identifier: BSD-3-Clause
// The readers of ReadCalibrations, one a format. Each takes the path for its messages and the bytes
// of the file, and throws a FileError.
#ifndef WideFoVReaders_h
#define WideFoVReaders_h

#include "Calibration.h"

#include <functional>

namespace wfv::displays
{
// Gives the bytes of a part of an archive. Throws a FileError where there is none.
using PartReader = std::function<std::string(const std::string& name)>;

Calibration ReadBourke(const std::string& path, const std::string& bytes);
Calibration ReadObjWarp(const std::string& path, const std::string& bytes);
Calibration ReadPfmWarp(const std::string& path, const std::string& bytes);
Calibration ReadSciss(const std::string& path, const std::string& bytes);
Calibration ReadSkySkan(const std::string& path, const std::string& bytes);
Calibration ReadScalable(const std::string& path, const std::string& bytes);
Calibration ReadDomeprojection(const std::string& path, const std::string& bytes);

// SimCAD or MPCDI, told by the root element; the parts of MPCDI lie in the file's folder.
std::vector<Calibration> ReadXml(const std::string& path, const std::string& bytes);

// An archive of MPCDI.
std::vector<Calibration> ReadMpcdiArchive(const std::string& path);

// The description of MPCDI; `path` is where it lies, for messages.
std::vector<Calibration> ReadMpcdi(
  const std::string& path, const std::string& xml, const PartReader& parts);

// A portable float map of three channels (PF).
Raster ReadPfm(const std::string& path, const std::string& bytes);

// Takes the pixels without a value out of the calibration. Throws a FileError where none is left or
// the map folds; notes what else is odd.
void CheckPixels(const std::string& path, Calibration& calibration);

// A PNG image as grey: the mean of its colours.
Mask ReadPng(const std::string& path, const std::string& bytes);

// Quads between the nodes of a grid, two triangles each, cut from (column, row) to (column + 1,
// row + 1). A triangle with a node that `used` denies is left out. `wraps`: the last column hangs
// together with the first.
void AddGrid(WarpMesh& mesh, std::size_t columns, std::size_t rows,
  const std::function<bool(const WarpNode&)>& used = {}, bool wraps = false);

// Throws a FileError where a triangle has a node that is not there, no triangle has an area, or
// the mesh folds: some of its triangles show the picture mirrored and others do not. Notes a fold
// that is as small as noise.
void CheckMesh(const std::string& path, Calibration& calibration);

// Throws a FileError unless the borders are apart and less than a quarter turn from the axis.
void CheckFrustum(const std::string& path, const Frustum& frustum);

// The frustum of these angles, degrees, to the left and downwards negative.
Frustum FrustumOfAngles(double left, double right, double down, double up);

// Rotation by `degrees` about the axis 0 (x), 1 (y) or 2 (z), counterclockwise seen from its tip.
glm::dmat3 RotationAbout(int axis, double degrees);
}

#endif
