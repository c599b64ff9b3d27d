// SPDX-License-Identifier: BSD-3-Clause
// wfv::Stages: is the view still that of the last frame, and that of the other eye?
#include "Frame/Stages.h"

#include "Stereo/Stereo.h"

#include <algorithm>
#include <cmath>
#include <iterator>

void wfv::Stages::NumberView(const wfv::StereoModel* stereo)
{
  const wfv::WfvView& v = this->View;
  // everything that IsCulled and Choose go by, but the prop; the same for two eyes that are as far
  // from the middle, which is what they are asked about (SetEyes)
  const double seen[] = { v.halfFov.x, v.halfFov.y, v.scale.x, v.scale.y, v.tilt.x, v.tilt.y,
    v.radii.x, v.radii.y, v.lens.x, v.lens.y, v.lens.z, v.lens.w, v.lens5, v.lensHigh.x,
    v.lensHigh.y, v.lensHigh.z, v.lensHigh.w, v.maxAngle, v.curvature, wfv::wfvFromMiddle(v),
    v.stereo.x, v.stereo.y, v.stereo.z, v.stereo.w, static_cast<double>(v.depthMapping), v.tables.x,
    v.tables.y, v.tables.z, v.tables.w, this->Tolerance, this->HalfDiagonal, this->PixelAngle,
    this->Part.Low.x, this->Part.Low.y, this->Part.High.x, this->Part.High.y, this->Pixels.x,
    this->Pixels.y, static_cast<double>(this->Technique), static_cast<double>(this->Culling) };
  const void* const objects[] = { this->Projection, stereo, v.map };
  const bool same = this->ViewNumber > 0 &&
    std::equal(std::begin(seen), std::end(seen), this->Numbered.begin(), this->Numbered.end()) &&
    std::equal(std::begin(objects), std::end(objects), std::begin(this->NumberedObjects)) &&
    std::equal(this->WorldToView, this->WorldToView + 16, this->NumberedMatrix);
  if (!same)
  {
    this->ViewNumber++;
    this->Numbered.assign(std::begin(seen), std::end(seen));
    std::copy(std::begin(objects), std::end(objects), this->NumberedObjects);
    std::copy_n(this->WorldToView, 16, this->NumberedMatrix);
  }
}
