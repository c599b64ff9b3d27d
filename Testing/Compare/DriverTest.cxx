// SPDX-License-Identifier: BSD-3-Clause
// Mesa has a second software renderer, an interpreter of OpenGL 3.3 without doubles and without
// tessellation. Tests that run with it show that pictures do not hang on one compiler's mind; this
// one, that it is it that draws.
#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <string>

TEST(Driver, IsTheOneThatWasAskedFor)
{
  const char* const wanted = std::getenv("GALLIUM_DRIVER");
  if (!wanted)
  {
    GTEST_SKIP() << "GALLIUM_DRIVER says no name";
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
