// SPDX-License-Identifier: BSD-3-Clause
// The factory of wide renderers and cameras, for programs that know nothing of them.
#include "Run/Wishes/Wishes.h"
#include "RunRenderer.h"
#include "Text/Messages.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkVersion.h>

#include "Compat/FutureConst.h"

#include <cstdlib>

namespace widefov
{
namespace
{
class RunFactory : public vtkObjectFactory
{
public:
  vtkTypeMacro(RunFactory, vtkObjectFactory);
  static RunFactory* New()
  {
    auto* const made = new RunFactory;
    made->InitializeObjectBase();
    return made;
  }

  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "wide views by widefov-run"; }

private:
  RunFactory();
};

constexpr const char* StereoWindow = "widefovStereoWindow";

// The first factory that makes a class makes it, and others may have been registered before: what
// they make is not asked for any more. Those that come later are asked later.
void PutFirst(const char* name)
{
  vtkObjectFactory::SetAllEnableFlags(0, name);
}

// As the other factories make it, and stereo from the beginning.
vtkObject* MakeStereoWindow()
{
  vtkObjectFactory::SetAllEnableFlags(1, "vtkRenderWindow");
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow", StereoWindow);
  vtkRenderWindow* const window = vtkRenderWindow::New();
  PutFirst("vtkRenderWindow");
  vtkObjectFactory::SetAllEnableFlags(1, "vtkRenderWindow", StereoWindow);
  window->SetStereoTypeToAnaglyph();
  window->StereoRenderOn();
  return window;
}

RunFactory::RunFactory()
{
  const char* const what = "wide field of view";
  const Wishes& wishes = TheWishes();
  PutFirst("vtkRenderer");
  this->RegisterOverride("vtkRenderer", "vtkWideFoVRenderer", what, 1,
    []() -> vtkObject* { return RunRenderer::New(); });
  if (!wishes.IsFlat())
  {
    PutFirst("vtkCamera");
    this->RegisterOverride(
      "vtkCamera", "vtkWideFoVCamera", what, 1, []() -> vtkObject* { return RunCamera::New(); });
  }
  if (wishes.Stereo->Traits.TwoEyes)
  {
    PutFirst("vtkRenderWindow");
    this->RegisterOverride("vtkRenderWindow", StereoWindow, what, 1, &MakeStereoWindow);
  }
}

std::optional<std::string> FromEnvironment(const Wish& wish)
{
  const char* const value = std::getenv(wish.Variable);
  return value && *value ? std::optional<std::string>(value) : std::nullopt;
}

// A wrong one ends the program: it is not to show something else.
Wishes WishesOrExit()
{
  try
  {
    return ReadWishes(&FromEnvironment, &Wish::Variable);
  }
  catch (const Failure& failure)
  {
    SetProgramName("widefov-run");
    SayError(failure.what());
    std::_Exit(failure.ExitCode);
  }
}
}

const Wishes& TheWishes()
{
  static const Wishes wishes = WishesOrExit();
  return wishes;
}
}

extern "C" __attribute__((visibility("default"))) vtkObjectFactory* widefovMakeFactory()
{
  return widefov::RunFactory::New();
}
