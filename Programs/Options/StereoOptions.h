// SPDX-License-Identifier: BSD-3-Clause
// The stereo options of the command line.
#ifndef WideFoVStereoOptions_h
#define WideFoVStereoOptions_h

#include "vtkWideFoVAbi.h"

#include "OptionGroup.h"
#include "Pictures/ImageOutput.h"
#include "Options.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
void DeclareStereo(CLI::App& app, Options& options);

// After the projection is known and before wfv::CheckOptions: sets the model. Throws a Failure
// with ExitUsage where an option is given that the model does not have.
void CompleteStereo(Options& options);

// After everything is known.
void CheckStereo(const Options& options);

// The same, of what is written to files.
void CheckFiles(const Options& options);

// Colours of light; a mask of vtkRenderWindow is one more than the index.
const std::vector<std::string>& AnaglyphColors();

// How the window shows the layout anaglyph.
void SetAnaglyph(vtkRenderWindow* window, const Options& options);

// Adds the floating window and the letterbox that the options ask for.
void AddStereoWindow(vtkRenderer* renderer, const Options& options);

// The files that an output file becomes: two where each eye has its own.
std::vector<std::string> FilesOf(const Options& options, const std::string& output);

// Can both eyes be drawn in tiles? Not where each has half of the window, or both go into one file
// apart, nor where pairs of rows become one and the topmost tiles have an odd number of them.
bool EyesFitTiles(const Options& options);

// What viewers of panoramas may know of these pictures.
PanoramaInfo DescribePanorama(const Options& options);
}

#endif
