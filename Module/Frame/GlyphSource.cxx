// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/GlyphSource.h"

#include "Clusters/Classifier.h"
#include "Shaders/Limits.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
void GlyphSource::Update(vtkPolyData* source)
{
  this->Mesh.Update(source);
  if (this->Time == source->GetMTime())
  {
    return;
  }
  this->Time = source->GetMTime();
  const Corners& corners = this->Mesh.GetCorners();
  this->Edges.resize(corners.size());
  this->LongestEdge = 0;
  bool finite = true;
  for (std::size_t i = 0; i < corners.size(); i++)
  {
    const std::size_t first = i - i % 3;
    double p[3];
    double q[3];
    source->GetPoint(corners[first + (i + 1) % 3], p);
    source->GetPoint(corners[first + (i + 2) % 3], q);
    this->Edges[i] = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    this->LongestEdge = std::max(this->LongestEdge, this->Edges[i]);
    finite = finite && std::isfinite(this->Edges[i]);
  }
  this->MostChords = 0;
  for (int chords = 1; finite && this->LongestEdge > 0 && chords <= Most; chords *= 2)
  {
    this->MostChords = this->CanCut(chords) ? chords : this->MostChords;
  }
}

// An edge has as many more chords as it is longer, in whatever way a copy is stretched; both
// triangles at it have the same.
int GlyphSource::ChordsOf(std::size_t edge, int chords) const
{
  const double share = this->Edges[edge] / this->LongestEdge;
  return std::max(1, static_cast<int>(std::ceil(share * chords)));
}

// As a triangle that is classified by itself.
bool GlyphSource::CanCut(int chords) const
{
  for (std::size_t i = 0; i < this->Edges.size(); i += 3)
  {
    const auto [least, most] = std::minmax(
      { this->ChordsOf(i, chords), this->ChordsOf(i + 1, chords), this->ChordsOf(i + 2, chords) });
    if (most > Classifier::MostRows && least > 1)
    {
      return false;
    }
  }
  return true;
}

std::vector<unsigned int> GlyphSource::ListChords(int chords) const
{
  std::vector<unsigned int> codes(this->Edges.size() / 3);
  for (std::size_t i = 0; i < this->Edges.size(); i++)
  {
    const int code = wfvCodeOfChords(static_cast<int>(i % 3), this->ChordsOf(i, chords));
    codes[i / 3] |= static_cast<unsigned int>(code);
  }
  return codes;
}
}
