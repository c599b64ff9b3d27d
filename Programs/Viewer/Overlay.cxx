// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include <vtkTextProperty.h>

#include <algorithm>

namespace widefov
{
namespace
{
constexpr int TextSize = 14; // points
constexpr int SmallestTextSize = 5;
constexpr double LineSpacing = 1.2;  // lines a text size
constexpr int Margin = 8;            // pixels
constexpr double LargestShare = 0.3; // of the height, of the text in the corner

// That of letters, for text that fits into so many pixels; points.
int SizeOf(const std::string& text, double width, double height)
{
  int lines = 1;
  int longest = 0;
  int length = 0;
  for (const char c : text)
  {
    lines += c == '\n';
    length = c == '\n' ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  // a letter of this family is about two thirds as wide as its size in points
  const double tall = height / (LineSpacing * lines);
  const double wide = width * 1.5 / std::max(1, longest);
  return std::clamp(static_cast<int>(std::min(tall, wide)), SmallestTextSize, TextSize);
}

void SetLook(vtkTextProperty* look, double opacity)
{
  look->SetFontFamilyToCourier();
  look->SetFontSize(TextSize);
  look->SetBold(true);
  look->SetColor(1, 1, 1);
  look->SetBackgroundColor(0, 0, 0);
  look->SetBackgroundOpacity(opacity);
}
}

Overlay::Overlay()
{
  this->Renderer->SetLayer(2);
  this->Renderer->InteractiveOff();
  SetLook(this->Text->GetTextProperty(), 0.5);
  this->Text->GetTextProperty()->SetVerticalJustificationToTop();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Text->SetPosition(0.01, 0.99);
  SetLook(this->Help->GetTextProperty(), 0.8);
  this->Help->GetTextProperty()->SetJustificationToCentered();
  this->Help->GetTextProperty()->SetVerticalJustificationToCentered();
  this->Help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Help->SetPosition(0.5, 0.5);
  this->Renderer->AddViewProp(this->Text);
  this->Renderer->AddViewProp(this->Help);
}

void Overlay::SetText(const std::string& text, int width, int height)
{
  this->Text->SetVisibility(!text.empty());
  if (!text.empty())
  {
    const double share = LargestShare * height;
    this->Text->GetTextProperty()->SetFontSize(SizeOf(text, width - 2 * Margin, share));
    this->Text->SetInput(text.c_str());
  }
}

void Overlay::SetHelp(const std::string& text, int width, int height)
{
  this->Help->SetVisibility(!text.empty());
  if (!text.empty())
  {
    this->Help->GetTextProperty()->SetFontSize(
      SizeOf(text, width - 2 * Margin, height - 2 * Margin));
    this->Help->SetInput(text.c_str());
  }
}
}
