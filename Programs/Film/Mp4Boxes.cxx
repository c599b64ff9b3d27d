// SPDX-License-Identifier: BSD-3-Clause
#include "Mp4Boxes.h"

#include "Text/Messages.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>

namespace widefov
{
namespace
{
constexpr std::size_t HeaderBytes = 8;
constexpr std::size_t LongHeaderBytes = 16; // of a box over 4 GiB

[[noreturn]] void FailBoxes()
{
  Fail("the film that ffmpeg wrote is no MP4 file that can be tagged; choose another ending");
}

std::uint64_t NumberAt(const std::string& bytes, std::size_t at, int count)
{
  if (at + count > bytes.size())
  {
    FailBoxes();
  }
  std::uint64_t value = 0;
  for (int i = 0; i < count; i++)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

// How many bytes of fields are before a box's children; none: it has none, or they are of no use.
const std::size_t* FieldsBefore(const std::string& type)
{
  static const std::map<std::string, std::size_t> known{ { "moov", 0 }, { "trak", 0 },
    { "mdia", 0 }, { "minf", 0 }, { "stbl", 0 }, { "stsd", 8 } };
  const auto found = known.find(type);
  return found == known.end() ? nullptr : &found->second;
}

// The entries of a table of chunks' places.
std::vector<std::uint64_t> ReadPlaces(const Mp4Box& table)
{
  const int bytes = table.Type == "co64" ? 8 : 4;
  std::vector<std::uint64_t> places(NumberAt(table.Fields, 4, 4));
  for (std::size_t i = 0; i < places.size(); i++)
  {
    places[i] = NumberAt(table.Fields, 8 + i * bytes, bytes);
  }
  return places;
}

void WritePlaces(Mp4Box& table, const std::vector<std::uint64_t>& places)
{
  const int bytes = table.Type == "co64" ? 8 : 4;
  table.Fields = table.Fields.substr(0, 4) + Mp4Number(places.size(), 4);
  for (const std::uint64_t place : places)
  {
    table.Fields += Mp4Number(place, bytes);
  }
}

void CollectTables(Mp4Box& box, std::vector<Mp4Box*>& tables)
{
  if (box.Type == "stco" || box.Type == "co64")
  {
    tables.push_back(&box);
  }
  for (Mp4Box& child : box.Children)
  {
    CollectTables(child, tables);
  }
}

std::uint64_t Largest(const std::vector<Mp4Box*>& tables)
{
  std::uint64_t largest = 0;
  for (const Mp4Box* const table : tables)
  {
    for (const std::uint64_t place : ReadPlaces(*table))
    {
      largest = std::max(largest, place);
    }
  }
  return largest;
}

// With the movie in front of all that was before it, which moves by its size.
void MoveChunks(Mp4Box& movie)
{
  std::vector<Mp4Box*> tables;
  CollectTables(movie, tables);
  const std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  // tables of 64 bits take twice the room
  if (Largest(tables) + 2 * BoxBytes(movie).size() > most)
  {
    for (Mp4Box* const table : tables)
    {
      const std::vector<std::uint64_t> places = ReadPlaces(*table);
      table->Type = "co64";
      WritePlaces(*table, places);
    }
  }
  const std::uint64_t shift = BoxBytes(movie).size();
  for (Mp4Box* const table : tables)
  {
    std::vector<std::uint64_t> places = ReadPlaces(*table);
    for (std::uint64_t& place : places)
    {
      place += shift;
    }
    WritePlaces(*table, places);
  }
}

// A box of the file itself.
struct BoxPlace
{
  std::string Type;
  std::uint64_t Begin = 0;
  std::uint64_t Size = 0;
};

std::string ReadPart(std::ifstream& file, std::uint64_t begin, std::uint64_t size)
{
  std::string bytes(size, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(begin));
  file.read(&bytes[0], static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  return bytes;
}

std::vector<BoxPlace> PlacesOf(std::ifstream& file)
{
  file.seekg(0, std::ios::end);
  const auto end = static_cast<std::uint64_t>(file.tellg());
  std::vector<BoxPlace> places;
  for (std::uint64_t at = 0; at < end;)
  {
    const std::string header = ReadPart(file, at, LongHeaderBytes);
    std::uint64_t size = NumberAt(header, 0, 4);
    size = size == 1 ? NumberAt(header, HeaderBytes, 8) : size == 0 ? end - at : size;
    if (size < HeaderBytes || size > end - at)
    {
      FailBoxes();
    }
    places.push_back({ header.substr(4, 4), at, size });
    at += size;
  }
  return places;
}

void CopyPart(std::ifstream& file, const BoxPlace& place, const WriteBytes& write)
{
  constexpr std::uint64_t Block = 1 << 20;
  for (std::uint64_t done = 0; done < place.Size;)
  {
    const std::string bytes =
      ReadPart(file, place.Begin + done, std::min(Block, place.Size - done));
    if (bytes.empty())
    {
      FailBoxes();
    }
    write(bytes.data(), bytes.size());
    done += bytes.size();
  }
}
}

Mp4Box* Mp4Box::Find(const std::string& type)
{
  const auto found = std::find_if(this->Children.begin(), this->Children.end(),
    [&type](const Mp4Box& child) { return child.Type == type; });
  return found == this->Children.end() ? nullptr : &*found;
}

std::string Mp4Number(std::uint64_t value, int bytes)
{
  std::string text;
  for (int i = bytes - 1; i >= 0; i--)
  {
    text.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
  }
  return text;
}

std::vector<Mp4Box> ParseBoxes(const std::string& bytes)
{
  std::vector<Mp4Box> boxes;
  std::size_t at = 0;
  for (; at + HeaderBytes <= bytes.size();)
  {
    const std::uint64_t size = NumberAt(bytes, at, 4);
    if (size < HeaderBytes || size > bytes.size() - at)
    {
      FailBoxes();
    }
    Mp4Box box;
    box.Type = bytes.substr(at + 4, 4);
    const std::string inside = bytes.substr(at + HeaderBytes, size - HeaderBytes);
    const std::size_t* const before = FieldsBefore(box.Type);
    box.Fields = inside.substr(0, before != nullptr ? *before : std::string::npos);
    if (before != nullptr && inside.size() > *before)
    {
      box.Children = ParseBoxes(inside.substr(*before));
    }
    boxes.push_back(box);
    at += size;
  }
  // QuickTime ends some lists by a number 0
  if (bytes.find_first_not_of('\0', at) != std::string::npos)
  {
    FailBoxes();
  }
  return boxes;
}

std::string BoxBytes(const Mp4Box& box)
{
  std::string inside = box.Fields;
  for (const Mp4Box& child : box.Children)
  {
    inside += BoxBytes(child);
  }
  return Mp4Number(inside.size() + HeaderBytes, 4) + box.Type + inside;
}

VideoTrack FindVideoTrack(Mp4Box& movie)
{
  for (Mp4Box& track : movie.Children)
  {
    Mp4Box* const media = track.Find("mdia");
    Mp4Box* const handler = media != nullptr ? media->Find("hdlr") : nullptr;
    if (handler == nullptr || handler->Fields.substr(8, 4) != "vide")
    {
      continue;
    }
    Mp4Box* box = media;
    for (const char* const type : { "minf", "stbl", "stsd" })
    {
      box = box != nullptr ? box->Find(type) : nullptr;
    }
    if (box != nullptr && !box->Children.empty())
    {
      return { &track, &box->Children.front() };
    }
  }
  return {};
}

void RewriteMovie(
  const std::string& path, const std::function<void(Mp4Box& movie)>& edit, const WriteBytes& write)
{
  std::ifstream file(path, std::ios::binary);
  const std::vector<BoxPlace> places = PlacesOf(file);
  // ffmpeg writes it last, for it is known last; so everything before it moves by its size
  if (places.size() < 2 || places.back().Type != "moov" || places.front().Type != "ftyp")
  {
    FailBoxes();
  }
  const std::string bytes = ReadPart(file, places.back().Begin, places.back().Size);
  Mp4Box movie = ParseBoxes(bytes).front();
  edit(movie);
  MoveChunks(movie);
  CopyPart(file, places.front(), write);
  const std::string moved = BoxBytes(movie);
  write(moved.data(), moved.size());
  for (std::size_t i = 1; i + 1 < places.size(); i++)
  {
    CopyPart(file, places[i], write);
  }
}
}
