// SPDX-License-Identifier: BSD-3-Clause
// What is said of a VTK that the module does not know.
#include "Compat/VersionCheck.h"

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>
#include <vtkStringOutputWindow.h>

#include <gtest/gtest.h>

using wfv::RemarkOnVtk;

TEST(VersionCheck, AKnownVtkGetsNoRemark)
{
  EXPECT_EQ(RemarkOnVtk("9.1.0", "9.1.0", "9.6"), "");
  EXPECT_EQ(RemarkOnVtk("9.2.20220823", "9.2.20220823", "9.6"), "");
  EXPECT_EQ(RemarkOnVtk("9.6.2", "9.6.2", "9.6"), "");
  EXPECT_EQ(RemarkOnVtk("9.6.2", "9.6.1", "9.6"), "");
}

TEST(VersionCheck, ANewerOneIsNamed)
{
  for (const char* version : { "9.7.0", "9.10.1", "10.0.0" })
  {
    const std::string remark = RemarkOnVtk(version, version, "9.6");
    EXPECT_NE(remark.find("VTK " + std::string(version) + " is newer than 9.6"), std::string::npos)
      << remark;
  }
}

TEST(VersionCheck, TwoOfThemAreNamedBoth)
{
  const std::string remark = RemarkOnVtk("9.3.1", "9.6.2", "9.6");
  EXPECT_NE(remark.find("but VTK 9.3.1 draws"), std::string::npos) << remark;
  EXPECT_NE(remark.find("against VTK 9.6.2"), std::string::npos) << remark;
}

TEST(VersionCheck, ARemarkIsAWarning)
{
  const vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  const auto said = [](const std::string& remark) {
    vtkNew<vtkStringOutputWindow> window;
    vtkOutputWindow::SetInstance(window);
    wfv::WarnWith(remark);
    return window->GetOutput();
  };
  const std::string remark = RemarkOnVtk("9.7.0", "9.7.0", "9.6");
  const std::string warned = said(remark);
  const std::string silent = said("");
  vtkOutputWindow::SetInstance(before);
  EXPECT_NE(warned.find(remark), std::string::npos) << warned;
  EXPECT_EQ(silent, "");
}
