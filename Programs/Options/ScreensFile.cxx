// SPDX-License-Identifier: BSD-3-Clause
#include "ScreensFile.h"

#include "System/MessageCatcher.h"
#include "System/SmallFile.h"
#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace widefov
{
namespace
{
const char* const Advice = "give a screens file as ParaView's .pvx";

// The numbers of an attribute, all of it; empty where it is something else.
std::vector<double> Numbers(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<double> numbers;
  double number = 0;
  while (stream >> number)
  {
    numbers.push_back(number);
  }
  return stream.eof() ? numbers : std::vector<double>();
}

wfv::vec3 Corner(const std::string& where, vtkXMLDataElement* machine, const char* name)
{
  const char* const text = machine->GetAttribute(name);
  if (text == nullptr)
  {
    Fail(where + " has no " + name + "; give it all three corners of its screen");
  }
  const std::vector<double> v = Numbers(text);
  if (v.size() != 3)
  {
    Fail(where + ": " + name + "=\"" + OneLine(text) + "\" is not three numbers; correct it");
  }
  return { v[0], v[1], v[2] };
}

wfv::Screen Corners(const std::string& where, vtkXMLDataElement* machine)
{
  wfv::Screen screen;
  screen.LowerLeft = Corner(where, machine, "LowerLeft");
  screen.LowerRight = Corner(where, machine, "LowerRight");
  // files of ParaView before 3.10 name the other upper corner
  const bool old =
    machine->GetAttribute("UpperRight") == nullptr && machine->GetAttribute("UpperLeft") != nullptr;
  screen.UpperRight = old
    ? Corner(where, machine, "UpperLeft") + screen.LowerRight - screen.LowerLeft
    : Corner(where, machine, "UpperRight");
  const std::string problem = wfv::CheckScreen(screen);
  if (!problem.empty())
  {
    Fail(where + ": " + problem + "; correct it");
  }
  return screen;
}

// Geometry="WxH+X+Y": where its window is.
std::array<int, 2> WindowSize(const std::string& where, vtkXMLDataElement* machine)
{
  const char* const text = machine->GetAttribute("Geometry");
  if (text == nullptr)
  {
    return { { 0, 0 } };
  }
  std::array<int, 2> size{ { 0, 0 } };
  if (std::sscanf(text, "%dx%d", &size[0], &size[1]) != 2 || size[0] < 1 || size[1] < 1)
  {
    Fail(where + ": Geometry=\"" + OneLine(text) + "\" is not WIDTHxHEIGHT+X+Y; correct it");
  }
  return size;
}

// Fit for a file's name, and unlike the others'.
std::string UniqueName(const char* given, const std::vector<NamedScreen>& others)
{
  std::string name = given ? given : "";
  std::replace_if(
    name.begin(), name.end(),
    [](unsigned char c) { return c < 128 && !std::isalnum(c) && c != '-' && c != '_' && c != '.'; },
    '_');
  name = name.empty() ? "screen" : name;
  std::string unique = name;
  const auto taken = [&](const NamedScreen& other) { return other.Name == unique; };
  for (int i = 2; std::any_of(others.begin(), others.end(), taken); i++)
  {
    unique = name + "-" + std::to_string(i);
  }
  return unique;
}

bool Draws(vtkXMLDataElement* process)
{
  const char* const type = process->GetAttribute("Type");
  return type == nullptr || std::string(type) == "server" || std::string(type) == "renderserver";
}

void AddMachine(const std::string& path, vtkXMLDataElement* machine, ScreensFile& file)
{
  const char* const name = machine->GetAttribute("Name");
  const std::string where = path + ", machine " + std::to_string(file.Screens.size() + 1) +
    (name ? " (" + OneLine(name) + ")" : "");
  NamedScreen screen;
  screen.Corners = Corners(where, machine);
  screen.Size = WindowSize(where, machine);
  screen.Name = UniqueName(name, file.Screens);
  file.Screens.push_back(screen);
}

void AddElements(const std::string& path, vtkXMLDataElement* parent, ScreensFile& file)
{
  for (int i = 0; i < parent->GetNumberOfNestedElements(); i++)
  {
    vtkXMLDataElement* const element = parent->GetNestedElement(i);
    const std::string kind = element->GetName();
    if (kind == "Process" && Draws(element))
    {
      AddElements(path, element, file);
    }
    else if (kind == "Machine")
    {
      AddMachine(path, element, file);
    }
    else if (kind == "EyeSeparation")
    {
      const char* const value = element->GetAttribute("Value");
      const std::vector<double> v = Numbers(value ? value : "");
      if (v.size() != 1 || !(v[0] >= 0) || !std::isfinite(v[0]))
      {
        Fail(path + ": EyeSeparation needs a Value of at least 0; correct it");
      }
      file.EyeSeparation = v[0];
    }
  }
}
}

ScreensFile ReadScreens(const std::string& path)
{
  std::istringstream text(ReadSmallFile(path, Advice));
  MessageCatcher::TakeFirstError();
  vtkNew<vtkXMLDataParser> parser;
  parser->SetStream(&text);
  const bool parsed = parser->Parse() != 0;
  const std::string error = MessageCatcher::TakeFirstError();
  vtkXMLDataElement* const root = parsed ? parser->GetRootElement() : nullptr;
  if (root == nullptr)
  {
    Fail(path + " is no XML" + (error.empty() ? "" : " (" + error + ")") + "; " + Advice);
  }
  if (std::string(root->GetName()) != "pvx")
  {
    Fail(path + " is not pvx, but '" + OneLine(root->GetName()) + "'; " + Advice);
  }
  ScreensFile file;
  AddElements(path, root, file);
  if (file.Screens.empty())
  {
    Fail(path + " has no screen: no Machine of a Process that draws; add one");
  }
  return file;
}
}
