// SPDX-License-Identifier: BSD-3-Clause
// What a picture is made with, by what it is for: one table, which programs, windows and documents
// read.
#ifndef WideFoVPresets_h
#define WideFoVPresets_h

#include "Projections/Projection.h"

#include <array>
#include <string>
#include <vector>

namespace wfv
{
// A kind of picture. Angles in degrees.
struct Preset
{
  std::string Name;      // as on the command line
  std::string Title;     // for people
  std::string ViewTitle; // in a window whose size is its own; empty: not offered there

  std::string Projection;
  double HorizontalFov = 360;          // of round maps the one across
  double VerticalFov = 180;            // of round maps the same
  double Tilt = 0;                     // how far the axis is raised
  std::array<int, 2> Size{ { 0, 0 } }; // of the picture of one eye, pixels

  bool TwoEyes = false; // by the usual model of the projection
  std::string Layout;   // where the eyes go, as on the command line

  std::string Codec; // of films: x264, x265, vp9, prores; empty: for single pictures

  // Latitudes: where a picture shows what is overhead, the eyes' distance goes before they swirl.
  std::array<double, 2> PoleFade{ { 60, 85 } };
};

// All of them, those of one kind beside each other.
WFV_EXPORT const std::vector<Preset>& Presets();

// The preset of that name, or nullptr.
WFV_EXPORT const Preset* FindPreset(const std::string& name);
}

#endif
