// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/GlyphDraw.h"

#include "Clusters/Affine.h"
#include "Compat/Gl.h"
#include "Frame/Stages.h"
#include "Frame/vtkWideFoVStage.h"

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
#include <cmath>
#include <iterator>

namespace
{
// Triangles of all copies under which a second program costs more than it saves.
constexpr std::size_t FewTriangles = 256;

// Copies that a thread classifies at least.
constexpr vtkIdType Grain = 256;

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
  for (Group& group : this->Groups)
  {
    group.Helper.PrimitiveType = vtkOpenGLPolyDataMapper::PrimitiveTris;
  }
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
}

void GlyphDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Group& group : this->Groups)
  {
    group.Matrices->ReleaseGraphicsResources();
    group.Normals->ReleaseGraphicsResources();
    group.Colors->ReleaseGraphicsResources();
    group.Chords.ReleaseGraphicsResources(window);
    group.Helper.ReleaseGraphicsResources(window);
  }
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

// False where all copies are drawn by the stage.
bool GlyphDraw::Classify()
{
  vtkPolyData* const source = this->Helper->CurrentInput;
  wfv::Stages* const stages = this->Stage->GetStages();
  ClassifierView view;
  if (!source || !stages->GetClassifierView(this->Stage, this->Actor, view))
  {
    return false;
  }
  this->Download();
  double toMap[16];
  stages->GetToMap(this->Actor, toMap);
  const bool still = this->Known && this->Source.GetTime() == source->GetMTime() &&
    this->View == view && std::equal(toMap, toMap + 16, this->ToMap);
  if (!still)
  {
    this->Source.Update(source);
    this->View = view;
    std::copy_n(toMap, 16, this->ToMap);
    const auto triangles = static_cast<std::size_t>(this->Source.GetNumberOfTriangles());
    this->Known = triangles * this->All.Count() >= FewTriangles && this->Source.GetMostChords() > 0;
    this->Found = FrameStatistics();
    if (this->Known)
    {
      this->Gather(source);
      stages->Counts.ClassifiedMeshes++;
    }
  }
  stages->Counts.Add(this->Found);
  return this->Known && this->Groups[0].Arrays.Count() < this->All.Count();
}

void GlyphDraw::ClassifyCopies(vtkPolyData* source)
{
  double b[6];
  source->GetBounds(b);
  const Classifier classifier(this->View);
  this->Classes.resize(this->All.Count());
  const double radius = 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Classes.size()), Grain, [&](vtkIdType from, vtkIdType to) {
      for (vtkIdType i = from; i < to; i++)
      {
        const Affine toMap = OfCopy(this->ToMap, this->All.Matrices.data() + 16 * i);
        Box box;
        for (int k = 0; k < 8; k++)
        {
          box.Add(toMap.Of(b[k & 1], b[2 + ((k >> 1) & 1)], b[4 + ((k >> 2) & 1)]));
        }
        const double scale = toMap.GetScale();
        const int chords = classifier.ChordsOfAll(
          box, scale * radius, scale * this->Source.GetLongestEdge(), this->Source.GetMostChords());
        const auto kind = std::find(std::begin(ChordsOfKinds), std::end(ChordsOfKinds), chords);
        this->Classes[i] = chords == Classifier::Unseen
          ? chords
          : static_cast<int>(kind - std::begin(ChordsOfKinds));
      }
    });
}

void GlyphDraw::Gather(vtkPolyData* source)
{
  this->ClassifyCopies(source);
  for (Group& group : this->Groups)
  {
    group.Arrays.Clear();
  }
  for (std::size_t i = 0; i < this->Classes.size(); i++)
  {
    if (this->Classes[i] != Classifier::Unseen)
    {
      this->Groups[this->Classes[i]].Arrays.Add(this->All, i);
    }
  }
  const vtkIdType triangles = this->Source.GetNumberOfTriangles();
  vtkIdType seen = 0;
  for (Group& group : this->Groups)
  {
    group.Upload();
    seen += static_cast<vtkIdType>(group.Arrays.Count());
  }
  const auto all = static_cast<vtkIdType>(this->All.Count());
  const auto byStage = static_cast<vtkIdType>(this->Groups[0].Arrays.Count());
  this->Found.Triangles = triangles * all;
  this->Found.CulledTriangles = triangles * (all - seen);
  this->Found.ProjectedTriangles = triangles * (seen - byStage);
}

