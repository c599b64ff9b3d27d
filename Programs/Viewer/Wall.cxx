// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

#include "System/CrashGuard.h"
#include "Viewing/Choices.h"

#include <algorithm>

namespace widefov
{
namespace
{
constexpr const char* ProgramName = "widefov-viewer"; // begins the titles

bool IsVisible(const std::array<int, 2>& size)
{
  return size[0] > 0 && size[1] > 0;
}

// Puts a picture into a larger one.
void Insert(const Picture& part, int column, int row, Picture& whole)
{
  const std::size_t bytes = 3 * static_cast<std::size_t>(part.Width);
  for (int j = 0; j < part.Height; j++)
  {
    const std::size_t to = static_cast<std::size_t>(row + j) * whole.Width + column;
    std::copy_n(part.Rgb.begin() + static_cast<std::ptrdiff_t>(bytes * j), bytes,
      whole.Rgb.begin() + static_cast<std::ptrdiff_t>(3 * to));
  }
}
}

Wall::Wall(const ViewerOptions& o, const std::vector<Options>& parts)
  : Columns(o.Wall[0])
  , Rows(o.Wall[1])
{
  for (int i = 0; i < this->Columns * this->Rows; i++)
  {
    for (const Options& part : parts)
    {
      this->AddPane(o, part);
    }
  }
}

void Wall::AddPane(const ViewerOptions& o, const Options& part)
{
  const int i = static_cast<int>(this->Panes.size());
  const bool tiled = this->IsTiled();
  Pane pane;
  if (tiled)
  {
    pane.Where = { this->Columns, this->Rows, i % this->Columns, i / this->Columns };
  }
  pane.Part = tiled ? 0 : this->Panes.size();
  pane.Name = part.Screen ? ": " + part.Screen->Name : "";
  const int monitor = tiled || part.Screen ? i + 1 : o.Monitor;
  pane.Window = std::make_unique<GlfwWindow>(
    ProgramName + pane.Name, part.Size, o.FullScreen, monitor, ShowsEyesInTurn(o.Picture));
  if (i > 0 && !o.FullScreen)
  {
    // screens in one row
    const int right = tiled ? pane.Where.Column * part.Size[0] : GetSize()[0];
    pane.Window->PlaceBeside(*this->Panes[0].Window, right, pane.Where.Row * part.Size[1]);
  }
  pane.Stage = std::make_unique<ViewerStage>(
    pane.Window->GetHandle(), pane.Window->IsStereo(), part, pane.Where);
  this->Panes.push_back(std::move(pane));
}

void Wall::SetScene(const Scene& scene, const Look& look)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Stage->SetScene(scene, look);
  }
}

void Wall::SetVolumeOpacity(double factor)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Stage->SetVolumeOpacity(factor);
  }
}

void Wall::SetTitle(const std::string& title)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Window->SetTitle(ProgramName + (": " + title) + pane.Name);
  }
}

std::unique_ptr<Panel> Wall::MakePanel() const
{
  return widefov::MakePanel(this->Panes[0].Window->GetHandle());
}

void Wall::DrawOver(Panel* over) const
{
  if (over != nullptr)
  {
    this->Panes[0].Stage->DrawOver([over] { over->Draw(); });
  }
}

void Wall::ShowAgain(Panel& over)
{
  this->Panes[0].Window->CheckAlive();
  this->Panes[0].Stage->ShowAgain();
  this->DrawOver(&over);
  this->Panes[0].Window->Show();
}

void Wall::Poll()
{
  GlfwWindow::Poll();
}

void Wall::Wait(double seconds)
{
  GlfwWindow::Wait(seconds);
}

std::array<double, 2> Wall::ToPart(const Pane& pane, double x, double y) const
{
  const std::array<int, 2> own = pane.Window->GetSize();
  const std::array<int, 2> whole = this->GetSize(pane.Part);
  return { { (pane.Where.Column + x / std::max(1, own[0])) * whole[0] / this->Columns,
    (pane.Where.Row + y / std::max(1, own[1])) * whole[1] / this->Rows } };
}

std::optional<Place> Wall::FindPane(const Place& place) const
{
  const std::array<int, 2> size = this->GetSize(place.Part);
  const double x = place.At[0] / std::max(1, size[0]) * this->Columns;
  const double y = place.At[1] / std::max(1, size[1]) * this->Rows;
  for (std::size_t i = 0; i < this->Panes.size(); i++)
  {
    const Pane& pane = this->Panes[i];
    const double right = x - pane.Where.Column;
    const double down = y - pane.Where.Row;
    if (pane.Part == place.Part && right >= 0 && right < 1 && down >= 0 && down < 1)
    {
      const std::array<int, 2> own = pane.Window->GetSize();
      return Place{ i, { { right * own[0], down * own[1] } } };
    }
  }
  return std::nullopt;
}

std::vector<WindowEvent> Wall::TakeEvents()
{
  std::vector<WindowEvent> all;
  for (const Pane& pane : this->Panes)
  {
    for (WindowEvent event : pane.Window->TakeEvents())
    {
      event.Part = pane.Part;
      if (event.What == WindowEvent::Kind::Cursor)
      {
        const std::array<double, 2> at = this->ToPart(pane, event.X, event.Y);
        event.X = at[0];
        event.Y = at[1];
      }
      all.push_back(event);
    }
  }
  if (this->Preview)
  {
    const std::vector<WindowEvent> keys = this->Preview->TakeEvents();
    all.insert(all.end(), keys.begin(), keys.end());
  }
  if (this->Preview && this->Preview->IsClosing())
  {
    this->Preview.reset();
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

bool Wall::SetFullScreen(bool on)
{
  if (on && this->IsSeveral() &&
    static_cast<std::size_t>(GlfwWindow::CountMonitors()) < this->Panes.size())
  {
    return false;
  }
  for (const Pane& pane : this->Panes)
  {
    pane.Window->SetFullScreen(on);
  }
  return true;
}

// Of several windows each has its monitor already.
void Wall::NextMonitor()
{
  if (!this->IsSeveral())
  {
    this->Panes[0].Window->NextMonitor();
  }
}

void Wall::SetPointerShown(bool shown)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Window->SetPointerShown(shown);
  }
}

