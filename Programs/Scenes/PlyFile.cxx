// SPDX-License-Identifier: BSD-3-Clause
// The Polygon File Format: a header of lines, then the elements it names one after another, as
// words or as numbers in binary.
#include "PlyFile.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace widefov
{
namespace ply
{
namespace
{
constexpr std::size_t LongestQuote = 40; // letters of a message

struct Broken : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Type
{
  int Size = 0; // bytes
  bool Counts = false;
  bool Signed = false;
};

struct Property
{
  std::string Name;
  bool IsList = false;
  Type Count; // of a list
  Type Value;
};

struct Element
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<Property> Properties;
};

Type FindType(const std::string& name)
{
  static const std::map<std::string, Type> types{ { "char", { 1, true, true } },
    { "int8", { 1, true, true } }, { "uchar", { 1, true, false } }, { "uint8", { 1, true, false } },
    { "short", { 2, true, true } }, { "int16", { 2, true, true } },
    { "ushort", { 2, true, false } }, { "uint16", { 2, true, false } },
    { "int", { 4, true, true } }, { "int32", { 4, true, true } }, { "uint", { 4, true, false } },
    { "uint32", { 4, true, false } }, { "float", { 4, false, true } },
    { "float32", { 4, false, true } }, { "double", { 8, false, true } },
    { "float64", { 8, false, true } } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw Broken("its header has the unknown type '" + name.substr(0, LongestQuote) + "'");
  }
  return found->second;
}

Property ParseProperty(std::istringstream& words)
{
  Property property;
  std::string type;
  words >> type;
  property.IsList = type == "list";
  if (property.IsList)
  {
    std::string count;
    words >> count >> type;
    property.Count = FindType(count);
    if (!property.Count.Counts)
    {
      throw Broken("its header has a list whose length is no whole number");
    }
  }
  property.Value = FindType(type);
  words >> property.Name;
  return property;
}

class File
{
public:
  explicit File(const std::string& path)
    : Stream(path, std::ios::binary)
  {
  }

  void ReadHeader()
  {
    std::string line;
    std::getline(this->Stream, line);
    if (line != "ply" && line != "ply\r")
    {
      throw Broken("it does not begin with the line ply");
    }
    while (std::getline(this->Stream, line))
    {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == "end_header")
      {
        this->CheckVertices();
        return;
      }
      this->ReadHeaderLine(key, words);
    }
    throw Broken("it ends within its header");
  }

  void PassElements()
  {
    for (const Element& element : this->Elements)
    {
      // (elements without properties take no place, however many there are)
      const std::uint64_t count = element.Properties.empty() ? 0 : element.Count;
      for (std::uint64_t i = 0; i < count; i++)
      {
        if (!this->Pass(element))
        {
          throw Broken("it announces " + std::to_string(element.Count) + " of " + element.Name +
            ", but only the first " + std::to_string(i) + " are whole");
        }
      }
    }
  }

private:
  void ReadHeaderLine(const std::string& key, std::istringstream& words)
  {
    if (key == "format")
    {
      std::string format;
      words >> format;
      this->IsText = format == "ascii";
      this->IsBigEndian = format == "binary_big_endian";
      if (!this->IsText && !this->IsBigEndian && format != "binary_little_endian")
      {
        throw Broken("its header has the unknown format '" + format.substr(0, LongestQuote) + "'");
      }
    }
    else if (key == "element")
    {
      Element element;
      if (!(words >> element.Name >> element.Count))
      {
        throw Broken("its header has an element without a count");
      }
      this->Elements.push_back(element);
    }
    else if (key == "property")
    {
      if (this->Elements.empty())
      {
        throw Broken("its header has a property of no element");
      }
      this->Elements.back().Properties.push_back(ParseProperty(words));
    }
  }

  void CheckVertices() const
  {
    std::string names;
    for (const Element& element : this->Elements)
    {
      for (const Property& property : element.Properties)
      {
        names += element.Name == "vertex" ? property.Name + " " : "";
      }
    }
    const std::string all = " " + names;
    for (const char* const axis : { " x ", " y ", " z " })
    {
      if (all.find(axis) == std::string::npos)
      {
        throw Broken("its vertices have no x, y and z");
      }
    }
  }

  // The rest of these return false where the file ends too early, or where a list has no length.

  bool Pass(const Element& element)
  {
    for (const Property& property : element.Properties)
    {
      std::uint64_t values = 1;
      if (property.IsList && !this->ReadCount(property.Count, values))
      {
        return false;
      }
      const auto size = static_cast<std::uint64_t>(property.Value.Size);
      if (!(this->IsText ? this->SkipWords(values) : this->SkipBytes(values * size)))
      {
        return false;
      }
    }
    return true;
  }

  bool ReadCount(const Type& type, std::uint64_t& count)
  {
    if (this->IsText)
    {
      return static_cast<bool>(this->Stream >> count);
    }
    unsigned char bytes[8] = {};
    if (!this->Stream.read(reinterpret_cast<char*>(bytes), type.Size))
    {
      return false;
    }
    count = 0;
    for (int i = 0; i < type.Size; i++)
    {
      count = count << 8 | bytes[this->IsBigEndian ? i : type.Size - 1 - i];
    }
    return !type.Signed || count >> (8 * type.Size - 1) == 0;
  }

  bool SkipWords(std::uint64_t words)
  {
    for (std::uint64_t i = 0; i < words; i++)
    {
      if (!(this->Stream >> this->Word) ||
        std::string("0123456789+-.nNiI").find(this->Word[0]) == std::string::npos)
      {
        return false;
      }
    }
    return true;
  }

  bool SkipBytes(std::uint64_t bytes)
  {
    this->Stream.ignore(static_cast<std::streamsize>(bytes));
    return static_cast<std::uint64_t>(this->Stream.gcount()) == bytes;
  }

  std::ifstream Stream;
  std::string Word; // the last that was passed
  bool IsText = true;
  bool IsBigEndian = false;
  std::vector<Element> Elements;
};
}
}

std::string DamagedPly(const std::string& path)
{
  try
  {
    ply::File file(path);
    file.ReadHeader();
    file.PassElements();
  }
  catch (const ply::Broken& broken)
  {
    return broken.what();
  }
  return "";
}
}
