// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

#include "Choices.h"

#include <algorithm>

namespace widefov
{
Wall::Wall(const ViewerOptions& o, const Scene& scene, const std::string& title)
  : Columns(o.Wall[0])
  , Rows(o.Wall[1])
{
  const std::array<int, 2>& size = o.Picture.Size;
  for (int i = 0; i < this->Columns * this->Rows; i++)
  {
    Pane pane;
    pane.Where = { this->Columns, this->Rows, i % this->Columns, i / this->Columns };
    const int monitor = this->Columns * this->Rows > 1 ? i + 1 : o.Monitor;
    pane.Window =
      std::make_unique<GlfwWindow>(title, size, o.FullScreen, monitor, ShowsEyesInTurn(o.Picture));
    if (i > 0 && !o.FullScreen)
    {
      pane.Window->PlaceBeside(
        *this->Panes[0].Window, pane.Where.Column * size[0], pane.Where.Row * size[1]);
    }
    pane.Stage = std::make_unique<ViewerStage>(
      pane.Window->GetHandle(), pane.Window->IsStereo(), scene, o.Picture, pane.Where);
    this->Panes.push_back(std::move(pane));
  }
}

void Wall::Poll()
{
  GlfwWindow::Poll();
}

void Wall::Wait(double seconds)
{
  GlfwWindow::Wait(seconds);
}

std::array<double, 2> Wall::ToWhole(const Pane& pane, double x, double y) const
{
  const std::array<int, 2> own = pane.Window->GetSize();
  const std::array<int, 2> whole = this->GetSize();
  return { { (pane.Where.Column + x / std::max(1, own[0])) * whole[0] / this->Columns,
    (pane.Where.Row + y / std::max(1, own[1])) * whole[1] / this->Rows } };
}

std::vector<WindowEvent> Wall::TakeEvents()
{
  std::vector<WindowEvent> all;
  for (const Pane& pane : this->Panes)
  {
    for (WindowEvent event : pane.Window->TakeEvents())
    {
      if (event.What == WindowEvent::Kind::Cursor)
      {
        const std::array<double, 2> at = this->ToWhole(pane, event.X, event.Y);
        event.X = at[0];
        event.Y = at[1];
      }
      all.push_back(event);
    }
  }
  // a pointer that leaves one window for another is heard of by both
  std::sort(all.begin(), all.end(),
    [](const WindowEvent& a, const WindowEvent& b) { return a.Order < b.Order; });
  return all;
}

bool Wall::TakeDamage()
{
  bool damaged = false;
  for (const Pane& pane : this->Panes)
  {
    damaged = pane.Window->TakeDamage() || damaged;
  }
  return damaged;
}

bool Wall::IsClosing() const
{
  return std::any_of(this->Panes.begin(), this->Panes.end(),
    [](const Pane& pane) { return pane.Window->IsClosing(); });
}

void Wall::Close()
{
  this->Panes[0].Window->Close();
}

void Wall::CheckAlive() const
{
  for (const Pane& pane : this->Panes)
  {
    pane.Window->CheckAlive();
  }
}

bool Wall::IsFullScreen() const
{
  return this->Panes[0].Window->IsFullScreen();
}

void Wall::SetFullScreen(bool on)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Window->SetFullScreen(on);
  }
}

// Of several windows each has its monitor already.
void Wall::NextMonitor()
{
  if (!this->IsSeveral())
  {
    this->Panes[0].Window->NextMonitor();
  }
}

std::array<double, 2> Wall::GetCursor() const
{
  const std::array<double, 2> at = this->Panes[0].Window->GetCursor();
  return this->ToWhole(this->Panes[0], at[0], at[1]);
}

std::array<int, 2> Wall::GetSize() const
{
  for (const Pane& pane : this->Panes)
  {
    const std::array<int, 2> own = pane.Window->GetSize();
    if (own[0] <= 0 || own[1] <= 0)
    {
      return { { 0, 0 } };
    }
  }
  const std::array<int, 2> first = this->Panes[0].Window->GetSize();
  return { { first[0] * this->Columns, first[1] * this->Rows } };
}

bool Wall::IsWithinLimits() const
{
  return std::all_of(this->Panes.begin(), this->Panes.end(), [](const Pane& pane) {
    const std::array<int, 2> size = pane.Window->GetSize();
    const std::array<int, 2> limits = pane.Stage->GetLimits();
    return size[0] <= limits[0] && size[1] <= limits[1];
  });
}

FrameCost Wall::Draw(const Options& o, const std::function<std::string(const FrameCost&)>& text,
  const std::string& help)
{
  FrameCost sum;
  // the first one last: its text tells what all of them took
  for (auto pane = this->Panes.rbegin(); pane != this->Panes.rend(); ++pane)
  {
    const bool first = pane + 1 == this->Panes.rend();
    const FrameCost before = sum;
    const auto total = [&](const FrameCost& cost) { return text(before + cost); };
    const std::array<int, 2> size = pane->Window->GetSize();
    sum = before +
      (first ? pane->Stage->Draw(o, size, total, help) : pane->Stage->Draw(o, size, nullptr, ""));
  }
  for (const Pane& pane : this->Panes)
  {
    pane.Window->Show();
  }
  return sum;
}

void Wall::SetUpdateRate(double rate)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Stage->SetUpdateRate(rate);
  }
}

bool Wall::Flip()
{
  bool flipped = false;
  for (const Pane& pane : this->Panes)
  {
    if (pane.Stage->IsFlipping())
    {
      pane.Stage->Flip();
      flipped = true;
    }
  }
  for (const Pane& pane : this->Panes)
  {
    if (flipped)
    {
      pane.Window->Show();
    }
  }
  return flipped;
}

bool Wall::HasBuffersForBoth() const
{
  return std::all_of(this->Panes.begin(), this->Panes.end(),
    [](const Pane& pane) { return pane.Window->IsStereo(); });
}

Picture Wall::Take(const Options& o)
{
  Picture whole;
  whole.Width = o.Size[0];
  whole.Height = o.Size[1];
  const int width = o.Size[0] / this->Columns;
  const int height = o.Size[1] / this->Rows;
  whole.Rgb.resize(3 * static_cast<std::size_t>(whole.Width) * whole.Height);
  for (const Pane& pane : this->Panes)
  {
    const Picture part = pane.Stage->Take(o, { { width, height } });
    const std::size_t row = 3 * static_cast<std::size_t>(width);
    for (int j = 0; j < height; j++)
    {
      const std::size_t to =
        static_cast<std::size_t>(pane.Where.Row * height + j) * this->Columns + pane.Where.Column;
      std::copy_n(part.Rgb.begin() + static_cast<std::ptrdiff_t>(row * j), row,
        whole.Rgb.begin() + static_cast<std::ptrdiff_t>(row * to));
    }
  }
  return whole;
}
}
