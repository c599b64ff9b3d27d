// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSortedEntry.h"

#include <algorithm>
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

void SortedDraw::Entry::LoadFolds(vtkOpenGLRenderWindow* window)
{
  if (this->FoldsLoaded)
  {
    return;
  }
  std::vector<unsigned char> ordered(this->Order.size());
  std::transform(this->Order.begin(), this->Order.end(), ordered.begin(),
    [this](unsigned int triangle) { return this->Folds[triangle]; });
  this->FoldTexture.Load(window, ordered.empty() ? this->Folds : ordered);
  this->FoldsLoaded = true;
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
  Sorter::Lot& all = this->Lots[lot];
  const auto arrange = [&](std::vector<unsigned int>& list, std::size_t from) {
    std::vector<unsigned int> other(places.size());
    std::transform(places.begin(), places.end(), other.begin(),
      [&](std::size_t place) { return list[from + place]; });
    const auto first = list.begin() + static_cast<std::ptrdiff_t>(from);
    const std::size_t kept = std::min(all.All, places.size());
    const auto end = std::copy_n(other.begin(), kept, first);
    kept < all.All
      ? list.erase(end, first + static_cast<std::ptrdiff_t>(all.All))
      : list.insert(end, other.begin() + static_cast<std::ptrdiff_t>(kept), other.end());
  };
  arrange(this->Order, this->GetFirst(lot));
  if (lot == Calm)
  {
    arrange(this->Reaches, 0);
  }
  all.All = places.size();
}

void SortedDraw::Entry::HideInLot(Lot lot, const unsigned char* hidden)
{
  Sorter::Lot& all = this->Lots[lot];
  std::vector<std::size_t> places;
  places.reserve(all.All);
  const auto put = [&](std::size_t from, std::size_t to, int asked, int answer) {
    const std::size_t before = places.size();
    for (std::size_t i = from; i < to; i++)
    {
      if ((hidden[i] & asked) == answer)
      {
        places.push_back(i);
      }
    }
    return places.size() - before;
  };
  const std::size_t left = all.Left;
  const std::size_t right = all.All - all.Right;
  all.Hidden = put(left, right, NoEye, NoEye);
  all.LeftHidden = put(0, left, NoEye, NoEye);
  put(0, left, LeftEye, 0);
  const bool apart = std::any_of(hidden + left, hidden + right,
    [](unsigned char eyes) { return eyes == LeftEye || eyes == RightEye; });
  const std::size_t seen = put(left, right, LeftEye, 0);
  all.LeftSees = apart ? seen : 0;
  all.RightSees = apart ? put(left, right, RightEye, 0) : 0;
  all.Twice = all.LeftSees + all.RightSees - (apart ? right - left - all.Hidden : 0);
  put(right, all.All, RightEye, 0);
  all.RightHidden = put(right, all.All, NoEye, NoEye);
  this->Arrange(lot, places);
}

// Triangles were in the order of their numbers; of those for the left eye alone pieces came first,
// of others they came last.
bool SortedDraw::Entry::ComesBefore(Lot lot, std::size_t i, std::size_t j, bool piecesFirst) const
{
  const bool piece[2] = { this->IsPiece(lot, i), this->IsPiece(lot, j) };
  const unsigned int* const order = this->Order.data() + this->GetFirst(lot);
  return piece[0] != piece[1] ? piece[0] == piecesFirst
    : piece[0]                ? this->Reaches[i] < this->Reaches[j]
                              : order[i] < order[j];
}

// places: those of both eyes' lists, one after the other; what is in both once after it.
void SortedDraw::Entry::MergeBoth(Lot lot, std::vector<std::size_t>& places) const
{
  const auto before = [&](std::size_t i, std::size_t j) {
    return this->ComesBefore(lot, i, j, false);
  };
  const auto same = [&](std::size_t i, std::size_t j) { return !before(i, j); };
  const auto hidden = static_cast<std::ptrdiff_t>(this->Lots[lot].Hidden);
  const auto seen = places.begin() + hidden + static_cast<std::ptrdiff_t>(this->Lots[lot].LeftSees);
  std::inplace_merge(places.begin() + hidden, seen, places.end(), before);
  places.erase(std::unique(places.begin() + hidden, places.end(), same), places.end());
  std::inplace_merge(places.begin(), places.begin() + hidden, places.end(), before);
}

void SortedDraw::Entry::ShowLot(Lot lot)
{
  Sorter::Lot& all = this->Lots[lot];
  const auto at = [&](std::size_t from, std::size_t count) {
    std::vector<std::size_t> places(count);
    std::iota(places.begin(), places.end(), from);
    return places;
  };
  std::vector<std::size_t> places = at(all.Hidden, all.Left);
  std::inplace_merge(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(all.LeftHidden),
    places.end(), [&](std::size_t i, std::size_t j) { return this->ComesBefore(lot, i, j, true); });
  std::vector<std::size_t> both = at(0, all.Hidden);
  const std::vector<std::size_t> seen =
    at(all.Hidden + all.Left, all.All - all.Hidden - all.Left - all.Right);
  both.insert(both.end(), seen.begin(), seen.end());
  this->MergeBoth(lot, both);
  std::vector<std::size_t> right = at(all.All - all.Right, all.Right);
  std::inplace_merge(right.begin(), right.end() - static_cast<std::ptrdiff_t>(all.RightHidden),
    right.end(), [&](std::size_t i, std::size_t j) { return this->ComesBefore(lot, i, j, false); });
  places.insert(places.end(), both.begin(), both.end());
  places.insert(places.end(), right.begin(), right.end());
  this->Arrange(lot, places);
  all.Hidden = all.LeftHidden = all.RightHidden = 0;
  all.LeftSees = all.RightSees = all.Twice = 0;
}
}
