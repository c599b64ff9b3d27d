// SPDX-License-Identifier: BSD-3-Clause
// Mesa has a second software renderer, an interpreter of OpenGL 3.3 without doubles and without
// tessellation; and it has OpenGL on Vulkan, where programs are SPIR-V, as many a GPU draws. Tests
// that run with them show that pictures do not hang on one compiler's mind; this one, that it is
// they that draw.
#include "Drawing.h"
#include "Meshes.h"
#include "Poses.h"
#include "vtkWideFoVPass.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkStringOutputWindow.h>

#include <cstdlib>
#include <string>

TEST(Driver, IsTheOneThatWasAskedFor)
{
  const char* const wanted = std::getenv("WIDEFOV_TEST_RENDERER");
  if (!wanted)
  {
    GTEST_SKIP() << "WIDEFOV_TEST_RENDERER says no name";
  }
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(8, 8);
  window->Render();
  const std::string told = window->ReportCapabilities();
  const std::size_t at = told.find("OpenGL renderer string:");
  ASSERT_NE(at, std::string::npos);
  const std::string line = told.substr(at, told.find('\n', at) - at);
  EXPECT_NE(line.find(wanted), std::string::npos) << line;
}

namespace
{
// What VTK says goes to a string while this lives.
struct Overheard
{
  Overheard() { vtkOutputWindow::SetInstance(this->Window); }
  ~Overheard() { vtkOutputWindow::SetInstance(this->Before); }

  long Count(const std::string& text) const
  {
    const std::string all = this->Window->GetOutput();
    long count = 0;
    for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1))
    {
      ++count;
    }
    return count;
  }

  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> Window;
};
}

// A driver without enough tessellation: one warning that says so, and pictures as good as they were
// to be. WIDEFOV_TEST_OBSTACLE: what the warning says of this driver.
TEST(Driver, KeepsTheToleranceWithoutTessellation)
{
  using namespace wfv;
  const char* const obstacle = std::getenv("WIDEFOV_TEST_OBSTACLE");
  if (!obstacle)
  {
    GTEST_SKIP() << "WIDEFOV_TEST_OBSTACLE says no reason why this driver could not tessellate";
  }
  const Overheard said;
  test::Drawing drawing;
  drawing.SetMesh(test::MakeRoom(1));
  drawing.SetTechnique(vtkWideFoVPass::TESSELLATE);
  for (double tolerance : { 0.05, 0.25, 1.0 })
  {
    drawing.SetTolerance(tolerance);
    const test::Shot shot = test::MakeShot("hammer", 360, test::PlainPoses()[1]);
    const reference::DrawnPicture picture = drawing.Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width);
    EXPECT_EQ(drawing.GetNumberOfTessellateDraws(), 0);
    const reference::RayCaster caster(drawing.GetMesh(), drawing.GetView(), drawing.GetPose());
    const reference::Metrics m = reference::Compare(picture, caster, tolerance);
    EXPECT_LE(m.MaxPx, tolerance) << test::Row(shot, "room of 12", m);
    EXPECT_EQ(m.Unexplained, 0) << test::Row(shot, "room of 12", m);
  }
  EXPECT_EQ(said.Count("the technique tessellate cannot be had, auto is used: this OpenGL "), 1);
  EXPECT_EQ(said.Count(obstacle), 1) << said.Window->GetOutput();
}
