// SPDX-License-Identifier: BSD-3-Clause
// Tests that draw: one window for all tests of a suite, one instance a projection.
#ifndef WideFoVTestDrawingTest_h
#define WideFoVTestDrawingTest_h

#include "Drawing.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace wfv
{
namespace test
{
class DrawingTest : public ::testing::TestWithParam<std::string>
{
public:
  static void SetUpTestSuite() { Picture.reset(new Drawing); }
  static void TearDownTestSuite() { Picture.reset(); }

  // The projection, with underscores: what GoogleTest allows in a name.
  static std::string NameOf(const ::testing::TestParamInfo<std::string>& info)
  {
    std::string name = info.param;
    for (char& c : name)
    {
      c = c == '-' ? '_' : c;
    }
    return name;
  }

protected:
  static inline std::unique_ptr<Drawing> Picture;
};

// All but the perspective, which stock VTK draws, and stereo all round is not for.
inline std::vector<std::string> WideNames()
{
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    if (p.Axis != Family::Planar)
    {
      names.push_back(p.Name);
    }
  }
  return names;
}

inline std::vector<std::string> ProjectionNames()
{
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    names.push_back(p.Name);
  }
  return names;
}
}
}

#endif
