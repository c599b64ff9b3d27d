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

// What one eye alone needs stays where it is.
void SortedDraw::Entry::HideInLot(Lot lot, const unsigned char* hidden)
{
  Sorter::Lot& all = this->Lots[lot];
  const auto isHidden = [&](std::size_t i) {
    return i >= all.Left && i < all.All - all.Right && hidden[i] != 0;
  };
  std::vector<std::size_t> places(all.All);
  std::iota(places.begin(), places.end(), std::size_t(0));
  const auto end = std::stable_partition(places.begin(), places.end(), isHidden);
  this->Arrange(lot, places);
  all.Hidden = static_cast<std::size_t>(end - places.begin());
}

// Those that are for both eyes were in the order of their numbers, pieces behind all others.
void SortedDraw::Entry::ShowLot(Lot lot)
{
  Sorter::Lot& all = this->Lots[lot];
  const unsigned int* const order = this->Order.data() + this->GetFirst(lot);
  const auto turn = [&](std::size_t i) {
    const bool piece = lot == Calm && this->Reaches[i] >= Sorter::PieceBits;
    return piece ? this->Reaches[i] : order[i];
  };
  std::vector<std::size_t> places;
  places.reserve(all.All);
  const std::size_t both = all.Hidden + all.Left;
  const std::size_t end = all.All - all.Right;
  for (std::size_t i = all.Hidden; i < both; i++)
  {
    places.push_back(i);
  }
  std::size_t hidden = 0;
  for (std::size_t i = both; i < end; i++)
  {
    for (; hidden < all.Hidden && turn(hidden) < turn(i); hidden++)
    {
      places.push_back(hidden);
    }
    places.push_back(i);
  }
  for (; hidden < all.Hidden; hidden++)
  {
    places.push_back(hidden);
  }
  for (std::size_t i = end; i < all.All; i++)
  {
    places.push_back(i);
  }
  this->Arrange(lot, places);
  all.Hidden = 0;
}
}
