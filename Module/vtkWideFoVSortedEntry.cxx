// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSortedEntry.h"

#include <numeric>

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
  if (this->Loaded || this->Reaches.empty())
  {
    return;
  }
  this->ReachTexture.Load(window, this->Reaches);
  this->PieceTexture.LoadFours(window, this->Pieces);
  this->Loaded = true;
}

bool SortedDraw::Entry::TakeNaturalOrder()
{
  if (!this->Order.empty())
  {
    return false;
  }
  this->Order.resize(this->All);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  return true;
}

void SortedDraw::Entry::Arrange(Lot lot, const std::vector<std::size_t>& places)
{
  const std::size_t first = this->GetFirst(lot);
  const auto arrange = [&](std::vector<unsigned int>& list, std::size_t from) {
    std::vector<unsigned int> other(places.size());
    std::transform(places.begin(), places.end(), other.begin(),
      [&](std::size_t place) { return list[from + place]; });
    std::copy(other.begin(), other.end(), list.begin() + static_cast<std::ptrdiff_t>(from));
  };
  arrange(this->Order, first);
  if (lot == Calm)
  {
    arrange(this->Reaches, 0);
  }
}

void SortedDraw::Entry::HideInLot(Lot lot, const unsigned char* hidden)
{
  Sorter::Lot& all = this->Lots[lot];
  std::vector<std::size_t> places(all.All);
  std::iota(places.begin(), places.end(), std::size_t(0));
  const auto left = places.begin() + static_cast<std::ptrdiff_t>(all.Left);
  const auto right = places.end() - static_cast<std::ptrdiff_t>(all.Right);
  const auto isHidden = [&](std::size_t i) { return hidden[i] != 0; };
  const auto isShown = [&](std::size_t i) { return hidden[i] == 0; };
  const auto leftShown = std::stable_partition(places.begin(), left, isHidden);
  const auto bothShown = std::stable_partition(left, right, isHidden);
  const auto rightHidden = std::stable_partition(right, places.end(), isShown);
  all.LeftHidden = static_cast<std::size_t>(leftShown - places.begin());
  all.Hidden = static_cast<std::size_t>(bothShown - left);
  all.RightHidden = static_cast<std::size_t>(places.end() - rightHidden);
  std::rotate(places.begin(), left, bothShown);
  this->Arrange(lot, places);
}

// Triangles were in the order of their numbers; of those for the left eye alone pieces came first,
// of others they came last.
void SortedDraw::Entry::ShowLot(Lot lot)
{
  Sorter::Lot& all = this->Lots[lot];
  const unsigned int* const order = this->Order.data() + this->GetFirst(lot);
  const auto before = [&](std::size_t i, std::size_t j, bool piecesFirst) {
    const bool piece[2] = { this->IsPiece(lot, i), this->IsPiece(lot, j) };
    const bool apart = piece[0] != piece[1];
    return apart ? piece[0] == piecesFirst
      : piece[0] ? this->Reaches[i] < this->Reaches[j]
                 : order[i] < order[j];
  };
  std::vector<std::size_t> places(all.All);
  std::iota(places.begin(), places.end(), std::size_t(0));
  // hidden ones of both behind the left eye's own
  const auto first = places.begin();
  const auto hidden = static_cast<std::ptrdiff_t>(all.Hidden);
  const auto left = static_cast<std::ptrdiff_t>(all.Left);
  const auto right = places.end() - static_cast<std::ptrdiff_t>(all.Right);
  std::rotate(first, first + hidden, first + hidden + left);
  const auto last = [&](std::size_t i, std::size_t j) { return before(i, j, false); };
  std::inplace_merge(first, first + static_cast<std::ptrdiff_t>(all.LeftHidden), first + left,
    [&](std::size_t i, std::size_t j) { return before(i, j, true); });
  std::inplace_merge(first + left, first + left + hidden, right, last);
  std::inplace_merge(
    right, places.end() - static_cast<std::ptrdiff_t>(all.RightHidden), places.end(), last);
  this->Arrange(lot, places);
  all.Hidden = all.LeftHidden = all.RightHidden = 0;
}
}
