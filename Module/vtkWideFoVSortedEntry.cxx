// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSortedEntry.h"

namespace wfv
{
// still: nothing has changed since the last one.
void SortedDraw::Entry::CountFrame(bool still, int eye)
{
  const bool next = eye == this->FirstEye || eye == this->LastEye;
  this->Frames = still ? this->Frames + (next ? 1 : 0) : 0;
  this->FirstEye = still ? this->FirstEye : eye;
  this->LastEye = eye;
}

void SortedDraw::Entry::TakePieces(const std::vector<CoverPiece>& pieces)
{
  this->Cuts = !pieces.empty();
  this->Pieces.clear();
  for (const CoverPiece& p : pieces)
  {
    const double eye = p.Eye;
    for (const double number : { p.From.x, p.From.y, p.Side.x, p.Side.y, p.Height, eye, 0.0, 0.0 })
    {
      this->Pieces.push_back(static_cast<float>(number));
    }
  }
  this->Pieces.resize(std::max<std::size_t>(this->Pieces.size(), 8)); // the shader reads one
}

void SortedDraw::Entry::Load(vtkOpenGLRenderWindow* window)
{
  if (this->Reaches.empty())
  {
    return;
  }
  this->ReachTexture.Load(window, this->Reaches);
  this->PieceTexture.LoadFours(window, this->Pieces);
  this->Reaches = std::vector<unsigned int>();
  this->Pieces = std::vector<float>();
}
}
