// SPDX-License-Identifier: BSD-3-Clause
// Writes the server manager XML of the view: the template with what the registries of
// projections, stereo models and techniques know put in.
//
//   widefov-view-xml TEMPLATE OUTPUT
#include "Frame/Technique.h"
#include "Projections/Projection.h"
#include "Stereo/Stereo.h"

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

namespace
{
std::string Escape(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return escaped;
}

std::string Choice(const std::string& name)
{
  return "          <String value=\"" + Escape(name) + "\" />\n";
}

// What a combo box offers.
std::string Choices()
{
  std::string text;
  for (const wfv::Projection* p : wfv::AllProjections())
  {
    text += Choice(p->Name);
  }
  return text;
}

std::string StereoChoices()
{
  std::string text;
  for (const wfv::StereoModel& m : wfv::StereoModels())
  {
    text += Choice(m.Name);
  }
  return text;
}

// What a combo box offers, with the number of each.
std::string TechniqueChoices()
{
  std::string text;
  for (const wfv::TechniqueEntry& t : wfv::Techniques())
  {
    text += "          <Entry text=\"" + Escape(t.Title) + "\" value=\"" +
      std::to_string(t.Number) + "\" />\n";
  }
  return text;
}

// A sentence a technique: how it draws.
std::string TechniqueHelp()
{
  std::string text;
  for (const wfv::TechniqueEntry& t : wfv::Techniques())
  {
    text += "          " + t.Title + ": " + t.Help + ".\n";
  }
  return Escape(text);
}

// A sentence a model: its name for people.
std::string StereoHelp()
{
  std::string text;
  for (const wfv::StereoModel& m : wfv::StereoModels())
  {
    text += "          " + m.Name + ": " + m.Title + ".\n";
  }
  return Escape(text);
}

// "360 degrees", or "from 90 to 170 degrees".
std::string Range(double least, double most)
{
  std::ostringstream text;
  if (least > 0 && least < most)
  {
    text << "from " << least << " to ";
  }
  text << most << " degrees";
  return text.str();
}

// A sentence a projection: its name for people, what it keeps, how far it reaches.
std::string Help()
{
  std::string text;
  for (const wfv::Projection& p : wfv::Projections())
  {
    const bool round = p.Axis == wfv::Family::Azimuthal;
    text += "          " + p.Name + ": " + p.Title + " (" + p.Properties + "), up to " +
      Range(p.MinHorizontalFov, p.MaxHorizontalFov) +
      (round ? " across" : " by " + Range(p.MinVerticalFov, p.MaxVerticalFov)) +
      (p.Limit.empty() ? "" : ", for " + p.Limit) + ".\n";
  }
  const wfv::Projection& sampled = wfv::SampledProjection();
  text += "          " + sampled.Name + ": " + sampled.Title + ", see DirectionMapFile.\n";
  return Escape(text);
}

// Wherever the mark is.
void Replace(std::string& text, const std::string& mark, const std::string& value)
{
  std::string::size_type at = text.find(mark);
  if (at == std::string::npos)
  {
    throw std::runtime_error("the template lacks " + mark);
  }
  for (; at != std::string::npos; at = text.find(mark, at + value.size()))
  {
    text.replace(at, mark.size(), value);
  }
}

// Which model it is that has a number, and which is the usual one.
void NameModels(std::string& text)
{
  using Number = wfv::StereoNumber;
  const std::pair<const char*, Number> numbers[] = { { "INTERPUPILLARY_DISTANCE",
                                                       Number::InterpupillaryDistance },
    { "POLE_FADE", Number::PoleFade }, { "IOD", Number::Iod }, { "SEPARATION", Number::Separation },
    { "CONVERGENCE", Number::Convergence } };
  for (const auto& [mark, number] : numbers)
  {
    Replace(text, "@STEREO_WITH_" + std::string(mark) + "@", Escape(wfv::StereoWith(number).Name));
  }
  const wfv::Projection& around = wfv::Projections().front();
  Replace(text, "@STEREO_USUAL@", Escape(wfv::UsualStereo(around).Name));
}

void Write(const std::string& source, const std::string& output)
{
  std::ifstream in(source);
  std::stringstream content;
  content << in.rdbuf();
  if (!in)
  {
    throw std::runtime_error("cannot read " + source);
  }
  std::string text = content.str();
  Replace(text, "@PROJECTION_CHOICES@\n", Choices());
  Replace(text, "@PROJECTION_HELP@\n", Help());
  Replace(text, "@STEREO_CHOICES@\n", StereoChoices());
  Replace(text, "@STEREO_HELP@\n", StereoHelp());
  Replace(text, "@TECHNIQUE_CHOICES@\n", TechniqueChoices());
  Replace(text, "@TECHNIQUE_HELP@\n", TechniqueHelp());
  NameModels(text);
  std::ofstream out(output);
  out << text;
  out.close();
  if (!out)
  {
    throw std::runtime_error("cannot write " + output);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "widefov-view-xml: name the template and the output\n";
    return 2;
  }
  try
  {
    Write(argv[1], argv[2]);
  }
  catch (const std::exception& e)
  {
    std::cerr << "widefov-view-xml: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
