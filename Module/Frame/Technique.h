// SPDX-License-Identifier: BSD-3-Clause
// The registry of techniques. Everything that offers, draws, checks or documents one reads it
// from here.
#ifndef WideFoVTechnique_h
#define WideFoVTechnique_h

#include "Projections/Projection.h" // For WFV_EXPORT

#include <string>
#include <vector>

namespace wfv
{
// vtkWideFoVPass::Techniques by the same numbers, for what the pass is made of.
enum TechniqueNumber : int
{
  TechniqueAuto = 0,
  TechniqueExact,
  TechniqueTessellate, // TechniqueAuto by its old name
  TechniquePreClip,
  TechniqueVertex
};

struct TechniqueEntry
{
  int Number;        // TechniqueNumber
  std::string Name;  // of command lines
  std::string Title; // of a choice in a window
  std::string Help;  // how it draws: part of a sentence
};

// In the order in which they are offered. TechniqueTessellate is not among them.
WFV_EXPORT const std::vector<TechniqueEntry>& Techniques();

// Its number, or -1.
WFV_EXPORT int FindTechnique(const std::string& name);

// Returns the technique that a number stands for: the nearest one, and for TechniqueTessellate,
// whose name goes with the next release, TechniqueAuto, with one warning in a process.
int TechniqueOf(int number);
}

#endif
