// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/GlyphDraw.h"

#include "Compat/Gl.h"
#include "Frame/Stages.h"
#include "Frame/vtkWideFoVStage.h"
#include "Refine/Affine.h"
#include "Refine/EndCache.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

namespace
{
// Copies that a thread takes at least.
constexpr std::size_t LeastCopies = 256;

// What VTK's mapper of copies keeps to itself.
class HelperAccess : public vtkOpenGLGlyph3DHelper
{
public:
  static vtkOpenGLHelper& Triangles(vtkOpenGLGlyph3DHelper* helper)
  {
    return (helper->*(&HelperAccess::Primitives))[PrimitiveTris];
  }

  static bool IsInstanced(vtkOpenGLGlyph3DHelper* helper)
  {
    return helper->*(&HelperAccess::UsingInstancing);
  }

  // Whose program has been made ready last.
  static vtkOpenGLHelper*& Last(vtkOpenGLGlyph3DHelper* helper)
  {
    return helper->*(&HelperAccess::LastBoundBO);
  }

  static void MakeReady(
    vtkOpenGLGlyph3DHelper* helper, vtkOpenGLHelper& drawn, vtkRenderer* renderer, vtkActor* actor)
  {
    (helper->*(&HelperAccess::UpdateShaders))(drawn, renderer, actor);
  }

  static vtkOpenGLVertexBufferObjectGroup* Buffers(vtkOpenGLGlyph3DHelper* helper)
  {
    return helper->*(&HelperAccess::VBOs);
  }

  static vtkMTimeType TimeOfBuffers(vtkOpenGLGlyph3DHelper* helper)
  {
    return (helper->*(&HelperAccess::InstanceBuffersBuildTime)).GetMTime();
  }

  static void Download(vtkOpenGLGlyph3DHelper* helper, wfv::GlyphArrays& arrays)
  {
    Read(helper->*(&HelperAccess::MatrixBuffer), arrays.Matrices);
    Read(helper->*(&HelperAccess::NormalMatrixBuffer), arrays.Normals);
    Read(helper->*(&HelperAccess::ColorBuffer), arrays.Colors);
  }

private:
  template <typename Value>
  static void Read(vtkOpenGLBufferObject* buffer, std::vector<Value>& values)
  {
    values.clear();
    if (buffer->GetHandle() && buffer->Bind())
    {
      GLint bytes = 0;
      glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
      values.resize(static_cast<std::size_t>(bytes) / sizeof(Value));
      glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes, values.data());
      buffer->Release();
    }
  }
};

// The matrix of a copy, for points of its source; OpenGL's are column-major.
wfv::Affine OfCopy(const double toMap[16], const float copy[16])
{
  double product[16] = { 0 };
  for (int row = 0; row < 4; row++)
  {
    for (int column = 0; column < 4; column++)
    {
      for (int k = 0; k < 4; k++)
      {
        product[4 * row + column] += toMap[4 * row + k] * copy[4 * column + k];
      }
    }
  }
  return wfv::Affine(product);
}
}

