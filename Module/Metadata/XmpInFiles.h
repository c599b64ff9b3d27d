// SPDX-License-Identifier: BSD-3-Clause
// XMP packets in the bytes of PNG and JPEG files.
#ifndef WideFoVMetadataXmpInFiles_h
#define WideFoVMetadataXmpInFiles_h

#include <cstddef>
#include <string>
#include <vector>

namespace wfvxmp
{
using Bytes = std::vector<unsigned char>;

// A packet as a PNG's chunk iTXt "XML:com.adobe.xmp".
Bytes PngChunk(const std::string& xmp);

// Bytes of a PNG's signature and of its header, behind which chunks may be inserted.
constexpr std::size_t PngHeaderEnd = 8 + 4 + 4 + 13 + 4;

// Inserts a chunk behind the header. False, and no change, where these are no PNG.
bool InsertInPng(Bytes& png, const Bytes& chunk);

// Begins the data of the segment that holds a packet.
extern const std::string JpegPacketName;

// A number of so many bytes, the highest first.
std::string BigEndian(std::size_t value, int bytes);

// An application segment of number 1, which XMP shares with EXIF; empty where the data are too
// long for one.
std::string JpegSegment(const std::string& data);

// Inserts segments behind the first one of the file, which stays the first, and takes away packets
// that the encoder wrote. False, and no change, where these are no JPEG.
bool InsertInJpeg(Bytes& jpeg, const std::string& segments);
}

#endif
