// SPDX-License-Identifier: BSD-3-Clause
// Puts the pictures of the two eyes into one.
#ifndef WideFoVEyePictures_h
#define WideFoVEyePictures_h

#include "Options/StereoLayout.h"
#include "Picture.h"

#include <vector>

namespace widefov
{
// The pictures to write, from those drawn with each of the types of the layout.
std::vector<Picture> Arrange(const StereoLayout& layout, const std::vector<Picture>& eyes);

// Two pictures of one size, the first on the left or above.
Picture Join(const Picture& first, const Picture& second, bool below);

// Half as wide or half as high: the mean of two pixels each; an odd last one is its own mean.
Picture Halve(const Picture& picture, bool height);
}

#endif