void GlyphDraw::Group::Upload()
{
  if (this->Arrays.Count() > 0)
  {
    this->Matrices->Upload(this->Arrays.Matrices, vtkOpenGLBufferObject::ArrayBuffer);
    this->Colors->Upload(this->Arrays.Colors, vtkOpenGLBufferObject::ArrayBuffer);
  }
  if (!this->Arrays.Normals.empty())
  {
    this->Normals->Upload(this->Arrays.Normals, vtkOpenGLBufferObject::ArrayBuffer);
  }
}

// As vtkOpenGLGlyph3DHelper does it.
void GlyphDraw::Group::AddAttributes()
{
  vtkOpenGLVertexArrayObject* const vao = this->Helper.VAO;
  vtkShaderProgram* const program = this->Helper.Program;
  constexpr int size = sizeof(float);
  vao->Bind();
  vao->AddAttributeMatrixWithDivisor(
    program, this->Matrices, "GCMCMatrix", 0, 16 * size, VTK_FLOAT, 4, false, 1, 4 * size);
  if (!this->Arrays.Normals.empty() && program->IsAttributeUsed("glyphNormalMatrix"))
  {
    vao->AddAttributeMatrixWithDivisor(
      program, this->Normals, "glyphNormalMatrix", 0, 9 * size, VTK_FLOAT, 3, false, 1, 3 * size);
  }
  if (program->IsAttributeUsed("glyphColor"))
  {
    vao->AddAttributeArrayWithDivisor(
      program, this->Colors, "glyphColor", 0, 4, VTK_UNSIGNED_CHAR, 4, true, 1, false);
  }
}

vtkWideFoVStage* GlyphDraw::StageOf(int kind) const
{
  wfv::Stages* const stages = this->Stage->GetStages();
  const int chords = ChordsOfKinds[kind];
  return chords == Classifier::None ? this->Stage
    : chords == 1                   ? stages->Projected.Get()
                                    : stages->Cut.Get();
}

void GlyphDraw::ActivateChords(Group& group, int chords)
{
  auto* const window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  if (!group.Chords.IsLoadedFor(window) || group.ChordsTime != this->Source.GetTime())
  {
    group.Chords.Load(window, this->Source.ListChords(chords));
    group.ChordsTime = this->Source.GetTime();
  }
  group.Chords.Activate(group.Helper.Program, "wfvChords");
  group.Helper.Program->SetUniformi("wfvHasChords", 1);
}

void GlyphDraw::DrawGroup(int kind)
{
  Group& group = this->Groups[kind];
  if (group.Arrays.Count() == 0)
  {
    return;
  }
  vtkOpenGLHelper& own = HelperAccess::Triangles(this->Helper);
  group.Helper.IBO->IndexCount = own.IBO->IndexCount; // which has no indices of its own
  vtkWideFoVStage* const stage = this->StageOf(kind);
  Stages::Replace(this->Actor, this->Stage, stage);
  HelperAccess::MakeReady(this->Helper, group.Helper, this->Renderer, this->Actor);
  Stages::Replace(this->Actor, stage, this->Stage);
  if (!group.Helper.Program)
  {
    return;
  }
  if (ChordsOfKinds[kind] > 1)
  {
    this->ActivateChords(group, ChordsOfKinds[kind]);
  }
  group.AddAttributes();
  own.IBO->Bind();
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(own.IBO->IndexCount), GL_UNSIGNED_INT,
    nullptr, static_cast<GLsizei>(group.Arrays.Count()));
  own.IBO->Release();
  group.Chords.Deactivate();
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
  if (this->Classify())
  {
    for (int kind = 0; kind < NumberOfKinds; kind++)
    {
      this->DrawGroup(kind);
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
