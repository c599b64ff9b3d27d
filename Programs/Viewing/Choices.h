// SPDX-License-Identifier: BSD-3-Clause
// Going through projections and techniques.
#ifndef WideFoVChoices_h
#define WideFoVChoices_h

#include "Fields.h"
#include "Options/Options.h"
#include "Presets/Presets.h"
#include "Scenes/Scene.h"

#include <string>
#include <vector>

namespace widefov
{
// Can this be drawn over several windows? Stock VTK's views know nothing of tiles.
bool CanBeTiled(const Options& options);

// Why these options cannot be drawn, or an empty text: widefov-render's own rules. `tiled`:
// over several windows.
std::string WhyNot(const Options& options, bool tiled = false);

// What there is to choose from.
std::vector<std::string> StereoNames();

// Takes the projection of that name. What goes with some projections only (the cubemap, the
// debug view, a depth mapping) is given up where it must be. False, and nothing changes, where
// the view cannot be drawn so.
bool SetProjection(
  Options& options, const Fields& fields, const std::string& name, bool tiled = false);

// The same of a technique, of a stereo model, and of the numbers of the view.
bool SetTechnique(Options& options, const std::string& name, bool tiled = false);
bool SetStereo(Options& options, const std::string& name, bool tiled = false);
bool SetView(Options& options, const wfv::ViewOptions& view, bool tiled = false);

// Takes projection, fields of view, tilt and eyes of a preset; their distance is fitted to the
// scene. The size stays.
bool SetPreset(Options& options, Fields& fields, const wfv::Preset& preset, const Scene& scene,
  bool tiled = false);

// Takes the next (step 1) or the previous (-1) projection.
void StepProjection(Options& options, const Fields& fields, int step, bool tiled = false);

// Takes the next technique that can draw the view. False where there is no other.
bool StepTechnique(Options& options, int step, bool tiled = false);

// Another stereo model, and another place for the eyes that one traversal of VTK's can draw.
// False where there is none.
bool StepStereo(Options& options, int step, bool tiled = false);
bool StepLayout(Options& options, int step);

// True where a window can show the eyes so: several pictures are for files.
bool FitsWindow(const Options& options);

// True where a window shows one eye after the other.
bool ShowsEyesInTurn(const Options& options);

// False, and nothing changes, where the view cannot be drawn so.
bool SetDebugView(Options& options, bool on);

// After a change of the view: the technique auto where the present one cannot draw it any
// more. True where that happened.
bool GiveUpTechnique(Options& options);
}

#endif
