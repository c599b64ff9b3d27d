// SPDX-License-Identifier: BSD-3-Clause
#include "Choices.h"

#include "Messages.h"
#include "OptionCheck.h"

namespace widefov
{
namespace
{
constexpr const char* Techniques[] = { "auto", "exact", "tessellate", "preclip", "vertex",
  "cubemap" };
constexpr int TechniqueCount = 6;

int IndexOf(const std::string& technique)
{
  int index = 0;
  while (index + 1 < TechniqueCount && technique != Techniques[index])
  {
    index++;
  }
  return index;
}
}

bool CanBeTiled(const Options& options)
{
  const wfv::Projection& p = *wfv::FindProjection(options.Projection);
  return p.Axis != wfv::Family::Planar && options.TechniqueName != "cubemap";
}

std::string WhyNot(const Options& options, bool tiled)
{
  const wfv::Projection& p = *wfv::FindProjection(options.Projection);
  if (p.Axis == wfv::Family::Sampled && !options.View.Map)
  {
    return "a direction map is a file; give one on the command line";
  }
  if (tiled && !CanBeTiled(options))
  {
    return "only wide projections drawn by this module go over several windows";
  }
  const std::string complaint = wfv::CheckOptions(p, options.View);
  if (!complaint.empty())
  {
    return complaint;
  }
  try
  {
    Options copy = options;
    CheckDrawn(copy);
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return "";
}

bool GiveUpTechnique(Options& o)
{
  if (o.Technique == Technique::Auto || WhyNot(o).empty())
  {
    return false;
  }
  o.Technique = Technique::Auto;
  o.TechniqueName = "auto";
  return true;
}

void StepProjection(Options& o, const Fields& fields, int step, bool tiled)
{
  const std::vector<const wfv::Projection*> all = wfv::AllProjections();
  const int count = static_cast<int>(all.size());
  int index = 0;
  while (all[static_cast<std::size_t>(index)]->Name != o.Projection)
  {
    index++;
  }
  for (int tries = 1; tries < count; tries++)
  {
    Options next = o;
    next.Projection = all[static_cast<std::size_t>((index + (step * tries + count)) % count)]->Name;
    fields.Apply(next);
    GiveUpTechnique(next);
    if (!WhyNot(next).empty())
    {
      next.DebugView = false;
      next.Depth = "linear";
    }
    if (WhyNot(next, tiled).empty())
    {
      CheckDrawn(next);
      o = next;
      return;
    }
  }
}

bool StepTechnique(Options& o, int step, bool tiled)
{
  const int index = IndexOf(o.TechniqueName);
  for (int tries = 1; tries < TechniqueCount; tries++)
  {
    Options next = o;
    next.TechniqueName = Techniques[(index + step * tries + TechniqueCount) % TechniqueCount];
    if (WhyNot(next, tiled).empty())
    {
      CheckDrawn(next);
      o = next;
      return true;
    }
  }
  return false;
}

bool SetDebugView(Options& o, bool on)
{
  Options next = o;
  next.DebugView = on;
  if (!WhyNot(next).empty())
  {
    return false;
  }
  o = next;
  return true;
}
}
