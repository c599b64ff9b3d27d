// SPDX-License-Identifier: BSD-3-Clause
// The boxes of MP4 and QuickTime files (ISO/IEC 14496-12): their tree, and files with another one.
#ifndef WideFoVMp4Boxes_h
#define WideFoVMp4Boxes_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace widefov
{
// A box of boxes has fields before them; any other has nothing but its fields.
struct Mp4Box
{
  std::string Type; // four characters
  std::string Fields;
  std::vector<Mp4Box> Children;

  // The first one of that type; nullptr where there is none.
  Mp4Box* Find(const std::string& type);
};

// A number of so many bytes, the highest first.
std::string Mp4Number(std::uint64_t value, int bytes);

// Those that the bytes hold one after the other. Throws a Failure with ExitFailed where they end in
// the middle of one.
std::vector<Mp4Box> ParseBoxes(const std::string& bytes);

std::string BoxBytes(const Mp4Box& box);

// The sample entry of the video track, whose fields are all that is in it, and the track; nullptr
// where there is none.
struct VideoTrack
{
  Mp4Box* Track = nullptr;
  Mp4Box* Entry = nullptr;
};
VideoTrack FindVideoTrack(Mp4Box& movie);

// Reads a file of boxes, lets `edit` change its movie box, and writes all bytes with that box in
// front, so that players may begin before the file's end has come. Throws a Failure with ExitFailed
// where the file is not what ffmpeg writes; whatever `write` throws goes through.
using WriteBytes = std::function<void(const char* bytes, std::size_t count)>;
void RewriteMovie(
  const std::string& path, const std::function<void(Mp4Box& movie)>& edit, const WriteBytes& write);
}

#endif
