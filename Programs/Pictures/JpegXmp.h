// SPDX-License-Identifier: BSD-3-Clause
// Metadata of JPEG files beyond what OpenImageIO writes: XMP packets, their extension for what
// is longer than a segment, and VR180 photos, which carry the other eye's picture in it.
// Sources: Adobe XMP part 3; Google's VR photo format.
#ifndef WideFoVJpegXmp_h
#define WideFoVJpegXmp_h

#include "Picture.h"

#include <string>
#include <vector>

namespace widefov
{
// Inserts a packet behind the first segment of a JPEG file, and its extension (empty: none)
// behind it. A packet that is there already is taken away. Throws a Failure with ExitFailed
// where these bytes are no JPEG, or the packet is longer than a segment.
void InsertJpegXmp(
  std::vector<unsigned char>& jpeg, const std::string& xmp, const std::string& extension);

// The extension that holds the right eye's file.
std::string Vr180Extension(const std::vector<unsigned char>& right);

// The packet of the left eye's picture of that many pixels, which refers to the extension.
std::string Vr180Xmp(int width, int height, const PanoramaInfo& info, const std::string& extension);
}

#endif
