// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkWideFoVStage.h"

#include "Camera/Tile.h"
#include "Compat/Gl.h"
#include "Compat/StockText.h"
#include "Drawables/Discontinuity.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/LineMapper.h"
#include "Drawables/PropTraits.h"
#include "Drawables/QuadricKind.h"
#include "Drawables/StockTraits.h"
#include "Frame/RefinedDraw.h"
#include "Frame/DirectionTextures.h"
#include "Frame/Eye.h"
#include "Frame/Headlights.h"
#include "Frame/RefusedShaders.h"
#include "Frame/Stages.h"
#include "Projections/Bounds/Curvature.h"
#include "Shaders/quadrics/QuadricShaders.h"
#include "vtkWideFoVCamera.h"

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
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkWideFoVStage);

namespace
{
// What a pass may know of a mapper only from inside.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  static void Describe(vtkOpenGLPolyDataMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
    wfv::ShaderBuilder::Request& request)
  {
    using Primitive = wfv::ShaderBuilder::Primitive;
    const vtkOpenGLHelper* buffer = mapper->*(&MapperAccess::LastBoundBO);
    const int type = buffer ? buffer->PrimitiveType : static_cast<int>(PrimitiveTris);
    const int representation = actor->GetProperty()->GetRepresentation();
    const bool picking = mapper->*(&MapperAccess::PointPicking);
    const bool points = representation == VTK_POINTS || type == PrimitivePoints ||
      type == PrimitiveVertices || picking;
    const bool lines = representation == VTK_WIREFRAME || type == PrimitiveLines;
    request.Kind = points ? Primitive::Points : lines ? Primitive::Lines : Primitive::Triangles;
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    request.Points.Wide = request.Kind == Primitive::Points && wfv::PointSize(mapper, actor) > 1.0f;
    request.Lines.Wide = request.Kind == Primitive::Lines && window &&
      actor->GetProperty()->GetLineWidth() > window->GetMaximumHardwareLineWidth();
    request.Triangles.Edges = request.Kind == Primitive::Triangles &&
      actor->GetProperty()->GetEdgeVisibility() && !renderer->GetSelector();
    request.Triangles.EdgeFlags = request.Triangles.Edges && type == PrimitiveTris &&
      !(mapper->*(&MapperAccess::EdgeValues)).empty();
    request.Kind = wfv::quadric::KindOf(mapper, actor, request.Kind);
    request.Surface = DescribeMaterial(mapper, renderer, actor, buffer);
    request.Stock = wfv::stock::Describe(mapper, actor);
  }

private:
  // Of the mappers that take the property as it is; of composite ones each block may have colours
  // and an opacity of its own. What is selected has a colour of its own everywhere.
  static wfv::ShaderBuilder::Material DescribeMaterial(vtkOpenGLPolyDataMapper* mapper,
    vtkRenderer* renderer, vtkActor* actor, const vtkOpenGLHelper* buffer)
  {
    const bool simple = wfv::HasTrait(mapper, wfv::OneMaterial);
    const bool known = simple || wfv::HasTrait(mapper, wfv::DrawsBlocks);
    const bool surface = buffer && !(mapper->*(&MapperAccess::DrawingSelection)) &&
      (buffer->PrimitiveType == PrimitiveTris || buffer->PrimitiveType == PrimitiveTriStrips);
    wfv::ShaderBuilder::Material material;
    if (surface && !renderer->GetSelector() && known)
    {
      vtkProperty* property = actor->GetProperty();
      material.NoAmbient = property->GetAmbient() == 0;
      material.NoDiffuse = property->GetDiffuse() == 0;
      material.FullDiffuse = property->GetDiffuse() == 1;
      material.NoSpecular = property->GetSpecular() == 0;
      material.Opaque = property->GetOpacity() == 1 && simple;
    }
    return material;
  }
};

}

