// SPDX-License-Identifier: BSD-3-Clause
// What VTK says, for tests to look at.
#ifndef Overheard_h
#define Overheard_h

#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <string>

// It goes to a string while this lives.
struct Overheard
{
  Overheard() { vtkOutputWindow::SetInstance(this->Window); }
  ~Overheard() { vtkOutputWindow::SetInstance(this->Before); }

  std::string All() const { return this->Window->GetOutput(); }

  int Count(const std::string& part) const
  {
    const std::string all = this->All();
    int n = 0;
    for (size_t at = all.find(part); at != std::string::npos; at = all.find(part, at + 1))
    {
      n++;
    }
    return n;
  }

  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> Window;
};

#endif