namespace wfv
{
void GlyphArrays::Clear()
{
  this->Matrices.clear();
  this->Normals.clear();
  this->Colors.clear();
}

void GlyphArrays::Add(const GlyphArrays& from, std::size_t i)
{
  const auto add = [i](auto& to, const auto& values, std::size_t size) {
    if (!values.empty())
    {
      to.insert(to.end(), values.begin() + i * size, values.begin() + (i + 1) * size);
    }
  };
  add(this->Matrices, from.Matrices, 16);
  add(this->Normals, from.Normals, 9);
  add(this->Colors, from.Colors, 4);
}

GlyphDraw::GlyphDraw(vtkOpenGLGlyph3DHelper* helper)
  : Helper(helper)
{
  this->FineHelper.PrimitiveType = vtkOpenGLPolyDataMapper::PrimitiveTris;
}

GlyphDraw::~GlyphDraw()
{
  this->Finish();
  if (this->Mapper)
  {
    this->Mapper->RemoveObserver(this->Done);
  }
}

vtkOpenGLGlyph3DHelper* GlyphDraw::GetHelper() const
{
  return this->Helper;
}

bool GlyphDraw::MayDraw(vtkActor* actor)
{
  // one that another draws with does not say when it is done
  auto* const mapper = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
  vtkProperty* const property = actor->GetProperty();
  if (!mapper || property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    !HelperAccess::IsInstanced(this->Helper) ||
    HelperAccess::Last(this->Helper) != &HelperAccess::Triangles(this->Helper))
  {
    return false;
  }
  if (this->Mapper != mapper)
  {
    if (this->Mapper)
    {
      this->Mapper->RemoveObserver(this->Done);
    }
    this->Mapper = mapper;
    this->Done = mapper->AddObserver(vtkCommand::ProgressEvent, this, &GlyphDraw::Finish);
  }
  return true;
}

// The mapper has drawn: its indices are back.
void GlyphDraw::Finish()
{
  if (this->Indices > 0 && this->Helper)
  {
    HelperAccess::Triangles(this->Helper).IBO->IndexCount = this->Indices;
  }
  this->Indices = 0;
  this->Whole.Finish();
}

void GlyphDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  this->FineBuffers.ReleaseGraphicsResources();
  this->FineHelper.ReleaseGraphicsResources(window);
  this->PieceArrays.ReleaseGraphicsResources();
  this->Buffers.ReleaseGraphicsResources();
  this->Numbers.ReleaseGraphicsResources(window);
  this->Whole.ReleaseGraphicsResources(window);
  this->Known = false;
}

void GlyphDraw::Download()
{
  const vtkMTimeType time = HelperAccess::TimeOfBuffers(this->Helper);
  if (this->Time != time)
  {
    this->Time = time;
    this->Known = false;
    HelperAccess::Download(this->Helper, this->All);
  }
}

bool GlyphDraw::Prepare()
{
  vtkPolyData* const source = this->Helper->CurrentInput;
  wfv::Stages* const stages = this->Stage->GetStages();
  RefineView view;
  if (!source || !stages->GetRefineView(this->Stage, this->Actor, view))
  {
    return false;
  }
  this->Download();
  double toMap[16];
  stages->GetToMap(this->Actor, toMap);
  this->Source.Update(source);
  const bool still = this->Known && this->SourceTime == source->GetMTime() && this->View == view &&
    std::equal(toMap, toMap + 16, this->ToMap);
  if (!still)
  {
    this->Known = true;
    this->SourceTime = source->GetMTime();
    this->View = view;
    std::copy_n(toMap, 16, this->ToMap);
    const auto start = std::chrono::steady_clock::now();
    this->Refine(source);
    stages->AddRefineTime(start);
    stages->Counts.ClassifiedMeshes++;
  }
  stages->Counts.Add(this->Counts);
  return true;
}

// One copy: culled, drawn as it is, or asked triangle by triangle.
void GlyphDraw::RefineCopy(const Refiner& refiner, vtkPolyData* source, std::size_t copy,
  EndCache& cache, Found& found) const
{
  double bounds[6];
  source->GetPoints()->GetBounds(bounds); // computed before
  const Affine toMap = OfCopy(this->ToMap, this->All.Matrices.data() + 16 * copy);
  switch (refiner.OfCluster(toMap, bounds, this->LongestEdge))
  {
    case Refiner::Unseen:
      found.CulledTriangles += this->Source.GetNumberOfTriangles();
      break;
    case Refiner::Nothing:
      found.Fine.push_back(copy);
      break;
    default:
      this->RefineTriangles(refiner, source, toMap, copy, cache, found);
      break;
  }
}

void GlyphDraw::RefineTriangles(const Refiner& refiner, vtkPolyData* source, const Affine& toMap,
  std::size_t copy, EndCache& cache, Found& found) const
{
  const Corners& corners = this->Source.GetCorners();
  const auto place = [&](unsigned int point) {
    double p[3];
    source->GetPoint(point, p);
    return toMap.Of(p[0], p[1], p[2]);
  };
  const std::uint64_t first = static_cast<std::uint64_t>(copy) * source->GetNumberOfPoints();
  const auto triangles = static_cast<unsigned int>(this->Source.GetNumberOfTriangles());
  std::vector<unsigned int> fine;
  for (unsigned int i = 0; i < triangles; i++)
  {
    const unsigned int at = 3 * i;
    const vec3 p[3] = { place(corners[at]), place(corners[at + 1]), place(corners[at + 2]) };
    const std::uint64_t points[3] = { first + corners[at], first + corners[at + 1],
      first + corners[at + 2] };
    if (refiner.Take(p, points, i, cache, found.Refined))
    {
      fine.push_back(i);
    }
  }
  if (fine.size() == triangles)
  {
    found.Fine.push_back(copy);
    return;
  }
  for (const unsigned int i : fine)
  {
    found.Refined.AddWhole(i);
  }
  found.Copies.resize(found.Refined.Vertices.size(), copy);
}