Place Wall::GetCursor() const
{
  const std::array<double, 2> at = this->Panes[0].Window->GetCursor();
  return { 0, this->ToPart(this->Panes[0], at[0], at[1]) };
}

std::array<int, 2> Wall::GetSize(std::size_t part) const
{
  for (const Pane& pane : this->Panes)
  {
    const std::array<int, 2> own = pane.Window->GetSize();
    if (pane.Part == part && IsVisible(own))
    {
      return { { own[0] * this->Columns, own[1] * this->Rows } };
    }
  }
  return { { 0, 0 } };
}

std::array<int, 2> Wall::GetSize() const
{
  std::array<int, 2> all{ { 0, 0 } };
  for (std::size_t part = 0; !this->Panes.empty() && part <= this->Panes.back().Part; part++)
  {
    const std::array<int, 2> size = this->GetSize(part);
    all = { { all[0] + size[0], std::max(all[1], size[1]) } };
  }
  return all;
}

bool Wall::IsWithinLimits() const
{
  return std::all_of(this->Panes.begin(), this->Panes.end(), [](const Pane& pane) {
    const std::array<int, 2> size = pane.Window->GetSize();
    const std::array<int, 2> limits = pane.Stage->GetLimits();
    return size[0] <= limits[0] && size[1] <= limits[1];
  });
}

FrameCost Wall::SumOfCosts() const
{
  std::optional<FrameCost> sum;
  for (const Pane& pane : this->Panes)
  {
    if (pane.Cost)
    {
      sum = sum ? *sum + *pane.Cost : *pane.Cost;
    }
  }
  return sum.value_or(FrameCost());
}

// The window under the pointer first, for it finds where the crosshair is in all of them; the one
// with the text last, which tells what all of them took.
std::vector<std::size_t> Wall::OrderFrom(std::size_t first) const
{
  std::vector<std::size_t> order;
  for (std::size_t i = this->Panes.size(); i > 0; i--)
  {
    order.push_back(i - 1);
  }
  const auto found = std::find(order.begin(), order.end(), first);
  std::rotate(order.begin(), found, found == order.end() ? found : found + 1);
  return order;
}

FrameCost Wall::DrawPane(
  std::size_t i, const Options& part, const Extras& extras, const Place& under)
{
  Pane& pane = this->Panes[i];
  const bool first = i == 0;
  pane.Window->CheckAlive(); // its context is to become current
  if (extras.Cross != nullptr)
  {
    extras.Cross->Pointer = i == under.Part ? std::optional(under.At) : std::nullopt;
  }
  const auto total = [&](const FrameCost& cost) {
    pane.Cost = cost;
    return extras.Text(this->SumOfCosts());
  };
  const std::function<std::string(const FrameCost&)> text =
    first && extras.Text && !this->Preview ? total : std::function<std::string(const FrameCost&)>();
  return pane.Stage->Draw(
    part, pane.Window->GetSize(), text, first ? extras.Help : "", extras.Cross);
}

FrameCost Wall::Draw(const std::vector<Options>& parts, const Extras& extras)
{
  // one that goes while it is drawn to, after CheckAlive, may crash Mesa
  const CrashGuard guard("a picture could not be drawn: the window was destroyed by another "
                         "program, or drawing crashed; start again");
  const Place nowhere{ this->Panes.size(), {} };
  const Place under = this->FindPane(extras.Pointer).value_or(nowhere);
  for (const std::size_t i : this->OrderFrom(extras.Cross != nullptr ? under.Part : nowhere.Part))
  {
    Pane& pane = this->Panes[i];
    const bool visible = IsVisible(pane.Window->GetSize());
    pane.Cost.reset();
    if (visible)
    {
      pane.Cost = this->DrawPane(i, parts[pane.Part], extras, under);
    }
  }
  this->DrawPreview(parts);
  this->DrawOver(extras.Over);
  for (const Pane& pane : this->Panes)
  {
    pane.Window->Show();
  }
  return this->SumOfCosts();
}

void Wall::SetUpdateRate(double rate)
{
  for (const Pane& pane : this->Panes)
  {
    pane.Stage->SetUpdateRate(rate);
  }
}

bool Wall::Flip(Panel* over)
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
  this->DrawOver(flipped ? over : nullptr);
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

Picture Wall::Take(const std::vector<Options>& parts)
{
  const std::array<int, 2> size = this->GetSize();
  Picture whole;
  whole.Width = size[0];
  whole.Height = size[1];
  whole.Rgb.resize(3 * static_cast<std::size_t>(whole.Width) * whole.Height);
  int left = 0;
  for (const Pane& pane : this->Panes)
  {
    const std::array<int, 2> all = this->GetSize(pane.Part);
    if (IsVisible(all))
    {
      const int width = all[0] / this->Columns;
      const int height = all[1] / this->Rows;
      const int column = this->IsTiled() ? pane.Where.Column * width : left;
      Insert(pane.Stage->Take(parts[pane.Part], { { width, height } }), column,
        pane.Where.Row * height, whole);
      left += width;
    }
  }
  return whole;
}
}
