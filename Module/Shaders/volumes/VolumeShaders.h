// SPDX-License-Identifier: BSD-3-Clause
// Volumes by the ray of each pixel: VTK's own text marches, along the view's rays. Text in, text
// out.
#ifndef WideFoVVolumeShaders_h
#define WideFoVVolumeShaders_h

#include "Shaders/ShaderBuilder.h"

namespace wfv
{
namespace volume
{
// What is known of the volume's text, beside the request.
struct Traits
{
  bool Known = false;  // all of it is VTK's own
  bool Shaded = false; // by lights
  int Directional = 0; // which of the lights without a position are at the eye, a bit each
};

// After the mapper has replaced its tags.
WFV_EXPORT void Finish(const ShaderBuilder::Request& request, const Traits& traits,
  std::string& geometry, std::string& fragment);

// The same of a flat picture that stock VTK draws, of an eye beside the camera's position.
WFV_EXPORT void FinishFlat(const Traits& traits, std::string& fragment);
}
}

#endif
