// SPDX-License-Identifier: BSD-3-Clause
// Mesa has a second software renderer, an interpreter of OpenGL 3.3 without doubles; and it has
// OpenGL on Vulkan, where programs are SPIR-V, as many a GPU draws. Tests that run with them show
// that pictures do not depend on one compiler; this one shows that the driver asked for draws.
#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>

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