void GlyphDraw::Refine(vtkPolyData* source)
{
  double bounds[6];
  source->GetPoints()->GetBounds(bounds); // so that threads do not compute them
  this->LongestEdge = 0;
  for (int c = 0; c < this->Source.GetNumberOfClusters(); c++)
  {
    this->LongestEdge = std::max(this->LongestEdge, this->Source.GetLongestEdge(c));
  }
  const Refiner refiner(this->View);
  const std::size_t copies = this->All.Count();
  const std::size_t parts = RefinedDraw::CountParts(copies, LeastCopies);
  std::vector<Found> found(parts);
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts), 1, [&](vtkIdType from, vtkIdType to) {
    for (auto part = static_cast<std::size_t>(from); part < static_cast<std::size_t>(to); part++)
    {
      EndCache cache(source->GetNumberOfPoints());
      for (std::size_t i = part * copies / parts; i < (part + 1) * copies / parts; i++)
      {
        this->RefineCopy(refiner, source, i, cache, found[part]);
      }
    }
  });
  this->Gather(found);
}

void GlyphDraw::Gather(const std::vector<Found>& found)
{
  this->Fine.Clear();
  this->Refined.Clear();
  this->Buffers.Forget();
  this->Numbers.Forget();
  this->Counts = FrameStatistics();
  GlyphArrays ofVertices;
  for (const Found& part : found)
  {
    for (const std::size_t copy : part.Fine)
    {
      this->Fine.Add(this->All, copy);
    }
    this->Refined.Append(part.Refined);
    for (const std::size_t copy : part.Copies)
    {
      ofVertices.Add(this->All, copy);
    }
    this->Counts.CulledTriangles += part.CulledTriangles;
  }
  this->FineBuffers.Upload(this->Fine);
  this->PieceArrays.Upload(ofVertices);
  const vtkIdType triangles = this->Source.GetNumberOfTriangles();
  this->Counts.Triangles = triangles * static_cast<vtkIdType>(this->All.Count());
  this->Counts.ProjectedTriangles =
    this->View.Limits ? triangles * static_cast<vtkIdType>(this->Fine.Count()) : 0;
  this->Counts.Pieces = static_cast<vtkIdType>(this->Refined.Numbers.size());
}

void GlyphDraw::ArrayBuffers::Upload(const GlyphArrays& arrays)
{
  this->HasNormals = !arrays.Normals.empty();
  if (arrays.Count() > 0)
  {
    this->Matrices->Upload(arrays.Matrices, vtkOpenGLBufferObject::ArrayBuffer);
    this->Colors->Upload(arrays.Colors, vtkOpenGLBufferObject::ArrayBuffer);
  }
  if (this->HasNormals)
  {
    this->Normals->Upload(arrays.Normals, vtkOpenGLBufferObject::ArrayBuffer);
  }
}

// As vtkOpenGLGlyph3DHelper does it. divisor: 1 for a value a copy, 0 for a value a vertex.
void GlyphDraw::ArrayBuffers::AddAttributes(
  vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program, int divisor) const
{
  constexpr int size = sizeof(float);
  vao->AddAttributeMatrixWithDivisor(
    program, this->Matrices, "GCMCMatrix", 0, 16 * size, VTK_FLOAT, 4, false, divisor, 4 * size);
  if (this->HasNormals && program->IsAttributeUsed("glyphNormalMatrix"))
  {
    vao->AddAttributeMatrixWithDivisor(program, this->Normals, "glyphNormalMatrix", 0, 9 * size,
      VTK_FLOAT, 3, false, divisor, 3 * size);
  }
  if (program->IsAttributeUsed("glyphColor"))
  {
    vao->AddAttributeArrayWithDivisor(
      program, this->Colors, "glyphColor", 0, 4, VTK_UNSIGNED_CHAR, 4, true, divisor, false);
  }
}

