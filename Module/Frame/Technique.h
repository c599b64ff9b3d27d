// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVPass::Techniques by the same numbers, for what the pass is made of.
#ifndef WideFoVTechnique_h
#define WideFoVTechnique_h

namespace wfv
{
enum Technique : int
{
  TechniqueAuto = 0,
  TechniqueExact,
  TechniqueTessellate,
  TechniquePreClip,
  TechniqueVertex
};
}

#endif