namespace
{
// True where the picture shows the end of a map whose seam is curved: a corner lies outside of it.
bool ShowsCurvedSeam(const wfv::View& view)
{
  const wfv::Projection& map = view.GetProjection();
  return map.Axis == wfv::Family::Meridian && !map.StraightSeam &&
    !map.Unproject(wfv::vec2(1, 1), view.GetParameters()).inside;
}
}

//------------------------------------------------------------------------------
// Notes the parts of a view that are text of the shaders.
void vtkWideFoVStage::NoteView(const wfv::View& view)
{
  const bool tilts = !this->Seen.Tilted && view.GetParameters().tilt != wfv::vec2(1, 0);
  const bool bends = !this->Seen.Lensed && view.GetParameters().lens.x != 0;
  const wfv::StereoModel* const stereo = view.GetStereoModel();
  const bool fades = !this->Seen.Fades && stereo && stereo->Fades(view.GetParameters());
  const bool another = &view.GetProjection() != this->Seen.Projection;
  const bool ends = (another || !this->Seen.Seam) && ShowsCurvedSeam(view);
  if (another || tilts || bends || fades || ends || stereo != this->Seen.Stereo ||
    view.GetParameters().depthMapping != this->Seen.DepthMapping)
  {
    this->Seen.Projection = &view.GetProjection();
    this->Seen.Stereo = stereo;
    this->Seen.DepthMapping = view.GetParameters().depthMapping;
    this->Seen.Tilted = this->Seen.Tilted || tilts;
    this->Seen.Lensed = this->Seen.Lensed || bends;
    this->Seen.Fades = this->Seen.Fades || fades;
    this->Seen.Seam = ends || (this->Seen.Seam && !another);
    this->SourceTime.Modified();
  }
}

void vtkWideFoVStage::SetView(
  vtkRenderer* renderer, vtkWideFoVCamera* camera, double tolerance, int border)
{
  const wfv::View& view = camera->GetView(wfv::PictureAspect(renderer));
  this->NoteView(view);
  this->TakeSamples();
  this->Renderer = renderer;
  this->Camera = camera;
  this->View = view.GetParameters();
  this->Tolerance = static_cast<float>(tolerance);

  this->Pixels = wfv::PixelsOfTile(renderer);
  this->Pixels.Size += wfv::vec2(2.0 * border);
  this->Pixels.Start -= wfv::vec2(border);
  for (int i = 0; i < 2; i++)
  {
    const double whole = this->Pixels.Full[i];
    const double size = this->Pixels.Size[i];
    this->Tile[i] = static_cast<float>(whole / size);
    this->Tile[i + 2] = static_cast<float>((whole - 2 * this->Pixels.Start[i] - size) / size);
  }

  const int headlights = wfv::FindHeadlights(renderer);
  const bool changed = this->Lights.Look(renderer);
  if (changed || headlights != this->Headlights)
  {
    this->Headlights = headlights; // constants of the shaders, both
    this->SourceTime.Modified();
  }
}

void vtkWideFoVStage::Announce() const
{
  if (this->Camera)
  {
    this->Camera->ExpectStage();
  }
}

vtkMTimeType vtkWideFoVStage::GetShaderStageMTime()
{
  this->Announce();
  this->NoteSamples();
  return this->SourceTime.GetMTime();
}

namespace
{
bool WarnOfImpostors(const std::string& model)
{
  vtkGenericWarningMacro(
    << "spheres, cylinders, tubes and splats are drawn without parallax by the "
       "stereo model "
    << model << "; draw them as surfaces");
  return true;
}
}

