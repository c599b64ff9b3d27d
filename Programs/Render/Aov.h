// SPDX-License-Identifier: BSD-3-Clause
// What a picture is made of, as channels of a file.
#ifndef WideFoVAov_h
#define WideFoVAov_h

#include "vtkWideFoVAbi.h"

#include "Pictures/ImageOutput.h"
#include "Scenes/Scene.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Names of the channels, in their order.
const std::vector<std::string>& AovChannels();

// What vtkWideFoVDataPass gave, from the top. Props, which are actors there, become files of the
// scene.
FloatPicture FlattenAov(vtkImageData* image, const Scene& scene);

// Columns of one row of tiles, from column `at` on, into a band of the picture.
void CopyBeside(const FloatPicture& tile, int at, FloatPicture& band);
}

#endif
