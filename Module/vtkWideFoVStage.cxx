// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVStage.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVDirectionTextures.h"
#include "vtkWideFoVDiscontinuity.h"
#include "vtkWideFoVEye.h"
#include "vtkWideFoVHeadlights.h"
#include "vtkWideFoVLineMapper.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVQuadricKind.h"
#include "vtkWideFoVQuadricShaders.h"
#include "vtkWideFoVSortedDraw.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVTessellation.h"
#include "vtkWideFoVTile.h"

#include "Projections/Bend.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

vtkStandardNewMacro(vtkWideFoVStage);

namespace
{
// What a pass may know of a mapper only from inside.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  static void Describe(vtkOpenGLPolyDataMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
    vtkWideFoVShaderBuilder::Request& request)
  {
    using Primitive = vtkWideFoVShaderBuilder::Primitive;
    const vtkOpenGLHelper* buffer = mapper->*(&MapperAccess::LastBoundBO);
    const int type = buffer ? buffer->PrimitiveType : static_cast<int>(PrimitiveTris);
    const int representation = actor->GetProperty()->GetRepresentation();
    const bool picking = mapper->*(&MapperAccess::PointPicking);
    const bool points = representation == VTK_POINTS || type == PrimitivePoints ||
      type == PrimitiveVertices || picking;
    const bool lines = representation == VTK_WIREFRAME || type == PrimitiveLines;
    request.Kind = points ? Primitive::Points : lines ? Primitive::Lines : Primitive::Triangles;
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    request.WidePoints = request.Kind == Primitive::Points && wfv::PointSize(mapper, actor) > 1.0f;
    request.WideLines = request.Kind == Primitive::Lines && window &&
      actor->GetProperty()->GetLineWidth() > window->GetMaximumHardwareLineWidth();
    request.Edges = request.Kind == Primitive::Triangles &&
      actor->GetProperty()->GetEdgeVisibility() && !renderer->GetSelector();
    request.EdgeFlags =
      request.Edges && type == PrimitiveTris && !(mapper->*(&MapperAccess::EdgeValues)).empty();
    request.Kind = wfv::quadric::KindOf(mapper, actor, request.Kind);
    request.Surface = DescribeMaterial(mapper, renderer, actor, buffer);
  }

private:
  // Of the stock mappers that take the property as it is; of composite ones each block may
  // have its own, and what is selected has a colour of its own.
  static vtkWideFoVShaderBuilder::Material DescribeMaterial(vtkOpenGLPolyDataMapper* mapper,
    vtkRenderer* renderer, vtkActor* actor, const vtkOpenGLHelper* buffer)
  {
    static const std::set<std::string> simple{ "vtkOpenGLPolyDataMapper",
      "vtkWideFoVPolyDataMapper", "vtkOpenGLGlyph3DHelper" };
    const vtkOpenGLHelper* own = mapper->*(&MapperAccess::Primitives);
    const bool surface = buffer == own + PrimitiveTris || buffer == own + PrimitiveTriStrips;
    vtkWideFoVShaderBuilder::Material material;
    if (surface && !renderer->GetSelector() && simple.count(mapper->GetClassName()) > 0)
    {
      vtkProperty* property = actor->GetProperty();
      material.NoAmbient = property->GetAmbient() == 0;
      material.FullDiffuse = property->GetDiffuse() == 1;
      material.NoSpecular = property->GetSpecular() == 0;
      material.Opaque = property->GetOpacity() == 1;
    }
    return material;
  }
};

constexpr int MaxSamples = 16; // as in ray_fragment.glsl

// Samples of a pixel of the framebuffer that is bound.
int CountSamples()
{
  int samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return glIsEnabled(GL_MULTISAMPLE) ? std::min(samples, MaxSamples) : 0;
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
  set2("wfvView.radii", v.radii);
  const float lens[4] = { static_cast<float>(v.lens.x), static_cast<float>(v.lens.y),
    static_cast<float>(v.lens.z), static_cast<float>(v.lens.w) };
  program->SetUniform4f("wfvView.lens", lens);
  const float stereo[4] = { static_cast<float>(v.stereo.x), static_cast<float>(v.stereo.y),
    static_cast<float>(v.stereo.z), static_cast<float>(v.stereo.w) };
  program->SetUniform4f("wfvView.stereo", stereo);
  program->SetUniformf("wfvView.lens5", static_cast<float>(v.lens5));
  program->SetUniformf("wfvView.maxAngle", static_cast<float>(v.maxAngle));
  program->SetUniformf("wfvView.bend", static_cast<float>(v.bend));
  const double unit = std::exp2(std::floor(std::log2(v.radii.y)));
  program->SetUniformf("wfvUnit", static_cast<float>(unit));
  const double depth = v.radii.y - v.radii.x;
  set2("wfvUnitDepth", wfv::vec2(unit / depth, -v.radii.x / depth));
  if (v.map)
  {
    const float tables[3] = { static_cast<float>(v.tables.x), static_cast<float>(v.tables.y),
      static_cast<float>(v.tables.z) };
    program->SetUniform3f("wfvView.tables", tables);
  }
}
}