void vtkWideFoVStage::FinishTriangles(wfv::ShaderBuilder::Request& request) const
{
  request.Lights.Headlights = this->Headlights;
  request.Lights.Constants = &this->Lights.GetConstants();
  const bool straight = !this->Seen.Stereo || this->Seen.Stereo->Traits.StraightRays;
  if (request.Kind == wfv::ShaderBuilder::Primitive::Lines && !straight &&
    request.Stage == wfv::ShaderBuilder::Variant::Exact)
  {
    request.Stage = wfv::ShaderBuilder::Variant::PreClip; // strips know one depth alone
  }
  if (!straight && wfv::quadric::Draws(request.Kind))
  {
    static const bool said = WarnOfImpostors(this->Seen.Stereo->Name);
    (void)said;
  }
  if (request.Kind != wfv::ShaderBuilder::Primitive::Triangles)
  {
    return;
  }
  request.Triangles.ByRays = this->ByRays;
  const bool upright =
    this->Seen.Projection->Axis == wfv::Family::Meridian && this->Seen.Projection->StraightSeam;
  request.Runs = upright ? this->Runs : 1;
  // how far edges are is asked of float32 alone
  request.Triangles.Fp64 = this->IsFp64() && !request.Triangles.Edges && !this->DebugView;
  if ((!straight || (this->Seen.Stereo && !this->Seen.Stereo->Traits.OneCenter)) &&
    request.Stage != wfv::ShaderBuilder::Variant::Projected)
  {
    // their edges are no great circles, which is what chords are chosen by
    request.Stage = wfv::ShaderBuilder::Variant::Exact;
  }
}

bool vtkWideFoVStage::HasFp64Rays() const
{
  const bool exact = this->Variant == wfv::ShaderBuilder::Variant::Exact;
  const bool moved = this->Seen.Stereo &&
    (!this->Seen.Stereo->Traits.OneCenter || !this->Seen.Stereo->Traits.StraightRays);
  return exact && !moved && !this->Seen.Multisample &&
    this->Seen.Projection->Axis != wfv::Family::Planar;
}

namespace
{
// True if a mapper draws the pieces of its triangles. A user's own shaders may move them anywhere.
bool Refines(vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  const bool copies = actor && wfv::HasTrait(mapper, wfv::Glyphs) &&
    wfv::HasTrait(actor->GetMapper(), wfv::CopiesAtPoints);
  return actor && !wfv::HasOwnShaders(actor) &&
    (copies || wfv::HasTrait(mapper, wfv::OwnMesh) || wfv::HasTrait(mapper, wfv::ClassifiesBlocks));
}
}

namespace
{
// True if the mapper draws these primitives refined. Copies of glyphs have refined triangles only.
bool IsRefined(const wfv::ShaderBuilder::Request& request, vtkAbstractMapper* mapper, vtkProp* prop)
{
  using Primitive = wfv::ShaderBuilder::Primitive;
  const bool triangles = request.Kind == Primitive::Triangles && !request.Triangles.Edges;
  const bool lines = request.Kind == Primitive::Lines && !wfv::HasTrait(mapper, wfv::Glyphs);
  auto* const polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  return (triangles || lines) && Refines(mapper, prop) && !wfv::DrawsSelection(polydata);
}
}

// Parts that each of few lines is drawn in: the pieces of one that runs round the eye or past a
// pole are more than the geometry stage may write at once.
constexpr int RunsOfFewLines = 4;

wfv::ShaderBuilder::Request vtkWideFoVStage::MakeRequest(
  vtkAbstractMapper* mapper, vtkProp* prop) const
{
  using Variant = wfv::ShaderBuilder::Variant;
  wfv::ShaderBuilder::Request request;
  request.View = this->Seen;
  request.Stage = this->Variant;
  request.DebugView = this->DebugView;
  auto* polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (auto* actor = vtkActor::SafeDownCast(prop); polydata && actor && this->Renderer)
  {
    MapperAccess::Describe(polydata, this->Renderer, actor, request);
  }
  if (request.Stage == Variant::Projected && !this->Clipless && !IsRefined(request, mapper, prop))
  {
    request.Stage = this->Unrefined;
  }
  // stock VTK draws these with a geometry stage of its own, straight in the picture
  const bool refined = this->Unrefined != Variant::Projected && IsRefined(request, mapper, prop);
  if ((request.Triangles.Edges || request.Lines.Wide) && request.Stage == Variant::Projected &&
    !this->Clipless && !refined)
  {
    request.Stage = Variant::PreClip;
  }
  this->FinishTriangles(request);
  const bool lines = request.Kind == wfv::ShaderBuilder::Primitive::Lines && polydata;
  request.Runs = lines && wfv::HasFewLines(polydata) ? RunsOfFewLines : request.Runs;
  if (lines && this->ChordLines && !refined && request.Stage == Variant::Exact)
  {
    request.Stage = Variant::PreClip;
  }
  return request;
}

