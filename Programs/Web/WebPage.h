// SPDX-License-Identifier: BSD-3-Clause
// Web pages that turn a panorama or a film: Documentation/web.md.
#ifndef WideFoVWebPage_h
#define WideFoVWebPage_h

#include "Options/Options.h"
#include "Pictures/Picture.h"
#include "Scenes/Scene.h"

#include <vector>

namespace widefov
{
// Before drawing: throws a Failure with ExitFailed if there can be no page in the folder.
void CheckWebPage(const Options& options);

// Writes a page of the picture of each eye. Throws a Failure with ExitFailed.
void WritePicturePage(const Options& options, const Scene& scene, const std::vector<Picture>& eyes);

// Writes a page of a film that is in the folder. A film that is not whole gets none.
void WriteFilmPage(const Options& options, const Scene& scene);
}

#endif
