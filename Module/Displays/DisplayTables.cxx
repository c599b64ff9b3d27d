// SPDX-License-Identifier: BSD-3-Clause
#include "Blending.h"
#include "DisplayFile.h"
#include "FileText.h"
#include "Readers.h"

#include <algorithm>

namespace wfv::displays
{
namespace
{
std::array<int, 2> SizeOf(const DisplayProjector& projector, const Calibration& calibration)
{
  const std::array<int, 2> size = projector.Size[0] > 0 ? projector.Size : calibration.Size;
  if (size[0] == 0)
  {
    throw FileError(
      projector.Calibration + " says no pixels; give the projector " + projector.Name + " a size");
  }
  return size;
}

// A lens of a file with the surface of the display.
Table CastLens(
  const DisplayFile& display, const Calibration& calibration, const std::array<int, 2>& size)
{
  const Frustum lens = *calibration.Lens;
  const Projector projector{ lens.Position, glm::dmat3(1),
    [lens](vec2 uv) { return lens.DirectionAt(uv); } };
  return CastTable(projector, *display.Lit, size[0], size[1]);
}

// True where the file has masks.
bool HasMask(const Calibration& calibration)
{
  const std::vector<WarpNode>& nodes = calibration.Mesh.Nodes;
  return calibration.Alpha.Width > 0 ||
    std::any_of(nodes.begin(), nodes.end(),
      [](const WarpNode& n) { return n.Brightness >= 0 && n.Brightness < 1; });
}

Table TableOf(const DisplayFile& display, const DisplayProjector& projector, bool& masked,
  std::vector<std::string>& notes)
{
  if (projector.Place)
  {
    return CastTable(
      *projector.Place, *display.Lit, projector.Size[0], projector.Size[1], projector.Mirror);
  }
  const Calibration calibration = ReadCalibration(projector.Calibration, projector.Region);
  notes.insert(notes.end(), calibration.Notes.begin(), calibration.Notes.end());
  const std::array<int, 2> size = SizeOf(projector, calibration);
  const bool lensAlone = calibration.Lens && calibration.Pixels.Width == 0;
  if (lensAlone && display.Lit)
  {
    return CastLens(display, calibration, size);
  }
  masked = HasMask(calibration);
  const Content content =
    display.Picture ? ContentOfView(*display.Picture->Map, display.Picture->Options) : Content();
  return MakeTable(calibration, size[0], size[1], content, projector.Gamma);
}
}

Content ContentOfView(const Projection& projection, const ViewOptions& options)
{
  const auto view = std::make_shared<const View>(projection, options);
  return [view](vec2 uv) {
    const ViewRay ray = view->Ray(2. * uv - 1.);
    return ray.Inside ? ray.Direction : vec3(std::nan(""));
  };
}

std::vector<Table> MakeTables(const DisplayFile& display, std::vector<std::string>& notes)
{
  std::vector<Table> tables;
  std::vector<double> blackLevels;
  std::array<std::string, 2> withMask; // names of one projector without, and of one with a mask
  for (const DisplayProjector& projector : display.Projectors)
  {
    bool masked = false;
    tables.push_back(TableOf(display, projector, masked, notes));
    if (!projector.Mask.empty())
    {
      const Mask mask = ReadPng(projector.Mask, ReadBytes(projector.Mask));
      ApplyMask(projector.Mask, mask, projector.MaskGamma, tables.back());
      masked = true;
    }
    withMask[masked ? 1 : 0] = projector.Name;
    blackLevels.push_back(projector.BlackLevel);
  }
  if (!withMask[0].empty() && !withMask[1].empty())
  {
    throw FileError(display.Path + ": the projector " + withMask[1] + " has a mask and " +
      withMask[0] + " has none; name masks for all, or for none to have them computed");
  }
  const bool black =
    std::any_of(blackLevels.begin(), blackLevels.end(), [](double level) { return level > 0; });
  const bool given = !withMask[1].empty();
  if (tables.size() > 1 && (black || !given))
  {
    Blend(tables, blackLevels, display.Eye, given ? Masks::Given : Masks::Computed);
  }
  return tables;
}
}
