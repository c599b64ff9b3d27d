// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVStage: what its programs are told.
#include "Frame/vtkWideFoVStage.h"

#include "Camera/Tile.h"
#include "Camera/TwoFloats.h"
#include "Compat/Gl.h"
#include "Drawables/LineMapper.h"
#include "Frame/DirectionTextures.h"
#include "Frame/Eye.h"
#include "Frame/Stages.h"
#include "Projections/Bounds/Curvature.h"
#include "Shaders/Limits.h"

#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
// Samples of a pixel of the framebuffer that is bound.
int CountSamples()
{
  int samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return glIsEnabled(GL_MULTISAMPLE) ? std::min(samples, wfv::WFV_MOST_SAMPLES) : 0;
}

// View coordinates per unit of the pre-clip's own: a power of two, which costs no rounding. It is
// near the far radius, or below if the near one is so much smaller that products of three lengths
// there would be too small for a float.
double FindUnit(const wfv::vec2& radii)
{
  constexpr double MostBits = 24; // between the radii, with a unit near the far one
  const double bits = std::log2(radii.y / radii.x) - MostBits;
  return std::exp2(std::floor(std::log2(radii.y) - 0.5 * std::max(bits, 0.0)));
}

// The uniform wfvView.
void SetViewParameters(vtkShaderProgram* program, const wfv::WfvView& v)
{
  const auto set2 = [program](const char* name, const wfv::vec2& v) {
    const float f[2] = { static_cast<float>(v.x), static_cast<float>(v.y) };
    program->SetUniform2f(name, f);
  };
  set2("wfvView.halfFov", v.halfFov);
  set2("wfvView.scale", v.scale);
  set2("wfvView.tilt", v.tilt);
  set2("wfvTiltLow", wfv::vec2(wfv::LowPart(v.tilt.x), wfv::LowPart(v.tilt.y)));
  set2("wfvView.radii", v.radii);
  const auto set4 = [program](const char* name, const wfv::vec4& v) {
    const float f[4] = { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
      static_cast<float>(v.w) };
    program->SetUniform4f(name, f);
  };
  set4("wfvView.lens", v.lens);
  set4("wfvView.lensHigh", v.lensHigh);
  set4("wfvView.stereo", v.stereo);
  set2("wfvView.center", v.center);
  program->SetUniformi("wfvView.eye", v.eye);
  program->SetUniformf("wfvView.halfEyes", static_cast<float>(v.halfEyes));
  program->SetUniformf("wfvView.lens5", static_cast<float>(v.lens5));
  program->SetUniformf("wfvView.maxAngle", static_cast<float>(v.maxAngle));
  program->SetUniformf("wfvView.curvature", static_cast<float>(v.curvature));
  const double unit = FindUnit(v.radii);
  program->SetUniformf("wfvUnit", static_cast<float>(unit));
  const double depth = v.radii.y - v.radii.x;
  set2("wfvUnitDepth", wfv::vec2(unit / depth, -v.radii.x / depth));
  if (v.map)
  {
    set4("wfvView.tables", v.tables);
  }
}

wfv::ProgramUses FindUses(vtkShaderProgram* program)
{
  wfv::ProgramUses uses;
  uses.Samples = program->IsUniformUsed("wfvSamples");
  uses.Eye = wfv::FindEyeUniforms(program);
  uses.LineWidth = program->IsUniformUsed("wfvLineWidth");
  uses.FrontCulled = program->IsUniformUsed("wfvFrontCulled");
  uses.PointSize = program->IsUniformUsed("wfvPointSize");
  uses.Pixels = program->IsUniformUsed("wfvPixels");
  uses.PolygonOffset = program->IsUniformUsed("wfvPolygonOffset");
  uses.FineDepth = program->IsUniformUsed("wfvNearestKnown");
  return uses;
}
}

namespace
{
// Factor and units of the polygon offset, as stock VTK chooses them.
void SetPolygonOffset(vtkShaderProgram* program, vtkMapper* mapper, vtkProperty* property)
{
  const bool edges = property->GetEdgeVisibility() && property->GetRepresentation() == VTK_SURFACE;
  double offset[2] = { 0, 0 };
  if (mapper && (edges || vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_POLYGON_OFFSET))
  {
    mapper->GetCoincidentTopologyPolygonOffsetParameters(offset[0], offset[1]);
  }
  const float values[2] = { static_cast<float>(offset[0]), static_cast<float>(offset[1]) };
  program->SetUniform2f("wfvPolygonOffset", values);
}
}

// The factor that moves the outer vertices of a skirt by two tolerances and a pixel at least.
void vtkWideFoVStage::SetSkirtUniform(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("wfvSkirt"))
  {
    return;
  }
  const wfv::vec2 half = 0.5 * wfv::vec2(this->Pixels.Full.x, this->Pixels.Full.y);
  double radius = std::min(half.x, half.y);
  if (this->Seen.Projection->Axis == wfv::Family::Azimuthal)
  {
    const double angle = this->View.maxAngle;
    const wfv::vec3 rim(std::sin(angle), 0, -std::cos(angle));
    radius = half.x * std::abs(this->Seen.Projection->Project(rim, this->View).x);
  }
  const double factor = 1 + (2 * this->Tolerance + 1) / std::max(1.0, radius);
  program->SetUniformf("wfvSkirt", static_cast<float>(factor));
}

