// SPDX-License-Identifier: BSD-3-Clause
// The outputs of a vertex stage, found in its text, and how a geometry stage of ours hands
// them on: as flat copies of what each corner of the primitive has, which the fragment
// stage weighs by the pixel's ray. Text in, text out.
#ifndef vtkWideFoVVaryings_h
#define vtkWideFoVVaryings_h

#include <string>
#include <vector>

namespace wfv
{
// One output of the vertex stage.
struct Varying
{
  bool Flat;
  std::string Type;
  std::string Name;

  // As the geometry stage takes it in: one a vertex.
  std::string Input() const;

  std::string Declaration(const std::string& name) const;

  // Floats or integers in it: what OpenGL counts.
  int Components() const;
};

std::vector<Varying> FindVaryings(const std::string& vertex);

// Takes the fragment stage's declarations of these inputs out.
void RemoveInputs(std::string& fragment, const std::vector<Varying>& varyings);

// The copy of a varying at a corner.
std::string CornerName(size_t varying, int corner);

// For the geometry stage: declares all copies for primitives of so many corners, and
// wfvWriteCorners(), which sets them.
std::string CornerOutputs(const std::vector<Varying>& varyings, int corners);

// For the fragment stage: declares the varyings as plain variables, and
// wfvInterpolate(), which sets them from the copies and one weight a corner, an
// expression in GLSL. What is flat has the value of the last corner.
std::string CornerInputs(
  const std::vector<Varying>& varyings, const std::vector<std::string>& weights);

// Components of all copies.
int CornerComponents(const std::vector<Varying>& varyings, int corners);

void ReplaceAll(std::string& text, const std::string& from, const std::string& to);
}

#endif