//------------------------------------------------------------------------------
void vtkWideFoVStage::SetView(vtkRenderer* renderer, vtkWideFoVCamera* camera, double tolerance)
{
  const wfv::View& view = camera->GetView(wfv::PictureAspect(renderer));
  const bool tilts = !this->Tilted && view.GetParameters().tilt != wfv::vec2(1, 0);
  const wfv::StereoModel* const stereo = view.GetStereoModel();
  const bool fades = !this->Fades && stereo && stereo->Fades(view.GetParameters());
  if (&view.GetProjection() != this->Projection || tilts || fades || stereo != this->Stereo ||
    view.GetParameters().depthMapping != this->View.depthMapping)
  {
    this->Projection = &view.GetProjection();
    this->Stereo = stereo;
    this->Tilted = this->Tilted || tilts;
    this->Fades = this->Fades || fades;
    this->SourceTime.Modified();
  }
  if (this->Multisample && !this->SawSamples)
  {
    this->Multisample = false;
    this->SourceTime.Modified();
  }
  this->SawSamples = false;
  this->Renderer = renderer;
  this->View = view.GetParameters();
  this->Tolerance = static_cast<float>(tolerance);

  this->Pixels = wfv::PixelsOfTile(renderer);
  for (int i = 0; i < 2; i++)
  {
    const double whole = this->Pixels.Whole[i];
    const double size = this->Pixels.Size[i];
    this->Tile[i] = static_cast<float>(whole / size);
    this->Tile[i + 2] = static_cast<float>((whole - 2 * this->Pixels.Start[i] - size) / size);
  }

  this->Headlights = wfv::FindHeadlights(renderer);
}

void vtkWideFoVStage::NoteSamples()
{
  const bool several = CountSamples() > 1;
  this->SawSamples = this->SawSamples || several;
  if (several && !this->Multisample)
  {
    this->Multisample = true;
    this->SourceTime.Modified();
  }
}

vtkMTimeType vtkWideFoVStage::GetShaderStageMTime()
{
  this->NoteSamples();
  return this->SourceTime.GetMTime();
}

namespace
{
bool WarnOfBodies()
{
  vtkGenericWarningMacro(<< "balls, sticks, tubes and splats are drawn without parallax by the "
                            "stereo model warped; draw them as surfaces");
  return true;
}
}

void vtkWideFoVStage::FinishTriangles(vtkWideFoVShaderBuilder::Request& request) const
{
  request.Stereo = this->Stereo;
  request.Fades = this->Fades;
  const bool straight = !this->Stereo || this->Stereo->Straight;
  if (request.Kind == vtkWideFoVShaderBuilder::Primitive::Lines && !straight &&
    request.Stage == vtkWideFoVShaderBuilder::Variant::Exact)
  {
    request.Stage = vtkWideFoVShaderBuilder::Variant::PreClip; // strips know one depth alone
  }
  if (!straight && wfv::quadric::Draws(request.Kind))
  {
    static const bool said = WarnOfBodies();
    (void)said;
  }
  if (request.Kind != vtkWideFoVShaderBuilder::Primitive::Triangles)
  {
    return;
  }
  request.ByRays = this->ByRays || this->Calm;
  request.Calm = this->Calm;
  if ((!straight || (this->Stereo && this->Stereo->OwnRays)) &&
    request.Stage != vtkWideFoVShaderBuilder::Variant::Plain)
  {
    // their edges are no great circles, which is what chords are chosen by
    request.Stage = vtkWideFoVShaderBuilder::Variant::Exact;
  }
}

