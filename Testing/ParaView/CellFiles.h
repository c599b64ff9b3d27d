// SPDX-License-Identifier: BSD-3-Clause
// What widefov-check-cells reads with VTK's classes. Its JSON is read in another source: the VTK of
// ParaView 5.12 and later brings a JSON library of its own, and its headers and the system's cannot
// be included together.
#ifndef WideFoVCellFiles_h
#define WideFoVCellFiles_h

#include "Metrics.h"
#include "RayCaster.h"

#include <array>
#include <string>

namespace checkcells
{
// Throws where the file is no picture of colours.
wfv::reference::DrawnPicture ReadPicture(const std::string& file);

// World to view, of a camera there.
wfv::reference::Pose MakePose(const std::array<double, 3>& eye, const std::array<double, 3>& focal,
  const std::array<double, 3>& up);

// The triangles of the mesh, each with its cell's number less one for an id. Throws where it has
// no numbers, or they do not grow.
wfv::reference::TriangleSoup ReadSoup(const std::string& file, const wfv::reference::Pose& pose);
}

#endif