bool vtkWideFoVStage::PreReplaceShaderValues(std::string&, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  this->NoteSamples(); // a mapper with passes that are new to it does not ask for the time
  this->Announce();
  if (this->Stages)
  {
    this->Stages->Shaders.Begin();
  }
  if (vtkVolume::SafeDownCast(prop) || this->Variant == wfv::ShaderBuilder::Variant::Sky)
  {
    return true;
  }
  wfv::ShaderBuilder::Prepare(this->MakeRequest(mapper, prop), geometryShader, fragmentShader);
  return true;
}

bool vtkWideFoVStage::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  if (wfv::stock::DrawsNothing(fragmentShader) ||
    this->FinishVolume(prop, mapper, vertexShader, geometryShader, fragmentShader) ||
    this->FinishSky(mapper, prop, vertexShader, geometryShader, fragmentShader))
  {
    return true;
  }
  wfv::ShaderBuilder::Request request = this->MakeRequest(mapper, prop);
  const bool classifies = IsRefined(request, mapper, prop);
  const bool others = wfv::IsEditedFurther(this, prop);
  Texts texts{ vertexShader, geometryShader, fragmentShader };
  const Texts* const before =
    this->Stages ? this->Stages->Texts.Find(request, { classifies, others }, texts) : nullptr;
  if (before)
  {
    texts = *before;
  }
  else
  {
    this->FinishTexts(request, classifies, mapper, texts);
    this->Keep(texts);
  }
  // of what others edit nothing is known
  if ((!before || others) && this->LeaveOutRefused(mapper, prop, texts) && !others)
  {
    this->Keep(texts);
  }
  vertexShader = std::move(texts.Vertex);
  geometryShader = std::move(texts.Geometry);
  fragmentShader = std::move(texts.Fragment);
  return true;
}

void vtkWideFoVStage::FinishTexts(const wfv::ShaderBuilder::Request& request, bool classifies,
  vtkAbstractMapper* mapper, Texts& texts)
{
  if (classifies)
  {
    wfv::TakeNumbers(texts.Vertex, texts.Fragment);
  }
  wfv::ShaderBuilder::Finish(request, texts.Vertex, texts.Geometry, texts.Fragment);
  wfv::stock::LeaveOutUnedited(
    this->GetReporter(), mapper, texts.Vertex, texts.Geometry, texts.Fragment);
}

void vtkWideFoVStage::Keep(const Texts& texts)
{
  if (this->Stages)
  {
    this->Stages->Texts.Keep(texts);
  }
}

bool vtkWideFoVStage::LeaveOutRefused(vtkAbstractMapper* mapper, vtkProp* prop, Texts& texts)
{
  vtkRenderWindow* const window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  const bool refused = window && !wfv::stock::DrawsNothing(texts.Fragment) &&
    wfv::IsRefused(this->GetReporter(), window, this, mapper, prop, texts);
  if (refused)
  {
    wfv::stock::LeaveOut(texts.Vertex, texts.Geometry, texts.Fragment);
  }
  return refused;
}

vtkObject* vtkWideFoVStage::GetReporter()
{
  return this->Renderer ? static_cast<vtkObject*>(this->Renderer) : this;
}