void GlyphDraw::ArrayBuffers::ReleaseGraphicsResources()
{
  this->Matrices->ReleaseGraphicsResources();
  this->Normals->ReleaseGraphicsResources();
  this->Colors->ReleaseGraphicsResources();
}

void GlyphDraw::SetOwnNumbers(vtkShaderProgram* program)
{
  this->Whole.SetOwnNumbers(
    program, static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow()));
}

// Sets all uniforms of the program; the mapper, which is about to do that, has set a part of them.
bool GlyphDraw::MakeReady()
{
  vtkOpenGLHelper& own = HelperAccess::Triangles(this->Helper);
  this->FineHelper.IBO->IndexCount = own.IBO->IndexCount; // which has no indices of its own
  HelperAccess::MakeReady(this->Helper, this->FineHelper, this->Renderer, this->Actor);
  return this->FineHelper.Program != nullptr;
}

void GlyphDraw::DrawFine()
{
  vtkOpenGLHelper& own = HelperAccess::Triangles(this->Helper);
  this->SetOwnNumbers(this->FineHelper.Program);
  this->FineHelper.VAO->Bind();
  this->FineBuffers.AddAttributes(this->FineHelper.VAO, this->FineHelper.Program, 1);
  own.IBO->Bind();
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(own.IBO->IndexCount), GL_UNSIGNED_INT,
    nullptr, static_cast<GLsizei>(this->Fine.Count()));
  own.IBO->Release();
}

void GlyphDraw::DrawPieces()
{
  vtkShaderProgram* const program = this->FineHelper.Program;
  auto* const window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  if (!this->Buffers.Load(
        this->Refined, this->Source.GetCorners(), HelperAccess::Buffers(this->Helper), 0))
  {
    return;
  }
  this->Numbers.Activate(program, window, [this] { return this->Refined.Numbers; });
  this->Buffers.Draw(
    program, GL_TRIANGLES, [this](vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* drawn) {
      this->PieceArrays.AddAttributes(vao, drawn, 0);
    });
  this->Numbers.Deactivate();
}

void GlyphDraw::Draw(vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage)
{
  if (this->Stage || !this->MayDraw(actor))
  {
    return; // while it draws its own programs are made ready, too
  }
  this->Stage = stage;
  this->Renderer = renderer;
  this->Actor = actor;
  vtkOpenGLHelper& own = HelperAccess::Triangles(this->Helper);
  this->SetOwnNumbers(own.Program);
  if (this->Prepare())
  {
    const bool ready = this->MakeReady();
    if (ready && this->Fine.Count() > 0)
    {
      this->DrawFine();
    }
    if (ready && !this->Refined.Numbers.empty())
    {
      this->DrawPieces();
    }
    auto* const window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    window->GetShaderCache()->ReadyShaderProgram(own.Program);
    own.VAO->Bind();
    HelperAccess::Last(this->Helper) = &own;
    this->Indices = own.IBO->IndexCount;
    own.IBO->IndexCount = 0;
  }
  this->Stage = nullptr;
}

void GlyphDraws::Draw(
  vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkProp* prop, vtkWideFoVStage* stage)
{
  auto* const helper = dynamic_cast<vtkOpenGLGlyph3DHelper*>(mapper);
  auto* const actor = helper ? vtkActor::SafeDownCast(prop) : nullptr;
  if (actor)
  {
    std::unique_ptr<GlyphDraw>& draw = this->Draws[helper];
    if (!draw || draw->GetHelper() != helper)
    {
      draw = std::make_unique<GlyphDraw>(helper);
    }
    draw->Draw(renderer, actor, stage);
  }
}

void GlyphDraws::Finish()
{
  for (auto it = this->Draws.begin(); it != this->Draws.end();)
  {
    it->second->Finish();
    it = it->second->GetHelper() ? std::next(it) : this->Draws.erase(it);
  }
}

void GlyphDraws::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& draw : this->Draws)
  {
    draw.second->ReleaseGraphicsResources(window);
  }
}
}