// Whatever frames before had: what is drawn depends on it, to the last digits.
void vtkWideFoVStage::TakeSamples()
{
  const bool several = CountSamples() > 1;
  if (several != this->Seen.Multisample)
  {
    this->Seen.Multisample = several;
    this->SourceTime.Modified();
  }
}

void vtkWideFoVStage::NoteSamples()
{
  if (CountSamples() > 1 && !this->Seen.Multisample)
  {
    this->Seen.Multisample = true;
    this->SourceTime.Modified();
  }
}

void vtkWideFoVStage::SetFrameParameters(vtkShaderProgram* program, const int viewport[4])
{
  SetViewParameters(program, this->View);
  program->SetUniformf("wfvTolerance", this->Tolerance);
  if (program->IsUniformUsed("wfvStretch"))
  {
    const wfv::vec2 stretch = wfv::Stretch(*this->Seen.Projection, this->View);
    program->SetUniformf("wfvStretch", static_cast<float>(std::max(stretch.x, stretch.y)));
  }
  this->SetSkirtUniform(program);
  wfv::SetTileUniforms(
    program, this->Pixels, this->Tile, viewport, this->View.scale, this->View.center);
}

bool vtkWideFoVStage::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  this->Stages->Shaders.End(program);
  int viewport[4] = { 0, 0, 1, 1 };
  if (auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer))
  {
    renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  }
  wfv::ProgramMemory& memory = this->Stages->Programs;
  wfv::ProgramMemory::Entry& known = memory.Get(program);
  if (!memory.IsSet(known, viewport))
  {
    this->SetFrameParameters(program, viewport);
    known.Uses = FindUses(program);
    memory.NoteSet(known, viewport);
  }
  if (this->View.map && this->Textures)
  {
    this->Textures->Bind(program);
  }
  if (known.Uses.Samples)
  {
    SetSampleParameters(program);
  }
  if (known.Uses.FineDepth)
  {
    this->Stages->Fine.SetParameters(program, prop, viewport);
  }
  this->SetVolumeParameters(program, prop);
  this->SetSkyParameters(program, prop);
  this->SetPropParameters(program, mapper, prop, known.Uses);
  this->NumberOfDraws++;
  const bool may = this->Unrefined != this->Variant && vtkActor::SafeDownCast(prop);
  this->NumberOfUnrefinedDraws += may && this->MakeRequest(mapper, prop).Stage != this->Variant;
  this->Stages->Glyphs.Draw(this->Renderer, mapper, prop, this);
  return true;
}

void vtkWideFoVStage::NoteProgram(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  if (this->Stages->Folder.IsOpen())
  {
    const std::string what = vtkVolume::SafeDownCast(prop)
      ? "volume"
      : wfv::ShaderFolder::NameOf(this->MakeRequest(mapper, prop));
    this->Stages->Folder.Note(program, what, this->Renderer, mapper, prop);
  }
}

void vtkWideFoVStage::SetPropParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, const wfv::ProgramUses& uses) const
{
  this->Stages->DrawnKeys.push_back(prop->GetPropertyKeys());
  this->NoteProgram(program, mapper, prop);
  auto* polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!polydata || !actor)
  {
    return;
  }
  vtkProperty* const property = actor->GetProperty();
  if (uses.Eye.Known >= 0)
  {
    wfv::SetEye(uses.Eye, polydata, actor, this->Stages->Eye);
  }
  if (uses.LineWidth)
  {
    program->SetUniformf("wfvLineWidth", wfv::LineWidth(polydata, actor));
  }
  if (uses.FrontCulled)
  {
    program->SetUniformi(
      "wfvFrontCulled", property->GetFrontfaceCulling() && !property->GetBackfaceCulling());
  }
  if (uses.PolygonOffset)
  {
    SetPolygonOffset(program, actor->GetMapper(), property);
  }
  if (uses.PointSize)
  {
    program->SetUniformf("wfvPointSize", wfv::PointSize(polydata, actor));
  }
  if (uses.Pixels)
  {
    const bool tubes = this->MakeRequest(mapper, prop).Kind == wfv::ShaderBuilder::Primitive::Tubes;
    program->SetUniformf("wfvPixels", tubes ? property->GetLineWidth() : property->GetPointSize());
  }
}

void vtkWideFoVStage::SetSampleParameters(vtkShaderProgram* program)
{
  const int samples = CountSamples();
  float offsets[wfv::WFV_MOST_SAMPLES][2];
  for (int i = 0; i < samples; i++)
  {
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, offsets[i]);
    offsets[i][0] -= 0.5f;
    offsets[i][1] -= 0.5f;
  }
  program->SetUniformi("wfvSamples", samples);
  if (samples > 1)
  {
    program->SetUniform2fv("wfvSampleOffsets", samples, offsets);
  }
}