vtkWideFoVShaderBuilder::Request vtkWideFoVStage::MakeRequest(
  vtkAbstractMapper* mapper, vtkProp* prop) const
{
  using Variant = vtkWideFoVShaderBuilder::Variant;
  vtkWideFoVShaderBuilder::Request request;
  request.Projection = this->Projection;
  request.Stage = this->Variant;
  request.DebugView = this->DebugView;
  request.DepthMapping = this->View.depthMapping;
  request.Multisample = this->Multisample;
  request.Tilted = this->Tilted;
  request.SurfaceDepth = this->SurfaceDepth;
  auto* polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (auto* actor = vtkActor::SafeDownCast(prop); polydata && actor && this->Renderer)
  {
    MapperAccess::Describe(polydata, this->Renderer, actor, request);
  }
  // stock VTK draws these with a geometry stage of its own, straight in the picture
  if ((request.Edges || request.WideLines) && request.Stage == Variant::Plain && !this->Clipless)
  {
    request.Stage = Variant::PreClip;
  }
  this->FinishTriangles(request);
  const bool lines = request.Kind == vtkWideFoVShaderBuilder::Primitive::Lines;
  if (lines && polydata && this->ExactLines)
  {
    // few are exact, many are not, whatever the triangles of the prop are
    const Variant chords = request.Stage == Variant::Exact ? Variant::PreClip : request.Stage;
    request.Stage = wfv::HasFewLines(polydata) ? Variant::Exact : chords;
  }
  // only our own mapper draws patches; the pieces' edges must not show as the cell's
  const bool patches = vtkWideFoVPolyDataMapper::SafeDownCast(mapper) &&
    request.Kind == vtkWideFoVShaderBuilder::Primitive::Triangles && !request.Edges;
  if (request.Stage == Variant::Tessellate && !patches)
  {
    request.Stage = Variant::PreClip;
  }
  return request;
}

bool vtkWideFoVStage::PreReplaceShaderValues(std::string&, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  this->NoteSamples(); // a mapper with passes that are new to it does not ask for the time
  vtkWideFoVShaderBuilder::Prepare(this->MakeRequest(mapper, prop), geometryShader, fragmentShader);
  return true;
}

bool vtkWideFoVStage::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  const vtkWideFoVShaderBuilder::Request request = this->MakeRequest(mapper, prop);
  const bool triangles = request.Kind == vtkWideFoVShaderBuilder::Primitive::Triangles;
  if (triangles && vtkWideFoVPolyDataMapper::SafeDownCast(mapper))
  {
    wfv::TakeSortedNumbers(fragmentShader);
  }
  vtkWideFoVShaderBuilder::Finish(request, vertexShader, geometryShader, fragmentShader);
  return true;
}

bool vtkWideFoVStage::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  SetViewParameters(program, this->View);
  program->SetUniformf("wfvTolerance", this->Tolerance);
  program->SetUniformi("wfvHeadlights", this->Headlights);
  if (program->IsUniformUsed("wfvStretch"))
  {
    program->SetUniformf(
      "wfvStretch", static_cast<float>(wfv::Stretch(*this->Projection, this->View)));
  }

  int viewport[4] = { 0, 0, 1, 1 };
  if (auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer))
  {
    renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  }
  if (this->View.map && this->Textures)
  {
    this->Textures->Bind(program);
  }
  this->SetSampleParameters(program);
  this->SetPropParameters(program, mapper, prop);
  wfv::SetTileUniforms(program, this->Pixels, this->Tile, viewport, this->View.scale);
  this->NumberOfDraws++;
  const bool tessellates = this->Variant == vtkWideFoVShaderBuilder::Variant::Tessellate;
  this->NumberOfTessellateDraws += tessellates && vtkWideFoVTessellation::IsIn(program);
  return true;
}

void vtkWideFoVStage::SetPropParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  using Primitive = vtkWideFoVShaderBuilder::Primitive;
  auto* polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (polydata && actor && this->Renderer)
  {
    wfv::SetEye(program, polydata, actor, this->Renderer->GetActiveCamera());
  }
  if (polydata && actor && program->IsUniformUsed("wfvLineWidth"))
  {
    program->SetUniformf("wfvLineWidth", wfv::LineWidth(polydata, actor));
  }
  if (actor && program->IsUniformUsed("wfvFrontCulled"))
  {
    vtkProperty* property = actor->GetProperty();
    const bool front = property->GetFrontfaceCulling() && !property->GetBackfaceCulling();
    program->SetUniformi("wfvFrontCulled", front);
  }
  if (polydata && actor && program->IsUniformUsed("wfvPointSize"))
  {
    program->SetUniformf("wfvPointSize", wfv::PointSize(polydata, actor));
  }
  if (actor && program->IsUniformUsed("wfvPixels"))
  {
    const bool tubes = this->MakeRequest(mapper, prop).Kind == Primitive::Tubes;
    vtkProperty* property = actor->GetProperty();
    program->SetUniformf("wfvPixels", tubes ? property->GetLineWidth() : property->GetPointSize());
  }
}

void vtkWideFoVStage::SetSampleParameters(vtkShaderProgram* program)
{
  // uniforms are found by name, so programs without a pre-clip cost one look-up here
  if (!program->IsUniformUsed("wfvSamples"))
  {
    return;
  }
  const int samples = CountSamples();
  float offsets[MaxSamples][2];
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
