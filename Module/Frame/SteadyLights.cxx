// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/SteadyLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace
{
enum Steadiness
{
  Moves,
  KeepsColor, // a headlight, whose direction is no number
  KeepsAll
};

// Of each light that is on: how steady it is, colour, direction.
constexpr std::size_t Numbers = 7;

Steadiness SteadinessOf(vtkLight* light)
{
  if (light->GetPositional())
  {
    return Moves;
  }
  return light->LightTypeIsHeadlight() ? KeepsColor
    : light->LightTypeIsCameraLight()  ? KeepsAll
                                       : Moves;
}

// A camera light's places are those of a camera at 0, 0, 1 that looks down -z.
void AppendLight(vtkLight* light, std::vector<double>& numbers)
{
  double direction[3];
  vtkMath::Subtract(light->GetFocalPoint(), light->GetPosition(), direction);
  vtkMath::Normalize(direction);
  const Steadiness steadiness = SteadinessOf(light);
  numbers.push_back(steadiness);
  for (int i = 0; i < 3; i++)
  {
    const double color = light->GetDiffuseColor()[i] * light->GetIntensity();
    numbers.push_back(steadiness == Moves ? 0 : color);
  }
  for (double d : direction)
  {
    numbers.push_back(steadiness == KeepsAll ? d : 0);
  }
}

void CollectNumbers(vtkRenderer* renderer, std::vector<double>& numbers)
{
  numbers.clear();
  auto* const gl = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (!renderer->GetLightFollowCamera() || !gl || gl->GetUserLightTransform())
  {
    return;
  }
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      AppendLight(light, numbers);
    }
  }
  if (numbers.empty() && renderer->GetAutomaticLightCreation())
  {
    // the one that VTK makes once it draws
    numbers.insert(numbers.end(), { KeepsColor, 1, 1, 1, 0, 0, 0 });
  }
}

// (GLSL's numbers have a point, whatever the user's language writes)
std::string Constant(const char* name, std::size_t light, const double* v)
{
  std::ostringstream line;
  line.imbue(std::locale::classic());
  line << std::setprecision(9) << name << light << " vec3(" << static_cast<float>(v[0]) << ", "
       << static_cast<float>(v[1]) << ", " << static_cast<float>(v[2]) << ")\n";
  return line.str();
}
}

namespace wfv
{
bool SteadyLights::Look(vtkRenderer* renderer)
{
  // of a frame like the last one nothing is allocated
  CollectNumbers(renderer, this->Now);
  const bool same = !this->Looked || this->Now == this->Seen;
  this->Looked = true;
  if (same && this->Current)
  {
    return false;
  }
  const bool had = !this->Constants.empty();
  this->Seen = this->Now;
  this->Current = same;
  this->Constants.clear();
  for (std::size_t i = 0; same && i < this->Seen.size() / Numbers; i++)
  {
    const double* const light = this->Seen.data() + Numbers * i;
    this->Constants += light[0] == Moves ? "" : Constant("lightColor", i, light + 1);
    this->Constants += light[0] == KeepsAll ? Constant("lightDirectionVC", i, light + 4) : "";
  }
  return had || !this->Constants.empty();
}
}
